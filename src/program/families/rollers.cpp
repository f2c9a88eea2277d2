// Cylinders between two platens, smooth: Hertz at both contacts of each.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

struct RollerSizes {
  std::vector<double> zone; // nodes of a contact, distances from its middle
  double radius, size, ratio, load;
  double edge() const { return std::asin(zone.back() / radius) * 180 / std::acos(-1.0); } // degrees
  double coarse() const { return radius / 6; }
  std::vector<double> angles() const {
    std::vector<double> out;
    for (const double x : zone) out.push_back(std::asin(x / radius));
    return out;
  }
};

// An arc outside the contacts, of so many degrees; fine at its ends where it meets one.
std::vector<double> outside(const RollerSizes& z, double degrees, bool from_zone, bool to_zone) {
  const double fine = last_size(z.zone);
  return graded(degrees * std::acos(-1.0) / 180 * z.radius, from_zone ? fine : 0, to_zone ? fine : 0, z.ratio, z.coarse());
}

// Right half of a cylinder that touches y = 0 and y = 2 R. Sides: 0 lower zone, 1 arc, 2 upper zone, 3 axis.
Outline half_roller(const RollerSizes& z) {
  const double R = z.radius, edge = z.edge(), fine = first_size(z.zone);
  Outline out({0, 0});
  out.arc({0, R}, R, -90, edge - 90, z.angles());
  out.arc({0, R}, R, edge - 90, 90 - edge, outside(z, 180 - 2 * edge, true, true));
  out.arc({0, R}, R, 90 - edge, 90, reversed(z.angles()));
  out.axis_x({0, 0}, graded(2 * R, fine, fine, z.ratio, z.coarse()));
  return out;
}

// How far the points at 45 degrees of a disc under two opposite forces move outwards: two wedges and a uniform tension.
double outwards(double load, double E, double nu) {
  const double pi = std::acos(-1.0), modulus = E / (1 - nu * nu), ratio = nu / (1 - nu);
  return load / (pi * modulus) * (std::sqrt(2.0) - (1 - ratio) * pi / 2);
}

// A whole one about x = at. Its contacts are smooth: what would let it roll is held at two points, which move as they would
// anyway, and so carry nothing. Sides: 0 lower zone, 1, 2, 3 right arc, 4 upper zone, 5 left arc.
Outline whole_roller(const RollerSizes& z, double at, double move) {
  const double R = z.radius, edge = z.edge(), w = z.zone.back();
  const Point centre{at, R};
  Outline out({at - w, R - R * std::cos(std::asin(w / R))});
  out.arc(centre, R, -90 - edge, edge - 90, mirrored(z.angles()));
  out.arc(centre, R, edge - 90, -45, outside(z, 45 - edge, true, false)).hold_x(move);
  out.arc(centre, R, -45, 45, outside(z, 90, false, false)).hold_x(move);
  out.arc(centre, R, 45, 90 - edge, outside(z, 45 - edge, false, true));
  out.arc(centre, R, 90 - edge, 90 + edge, mirrored(z.angles()));
  out.arc(centre, R, 90 + edge, 270 - edge, outside(z, 180 - 2 * edge, true, true));
  return out;
}

// The half plane above y = foot, pressed at its top. Sides: 0 zone, 1 surface, 2 right, 3 top, 4 axis.
Outline upper_block(const RollerSizes& z, double foot) {
  const double w = z.zone.back(), size = z.size, coarse = size / 4;
  Outline out({0, foot});
  out.line({w, foot}, z.zone);
  out.line({size, foot}, graded(size - w, last_size(z.zone), 0, z.ratio, coarse));
  out.line({size, foot + size}, graded(size, 0, 0, z.ratio, coarse));
  out.line({0, foot + size}, graded(size, 0, 0, z.ratio, coarse), traction(0, -z.load / (2 * size)));
  out.axis_x({0, foot}, graded(size, 0, first_size(z.zone), z.ratio, coarse));
  return out;
}

