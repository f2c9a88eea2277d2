// What statements of sketches mean: in what is read, in the deck, and solved.
#include "memory/config.hpp"
#include "problem.hpp"
#include "sketches.hpp"

#include <algorithm>
#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

const double kPi = std::acos(-1.0);

bool contains_card(const std::string& deck, const std::string& card) {
  const size_t at = deck.find("\n" + card);
  return at != std::string::npos && (deck[at + 1 + card.size()] == '\n' || deck[at + 1 + card.size()] == ' ');
}
bool has_cards(const std::string& deck, const std::string& cards) {
  return deck.find("\n" + cards + "\n") != std::string::npos;
}
int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

problem::Result solved(const std::string& text, double fineness = 1) {
  const problem::Result r = problem::solve_text(deck(text, fineness), {});
  REQUIRE(r.status == C2D_OK);
  REQUIRE(r.outcome == C2D_REACHED);
  return r;
}

std::vector<std::string> names_of(const Sketch& s, size_t body = 0) {
  std::vector<std::string> out;
  for (const Outline& outline : s.bodies[body].outlines)
    for (const Curve& curve : outline.curves) out.push_back(curve.name);
  return out;
}
const Curve& curve_of(const Sketch& s, const std::string& name) {
  for (const Outline& outline : s.bodies[0].outlines)
    for (const Curve& curve : outline.curves)
      if (curve.name == name) return curve;
  FAIL("no curve " << name);
  return s.bodies[0].outlines[0].curves[0];
}
double length_of(const Sketch& s, const std::string& name) { // of all curves with the name
  double sum = 0;
  for (const Outline& outline : s.bodies[0].outlines)
    for (const Curve& curve : outline.curves) sum += curve.name == name ? Measure(curve.shape).length() : 0;
  return sum;
}
bool at(Point p, double x, double y) { return length(p - Point{x, y}) < 1e-12; }

} // namespace

TEST_CASE("sketch: a title stands as it was written") {
  CHECK(sound("title  Pad, R = 5 (new; \"best\" ! of all\n" + std::string(kSquare)).title == "Pad, R = 5 (new; \"best\"");
  CHECK(sound("title \"Pad ! no comment\"\n" + std::string(kSquare)).title == "Pad ! no comment");
  CHECK(sound("title\n" + std::string(kSquare)).title.empty());
  CHECK(has_cards(deck("title a, b = {c\n" + std::string(kSquare) + "fix b.s\n"), "a, b = {c"));
}

TEST_CASE("sketch: a file that ends in .c2s is a sketch, whatever stands in it") {
  CHECK(is_sketch("body b"));
  CHECK_FALSE(is_sketch("boddy b"));
  CHECK(is_sketch("boddy b", "a.c2s"));
  CHECK_FALSE(is_sketch("*FREE", "a.dat"));
}

TEST_CASE("sketch: a parameter that is given from outside changes those that depend on it") {
  const std::string text = "parameter a 2\nparameter b 3*a c a+b\n" + std::string(kSquare);
  CHECK(sound(text).parameters == Parameters{{"a", 2}, {"b", 6}, {"c", 8}});
  CHECK(sound(text, {{"a", 5}}).parameters == Parameters{{"a", 5}, {"b", 15}, {"c", 20}});
  CHECK(sound(text, {{"b", 1}}).parameters == Parameters{{"a", 2}, {"b", 1}, {"c", 3}});
  CHECK(read("parameter b 3*a\nparameter a 2\n", {{"a", 1}}).faults.size() == 1); // a has no value there
}

TEST_CASE("sketch: histories go on in further statements, with cases that come later") {
  const std::string held = std::string(kSquare) + "fix b.s\ncase one\ntraction b.n y 1\nhistory one 1, 2\n";
  const Sketch s = sound(held + "case two\ntraction b.e x 1\nhistory two 1; one 0\n");
  REQUIRE(s.cases.size() == 2); // supports before the first case are in it
  CHECK(s.pieces == 4);
  CHECK(s.cases[0].factors == std::vector<double>{1, 2, 2, 0});
  CHECK(s.cases[1].factors == std::vector<double>{0, 0, 1, 1});
  CHECK(has_cards(deck("steps 7\n" + held + "case two\nhistory two 3\n"), "*PATH\n7 1\n7 2\n7 2"));
  CHECK(has_cards(deck(std::string(kSquare) + "fix b.s\n"), "*PATH\n10 1"));
}

