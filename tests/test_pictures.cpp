// Pictures, the report page and the VTK file: well-formed, legible, and in agreement with the CSV.
#include "json.hpp"
#include "report/axes.hpp"
#include "report/contour.hpp"
#include "report/history.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

using namespace test;

namespace {

const std::string kExamples = C2D_TEST_ROOT "/examples/";

std::string quoted(const std::string& path) {
  return "'" + path + "'";
}

// ---------------------------------------------------------------- a small XML reader
struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
};

bool good_entities(const std::string& text) {
  for (size_t i = text.find('&'); i != std::string::npos; i = text.find('&', i + 1)) {
    const size_t end = text.find(';', i);
    if (end == std::string::npos) return false;
    const std::string name = text.substr(i + 1, end - i - 1);
    const bool number =
        name.size() > 1 && name[0] == '#' && name.find_first_not_of("0123456789", 1) == std::string::npos;
    if (!number && name != "amp" && name != "lt" && name != "gt" && name != "quot") return false;
  }
  return text.find('<') == std::string::npos;
}

// All elements in order; why it is not well-formed, empty if it is.
std::string read_xml(const std::string& xml, std::vector<Element>& out) {
  std::vector<size_t> open;
  size_t at = 0;
  while (at < xml.size()) {
    const size_t tag = xml.find('<', at);
    const std::string text = xml.substr(at, tag == std::string::npos ? std::string::npos : tag - at);
    if (!good_entities(text)) return "bad text: " + text;
    if (!open.empty()) out[open.back()].text += text;
    if (open.empty() && text.find_first_not_of(" \n") != std::string::npos) return "text outside: " + text;
    if (tag == std::string::npos) break;
    const size_t end = xml.find('>', tag);
    if (end == std::string::npos) return "tag without end";
    std::string inside = xml.substr(tag + 1, end - tag - 1);
    at = end + 1;
    if (!inside.empty() && inside[0] == '/') {
      if (open.empty() || out[open.back()].name != inside.substr(1)) return "unexpected end " + inside;
      open.pop_back();
      continue;
    }
    const bool empty = !inside.empty() && inside.back() == '/';
    if (empty) inside.pop_back();
    Element e;
    size_t i = inside.find(' ');
    e.name = inside.substr(0, i);
    while (i != std::string::npos && (i = inside.find_first_not_of(' ', i)) != std::string::npos) {
      const size_t equals = inside.find("=\"", i);
      const size_t close = equals == std::string::npos ? equals : inside.find('"', equals + 2);
      if (close == std::string::npos) return "bad attribute in " + inside;
      const std::string name = inside.substr(i, equals - i),
                        value = inside.substr(equals + 2, close - equals - 2);
      if (!e.attributes.emplace(name, value).second) return "attribute twice: " + name;
      if (!good_entities(value)) return "bad value: " + value;
      i = close + 1;
    }
    if (open.empty() && !out.empty()) return "a second root";
    out.push_back(e);
    if (!empty) open.push_back(out.size() - 1);
  }
  return open.empty() ? "" : "not closed: " + out[open.back()].name;
}

double number_of(const Element& e, const char* name) {
  const auto found = e.attributes.find(name);
  return found == e.attributes.end() ? 0.0 : std::atof(found->second.c_str());
}

// The box that a text is sure to stay within: 0.6 em a character is more than a common sans-serif needs.
app::Box box_of(const Element& e) {
  size_t characters = 0;
  for (size_t i = 0; i < e.text.size(); ++i, ++characters)
    if (e.text[i] == '&') i = e.text.find(';', i);
  const double size = number_of(e, "font-size"), x = number_of(e, "x"), y = number_of(e, "y");
  const double wide = 0.6 * size * static_cast<double>(characters);
  const auto found = e.attributes.find("text-anchor");
  const double part = found == e.attributes.end() ? 0.0 : found->second == "middle" ? 0.5 : 1.0;
  if (e.attributes.count("transform"))
    return {x - 0.75 * size, y - (1.0 - part) * wide, x + 0.2 * size, y + part * wide};
  return {x - part * wide, y - 0.75 * size, x + (1.0 - part) * wide, y + 0.2 * size};
}

