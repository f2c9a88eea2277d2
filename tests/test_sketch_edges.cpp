// Sketches: what each statement expects where a word of it is missing, given twice or out of its range, and shapes at the ends
// of what they may be.
#include "sketches.hpp"

#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

const std::string kBegun = "body b E 1 nu 0\nfrom 0 0\n";     // 2 lines
const std::string kHeld = std::string(kSquare) + "fix b.s\n"; // 7 lines

struct Case {
  const char *text, *told;
};

void tell_all(const std::string& before, std::initializer_list<Case> cases) {
  for (const Case& c : cases) {
    CAPTURE(c.text);
    tells(before + c.text, c.told);
  }
}

} // namespace

TEST_CASE("sketch: curves whose words are missing, or that cannot be") {
  tell_all(kBegun,
           {{"arc centre 0 1 90\n", "expected turn and an angle in degrees"},
            {"arc centre 0 1 turn 0\n", "this arc has length zero"},
            {"arc to 1 0 centre 0.7 0\n",
             "the centre has the distance 0.7 from the start of the arc and 0.3 from its end, expected equal distances"},
            {"arc to 1 0 2\n", "expected radius, through or centre"},
            {"circle radius 1\n", "expected centre x y radius r"},
            {"circle centre 0 0 1\n", "expected radius r"},
            {"ellipse axes 1 2\n", "expected centre x y axes a b"},
            {"ellipse centre 0 0 1 2\n", "expected axes a b"},
            {"ellipse centre 0 0 axes 1 2 from 0 90\n", "expected turn and an angle in degrees"},
            {"curve t 0 1 y t\n", "expected x and its formula"},
            {"curve t 0 1 x t t\n", "expected y and its formula"},
            {"curve t 0 1 x t y 1/(t-0.5)\n", "the formulas have no finite value at t = 0.5"},
            {"curve t 0 1 x 1/(t-1) y t\n", "the formulas have no finite value at t = 1"},
            {"spline a\n", "expected through x y x y ..., or file NAME"},
            {"spline through 0 0 1 1\n", "point 2 of the spline repeats the one before it"},
            {"spline through 1 0 2 0 closed\n", "expected at least three"},
            {"fillet radius 1\n", "'fillet' has no curve directly before it"},
            {"line to 1 0\nfillet\n", "expected radius and a value"},
            {"line to 1 0\nchamfer\n", "expected cut and a value"},
            {"line to 1 0\nchamfer cut 0.1\nfillet radius 0.1\n", "'fillet' has no curve directly before it"},
            {"line to 1 0\nfillet radius 0.1\nline to 2 0\n", "the two curves join smoothly, expected a corner"},
            {"line to 1 0\nchamfer cut 3\nline to 1 1\n", "does not fit"},
            {"line to 1 0\nchamfer cut 0.5\nline to 1 0.4\n", "does not fit"},
            {"mirror x 1\n", "expected curves before 'mirror'"}});
  tell_all("body b E 1 nu 0\n", {{"spline through 1 0\n", "expected at least two"},
                                 {"arc centre 0 1 turn 90\n", "this arc has no start point"},
                                 {"arc to 1 0 radius 2\n", "this curve has no start point"}});
  tell_all(kHeld, {{"copy c b\n", "expected of and the name of a body"}});
}

TEST_CASE("sketch: parts of curves whose words are missing, or that cannot be") {
  tell_all(kBegun + "line s to 1 0\nline e to 1 1\nline s to 0 1\nline w close\n",
           {{"part p s from start to end\n", "expected of and the name of a curve"},
            {"part p of e start to end\n", "expected from and where the part begins"},
            {"part p of e from start end\n", "expected to and where the part ends"},
            {"part p of s from start to end\n", "several curves are called 's', expected a name of one curve"},
            {"part p of e from -0.5 to end\n", "the length -0.5 is not on the curve, expected a length from 0 to 1"},
            {"part p of e from start to 1.5\n", "the length 1.5 is not on the curve, expected a length from 0 to 1"},
            {"part p of e from end to start\n", "the end of the part is not after its start"},
            {"part p of e from start to start\n", "the end of the part is not after its start"},
            {"part p of e from y 2 to end\n", "y = 2"}});
  tells("body b E 1 nu 0\ncircle c centre 0 0 radius 1\npart p of c from end to end\n",
        "the end of the part is not after its start");
}

