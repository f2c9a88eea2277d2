// Reading MSH files.
#include "program/drawing/formats/msh.hpp"

#include "program/drawing/account.hpp"
#include "program/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace drawing {
namespace {

struct Kind { // of elements that are used
  int type, order, corners, nodes;
};
// Lines; triangles and quadrangles with all nodes, and with nodes on their sides only.
constexpr Kind kKinds[] = {{1, 1, 0, 2},   {8, 2, 0, 3}, {26, 3, 0, 4}, {2, 1, 3, 3},  {9, 2, 3, 6},   {20, 3, 3, 9},
                           {21, 3, 3, 10}, {3, 1, 4, 4}, {16, 2, 4, 8}, {10, 2, 4, 9}, {39, 3, 4, 12}, {36, 3, 4, 16}};

constexpr int kPoint = 15; // the type of an element that is one

const Kind* kind_of(int type) {
  for (const Kind& kind : kKinds)
    if (kind.type == type) return &kind;
  return nullptr;
}

class MshReader {
public:
  explicit MshReader(std::string_view text) : lines_(text) {}
  Mesh read();

private:
  using Words = std::vector<std::string_view>;
  struct Origin { // of an entity's elements
    int64_t entity = 0, group = 0;
    bool is_drawn = true; // no: it lies between partitions
  };
  Words row(const char* section, size_t least); // the next line, which may not be the section's end
  int64_t integer(const Words& words, size_t i, const char* what) const {
    return whole_number(words[i], lines_.number(), what);
  }
  int64_t count(const Words& words, size_t i, const char* what) const;
  void format();
  void names();
  void nodes_2();
  void nodes_4();
  void elements_2();
  void elements_4();
  void entities();
  void partitioned_entities();
  void take_entity(const Words& words, int dimension, size_t box, Origin of);
  void add_node(int64_t tag, const Words& words, size_t first);
  void add_element(Element element, const Words& words, size_t first);
  void sort_nodes();
  void check();
  void end(const std::string& section);
  void skip(const std::string& section);
  int number() const { return lines_.number(); }

