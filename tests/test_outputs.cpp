// What a cyclic history leaves in the outputs: every load factor, slip from turn to turn, the key table, curves at reversals;
// and the page on a dark screen.
#include "json.hpp"
#include "paths.hpp"
#include "picture_runs.hpp"
#include "report/drawn/dark.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

using namespace test;

namespace {

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> out(1);
  for (const char c : row)
    if (c == ',')
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

// A table by the names of its columns.
struct Table {
  std::map<std::string, size_t> column;
  std::vector<std::vector<std::string>> rows;
  explicit Table(const std::string& text) {
    for (const std::string& line : lines_of(text)) rows.push_back(cells_of(line));
    for (size_t k = 0; k < rows.at(0).size(); ++k) column[rows[0][k]] = k;
    rows.erase(rows.begin());
  }
  double number(size_t row, const std::string& name) const { return std::stod(rows[row][column.at(name)]); }
};

// Cattaneo's cylinder, there and back twice: 4 increments from no shear to the largest.
struct Cycle {
  Folder folder;
  std::string listing, page, tractions;
  Cycle() {
    const std::string program = quoted(paths::program()), deck = folder / "deck.dat";
    REQUIRE(run_shell(program + " make mindlin n=10 cycles=2 > " + quoted(deck)).status == 0);
    const Result r = run_shell(program + " run -q " + quoted(deck) + " --out " + quoted(folder / "o"));
    REQUIRE_MESSAGE(r.status == 0, r.err);
    listing = read_file(folder / "o/listing.txt");
    tractions = read_file(folder / "o/figures/tractions.svg");
    page = read_file(folder / "o/report.html");
  }
};

// The second load of the family at a step: 0 with the first, then there and back, 4 steps from 0 to the largest.
double shear_at(int step) {
  const int way = (step - 1) % 16;
  return (way <= 4 ? way : way <= 12 ? 8 - way : way - 16) / 4.0;
}

} // namespace

// Cells of a line that two blanks or more separate.
static std::string words_of_line(const std::string& line) {
  std::string out;
  for (size_t i = line.find_first_not_of(' '); i != std::string::npos;) {
    const size_t end = line.find("  ", i);
    out += (out.empty() ? "" : "|") + line.substr(i, end == std::string::npos ? end : end - i);
    i = end == std::string::npos ? end : line.find_first_not_of(' ', end);
  }
  return out;
}

