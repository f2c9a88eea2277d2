// Two bonded strips of different materials in bending.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

// The beam of two materials: stress E_i' k (y - y0) along it.
struct Beam {
  double neutral, curvature;
};
Beam beam_of(double E1, double h1, double E2, double h2, double moment) {
  const double c1 = h1 / 2, c2 = h1 + h2 / 2, axial = E1 * h1 + E2 * h2, y0 = (E1 * h1 * c1 + E2 * h2 * c2) / axial;
  const double stiffness =
      E1 * (h1 * h1 * h1 / 12 + h1 * (c1 - y0) * (c1 - y0)) + E2 * (h2 * h2 * h2 / 12 + h2 * (c2 - y0) * (c2 - y0));
  return {y0, moment / stiffness};
}

// Sides: 0 lower, 1 end, 2 upper, 3 axis.
Outline strip(double bottom, double height, double length, int along, int up, double fine, double ratio, const Condition& end,
              bool fixed) {
  const double coarse = length / along, top = bottom + height;
  const std::vector<double> s = graded(length, 0, fine, ratio, coarse), side = graded(height, fine, fine, ratio, height / up);
  Outline out({0, bottom});
  if (fixed) out.hold_y();
  out.line({length, bottom}, s);
  out.line({length, top}, side, end);
  out.line({0, top}, reversed(s));
  out.axis_x({0, bottom}, equal(height, up));
  return out;
}

ProblemModel build_bimaterial(const Values& v) {
  const double E1 = v.number("E1"), E2 = v.number("E2"), nu1 = v.number("nu1"), nu2 = v.number("nu2");
  const double h1 = v.number("h1"), h2 = v.number("h2"), depth = h1 + h2, moment = v.number("M");
  const double length = v.number("L") * depth;
  if (v.number("L") < 2) return unfit("L is below 2: the ends are felt in the middle");
  const Beam beam = beam_of(E1 / (1 - nu1 * nu1), h1, E2 / (1 - nu2 * nu2), h2, moment);
  const int n = v.count("n");
  const bool free = v.word("bond") == "free";
  // As in a strip of one material: away from the end the bond makes of it what belongs to two.
  const Condition end = traction_field([=](Point at) {
    return std::array<double, 2>{{12 * moment / (depth * depth * depth) * (at.y - depth / 2), 0}};
  });

  ProblemModel m;
  m.heading = {"Two bonded strips of different materials, bent by a moment M; the half x >= 0 is modelled.",
               "The ends carry 12 M (y - h/2) / h^3, h = h1 + h2. Away from them, with E' = E / (1 - nu^2), the stress is",
               "sxx = E' k (y - y0), y0 = " + show(beam.neutral) + ", curvature k = " + show(beam.curvature) +
                   ", and the bond carries nothing.",
               "Reference: beam of two materials; S. P. Timoshenko, 1925"};
  m.title = "BONDED STRIPS IN BENDING";
  m.function_nodes = v.count("order") + 1;
  m.images = true;
  const double fine = depth / n / 8;
  const int along = std::max(1, static_cast<int>(n * v.number("L") / 2));
  const auto over = [&](double h) { return std::max(1, static_cast<int>(std::ceil(n * h / depth))); };
  m.bodies = {{E1, nu1, {0, 0}, {strip(0, h1, length, along, over(h1), fine, 1.5, end, true)}, "the lower strip"},
              {E2,
               nu2,
               {0, 0},
               {strip(h1, h2, length, free ? along + 3 : along, over(h2), free ? 1.3 * fine : fine, 1.5, end, false)},
               "the upper strip"}};
  m.zones = {tie({0, 2}, {1, 0}, free)};
  return m;
}

} // namespace

Family bimaterial_family() {
  return {"bimaterial",
          "two bonded strips of different materials in bending: the beam of two materials",
          {{"M", Kind::kNumber, "1", "moment"},
           {"h1", Kind::kPositive, "1", "height of the lower strip"},
           {"h2", Kind::kPositive, "0.5", "height of the upper strip"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the lower strip"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "3000", "Young's modulus of the upper strip"},
           {"nu2", Kind::kPoisson, "0.2", "its Poisson's ratio"},
           {"L", Kind::kPositive, "6", "half length, over the height"},
           {"bond", Kind::kChoice, "matching", "matching|free: whether the meshes match at the bond"},
           {"n", Kind::kCount, "8", "elements over the height; half as dense along the strips"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_bimaterial};
}

} // namespace families
