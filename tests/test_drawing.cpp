// Drawings that become sketches: files of gmsh and ezdxf, drawings written here, what is wrong with drawings.
#include "paths.hpp"
#include "program/drawing/formats/nurbs.hpp"
#include "program/drawing/read.hpp"
#include "program/drawing/write.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sketch/shapes/outline.hpp"
#include "shell.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>

using sketch::Point;
using test::contains;

namespace {

const double kPi = std::acos(-1.0);
const std::string kDrawings = paths::data() + "/drawings/";

struct Drawn {
  std::string text; // of the sketch
  std::vector<std::string> notes;
  sketch::Sketch sketch;
};

sketch::Reading read_sketch(const std::string& text) {
  return sketch::read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
}

// A drawing as a sketch that reads without a fault.
Drawn drawn(const std::string& drawing, double join = 0) {
  Drawn out;
  out.text = drawing::sketch_of(drawing::read_drawing(drawing, join, out.notes), "a drawing", {});
  const sketch::Reading reading = read_sketch(out.text);
  INFO(out.text);
  for (const sketch::Fault& fault : reading.faults) MESSAGE(fault.text);
  REQUIRE(reading.faults.empty());
  out.sketch = reading.sketch;
  return out;
}
Drawn drawn_file(const std::string& name) { return drawn(test::read_file(kDrawings + name)); }

bool notes_tell(const Drawn& d, const std::string& part) {
  std::string all;
  for (const std::string& note : d.notes) all += note + "\n";
  INFO(all);
  return contains(all, part);
}

// What is wrong with a drawing, with its line, behind what was left out of it.
std::string fault(const std::string& drawing) {
  std::vector<std::string> notes;
  std::string all;
  try {
    drawing::read_drawing(drawing, 0, notes);
    all = "none";
  } catch (const drawing::Fault& f) {
    for (const std::string& note : notes) all += note + "; ";
    all += std::to_string(f.line) + " " + f.text;
  }
  return all;
}

// The area within the outlines of a body, by Gauss's rule along every curve; to about 1e-12 for those of these tests.
double area(const sketch::Body& body) {
  double sum = 0;
  for (const sketch::Outline& outline : body.outlines)
    for (const sketch::Curve& curve : outline.curves) {
      const int n = curve.shape->form() == sketch::Form::kLine ? 1 : 400;
      for (int i = 0; i < n; ++i)
        for (const double g : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) {
          const sketch::Shape::Local p = curve.shape->local((i + 0.5 + 0.5 * g) / n);
          sum += (g == 0 ? 4.0 : 2.5) / 9 * sketch::cross(p.at, p.d) / (2 * n);
        }
    }
  return sum;
}

double perimeter(const sketch::Body& body) {
  double sum = 0;
  for (const sketch::Outline& outline : body.outlines)
    for (const sketch::Curve& curve : outline.curves) sum += sketch::Measure(curve.shape).length();
  return sum;
}

int curves_called(const sketch::Body& body, const std::string& name) {
  int count = 0;
  for (const sketch::Outline& outline : body.outlines)
    for (const sketch::Curve& curve : outline.curves) count += curve.name == name ? 1 : 0;
  return count;
}

// An R12 drawing of nothing but entities.
std::string dxf(const std::string& entities, const std::string& header = "") {
  return "  0\nSECTION\n  2\nHEADER\n" + header + "  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n" + entities +
         "  0\nENDSEC\n  0\nEOF\n";
}
std::string value(int code, double number) { return std::to_string(code) + "\n" + sketch::show(number) + "\n"; }
std::string point(int code, Point p) { return value(code, p.x) + value(code + 10, p.y); }
std::string dxf_line(Point a, Point b, const std::string& layer = "0") {
  return "0\nLINE\n8\n" + layer + "\n" + point(10, a) + point(11, b);
}
std::string dxf_arc(Point centre, double r, double from, double to, const std::string& layer = "0") {
  return "0\nARC\n8\n" + layer + "\n" + point(10, centre) + value(40, r) + value(50, from) + value(51, to);
}
std::string circle(Point centre, double r, const std::string& layer = "0") {
  return "0\nCIRCLE\n8\n" + layer + "\n" + point(10, centre) + value(40, r);
}
std::string polyline(const std::vector<std::array<double, 3>>& corners, bool closed, const std::string& more = "") {
  std::string text =
      "0\nLWPOLYLINE\n8\nouter\n90\n" + std::to_string(corners.size()) + "\n70\n" + (closed ? "1" : "0") + "\n" + more;
  for (const auto& [x, y, bulge] : corners) text += point(10, {x, y}) + value(42, bulge);
  return text;
}
std::string rectangle(double x, double y, double width, double height) {
  return dxf_line({x, y}, {x + width, y}) + dxf_line({x + width, y + height}, {x + width, y}) +
         dxf_line({x, y + height}, {x + width, y + height}) + dxf_line({x, y}, {x, y + height});
}

// A mesh of line elements between points, each with its physical group.
std::string mesh(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& lines,
                 const std::string& names = "") {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n" + std::to_string(points.size()) + "\n";
  for (size_t i = 0; i < points.size(); ++i)
    text += std::to_string(i + 1) + " " + sketch::show(points[i].x) + " " + sketch::show(points[i].y) + " 0\n";
  text += "$EndNodes\n$Elements\n" + std::to_string(lines.size()) + "\n";
  for (size_t i = 0; i < lines.size(); ++i)
    text += std::to_string(i + 1) + " 1 2 " + std::to_string(lines[i][2]) + " 7 " + std::to_string(lines[i][0]) + " " +
            std::to_string(lines[i][1]) + "\n";
  return text + "$EndElements\n";
}

} // namespace