TEST_CASE("outputs: every load factor, slip since the loads turned, the key table, curves where loads turn") {
  const Cycle cycle;
  const Table contact(read_file(cycle.folder / "o/contact.csv")), bodies(read_file(cycle.folder / "o/bodies.csv")),
      summary(read_file(cycle.folder / "o/summary.csv"));
  for (const Table* t : {&contact, &bodies, &summary})
    for (size_t i = 0; i < t->rows.size(); ++i) {
      REQUIRE(t->rows[i].size() == t->column.size());
      CHECK(t->number(i, "load") == 1);
      CHECK(t->number(i, "load2") == shear_at(static_cast<int>(t->number(i, "step"))));
    }
  CHECK(contact.rows[0].size() == 19); // what came later stands at the end
  CHECK(contact.column.at("load2") == 18);

  std::map<int, std::map<int, double>> slip;     // by step and pair
  std::map<int, double> most;                    // of pairs that touch, since the loads turned
  std::map<int, std::map<double, double>> along; // the same of all of them, by x
  for (size_t i = 0; i < contact.rows.size(); ++i) {
    const int step = static_cast<int>(contact.number(i, "step")), pair = static_cast<int>(contact.number(i, "pair"));
    slip[step][pair] = contact.number(i, "slip");
    const int turn = step <= 1 ? 0 : step <= 5 ? 1 : 5 + (step - 6) / 8 * 8; // shear begins at 1, turns at 5, 13, 21, 29
    const double range = std::fabs(slip[step][pair] - (turn > 0 ? slip[turn][pair] : 0.0));
    if (contact.rows[i][contact.column.at("status")] != "open")
      most[step] = std::max(most[step], range), along[step][contact.number(i, "x")] = range;
  }
  size_t seen = 0;
  for (size_t i = 0; i < summary.rows.size(); ++i)
    if (summary.rows[i][summary.column.at("quantity")] == "slip range") {
      const std::map<double, double>& row = along[static_cast<int>(summary.number(i, "step"))];
      const double x = summary.number(i, "x"); // beyond the last pair: by the line through the last two
      auto next = row.lower_bound(x);
      if (next == row.begin() || next == row.end()) next = next == row.end() ? std::prev(next) : std::next(next);
      const auto last = std::prev(next);
      const double slope = (next->second - last->second) / (next->first - last->first);
      CHECK(summary.number(i, "value") == doctest::Approx(last->second + slope * (x - last->first)).epsilon(1e-3));
      ++seen;
    }
  CHECK(seen == 36);                                           // at all steps but the first, where nothing has slipped
  CHECK(std::fabs(most[37] / most[29] - 1) < 1e-6);            // a cycle goes as far there as back
  CHECK(std::fabs(most[37] / most[5] - 2) < 0.05);             // twice as far as the first quarter, but for locked-in slip
  CHECK(most[37] > 1.2 * std::fabs(slip[37].begin()->second)); // and no sum over the path

  // The key table of the listing, by the table of the summary.
  const size_t at = cycle.listing.find("Contact in numbers, step by step");
  REQUIRE(at != std::string::npos);
  const size_t heading = cycle.listing.find("stick borders", at), below = cycle.listing.find('\n', heading);
  CHECK(words_of_line(cycle.listing.substr(heading, below - heading)) ==
        "stick borders|contact width|stuck width|eccentricity");
  std::istringstream rows(cycle.listing.substr(below));
  for (int step = 1; step <= 37; ++step) {
    std::map<std::string, double> value;
    double along_peak = -1; // along the second side of the statement
    std::string along_edges;
    for (size_t i = 0; i < summary.rows.size(); ++i) {
      if (summary.number(i, "step") != step) continue;
      const std::string& name = summary.rows[i][summary.column.at("quantity")];
      value[name] = summary.number(i, "value");
      if (name == "peak pressure") along_peak = summary.number(i, "along");
      if (name == "contact edge") along_edges += (along_edges.empty() ? "" : ", ") + six(summary.number(i, "along"));
    }
    std::string word[13];
    for (std::string& w : word) REQUIRE(static_cast<bool>(rows >> w));
    std::string rest;
    std::getline(rows, rest);
    CHECK(std::stod(word[0]) == step);
    CHECK(std::stod(word[2]) == shear_at(step));
    CHECK(std::stod(word[3]) == doctest::Approx(value.at("peak pressure")).epsilon(1e-5));
    CHECK(std::stod(word[6]) == doctest::Approx(along_peak).epsilon(1e-5));
    CHECK(std::stod(word[8]) == doctest::Approx(value.at("force y")).epsilon(1e-5));
    if (step > 1) CHECK(std::stod(word[11]) == doctest::Approx(value.at("slip range")).epsilon(1e-5));
    if (step > 1) CHECK(std::stod(word[12]) == doctest::Approx(value.at("dissipated")).epsilon(1e-5));
    const std::string end = words_of_line(rest); // edges, borders, and what came later
    std::vector<std::string> last;
    std::istringstream in_end(end);
    for (std::string cell; std::getline(in_end, cell, '|');) last.push_back(cell);
    REQUIRE_MESSAGE(last.size() == 5, end);
    CHECK(last[0] == along_edges);
    CHECK(last[2] == six(value.at("contact width")));
    CHECK(last[3] == (value.count("stuck width") != 0 ? six(value.at("stuck width")) : "-"));
  }
  CHECK(contains(cycle.listing, "Increments\n"));
  CHECK(contains(cycle.listing, "  load factors " + std::string(29, '.') + " 1, 1\n"));

  // Thin curves: at the last turn that is another state than the end, not at a quarter of the way.
  CHECK(contains(cycle.tractions, "step 29: load 1, -1"));
  for (const char* other : {"step 9:", "step 13:", "step 19:", "step 21:", "step 28:"})
    CHECK(!contains(cycle.tractions, other));

  // The loop: its area by the force and the shift of the summary, which is not more than what friction took.
  std::map<int, double> force, shift, dissipated;
  for (size_t i = 0; i < summary.rows.size(); ++i) {
    const std::string what = summary.rows[i][summary.column.at("quantity")];
    const int step = static_cast<int>(summary.number(i, "step"));
    if (what == "force x") force[step] = summary.number(i, "value");
    if (what == "shift") shift[step] = summary.number(i, "value");
    if (what == "dissipated") dissipated[step] = summary.number(i, "value");
  }
  double area = 0;
  for (int step = 22; step <= 37; ++step) area += 0.5 * (force[step] + force[step - 1]) * (shift[step] - shift[step - 1]);
  const std::string loop = read_file(cycle.folder / "o/figures/loop.svg");
  const size_t told = loop.find("The last cycle, steps 21 to 37, encloses the area ");
  REQUIRE(told != std::string::npos);
  const double shown = std::stod(loop.substr(told + 50));
  CHECK(std::fabs(shown / std::fabs(area) - 1) < 1e-3); // the surface is all but flat
  CHECK(shown < dissipated[37] - dissipated[21]);
  CHECK(shown > 0.5 * (dissipated[37] - dissipated[21]));
  CHECK(contains(cycle.page, "<details>\n<summary>Step by step"));
}

