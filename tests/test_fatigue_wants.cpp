// Fatigue parameters requested by a sketch: statements, values of uniform and linear stress, the Cattaneo contact.
#include "json.hpp"
#include "paths.hpp"
#include "program/estimate/fatigue.hpp"
#include "program/estimate/kept.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/refine.hpp"
#include "shell.hpp"
#include "sketches.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

using namespace sketch;
using namespace sketches;

namespace {

// A square whose stress yy is the load factor of `pull`, or that factor times x.
const std::string kConstants = " fatigue fatemi-socie 0.5 yield 2 findley 0.3 crossland 0.4 dang-van 0.25\n";
std::string square(const std::string& constants, const std::string& traction) {
  return "plane stress\nbody b E 10 nu 0.3" + constants +
         "from 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix b.s y\nfix b.w.start x\n"
         "case pull\ntraction b.n fy " +
         traction + "\n";
}
const std::string kUniform = square(kConstants, "1") + "history pull 1, -1, 0.5, 1\n"; // 12 lines

std::vector<app::Stated> values_on(const Sketch& s, double fineness, estimate::Trial& trial) {
  const Mesh mesh = first_mesh(s, fineness);
  estimate::Demand demand;
  estimate::ask(s, demand);
  estimate::ask_below(s, mesh, demand.cycle);
  std::string why;
  REQUIRE_MESSAGE(estimate::solve(deck_of(s, mesh), demand, trial, why) == C2D_OK, why);
  return estimate::wanted_of(s, mesh, trial);
}
std::vector<app::Stated> values_on(const Sketch& s, double fineness = 0.5) {
  estimate::Trial trial;
  return values_on(s, fineness, trial);
}

} // namespace

TEST_CASE("fatigue wants: statements") {
  const Sketch s = sound(kUniform + "parameter depth 2\nwant fatigue swt b.e+n 3 % fatigue findley b 0.5 0.5 0.5 0.25 2 %\n"
                                    "want fatigue dang-van b.e depth 0.1 fatigue crossland b.e mean 0.2 4 % hoop b.n\n"
                                    "want fatigue crack b.e depth {depth/8}\n");
  REQUIRE(s.wants.size() == 7);
  CHECK((s.wants[0].side->has("n") && s.wants[0].tolerance == 0.03));
  CHECK((s.wants[1].fatigue.place == FatiguePlace::kPoint && s.wants[2].where.y == 0.25 && s.wants[2].tolerance == 0.02));
  CHECK((s.wants[3].fatigue.kind == FatigueKind::kDangVan && s.wants[3].fatigue.depth == 0.1 && !s.wants[3].tolerance));
  CHECK((s.wants[4].fatigue.place == FatiguePlace::kMean && s.wants[4].tolerance == 0.04 && s.wants[5].word == "hoop"));
  CHECK((s.wants[6].fatigue.kind == FatigueKind::kCrack && s.wants[6].fatigue.depth == 0.25));
  const FatigueConstants& c = s.bodies[0].fatigue;
  CHECK((c.fatemi_socie == 0.5 && c.yield == 2 && c.findley == 0.3 && c.crossland == 0.4 && c.dang_van == 0.25));
  CHECK(s.points.empty());
}

