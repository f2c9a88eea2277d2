#include "revolved_bodies.hpp"

#include "../dice.hpp"
#include "../interrupted.hpp"
#include "judged_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace random_decks {

using namespace many;
using Rings = many::Model;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr size_t kPlaces = 4; // at which a run is ended and resumed

struct Place { // a side of a body
  int32_t body = 0, side = 0;
};

struct Draft {
  Dice dice;
  Rings m;
  std::string name;
  int32_t element_nodes = 2;
  bool may_bend = true;      // all faces that meet may be bent alike
  double size = 1;           // of lengths
  Place base, top;           // where the model is supported, and loaded
  std::vector<Place> around; // sides that nothing else uses
  explicit Draft(uint64_t seed) : dice(seed) {}
};

// ---- sections

// Along the corners from the inner end of the lower face to that of the upper one: an open curve if they lie on the axis;
// else the last corner's elements are those of the bore.
Body section(Draft& a, const std::vector<Corner>& corners) {
  Body b;
  b.element_nodes = a.element_nodes;
  const bool open = corners.front().x == 0;
  const int32_t per = b.element_nodes - 1;
  for (size_t i = 0; i + (open ? 1 : 0) < corners.size(); ++i) {
    const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const int32_t first = b.sides.empty() ? 1 : b.sides.back().last + 1, steps = from.elements * per;
    for (int32_t k = 0; k < steps; ++k)
      b.xy.insert(b.xy.end(), {from.x + (to.x - from.x) * k / steps, from.y + (to.y - from.y) * k / steps});
    b.sides.push_back({first, first + from.elements - 1});
  }
  if (open) b.xy.insert(b.xy.end(), {corners.back().x, corners.back().y});
  b.open_regions = open ? 1 : 0;
  b.regions.push_back({1, b.sides.back().last});
  Dice& d = a.dice;
  b.youngs_modulus = d.chance(0.5) ? 1000 : d.power(2, 5);
  b.poisson_ratio = d.chance(0.3) ? 0.3 : d.chance(0.15) ? 0.5 : d.chance(0.15) ? 0 : d.between(-0.3, 0.49);
  return b;
}

// Moves a straight face of a body away from what it meets, with the square of the distance from a point of the face.
void crown(Body& b, int32_t side, double depth, double middle) {
  const Range r = b.sides[static_cast<size_t>(side - 1)];
  const size_t per = static_cast<size_t>(b.element_nodes - 1), first = static_cast<size_t>(r.first - 1) * per,
               count = static_cast<size_t>(r.last - r.first + 1) * per, points = b.xy.size() / 2;
  const auto at = [&](size_t i) { return 2 * ((first + i) % points); };
  const double x0 = b.xy[at(0)], y0 = b.xy[at(0) + 1], dx = b.xy[at(count)] - x0, dy = b.xy[at(count) + 1] - y0,
               length = std::hypot(dx, dy);
  for (size_t i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(count) - middle, lift = depth * s * s;
    b.xy[at(i)] -= lift * dy / length, b.xy[at(i) + 1] += lift * dx / length;
  }
}

// ---- how bodies meet

struct Meeting {
  int32_t kind, one, other; // elements on the two sides
};
Meeting some_meeting(Dice& d, double ties = 0.25) {
  Meeting z;
  z.kind = d.chance(0.5) ? C2D_ZONE_MATCHING : C2D_ZONE_FREE;
  z.one = d.whole(2, 6);
  z.other = z.kind == C2D_ZONE_MATCHING ? z.one : d.whole(2, 6);
  if (d.chance(ties)) z.kind += C2D_ZONE_TIED;
  return z;
}

