// Lame: a thick ring with inner and outer pressure.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

ProblemModel build_ring(const Values& v) {
  const double a = v.number("a"), b = v.number("b"), pi = v.number("pi"), po = v.number("po");
  if (b <= a) return unfit("b is not above a");
  const int n = v.count("n");
  ProblemModel m;
  m.heading = {"A thick ring with pressure inside and outside; a quarter of it is modelled.",
               "a = " + show(a) + ", b = " + show(b) + ", pressure inside " + show(pi) + ", outside " + show(po),
               "A = (pi a^2 - po b^2) / (b^2 - a^2), B = (pi - po) a^2 b^2 / (b^2 - a^2)",
               "srr = A - B / r^2, stt = A + B / r^2, ur = (1 + nu) / E ((1 - 2 nu) A r + B / r) in plane strain",
               "Reference: G. Lame, 1852"};
  m.title = "THICK RING";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  m.plane = v.word("plane") == "stress" ? 1 : 0;
  const int radial = std::max(1, static_cast<int>(n * (b - a) / (1.5 * a) + 0.5));
  const auto radial_traction = [](double p, double r) {
    return traction_field([p, r](Point at) { return std::array<double, 2>{{p * at.x / r, p * at.y / r}}; });
  };
  Outline ring({a, 0});
  ring.axis_y({b, 0}, equal(b - a, radial));
  ring.arc({0, 0}, b, 0, 90, equal(1, n), radial_traction(-po, b));
  ring.axis_x({0, a}, equal(b - a, radial));
  ring.arc({0, 0}, a, 90, 0, equal(1, n), radial_traction(pi, a));
  m.bodies = {{v.number("E"), v.number("nu"), {0, 0}, {ring}, "the ring"}};
  return m;
}

} // namespace

Family ring_family() {
  return {"ring",
          "a thick ring with inner and outer pressure: Lame",
          {{"a", Kind::kPositive, "1", "inner radius"},
           {"b", Kind::kPositive, "2", "outer radius"},
           {"pi", Kind::kNumber, "1", "inner pressure"},
           {"po", Kind::kNumber, "0", "outer pressure"},
           {"E", Kind::kPositive, "1", "Young's modulus"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio"},
           {"plane", Kind::kChoice, "strain", "strain|stress: plane strain or stress"},
           {"n", Kind::kCount, "8", "elements over each quarter circle"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_ring};
}

} // namespace families
