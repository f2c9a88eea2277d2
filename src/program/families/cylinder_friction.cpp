// A rigid cylinder pressed on a half plane with friction or full adhesion.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

// Elements under the contact, from the axis: `n` of the size h reach to a or just beyond, and some lie outside. A jump is
// of 2.5 to 1 at two thirds of a; gradual ones go there in three steps of a fifth of the first size.
std::vector<double> zone_of(double radius, double h, int n, const std::string& sizes) {
  const int outside = (n + 9) / 10 + 1, third = (n + 1) / 3;
  if (sizes == "equal") return cylinder_zone(radius, {{h, n + outside}});
  const auto count = [](double lengths, double size) { return static_cast<int>(std::lround(lengths / size)); };
  if (sizes == "jump") {
    const int coarse = count(2 * third, 1.25);
    return cylinder_zone(radius, {{1.25 * h, coarse}, {0.5 * h, count(n + outside - 1.25 * coarse, 0.5)}});
  }
  const int first = count(third, 1.25), second = third, finer = count(third, 0.75);
  const double reached = 1.25 * first + second + 0.75 * finer;
  return cylinder_zone(radius,
                       {{1.25 * h, first}, {h, second}, {0.75 * h, finer}, {0.5 * h, count(n + outside - reached, 0.5)}});
}

ProblemModel build_cylinder_friction(const Values& v) {
  const double radius = v.number("R"), a = v.number("a"), E = v.number("E"), nu = v.number("nu");
  const double size = v.number("L") * a, ratio = v.number("ratio");
  const int n = v.count("n");
  if (a > 0.1 * radius) return unfit("a is above R/10: the formulas are for small contacts");
  if (size < 3 * a) return unfit("L is below 3");
  const double load = std::acos(-1.0) * a * a / (4 * radius) * E / (1 - nu * nu);
  if (n - 1 + v.number("edge") <= 0) return unfit("n=1 needs an edge above 0");
  if (n < 6 && v.word("sizes") != "equal") return unfit("n is below 6: too few elements for several sizes");
  const std::vector<double> zone = zone_of(radius, a / (n - 1 + v.number("edge")), n, v.word("sizes"));

  ProblemModel m;
  m.heading = {"A rigid cylinder (body 2) pressed on a half plane (body 1) with friction.",
               "Half of it is modelled; the half plane is a block of half width L a.",
               "R = " + show(radius) + ", P = " + show(load) + ": without friction the half width is " + show(a),
               "The middle sticks; c/a is that of a flat punch with the same mu and nu.",
               "Reference: D. A. Spence, 1975, superposition of punches"};
  m.title = "RIGID CYLINDER WITH FRICTION";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  m.friction = {v.number("mu")};
  m.bodies = {{E, nu, {0, 0}, {half_block({zone, size, ratio})}, "the half plane"},
              {E * v.number("rigid"),
               nu,
               {0, radius},
               {half_cylinder(zone, radius, ratio, traction(0, -load / (2 * radius)))},
               "the cylinder"}};
  m.zones = {contact(3, 0)};
  m.loads = {{v.count("steps"), 1.0}};
  return m;
}

} // namespace

Family cylinder_friction_family() {
  return {"cylinder_friction",
          "a rigid cylinder pressed on a half plane with friction or adhesion",
          {{"mu", Kind::kFriction, "0.4", "coefficient of friction; inf: adhesion"},
           {"R", Kind::kPositive, "100", "radius of the cylinder"},
           {"a", Kind::kPositive, "1", "half width of the contact without friction; gives the load"},
           {"E", Kind::kPositive, "1000", "Young's modulus of the half plane"},
           {"nu", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"rigid", Kind::kPositive, "1e5", "stiffness of the cylinder over that of the half plane"},
           {"n", Kind::kCount, "40", "elements over a, were they equal"},
           {"edge", Kind::kFraction, "0.5", "where a lies in the last of them, 0 to 1"},
           {"sizes", Kind::kChoice, "equal",
            "equal|jump|gradual: elements under the contact; jump: of 2.5 to 1 at two thirds of a"},
           {"steps", Kind::kCount, "1", "increments of the load"},
           {"L", Kind::kPositive, "1000", "half width and depth of the block, over a"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the contact"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_cylinder_friction};
}

} // namespace families