// The second side's face is crowned if it may be: gaps that close.
void meet(Draft& a, const Meeting& z, Place one, Place two, double crowns = 0.3) {
  Dice& d = a.dice;
  if ((z.kind & C2D_ZONE_FREE) != 0) a.may_bend = false;
  const bool tied = (z.kind & C2D_ZONE_TIED) != 0;
  if (!tied && d.chance(crowns)) {
    crown(a.m.body(two.body), two.side, a.size * d.power(-4, -1.3), d.chance(0.5) ? 0.5 : d.between(0, 1));
    a.name += ", crowned";
  }
  const int32_t zone = a.m.join(z.kind, one.body, one.side, two.body, two.side);
  if (d.chance(0.4)) a.m.zones[static_cast<size_t>(zone - 1)].mu = d.chance(0.2) ? 0 : d.between(0.05, 0.9);
}

// ---- scenes

struct Span { // of radii, or of heights along the axis
  double from, to;
};
Span common(Span a, Span b) { return {std::max(a.from, b.from), std::min(a.to, b.to)}; }

// A side in three pieces, of which the middle one meets something. False: there is no such piece.
void cut_side(std::vector<Corner>& corners, double x0, double y0, double x1, double y1, Span meets, int32_t elements) {
  const double length = std::hypot(x1 - x0, y1 - y0);
  const auto at = [&](double s, int32_t n) {
    corners.push_back({x0 + (x1 - x0) * s / length, y0 + (y1 - y0) * s / length, n});
  };
  if (meets.from > 0) at(0, 2);
  at(meets.from, elements);
  if (meets.to < length) at(meets.to, 2);
}

struct Sides { // of a rectangular section
  int32_t number, lower, outer, upper;
};

// The section of these radii from z0 to z1, whose lower and upper faces meet others in part.
Sides add_rectangle(Draft& a, Span r, double z0, double z1, Span lower, int32_t lower_elements, Span upper,
                    int32_t upper_elements) {
  Dice& d = a.dice;
  std::vector<Corner> corners;
  Sides out;
  cut_side(corners, r.from, z0, r.to, z0, {lower.from - r.from, lower.to - r.from}, lower_elements);
  out.lower = lower.from > r.from ? 2 : 1;
  corners.push_back({r.to, z0, d.whole(2, 4)});
  out.outer = static_cast<int32_t>(corners.size());
  cut_side(corners, r.to, z1, r.from, z1, {r.to - upper.to, r.to - upper.from}, upper_elements);
  out.upper = out.outer + (upper.to < r.to ? 2 : 1);
  corners.push_back({r.from, z1, d.whole(2, 4)});
  out.number = a.m.add(section(a, corners));
  return out;
}

double some_radius(Dice& d) { return d.chance(0.6) ? 0 : d.power(-0.5, 2); } // of the inner side; 0: the axis

// Discs and rings on each other.
void pile(Draft& a) {
  Dice& d = a.dice;
  const size_t bodies = static_cast<size_t>(d.whole(2, 3));
  const double from = some_radius(d);
  std::vector<Span> r;
  for (size_t i = 0; i < bodies; ++i)
    r.push_back({from + (d.chance(0.6) ? 0 : d.between(0.1, 0.5)), from + (d.chance(0.6) ? 2 : d.between(1.2, 1.9))});
  Meeting below = {0, d.whole(2, 5), d.whole(2, 5)};
  double z = 0;
  Sides before = {0, 0, 0, 0};
  for (size_t i = 0; i < bodies; ++i) {
    const double h = d.between(0.4, 2);
    const Meeting above = some_meeting(d);
    const Sides now = add_rectangle(a, r[i], z, z + h, i > 0 ? common(r[i - 1], r[i]) : r[i], below.other,
                                    i + 1 < bodies ? common(r[i], r[i + 1]) : r[i], above.one);
    if (i > 0)
      meet(a, below, {before.number, before.upper}, {now.number, now.lower});
    else
      a.base = {now.number, now.lower};
    a.around.push_back({now.number, now.outer});
    a.top = {now.number, now.upper};
    below = above, before = now, z += h;
  }
}

