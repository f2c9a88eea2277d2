// A ring shrunk on a bush that is bonded to a core: Lame with three layers.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

// A quarter from radius a to b. Sides: 0 axis, 1 outer arc, 2 axis, 3 inner arc.
Outline quarter(double a, double b, int around) {
  const int radial = std::max(1, static_cast<int>(around * (b - a) / (a + b) + 0.5));
  Outline out({a, 0});
  out.axis_y({b, 0}, equal(b - a, radial));
  out.arc({0, 0}, b, 0, 90, equal(1, around));
  out.axis_x({0, a}, equal(b - a, radial));
  out.arc({0, 0}, a, 90, 0, equal(1, around));
  return out;
}

ProblemModel build_shrink(const Values& v) {
  const double a = v.number("a"), b = v.number("b"), c = v.number("c"), d = v.number("d"), delta = v.number("delta") * c;
  if (!(a < b && b < c && c < d)) return unfit("a, b, c, d are to rise");
  if (delta > 0.01 * c) return unfit("delta is above 0.01: strains are to be small");
  const int n = v.count("n");
  const bool free = v.word("bond") == "free";

  ProblemModel m;
  m.heading = {"A ring (body 3) shrunk on a bush (body 2) that is bonded to a core (body 1), smooth; a quarter is modelled.",
               "Radii a = " + show(a) + ", b = " + show(b) + ", c = " + show(c) + ", d = " + show(d) +
                   "; the ring's inner radius is smaller than c by " + show(delta),
               "Each layer has ur = C r + D / r; pressures at b and c follow from the bond and the interference.",
               "Reference: G. Lame, 1852, with three layers"};
  m.title = "RING SHRUNK ON A BONDED BUSH";
  m.function_nodes = v.count("order") + 1;
  m.images = true;
  m.plane = v.word("plane") == "stress" ? 1 : 0;
  m.bodies = {{v.number("E1"), v.number("nu1"), {0, 0}, {quarter(a, b, free ? n + 3 : n)}, "the core"},
              {v.number("E2"), v.number("nu2"), {0, 0}, {quarter(b, c, n)}, "the bush"},
              {v.number("E3"), v.number("nu3"), {0, 0}, {quarter(c - delta, d, n)}, "the ring"}};
  const ContactZone shrunk{{1, 1}, {2, 3}};
  m.zones = {shrunk, tie({0, 1}, {1, 3}, free)};
  m.keywords = {"*INTERFERENCE 1"};
  return m;
}

} // namespace

Family shrink_family() {
  return {"shrink",
          "a ring shrunk on a bush that is bonded to a core: Lame with three layers",
          {{"a", Kind::kPositive, "1", "inner radius of the core"},
           {"b", Kind::kPositive, "1.5", "radius of the bond"},
           {"c", Kind::kPositive, "2", "outer radius of the bush"},
           {"d", Kind::kPositive, "3", "outer radius of the ring"},
           {"delta", Kind::kPositive, "1e-4", "interference, over c"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the core"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "500", "Young's modulus of the bush"},
           {"nu2", Kind::kPoisson, "0.35", "its Poisson's ratio"},
           {"E3", Kind::kPositive, "2000", "Young's modulus of the ring"},
           {"nu3", Kind::kPoisson, "0.25", "its Poisson's ratio"},
           {"plane", Kind::kChoice, "strain", "strain|stress: plane strain or stress"},
           {"bond", Kind::kChoice, "matching", "matching|free: whether the meshes match at the bond"},
           {"n", Kind::kCount, "12", "elements over each quarter circle"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_shrink};
}

} // namespace families