TEST_CASE("sketch: bodies of revolution" * doctest::skip(!c2d::kRings)) {
  const std::string text = "axisymmetric\nbody b E 1000 nu 0.3\nfrom 0 0\nline s to 2 0\nline e to 2 1\nline n to 0 1\n"
                           "fix b.s y\ntraction b.n y 100\n";
  CHECK(has_cards(deck(text), "2 2"));
  CHECK(count(deck(text), "*SYMMETRY") == 0);
  CHECK(count(deck("symmetry y 5\n" + text), "*SYMMETRY Y") == 1);
  const problem::Result r = solved(text);
  double worst = 0;
  for (const problem::EndResult& end : r.boundary[0])
    worst = std::max({worst, std::fabs(end.uy - 0.1 * end.y), std::fabs(end.ux + 0.03 * end.x)});
  CHECK(worst < 1e-10);
}

TEST_CASE("sketch: weight and rotation of a body are one card") {
  const std::string text = deck(std::string(kSquare) + "fix b.s\nweight b y -2\nspin b 3 about 1 0\n");
  CHECK(has_cards(text, "*BODY FORCE 1 1 0 -2 3 1 0"));
  CHECK(count(text, "*BODY FORCE") == 1);
}

TEST_CASE("sketch: names of cases and interfaces, loads of further cases and adhesion stand in the deck") {
  const std::string text =
      deck(std::string(kSquare) + "fix b.s\ncopy c of b shift 0 1\ncontact b.n c.s mu inf name joint\ncase one\n"
                                  "traction c.n y -1\ncase side\nforce c at 0.5 1.5 x 2\nhistory one 1; side 1\n");
  CHECK(contains_card(text, "case 2 ! side"));
  CHECK(contains_card(text, "load 2 0.5 1.5 2 0"));
  CHECK(contains_card(text, "*NAME ZONE 1 joint"));
  CHECK(contains_card(text, "1 INF"));
  const std::string idle = deck(std::string(kSquare) + "fix b.s\ntraction b.n y 1\ncase two\nfix b.e x\n");
  CHECK(idle.find("*CASES") == std::string::npos); // a case that loads nothing is in no deck
  CHECK(contains_card(idle, "*PATH\n10 1"));
}

TEST_CASE("sketch: motions and loads of a rigid body in several cases are one set of cards") {
  const std::string text = deck(std::string(kSquare) +
                                "fix b.s\nbody r rigid\nfrom 0 1\nline f to 1 1\nline g to 1 2\nline h to 0 2\nline i close\n"
                                "contact b.n r.f mu 0.3\ncase one\ndrive r about 0.5 2 y -0.01\ncase two\ndrive r turn 0.001\n"
                                "case three\ndrive r fx 2\nhistory one 1; two 1; three 1\n");
  CHECK(contains_card(text, "*RIGID 2"));
  CHECK(contains_card(text, "1 0 -0.01 0 0.5 2"));
  CHECK(contains_card(text, "2 0 0 0.001 0.5 2"));
  CHECK(contains_card(text, "*RIGID LOAD 2 0.5 2 X"));
  CHECK(contains_card(text, "3 2 0 0"));
}

TEST_CASE("sketch: a platen keeps its point in all load cases") {
  const Sketch s =
      sound(std::string(kSquare) + "fix b.s\ncase one\nplaten b.n about 0 2 fy 1 turn 0\ncase two\nplaten b.n fx 1\n"
                                   "history one 1; two 1\n");
  REQUIRE(s.drives.size() == 2);
  CHECK(at(s.drives[1].about, 0, 2));
}

TEST_CASE("sketch: what is wanted") {
  const std::string two = std::string(kSquare) + "fix b.s\ncopy c of b shift 0 1\ncontact b.n c.s\n";
  const Sketch s = sound("parameter edges 0.25\ntolerance 0.5%\nlimit seconds 60 elements 5000\n" + two +
                         "want pressure 1 %  edges 0.02 forces approach 2% dissipation\nwant hoop c.n+e 3 %\n"
                         "want stress b 0.5 edges 0.5 0.75 1 %\nwant stress at c 0.5 1.5 0.1 edges\nwant stress c 0.5 1.25\n");
  CHECK(s.tolerance == doctest::Approx(0.005));
  CHECK((s.most_seconds == 60 && s.most_elements == 5000 && s.most_work == 1e13 && s.adapts && s.chooses_order));
  CHECK(sound("limit work 2e14\n" + two).most_work == 2e14);
  CHECK_FALSE(sound("functions linear\n" + two).chooses_order);
  const char* const words[] = {"pressure", "edges",  "forces", "approach", "dissipation", "hoop",
                               "stress",   "stress", "stress", "edges",    "stress"};
  const double tolerances[] = {0.01, 0.02, 0, 0.02, 0, 0.03, 0.01, 0.01, 0.1, 0, 0}; // 0: none
  REQUIRE(s.wants.size() == 11);
  for (size_t i = 0; i < 11; ++i) {
    CAPTURE(i);
    CHECK(s.wants[i].word == words[i]);
    CHECK(s.wants[i].tolerance.value_or(0) == doctest::Approx(tolerances[i]));
  }
  CHECK((s.wants[5].body == 1 && s.wants[5].side->has("e")));
  REQUIRE(s.points.size() == 4);
  CHECK((s.points[0].body == 0 && at(s.points[0].at, 0.5, 0.25) && at(s.wants[6].where, 0.5, 0.25)));
  CHECK((s.points[2].body == 1 && at(s.points[2].at, 0.5, 1.5) && at(s.wants[8].where, 0.5, 1.5)));
  CHECK_FALSE(sound("tolerance off\n" + two).adapts);
  CHECK(sound(two).tolerance == 0.01);
}

