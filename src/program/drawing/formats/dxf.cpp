#include "program/drawing/formats/dxf.hpp"

#include "program/drawing/formats/dxf_curves.hpp"
#include "program/drawing/formats/dxf_layers.hpp"

#include <algorithm>
#include <map>

namespace drawing {
namespace {

// The unit of $INSUNITS; empty: none, or an unusual one.
std::string unit_of(int64_t code) {
  const std::pair<int, const char*> known[] = {{1, "in"}, {2, "ft"}, {4, "mm"}, {5, "cm"}, {6, "m"}, {9, "mil"}, {13, "um"}};
  for (const auto& [number, name] : known)
    if (code == number) return name;
  return "";
}

// Where entities are drawn: those of the drawing itself, or of a block.
struct Place {
  Motion motion;
  std::string layer = "0"; // of entities on layer 0
  int depth = 0;           // of blocks within each other
};

class DxfReader {
public:
  explicit DxfReader(std::string_view text) : groups_(groups_of(text)) {}
  Drawing read();

private:
  std::vector<Entity> entities(size_t first, size_t last) const;
  void header(size_t first, size_t last);
  void layers(size_t first, size_t last);
  void blocks(size_t first, size_t last);
  void draw(const std::vector<Entity>& all, const Place& place);
  bool hides(const Entity& e, const std::string& layer);
  void curves(const Entity& e, const std::vector<Entity>& corners, const Place& place, const std::string& layer);
  void insert(const Entity& e, const Place& place, const std::string& layer);