TEST_CASE("drawing: the rounded pad, from every file that a tool wrote") {
  for (const char* name : {"pad-order1.msh", "pad-order2.msh", "pad-order3.msh", "pad-r12.dxf", "pad-r2018.dxf"}) {
    CAPTURE(name);
    const Drawn d = drawn_file(name);
    REQUIRE(d.sketch.bodies.size() == 2);
    const sketch::Body &block = d.sketch.bodies[0], &pad = d.sketch.bodies[1];
    const bool named = contains(d.text, "body pad ");
    CHECK(named == (std::string(name) == "pad-order1.msh" || std::string(name) == "pad-order2.msh"));
    CHECK(area(block) == doctest::Approx(600).epsilon(1e-12));
    CHECK(perimeter(block) == doctest::Approx(110).epsilon(1e-12));
    CHECK(area(pad) == doctest::Approx(140 - 8 * (1 - kPi / 4)).epsilon(1e-10));
    CHECK(perimeter(pad) == doctest::Approx(40 + 2 * kPi).epsilon(1e-10));
    for (const char* curve : {"bottom", "top"}) CHECK(curves_called(block, curve) == 1);
    CHECK(curves_called(block, "sides") == 2);
    CHECK(curves_called(pad, "loaded") == 1);
    CHECK(curves_called(pad, "flanks") == 2);
    CHECK(curves_called(pad, "face") == 3);
    for (const sketch::Curve& curve : pad.outlines[0].curves) CHECK(curve.shape->form() != sketch::Form::kSmooth);
  }
  CHECK(drawn_file("pad-r2018.dxf").sketch.units[0] == "mm");
  CHECK(drawn_file("pad-r12.dxf").sketch.units[0] == "");
  CHECK(notes_tell(drawn_file("pad-r12.dxf"), "left out: 1 TEXT (line"));
  CHECK(notes_tell(drawn_file("pad-r12.dxf"), "read: 7 LINE, 1 POLYLINE"));
}

TEST_CASE("drawing: a mesh of what was drawn has the area and the perimeter of the closed form") {
  const Drawn d = drawn_file("pad-order2.msh");
  const sketch::Mesh mesh = sketch::first_mesh(d.sketch, 1);
  const double areas[] = {600, 140 - 8 * (1 - kPi / 4)}, perimeters[] = {110, 40 + 2 * kPi};
  for (size_t b = 0; b < 2; ++b) {
    double length = 0, sum = 0;
    for (const sketch::MeshedOutline& outline : mesh.bodies[b])
      for (const sketch::MeshedCurve& curve : outline.curves)
        for (size_t e = 0; e < curve.elements(); ++e) {
          const auto at = [&](double s) { return curve.curve->shape->at(curve.measure.u_at(s)); };
          const Point p = at(curve.ends[e]), q = at(0.5 * (curve.ends[e] + curve.ends[e + 1])), r = at(curve.ends[e + 1]);
          length += sketch::length(q - p) + sketch::length(r - q);
          // A parabola through three points bounds 2/3 of the triangle's height times its base.
          sum += sketch::cross(p, r) / 2 + 2.0 / 3 * sketch::cross(q - p, r - p);
        }
    CHECK(length == doctest::Approx(perimeters[b]).epsilon(1e-3));
    CHECK(sum == doctest::Approx(areas[b]).epsilon(1e-6));
  }
  CHECK(contains(sketch::deck_of(d.sketch, mesh), "*FREE"));
}

TEST_CASE("drawing: circles, slots, ellipses and splines of a file of ezdxf") {
  const Drawn d = drawn_file("shapes.dxf");
  REQUIRE(d.sketch.bodies.size() == 7);
  const std::vector<sketch::Body>& b = d.sketch.bodies;
  CHECK(d.sketch.units[0] == "m");
  CHECK(area(b[0]) == doctest::Approx(8 * kPi).epsilon(1e-10));
  CHECK(area(b[1]) == doctest::Approx(16 + 4 * kPi).epsilon(1e-10));
  CHECK(curves_called(b[1], "long_side") == 2);
  CHECK(area(b[2]) == doctest::Approx(kPi * (17 * 0.5 - 0.4)).epsilon(1e-10));
  CHECK(area(b[3]) == doctest::Approx(kPi * 3 * 1.5 / 2).epsilon(1e-10));
  // Under a cubic Bezier-like spline with knots 0 0 0 0 1/2 1 1 1 1 and from y = 5: see the next test for the curve.
  drawing::Nurbs wave;
  wave.points = {{20, 10}, {22, 13}, {24, 7}, {26, 12}, {28, 10}};
  wave.knots = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
  double under = 0;
  for (int i = 0; i < 100000; ++i) {
    const Point p = wave.at(i / 1e5), q = wave.at((i + 1) / 1e5);
    under += (q.x - p.x) * (0.5 * (p.y + q.y) - 5);
  }
  CHECK(area(b[4]) == doctest::Approx(under).epsilon(1e-7));
  CHECK(area(b[6]) == doctest::Approx(4 * kPi).epsilon(1e-10));
  CHECK(curves_called(b[6], "rational_quarter") == 1);
  CHECK(notes_tell(d, "the name") == false); // names are changed in the sketch
  CHECK(contains(d.text, "! name 'long side' is changed to long_side"));
}

TEST_CASE("drawing: blocks of a file of ezdxf") {
  const Drawn d = drawn_file("blocks.dxf"); // a notched plate: as it is, turned and twice as large, mirrored, in two columns
  REQUIRE(d.sketch.bodies.size() == 5);
  const double one = 6 - kPi / 8;
  for (size_t b = 0; b < 5; ++b) {
    CHECK(area(d.sketch.bodies[b]) == doctest::Approx((b == 1 ? 4 : 1) * one).epsilon(1e-10));
    CHECK(curves_called(d.sketch.bodies[b], "notch") == 1);
  }
}

TEST_CASE("drawing: meshes without physical groups, of curves and of faces") {
  for (const char* name : {"plate-curves.msh", "plate-faces.msh"}) {
    CAPTURE(name);
    const Drawn d = drawn_file(name);
    REQUIRE(d.sketch.bodies.size() == 1);
    const sketch::Body& plate = d.sketch.bodies[0];
    REQUIRE(plate.outlines.size() == 2);
    // The wave of the top is the same to both sides of its middle: 10 times 6, without the hole.
    CHECK(area(plate) == doctest::Approx(60 - 2.25 * kPi).epsilon(5e-3));
    sketch::Body hole;
    hole.outlines = {plate.outlines[1]};
    CHECK(area(hole) == doctest::Approx(-2.25 * kPi).epsilon(1e-10));
    CHECK(curves_called(plate, "curve3") == 1);
    CHECK(curves_called(plate, "curve5") == 1);
  }
}