TEST_CASE("sketch: pressures at places are wanted") {
  const Sketch s = sound(std::string(kSquare) + "fix b.s\ncopy c of b shift 0 1\ncontact b.n c.s\n" +
                         "want pressure at b.n 0.25 1 0.75 1 2 %  forces\nwant pressure at c.s 0.5 1\n");
  REQUIRE(s.wants.size() == 4);
  for (const size_t i : {0u, 1u, 3u}) CHECK((s.wants[i].of == WantOf::kPlaces && s.wants[i].side->names.size() == 1));
  CHECK((at(s.wants[0].where, 0.25, 1) && at(s.wants[1].where, 0.75, 1) && s.wants[1].tolerance == 0.02));
  CHECK((s.wants[3].body == 1 && !s.wants[3].tolerance));
  CHECK(s.points.empty()); // they are not inside
}

TEST_CASE("sketch: parts of lines, arcs, circles and splines") {
  const Sketch line = sound(std::string(kSquare) + "part m of n from x 0.75 to 50 %\npart last of n from x 0.25 to end\n");
  CHECK(names_of(line) == std::vector<std::string>{"s", "e", "n", "m", "n", "last", "w"}); // n runs from x = 1 to 0
  CHECK((at(curve_of(line, "m").shape->at(0), 0.75, 1) && at(curve_of(line, "m").shape->at(1), 0.5, 1)));
  CHECK((at(curve_of(line, "last").shape->at(0), 0.25, 1) && at(curve_of(line, "last").shape->at(1), 0, 1)));
  CHECK(names_of(sound(std::string(kSquare) + "part m of n from start to end\n")) ==
        std::vector<std::string>{"s", "e", "m", "w"});
  // The bottom quarter of a circle that begins there; of a hole, which runs clockwise.
  const double r = std::sqrt(0.5);
  const std::string circle =
      "body b E 1 nu 0\ncircle face centre 0 0 radius 1\npart foot of face from angle -135 to angle -45\n";
  const Sketch round = sound(circle);
  CHECK(names_of(round) == std::vector<std::string>{"foot", "face", "foot"});
  CHECK(at(round.bodies[0].outlines[0].curves[1].shape->at(0), r, -r));
  CHECK(at(round.bodies[0].outlines[0].curves[1].shape->at(1), -r, -r));
  CHECK(area_of(polygon_of(round.bodies[0].outlines[0])) == doctest::Approx(kPi).epsilon(3e-3));
  const Sketch hole = sound("body b E 1 nu 0\ncircle centre 0 0 radius 2\nhole\ncircle face centre 0 0 radius 1\n"
                            "part foot of face from angle -45 to angle 225\n");
  CHECK(length_of(hole, "foot") == doctest::Approx(kPi / 2).epsilon(1e-9));
  CHECK(names_of(sound(circle + "part crown of face from angle 45 to angle 135\n")).size() == 5);
  // Of splines by lengths, on both sides of the begin of a closed one, and by a coordinate.
  const Sketch closed = sound("body b E 1 nu 0\nspline s through 1 0 0 1 -1 0 0 -1 closed\npart m of s from 10 % to 25 %\n"
                              "part k of s from 90% to 0.1\n");
  const double whole = length_of(closed, "s") + length_of(closed, "m") + length_of(closed, "k");
  CHECK(length_of(closed, "m") == doctest::Approx(0.15 * whole).epsilon(1e-9));
  CHECK(length_of(closed, "k") == doctest::Approx(0.1 * whole + 0.1).epsilon(1e-9));
  CHECK(length(curve_of(closed, "m").shape->at(1) - Point{0, 1}) < 1e-9);
  const Sketch open = sound("body b E 1 nu 0\nfrom 0 0\nline to 3 0\nline to 3 1\nspline s through 2 1.2 1 1.2 0 1\n"
                            "line close\npart m of s from x 1.5 to end\n");
  CHECK(curve_of(open, "m").shape->at(0).x == doctest::Approx(1.5).epsilon(1e-12));
  CHECK(at(curve_of(open, "m").shape->at(1), 0, 1));
}