TEST_CASE("fatigue wants: mistakes have a line and a column") {
  const auto with = [](const std::string& want) { return kUniform + "want fatigue " + want + "\n"; };
  tells(with("smith b.e"), "13:14 'smith': expected swt, fatemi-socie, findley, crossland, dang-van, ruiz1, ruiz2 or crack");
  tells(with("swt"), "13:17 the statement ends here");
  tells(with("swt b.top"), "'top', expected 's', 'e', 'n' or 'w'");
  tells(with("swt b 2 0.5"), "is not inside body 'b'");
  tells(with("swt b.e depth 0"), "expected a depth below the surface");
  tells(with("swt b.e depth"), "expected a depth below the surface");
  tells(with("crack b.e"), "13:23 the statement ends here, expected depth and the length of the crack");
  tells(with("swt b.e 2"), "expected a tolerance above 0");
  tells(with("ruiz1 b.e"), "13:1 the sketch has no contact");
  const std::string bare = square("\n", "1");
  const std::string back = "history pull 1, -1, 1\nwant fatigue ";
  tells(bare + back + "findley b.e\n",
        "13:22 body 'b' has no fatigue constant 'findley', expected it in the statement of the body: "
        "fatigue findley 0.3");
  tells(bare + back + "crossland b 0.5 0.5\n", "13:24 body 'b' has no fatigue constant 'crossland'");
  tells(bare + back + "dang-van b.e\n", "has no fatigue constant 'dang-van'");
  tells(bare + back + "fatemi-socie b.e\n", "has no fatigue constant 'fatemi-socie'");
  tells(square(" fatigue fatemi-socie 1\n", "1") + back + "fatemi-socie b.e\n", "has no fatigue constant 'yield'");
  CHECK(sound(bare + back + "swt b.e\n").wants.size() == 1); // E and nu are enough
  tells(bare + "history pull 1\nwant fatigue swt b.e\n", "13:1 the load history has no cycle");
  tells(square(" fatigue\n", "1"),
        "2:27 the statement ends here, expected fatemi-socie, yield, findley, crossland or dang-van");
  tells(square(" fatigue sines 1\n", "1"), "2:28 'sines': expected fatemi-socie, yield, findley");
  tells(square(" fatigue yield 0\n", "1"), "expected the yield stress");
  tells(square(" fatigue findley -1\n", "1"), "-1: expected a fatigue constant of at least 0");
  tells(std::string(kSquare) + "body r rigid\nfrom 0 1\nline s to 1 1\nline e to 1 2\nline n close\ncontact b.n r.s\nfix b.s\n"
                               "case pull\ndrive r about 0 1 y 0 x 0 turn 0\nhistory pull 1,-1,1\nwant fatigue swt r.s\n",
        "body 'r' is rigid");
}

TEST_CASE("fatigue wants: a bar in tension and compression, on the surface, below it and inside") {
  const Sketch s = sound(kUniform + "want fatigue swt b.e fatigue findley b.e depth 0.1 fatigue crossland b.w mean 0.3\n"
                                    "want fatigue dang-van b 0.5 0.25 fatigue fatemi-socie b.e\n");
  const std::vector<app::Stated> values = values_on(s);
  REQUIRE(values.size() == 5);
  const double c = (std::sqrt(17.0) - 3) / 4;
  const double expected[] = {0.1, (std::sqrt(1.09) + 0.3) / 2, 1 / std::sqrt(3.0) + 0.4 / 3, 0.5 + 0.25 / 3, 0};
  const char* const names[] = {"SWT of e", "Findley of e at depth 0.1", "Crossland of w, mean to depth 0.3", "Dang Van",
                               "Fatemi-Socie of e"};
  for (size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(values[i].name() == names[i]);
    CHECK(values[i].body == 1);
    if (i < 4) CHECK(values[i].value == doctest::Approx(expected[i]).epsilon(1e-8));
  }
  // dg/2 (1 + s/4): (1.3 / 10) sin p (1 + (1 + cos p)/8)
  double most = 0;
  for (double p = 0; p < 3.14; p += 1e-4) most = std::max(most, 0.13 * std::sin(p) * (1 + (1 + std::cos(p)) / 8));
  CHECK(values[4].value == doctest::Approx(most).epsilon(1e-7));
  CHECK(std::fabs(std::fabs(values[0].angle) - 90) < 1e-4);
  CHECK(std::isnan(values[2].angle));
  CHECK(values[1].at[0] == doctest::Approx(0.9));
}