void check_picture(const std::string& name, const std::string& svg) {
  std::vector<Element> elements;
  const std::string fault = read_xml(svg, elements);
  CHECK_MESSAGE(fault.empty(), name << ": " << fault);
  if (!fault.empty()) return;
  REQUIRE(elements[0].name == "svg");
  const double width = number_of(elements[0], "width"), height = number_of(elements[0], "height");
  std::vector<std::pair<std::string, app::Box>> texts;
  for (const Element& e : elements) {
    for (const auto& attribute : e.attributes) {
      CHECK_MESSAGE(!contains(attribute.second, "nan"), name << ": " << attribute.second);
      CHECK_MESSAGE(!contains(attribute.second, "inf"), name << ": " << attribute.second);
    }
    if (e.name != "text") continue;
    CHECK_MESSAGE(number_of(e, "font-size") >= 11.0, name << ": " << e.text);
    const app::Box box = box_of(e);
    CHECK_MESSAGE(box.left >= 0.0, name << ": " << e.text);
    CHECK_MESSAGE(box.right <= width, name << ": " << e.text);
    CHECK_MESSAGE(box.top >= 0.0, name << ": " << e.text);
    CHECK_MESSAGE(box.bottom <= height, name << ": " << e.text);
    for (const auto& other : texts) {
      const bool apart = box.right <= other.second.left || other.second.right <= box.left ||
                         box.bottom <= other.second.top || other.second.bottom <= box.top;
      CHECK_MESSAGE(apart, name << ": '" << e.text << "' over '" << other.first << "'");
    }
    texts.emplace_back(e.text, box);
  }
}

// ---------------------------------------------------------------- a run with all pictures
struct Shown {
  Folder folder;
  Result result;
  std::string page, vtk;
  std::map<std::string, std::string> figures; // by name without .svg
};

void show(Shown& out, const std::string& deck, const std::string& options = "") {
  out.result =
      run_shell("'" C2D_TEST_PROGRAM "' run " + quoted(deck) + " --listing /dev/null --csv " +
                quoted(out.folder / "c.csv") + " --report " + quoted(out.folder / "r.html") + " --figures " +
                quoted(out.folder / "figures") + " --vtk " + quoted(out.folder / "b.vtk") + " --boundary " +
                quoted(out.folder / "b.csv") + " " + options);
  out.page = read_file(out.folder / "r.html");
  out.vtk = read_file(out.folder / "b.vtk");
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(out.folder / "figures", none))
    out.figures[entry.path().stem().string()] = read_file(entry.path().string());
}

std::set<std::string> names_of(const Shown& shown) {
  std::set<std::string> out;
  for (const auto& figure : shown.figures) out.insert(figure.first);
  return out;
}

void check_page(const Shown& shown) {
  const std::string& page = shown.page;
  CHECK(page.compare(0, 15, "<!DOCTYPE html>") == 0);
  CHECK(contains(page, "</html>"));
  CHECK(contains(page, "@media print"));
  for (const char* never : {"<script", "src=", "href=", "@import"})
    CHECK_MESSAGE(!contains(page, never), never);
  size_t inline_pictures = 0;
  for (size_t at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1))
    ++inline_pictures;
  CHECK(inline_pictures == shown.figures.size());
  for (const auto& figure : shown.figures) {
    CHECK_MESSAGE(contains(page, figure.second), figure.first);
    check_picture(figure.first, figure.second);
  }
  std::set<std::string> ids;
  for (size_t at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1)) {
    const std::string id = page.substr(at + 5, page.find('"', at + 5) - at - 5);
    CHECK_MESSAGE(ids.insert(id).second, id);
  }
}

std::string caption_of(const Shown& shown, const std::string& name) {
  const size_t section = shown.page.find("<section id=\"" + name + "\">");
  REQUIRE(section != std::string::npos);
  const size_t start = shown.page.find("<figcaption>", section) + 12;
  return shown.page.substr(start, shown.page.find("</figcaption>", start) - start);
}

struct PairRow {
  double mu, load, x, y, tn;
  int step, pair;
  std::string status;
};
// Rows of the last recorded step of one coefficient.
std::vector<PairRow> last_rows(const std::string& csv, double mu) {
  std::vector<PairRow> out;
  for (const std::string& line : lines_of(csv)) {
    std::istringstream in(line);
    std::vector<std::string> f;
    for (std::string field; std::getline(in, field, ',');) f.push_back(field);
    if (f.size() != 15 || f[0] == "mu" || std::stod(f[0]) != mu) continue;
    const PairRow row{std::stod(f[0]), std::stod(f[2]), std::stod(f[4]), std::stod(f[5]),
                      std::stod(f[7]), std::stoi(f[1]), std::stoi(f[3]), f[6]};
    if (!out.empty() && out.back().step != row.step) out.clear();
    out.push_back(row);
  }
  return out;
}

