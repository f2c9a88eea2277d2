#include "three_bodies.hpp"

#include "../dice.hpp"
#include "judged_bodies.hpp"

#include <cmath>

namespace random_decks {

using namespace many;
using Three = many::Model;

namespace {

// ---- the model

enum Standing { kStack, kBridge, kThreeJoints };
const char* const kNames[] = {"stack", "bridge", "three joints"};

struct Draft {
  Dice dice;
  Three m;
  explicit Draft(uint64_t seed) : dice(seed) {}
};

Body of_some_material(Dice& d, Body body) {
  body.youngs_modulus = d.chance(0.3) ? 1000 : d.power(2, 4);
  body.poisson_ratio = d.chance(0.2) ? 0.3 : d.between(-0.3, 0.49);
  return body;
}

// A block with these elements on its lower, right, upper and left sides.
Body block(Dice& d, double x0, double y0, double x1, double y1, const std::array<int32_t, 4>& n) {
  return of_some_material(d, rectangle(x0, y0, x1, y1, n));
}

struct Meeting {
  int32_t kind, one, other; // elements on the two sides
};
Meeting some_meeting(Dice& d) {
  Meeting z;
  z.kind = d.chance(0.5) ? C2D_ZONE_MATCHING : C2D_ZONE_FREE;
  z.one = d.whole(2, 7);
  z.other = z.kind == C2D_ZONE_MATCHING ? z.one : d.whole(2, 7);
  if (d.chance(0.3)) z.kind += C2D_ZONE_TIED;
  return z;
}
void meet(Draft& a, const Meeting& z, int32_t body1, int32_t side1, int32_t body2, int32_t side2) {
  const int32_t zone = a.m.join(z.kind, body1, side1, body2, side2);
  if (a.dice.chance(0.5)) a.m.zones[static_cast<size_t>(zone - 1)].mu = a.dice.chance(0.2) ? 0 : a.dice.between(0.05, 0.9);
}

void stack(Draft& a) {
  Dice& d = a.dice;
  const double width = d.between(1.5, 4), h1 = d.between(0.5, 2), h2 = h1 + d.between(0.3, 2), h3 = h2 + d.between(0.5, 2);
  const Meeting low = some_meeting(d), high = some_meeting(d);
  a.m.add(block(d, 0, 0, width, h1, {d.whole(2, 5), d.whole(1, 4), low.one, d.whole(1, 4)}));
  a.m.add(block(d, 0, h1, width, h2, {low.other, d.whole(1, 4), high.one, d.whole(1, 4)}));
  a.m.add(block(d, 0, h2, width, h3, {high.other, d.whole(1, 4), d.whole(2, 5), d.whole(1, 4)}));
  meet(a, low, 1, 3, 2, 1);
  meet(a, high, 2, 3, 3, 1);
}

// Body 3 lies on two feet that stand apart.
void bridge(Draft& a) {
  Dice& d = a.dice;
  const double w1 = d.between(0.6, 1.5), gap = d.between(0.3, 2), w2 = d.between(0.6, 1.5), h = d.between(0.5, 1.5);
  const double left = w1 + gap, right = left + w2;
  const Meeting one = some_meeting(d), two = some_meeting(d);
  a.m.add(block(d, 0, 0, w1, h, {d.whole(2, 4), d.whole(2, 4), one.one, d.whole(2, 4)}));
  a.m.add(block(d, left, 0, right, h, {d.whole(2, 4), d.whole(2, 4), two.one, d.whole(2, 4)}));
  a.m.add(of_some_material(d, polygon({{0, h, one.other},
                                       {w1, h, d.whole(2, 4)},
                                       {left, h, two.other},
                                       {right, h, d.whole(1, 3)},
                                       {right, h + d.between(0.5, 1), d.whole(3, 6)},
                                       {0, h + 0.7, d.whole(1, 3)}})));
  meet(a, one, 1, 3, 3, 1);
  meet(a, two, 2, 3, 3, 3);
}

// Bodies 2 and 3 stand on body 1 side by side and touch each other above a notch.
void three_joints(Draft& a) {
  Dice& d = a.dice;
  const double w = d.between(1, 2), h = d.between(0.5, 1), top = h + d.between(1, 2), notch = 0.2;
  Meeting one = some_meeting(d), two = some_meeting(d), beside = some_meeting(d);
  const int32_t middle = d.whole(1, 2);
  a.m.add(of_some_material(d, polygon({{-w, 0, d.whole(3, 6)},
                                       {w, 0, d.whole(1, 3)},
                                       {w, h, two.one},
                                       {notch, h, middle},
                                       {-notch, h, one.one},
                                       {-w, h, d.whole(1, 3)}})));
  a.m.add(of_some_material(
      d,
      polygon(
          {{-w, h, one.other}, {-notch, h, 2}, {0, h + 0.3, beside.one}, {0, top, d.whole(2, 4)}, {-w, top, d.whole(2, 4)}})));
  a.m.add(of_some_material(
      d,
      polygon(
          {{notch, h, two.other}, {w, h, d.whole(2, 4)}, {w, top, d.whole(2, 4)}, {0, top, beside.other}, {0, h + 0.3, 2}})));
  meet(a, one, 1, 5, 2, 1);
  meet(a, two, 1, 3, 3, 1);
  meet(a, beside, 2, 3, 3, 4);
}

// What holds a body below: its displacements, or it is rigid.
void hold(Draft& a, int32_t body) {
  if (a.dice.chance(0.15))
    a.m.body(body).rigid = 1;
  else
    a.m.set(body, 1, end_of(kHeld));
}

// What loads a body at its side: tractions, or displacements.
void load(Draft& a, int32_t body, int32_t side, bool only_tractions = false) {
  Dice& d = a.dice;
  const double pressure = d.between(0.5, 2), shear = d.chance(0.3) ? 0 : pressure * d.between(-0.4, 0.4),
               slope = d.between(-0.3, 0.3);
  if (only_tractions || d.chance(0.6)) {
    a.m.set(body, side, [&](double x, double) { return end_of(kPulled, shear, -pressure * (1 + slope * std::sin(x))); });
    return;
  }
  const double down = pressure * 1e-3;
  a.m.set(body, side, [&](double x, double) { return end_of(kHeld, 0, 0, shear * 1e-3, -down * (1 + 0.2 * slope * x)); });
}

// Shapes and directions: everything sheared, bent (if all zones are matching) and turned.
void deform(Draft& a) {
  Dice& d = a.dice;
  bool free = false;
  for (const Zone& z : a.m.zones) free = free || (z.kind & C2D_ZONE_FREE) != 0;
  const double shear = d.chance(0.5) ? 0 : d.between(-0.3, 0.3), bend = free || d.chance(0.5) ? 0 : d.between(-0.05, 0.05);
  for (Body& b : a.m.bodies)
    for (size_t i = 0; i < b.xy.size(); i += 2) {
      const double x = b.xy[i], y = b.xy[i + 1];
      b.xy[i] = x + shear * y;
      b.xy[i + 1] = y + bend * x * x;
    }
  if (d.chance(0.5)) a.m = turned(a.m, d.between(-180, 180));
}

} // namespace

Three generate_three(uint64_t seed, std::string& title) {
  Draft a(seed);
  Dice& d = a.dice;
  const int standing = d.whole(0, 2);
  a.m.function_nodes = d.chance(0.7) ? 2 : 3;
  a.m.plane = d.chance(0.7) ? C2D_PLANE_STRAIN : C2D_PLANE_STRESS;
  a.m.friction = d.chance(0.15) ? 0 : d.between(0.05, 0.9);
  const int32_t pieces = d.whole(1, 3);
  a.m.paths.clear();
  for (int32_t i = 0; i < pieces; ++i) a.m.paths.push_back({d.whole(1, 3), i == 0 ? 1.0 : d.between(0.3, 1.5)});
  if (standing == kStack) stack(a), hold(a, 1), load(a, 3, 3);
  if (standing == kBridge) bridge(a), hold(a, 1), hold(a, 2), load(a, 3, 5);
  if (standing == kThreeJoints)
    three_joints(a), hold(a, 1), load(a, 2, 4, true), load(a, 3, 3, true); // sides that end at a zone
  deform(a);
  title = std::string("three bodies, ") + kNames[standing] + ", seed " + std::to_string(static_cast<unsigned long long>(seed));
  return a.m;
}

// ---- the same, told otherwise

namespace {

std::vector<BodyForm> forms_of_three(const Three& m) {
  std::vector<BodyForm> forms = common_forms(m);
  BodyForm mirror = {"mirror", reflected(m), Mapping()};
  mirror.map.tangential = -1;
  mirror.map.place = [](double& x, double&) { x = -x; };
  BodyForm turn = {"turned", turned(m, 37), Mapping()};
  turn.map.place = [](double& x, double& y) {
    const double angle = 37 * std::acos(-1.0) / 180, old = x;
    x = std::cos(angle) * old - std::sin(angle) * y, y = std::sin(angle) * old + std::cos(angle) * y;
  };
  forms.push_back(mirror), forms.push_back(turn);
  return forms;
}

} // namespace

Verdict judge_three(uint64_t seed) {
  Verdict v;
  const Three m = generate_three(seed, v.title);
  judge_bodies(v, m, forms_of_three(m));
  return v;
}

} // namespace random_decks