TEST_CASE("fatigue wants: a crack in bending, and a depth that is not in the body") {
  // yy = factor (1 - 2 x): the crack at x = 0, of depth 0.1: (1.1215 - 0.2 0.683) sqrt(pi a)
  const Sketch s =
      sound(square("\n", "{1 - 2*x}") + "history pull 1, -1, 1\nwant fatigue crack b.w depth 0.1 fatigue swt b.w\n");
  const std::vector<app::Stated> values = values_on(s, 2);
  REQUIRE(values.size() == 2);
  CHECK(values[0].name() == "crack range of K of w, depth 0.1");
  CHECK(values[0].value == doctest::Approx((1.1215 - 0.2 * 0.683) * std::sqrt(std::acos(-1.0) * 0.1)).epsilon(1e-2));
  CHECK(values[1].value == doctest::Approx(0.1).epsilon(1e-2));
  const Sketch deep = sound(kUniform + "want fatigue swt b.e depth 3\n");
  try {
    values_on(deep);
    FAIL("no fault");
  } catch (const Fault& fault) {
    CHECK(fault.at.line == 13);
    CHECK(fault.text.find("is not inside the body, expected a smaller depth") != std::string::npos);
  }
}

// A square fixed at its foot, with two loads that go round; turned by a right angle, or mirrored first.
TEST_CASE("fatigue wants: turning and mirroring the sketch change nothing but the place and the plane") {
  const auto values = [](double quarters, bool mirrored) {
    const auto pair = [&](const char* before, double x, double y, const char* between) {
      char text[120];
      const double m = mirrored ? -x : x, c = 1 - quarters, n = quarters; // the mesh depends on other angles
      std::snprintf(text, sizeof text, "%s%.17g%s%.17g", before, c * m - n * y, between, n * m + c * y);
      return std::string(text);
    };
    const std::string e = mirrored ? "w" : "e", w = mirrored ? "e" : "w"; // the outline keeps its material on the left
    const double l = mirrored ? 1 : 0, r = 1 - l;
    const Sketch s =
        sound("body b E 10 nu 0.3" + kConstants + pair("from ", l, 0, " ") + pair("\nline s to ", r, 0, " ") +
              pair(("\nline " + e + " to ").c_str(), r, 1, " ") + pair("\nline n to ", l, 1, " ") + "\nline " + w +
              " close\nfix b.s\ncase pull\n" + pair("traction b.n fx ", 0.1, 1, " fy ") + "\ncase push\n" +
              pair("traction b.e fx ", 0.5, 0.2, " fy ") + "\nhistory pull 1; push 1; pull -1; push -1; pull 1; push 1\n" +
              pair("want fatigue swt b ", 0.3, 0.6, " ") + pair("\nwant fatigue fatemi-socie b ", 0.3, 0.6, " ") +
              pair("\nwant fatigue findley b ", 0.3, 0.6, " ") + pair("\nwant fatigue dang-van b ", 0.3, 0.6, " ") +
              pair("\nwant fatigue crossland b ", 0.3, 0.6, " ") + "\nwant fatigue swt b.n depth 0.3\n");
    return values_on(s);
  };
  const std::vector<app::Stated> first = values(0, false);
  REQUIRE(first.size() == 6);
  for (const bool mirrored : {false, true}) {
    const std::vector<app::Stated> second = values(1, mirrored);
    REQUIRE(second.size() == 6);
    for (size_t i = 0; i < 6; ++i) {
      CAPTURE(i);
      CAPTURE(mirrored);
      CHECK(first[i].value > 0);
      CHECK(std::fabs(second[i].value / first[i].value - 1) < 1e-9);
    }
    const double turn = 90, own = (mirrored ? -1 : 1) * first[0].angle;
    CHECK(std::fabs(std::remainder(second[0].angle - own - turn, 180)) < 1e-4);
  }
}