TEST_CASE("outputs: the largest stress in a picture is found where it is; what is zero everywhere has no picture") {
  Shown shown;
  const std::string deck = shown.folder / "d.dat";
  REQUIRE(run_shell(quoted(paths::program()) + " make hertz n=20 R=100 > " + quoted(deck)).status == 0);
  show(shown, deck, "--summary " + quoted(shown.folder / "s.csv"));
  REQUIRE(shown.result.status == 0);
  const Table summary(read_file(shown.folder / "s.csv"));
  double p0 = 0;
  for (size_t i = 0; i < summary.rows.size(); ++i)
    if (summary.rows[i][summary.column.at("quantity")] == "peak pressure") p0 = summary.number(i, "value");
  double most = 0, depth = 0; // below the middle of Hertz' contact, over p0 and its half width, plane strain
  for (double z = 0.01; z < 3; z += 0.001) {
    const double r = std::sqrt(1 + z * z), x = 2 * z - (1 + 2 * z * z) / r, y = -1 / r, w = 0.3 * (x + y);
    const double mises = std::sqrt(0.5 * ((x - y) * (x - y) + (y - w) * (y - w) + (w - x) * (w - x)));
    if (mises > most) most = mises, depth = z;
  }
  const std::string caption = caption_of(shown, "stress_zone"), words = "the largest value in the picture is ";
  const size_t at = caption.find(words), place = caption.find("at (", at);
  REQUIRE(at != std::string::npos);
  CHECK(std::fabs(std::stod(caption.substr(at + words.size())) / (most * p0) - 1) < 0.005); // R is but 100 half widths
  CHECK(std::fabs(std::stod(caption.substr(place + 4))) < 0.02);
  CHECK(std::fabs(std::fabs(std::stod(caption.substr(caption.find(',', place) + 1))) - depth) < 0.03);
  CHECK(shown.figures.count("loop") == 0); // smooth
  CHECK(!contains(shown.figures.at("tractions"), "Friction"));
  CHECK(!contains(shown.figures.at("energy"), "dissipated by friction</text>"));
}