TEST_CASE("drawing: physical surfaces that share nodes are bodies that touch, holes are theirs") {
  const Drawn d = drawn_file("joined.msh");
  REQUIRE(d.sketch.bodies.size() == 2);
  CHECK((d.sketch.bodies[0].name == "lower" && d.sketch.bodies[1].name == "upper"));
  CHECK(area(d.sketch.bodies[0]) == doctest::Approx(8 - kPi / 4).epsilon(1e-10));
  CHECK(perimeter(d.sketch.bodies[0]) == doctest::Approx(12 + kPi).epsilon(1e-10));
  CHECK(area(d.sketch.bodies[1]) == doctest::Approx(4).epsilon(1e-12));
  CHECK(d.sketch.bodies[1].outlines[0].curves.size() == 4);
  for (const sketch::Body& body : d.sketch.bodies) // the example is of the sides between them, at y = 2
    for (const sketch::Curve& curve : body.outlines[0].curves) {
      const bool between = curve.shape->at(0).y == 2 && curve.shape->at(1).y == 2;
      const size_t example = d.text.find("! contact "), end = d.text.find("mu 0.3", example);
      CHECK(contains(d.text.substr(example, end - example), body.name + "." + curve.name + " ") == between);
    }
}

TEST_CASE("drawing: B-splines against the recursion of their basis") {
  struct Basis {
    static double of(const std::vector<double>& k, size_t i, int p, double t) {
      if (p == 0) return t >= k[i] && t < k[i + 1] ? 1 : 0;
      const size_t q = static_cast<size_t>(p);
      const double a = k[i + q] - k[i], b = k[i + q + 1] - k[i + 1];
      return (a > 0 ? (t - k[i]) / a * of(k, i, p - 1, t) : 0) + (b > 0 ? (k[i + q + 1] - t) / b * of(k, i + 1, p - 1, t) : 0);
    }
  };
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> any(0.1, 1);
  for (int degree = 1; degree <= 5; ++degree) {
    drawing::Nurbs n;
    n.degree = degree;
    for (int i = 0; i < 9; ++i) n.points.push_back({any(dice), any(dice)}), n.weights.push_back(any(dice));
    n.knots.push_back(0);
    while (n.knots.size() < 10 + static_cast<size_t>(degree))
      n.knots.push_back(n.knots.back() + (n.knots.size() % 4 == 0 ? 0 : any(dice)));
    CHECK(n.fault() == "");
    const double first = n.knots[static_cast<size_t>(degree)], last = n.knots[9];
    for (int i = 0; i < 50; ++i) {
      const double t = first + (last - first) * (i + 0.3) / 50;
      double x = 0, y = 0, w = 0;
      for (size_t j = 0; j < 9; ++j) {
        const double f = n.weights[j] * Basis::of(n.knots, j, degree, t);
        x += f * n.points[j].x, y += f * n.points[j].y, w += f;
      }
      CHECK(sketch::length(n.at(t) - Point{x / w, y / w}) < 1e-13);
    }
  }
}

TEST_CASE("drawing: a spline of a sketch stays near the B-spline that was drawn") {
  drawing::Nurbs n;
  n.points = {{0, 0}, {1, 2}, {3, -1}, {4, 1}, {6, 0}, {7, 3}};
  n.knots = {0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  const std::vector<drawing::Curve> curves = drawing::curves_of(n, 1e-6);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].doubt <= 1e-6);
  CHECK(curves[0].doubt > 0);
  const sketch::ShapePtr shape = drawing::shape_of(curves[0]);
  for (int i = 0; i <= 300; ++i) { // brute force: the nearest of many points, and its neighbours' chords
    const Point p = n.at(3.0 * i / 300);
    double least = HUGE_VAL;
    for (int k = 0; k < 4000; ++k) {
      const Point a = shape->at(k / 4000.0), d = shape->at((k + 1) / 4000.0) - a;
      const double t = std::clamp(sketch::dot(p - a, d) / sketch::dot(d, d), 0.0, 1.0);
      least = std::min(least, sketch::length(p - (a + t * d)));
    }
    CHECK(least < 2e-6);
  }
  // A corner inside splits it; where it is straight it is a line.
  n.degree = 2;
  n.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}};
  n.knots = {0, 0, 0, 1, 1, 2, 2, 2};
  const std::vector<drawing::Curve> parts = drawing::curves_of(n, 1e-6);
  REQUIRE(parts.size() == 2);
  for (const drawing::Curve& part : parts) CHECK(part.kind == drawing::Curve::kLine);
}

TEST_CASE("drawing: blocks are drawn where they are inserted") {
  // A quarter of a ring and a half ellipse on it; its base is (1, 0).
  const std::string half = "0\nELLIPSE\n8\n0\n10\n3\n20\n0\n11\n1\n21\n0\n40\n0.5\n41\n" + sketch::show(kPi) + "\n42\n" +
                           sketch::show(2 * kPi) + "\n";
  const std::string block = "0\nBLOCK\n2\npart\n10\n1\n20\n0\n" + half + dxf_arc({0, 0}, 4, 0, 90, "rim") +
                            dxf_arc({0, 0}, 2, 0, 90) + dxf_line({0, 2}, {0, 4}) + "0\nENDBLK\n" +
                            "0\nBLOCK\n2\nouter\n10\n0\n20\n0\n0\nINSERT\n8\n0\n2\npart\n10\n5\n20\n5\n0\nENDBLK\n";
  const auto with = [&](const std::string& entities) {
    std::string text = dxf(entities);
    return text.insert(text.find("  0\nSECTION\n  2\nENTITIES"), "0\nSECTION\n2\nBLOCKS\n" + block + "0\nENDSEC\n");
  };
  const auto insert = [](const std::string& name, double x, double y, double turn, const std::string& more = "") {
    return "0\nINSERT\n8\nplace\n2\n" + name + "\n" + point(10, {7, -3}) + value(41, x) + value(42, y) + value(50, turn) + more;
  };
  const double own = kPi * 12 / 4 + kPi * 0.5 / 2;
  for (const auto& [x, y] : {std::pair(1.0, 1.0), std::pair(2.0, -2.0), std::pair(-0.5, 0.5), std::pair(-3.0, -3.0)})
    for (const std::string name : {"part", "outer"}) {
      const Drawn d = drawn(with(insert(name, x, y, 33)));
      REQUIRE(d.sketch.bodies.size() == 1);
      CHECK(area(d.sketch.bodies[0]) == doctest::Approx(own * x * x).epsilon(1e-10));
      CHECK(curves_called(d.sketch.bodies[0], "rim") == 1);
      CHECK(curves_called(d.sketch.bodies[0], "place") == 3);
      // Where the point (0, 4) of the block went: on the boundary, by hand.
      const double c = std::cos(33 * kPi / 180), s = std::sin(33 * kPi / 180), shift = name == "outer" ? 5 : 0;
      const Point p = {x * (-1 + shift), y * (4 + shift)}, at = {7 + c * p.x - s * p.y, -3 + s * p.x + c * p.y};
      double least = HUGE_VAL;
      for (const sketch::Curve& curve : d.sketch.bodies[0].outlines[0].curves)
        least = std::min(least, sketch::length(curve.shape->at(0) - at));
      CHECK(least < 1e-9);
    }
  const std::string array = "70\n3\n71\n2\n44\n10\n45\n20\n";
  CHECK(drawn(with(insert("part", 1, 1, 10, array))).sketch.bodies.size() == 6);
  CHECK(area(drawn(with(insert("part", 1, 2, 0))).sketch.bodies[0]) == doctest::Approx(2 * own).epsilon(1e-10));
  CHECK(contains(fault(with(insert("none", 1, 1, 0))), "left out: 1 INSERT (line"));
  CHECK(contains(fault(with(insert("none", 1, 1, 0))), "block 'none' is missing; 0 the drawing has no curves"));
  CHECK(contains(fault(with(insert("part", 1, 1, 0, "70\n3000\n71\n3000\n"))), "more than 10000 copies"));
  std::string round = with(insert("outer", 1, 1, 0));
  round.replace(round.find("2\npart\n10\n5"), 6, "2\nouter");
  CHECK(contains(fault(round), "block 'outer' contains itself, or blocks are nested more than 16 deep"));
}

