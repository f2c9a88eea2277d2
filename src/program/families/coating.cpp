// A cylinder pressed on a layer that is bonded to a half plane.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

// The layer from y = -t to 0. Sides: 0 bond, 1 right, 2 surface outside the zone, 3 zone, 4 axis.
Outline layer(const std::vector<double>& zone, const std::vector<double>& bond, double thickness, double size, double ratio,
              double coarse) {
  const double w = zone.back();
  Outline out({0, -thickness});
  out.line({size, -thickness}, bond);
  out.line({size, 0}, graded(thickness, 0, 0, ratio, thickness / 2));
  out.line({w, 0}, graded(size - w, 0, last_size(zone), ratio, coarse));
  out.line({0, 0}, reversed(zone));
  out.axis_x({0, -thickness}, graded(thickness, first_size(zone), first_size(bond), ratio, thickness / 4));
  return out;
}

// The half plane below it. Sides: 0 foot, 1 right, 2 bond, 3 axis.
Outline substrate(const std::vector<double>& bond, double top, double size, double ratio) {
  const double foot = top - size, coarse = size / 4;
  Outline out({0, foot});
  out.line({size, foot}, graded(size, 0, 0, ratio, coarse), roller_y());
  out.line({size, top}, graded(size, 0, last_size(bond), ratio, coarse));
  out.line({0, top}, reversed(bond));
  out.axis_x({0, foot}, graded(size, first_size(bond), 0, ratio, coarse));
  return out;
}

// Nodes of the bond from the axis: equal elements of about a size below the contact, and then ever larger ones.
std::vector<double> bond_nodes(double near, double fine, double size, double ratio, double coarse) {
  std::vector<double> out = equal(near, std::max(1, static_cast<int>(near / fine + 0.5)));
  for (const double s : graded(size - near, fine, 0, ratio, coarse))
    if (s > 0) out.push_back(near + s);
  return out;
}

ProblemModel build_coating(const Values& v) {
  const double R = v.number("R"), a = v.number("a"), size = v.number("L") * a, thickness = v.number("t") * a;
  const double ratio = v.number("ratio");
  const int n = v.count("n");
  if (a > 0.1 * R) return unfit("a is above R/10: the formulas of Hertz are for small contacts");
  if (size < 3 * a) return unfit("L is below 3");
  if (thickness < 0.1 * a) return unfit("t is below 0.1");
  const double compliance =
      (1 - std::pow(v.number("nu1"), 2)) / v.number("E1") + (1 - std::pow(v.number("nu3"), 2)) / v.number("E3");
  const double load = std::acos(-1.0) * a * a / (4 * R * compliance);
  const double h = a / (n - 1 + v.number("edge"));
  const std::vector<double> zone = cylinder_zone(R, {{h, n + (n + 3) / 4 + 2}});
  const double fine = std::max(h, 2 * thickness / n), near = 2 * (a + thickness), coarse = std::min(size / 4, 5 * thickness);
  if (near > size / 2) return unfit("L is below four times 1 + t");
  const bool free = v.word("bond") == "free";
  const std::vector<double> below = bond_nodes(near, fine, size, ratio, coarse),
                            above = free ? bond_nodes(near, 1.4 * fine, size, ratio, coarse) : below;

  ProblemModel m;
  m.heading = {"A cylinder (body 3) pressed on a layer (body 2) that is bonded to a half plane (body 1), smooth.",
               "The half x >= 0 is modelled; the half plane is a block of half width and depth L a.",
               "R = " + show(R) + ", thickness t = " + show(thickness) + ", load P = " + show(load) + " per unit thickness",
               "E2 = E1 and nu2 = nu1: the layer is part of the half plane, p = p0 sqrt(1 - (x/a)^2) with",
               "a = " + show(a) + ", p0 = 2 P / (pi a) = " + show(2 * load / (std::acos(-1.0) * a)) +
                   ". A stiffer layer makes a narrower contact.",
               "Reference: H. Hertz, 1882; for other layers K. L. Johnson, Contact Mechanics, section 5.8"};
  m.title = "COATING, " + show(n) + " ELEMENTS OVER THE HALF WIDTH";
  m.function_nodes = v.count("order") + 1;
  m.images = true;
  m.bodies = {
      {v.number("E1"), v.number("nu1"), {0, 0}, {substrate(below, -thickness, size, ratio)}, "the half plane"},
      {v.number("E2"), v.number("nu2"), {0, 0}, {layer(zone, above, thickness, size, ratio, coarse)}, "the layer"},
      {v.number("E3"), v.number("nu3"), {0, R}, {half_cylinder(zone, R, ratio, traction(0, -load / (2 * R)))}, "the cylinder"}};
  const ContactZone pressed{{1, 3}, {2, 0}};
  m.zones = {pressed, tie({0, 2}, {1, 0}, free)};
  return m;
}

} // namespace

Family coating_family() {
  return {"coating",
          "a cylinder pressed on a layer that is bonded to a half plane, smooth",
          {{"R", Kind::kPositive, "100", "radius of the cylinder"},
           {"a", Kind::kPositive, "1", "half width of the contact without a layer; gives the load"},
           {"t", Kind::kPositive, "1", "thickness of the layer, over a"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the half plane"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "1000", "Young's modulus of the layer"},
           {"nu2", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E3", Kind::kPositive, "1000", "Young's modulus of the cylinder"},
           {"nu3", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"bond", Kind::kChoice, "matching", "matching|free: whether the meshes match at the bond"},
           {"n", Kind::kCount, "20", "elements over a"},
           {"edge", Kind::kFraction, "0.5", "where in its element a lies"},
           {"L", Kind::kPositive, "200", "half width and depth of the block, over a"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the contact"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_coating};
}

} // namespace families