  std::vector<Group> groups_;
  Drawing drawing_;
  Layers layers_;
  struct Block {
    Point base;
    std::string fault; // why it cannot be inserted; empty: it can
    std::vector<Entity> entities;
  };
  std::map<std::string, Block> blocks_; // by folded names
  int inserts_ = 0;
  Account account_;
};

std::vector<Entity> DxfReader::entities(size_t first, size_t last) const {
  std::vector<Entity> all;
  for (size_t i = first; i < last; ++i) {
    if (groups_[i].code != 0) continue;
    Entity e;
    e.type = groups_[i].value;
    e.line = groups_[i].line;
    size_t end = i + 1;
    while (end < last && groups_[end].code != 0) ++end;
    e.first = groups_.data() + i + 1, e.last = groups_.data() + end;
    all.push_back(e);
  }
  return all;
}

void DxfReader::header(size_t first, size_t last) {
  for (size_t i = first; i + 1 < last; ++i)
    if (groups_[i].code == 9 && groups_[i].value == "$INSUNITS" && groups_[i + 1].code == 70)
      drawing_.unit = unit_of(whole_number(groups_[i + 1].value, groups_[i + 1].line, "$INSUNITS"));
}

void DxfReader::layers(size_t first, size_t last) {
  for (const Entity& e : entities(first, last)) try {
      if (e.type == "LAYER") layers_.add(e);
    } catch (const Fault& fault) {
      account_.leave_out(e.type, fault.text, fault.line);
    }
}

// BLOCK, its entities and ENDBLK, one block behind the other.
void DxfReader::blocks(size_t first, size_t last) {
  Block* open = nullptr;
  for (const Entity& e : entities(first, last)) {
    if (e.type == "BLOCK") {
      constexpr int64_t kElsewhere = 4;
      open = &blocks_[folded(e.text(2))];
      try {
        open->base = {e.number(10, 0, "its base point"), e.number(20, 0, "its base point")};
        if ((e.flags(70) & kElsewhere) != 0) open->fault = "it is in another file";
      } catch (const Fault& fault) {
        open->fault = fault.text;
      }
    } else if (e.type == "ENDBLK") {
      open = nullptr;
    } else if (open != nullptr) {
      open->entities.push_back(e);
    }
  }
}

// Counts a hidden entity with its reason.
bool DxfReader::hides(const Entity& e, const std::string& layer) {
  std::string why;
  if (e.flags(67) == 1) why = "in paper space";
  if (e.flags(60) == 1) why = "invisible";
  const bool is_insert = e.type == "INSERT"; // entities of a block have layers of their own; one that is frozen hides all
  if (const std::string hidden = layers_.why_hidden(layer); !hidden.empty() && (!is_insert || layers_.is_frozen(layer)))
    why = "layer " + shown(layer) + " " + hidden;
  if (!why.empty()) account_.leave_out(e.type, why, e.line);
  return !why.empty();
}

// An entity with a fault is left out; the others of the drawing are read.
void DxfReader::draw(const std::vector<Entity>& all, const Place& place) {
  for (size_t i = 0; i < all.size(); ++i) {
    const Entity& e = all[i];
    if (e.type == "VERTEX" || e.type == "SEQEND" || e.type == "ATTRIB") continue; // of what was left out
    std::vector<Entity> corners;
    if (e.type == "POLYLINE")
      while (i + 1 < all.size() && all[i + 1].type == "VERTEX") corners.push_back(all[++i]);
    try {
      const std::string layer = e.text(8).empty() || e.text(8) == "0" ? place.layer : layers_.spelled(e.text(8));
      if (hides(e, layer)) continue;
      if (e.type == "INSERT") {
        insert(e, place, layer);
      } else if (!is_curve(e.type)) {
        const bool endless = e.type == "XLINE" || e.type == "RAY";
        account_.leave_out(e.type, endless ? "a construction line" : "not a supported curve", e.line);
      } else {
        if (e.type == "POLYLINE" && (i + 1 == all.size() || all[i + 1].type != "SEQEND"))
          throw Fault{e.line, "no SEQEND after its vertices"};
        curves(e, corners, place, layer);
      }
    } catch (const TooLarge&) {
      throw;
    } catch (const Fault& fault) {
      account_.leave_out(e.type, fault.text, fault.line);
    }
  }
}

void DxfReader::curves(const Entity& e, const std::vector<Entity>& corners, const Place& place, const std::string& layer) {
  for (Curve& curve : curves_of(e, corners, place.motion, account_)) {
    curve.name = layer == "0" ? std::string() : layer;
    curve.line = e.line;
    drawing_.curves.push_back(std::move(curve));
  }
  account_.read(e.type);
}

// A block, perhaps several times in rows and columns.
void DxfReader::insert(const Entity& e, const Place& place, const std::string& layer) {
  constexpr int kDeepest = 16;
  constexpr int64_t kMostCopies = 10000;
  constexpr int kMostInserts = 1000000;
  const double x = e.number(41, 1, "a scale"), y = e.number(42, 1, "a scale");
  if (x == 0 || y == 0) throw Fault{e.line, "its scale is 0"};
  const auto block = blocks_.find(folded(e.text(2)));
  if (block == blocks_.end()) throw Fault{e.line, "block " + shown(e.text(2)) + " is missing"};
  if (!block->second.fault.empty()) throw Fault{e.line, "block " + shown(e.text(2)) + ": " + block->second.fault};
  if (place.depth >= kDeepest)
    throw Fault{e.line, "block " + shown(e.text(2)) + " contains itself, or blocks are nested more than 16 deep"};
  const bool behind = is_seen_from_behind(e);
  const Point at = e.point(10, "the insertion point of a block"),
              step = {e.number(44, 0, "a column spacing"), e.number(45, 0, "a row spacing")};
  int64_t columns = e.has(70) ? e.flags(70) : 1, rows = e.has(71) ? e.flags(71) : 1;
  if (columns < 0 || rows < 0 || columns > kMostCopies || rows > kMostCopies || columns * rows > kMostCopies)
    throw Fault{e.line, "more than 10000 copies of a block"};
  columns = std::max<int64_t>(columns, 1), rows = std::max<int64_t>(rows, 1);
  const double angle = e.number(50, 0, "an angle");
  const Motion array = placing({}, at, 1, 1, angle); // of the copies among each other
  for (int64_t i = 0; i < columns * rows; ++i) {
    if (++inserts_ > kMostInserts) throw TooLarge{e.line, "INSERT: more than 1000000 copies of blocks in total"};
    const Point corner = array({static_cast<double>(i % columns) * step.x, static_cast<double>(i / columns) * step.y});
    Place inside{placing(block->second.base, corner, x, y, angle), layer, place.depth + 1};
    if (behind) inside.motion = after(kFromBehind, inside.motion);
    inside.motion = after(place.motion, inside.motion);
    draw(block->second.entities, inside);
  }
  account_.read(e.type);
}

Drawing DxfReader::read() {
  drawing_.kind = "DXF";
  bool found = false;
  for (size_t i = 0; i + 1 < groups_.size(); ++i) {
    if (groups_[i].code != 0 || groups_[i].value != "SECTION") continue;
    if (groups_[i + 1].code != 2) throw Fault{groups_[i + 1].line, "expected the name of a section, group 2"};
    const std::string_view name = groups_[i + 1].value;
    size_t end = i + 2;
    while (end < groups_.size() && !(groups_[end].code == 0 && groups_[end].value == "ENDSEC")) ++end;
    if (end == groups_.size())
      throw Fault{groups_[i].line, "section " + shown(name) + " without ENDSEC: the file is truncated"};
    if (name == "HEADER") header(i + 2, end);
    if (name == "TABLES") layers(i + 2, end);
    if (name == "BLOCKS") blocks(i + 2, end);
    if (name == "ENTITIES") draw(entities(i + 2, end), {}), found = true;
    i = end;
  }
  if (!found) throw Fault{0, "no section ENTITIES"};
  drawing_.notes = account_.notes();
  return std::move(drawing_);
}

} // namespace

bool is_dxf(std::string_view text) {
  Lines lines(text);
  std::string_view code, value;
  while (lines.next(code) && lines.next(value)) // comments may stand first
    if (trimmed(code) != "999") return trimmed(code) == "0" && trimmed(value) == "SECTION";
  return false;
}

Drawing read_dxf(std::string_view text) { return DxfReader(text).read(); }

} // namespace drawing