  Lines lines_;
  Mesh mesh_;
  bool is_4_ = false;
  std::vector<double> height_;                          // z of each node
  std::map<std::pair<int, int64_t>, Origin> origin_of_; // by dimension and tag
  Account account_;
  bool many_ = false; // an entity of several groups
};

MshReader::Words MshReader::row(const char* section, size_t least) {
  std::string_view line;
  do {
    if (!lines_.next(line)) throw Fault{number(), std::string("the file ends within ") + section + ": it is truncated"};
  } while (trimmed(line).empty());
  Words words = words_of(trimmed(line));
  if (words[0][0] == '$') throw Fault{number(), std::string(section) + " has fewer lines than its count"};
  if (words.size() < least)
    throw Fault{number(), std::string(section) + ": " + std::to_string(words.size()) + " numbers in a line, expected " +
                              std::to_string(least) + " or more"};
  return words;
}

int64_t MshReader::count(const Words& words, size_t i, const char* what) const {
  const int64_t n = integer(words, i, what);
  if (n < 0 || n > 100000000)
    throw Fault{number(), std::string(what) + " is " + std::to_string(n) + ", expected 0 to 100000000"};
  return n;
}

void MshReader::format() {
  const Words words = row("$MeshFormat", 3);
  mesh_.format = std::string(words[0]);
  is_4_ = words[0] == "4.1";
  if (!is_4_ && words[0] != "2.2" && words[0] != "2")
    throw Fault{number(), "MSH format " + shown(words[0]) + ", expected 2.2 or 4.1"};
  if (integer(words, 1, "the file type") != 0) throw Fault{number(), "this MSH file is binary, expected an ASCII file"};
}

void MshReader::names() {
  const int64_t n = count(row("$PhysicalNames", 1), 0, "the number of names");
  for (int64_t i = 0; i < n; ++i) {
    const Words words = row("$PhysicalNames", 3);
    const std::string_view first = words[2], last = words.back();
    std::string_view name(first.data(), static_cast<size_t>(last.data() + last.size() - first.data())); // with its blanks
    if (name.size() < 2 || name.front() != '"' || name.back() != '"')
      throw Fault{number(), "the name of a physical group is " + shown(name) + ", expected a name in quotes"};
    mesh_.names.push_back({static_cast<int>(integer(words, 0, "a dimension")), integer(words, 1, "a physical group"),
                           std::string(name.substr(1, name.size() - 2))});
  }
}

void MshReader::add_node(int64_t tag, const Words& words, size_t first) {
  mesh_.tags.push_back(tag);
  mesh_.nodes.push_back({real(words[first], number(), "x of a node"), real(words[first + 1], number(), "y of a node")});
  height_.push_back(real(words[first + 2], number(), "z of a node"));
}

void MshReader::nodes_2() {
  const int64_t n = count(row("$Nodes", 1), 0, "the number of nodes");
  for (int64_t i = 0; i < n; ++i) {
    const Words words = row("$Nodes", 4);
    add_node(integer(words, 0, "a node"), words, 1);
  }
}

void MshReader::nodes_4() {
  const int64_t blocks = count(row("$Nodes", 4), 0, "the number of blocks");
  for (int64_t b = 0; b < blocks; ++b) {
    const int64_t n = count(row("$Nodes", 4), 3, "the number of nodes");
    std::vector<int64_t> tags;
    for (int64_t i = 0; i < n; ++i) tags.push_back(integer(row("$Nodes", 1), 0, "a node"));
    for (int64_t i = 0; i < n; ++i) add_node(tags[static_cast<size_t>(i)], row("$Nodes", 3), 0);
  }
}

void MshReader::entities() {
  const Words counts = row("$Entities", 4);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (int64_t i = count(counts, static_cast<size_t>(dimension), "the number of entities"); i > 0; --i)
      take_entity(row("$Entities", 2), dimension, 1, {});
}

// Parts of entities that a mesh is cut into, and what lies between them: each with the entity that it is a part of.
void MshReader::partitioned_entities() {
  const char* const section = "$PartitionedEntities";
  row(section, 1);
  for (int64_t ghosts = count(row(section, 1), 0, "the number of ghost entities"); ghosts > 0; --ghosts) row(section, 2);
  const Words counts = row(section, 4);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (int64_t i = count(counts, static_cast<size_t>(dimension), "the number of entities"); i > 0; --i) {
      const Words words = row(section, 5);
      const int64_t partitions = count(words, 3, "the number of partitions");
      Origin of{integer(words, 2, "an entity"), 0, integer(words, 1, "a dimension") == dimension};
      take_entity(words, dimension, 4 + static_cast<size_t>(partitions), of);
    }
}

// Its physical groups stand behind the box around it, of points behind their place, which begins at `box`.
void MshReader::take_entity(const Words& words, int dimension, size_t box, Origin of) {
  const size_t at = box + (dimension == 0 ? 3 : 6);
  const char* const few = "too few numbers for an entity";
  if (words.size() <= at) throw Fault{number(), few};
  const int64_t groups = count(words, at, "the number of physical groups"), tag = integer(words, 0, "an entity");
  if (words.size() < at + 1 + static_cast<size_t>(groups)) throw Fault{number(), few};
  if (groups > 0) of.group = std::abs(integer(words, at + 1, "a physical group"));
  if (groups > 1) many_ = true;
  if (of.entity == 0) of.entity = tag;
  origin_of_[{dimension, tag}] = of;
}

// A quadrangle with a side of no length becomes the triangle that it is.
bool has_area(Element& face) {
  std::vector<int64_t>& n = face.nodes;
  n.erase(std::unique(n.begin(), n.end()), n.end());
  while (n.size() > 1 && n.front() == n.back()) n.pop_back();
  constexpr int kTriangle = 2;
  if (n.size() == 3) face.type = kTriangle;
  return n.size() >= 3;
}

void MshReader::add_element(Element element, const Words& words, size_t first) {
  const Kind* kind = kind_of(element.type);
  if (kind == nullptr) {
    if (element.type != kPoint)
      account_.leave_out("element", "of type " + std::to_string(element.type) + ", neither a line nor a face", number());
    return;
  }
  if (words.size() - first != static_cast<size_t>(kind->nodes))
    throw Fault{number(), "an element of type " + std::to_string(element.type) + " has " +
                              std::to_string(words.size() - first) + " nodes, expected " + std::to_string(kind->nodes)};
  element.line = number();
  for (size_t i = first; i < words.size(); ++i) element.nodes.push_back(integer(words, i, "a node"));
  if (kind->corners == 0 && element.nodes[0] == element.nodes[1])
    return account_.leave_out("line element", "both ends are the same node", number());
  if (kind->order == 1 && kind->corners > 0 && !has_area(element))
    return account_.leave_out("face", "it has fewer than three corners", number());
  (kind->corners == 0 ? mesh_.lines : mesh_.faces).push_back(std::move(element));
}

void MshReader::elements_2() {
  const int64_t n = count(row("$Elements", 1), 0, "the number of elements");
  for (int64_t i = 0; i < n; ++i) {
    const Words words = row("$Elements", 3);
    const int64_t tags = count(words, 2, "the number of tags");
    const size_t first = 3 + static_cast<size_t>(tags);
    if (words.size() <= first) throw Fault{number(), "$Elements: a line without nodes"};
    Element element{static_cast<int>(count(words, 1, "the type of an element")), 0, 0, 0, {}};
    if (tags > 0) element.group = std::abs(integer(words, 3, "a physical group"));
    if (tags > 1) element.entity = integer(words, 4, "an elementary entity");
    add_element(std::move(element), words, first);
  }
}

void MshReader::elements_4() {
  const int64_t blocks = count(row("$Elements", 4), 0, "the number of blocks");
  for (int64_t b = 0; b < blocks; ++b) {
    const Words head = row("$Elements", 4);
    const int64_t dimension = count(head, 0, "a dimension"), n = count(head, 3, "the number of elements");
    Element element{static_cast<int>(count(head, 2, "the type of an element")), 0, 0, integer(head, 1, "an entity"), {}};
    const auto origin = origin_of_.find({static_cast<int>(dimension), element.entity});
    const bool is_drawn = origin == origin_of_.end() || origin->second.is_drawn;
    if (origin != origin_of_.end()) element.group = origin->second.group, element.entity = origin->second.entity;
    for (int64_t i = 0; i < n; ++i) {
      const Words words = row("$Elements", 2);
      if (is_drawn || element.type == kPoint)
        add_element(element, words, 1);
      else
        account_.leave_out("line element", "it separates partitions", number());
    }
  }
}

void MshReader::end(const std::string& section) {
  std::string_view line;
  while (lines_.next(line))
    if (!trimmed(line).empty()) {
      if (trimmed(line) == "$End" + section.substr(1)) return;
      throw Fault{number(), shown(trimmed(line)) + ", expected $End" + section.substr(1)};
    }
  throw Fault{number(), "the file ends without $End" + section.substr(1) + ": it is truncated"};
}

void MshReader::skip(const std::string& section) {
  std::string_view line;
  while (lines_.next(line))
    if (trimmed(line) == "$End" + section.substr(1)) return;
  throw Fault{number(), "the file ends without $End" + section.substr(1) + ": it is truncated"};
}

void MshReader::sort_nodes() {
  std::vector<size_t> order(mesh_.tags.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t i, size_t j) { return mesh_.tags[i] < mesh_.tags[j]; });
  Mesh sorted;
  for (const size_t i : order) {
    if (!sorted.tags.empty() && sorted.tags.back() == mesh_.tags[i])
      throw Fault{0, "node " + std::to_string(mesh_.tags[i]) + " is defined twice"};
    sorted.tags.push_back(mesh_.tags[i]);
    sorted.nodes.push_back(mesh_.nodes[i]);
  }
  mesh_.tags.swap(sorted.tags);
  mesh_.nodes.swap(sorted.nodes);
}