namespace {

// A crowned block pressed on a flat one, P constant and Q between +- mu P / 2: the lower one fixed, the upper one moved to and
// fro. The example of half planes has R = 6 and E = 200e3; with a hundred times both the pressure is the same, and slip and
// slopes, which half planes do not see, are a hundredth.
const char kCattaneo[] = R"c2s(parameter R 600 P 120 mu 0.6 c 0.7 W 400 H 400
parameter f {R - sqrt(R^2 - c^2)} g {f + (W - c)*c/sqrt(R^2 - c^2)}
body block E 20e6 nu 0.3 fatigue fatemi-socie 1 yield 400 findley 0.3 crossland 0.3
  from -W -H
  line bottom to W -H
  line right to W 0
  line top to -W 0
  line left close
body pad E 20e6 nu 0.3
  from -W g
  line flank to -c f
  arc tip to c f radius R
  line flank to W g
  line right to W H
  line top to -W H
  line left close
contact block.top pad.tip mu mu
case normal
  fix block.bottom
  platen pad.top about 0 0 fx 0 fy -P turn 0
case shear
  platen pad.top about 0 0 fx {0.5*mu*P} fy 0
history normal 1; shear 1, -1, 1
)c2s";

} // namespace

namespace {

// What the program finds, by name.
test::Json run_wants(const test::Folder& folder, const std::string& wants, int status) {
  test::write_file(folder / "a.c2s", kCattaneo + wants);
  const test::Result run =
      test::run_shell("'" + paths::program() + "' run '" + (folder / "a.c2s") + "' --listing '" + (folder / "l") +
                      "' --summary '" + (folder / "s") + "' --json '" + (folder / "j") + "'");
  REQUIRE_MESSAGE(run.status == status, run.err);
  return test::JsonReader::read(test::read_file(folder / "j"));
}

} // namespace

// Half planes: SWT 2.29183 / 100 at the edges +-0.091336.
TEST_CASE("fatigue wants: the edge of the Cattaneo contact by the program") {
  const test::Folder folder;
  const test::Json json = run_wants(folder, "steps 1\nwant fatigue swt block.top 30 %\n", 0);
  bool seen = false;
  for (const test::Json& number : json["accuracy"]["stated"].items) {
    if (number["name"].text != "SWT of top") continue;
    seen = true;
    CHECK(std::fabs(number["value"].number / 0.0229183 - 1) < 0.05);
    CHECK(number["met"].number == 1);
    CHECK(std::fabs(std::fabs(number["x"].number) - 0.0913) < 1e-3);
    CHECK(std::fabs(number["plane_angle"].number) < 3);
  }
  CHECK(seen);
  CHECK(test::contains(test::read_file(folder / "s"), ",block,SWT of top,,"));
  CHECK(test::contains(test::read_file(folder / "l"), "   plane "));
}

TEST_CASE("fatigue wants: the table and the picture of the page") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", kUniform + "want fatigue swt b.e+n  fatigue findley b.w depth 0.1\n");
  const test::Result run = test::run_shell("'" + paths::program() + "' run -q '" + (folder / "a.c2s") + "' --report '" +
                                           (folder / "r.html") + "' --figures '" + (folder / "p") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::string page = test::read_file(folder / "r.html"), picture = test::read_file(folder / "p/fatigue.svg");
  CHECK(test::contains(page, "<h2>Fatigue, last cycle</h2>"));
  CHECK(test::contains(page, "<tr><td><a href=\"#term-SWT\">SWT</a> of e</td><td>body 1 (b)</td><td>0.1</td>"));
  CHECK(test::contains(page, "<tr><td><a href=\"#term-Findley\">Findley</a> of w at depth 0.1</td>"));
  for (const char* term : {"SWT", "Findley"}) // links that lead somewhere, without a contact too
    CHECK(test::contains(page, std::string("<dt id=\"term-") + term + "\">"));
  CHECK(test::contains(picture, "distance along e"));
  CHECK(test::contains(picture, "SWT, body 1 (b)"));
  CHECK_FALSE(test::contains(picture, "Findley"));
}

