// Sketches: words, arithmetic, curves, what is wrong with them, and the decks made of them.
#include "paths.hpp"
#include "problem.hpp"
#include "sketches.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <sstream>

using namespace sketch;
using namespace sketches;

namespace {

const double kPi = std::acos(-1.0);

double value(const std::string& text, const Parameters& parameters = {}) {
  return Expression(Word{text, {1, 1, static_cast<int>(text.size())}, false}, parameters).value();
}

std::vector<Point> polygon(const std::string& outline) {
  return polygon_of(sound("body b E 1 nu 0\n" + outline).bodies[0].outlines[0]);
}

} // namespace

TEST_CASE("sketch: words and their places") {
  const std::vector<Word> w = words_of("arc  tip=3, {a + 1};\"two words\" ! comment", 7);
  REQUIRE(w.size() == 6);
  CHECK(w[2].text == "3");
  CHECK(w[3].text == "{a + 1}");
  CHECK(w[4].text == ";");
  CHECK((w[5].text == "two words" && w[5].quoted));
  CHECK((w[3].at.line == 7 && w[3].at.column == 13 && w[3].at.end == 19));
  CHECK_THROWS_AS(words_of("a (b", 1), Fault);
  CHECK_THROWS_AS(words_of("a b)", 1), Fault);
  CHECK_THROWS_AS(words_of("a \"b", 1), Fault);
}

TEST_CASE("sketch: arithmetic") {
  CHECK(value("1+2*3^2") == 19);
  CHECK(value("-2^2") == -4);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("(1+2)*(3-5)/4") == -1.5);
  CHECK(value("a*b", {{"a", 3}, {"b", 4}}) == 12);
  CHECK(value("sqrt(9)+max(1,2)+abs(-3)") == 8);
  CHECK(value("sin(30*deg)") == doctest::Approx(0.5).epsilon(1e-15));
  CHECK(value("atan2(1,-1)") == doctest::Approx(0.75 * kPi).epsilon(1e-15));
  CHECK(value("1e3+.5") == 1000.5);
  for (const char* wrong : {"1+", "(1", "2x", "nobody", "sin 1", "max(1)", "1e999", "tanh(1)"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(value(wrong), Fault);
  }
  CHECK_THROWS_AS(value(std::string(5000, '(') + "1" + std::string(5000, ')')), Fault);
}

TEST_CASE("sketch: derivatives of formulas against differences") {
  for (const char* text :
       {"sin(t)*exp(t)", "t^3/(1+t)", "sqrt(t)+log(t)", "atan2(t,2)+asin(t/3)", "acos(t/2)*tan(t)", "2^t", "cos(t)^2"}) {
    const Expression f(Word{text, {}, false}, {}, {"t", ""});
    const double t = 0.7, h = 1e-4;
    const Jet j = f.at(t);
    CAPTURE(text);
    CHECK(j.d == doctest::Approx((f.at(t + h).v - f.at(t - h).v) / (2 * h)).epsilon(1e-6));
    CHECK(j.dd == doctest::Approx((f.at(t + h).v - 2 * j.v + f.at(t - h).v) / (h * h)).epsilon(1e-5));
  }
}

TEST_CASE("sketch: areas of what is drawn") {
  CHECK(area_of(polygon("from 0 0\nline to 2 0\nline by 0 1\nline to 0 1\nline close\n")) == doctest::Approx(2));
  // Half discs in five ways; a polygon of 48 sides and more lacks 1e-3 of it.
  for (const char* way :
       {"arc to -1 0 radius 1", "arc to -1 0 through 0 1", "arc to -1 0 centre 0 0", "arc centre 0 0 turn 180",
        "curve t 0 pi x cos(t) y sin(t)", "ellipse centre 0 0 axes 1 1 from 0 turn 180"}) {
    CAPTURE(way);
    CHECK(area_of(polygon(std::string("from 1 0\n") + way + "\nline close\n")) == doctest::Approx(kPi / 2).epsilon(2e-3));
  }
  CHECK(area_of(polygon("circle centre 3 4 radius 2\n")) == doctest::Approx(4 * kPi).epsilon(3e-3));
  CHECK(area_of(polygon("ellipse centre 3 4 axes 2 1 tilt 30\n")) == doctest::Approx(2 * kPi).epsilon(3e-3));
  CHECK(area_of(polygon("from 1 0\nline to 2 0\nline to 2 1\nline to 1 1\nmirror x 1\n")) == doctest::Approx(2));
  // A fillet takes (1 - pi/4) r^2 off a right corner, a chamfer c^2 / 2.
  const char* square = "from 0 0\nline to 1 0\n%\nline to 1 1\nline to 0 1\nline close\n";
  const auto with = [&](const std::string& corner) {
    std::string text = square;
    return area_of(polygon(text.replace(text.find('%'), 1, corner)));
  };
  CHECK(with("fillet radius 0.2") == doctest::Approx(1 - 0.04 * (1 - kPi / 4)).epsilon(1e-5));
  CHECK(with("chamfer cut 0.2") == doctest::Approx(0.98));
}