// Nodes of elements are there, and lie in a plane.
void MshReader::check() {
  sort_nodes();
  const auto missing = [&](const Element& element) { // the first of its nodes that is not there
    return std::find_if(element.nodes.begin(), element.nodes.end(),
                        [&](int64_t node) { return !std::binary_search(mesh_.tags.begin(), mesh_.tags.end(), node); });
  };
  for (const Element& face : mesh_.faces) // a surface without one would have a hole
    if (const auto node = missing(face); node != face.nodes.end())
      throw Fault{face.line, "an element has node " + std::to_string(*node) + ", which is missing"};
  const auto is_odd = [&](const Element& line) {
    const auto node = missing(line);
    if (node == line.nodes.end()) return false;
    account_.leave_out("line element", "node " + std::to_string(*node) + " is missing", line.line);
    return true;
  };
  mesh_.lines.erase(std::remove_if(mesh_.lines.begin(), mesh_.lines.end(), is_odd), mesh_.lines.end());
  if (height_.empty()) return;
  const auto [low, high] = std::minmax_element(height_.begin(), height_.end());
  double size = 0;
  for (const Point& p : mesh_.nodes) size = std::max(size, sketch::length(p - mesh_.nodes.front()));
  if (*high - *low > kJoin * size)
    throw Fault{0, "the mesh is not plane: z ranges from " + text_of(*low) + " to " + text_of(*high) + ", expected constant z"};
}

