// Two involute teeth, tied to rigid hubs on shafts: one turned by a moment, the other held.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace families {
namespace {

const double kPi = std::acos(-1.0);

// One gear about the origin, its tooth along +x; it pushes upwards, along the line that touches its base circle at the angle
// -pressure. `t`: how far from there the teeth touch.
struct Gear {
  double pitch, base, tip, root, pressure, t;
  int teeth;
  double touching() const { return t / base; } // roll angle there
  double first_roll() const { return std::max(0.1, std::sqrt(std::max(0.0, root * root / (base * base) - 1))); }
  double last_roll() const { return std::sqrt(tip * tip / (base * base) - 1); }
  // A point of the flank that works, at a roll angle.
  Point flank(double roll) const {
    const double at = -pressure - (roll - touching()), c = std::cos(at), s = std::sin(at);
    return {base * (c - roll * s), base * (s + roll * c)};
  }
  double direction(double roll) const {
    const Point p = flank(roll);
    return std::atan2(p.y, p.x);
  }
  // Of the tooth's middle: half a tooth from where the flank crosses the pitch circle.
  double middle() const { return direction(std::tan(pressure)) - kPi / (2 * teeth); }
};

Point mirrored_about(Point p, double direction) {
  const double c = std::cos(2 * direction), s = std::sin(2 * direction);
  return {p.x * c + p.y * s, p.x * s - p.y * c};
}
// Where a gear stands: at its centre, turned by half a turn or not.
struct Place {
  Point centre;
  bool half_turn;
  Point of(Point p) const { return half_turn ? Point{centre.x - p.x, centre.y - p.y} : Point{centre.x + p.x, centre.y + p.y}; }
};

struct Tooth {
  Outline tooth, hub;
};

// Sides of the tooth: 0 chord to the hub, 1 flank that does not work, 2 tip, 3 flank outside the zone, 4 zone, 5 flank inside;
// of the hub: 0 chord. `zone`: distances along the flank from where the teeth touch.
Tooth tooth_of(const Gear& g, const Place& place, const std::vector<double>& zone, double module, double ratio) {
  const double middle = g.middle(), coarse = module / 4, touch = g.touching(), w = zone.back(), fine = last_size(zone);
  const double first = g.first_roll(), last = g.last_roll();
  const auto length = [&](double roll) { return g.base * roll * roll / 2; }; // along an involute
  // On the working flank, so far from the touching point; without the loss of digits of a difference.
  const auto working = [&](double x) {
    return place.of(g.flank(touch + 2 * x / g.base / (touch + std::sqrt(touch * touch + 2 * x / g.base))));
  };
  const auto idle = [&](double s) {
    return place.of(mirrored_about(g.flank(std::sqrt(2 * (length(first) + s) / g.base)), middle));
  };
  // Below the involute the flank goes on along a radius.
  const Point start = g.flank(first);
  const double part = std::min(1.0, g.root / std::hypot(start.x, start.y));
  const Point low{start.x * part, start.y * part}, feet[2] = {place.of(low), place.of(mirrored_about(low, middle))};
  const double whole = length(last) - length(first), outer = length(last) - length(touch) - w,
               inner = length(touch) - length(first) - w;

  std::vector<Point> back, outside, contact, inside;
  if (part < 0.999) back.push_back(idle(0));
  for (const double s : equal(whole, std::max(4, static_cast<int>(whole / coarse + 0.5))))
    if (s > 0) back.push_back(idle(s));
  for (const double s : graded(outer, 0, fine, ratio, coarse))
    if (s > 0) outside.push_back(working(w + outer - s));
  for (const double s : mirrored(zone))
    if (s > 0) contact.push_back(working(w - s));
  for (const double s : graded(inner, fine, 0, ratio, coarse))
    if (s > 0) inside.push_back(working(-w - s));
  if (part < 0.999) inside.push_back(feet[0]);

  Outline tooth(feet[0]), hub(feet[1]);
  tooth.line(feet[1], equal(1, 6));
  tooth.path(back);
  tooth.line(working(w + outer), equal(1, 3));
  tooth.path(outside).path(contact).path(inside);
  hub.line(feet[0], equal(1, 6));
  hub.line(place.centre, equal(1, 2));
  hub.line(feet[1], equal(1, 2));
  return {tooth, hub};
}

// Two gears whose teeth touch at a place of the line of action.
struct GearPair {
  Gear A, B;
  double centres;
  bool reach; // do the teeth reach each other?
};

GearPair pair_of(const Values& v) {
  const double module = v.number("m"), pressure = v.number("angle") * kPi / 180;
  const auto gear = [&](int teeth) {
    const double r = module * teeth / 2;
    return Gear{r, r * std::cos(pressure), r + module, r - 1.25 * module, pressure, 0, teeth};
  };
  GearPair out{gear(v.count("zA")), gear(v.count("zB")), 0, false};
  Gear &A = out.A, &B = out.B;
  out.centres = A.pitch + B.pitch;
  const double line = out.centres * std::sin(pressure);
  // The line of action, as far as both flanks reach and a little within.
  const double room = 0.15 * module;
  const double from = std::max(A.base * A.first_roll(), line - B.base * B.last_roll()) + room;
  const double to = line - std::max(B.base * B.first_roll(), line - A.base * A.last_roll()) - room;
  A.t = from + v.number("at") * (to - from), B.t = line - A.t;
  out.reach = from < to;
  return out;
}

std::vector<std::string> heading_of(const Values& v, const GearPair& pair, double load, double a) {
  return {"Two involute teeth (bodies 1 and 2), smooth, tied to rigid hubs (3 and 4).",
          show(v.count("zA")) + " teeth drive " + show(v.count("zB")) + "; module " + show(v.number("m")) +
              ", pressure angle " + show(v.number("angle")) + " degrees.",
          "Hub 3 turns about (0, 0) under the moment " + show(load * pair.A.base) + "; hub 4, about (" + show(pair.centres) +
              ", 0), is held.",
          "The moment that holds it is zB / zA times as large, " + show(load * pair.B.base) + ", wherever the teeth touch.",
          "Tooth force P = " + show(load) + ", Hertz's half width " + show(a) + ", p0 = " + show(2 * load / (kPi * a)),
          "Reference: law of gearing; H. Hertz, 1882"};
}

ProblemModel build(const Values& v) {
  const int zA = v.count("zA"), zB = v.count("zB"), n = v.count("n");
  const double module = v.number("m"), angle = v.number("angle"), ratio = v.number("ratio");
  const double a = v.number("a") * module, E = v.number("E"), nu = v.number("nu");
  if (zA < 12 || zB < 12 || zA > 200 || zB > 200) return unfit("zA and zB are to be from 12 to 200");
  if (angle < 10 || angle > 30) return unfit("angle is to be from 10 to 30 degrees");
  if (a > 0.02 * module) return unfit("a is above 0.02: the teeth are to touch in a narrow contact");
  const GearPair pair = pair_of(v);
  if (!pair.reach) return unfit("these teeth do not reach each other");
  const double curvature = 1 / pair.A.t + 1 / pair.B.t, load = kPi * a * a / 4 * curvature * E / (2 * (1 - nu * nu));
  const double h = a / (n - 0.5);
  const std::vector<double> zone = equal((n + 5) * h, n + 5);
  const Place left{{0, 0}, false}, right{{pair.centres, 0}, true};
  const Tooth one = tooth_of(pair.A, left, zone, module, ratio), other = tooth_of(pair.B, right, zone, module, ratio);
  const Point touching = left.of(pair.A.flank(pair.A.touching()));

  ProblemModel m;
  m.heading = heading_of(v, pair, load, a);
  m.title = "GEAR PAIR";
  m.function_nodes = v.count("order") + 1;
  const RigidModel driven{RigidModel::kLoaded, {0, 0}, "TURN", {{0, 0, load * pair.A.base}}};
  m.bodies = {{E, nu, touching, {one.tooth}, "the tooth that drives"},
              {E, nu, touching, {other.tooth}, "the tooth that is driven"},
              {E, nu, {0, 0}, {one.hub}, "the hub that drives", driven},
              {E, nu, right.centre, {other.hub}, "the hub that is driven", {RigidModel::kHeld}}};
  const ContactZone teeth{{0, 4}, {1, 4}};
  m.zones = {teeth, tie({2, 0}, {0, 0}), tie({3, 0}, {1, 0})};
  return m;
}

} // namespace

Family gear_family() {
  return {"gear",
          "two involute teeth on rigid hubs, one turned by a moment: the law of gearing",
          {{"zA", Kind::kCount, "20", "teeth of the gear that drives"},
           {"zB", Kind::kCount, "30", "teeth of the gear that is driven"},
           {"m", Kind::kPositive, "1", "module: pitch diameter over the number of teeth"},
           {"angle", Kind::kPositive, "20", "pressure angle, degrees"},
           {"at", Kind::kFraction, "0.5", "where the teeth touch along the line of action"},
           {"a", Kind::kPositive, "1e-3", "half width of the contact, over m; gives the moment"},
           {"E", Kind::kPositive, "1000", "Young's modulus of both"},
           {"nu", Kind::kPoisson, "0.3", "Poisson's ratio of both"},
           {"n", Kind::kCount, "10", "elements over the half width"},
           {"ratio", Kind::kPositive, "1.5", "growth of the elements away from the contact"},
           {"order", Kind::kOrder, "1", "of the functions: 1 linear, 2 quadratic, 3 cubic"}},
          build};
}

} // namespace families