std::string six(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

} // namespace

TEST_CASE("pictures: contact with two coefficients of friction") {
  Shown shown;
  show(shown, kExamples + "hertz.dat");
  REQUIRE(shown.result.status == 0);
  const std::set<std::string> expected = {"model",    "tractions_1", "tractions_2", "status_1",
                                          "status_2", "gap_1",       "gap_2",       "deformed",
                                          "stress",   "stress_zone", "path",        "balance"};
  for (const std::string& name : expected) CHECK_MESSAGE(shown.figures.count(name) == 1, name);
  check_page(shown);
  CHECK(contains(shown.page, "the last pair at an end of a contact zone has closed"));
  CHECK(contains(shown.page, "&#956; = 0.3: reached load factor 1.03 in 28 steps."));
}

TEST_CASE("pictures: captions say what the CSV says") {
  Shown shown;
  show(shown, kExamples + "hertz.dat");
  REQUIRE(shown.result.status == 0);
  int index = 0;
  for (const double mu : {0.4, 0.3}) {
    const std::vector<PairRow> rows = last_rows(read_file(shown.folder / "c.csv"), mu);
    REQUIRE(rows.size() == 15);
    const auto peak = std::max_element(rows.begin(), rows.end(),
                                       [](const PairRow& a, const PairRow& b) { return a.tn < b.tn; });
    double half_width = 0.0;
    int touching = 0, slipping = 0;
    for (const PairRow& row : rows) {
      if (row.status == "open") continue;
      half_width = std::max(half_width, row.x); // flat body, axis at x = 0
      ++touching;
      if (row.status == "slip") ++slipping;
    }
    const std::string caption = caption_of(shown, "tractions_" + std::to_string(++index));
    CHECK(contains(caption, "the peak pressure is " + six(peak->tn) + " at s = "));
    CHECK(contains(caption, "(pair " + std::to_string(peak->pair) + ")"));
    CHECK(contains(caption, std::to_string(touching) + " of 15 pairs touch"));
    CHECK(contains(caption, "contact half width " + six(half_width)));
    CHECK(contains(caption, std::to_string(slipping) + " pairs slip"));
    CHECK(contains(shown.page, "<td>" + six(peak->tn) + "</td>"));
  }
}

TEST_CASE("pictures: other contacts, and a single body") {
  const std::map<std::string, std::set<std::string>> expected = {
      {"sliding_block.dat", {"model", "tractions", "status", "gap", "deformed", "stress", "path", "balance"}},
      {"layer_receding.dat",
       {"model", "tractions", "status", "gap", "deformed", "stress", "path", "balance"}},
      {"thick_ring.dat", {"model", "deformed", "boundary", "stress", "balance"}},
      {"rough_plates.dat", {"model", "tractions_4", "status_4", "gap_4", "deformed", "stress", "path"}}};
  for (const auto& example : expected) {
    Shown shown;
    show(shown, kExamples + example.first);
    REQUIRE(shown.result.status == 0);
    for (const std::string& name : example.second)
      CHECK_MESSAGE(shown.figures.count(name) == 1, example.first << ": " << name);
    check_page(shown);
  }
}

TEST_CASE("pictures: stick and slip of the sliding block as in the CSV") {
  Shown shown;
  show(shown, kExamples + "sliding_block.dat");
  REQUIRE(shown.result.status == 0);
  const std::vector<PairRow> rows = last_rows(read_file(shown.folder / "c.csv"), 0.3);
  int stick = 0, slip = 0;
  double last_stick = -1e9;
  for (const PairRow& row : rows) {
    if (row.status == "slip") ++slip;
    if (row.status != "stick") continue;
    ++stick;
    last_stick = std::max(last_stick, row.x);
  }
  REQUIRE(stick > 0);
  REQUIRE(slip > 0);
  const std::string caption = caption_of(shown, "status");
  CHECK(contains(caption, std::to_string(stick) + " of 25 pairs stick, " + std::to_string(slip) +
                              " slip, 0 are open"));
  char text[40]; // s counts from the block's left corner at x = -1
  std::snprintf(text, sizeof text, "to %.4g.", last_stick + 1.0);
  CHECK_MESSAGE(contains(caption, text), caption << " lacks " << text);
}