TEST_CASE("sketch: conditions and loads that are given twice, or not at all") {
  tell_all(kHeld, {{"contact b.e b.w mu -1\n", "-1: expected a coefficient of friction, 0 or above"},
                   {"fix \"b.e\"\n", "expected a body, a dot and curves of the body"},
                   {"fix b.none\n", "expected 's', 'e', 'n' or 'w'"},
                   {"move b.n x 1 x 2\n", "x is given twice"},
                   {"move b.n y 1 y 2\n", "y is given twice"},
                   {"traction b.n x 1 x 2\n", "x is given twice"},
                   {"traction b.n y 1 y 2\n", "y is given twice"},
                   {"force b 0 1 x 1\n", "expected at x y, then fx and fy"},
                   {"weight b y -1\nweight b y -1\n", "the weight of the body in this load case is given twice"},
                   {"weight b x -1\nweight b x -1\n", "the weight of the body in this load case is given twice"},
                   {"symmetry x 0\n", "the line of symmetry stands after a body, expected it before the first body"}});
  tells("symmetry x 0\nsymmetry x 1\n" + kHeld, "the line of symmetry x is given twice");
  tells("symmetry y 0\nsymmetry y 1\n" + kHeld, "the line of symmetry y is given twice");
  tells("units sixteenlettersss N\n" + kHeld, "expected at most 15 characters");
  tells("parameter deg 2\n" + kHeld, "'deg' is reserved");
  std::string many = kBegun;
  for (int i = 1; i <= 9; ++i) many += "line c" + std::to_string(i) + " to " + std::to_string(i) + " 0\n";
  tells(many + "line up to 9 1\nline close\nfix b.none\n", "'c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'c7', 'c8', ...");
  // A part of the boundary alone, of a curve whose name two have.
  tells(kBegun + "line s to 1 0\nline s to 1 1\nline close\nfix b.s.start\n",
        "several curves are named, expected a single one");
}

TEST_CASE("sketch: friction without end, load cases that are named later, weights of two cases") {
  const std::string two = kHeld + "copy c of b shift 0 1\n";
  const Reading rough = read(two + "contact b.n c.s mu inf\npressure c.n 1\n");
  REQUIRE(rough.faults.empty());
  CHECK(rough.sketch.interfaces.at(0).friction == HUGE_VAL);
  // One that is named again goes on; forces before the first name are a case of their own.
  const Reading again = read(kHeld + "case pull\npressure b.n -1\ncase push\npressure b.n 2\ncase pull\ntraction b.e x 1\n"
                                     "history pull 1; push 2\n");
  REQUIRE(again.faults.empty());
  CHECK(again.sketch.cases.size() == 2);
  CHECK(again.sketch.conditions.back().load_case == 0);
  for (const char* first : {"force b at 0.5 1 y -1\n", "weight b y -1\n", "pressure b.n 1\n", "move b.n x 1\n"}) {
    CAPTURE(first);
    CHECK(read(kHeld + first + "case later\ntraction b.e x 1\nhistory later 1\n").sketch.cases.size() == 2);
  }
  const Reading weights = read(kHeld + "case a\nweight b y -1\ncase b\nweight b x -1\nhistory a 1; b 1;\n");
  REQUIRE(weights.faults.empty());
  CHECK(weights.sketch.body_forces.size() == 2);
}