namespace {

// Relative luminance and contrast as accessibility guidelines (WCAG 2) define them.
double luminance(const std::string& colour) {
  double sum = 0;
  const double weights[3] = {0.2126, 0.7152, 0.0722};
  for (size_t k = 0; k < 3; ++k) {
    const double c = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
    sum += weights[k] * (c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return sum;
}
double contrast(const std::string& a, const std::string& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}
std::string dark(const std::string& light) {
  for (int i = 0; i < app::kDarkColourCount; ++i)
    if (light == app::kDarkColours[i].light) return app::kDarkColours[i].dark;
  return "";
}

} // namespace

TEST_CASE("outputs: on a dark screen every colour of the pictures has another, and stays legible") {
  Shown shown;
  show(shown, example("hertz.dat"));
  REQUIRE(shown.result.status == 0);
  CHECK(contains(shown.page, "@media screen and (prefers-color-scheme:dark)"));
  size_t colours = 0;
  for (const auto& figure : shown.figures) {
    if (figure.first.substr(0, 6) == "stress") continue; // the scale of contours stays
    std::vector<Element> elements;
    REQUIRE(read_xml(figure.second, elements).empty());
    for (const Element& e : elements)
      for (const char* what : {"fill", "stroke"}) {
        const auto found = e.attributes.find(what);
        if (found == e.attributes.end() || found->second == "none" || found->second.substr(0, 3) == "url") continue;
        ++colours;
        CHECK_MESSAGE(!dark(found->second).empty(), figure.first << ": " << found->second);
        CHECK(contains(shown.page, std::string("svg [") + what + "=\"" + found->second + "\"]"));
      }
  }
  CHECK(colours > 1000);
  const std::string paper = dark("white");
  CHECK(contrast(dark("#222222"), paper) > 12); // text
  for (const char* line : {"#0060a8", "#d55e00", "#007a5a", "#a0438a", "#888888", "#8a5a00", "#444444", "#33521f"})
    CHECK_MESSAGE(contrast(dark(line), paper) > 4.5, line);
  for (const char* fill : {"#dce9f5", "#e6c88c", "#a4b494", "#e8d0dc", "#b4b8cc", "#f6f3ea"}) // letters on bodies
    CHECK_MESSAGE(contrast(dark("#222222"), dark(fill)) > 5, fill);
}

TEST_CASE("outputs: a node that is at 0 but for round-off has its place told as 0, in the page and in its pictures") {
  Shown shown;
  const std::string program = quoted(paths::program()), deck = shown.folder / "d.dat";
  std::string text = run_shell(program + " make mindlin n=4").out;
  for (const char* origin : {"points of plane\n0 0\n", "points of cylinder\n0 0\n"}) {
    const size_t at = text.find(origin);
    REQUIRE(at != std::string::npos);
    text.replace(text.find("\n0", at), 2, "\n5e-11");
  }
  write_file(deck, text);
  show(shown, deck);
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  CHECK(contains(read_file(shown.folder / "c.csv"), "e-11,0,stick,")); // as the deck has it
  CHECK(contains(shown.page, "<td>0</td>"));
  CHECK_FALSE(contains(shown.page, "5e-11"));
}

namespace {

std::vector<app::Point> points_of(const std::string& path) {
  std::vector<app::Point> out;
  for (size_t at = 0; (at = path.find_first_of("ML", at)) != std::string::npos; ++at) {
    char* end = nullptr;
    const double x = std::strtod(path.c_str() + at + 1, &end);
    out.push_back({x, std::strtod(end, nullptr)});
  }
  return out;
}

} // namespace

TEST_CASE("outputs: a ring that was shrunk on lies on its bush in the magnified deformed shape, all round") {
  Shown shown;
  const std::string deck = shown.folder / "d.dat";
  REQUIRE(run_shell(quoted(paths::program()) + " make shrink n=6 > " + quoted(deck)).status == 0);
  show(shown, deck);
  REQUIRE(shown.result.status == 0);
  std::vector<Element> elements;
  REQUIRE(read_xml(shown.figures.at("deformed"), elements).empty());
  std::map<std::string, std::vector<app::Point>> body; // of the left view, the first of each fill
  for (const Element& e : elements)
    if (e.name == "path" && e.attributes.count("fill") && e.attributes.count("fill-rule"))
      body.emplace(e.attributes.at("fill"), points_of(e.attributes.at("d")));
  const std::vector<app::Point>&bush = body.at("#e6c88c"), &ring = body.at("#f6f3ea");
  double left = HUGE_VAL, right = -HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL, r = 0;
  for (const app::Point& p : ring)
    left = std::min(left, p.x), right = std::max(right, p.x), low = std::min(low, p.y), high = std::max(high, p.y);
  const double cx = 0.5 * (left + right), cy = 0.5 * (low + high);
  for (const app::Point& p : bush) r = std::max(r, std::hypot(p.x - cx, p.y - cy));
  size_t around[4] = {0, 0, 0, 0};
  for (const app::Point& p : ring) {
    const double apart = std::hypot(p.x - cx, p.y - cy) - r;
    if (apart > 0.25 * r) continue;     // outside: 3 against 2
    CHECK(std::fabs(apart) < 0.01 * r); // unmagnified gaps left a tenth
    ++around[(p.x < cx) + 2 * (p.y < cy)];
  }
  for (const size_t quarter : around) CHECK(quarter > 5);
}

TEST_CASE("outputs: a folder holds nothing of an earlier run's model, and all that the program has not made") {
  const Folder folder;
  const std::string program = quoted(paths::program()), out = folder / "o", figures = folder / "o/figures";
  const auto run = [&](const std::string& deck, const std::string& options) {
    const Result r = run_shell(program + " run -q " + quoted(example(deck)) + " " + options);
    REQUIRE_MESSAGE(r.status == 0, r.err);
  };
  const auto names_in = [](const std::string& of) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(of)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  };
  write_file(folder / "points.csv", "body,x,y\n1,0.5,3\n");
  run("hertz.dat", "--points " + quoted(folder / "points.csv") + " --out " + quoted(out));
  REQUIRE(std::filesystem::exists(figures + "/tractions_2.svg"));
  REQUIRE(lines_of(read_file(out + "/interior.csv")).size() == 2);

  // Copied, changed, linked to, of that name alone: not the program's.
  const std::string drawn = read_file(figures + "/tractions_1.svg");
  write_file(figures + "/mine.svg", drawn);
  write_file(figures + "/status_1.svg", read_file(figures + "/status_1.svg") + "<!-- mine -->\n");
  write_file(figures + "/gap_9.svg", "<svg/>\n");
  write_file(figures + "/empty.svg", "");
  write_file(figures + "/note.txt", drawn);
  write_file(folder / "tractions_2.svg", read_file(figures + "/tractions_2.svg"));
  std::filesystem::remove(figures + "/tractions_2.svg");
  std::filesystem::create_symlink("../../tractions_2.svg", figures + "/tractions_2.svg");
  std::filesystem::create_directory(figures + "/folder.svg");

  run("thick_ring.dat", "--out " + quoted(out));
  run("thick_ring.dat", "--out " + quoted(folder / "fresh"));
  std::vector<std::string> expected = names_in(folder / "fresh/figures");
  for (const char* name : {"mine.svg", "status_1.svg", "gap_9.svg", "empty.svg", "note.txt", "tractions_2.svg", "folder.svg"})
    expected.push_back(name);
  std::sort(expected.begin(), expected.end());
  CHECK(names_in(figures) == expected);
  CHECK(std::filesystem::exists(folder / "tractions_2.svg"));
  CHECK(lines_of(read_file(out + "/interior.csv")).size() == 1); // its header
  CHECK(!std::filesystem::exists(folder / "fresh/interior.csv"));

  // Points of somebody else stay, and so do pictures in a folder that has none of this run's.
  write_file(out + "/interior.csv", "x\n");
  run("hertz.dat", "--figures " + quoted(out));
  run("thick_ring.dat", "--out " + quoted(out));
  CHECK(read_file(out + "/interior.csv") == "x\n");
  CHECK(std::filesystem::exists(out + "/tractions_1.svg"));
  run("thick_ring.dat", "--figures " + quoted(out) + " --out " + quoted(out));
  CHECK(!std::filesystem::exists(out + "/tractions_1.svg"));
  CHECK(std::filesystem::exists(out + "/model.svg"));

  // A run that fails takes nothing away.
  write_file(folder / "deck", "    1\nnot a deck\n");
  CHECK(run_shell(program + " run " + quoted(folder / "deck") + " --out " + quoted(out)).status == 2);
  CHECK(names_in(figures) == expected);
}

TEST_CASE("outputs: motions of a rigid body bear its name, in JSON, table and page, and are those of its point") {
  Folder folder;
  write_file(folder / "shoe.c2s", read_file(example("tutorial/t9_shoe.c2s")) + "\ntolerance off\n");
  const Result r = run_shell("cd " + quoted(folder.path()) + " && " + quoted(paths::program()) +
                             " run -q shoe.c2s --json j --summary s --report r --listing l");
  REQUIRE_MESSAGE(r.status == 0, r.err);
  const Json json = JsonReader::read(read_file(folder / "j"));
  const Json &last = json["steps_detail"].items.back(), &motion = last["bodies"][2]["motion"];
  const std::vector<std::string> names = {"motion x", "motion y", "rotation"};
  size_t found = 0;
  for (const Json& q : last["quantities"].items) {
    CHECK(q.has("name") == (q["zone"].number == 0 && q["item"].number > 0));
    const size_t i = static_cast<size_t>(std::find(names.begin(), names.end(), q["quantity"].text) - names.begin());
    if (i == names.size()) continue;
    CHECK(q["item"].number == 3);
    CHECK(q["name"].text == "shoe");
    CHECK(std::fabs(q["value"].number - motion[i].number) < 1e-11 * std::fabs(motion[i].number));
    ++found;
  }
  CHECK(found == names.size());
  CHECK(read_file(folder / "s").find(",shoe,motion x,3,") != std::string::npos);
  CHECK(read_file(folder / "r").find("motion x</a>, body 3 (shoe)") != std::string::npos);
}