// A rigid platen with the surface y = `at`, which touches rollers at `places`: below the surface, or above. `zones`: the sides
// of the contacts in the order of the places.
Outline rigid_platen(const RollerSizes& z, double at, bool above, const std::vector<double>& places, std::vector<int>& zones) {
  const double w = z.zone.back(), end = places.back() + z.radius, way = above ? 1 : -1; // in x along the surface
  const int count = static_cast<int>(places.size());
  Outline out({-way * end, at});
  for (int i = 0; i < count; ++i) {
    const double x = places[static_cast<size_t>(above ? i : count - 1 - i)], from = out.nodes().back().at.x;
    out.line({x - way * w, at}, equal(std::fabs(x - from) - w, 4));
    out.line({x + way * w, at}, mirrored(z.zone));
  }
  out.line({way * end, at}, equal(1, 2));
  out.line({way * end, at + way * z.radius}, equal(1, 2));
  out.line({-way * end, at + way * z.radius}, equal(1, 2));
  out.line({-way * end, at}, equal(1, 2));
  zones.clear();
  for (int i = 0; i < count; ++i) zones.push_back(2 * (above ? i : count - 1 - i) + 1);
  return out;
}

void add_rigid(ProblemModel& m, const RollerSizes& z, int rollers, double pitch, double E, double nu) {
  std::vector<double> places;
  for (int i = 0; i < rollers; ++i) places.push_back((i - (rollers - 1) / 2.0) * pitch);
  std::vector<int> below, above;
  const Outline lower = rigid_platen(z, 0, false, places, below), upper = rigid_platen(z, 2 * z.radius, true, places, above);
  m.bodies.push_back({E, nu, {0, 0}, {lower}, "the lower platen", {RigidModel::kHeld}});
  for (int i = 0; i < rollers; ++i) {
    const size_t at = static_cast<size_t>(i);
    const Point centre{places[at], z.radius};
    m.bodies.push_back({E, nu, centre, {whole_roller(z, centre.x, outwards(z.load, E, nu))}, "roller " + show(i + 1)});
    m.zones.push_back({{0, below[at]}, {i + 1, 0}});
    m.zones.push_back({{rollers + 1, above[at]}, {i + 1, 4}});
  }
  const RigidModel pressed{RigidModel::kLoaded, {0, 2 * z.radius}, "Y", {{0, -z.load * rollers, 0}}};
  m.bodies.push_back({E, nu, {0, 0}, {upper}, "the upper platen", pressed});
}

void add_elastic(ProblemModel& m, const RollerSizes& z, const Values& v) {
  const double R = z.radius, E = v.number("E1"), nu = v.number("nu1");
  if (v.word("platens") == "cylinders") {
    Outline lower({0, -R}), upper({0, 2 * R});
    const std::vector<double> angles = z.angles(), rest = outside(z, 90 - z.edge(), true, false);
    const std::vector<double> flat = graded(R, 0, 0, z.ratio, z.coarse()),
                              axis = graded(R, first_size(z.zone), 0, z.ratio, z.coarse());
    lower.line({R, -R}, flat, roller_y());
    lower.arc({0, -R}, R, 0, 90 - z.edge(), reversed(rest));
    lower.arc({0, -R}, R, 90 - z.edge(), 90, reversed(angles));
    lower.axis_x({0, -R}, axis);
    upper.arc({0, 3 * R}, R, -90, z.edge() - 90, angles);
    upper.arc({0, 3 * R}, R, z.edge() - 90, 0, rest);
    upper.line({0, 3 * R}, flat, traction(0, -z.load / (2 * R)));
    upper.axis_x({0, 2 * R}, reversed(axis));
    m.bodies = {{E, nu, {0, -R}, {lower}, "the lower cylinder"},
                {v.number("E2"), v.number("nu2"), {0, R}, {half_roller(z)}, "the roller"},
                {E, nu, {0, 3 * R}, {upper}, "the upper cylinder"}};
    m.zones = {{{0, 2}, {1, 0}}, {{2, 0}, {1, 2}}};
    return;
  }
  m.bodies = {{E, nu, {0, 0}, {half_block({z.zone, z.size, z.ratio})}, "the lower platen"},
              {v.number("E2"), v.number("nu2"), {0, R}, {half_roller(z)}, "the roller"},
              {E, nu, {0, 2 * R}, {upper_block(z, 2 * R)}, "the upper platen"}};
  m.zones = {{{0, 3}, {1, 0}}, {{2, 0}, {1, 2}}};
}