TEST_CASE("sketch: arcs to the right and long ones, splines that are turned round, curves of formulas") {
  const auto area_of = [](const std::string& text) {
    const Reading r = read(text);
    REQUIRE_MESSAGE(r.faults.empty(), fault(text));
    double twice = 0;
    for (const Outline& outline : r.sketch.bodies.at(0).outlines)
      for (const Curve& curve : outline.curves)
        for (int i = 0; i < 256; ++i) twice += cross(curve.shape->at(i / 256.0), curve.shape->at((i + 1) / 256.0));
    return twice / 2;
  };
  const double half_disc = std::acos(-1.0) / 2;
  CHECK(area_of("body b E 1 nu 0\nfrom -1 0\nline s to 1 0\narc to -1 0 radius 1\nfix b.s\n") > 0);
  CHECK(area_of(kBegun + "line s to 2 0\narc to 0 0 radius 1\nfix b.s\n") == doctest::Approx(half_disc).epsilon(1e-3));
  CHECK(area_of(kBegun + "line s to 2 0\nline to 2 2\narc to 0 2 radius 1 right\nline close\nfix b.s\n") ==
        doctest::Approx(4 - half_disc).epsilon(1e-3));
  const double long_one = area_of(kBegun + "line s to 1 0\narc to 0 0 radius 1 long\nfix b.s\n");
  CHECK(long_one == doctest::Approx(2 * half_disc * 5 / 6 + std::sqrt(3) / 4).epsilon(1e-3));
  CHECK(area_of("body b E 1 nu 0\nspline s through 0 0 0 1 1 1 1 0 0 0 closed reversed\nfix b.s\n") > 1);
  CHECK(area_of(kBegun + "spline s through 1 0.1 2 0\nline to 2 2\nline to 0 2\nline close\nfix b.s\n") < 4);
  CHECK(area_of(kBegun + "line s to 1 0\ncurve t 0 1 x=1-t y=t*(1-t)\nfix b.s\n") == doctest::Approx(1.0 / 6).epsilon(1e-3));
  CHECK(area_of(kBegun + "line s to 1 0\nline to 1 1\nchamfer cut 0.5\nline to 0 1\nline close\nfix b.s\n") ==
        doctest::Approx(0.875));
  // A corner between the last curve and the first, turned about a point, seen in mirrors.
  CHECK(area_of(kBegun + "line s to 1 0\nline to 1 1\nline to 0 1\nline close\nchamfer cut 0.5\nfix b.s\n") ==
        doctest::Approx(0.875));
  CHECK(read(kHeld + "copy c of b turn 90 about 3 0 mirror y 5\nfix c.s\n").faults.empty());
}

TEST_CASE("sketch: words in tabs, quotes, brackets and carriage returns") {
  CHECK(read("body\tb\tE 1, nu=0\r\nfrom 0 0\r\nline s to (1 + 0) 0 ! to the right\r\nline to 1 1\nline to 0 1\nline "
             "close\nfix b.s\n")
            .faults.empty());
  tells("body b E (1 nu 0\n", "the bracket '(' is not closed");
  tells("body b E 1) nu 0\n", "the bracket ')' has no matching opening bracket");
  tells("body b E (1} nu 0\n", "the bracket '}' has no matching opening bracket");
  tells("body b\"c E 1 nu 0\n", "the quote is not closed");
  tells("body b E 1 nu \"0\"\n", "expected");
  tells("body b E .5 nu (0\n", "the bracket '(' is not closed");
  CHECK(read("parameter a_1 2\nbody b E .5 nu 0\nfrom 0 0\nline s to +1 0\nline to a_1-1 sqrt(1)\nline to 0 1\nline close\nfix "
             "b.s\n")
            .faults.empty());
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 sqrt(1\nline close\n", "is not closed");
  tells("parameter a 1e999\n" + kHeld, "expected a number in the range of double precision");
  tells("\"body\" b E 1 nu 0\n", "expected a statement");
}