TEST_CASE("drawing: bulges of polylines are segments of circles") {
  for (const double bulge : {0.1, 0.5, 1.0, 2.0, -0.1, -0.4}) {
    CAPTURE(bulge);
    const Drawn d = drawn(dxf(polyline({{0, 0, bulge}, {2, 0, 0}, {2, 6, 0}, {0, 6, 0}}, true)));
    const double angle = 4 * std::atan(bulge), r = 2 * (1 + bulge * bulge) / (4 * std::fabs(bulge));
    const double segment = 0.5 * r * r * (std::fabs(angle) - std::sin(std::fabs(angle)));
    REQUIRE(d.sketch.bodies.size() == 1);
    CHECK(area(d.sketch.bodies[0]) == doctest::Approx(12 + (bulge > 0 ? segment : -segment)).epsilon(1e-9));
  }
  // Two half circles are a circle, also seen from behind.
  for (const char* plane : {"", "210\n0\n220\n0\n230\n-1\n"}) {
    const Drawn d = drawn(dxf(polyline({{-1, 2, 1}, {3, 2, 1}}, true, plane)));
    CHECK(area(d.sketch.bodies[0]) == doctest::Approx(4 * kPi).epsilon(1e-10));
    CHECK(contains(d.text, *plane == '\0' ? "circle outer centre 1 2  radius 2" : "circle outer centre -1 2  radius 2"));
  }
}

TEST_CASE("drawing: any order, any direction, any angle, mirrored: the same areas") {
  std::mt19937 dice(11);
  std::uniform_real_distribution<double> any(0, 360);
  for (int round = 0; round < 40; ++round) {
    const double turn = any(dice), c = std::cos(turn * kPi / 180), s = std::sin(turn * kPi / 180),
                 scale = std::pow(10, any(dice) / 30 - 4);
    const bool behind = round % 2 == 1; // arcs in a plane that is seen from behind
    const auto at = [&](double x, double y) { return Point{scale * (c * x - s * y + 3), scale * (s * x + c * y - 7)}; };
    const auto round_corner = [&](double x, double y, double r, double from) {
      const Point centre = at(x, y);
      if (!behind) return dxf_arc(centre, scale * r, from + turn, from + turn + 90);
      return dxf_arc({-centre.x, centre.y}, scale * r, 90 - from - turn, 180 - from - turn) + "210\n0\n220\n0\n230\n-1\n";
    };
    std::vector<std::string> parts = {dxf_line(at(1, 0), at(4, 0)), round_corner(4, 1, 1, 270),
                                      dxf_line(at(5, 4), at(5, 1)), dxf_line(at(5, 4), at(0, 4)),
                                      dxf_line(at(0, 1), at(0, 4)), round_corner(1, 1, 1, 180),
                                      circle(at(2.5, 2), scale),    circle(at(2.5, 2), scale * 0.9)};
    std::shuffle(parts.begin(), parts.end(), dice);
    std::string all;
    for (const std::string& part : parts) all += part;
    const Drawn d = drawn(dxf(all));
    REQUIRE(d.sketch.bodies.size() == 2);
    const double round_plate = area(d.sketch.bodies[0]) > area(d.sketch.bodies[1]) ? 0 : 1;
    const sketch::Body &plate = d.sketch.bodies[static_cast<size_t>(round_plate)],
                       &pin = d.sketch.bodies[static_cast<size_t>(1 - round_plate)];
    CHECK(area(plate) == doctest::Approx(scale * scale * (20 - 2 * (1 - kPi / 4) - kPi)).epsilon(1e-9));
    CHECK(perimeter(plate) == doctest::Approx(scale * (3 + 3 + 5 + 3 + kPi + 2 * kPi)).epsilon(1e-9));
    CHECK(area(pin) == doctest::Approx(scale * scale * 0.81 * kPi).epsilon(1e-9));
  }
}