TEST_CASE("pictures: units of the deck stand at the axes") {
  const Folder folder;
  write_file(folder / "deck", read_file(kExamples + "hertz.dat") + "*UNITS cm, kN\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  CHECK(contains(shown.figures["tractions_1"], "pressure tn [kN/cm&#178;]"));
  CHECK(contains(shown.figures["model"], ">x [cm]<"));
  check_page(shown);
}

TEST_CASE("pictures: a load that goes down again is drawn over its steps") {
  std::string deck = read_file(kExamples + "hertz.dat");
  const size_t last = deck.find("    2     1.0300");
  REQUIRE(last != std::string::npos);
  deck.replace(last, 16, "    2     0.4000");
  const Folder folder;
  write_file(folder / "deck", deck);
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE(shown.result.status == 0);
  CHECK(contains(shown.figures["status_1"], ">step<"));
  check_page(shown);
}

TEST_CASE("pictures: a path through two load cases is drawn over its steps") {
  const Folder folder;
  write_file(folder / "deck", read_file(kExamples + "sliding_block.dat") +
                                  "*CASES 2\ncase 2\n condition 2 25-48 0 0.05 0 0 0\n"
                                  "*PATH\n 2, 1, 0\n 6 1 0.3\n 6 1 -0.5\n");
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  for (const char* name : {"status", "path", "energy"})
    CHECK_MESSAGE(contains(shown.figures[name], ">step<"), name);
  check_page(shown);
}

TEST_CASE("pictures: images make the whole body") {
  Shown shown;
  show(shown, kExamples + "thick_ring.dat", "--symmetry images");
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  CHECK(contains(shown.figures["model"], "line of symmetry"));
  CHECK(contains(shown.figures["model"], "&#8722;2")); // the axis reaches the other side
  CHECK(contains(shown.figures["stress"], "&#8722;2"));
  check_page(shown);
}

TEST_CASE("pictures: work is stored or dissipated, as the JSON says") {
  Shown shown;
  show(shown, kExamples + "sliding_block.dat", "--json " + quoted(shown.folder / "r.json"));
  REQUIRE(shown.result.status == 0);
  const Json json = JsonReader::read(read_file(shown.folder / "r.json"));
  REQUIRE(!json["steps_detail"].items.empty());
  const Json& last = json["steps_detail"].items.back();
  const std::string caption = caption_of(shown, "energy");
  for (const char* key : {"work", "elastic", "dissipated"})
    CHECK_MESSAGE(contains(caption, six(last[key].number)), caption << " lacks " << key);
}

TEST_CASE("pictures: a run that stops early still has its page, which says so") {
  const Folder folder; // a horizontal load that friction cannot carry
  std::string deck = read_file(kExamples + "sliding_block.dat");
  const size_t mu = deck.find("    1     0.3000\n");
  REQUIRE(mu != std::string::npos);
  deck.replace(mu, 17, "    1     0.0500\n");
  write_file(folder / "deck", deck);
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE(shown.result.status == 1);
  CHECK(contains(shown.page, "<b>incomplete</b>, stopped at load factor"));
  CHECK(names_of(shown).count("model") == 1);
  check_page(shown);
}

TEST_CASE("pictures: outputs that cannot be written end with 3 and leave nothing") {
  const Folder folder;
  write_file(folder / "file", "x");
  const std::string run = "'" C2D_TEST_PROGRAM "' run " + quoted(kExamples + "hertz.dat") + " --csv " +
                          quoted(folder / "c.csv") + " --listing /dev/null ";
  for (const std::string& option :
       {"--report " + quoted(folder / "none/r.html"), "--vtk " + quoted(folder / "none/b.vtk"),
        "--figures " + quoted(folder / "none/figures"), "--figures " + quoted(folder / "file"),
        "--figures " + quoted(folder / "new") + " --report " + quoted(folder / "none/r.html"),
        "--figures " + quoted(folder / "new") + " --report /dev/full"}) {
    CHECK_MESSAGE(run_shell(run + option).status == 3, option);
    CHECK_MESSAGE(folder.names() == std::vector<std::string>{"file"}, option);
  }
  CHECK(read_file(folder / "file") == "x");
}

TEST_CASE("pictures: a bad deck leaves neither page nor folder") {
  const Folder folder;
  write_file(folder / "deck", "    1\nnot a deck\n  x\n");
  CHECK(run_shell("'" C2D_TEST_PROGRAM "' run " + quoted(folder / "deck") + " --report " +
                  quoted(folder / "r.html") + " --figures " + quoted(folder / "figures") + " --vtk " +
                  quoted(folder / "b.vtk"))
            .status == 2);
  CHECK(folder.names() == std::vector<std::string>{"deck"});
}

TEST_CASE("pictures: the same output as without them") {
  const Folder folder;
  const std::string run = "'" C2D_TEST_PROGRAM "' run " + quoted(kExamples + "hertz.dat") + " --csv ";
  REQUIRE(run_shell(run + quoted(folder / "a.csv") + " --listing " + quoted(folder / "a.lst")).status == 0);
  REQUIRE(run_shell(run + quoted(folder / "b.csv") + " --listing " + quoted(folder / "b.lst") + " --report " +
                    quoted(folder / "r.html"))
              .status == 0);
  CHECK(read_file(folder / "a.csv") == read_file(folder / "b.csv"));
  CHECK(read_file(folder / "a.lst") == read_file(folder / "b.lst"));
}

// ---------------------------------------------------------------- VTK
namespace {

struct Vtk {
  std::vector<std::array<double, 3>> points, displacement, traction;
  std::vector<std::array<double, 1>> von_mises;
  std::vector<std::vector<int>> cells;
  std::vector<int> types, body, element, status;
  size_t tensors = 0;
  std::string fault;
};

template <size_t n>
void read_tuples(std::istream& in, size_t count, std::vector<std::array<double, n>>& out) {
  out.resize(count);
  for (auto& tuple : out)
    for (double& x : tuple) in >> x;
}
void read_scalars(std::istream& in, size_t count, std::vector<int>& out) {
  std::string word;
  in >> word >> word >> word; // type is read by the caller; components, LOOKUP_TABLE default
  out.resize(count);
  for (int& x : out) in >> x;
}

Vtk read_vtk(const std::string& text) {
  Vtk out;
  std::istringstream in(text);
  std::string line, word, name;
  std::getline(in, line);
  if (line != "# vtk DataFile Version 3.0") out.fault = line;
  std::getline(in, line);
  std::getline(in, line);
  if (line != "ASCII") out.fault = line;
  size_t count = 0, numbers = 0, tuples = 0;
  while (in >> word) {
    if (word == "DATASET") {
      in >> name;
      if (name != "UNSTRUCTURED_GRID") out.fault = name;
    } else if (word == "POINTS") {
      in >> count >> name;
      read_tuples(in, count, out.points);
    } else if (word == "CELLS") {
      in >> count >> numbers;
      for (size_t c = 0; c < count; ++c) {
        int n = 0;
        in >> n;
        numbers -= static_cast<size_t>(n) + 1;
        out.cells.emplace_back(static_cast<size_t>(n));
        for (int& i : out.cells.back()) in >> i;
      }
      if (numbers != 0) out.fault = "size of CELLS";
    } else if (word == "CELL_TYPES") {
      in >> count;
      out.types.resize(count);
      for (int& t : out.types) in >> t;
    } else if (word == "CELL_DATA" || word == "POINT_DATA") {
      in >> tuples;
    } else if (word == "SCALARS") {
      in >> name >> word;
      if (name == "von_mises") {
        in >> word >> word >> word;
        read_tuples(in, tuples, out.von_mises);
        continue;
      }
      read_scalars(in, tuples, name == "body" ? out.body : name == "element" ? out.element : out.status);
    } else if (word == "VECTORS") {
      in >> name >> word;
      read_tuples(in, tuples, name == "displacement" ? out.displacement : out.traction);
    } else if (word == "TENSORS") {
      in >> name >> word;
      std::vector<std::array<double, 9>> tensors;
      read_tuples(in, tuples, tensors);
      out.tensors = tensors.size();
    } else {
      out.fault = "unknown word " + word;
      break;
    }
  }
  return out;
}

} // namespace

TEST_CASE("pictures: the VTK file holds the boundary CSV") {
  for (const char* example : {"hertz.dat", "thick_ring.dat"}) {
    Shown shown;
    show(shown, kExamples + example);
    REQUIRE(shown.result.status == 0);
    const Vtk vtk = read_vtk(shown.vtk);
    CHECK_MESSAGE(vtk.fault.empty(), vtk.fault);
    const std::vector<std::string> rows = lines_of(read_file(shown.folder / "b.csv"));
    const size_t boundary = rows.size() - 1; // a grid inside follows
    REQUIRE(vtk.points.size() > boundary);
    REQUIRE(vtk.displacement.size() == vtk.points.size());
    REQUIRE(vtk.traction.size() == vtk.points.size());
    CHECK(vtk.status.size() == vtk.points.size());
    CHECK(vtk.tensors == vtk.points.size());
    CHECK(vtk.von_mises.size() == vtk.points.size());
    CHECK(vtk.types.size() == vtk.cells.size());
    CHECK(vtk.body.size() == vtk.cells.size());
    size_t ends = 0;
    for (size_t c = 0; c < vtk.cells.size() && vtk.element[c] > 0; ++c) {
      ends += vtk.cells[c].size();
      const size_t n = vtk.cells[c].size();
      CHECK(vtk.types[c] == (n == 1 ? 1 : n == 2 ? 3 : n == 3 ? 21 : 35));
    }
    CHECK(ends == boundary);
    for (size_t i = 0; i < boundary; ++i) {
      std::istringstream in(rows[i + 1]);
      std::vector<double> f;
      for (std::string field; std::getline(in, field, ',');) f.push_back(std::stod(field));
      REQUIRE(f.size() == 9);
      CHECK(vtk.points[i][0] == f[3]);
      CHECK(vtk.points[i][1] == f[4]);
      CHECK(vtk.displacement[i][0] == f[5]);
      CHECK(vtk.displacement[i][1] == f[6]);
      CHECK(vtk.traction[i][0] == f[7]);
      CHECK(vtk.traction[i][1] == f[8]);
    }
    // A quadratic edge lists its ends first: its middle node lies nearer to both than they to each other.
    for (const std::vector<int>& cell : vtk.cells) {
      if (cell.size() != 3) continue;
      const auto place = [&](int i) { return vtk.points[static_cast<size_t>(cell[static_cast<size_t>(i)])]; };
      const auto apart = [&](int i, int k) {
        return std::hypot(place(i)[0] - place(k)[0], place(i)[1] - place(k)[1]);
      };
      CHECK(apart(0, 2) < apart(0, 1));
      CHECK(apart(1, 2) < apart(0, 1));
    }
  }
}

// ---------------------------------------------------------------- contours and axes
namespace {

double area_of(const app::Polygons& polygons) {
  double sum = 0.0;
  for (const auto& polygon : polygons) {
    double twice = 0.0;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const app::Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      twice += a.x * b.y - a.y * b.x;
    }
    sum += 0.5 * std::fabs(twice);
  }
  return sum;
}

app::Grid make_grid(size_t columns, size_t rows, double (*f)(double, double)) {
  app::Grid g;
  g.columns = columns;
  g.rows = rows;
  g.dx = 1.0 / static_cast<double>(columns - 1);
  g.dy = 1.0 / static_cast<double>(rows - 1);
  for (size_t r = 0; r < rows; ++r)
    for (size_t c = 0; c < columns; ++c) {
      const app::Point p = g.place(c, r);
      g.values.push_back(f(p.x, p.y));
      g.known.push_back(1);
    }
  return g;
}

} // namespace

TEST_CASE("contours: bands of a plane have their exact areas") {
  const app::Grid g = make_grid(14, 9, [](double x, double y) { return x + y; });
  const std::vector<app::Polygons> bands = app::fill_bands(g, {0.0, 0.5, 1.0, 1.5, 2.0});
  REQUIRE(bands.size() == 4);
  const double exact[] = {0.125, 0.375, 0.375, 0.125}; // corner triangles of the unit square
  for (size_t k = 0; k < 4; ++k) CHECK(area_of(bands[k]) == doctest::Approx(exact[k]).epsilon(1e-12));
}

TEST_CASE("contours: bands of a paraboloid converge to discs and cover the square once") {
  double last = 1.0;
  for (const size_t n : {11u, 41u}) {
    const app::Grid g = make_grid(n, n, [](double x, double y) { return x * x + y * y; });
    const std::vector<app::Polygons> bands = app::fill_bands(g, {0.0, 0.25, 0.81, 2.0});
    double sum = 0.0;
    for (const auto& band : bands) sum += area_of(band);
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
    const double pi = 3.14159265358979323846;
    const double error = std::fabs(area_of(bands[1]) - pi / 4.0 * (0.81 - 0.25));
    CHECK(error < 0.2 * last); // second order would be 1/16
    last = error;
  }
  CHECK(last < 1e-3);
}

TEST_CASE("contours: values beyond the levels belong to the outer bands, unknown cells to none") {
  app::Grid g = make_grid(3, 3, [](double x, double) { return 10.0 * x - 5.0; });
  g.known[g.at(2, 2)] = 0;
  const std::vector<app::Polygons> bands = app::fill_bands(g, {-1.0, 0.0, 1.0});
  CHECK(area_of(bands[0]) + area_of(bands[1]) == doctest::Approx(0.75));
}

TEST_CASE("contours: a plane is continued exactly") {
  app::Grid g = make_grid(9, 9, [](double x, double y) { return 2.0 * x - 3.0 * y + 1.0; });
  const app::Grid whole = g;
  for (size_t r = 0; r < 9; ++r)
    for (size_t c = 0; c < 9; ++c)
      if (c + r > 10) g.values[g.at(c, r)] = 99.0, g.known[g.at(c, r)] = 0;
  app::extend(g, 2);
  for (size_t i = 0; i < g.values.size(); ++i)
    if (g.known[i]) CHECK(g.values[i] == doctest::Approx(whole.values[i]).epsilon(1e-12));
  CHECK(g.known[g.at(5, 6)] == 1);
  CHECK(g.known[g.at(8, 8)] == 0);
}

TEST_CASE("contours: inside and outside of a ring") {
  const std::vector<std::vector<app::Point>> ring = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}},
                                                     {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
  CHECK(app::is_inside(ring, {0.5, 0.5}));
  CHECK(!app::is_inside(ring, {2.0, 2.0}));
  CHECK(!app::is_inside(ring, {5.0, 2.0}));
}