// A hub on a shaft, which it overlaps in part of the draws. Below its bore it has a chamfer.
void hub(Draft& a) {
  Dice& d = a.dice;
  const double bore = some_radius(d), r = bore + d.between(0.6, 2), wall = d.between(0.4, 2), length = d.between(0.5, 2.5);
  const bool press = d.chance(0.6);
  const double overlap = press ? d.power(-4, -2.3) * (r - bore) : 0, below = d.chance(0.3) ? 0 : d.between(0.3, 1),
               above = d.between(0.3, 1);
  const Meeting z = some_meeting(d, press ? 0 : 0.25);
  std::vector<Corner> shaft = {{bore, -below, d.whole(2, 4)}};
  cut_side(shaft, r + overlap, -below, r + overlap, length + above, {below, below + length}, z.one);
  shaft.push_back({r + overlap, length + above, d.whole(2, 4)});
  shaft.push_back({bore, length + above, d.whole(2, 4)});
  a.m.add(section(a, shaft));
  a.m.add(section(a, {{r + 0.1, -0.1, d.whole(2, 4)},
                      {r + wall, -0.1, d.whole(2, 5)},
                      {r + wall, length, d.whole(2, 4)},
                      {r, length, z.other},
                      {r, 0, 2}}));
  if (press) a.m.interference = 1, a.name += ", pressed on";
  meet(a, z, {1, below > 0 ? 3 : 2}, {2, 4}, press ? 0 : 0.3);
  a.may_bend = false;
  a.base = {2, 1}, a.top = {1, static_cast<int32_t>(shaft.size()) - 1};
  a.around.push_back({2, 2});
}

// A plug in a conical seat, below which is a bore.
void seat(Draft& a) {
  Dice& d = a.dice;
  const double bore = some_radius(d), narrow = bore + d.between(0.5, 1.5), wide = narrow + d.between(0.1, 1.5),
               h = d.between(0.5, 1.5), wall = d.between(0.4, 1.5), above = d.between(0.2, 1);
  const Meeting z = some_meeting(d, 0.15);
  a.m.add(section(a, {{narrow, -0.3, d.whole(2, 4)},
                      {wide + wall, -0.3, d.whole(2, 4)},
                      {wide + wall, h, d.whole(2, 4)},
                      {wide, h, z.one},
                      {narrow, 0, 2}}));
  a.m.add(section(a, {{bore, 0, d.whole(2, 4)},
                      {narrow, 0, z.other},
                      {wide, h, d.whole(1, 2)},
                      {wide, h + above, d.whole(2, 4)},
                      {bore, h + above, d.whole(2, 4)}}));
  meet(a, z, {1, 4}, {2, 2});
  a.may_bend = false;
  a.base = {1, 1}, a.top = {2, 4};
  a.around.push_back({1, 2});
}

// A plate on two rings, or on a ring and a disc.
void plate(Draft& a) {
  Dice& d = a.dice;
  const double from = some_radius(d), r1 = from + d.between(0.5, 1.2), r2 = r1 + d.between(0.3, 1.2),
               r3 = r2 + d.between(0.4, 1), h = d.between(0.4, 1.5), thick = d.between(0.3, 1);
  const Meeting one = some_meeting(d), two = some_meeting(d);
  const auto foot = [&](Span r, const Meeting& z) { return add_rectangle(a, r, 0, h, r, d.whole(2, 4), r, z.one); };
  const Sides inner = foot({from, r1}, one), outer = foot({r2, r3}, two);
  const int32_t number = a.m.add(section(a, {{from, h, one.other},
                                             {r1, h, d.whole(2, 4)},
                                             {r2, h, two.other},
                                             {r3, h, 2},
                                             {r3, h + thick, d.whole(3, 5)},
                                             {from, h + thick, 2}}));
  meet(a, one, {inner.number, inner.upper}, {number, 1}, 0);
  meet(a, two, {outer.number, outer.upper}, {number, 3}, 0);
  a.base = {inner.number, inner.lower}, a.top = {number, 5};
  a.around = {{number, 4}, {outer.number, outer.outer}};
}

