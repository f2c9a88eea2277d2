// Rollers between a shaft and a ring, without clearance: how they share the load.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <cmath>

namespace families {
namespace {

const double kPi = std::acos(-1.0);

// Nodes of a contact with one of the races: angles from its middle.
struct Contact {
  std::vector<double> roller, race; // about the roller's centre, about the shaft's
  double at_roller() const { return roller.back() * 180 / kPi; }
  double at_race() const { return race.back() * 180 / kPi; }
};

struct BearingSizes {
  double radius, shaft, bore, depth; // of the rollers, of the races, of the ring
  double pitch, ratio, load;         // the load: on the half
  Contact inner, outer;
  std::vector<double> places; // degrees from where the load points, of the rollers it presses
  double middle() const { return shaft + radius; }
};

Contact contact_of(const std::vector<double>& x, double radius, double race) {
  Contact out;
  for (const double at : x) out.roller.push_back(std::asin(at / radius)), out.race.push_back(std::asin(at / race));
  return out;
}

// Elements of a surface of a radius over so many degrees, fine where it goes on as a contact.
std::vector<double> beside(const BearingSizes& z, double radius, double degrees, double from, double to) {
  return graded(degrees * kPi / 180 * radius, from, to, z.ratio, radius / 6);
}

// Right half of a race, from its lowest point upwards; sides[i]: that of roller i. `downwards`: the other way.
void add_race(Outline& out, const BearingSizes& z, const Contact& c, double radius, bool downwards, std::vector<int>& sides) {
  const double fine = radius * (c.race.back() - c.race[c.race.size() - 2]), edge = c.at_race();
  struct Part {
    double from, to;
    std::vector<double> s;
    int roller;
  };
  std::vector<Part> parts;
  double reached = 0;
  for (size_t i = 0; i < z.places.size(); ++i) {
    const double at = z.places[i];
    if (at > 0) parts.push_back({reached, at - edge, beside(z, radius, at - edge - reached, reached > 0 ? fine : 0, fine), -1});
    parts.push_back({at > 0 ? at - edge : 0, at + edge, at > 0 ? mirrored(c.race) : c.race, static_cast<int>(i)});
    reached = at + edge;
  }
  parts.push_back({reached, 180, beside(z, radius, 180 - reached, fine, 0), -1});
  sides.assign(z.places.size(), 0);
  const int before = static_cast<int>(out.sides().size()), count = static_cast<int>(parts.size());
  for (int k = 0; k < count; ++k) {
    const Part& p = parts[static_cast<size_t>(downwards ? count - 1 - k : k)];
    if (p.roller >= 0) sides[static_cast<size_t>(p.roller)] = before + k;
    out.arc({0, 0}, radius, (downwards ? p.to : p.from) - 90, (downwards ? p.from : p.to) - 90,
            downwards ? reversed(p.s) : p.s);
  }
}

// Right half of the roller under the load. Sides: 0 ring, 1 arc, 2 shaft, 3 axis.
Outline half_roller(const BearingSizes& z) {
  const double r = z.radius, low = -z.middle() - r;
  const double fine[2] = {r * last_size(z.outer.roller), r * last_size(z.inner.roller)};
  const double from = z.outer.at_roller() - 90, to = 90 - z.inner.at_roller();
  Outline out({0, low});
  out.arc({0, low + r}, r, -90, from, z.outer.roller);
  out.arc({0, low + r}, r, from, to, beside(z, r, to - from, fine[0], fine[1]));
  out.arc({0, low + r}, r, to, 90, reversed(z.inner.roller));
  out.axis_x({0, low}, graded(2 * r, r * first_size(z.inner.roller), r * first_size(z.outer.roller), z.ratio, r / 6));
  return out;
}

// A whole one. Its contacts are smooth: that it neither rolls nor turns is left to two points on one side, which carry
// nothing. Sides: 0 ring, 1, 2, 3 arc, 4 shaft, 5 arc.
Outline whole_roller(const BearingSizes& z, double place) {
  const double r = z.radius, way = place - 90, out_edge = z.outer.at_roller(), in_edge = z.inner.at_roller();
  const double fine[2] = {r * last_size(z.outer.roller), r * last_size(z.inner.roller)};
  const Point centre{z.middle() * std::cos(way * kPi / 180), z.middle() * std::sin(way * kPi / 180)};
  const double start = (way - out_edge) * kPi / 180;
  Outline out({centre.x + r * std::cos(start), centre.y + r * std::sin(start)});
  const auto hold = [&] { place <= 45 ? out.hold_x() : out.hold_y(); };
  out.arc(centre, r, way - out_edge, way + out_edge, mirrored(z.outer.roller));
  out.arc(centre, r, way + out_edge, way + 45, beside(z, r, 45 - out_edge, fine[0], 0));
  hold();
  out.arc(centre, r, way + 45, way + 135, beside(z, r, 90, 0, 0));
  hold();
  out.arc(centre, r, way + 135, way + 180 - in_edge, beside(z, r, 45 - in_edge, 0, fine[1]));
  out.arc(centre, r, way + 180 - in_edge, way + 180 + in_edge, mirrored(z.inner.roller));
  out.arc(centre, r, way + 180 + in_edge, way + 360 - out_edge, beside(z, r, 180 - in_edge - out_edge, fine[1], fine[0]));
  return out;
}

void add_bodies(ProblemModel& m, const BearingSizes& z, const Values& v, bool rigid) {
  std::vector<int> inner, outer;
  Outline shaft({0, -z.shaft}), ring({0, -z.depth});
  add_race(shaft, z, z.inner, z.shaft, false, inner);
  shaft.axis_x({0, -z.shaft}, graded(2 * z.shaft, 0, z.shaft * first_size(z.inner.race), z.ratio, z.shaft / 6));
  const std::vector<double> thick = graded(z.depth - z.bore, 0, z.bore * first_size(z.outer.race), z.ratio, z.bore / 6);
  ring.arc({0, 0}, z.depth, -90, 90, equal(1, 24), rigid ? free_side() : clamped());
  ring.axis_x({0, z.bore}, thick);
  add_race(ring, z, z.outer, z.bore, true, outer);
  ring.axis_x({0, -z.depth}, reversed(thick));
  const double E = v.number("E1"), nu = v.number("nu1");
  m.bodies = {{E, nu, {0, 0}, {shaft}, "the shaft"}, {E, nu, {0, 0}, {ring}, "the ring"}};
  if (rigid) {
    m.bodies[0].rigid = {RigidModel::kLoaded, {0, 0}, "Y", {{0, -z.load, 0}}};
    m.bodies[1].rigid.kind = RigidModel::kHeld;
  } else {
    m.keywords.push_back("*BODY FORCE 1 1 0 -" + show(2 * z.load / (kPi * z.shaft * z.shaft)));
  }
  for (size_t i = 0; i < z.places.size(); ++i) {
    const double at = z.places[i], way = (at - 90) * kPi / 180;
    const Point centre{at > 0 ? z.middle() * std::cos(way) : 0, z.middle() * std::sin(way)};
    const int body = static_cast<int>(m.bodies.size());
    m.bodies.push_back({v.number("E2"),
                        v.number("nu2"),
                        centre,
                        {at > 0 ? whole_roller(z, at) : half_roller(z)},
                        "the roller at " + show(at) + " degrees"});
    m.zones.push_back({{0, inner[i]}, {body, at > 0 ? 4 : 2}});
    m.zones.push_back({{1, outer[i]}, {body, 0}});
  }
}

ProblemModel build_bearing(const Values& v) {
  const int rollers = v.count("Z"), n = v.count("n");
  const bool rigid = v.word("rings") == "rigid", between = v.word("place") == "between";
  const double r = v.number("r"), a = v.number("a"), shaft = v.number("R") * r, bore = shaft + 2 * r;
  if (rollers < 5 || rollers > 60) return unfit("Z is not from 5 to 60");
  if (2 * r > 0.98 * 2 * (shaft + r) * std::sin(kPi / rollers))
    return unfit("Z is so large, or R so small, that rollers touch");
  if (a > 0.05 * r) return unfit("a is above r/20: the formulas of Hertz are for small contacts");
  const double narrow = 1 / (1 / r + 1 / shaft), wide = 1 / (1 / r - 1 / bore); // relative radii
  const double own = (1 - std::pow(v.number("nu2"), 2)) / v.number("E2"),
               other = rigid ? 0 : (1 - std::pow(v.number("nu1"), 2)) / v.number("E1");
  const double most = kPi * a * a / (4 * narrow) / (own + other); // force on the roller whose inner contact is 2 a wide
  BearingSizes z{r, shaft, bore, v.number("depth") * bore, 360.0 / rollers, v.number("ratio"), most * rollers / 8, {}, {}, {}};
  const double h = a / (n - 1 + v.number("edge")), wider = std::sqrt(wide / narrow);
  const int elements = n + (n + 3) / 4 + 2;
  z.inner = contact_of(cylinder_zone(r, {{h, elements}}), r, shaft);
  z.outer = contact_of(cylinder_zone(r, {{h * wider, elements}}), r, bore);
  for (double at = between ? z.pitch / 2 : 0; at < 90 - 1e-9; at += z.pitch) z.places.push_back(at);

  ProblemModel m;
  m.heading = {show(rollers) + " smooth rollers without clearance between a shaft, which is pressed down, and a ring, both " +
                   (rigid ? "rigid." : "elastic."),
               "The half x >= 0 is modelled, with the rollers below the middle: the others carry nothing and are left out.",
               "Load of both halves P = " + show(2 * z.load) + ", rollers of radius " + show(r) + " between radii " +
                   show(shaft) + " and " + show(bore),
               "Between rigid rings a roller gives way by Q (1 - nu^2) / (pi E) (2 ln(4 r/a1) + 2 ln(4 r/a2) - 2),",
               "a1, a2 the half widths of its contacts, and by D cos(psi) at the angle psi from the load.",
               "With Q ~ D^1.11 and many rollers the largest Q is 4.08 P/Z, with Q ~ D it is 4 P/Z.",
               "Reference: K. L. Johnson, Contact Mechanics, eq. (5.57); R. Stribeck, 1901"};
  m.title = "BEARING, " + show(n) + " ELEMENTS OVER THE HALF WIDTH";
  m.function_nodes = v.count("order") + 1;
  m.images = true;
  add_bodies(m, z, v, rigid);
  return m;
}

} // namespace

Family bearing_family() {
  return {"bearing",
          "rollers without clearance between a shaft and a ring: how they share the load",
          {{"Z", Kind::kCount, "12", "number of rollers all round, 5 to 60"},
           {"place", Kind::kChoice, "under", "under|between: a roller where the load points, or two beside it"},
           {"rings", Kind::kChoice, "rigid", "rigid|elastic: shaft and ring"},
           {"r", Kind::kPositive, "1", "radius of the rollers"},
           {"R", Kind::kPositive, "5", "radius of the shaft, over r"},
           {"a", Kind::kPositive, "0.005", "half width of the contact of a roller with 4 P/Z and the shaft; gives the load"},
           {"depth", Kind::kPositive, "2", "outer radius of the ring, over its bore"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of elastic rings"},
           {"nu1", Kind::kPoisson, "0.3", "their Poisson's ratio"},
           {"E2", Kind::kPositive, "1000", "Young's modulus of the rollers"},
           {"nu2", Kind::kPoisson, "0.3", "their Poisson's ratio"},
           {"n", Kind::kCount, "8", "elements over the half width"},
           {"edge", Kind::kFraction, "0.5", "where in its element the edge of that contact lies"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the contacts"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build_bearing};
}

} // namespace families