TEST_CASE("axes: steps of 1, 2 or 5, labels without rounding, power of ten in the name") {
  const auto axis_of = [](double low, double high, int about) {
    app::Range range;
    range.include(low);
    range.include(high);
    return app::make_axis(range, "p", "MPa", about);
  };
  for (const double size : {1e-9, 3.7e-5, 0.02, 1.0, 47.0, 1.3e4, 8e11})
    for (const double low : {0.0, -0.3, 0.9}) {
      const app::Axis a = axis_of(low * size, size, 6);
      CHECK(a.low <= low * size + 1e-6 * a.step);
      CHECK(a.high >= size - 1e-6 * a.step);
      CHECK(a.ticks >= 3);
      CHECK(a.ticks <= 14);
      for (int i = 0; i < a.ticks; ++i) {
        std::string label = a.label(i);
        if (label.compare(0, 7, "&#8722;") == 0) label = "-" + label.substr(7);
        CHECK(std::stod(label) * a.power == doctest::Approx(a.tick(i)).epsilon(1e-9).scale(a.step));
        CHECK(label.size() <= 8);
      }
    }
  CHECK(axis_of(0.0, 1.0, 5).name == "p [MPa]");
  CHECK(axis_of(0.0, 8e11, 5).name == "p [10&#8313; MPa]");
  const app::Axis constant = axis_of(5.0, 5.0, 5);
  CHECK(constant.low < 5.0);
  CHECK(constant.high > 5.0);
}

TEST_CASE("pictures: words of the user cannot break a page") {
  CHECK(app::escape_xml("a<b & \"c\">\x01\xe4") == "a&lt;b &amp; &quot;c&quot;&gt;??");
  const Folder folder;
  std::string deck = read_file(kExamples + "thick_ring.dat");
  std::vector<std::string> cards = lines_of(deck);
  const size_t title = static_cast<size_t>(std::stoi(cards[0]));
  cards[title] = "<script>alert(1)</script> & \"x\"";
  std::string changed;
  for (const std::string& card : cards) changed += card + "\n";
  write_file(folder / "deck", changed);
  Shown shown;
  show(shown, folder / "deck");
  REQUIRE(shown.result.status == 0);
  check_page(shown);
  CHECK(contains(shown.page, "&lt;script&gt;"));
}