// A ring of round section between two plates.
void o_ring(Draft& a) {
  Dice& d = a.dice;
  const double from = some_radius(d), r = 0.5, middle = from + d.between(0.8, 1.5), to = middle + d.between(0.8, 1.2), h = 0.7;
  const int32_t faces[2] = {2 * d.whole(2, 4), 2 * d.whole(2, 4)}, arcs[2] = {2 * d.whole(2, 4), 2 * d.whole(2, 4)};
  const double half = d.between(0.25, 0.6); // of the arcs, in right angles
  const Sides lower = add_rectangle(a, {from, to}, -h, 0, {from, to}, 3, {middle - 0.45, middle + 0.45}, faces[0]);
  Body ring;
  ring.element_nodes = 3;
  const double ends[5] = {-1 - half, -1 + half, 1 - half, 1 + half, 3 - half};
  const int32_t counts[4] = {arcs[0], d.whole(2, 5), arcs[1], d.whole(2, 5)};
  for (int side = 0; side < 4; ++side) {
    const int32_t first = ring.sides.empty() ? 1 : ring.sides.back().last + 1, n = 2 * counts[side];
    for (int32_t k = 0; k < n; ++k) {
      const double f = kPi / 2 * (ends[side] + (ends[side + 1] - ends[side]) * k / n);
      ring.xy.insert(ring.xy.end(), {middle + r * std::cos(f), r + r * std::sin(f)});
    }
    ring.sides.push_back({first, first + counts[side] - 1});
  }
  ring.regions.push_back({1, ring.sides.back().last});
  ring.poisson_ratio = d.chance(0.5) ? 0.49 : 0.5, ring.youngs_modulus = d.power(0, 3);
  const int32_t number = a.m.add(ring);
  a.m.join(C2D_ZONE_FREE, lower.number, lower.upper, number, 1);
  const Sides upper = add_rectangle(a, {from, to}, 2 * r, 2 * r + h, {middle - 0.45, middle + 0.45}, faces[1], {from, to}, 3);
  a.m.join(C2D_ZONE_FREE, upper.number, upper.lower, number, 3);
  a.may_bend = false;
  a.base = {lower.number, lower.lower}, a.top = {upper.number, upper.upper};
  a.around.push_back({number, 2});
}

// ---- how they are held and loaded

void fix_platen(Platen& p, double y, double load, bool loaded) {
  p.is_free[0] = p.is_free[2] = 0, p.is_free[1] = loaded ? 1 : 0;
  p.motion[1] = y, p.load[1] = load;
}

double area_of(const Draft& a, Place at) {
  double sum = 0;
  const Range r = a.m.side(at.body, at.side);
  for (int32_t e = r.first; e <= r.last; ++e) {
    double x0, y0, x1, y1;
    a.m.place(at.body, e, 0, x0, y0), a.m.place(at.body, e, a.m.function_nodes - 1, x1, y1);
    sum += kPi * (x0 + x1) * std::hypot(x1 - x0, y1 - y0);
  }
  return sum;
}

bool meets_rigid(const Rings& m, int32_t body) {
  for (const Zone& z : m.zones)
    for (int k = 0; k < 2; ++k)
      if (z.side[k].body == body && m.body(z.side[1 - k].body).rigid != 0) return true;
  return false;
}

void hold(Draft& a, Place at) {
  Dice& d = a.dice;
  const double kind = d.unit();
  if (kind < 0.10)
    a.m.body(at.body).rigid = 1;
  else if (kind < 0.25)
    fix_platen(a.m.move(at.body, at.side), 0, 0, false);
  else
    a.m.set(at.body, at.side, end_of(kind < 0.65 ? kHeld : "0110"));
}