TEST_CASE("sketch: a spline goes through its points with continuous curvature") {
  const std::vector<Point> points = {{0, 0}, {1, 0.3}, {2, -0.2}, {3.5, 0.4}};
  const ShapePtr s = spline(points, false);
  double at = 0, whole = 0;
  for (size_t i = 1; i < points.size(); ++i) whole += length(points[i] - points[i - 1]);
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0) at += length(points[i] - points[i - 1]) / whole;
    CHECK(length(s->at(at) - points[i]) < 1e-14);
    if (i > 0 && i + 1 < points.size())
      CHECK(s->curvature(at - 1e-9) == doctest::Approx(s->curvature(at + 1e-9)).epsilon(1e-5));
  }
  // A closed one through points of a circle is the circle, to the fourth order of their distance.
  std::vector<Point> circle;
  for (int i = 0; i < 24; ++i) circle.push_back({std::cos(2 * kPi * i / 24), std::sin(2 * kPi * i / 24)});
  const ShapePtr c = spline(circle, true);
  for (int i = 0; i < 240; ++i) CHECK(std::fabs(length(c->at(i / 240.0)) - 1) < 2e-5);
  CHECK(Measure(c).length() == doctest::Approx(2 * kPi).epsilon(2e-5));
}

TEST_CASE("sketch: lengths along curves") {
  const Measure m(arc({0, 0}, 2, 10, 200));
  CHECK(m.length() == doctest::Approx(2 * 200 * kPi / 180).epsilon(1e-14));
  for (const double u : {0.1, 0.37, 0.9}) CHECK(m.u_at(m.length_to(u)) == doctest::Approx(u).epsilon(1e-12));
  const Measure e(ellipse({0, 0}, 2, 1, 0, 0, 90));
  CHECK(e.length() == doctest::Approx(2.4221120551369190).epsilon(1e-12)); // 2 E(3/4)
}

TEST_CASE("sketch: sides that do not face each other are told") {
  const Reading r = read(std::string(kSquare) + "copy c of b shift 5 0\ncontact b.e c.e\nfix b.w\nfix c.w\n");
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].text ==
        "no part of b.e faces c.e: their outward normals point the same way; their smallest distance is 5 at (1, 0)");
}

namespace {

problem::Result solve_sketch(const std::string& text, double fineness = 1) {
  return problem::solve_text(deck(text, fineness), {});
}

} // namespace

TEST_CASE("sketch: a cylinder on a flat is Hertz's contact") {
  const char* text = "parameter R 10 P 20 L 100\nsymmetry x 0\n"
                     "body flat E 1000 nu 0.3\nfrom 0 -L\nline bottom to L -L\nline right to L 0\nline top to 0 0\n"
                     "body roller E 1000 nu 0.3\nfrom 0 0\narc face to R R centre 0 R\narc back to 0 2*R centre 0 R\n"
                     "contact flat.top roller.face\nfix flat.bottom\npressure roller.back P/(2*R)\n";
  const double compliance = 2 * (1 - 0.09) / 1000, a = std::sqrt(4 * 20 * 10 * compliance / kPi), p0 = 2 * 20 / (kPi * a);
  const problem::Result r = solve_sketch(text, 2);
  REQUIRE(r.status == C2D_OK);
  REQUIRE(r.outcome == C2D_REACHED);
  double peak = 0;
  for (int i = 0; i < r.steps.back().pairs(); ++i) peak = std::max(peak, r.steps.back().at(i, C2D_TN));
  CHECK(peak == doctest::Approx(p0).epsilon(0.002));
}

TEST_CASE("sketch: blocks that are tied and pulled are strained evenly") {
  const char* text = "body low E 100 nu 0\nfrom 0 0\nline foot to 2 0\nline to 2 1\nline joint to 0 1\nline close\n"
                     "body high E 100 nu 0\nfrom 0 1\nline joint to 2 1\nline to 2 3\nline top to 0 3\nline close\n"
                     "tie low.joint high.joint\nfix low.foot\ntraction high.top y 1\nstress high 1 2\n";
  const problem::Result r = solve_sketch(text);
  REQUIRE(r.status == C2D_OK);
  REQUIRE(r.outcome == C2D_REACHED);
  const problem::Step& last = r.steps.back();
  for (int i = 0; i < last.pairs(); ++i) CHECK(last.at(i, C2D_TN) == doctest::Approx(-1).epsilon(1e-9));
}