TEST_CASE("drawing: loops within loops, and outlines that share curves") {
  const Drawn nested = drawn(dxf(rectangle(0, 0, 10, 10) + circle({5, 5}, 4) + circle({5, 5}, 3) + circle({5, 5}, 1)));
  REQUIRE(nested.sketch.bodies.size() == 2);
  CHECK(area(nested.sketch.bodies[0]) == doctest::Approx(100 - 16 * kPi).epsilon(1e-10));
  CHECK(area(nested.sketch.bodies[1]) == doctest::Approx(8 * kPi).epsilon(1e-10));
  // A layer on a block: the line between them is drawn once. A hole in the layer belongs to it.
  const Drawn shared = drawn(dxf(dxf_line({0, 0}, {6, 0}) + dxf_line({6, 0}, {6, 4}) + dxf_line({6, 4}, {0, 4}, "between") +
                                 dxf_line({0, 4}, {0, 0}) + dxf_line({0, 4}, {0, 6}) + dxf_line({0, 6}, {6, 6}) +
                                 dxf_line({6, 6}, {6, 4}) + circle({3, 5}, 0.5)));
  REQUIRE(shared.sketch.bodies.size() == 2);
  CHECK(notes_tell(shared, "2 outlines share curves"));
  for (const sketch::Body& body : shared.sketch.bodies) {
    CHECK(curves_called(body, "between") == 1);
    CHECK(area(body) == doctest::Approx(body.outlines.size() == 2 ? 12 - kPi / 4 : 24).epsilon(1e-10));
  }
  // Circles that touch each other in a point.
  CHECK(drawn(dxf(circle({0, 0}, 2) + circle({3, 0}, 1))).sketch.bodies.size() == 2);
  // A line and an arc that begin in one direction: curvature tells their order.
  const Drawn tangent = drawn(dxf(dxf_line({0, 0}, {4, 0}) + dxf_line({4, 0}, {4, 4}) + dxf_line({4, 4}, {0, 0}) +
                                  dxf_arc({0, 2}, 2, 270, 360) + dxf_line({2, 2}, {0, 0})));
  CHECK(tangent.sketch.bodies.size() == 2);
}

TEST_CASE("drawing: open ends, doubles and what has no length are told") {
  const Drawn open =
      drawn(dxf(rectangle(0, 0, 10, 10) + dxf_line({20, 0}, {30, 0}, "rail") + dxf_line({30, 0.25}, {30, 9}, "post")));
  CHECK(open.sketch.bodies.size() == 1);
  CHECK(notes_tell(open, "line of 'rail' in line"));
  CHECK(notes_tell(open, "has an open end at (30, 0); the nearest other end is at (30, 0.25), 0.25 away"));
  CHECK(notes_tell(open, "has an open end at (20, 0); the nearest other end is at (10, 0), 10 away"));
  CHECK(notes_tell(open, "2 curves are left out: not part of a closed outline"));
  const Drawn twice = drawn(dxf(rectangle(0, 0, 10, 10) + dxf_line({10, 0}, {0, 0}) + circle({5, 5}, 1) + circle({5, 5}, 1) +
                                dxf_line({3, 3}, {3, 3}) + "0\nTEXT\n8\n0\n0\nTEXT\n8\n0\n0\nDIMENSION\n8\n0\n"));
  REQUIRE(twice.sketch.bodies.size() == 1);
  CHECK(area(twice.sketch.bodies[0]) == doctest::Approx(100 - kPi));
  CHECK(notes_tell(twice, "line in line"));
  CHECK(notes_tell(twice, "from (10, 0) to (0, 0) coincides with line"));
  CHECK(notes_tell(twice, "circle in line"));
  CHECK(notes_tell(twice, "at (3, 3) has no length and was left out"));
  CHECK(notes_tell(twice, "left out: 2 TEXT (from line"));
  CHECK(notes_tell(twice, "left out: 1 DIMENSION (line"));
  // Ends in the middle of a line and of an arc.
  const Drawn middle = drawn(dxf(rectangle(0, 0, 10, 10) + dxf_arc({20, 0}, 5, 80, 280, "bow") + dxf_line({10, 4}, {15, 0})));
  CHECK(notes_tell(middle, "at (10, 4); the nearest other end is at (10, 0), 4 away; it lies on line in line"));
  CHECK(notes_tell(middle, "it lies on arc of 'bow' in line"));
  CHECK(notes_tell(drawn(dxf(rectangle(0, 0, 10, 10) + "30\n0\n31\n2\n")),
                   ": projected along z, because its points differ in z"));
  // Two loops with a bridge between them.
  const Drawn bridge = drawn(dxf(rectangle(0, 0, 1, 1) + rectangle(3, 0, 1, 1) + dxf_line({1, 0}, {3, 0})));
  CHECK(bridge.sketch.bodies.size() == 2);
  CHECK(notes_tell(bridge, "1 curve is left out: not part of a closed outline"));
  // Many open ends: twenty in full, the others by number.
  std::string comb;
  for (int i = 0; i < 30; ++i) comb += dxf_line({2.0 * i, 20}, {2.0 * i, 30});
  CHECK(notes_tell(drawn(dxf(rectangle(0, 0, 10, 10) + comb)), "and 40 other ends are open"));
}

TEST_CASE("drawing: a file of pstoedit, of six digits") {
  std::vector<std::string> notes;
  const std::string file = test::read_file(kDrawings + "six-digits.dxf");
  CHECK(contains(fault(file), "no closed outline"));
  const Drawn d = drawn(file, 1e-4);
  REQUIRE(d.sketch.bodies.size() == 1);
  CHECK(d.sketch.units[0] == "mm");
  // 100 x 40 units of 1/72 inch and two quarters of a circle, less a circle; Bezier curves are no circles, to 3e-4.
  const double unit = 25.4 / 72;
  CHECK(area(d.sketch.bodies[0]) == doctest::Approx(unit * unit * (100 * 40 + 200 * kPi - 100 * kPi)).epsilon(1e-4));
}

TEST_CASE("drawing: ends that nearly meet are joined") {
  const double gap = 5e-6; // of 10: below 1e-6 of the size; twice that is open
  CHECK(
      drawn(dxf(dxf_line({0, 0}, {10, 0}) + dxf_line({10, gap}, {10, 10}) + dxf_line({10, 10}, {0, 0}))).sketch.bodies.size() ==
      1);
  CHECK(contains(fault(dxf(dxf_line({0, 0}, {10, 0}) + dxf_line({10, 4 * gap}, {10, 10}) + dxf_line({10, 10}, {0, 0}))),
                 "no closed outline"));
  // A file of six digits: what --join takes for one. An arc and an ellipse go through the joints.
  const double far = 1e-3;
  const std::string loose = dxf_line({0, 0}, {10, 0}) + dxf_arc({10, 2 + far}, 2, 270, 90) + dxf_line({10, 4}, {0, 4}) +
                            "0\nELLIPSE\n10\n0\n20\n2\n11\n0\n21\n2.001\n40\n0.5\n41\n0\n42\n" + sketch::show(kPi) + "\n";
  CHECK(contains(fault(dxf(loose)), "no closed outline; --join D joins ends up to a distance D"));
  const Drawn joined = drawn(dxf(loose), 3 * far);
  REQUIRE(joined.sketch.bodies.size() == 1);
  CHECK(area(joined.sketch.bodies[0]) == doctest::Approx(40 + 2 * kPi + kPi).epsilon(1e-3));
}