ProblemModel build_rollers(const Values& v) {
  const double R = v.number("R"), a = v.number("a"), size = v.number("L") * a, pitch = v.number("pitch") * R;
  const int n = v.count("n"), rollers = v.count("rollers");
  const bool rigid = v.word("platens") == "rigid", cylinders = v.word("platens") == "cylinders";
  if (a > 0.1 * R) return unfit("a is above R/10: the formulas of Hertz are for small contacts");
  if (size < 3 * a) return unfit("L is below 3");
  if (rollers > 15) return unfit("rollers is above 15");
  if (rollers > 1 && !rigid) return unfit("platens is to be rigid for several rollers, which feel each other through others");
  if (pitch < 2.01 * R) return unfit("pitch is below 2.01: the rollers touch");
  const double own = (1 - std::pow(v.number("nu2"), 2)) / v.number("E2"),
               other = rigid ? 0.0 : (1 - std::pow(v.number("nu1"), 2)) / v.number("E1");
  const double curvature = cylinders ? 2 / R : 1 / R;
  const double load = std::acos(-1.0) * a * a / 4 * curvature / (own + other);
  const double h = a / (n - 1 + v.number("edge"));
  const RollerSizes z{cylinder_zone(R, {{h, n + (n + 3) / 4 + 2}}), R, size, v.number("ratio"), load};

  ProblemModel m;
  m.heading = {rigid ? show(rollers) + " smooth cylinders between two rigid platens, the upper one free to move down."
                     : "A smooth cylinder between two " + std::string(cylinders ? "cylinders." : "half planes."),
               std::string(rigid ? "" : "The half x >= 0 is modelled. ") + "R = " + show(R) + ", half width a = " + show(a),
               "P = " + show(load) + " per cylinder" + (rigid ? ", as all are pressed alike." : ""),
               "At both contacts p = p0 sqrt(1 - (x/a)^2), p0 = 2 P / (pi a) = " + show(2 * load / (std::acos(-1.0) * a)),
               "Reference: H. Hertz, 1882; K. L. Johnson, Contact Mechanics, chapter 4"};
  m.title = "ROLLERS, " + show(n) + " ELEMENTS OVER THE HALF WIDTH";
  m.function_nodes = v.count("order") + 1;
  m.images = !rigid;
  if (rigid)
    add_rigid(m, z, rollers, pitch, v.number("E2"), v.number("nu2"));
  else
    add_elastic(m, z, v);
  return m;
}

} // namespace

Family rollers_family() {
  return {
      "rollers",
      "cylinders between two platens, smooth: Hertz at both contacts of each",
      {{"rollers", Kind::kCount, "3", "how many, at most 15; between elastic platens one"},
       {"platens", Kind::kChoice, "rigid", "rigid|elastic|cylinders: elastic half planes, or cylinders like the one between"},
       {"R", Kind::kPositive, "100", "radius of the cylinders"},
       {"a", Kind::kPositive, "1", "half width of the contacts; gives the load"},
       {"pitch", Kind::kPositive, "2.5", "distance of the rollers, over R"},
       {"E1", Kind::kPositive, "1000", "Young's modulus of elastic platens"},
       {"nu1", Kind::kPoisson, "0.3", "their Poisson's ratio"},
       {"E2", Kind::kPositive, "1000", "Young's modulus of the rollers"},
       {"nu2", Kind::kPoisson, "0.3", "their Poisson's ratio"},
       {"n", Kind::kCount, "20", "elements over the half width"},
       {"edge", Kind::kFraction, "0.5", "where in its element the edge of the contact lies"},
       {"L", Kind::kPositive, "200", "half width and depth of half planes, over a"},
       {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the contact"},
       {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
      build_rollers};
}

} // namespace families