// Its mesh is symmetric but for the last of eight digits, and far pairs have gaps a thousand times what moves: ends of the
// contact touch one after the other, not at once.
TEST_CASE("sketch: the one of the page is solved") {
  std::ifstream file(paths::root() + "/src/program/sketch/SKETCH.md");
  std::ostringstream page;
  page << file.rdbuf();
  const std::string text = page.str();
  const size_t begin = text.find("```\n") + 4, end = text.find("```", begin);
  REQUIRE(end != std::string::npos);
  const problem::Result r = solve_sketch(text.substr(begin, end - begin), 2);
  REQUIRE(r.status == C2D_OK);
  CHECK(r.outcome == C2D_REACHED);
  double p = 0; // the force of the platen, 208, is the sum of the pressure
  const problem::Step& last = r.steps.back();
  for (int i = 0; i < last.pairs(); ++i) p = std::max(p, last.at(i, C2D_TN));
  const double compliance = 2 * (1 - 0.32 * 0.32) / 120e3, a = std::sqrt(4 * 208 * 50 * compliance / kPi);
  CHECK(p == doctest::Approx(2 * 208 / (kPi * a)).epsilon(0.02)); // Hertz: friction and the finite bodies change little
}

TEST_CASE("sketch: rings all round, drawn from anywhere: an even pressure") {
  const auto pressure = [](const std::string& mouth) {
    const problem::Result r =
        solve_sketch("body inner E 200 nu 0.3\ncircle face centre 0 0 radius 10\nhole\ncircle bore centre 0 0 radius 5\n"
                     "body outer E 200 nu 0.3\ncircle out centre 0 0 radius 20\nhole\n" +
                     mouth + "contact outer.mouth inner.face\nfix inner.bore\npressure outer.out 1\n");
    REQUIRE(r.status == C2D_OK);
    REQUIRE(r.outcome == C2D_REACHED);
    const problem::Step& last = r.steps.back();
    CHECK(last.pairs() > 20);
    for (int i = 1; i < last.pairs(); ++i) CHECK(last.at(i, C2D_TN) == doctest::Approx(last.at(0, C2D_TN)).epsilon(1e-3));
    return last.at(0, C2D_TN);
  };
  // Rings of Lame, plane strain: radial motions agree where they meet, and none where the inner one is held.
  const double k = 1 - 2 * 0.3, a = 5, b = 10, c = 20;             // u = A r + B / r, p = 2 G (-A / k + B / r^2)
  const double held = (b - a * a / b) / (1 / k + a * a / (b * b)); // u(b) 2G / -p of the inner one
  const double out = c * c / (c * c - b * b);                      // of the outer one: p in, 1 out
  const double from_in = b * (k * b * b / (c * c - b * b) + out), from_out = b * out * (k + 1);
  const double p = from_out / (from_in + held);
  CHECK(pressure("circle mouth centre 0 0 radius 10\n") == doctest::Approx(p).epsilon(5e-3));
  // In three arcs, the middle of one of which is where the outline begins.
  CHECK(pressure(
            "from 0 -10\narc mouth centre 0 0 turn -100\narc mouth centre 0 0 turn -160\narc mouth centre 0 0 turn -100\n") ==
        doctest::Approx(p).epsilon(5e-3));
}

TEST_CASE("sketch: a side that goes on where its outline begins is one zone") {
  // The foot of the upper block is two curves, the last and the first of its outline.
  const char* text =
      "body low E 100 nu 0\nfrom 0 0\nline foot to 2 0\nline to 2 1\nline top to 0 1\nline close\n"
      "body high E 100 nu 0\nfrom 1 1\nline foot to 2 1\nline to 2 2\nline top to 0 2\nline to 0 1\nline foot close\n"
      "tie low.top high.foot\nfix low.foot\ntraction high.top y 1\n";
  const problem::Result r = solve_sketch(text);
  REQUIRE(r.status == C2D_OK);
  REQUIRE(r.outcome == C2D_REACHED);
  const problem::Step& last = r.steps.back();
  for (int i = 0; i < last.pairs(); ++i) CHECK(last.at(i, C2D_TN) == doctest::Approx(-1).epsilon(1e-9));
}

TEST_CASE("sketch: bodies without contact follow their history") {
  const char* text = "body b E 100 nu 0\nfrom 0 0\nline foot to 2 0\nline to 2 1\nline top to 0 1\nline close\n"
                     "case one\nfix b.foot\ntraction b.top y 1\ncase two\ntraction b.top y 3\nhistory one 1; two 1\n";
  const problem::Result r = solve_sketch(text);
  REQUIRE(r.status == C2D_OK);
  REQUIRE(r.outcome == C2D_REACHED);
  CHECK(r.summary.load == 1);
  double up = 0;
  for (const auto& end : r.boundary[0]) up = std::max(up, end.uy);
  CHECK(up == doctest::Approx(4.0 / 100).epsilon(1e-9));
}
