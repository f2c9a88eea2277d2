// Hertz: a cylinder pressed on a half plane, without friction.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

ProblemModel build_hertz(const Values& v) {
  const double radius = v.number("R"), a = v.number("a"), size = v.number("L") * a;
  const int n = v.count("n");
  if (a > 0.1 * radius) return unfit("a is above R/10: the formulas of Hertz are for small contacts");
  if (size < 3 * a) return unfit("L is below 3");
  const double compliance =
      (1 - std::pow(v.number("nu1"), 2)) / v.number("E1") + (1 - std::pow(v.number("nu2"), 2)) / v.number("E2");
  const double load = std::acos(-1.0) * a * a / (4 * radius * compliance);
  const double h = a / (n - 1 + v.number("edge"));
  const int elements = n + (n + 3) / 4 + 2;

  ProblemModel m;
  m.heading = {"Hertz: a cylinder of radius R (body 2) on a half plane (body 1), smooth.",
               "Half of it is modelled; the half plane is a block of half width L a.",
               "R = " + show(radius) + ", half width a = " + show(a) + ", load P = " + show(load) + " per unit thickness",
               "p = p0 sqrt(1 - (x/a)^2), p0 = 2 P / (pi a) = " + show(2 * load / (std::acos(-1.0) * a)),
               "Reference: H. Hertz, 1882; K. L. Johnson, Contact Mechanics, chapter 4"};
  m.title = "HERTZ, " + show(n) + " ELEMENTS OVER THE HALF WIDTH";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  const std::vector<double> zone = cylinder_zone(radius, {{h, elements}});
  const double ratio = v.number("ratio");
  m.bodies = {{v.number("E1"), v.number("nu1"), {0, 0}, {half_block({zone, size, ratio})}, "the half plane"},
              {v.number("E2"),
               v.number("nu2"),
               {0, radius},
               {half_cylinder(zone, radius, ratio, traction(0, -load / (2 * radius)))},
               "the cylinder"}};
  m.zones = {contact(3, 0)};
  return m;
}

} // namespace

Family hertz_family() {
  return {"hertz",
          "a cylinder pressed on a half plane, smooth",
          {{"R", Kind::kPositive, "100", "radius of the cylinder"},
           {"a", Kind::kPositive, "1", "half width of the contact; gives the load"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the half plane"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "1000", "Young's modulus of the cylinder"},
           {"nu2", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"n", Kind::kCount, "20", "elements over the half width"},
           {"edge", Kind::kFraction, "0.5", "where in its element the edge of the contact lies"},
           {"L", Kind::kPositive, "200", "half width and depth of the block, over a"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the contact"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_hertz};
}

} // namespace families