Mesh MshReader::read() {
  std::string_view line;
  bool has_nodes = false, has_elements = false;
  while (lines_.next(line)) {
    const std::string section(trimmed(line));
    if (section.empty()) continue;
    if (section[0] != '$') throw Fault{number(), shown(section) + ", expected the start of a section, such as $Nodes"};
    if (mesh_.format.empty() && section != "$MeshFormat")
      throw Fault{number(), shown(section) + ", expected $MeshFormat first"};
    if (section == "$MeshFormat")
      format();
    else if (section == "$PhysicalNames")
      names();
    else if (section == "$Entities" && is_4_)
      entities();
    else if (section == "$PartitionedEntities" && is_4_)
      partitioned_entities();
    else if (section == "$Nodes")
      is_4_ ? nodes_4() : nodes_2(), has_nodes = true;
    else if (section == "$Elements")
      is_4_ ? elements_4() : elements_2(), has_elements = true;
    else {
      skip(section);
      continue;
    }
    end(section);
  }
  if (!has_nodes) throw Fault{0, "no section $Nodes"};
  if (!has_elements) throw Fault{0, "no section $Elements"};
  check();
  if (!mesh_.lines.empty()) account_.read("line element", static_cast<int>(mesh_.lines.size()));
  if (!mesh_.faces.empty()) account_.read("face", static_cast<int>(mesh_.faces.size()));
  mesh_.notes = account_.notes();
  if (many_) mesh_.notes.push_back("some entities are in several physical groups: the first group gives the name");
  return std::move(mesh_);
}

} // namespace

int order_of(int type) {
  const Kind* kind = kind_of(type);
  return kind == nullptr ? 0 : kind->order;
}

int corners_of(int type) {
  const Kind* kind = kind_of(type);
  return kind == nullptr ? 0 : kind->corners;
}

std::string Mesh::name(int dimension, int64_t group) const {
  for (const Name& n : names)
    if (n.dimension == dimension && n.group == group) return n.name;
  return "";
}

Point Mesh::at(int64_t tag) const {
  return nodes[static_cast<size_t>(std::lower_bound(tags.begin(), tags.end(), tag) - tags.begin())];
}

bool is_msh(std::string_view text) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line))
    if (!trimmed(line).empty()) return trimmed(line) == "$MeshFormat" || trimmed(line) == "$NOD";
  return false;
}

Mesh read_mesh(std::string_view text) { return MshReader(text).read(); }

} // namespace drawing