TEST_CASE("drawing: points of line elements are read as lines, arcs and splines") {
  const std::string names = "$PhysicalNames\n3\n1 1 \"wall\"\n1 2 \"round tip\"\n1 3 \"to\"\n$EndPhysicalNames\n";
  // A half disc: a straight run in three elements, and a half circle in twelve.
  std::vector<Point> points;
  std::vector<std::array<int, 3>> lines;
  for (int i = 0; i < 12; ++i) points.push_back({std::cos(kPi * i / 12), std::sin(kPi * i / 12)});
  for (const double x : {-1.0, -0.2, 0.4}) points.push_back({x, 0});
  for (int i = 0; i < 15; ++i) lines.push_back({i + 1, (i + 1) % 15 + 1, i < 12 ? 2 : 1});
  const Drawn half = drawn(mesh(points, lines, names));
  CHECK(contains(half.text, "arc round_tip to -1 0  centre 0 0"));
  CHECK(contains(half.text, "line wall close"));
  CHECK(area(half.sketch.bodies[0]) == doctest::Approx(kPi / 2).epsilon(1e-12));
  // A rectangle of one element to a side, and one group, has four points on a circle but is none. `to` is no name for a curve.
  const Drawn box = drawn(mesh({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{1, 2, 3}, {2, 3, 3}, {3, 4, 3}, {4, 1, 3}}, names));
  CHECK(curves_called(box.sketch.bodies[0], "to_") == 4);
  CHECK(area(box.sketch.bodies[0]) == doctest::Approx(2));
  // A circle of eight elements is one; of six it is a hexagon.
  for (const int n : {6, 8}) {
    points.clear(), lines.clear();
    for (int i = 0; i < n; ++i) points.push_back({std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n)});
    for (int i = 0; i < n; ++i) lines.push_back({i + 1, (i + 1) % n + 1, 0});
    CHECK(area(drawn(mesh(points, lines)).sketch.bodies[0]) ==
          doctest::Approx(n == 8 ? kPi : 1.5 * std::sqrt(3.0)).epsilon(1e-9));
  }
  // A line, a parabola and a line that go on smoothly, as one group.
  points.clear(), lines.clear();
  for (int i = -14; i <= 14; ++i) { // y = x^2 / 20 up to 5, and on in its tangent
    const double x = i, beyond = std::max(0.0, std::fabs(x) - 5);
    points.push_back({x, beyond > 0 ? 1.25 + 0.5 * beyond : x * x / 20});
  }
  points.push_back({0, 30});
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i) lines.push_back({i + 1, (i + 1) % n + 1, 2});
  const Drawn smooth = drawn(mesh(points, lines, names));
  int straight = 0;
  for (const sketch::Curve& curve : smooth.sketch.bodies[0].outlines[0].curves)
    straight += curve.shape->form() == sketch::Form::kLine;
  CHECK(straight == 4);
  CHECK(smooth.sketch.bodies[0].outlines[0].curves.size() == 5);
}

TEST_CASE("drawing: names that a sketch cannot have") {
  const Drawn d =
      drawn(dxf(dxf_line({0, 0}, {1, 0}, "Kante 1") + dxf_line({1, 0}, {1, 1}, "Kante_1") + dxf_line({1, 1}, {0, 1}, "3rd") +
                dxf_line({0, 1}, {0, 0},
                         "\xc3\xbc"
                         "ber")));
  for (const char* name : {"Kante_1", "Kante_1-2", "c_3rd", "c_ber"}) CHECK(curves_called(d.sketch.bodies[0], name) == 1);
  CHECK(contains(d.text, "! name 'Kante 1' is changed to Kante_1\n"));
  CHECK(contains(d.text, "! name 'Kante_1' is changed to Kante_1-2\n"));
}