// Figures of half planes.
TEST_CASE("fatigue wants: all numbers of the Cattaneo contact to one percent") {
  const test::Folder folder;
  const std::string wants = "parameter x -0.0913361\n"
                            "want fatigue swt block x -0.002  x -0.005  x -0.010  x -0.025\n"
                            "want fatigue fatemi-socie block x -0.002  x -0.005  x -0.010  x -0.025\n"
                            "want fatigue findley block x -0.002  x -0.005  x -0.010  x -0.025\n"
                            "want fatigue crossland block x -0.002  x -0.005  x -0.010  x -0.025\n";
  const double depth[] = {0.002, 0.005, 0.010, 0.025};
  const std::map<std::string, std::array<double, 4>> exact = {{"SWT", {0.0090039, 0.0042298, 0.0010279, 0}},
                                                              {"Fatemi-Socie", {5.4146e-5, 3.8217e-5, 2.5482e-5, 1.3662e-5}},
                                                              {"Findley", {330.11, 257.87, 188.00, 92.54}},
                                                              {"Crossland", {311.70, 242.30, 175.60, 80.82}}};
  int seen = 0;
  for (const std::string& some : {std::string("want fatigue swt block.top\nwant fatigue crossland block.top\n"), wants}) {
    const test::Json json = run_wants(folder, "tolerance 1 %\n" + some, 0);
    for (const test::Json& number : json["accuracy"]["stated"].items) {
      const std::string name = number["name"].text;
      const bool surface = name == "SWT of top" || name == "Crossland of top";
      if (!surface && exact.count(name) == 0) continue;
      ++seen;
      const double value = number["value"].number;
      CAPTURE(name);
      CAPTURE(value);
      CHECK(number["met"].number == 1);
      double right = name == "SWT of top" ? 0.0229183 : 456.462, size = right;
      for (size_t i = 0; i < 4 && !surface; ++i)
        if (std::fabs(number["y"].number + depth[i]) < 1e-9) right = exact.at(name)[i], size = right > 0 ? right : 1e-2;
      CHECK(std::fabs(value - right) <= 0.01 * size);
    }
  }
  CHECK(seen == 18);
}

// Half planes: 0.550 for SWT at the edge. Here the contact moves with the pad, by 1 % of its width, and the trailing edge of
// one turn is within the contact at the other.
TEST_CASE("fatigue wants: the pad of the examples") {
  const test::Folder folder;
  const test::Result run = test::run_shell("'" + paths::program() + "' run '" + paths::root() +
                                           "/examples/fretting_fatigue.c2s' -q --json '" + (folder / "j") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const test::Json json = test::JsonReader::read(test::read_file(folder / "j"));
  std::map<std::string, double> values;
  for (const test::Json& number : json["accuracy"]["stated"].items)
    if (number["name"].text != "tractions") values[number["name"].text] = number["value"].number;
  CHECK(std::fabs(values["SWT of top"] / 0.550 - 1) < 0.07);
  CHECK(values["SWT of top at depth 0.015"] < 0.4 * values["SWT of top"]);
  CHECK(values["Ruiz F1 of top"] > 0);
  CHECK(values["crack range of K of top, depth 0.1"] > 0);
}

TEST_CASE("fatigue wants: a kept loop keeps the plane") {
  app::MeshLoop loop, back;
  loop.stated.emplace_back();
  loop.stated[0].what = app::Measure::kSwt, loop.stated[0].angle = 30.25, loop.stated[0].value = 1.0 / 3;
  loop.fatigue.push_back({app::Measure::kFindley, 2, "top", {{1.5, 1.0 / 7}}});
  REQUIRE(estimate::read_meshes(estimate::text_of(loop), back));
  CHECK((back.fatigue.size() == 1 && back.fatigue[0].what == app::Measure::kFindley && back.fatigue[0].body == 2));
  CHECK((back.fatigue[0].along == "top" && back.fatigue[0].points[0][1] == 1.0 / 7));
  CHECK((back.stated[0].angle == 30.25 && back.stated[0].value == 1.0 / 3 && back.stated[0].what == app::Measure::kSwt));
}