// By tractions, prescribed displacements, a platen, or as a rigid body.
void load(Draft& a, Place at, double strain, double stress) {
  Dice& d = a.dice;
  const double kind = d.unit(), down = strain * a.size, area = area_of(a, at);
  const double aside = d.chance(0.4) ? 0 : d.between(-0.4, 0.4), tilt = d.chance(0.5) ? 0 : d.between(-0.3, 0.3);
  const bool two_cases = a.m.cases > 1;
  Body& b = a.m.body(at.body);
  if (kind < 0.45) {
    a.m.set(at.body, at.side, [&](double x, double) {
      return end_of(kPulled, aside * stress * std::min(x, 1.0), -stress * (1 + tilt * std::sin(x)));
    });
    if (two_cases)
      a.m.set_second(at.body, at.side, end_of(kPulled, d.between(-0.5, 0.5) * stress, d.between(-1, 0.3) * stress));
  } else if (kind < 0.65) {
    const bool glued = d.chance(0.5);
    a.m.set(at.body, at.side, end_of(glued ? kHeld : "0110", 0, 0, 0, -down));
    if (two_cases) a.m.set_second(at.body, at.side, end_of(glued ? kHeld : "0110", 0, 0, 0, d.between(-1, 0.3) * down));
  } else if (kind < 0.88 || meets_rigid(a.m, at.body)) {
    Platen& p = a.m.move(at.body, at.side);
    fix_platen(p, -down, -stress * area, d.chance(0.6));
    p.second_motion[1] = d.between(-1, 0.3) * down, p.second_load[1] = d.between(-1, 0.3) * stress * area;
  } else {
    b.rigid = 1;
    b.is_free[1] = d.chance(0.6) ? 1 : 0;
    b.motion[1] = -down, b.load[1] = -stress * area;
  }
}

void load_more(Draft& a, double stress) {
  Dice& d = a.dice;
  const bool two_cases = a.m.cases > 1;
  for (const Place& at : a.around) {
    if (a.m.body(at.body).rigid != 0 || d.chance(0.6)) continue;
    const double pressure = d.between(-1, 1) * stress;
    a.m.set(at.body, at.side, end_of(kPulled, pressure, d.chance(0.7) ? 0 : d.between(-0.3, 0.3) * stress));
    if (two_cases) a.m.set_second(at.body, at.side, end_of(kPulled, d.between(-1, 1) * stress));
  }
  for (Body& b : a.m.bodies) {
    if (b.rigid != 0) continue;
    const double scale = a.m.scale();
    if (d.chance(0.15)) b.force[1] = d.between(-0.3, 0.1) * stress / a.size;
    if (d.chance(0.15)) b.spin = d.between(0.1, 1) * stress / (scale * scale);
  }
}

// A second case that loads nothing is not one.
void load_second(Draft& a, double stress) {
  if (a.m.cases < 2) return;
  bool loads = false;
  for (const Body& b : a.m.bodies) loads = loads || !b.second.empty();
  for (const Platen& p : a.m.platens) loads = loads || p.second_motion[1] != 0;
  for (const Place& at : a.around)
    if (!loads && a.m.body(at.body).rigid == 0)
      a.m.set_second(at.body, at.side, end_of(kPulled, a.dice.between(-1, 1) * stress)), loads = true;
  if (loads) return;
  a.m.cases = 1;
  for (Path& p : a.m.paths) p.second = 0;
}

// Forces of rings inside the last body, or a force on the axis.
void point_loads(Draft& a, double stress) {
  Dice& d = a.dice;
  const Body& b = a.m.body(a.top.body);
  if (b.rigid != 0 || !d.chance(0.2)) return;
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  const Range r = a.m.side(a.top.body, a.top.side);
  for (int32_t e = r.first; e <= r.last; ++e) { // below the side that is loaded
    double x, y;
    a.m.place(a.top.body, e, 0, x, y);
    low[0] = std::min(low[0], x), high[0] = std::max(high[0], x), low[1] = std::min(low[1], y), high[1] = std::max(high[1], y);
  }
  const bool on_axis = low[0] < 1e-9 * high[0] || b.open_regions > 0;
  const double x = on_axis && d.chance(0.5) ? 0 : low[0] + (high[0] - low[0]) * d.between(0.4, 0.6), y = low[1] - 0.15;
  const double force = stress * std::max(1.0, x) * d.between(-0.5, 0.5);
  a.m.point_loads.push_back({a.top.body, x, y, x == 0 ? 0 : force * d.between(-1, 1), force});
}