TEST_CASE("drawing: what is wrong with a file is told with its line") {
  const std::string good = dxf(rectangle(0, 0, 1, 1));
  const std::string nodes = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n";
  struct Case {
    std::string drawing, told;
  };
  const Case cases[] = {
      {"", "0 the drawing is empty"},
      {" \n\n", "0 the drawing is empty"},
      {"body b E 1 nu 0\n", "1 not a drawing, expected DXF"},
      {"AutoCAD Binary DXF\r\n\x1a", "1 this DXF file is binary"},
      {good.substr(0, good.size() / 2), "the file ends"},
      {good.substr(0, good.find("  0\nEOF")), "the file ends without EOF: it is truncated"},
      {dxf(""), "0 the drawing has no curves"},
      {dxf(dxf_line({0, 0}, {1, 0})), "0 no closed outline"},
      {dxf("0\nLINE\n10\nx\n"),
       "left out: 1 LINE (line 14): the first end is 'x', expected a number; 0 the drawing has no curves"},
      {dxf("0\nLINE\n10\n1\n"), "left out: 1 LINE (line 12): the first end is missing, expected group 20; 0 the drawing"},
      {dxf("0\nLINE\nten\n1\n"), "13 a group code is 'ten', expected a whole number"},
      {dxf("0\nLINE\n2000\n1\n"), "13 group code 2000, expected 0 to 1071"},
      {dxf("0\nARC\n10\n0\n20\n0\n40\n0\n50\n0\n51\n1\n"), "1 ARC (line 12): radius 0, expected a value above 0"},
      {dxf("0\nCIRCLE\n10\n0\n20\n0\n40\n-1\n"), "1 CIRCLE (line 12): radius -1, expected a value above 0"},
      {dxf("0\nCIRCLE\n10\n0\n20\n0\n40\n1e999\n"), "the radius is '1e999', expected a number"},
      {dxf("0\nELLIPSE\n10\n0\n20\n0\n11\n1\n21\n0\n40\n0\n"), "ratio of the axes 0, expected a value above 0"},
      {dxf("0\nELLIPSE\n10\n0\n20\n0\n11\n0\n21\n0\n40\n1\n"), "the major axis has no length"},
      {dxf("0\nLWPOLYLINE\n90\n3\n10\n0\n20\n0\n"), "1 vertices, expected 3"},
      {dxf("0\nLWPOLYLINE\n10\n0\n"), "a vertex has no y"},
      {dxf("0\nLWPOLYLINE\n20\n0\n"), "expected x of a vertex first"},
      {dxf("0\nPOLYLINE\n0\nVERTEX\n10\n0\n20\n0\n"), "1 POLYLINE (line 12): no SEQEND after its vertices"},
      {dxf("0\nSPLINE\n71\n3\n"), "1 SPLINE (line 12): it has neither control points nor two fit points"},
      {dxf("0\nSPLINE\n71\n1\n40\n0\n10\n0\n20\n0\n10\n1\n20\n0\n"), "1 knots, expected 4"},
      {dxf("0\nSPLINE\n71\n0\n10\n0\n20\n0\n"), "degree 0, expected 1 to 15"},
      {dxf("0\nSPLINE\n71\n2\n10\n0\n20\n0\n"), "1 control points, expected more than its degree 2"},
      {dxf("0\nSPLINE\n71\n1\n40\n0\n40\n1\n40\n0\n40\n1\n10\n0\n20\n0\n10\n1\n20\n0\n"), "decreasing knots"},
      {dxf("0\nSPLINE\n71\n1\n40\n0\n40\n0\n40\n0\n40\n0\n10\n0\n20\n0\n10\n1\n20\n0\n"), "knots that span no interval"},
      {dxf("0\nSPLINE\n71\n1\n40\n0\n40\n0\n40\n1\n40\n1\n41\n1\n41\n0\n10\n0\n20\n0\n10\n1\n20\n0\n"),
       "weight 0, expected a value above 0"},
      {dxf("0\nSPLINE\n71\n1\n40\n0\n40\n0\n40\n1\n40\n1\n41\n1\n10\n0\n20\n0\n10\n1\n20\n0\n"), "1 weights, expected one per"},
      {dxf("0\nSPLINE\n71\n1\n10\n0\n10\n1\n20\n0\n"), "an x without y"},
      {"0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n", "0 no section ENTITIES"},
      {"0\nSECTION\n2\nENTITIES\n0\nEOF\n", "2 section 'ENTITIES' without ENDSEC"},
      {"0\nSECTION\n3\nENTITIES\n0\nEOF\n", "4 expected the name of a section, group 2"},
      {"$NOD\n", "$MeshFormat first"},
      {"$MeshFormat\n1 0 8\n", "2 MSH format '1', expected 2.2 or 4.1"},
      {"$MeshFormat\n4.1 1 8\n", "2 this MSH file is binary"},
      {"$MeshFormat\n2.2 0 8\n", "2 the file ends without $EndMeshFormat"},
      {"$MeshFormat\n2.2 0 8\n$EndNodes\n", "3 '$EndNodes', expected $EndMeshFormat"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\nxyz\n", "4 'xyz', expected the start of a section"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "0 no section $Nodes"},
      {nodes, "0 no section $Elements"},
      {nodes + "$Elements\n1\n", "9 the file ends within $Elements"},
      {nodes + "$Elements\n2\n1 15 2 0 0 1\n$EndElements\n", "11 $Elements has fewer lines than its count"},
      {nodes + "$Elements\n1\n1 1 2 0 0 1 9\n$EndElements\n", "left out: 1 line element (line 10): node 9 is missing"},
      {nodes + "$Elements\n1\n1 2 2 0 0 1 8 9\n$EndElements\n", "10 an element has node 8, which is missing"},
      {nodes + "$Elements\n1\n1 1 2 0 0 1 1\n$EndElements\n",
       "left out: 1 line element (line 10): both ends are the same node"},
      {nodes + "$Elements\n1\n1 1 2 0 0 1\n$EndElements\n", "10 an element of type 1 has 1 nodes, expected 2"},
      {nodes + "$Elements\n1\n1 1 9 0\n$EndElements\n", "10 $Elements: a line without nodes"},
      {nodes + "$Elements\n1\n1 1\n$EndElements\n", "10 $Elements: 2 numbers in a line, expected 3 or more"},
      {nodes + "$Elements\n0\n$EndElements\n", "0 the drawing has no curves"},
      {nodes + "$Elements\n-1\n$EndElements\n", "9 the number of elements is -1"},
      {nodes + nodes.substr(nodes.find("$Nodes")) + "$Elements\n0\n$EndElements\n", "0 node 1 is defined twice"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 zero 0\n", "6 y of a node is 'zero', expected a number"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n2 1 0 1\n$EndNodes\n$Elements\n0\n$EndElements\n",
       "the mesh is not plane: z ranges from 0 to 1"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 top\n",
       "6 the name of a physical group is 'top', expected a name in quotes"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.drawing);
    const std::string said = fault(c.drawing);
    CHECK_MESSAGE(contains(said, c.told), said << " lacks " << c.told);
  }
}

TEST_CASE("drawing: statements beside a drawing") {
  const std::string text =
      "! conditions\ntitle Two plates\nparameter E0 70e3\nunits mm N\nbody body1 E=E0 nu 0.33 ! aluminium\n"
      "body punch rigid\n  from 0 20\n  line to 1 20\n  line to 1 21\n  line close\nfix body1.c1\n";
  const drawing::Conditions c = drawing::read_conditions(text);
  REQUIRE(c.materials.size() == 1);
  CHECK(c.materials[0].text == "E=E0 nu 0.33 ! aluminium");
  CHECK((c.has_title && c.has_units));
  std::vector<std::string> notes;
  const std::string out = drawing::sketch_of(drawing::read_drawing(dxf(rectangle(0, 0, 1, 1)), 0, notes), "a.dxf", c);
  INFO(out);
  const sketch::Reading reading = read_sketch(out);
  CHECK(reading.faults.empty());
  REQUIRE(reading.sketch.bodies.size() == 2);
  CHECK(reading.sketch.bodies[0].youngs_modulus == 70e3);
  CHECK(reading.sketch.bodies[1].rigid);
  CHECK(reading.sketch.conditions.size() == 1);
  CHECK(reading.sketch.title == "Two plates");
  try {
    drawing::sketch_of(drawing::read_drawing(dxf(rectangle(0, 0, 1, 1)), 0, notes), "a.dxf",
                       drawing::read_conditions("\nbody plate E 1 nu 0\n"));
    FAIL("a material of no body");
  } catch (const drawing::Fault& f) {
    CHECK(f.line == 2);
    CHECK(f.text == "the drawing has no body 'plate', expected body1");
  }
}

TEST_CASE("drawing: the examples in a sketch make a problem when they are taken as they stand") {
  for (const char* name : {"pad-order1.msh", "pad-r2018.dxf", "plate-curves.msh"}) {
    CAPTURE(name);
    std::string text = drawn_file(name).text, taken;
    bool examples = false;
    for (const std::string& one : test::lines_of(text)) {
      taken += (examples ? one.substr(2) : one) + "\n";
      examples = examples || contains(one, "Examples; remove");
    }
    const sketch::Reading reading = read_sketch(taken);
    INFO(taken);
    for (const sketch::Fault& f : reading.faults) MESSAGE(f.text);
    CHECK(reading.faults.empty());
    CHECK(contains(sketch::deck_of(reading.sketch, sketch::first_mesh(reading.sketch, 1)), "*FREE"));
  }
}

TEST_CASE("drawing: from a file to a report in two commands") {
  const test::Folder folder;
  const std::string program = "'" + paths::program() + "'";
  const test::Result made = test::run_shell("cd '" + folder.path() + "' && " + program + " sketch '" + kDrawings +
                                            "pad-order2.msh' --with '" + kDrawings + "pad-loads.c2s' -o pad.c2s && " + program +
                                            " run pad.c2s --report pad.html --json pad.json --listing /dev/null");
  CHECK_MESSAGE(made.status == 0, made.err);
  CHECK(contains(test::read_file(folder / "pad.html"), "<svg"));
  CHECK(contains(test::read_file(folder / "pad.c2s"), "contact block.top pad.face  mu 0.6"));
  const test::Result listed = test::run_shell(program + " sketch '" + kDrawings + "pad-r12.dxf'");
  CHECK(listed.status == 0);
  CHECK(contains(listed.out, "body body1 E 210e3 nu 0.3"));
  CHECK(contains(listed.err, "pad-r12.dxf: note: left out: 1 TEXT (line"));
}

TEST_CASE("drawing: the command's own errors") {
  const test::Folder folder;
  const auto run = [&](const std::string& rest) {
    return test::run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' sketch " + rest);
  };
  CHECK(run("").status == 64);
  CHECK(contains(run("").err, "sketch needs a drawing"));
  CHECK(contains(run("a.dxf --to free").err, "sketch takes no option --to"));
  CHECK(contains(run("a.dxf --with").err, "--with needs a value"));
  CHECK(contains(run("a.dxf --join -1").err, "--join -1: expected a distance above 0"));
  CHECK(run("none.dxf").status == 2);
  CHECK(contains(run("none.dxf").err, "cannot be read"));
  test::write_file(folder / "open.dxf", dxf(dxf_line({0, 0}, {4, 0})));
  const test::Result open = run("open.dxf -o open.c2s");
  CHECK(open.status == 2);
  CHECK(contains(open.err, "open.dxf: note: line in line 12 has an open end at (0, 0)"));
  CHECK(contains(open.err, "open.dxf: error: no closed outline"));
  CHECK(test::read_file(folder / "open.c2s").empty());
  test::write_file(folder / "binary.dxf", std::string("AutoCAD Binary DXF\r\n\x1a\0abc", 25));
  CHECK(contains(run("binary.dxf").err, "binary.dxf:1:1: error: this DXF file is binary"));
  test::write_file(folder / "binary.msh", std::string("$MeshFormat\n4.1 1 8\n\1\0\0\0", 24));
  CHECK(contains(run("binary.msh").err, "binary.msh:2:1: error: this MSH file is binary"));
  test::write_file(folder / "zero.dxf", dxf(rectangle(0, 0, 1, 1)) + std::string(1, '\0'));
  CHECK(run("zero.dxf").status == 2);
  CHECK(contains(run("zero.dxf").err, "not a text file"));
  test::write_file(folder / "box.dxf", dxf(rectangle(0, 0, 1, 1)));
  CHECK(contains(run("box.dxf --with none.c2s").err, "none.c2s: error: cannot be read"));
  test::write_file(folder / "other.c2s", "body other E 1 nu 0\n");
  CHECK(contains(run("box.dxf --with other.c2s").err, "other.c2s:1:1: error: the drawing has no body 'other'"));
  // What is wrong with the statements is told, and the sketch is there to put it right.
  test::write_file(folder / "wrong.c2s", "fix body1.nowhere\n");
  const test::Result wrong = run("box.dxf --with wrong.c2s -o box.c2s");
  CHECK(wrong.status == 0);
  CHECK(contains(wrong.err, "warning: "));
  CHECK_FALSE(test::read_file(folder / "box.c2s").empty());
}

TEST_CASE("drawing: spoilt drawings are refused or read, never more") {
  std::mt19937 dice(2026);
  std::vector<std::string> files;
  for (const char* name : {"pad-order1.msh", "pad-order2.msh", "plate-curves.msh", "pad-r12.dxf", "shapes.dxf"})
    files.push_back(test::read_file(kDrawings + name));
  int refused = 0, taken = 0;
  for (int round = 0; round < 500; ++round) {
    std::string text = files[dice() % files.size()];
    for (size_t n = dice() % 4 + 1; n > 0; --n) {
      const size_t at = dice() % text.size(), length = std::min<size_t>(dice() % 40, text.size() - at);
      switch (dice() % 6) {
      case 0: text[at] = static_cast<char>(dice() % 256); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(dice() % text.size(), length)); break;
      case 3: text.resize(at + 1); break;
      case 4: text[at] = "0123456789.-e \n"[dice() % 15]; break;
      default: { // a number that another replaces
        const size_t digit = text.find_first_of("0123456789", at);
        if (digit == std::string::npos) break;
        const char* const numbers[] = {"0", "-1", "1e30", "1e-30", "2147483648", "nan", "0.5"};
        text.replace(digit, 1, numbers[dice() % 7]);
      }
      }
    }
    std::vector<std::string> notes;
    try {
      const std::string sketch = drawing::sketch_of(drawing::read_drawing(text, 0, notes), "spoilt", {});
      read_sketch(sketch);
      ++taken;
    } catch (const drawing::Fault& f) {
      CHECK_FALSE(f.text.empty());
      ++refused;
    }
  }
  CHECK(refused > 50);
  CHECK(taken > 20);
}