TEST_CASE("sketch: supports at points") {
  // A strip on rollers, held along at one point alone, is strained evenly.
  for (const char* functions : {"linear", "quadratic", "cubic"}) {
    CAPTURE(functions);
    const std::string strip = std::string("functions ") + functions +
                              "\nbody b E 100 nu 0.3\nfrom 0 0\nline foot to 3 0\nline to 3 1\nline top to 0 1\nline close\n"
                              "fix b.foot y\nfix b.foot.start x\ntraction b.top y 2\n";
    double right = 0, left = 1, up = 0;
    const problem::Result r = solved(strip);
    for (const auto& end : r.boundary[0])
      right = std::min(right, end.ux), left = std::min(left, std::fabs(end.ux)), up = std::max(up, end.uy);
    CHECK(right == doctest::Approx(-3 * 1.3 * 0.3 * 2 / 100).epsilon(1e-8));
    CHECK(up == doctest::Approx((1 - 0.09) * 2 / 100).epsilon(1e-8));
    CHECK(left < 1e-12);
  }
  // A disc under pressure all round, held at its lowest point, and along x at its highest: the end of its right half.
  const problem::Result disc =
      solved("body b E 100 nu 0.3\ncircle face centre 0 0 radius 2\npart half of face from 0 % to 50 %\n"
             "fix b.half.start\nfix b.half.end x\npressure b.half+face 3\n",
             4);
  double high = 0;
  for (const auto& end : disc.boundary[0]) high = std::min(high, end.uy);
  CHECK(high == doctest::Approx(-4.0 * 3 / 100 * 1.3 * 0.4).epsilon(2e-3));
}

TEST_CASE("sketch: the bottom third of a whole roller is in contact") {
  const char* text = "parameter R 10 P 20 L 100\nbody flat E 1000 nu 0.3\nfrom -L -L\nline bottom to L -L\nline right to L 0\n"
                     "line top to -L 0\nline left close\nbody roller E 1000 nu 0.3\ncircle face centre 0 R radius R\n"
                     "part foot of face from angle -150 to angle -30\npart crown of face from angle 80 to angle 100\n"
                     "contact flat.top roller.foot\nfix flat.bottom\nplaten roller.crown x 0 turn 0 fy -P\n";
  const double compliance = 2 * (1 - 0.09) / 1000, a = std::sqrt(4 * 20 * 10 * compliance / kPi), p0 = 2 * 20 / (kPi * a);
  const problem::Result r = solved(text, 2);
  double peak = 0;
  for (int i = 0; i < r.steps.back().pairs(); ++i) peak = std::max(peak, r.steps.back().at(i, C2D_TN));
  CHECK(peak == doctest::Approx(p0).epsilon(0.003));
}

TEST_CASE("sketch: a load may be a formula of the place") {
  const std::string held = std::string(kSquare) + "fix b.s\n";
  const std::string text = deck(held + "traction b.e x {2*y} y {1 - x*y}\npressure b.n {3 + x}\n");
  CHECK(text.find(" 0011 2 0 0 0\n") != std::string::npos);  // at the end of the east side, (1, 1)
  CHECK(text.find(" 0011 0 -4 0 0\n") != std::string::npos); // where the north side begins there
  CHECK(text.find(" 0011 0 -3 0 0\n") != std::string::npos); // and where it ends, (0, 1)
  // The same as a number where it does not vary; a parameter called y is that number.
  CHECK(deck(held + "pressure b.n {3 + 0*x}\n") == deck(held + "pressure b.n 3\n"));
  CHECK(deck("parameter y 4\n" + held + "traction b.e x {2*y}\n") == deck(held + "traction b.e x 8\n"));
  tells(held + "pressure b.n {1/x}\n", "8:1 the formula has no finite value at (0, 1) of b.n");
  tells(held + "traction b.e x {sqrt(0.5 - y)} y 1\n", "the formula has no finite value at (1, 0.5");
  tells(held + "traction b.e x {z}\n", "no parameter is called 'z'");
  tells(held + "traction b.e x y 1\n", "'y': expected its value");
  tells(held + "traction b.e x {1/0}\n", "is not a finite number");
  tells(held + "traction b.e x 1 x 2\n", "x is given twice");
  tells(held + "traction b.e\n", "expected fx or fy");
  tells(std::string(kSquare) + "move b.s x {z}\n", "no parameter is called 'z'");
}