// Everything along the axis rises with the square of the radius.
void bend(Draft& a) {
  Dice& d = a.dice;
  if (!a.may_bend || d.chance(0.5) || a.m.scale() > 5) return;
  const double by = d.between(-0.05, 0.05);
  for (Body& b : a.m.bodies)
    for (size_t i = 0; i < b.xy.size(); i += 2) b.xy[i + 1] += by * b.xy[i] * b.xy[i];
  a.name += ", bent";
}

std::vector<Path> some_path(Dice& d, bool two_cases) {
  std::vector<Path> paths = {{d.whole(1, 3), 1.0}};
  if (two_cases && d.chance(0.3)) paths[0].second = d.between(-0.5, 0.5);
  for (int32_t i = d.whole(two_cases ? 1 : 0, 3); i > 0; --i) {
    const double factor = d.chance(0.15) ? 0 : d.chance(0.1) ? d.between(-0.5, 0) : d.between(0.3, 1.5);
    paths.push_back({d.whole(1, 3), factor, two_cases ? d.between(-1, 1) : 0});
  }
  return paths;
}

struct Scene {
  const char* name;
  void (*make)(Draft&);
};
constexpr Scene kScenes[] = {{"pile", pile}, {"hub", hub}, {"seat", seat}, {"plate", plate}, {"o-ring", o_ring}};

} // namespace

Rings generate_revolved(uint64_t seed, std::string& title) {
  Draft a(seed);
  Dice& d = a.dice;
  a.m.plane = C2D_AXISYMMETRIC;
  a.m.function_nodes = d.chance(0.65) ? 3 : d.chance(0.5) ? 2 : 4;
  a.element_nodes = d.chance(0.6) ? 2 : 3;
  a.m.friction = d.chance(0.2) ? 0 : d.between(0.05, 0.9);
  a.m.cases = d.chance(0.35) ? 2 : 1;
  a.m.paths = some_path(d, a.m.cases > 1);
  const double strain = d.power(-4, -2.3), stress = strain * 1000;
  const Scene& scene = kScenes[d.whole(0, 4)];
  a.name = scene.name;
  scene.make(a);
  bend(a);
  hold(a, a.base);
  if (a.name.compare(0, 5, "plate") == 0) hold(a, {2, 1});
  load(a, a.top, strain, stress);
  load_more(a, stress);
  load_second(a, stress);
  for (Zone& z : a.m.zones) // a rigid body in a free zone is side 1
    if ((z.kind & C2D_ZONE_FREE) != 0 && a.m.body(z.side[1].body).rigid != 0) std::swap(z.side[0], z.side[1]);
  point_loads(a, stress);
  title = "revolved, " + a.name + ", seed " + std::to_string(static_cast<unsigned long long>(seed));
  return a.m;
}

namespace {

std::vector<BodyForm> forms_of_revolved(const Rings& m, uint64_t seed) {
  Dice d(seed ^ 0xC0FFEEu);
  std::vector<BodyForm> forms = common_forms(m);
  forms.push_back({"upside down", upside_down(m), Mapping()});
  forms.back().map.tangential = -1;
  forms.back().map.place = [](double&, double& y) { y = -y; };
  forms.push_back({"numbering", renumbered(m, d.whole(1, 20)), Mapping()});
  forms.push_back({"least memory", m, Mapping()});
  forms.back().model.bytes = 1;
  forms.push_back({"compressed", m, Mapping()}); // elimination is dense all the same
  forms.back().model.elimination = C2D_ELIMINATION_COMPRESSED;
  const int32_t times = d.whole(2, 4);
  forms.push_back({"increments", in_more_steps(m, times), Mapping()});
  forms.back().map.every = times;
  return forms;
}

} // namespace

Verdict judge_revolved(uint64_t seed) {
  Verdict v;
  const Rings m = generate_revolved(seed, v.title);
  judge_bodies(v, m, forms_of_revolved(m, seed));
  if (v.status != C2D_OK) return v;
  const interrupted::Verdict ended = interrupted::end_and_resume(interrupted::job_of(m), kPlaces);
  if (!ended.difference.empty()) v.findings.push_back("resumed: " + ended.difference);
  return v;
}

} // namespace random_decks
