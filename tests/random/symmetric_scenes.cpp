// Two bodies that are symmetric about x = 0: right halves, and their mirror images.
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace random_decks {

namespace {

using Sides = std::vector<Side>;

// The image of a side in x = 0, run so that a curve round a body stays one.
Side image(const Side& side) {
  Side out = side;
  out.curve.a = {-side.curve.b.x, side.curve.b.y};
  out.curve.b = {-side.curve.a.x, side.curve.a.y};
  const size_t n = side.breaks.size();
  for (size_t i = 0; i < n; ++i) out.breaks[i] = 1 - side.breaks[n - 1 - i];
  return out;
}

// Of sides that run on from each other, as the images do.
Sides images(const Sides& sides) {
  Sides out;
  for (size_t i = sides.size(); i-- > 0;) out.push_back(image(sides[i]));
  return out;
}

void append(Sides& out, const Sides& more) { out.insert(out.end(), more.begin(), more.end()); }

// Elements of equal length, or finer towards both ends.
std::vector<double> even_breaks(Dice& dice, int32_t elements) {
  std::vector<double> breaks = equal_breaks(elements);
  const double pull = dice.chance(0.3) ? dice.between(0.1, 0.8) : 0;
  for (double& s : breaks) s = 0.5 + (s - 0.5) * (1 + pull * (0.25 - (s - 0.5) * (s - 0.5)));
  return breaks;
}

Side across(Dice& dice, double half_width, double height, int32_t elements, double bulge) {
  Side side = arc({-half_width, height}, {half_width, height}, elements, bulge);
  side.breaks = even_breaks(dice, elements);
  return side;
}

// What body 2 rests on, from left to right, as seen by body 2, in pieces with land between them.
using Seats = std::vector<Sides>;

Seats table_seat(Dice& dice, int32_t elements) { return {{across(dice, 0.5, 0, elements, 0)}}; }
Seats bump_seat(Dice& dice, int32_t elements) {
  return {{across(dice, 0.5, 0, elements, dice.sign() * dice.between(0.02, 0.25))}};
}
Seats vee_seat(Dice& dice, int32_t elements) { // a notch or a roof
  const Side right = line({0, dice.sign() * dice.power(-2, -0.3)}, {0.5, 0}, std::max(1, elements / 2));
  return {{image(right), right}};
}
Seats groove_seat(Dice& dice, int32_t elements) { // open upwards, straight or undercut
  const double height = dice.between(0.2, 0.9), kind = dice.unit();
  const double lean = kind < 0.3 ? 0 : kind < 0.6 ? dice.between(0.02, 0.3) : -dice.between(0.02, 0.3);
  const int32_t wall = std::max(1, elements / 3);
  const Side right = line({0.5, 0}, {0.5 + lean, height}, wall);
  return {{image(right), across(dice, 0.5, 0, std::max(1, elements - 2 * wall), 0), right}};
}
Seats portal_seat(Dice& dice, int32_t elements) {
  const double slope = dice.chance(0.5) ? 0 : dice.sign() * dice.between(0.02, 0.3);
  const Side right = line({dice.between(0.1, 0.35), 0}, {0.5, slope}, std::max(1, elements / 2));
  return {{image(right)}, {right}};
}

int32_t along(double length, double size) { return std::max(1, std::min(8, static_cast<int32_t>(std::lround(length / size)))); }

void add_line(Sides& outline, Point to, double size) {
  const Point from = outline.back().last();
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length > 1e-12) outline.push_back(line(from, to, along(length, size)));
}

double extreme(const Seats& seats, double sign) {
  double most = -1e9;
  for (const Sides& seat : seats)
    for (const Side& side : seat)
      for (double s : {0.0, 0.5, 1.0}) most = std::max(most, sign * side.curve.at(s).y);
  return sign * most;
}

// The curve begins in the middle of the base: the first side and the last one.
Sides below(const Seats& seats, bool walls, Dice& dice) {
  const Point right = seats.back().back().last();
  const double bottom = extreme(seats, -1) - (dice.chance(0.2) ? dice.power(-1.3, -0.5) : dice.between(0.6, 2.0));
  const double x = right.x + (!walls && dice.chance(0.3) ? 0 : dice.between(0.2, 1.2)), size = dice.between(0.2, 0.6);
  Sides out = {line({0, bottom}, {x, bottom}, along(x, size))};
  add_line(out, {x, right.y}, size);
  add_line(out, right, size);
  const Sides left = images(out);
  for (size_t i = seats.size(); i-- > 0;) {
    for (size_t k = seats[i].size(); k-- > 0;) out.push_back(opposite(seats[i][k]));
    if (i > 0) add_line(out, seats[i - 1].back().last(), size); // the land between two feet
  }
  append(out, left);
  return out;
}

// Behind the contact a wall, the top in four sides, two on either side of the axis, and the other wall.
Sides above(const Seats& seats, Dice& dice) {
  const Point right = seats.back().back().last();
  const double highest = extreme(seats, 1);
  const double top = highest + (dice.chance(0.25) ? dice.power(-1.5, -0.5) : dice.between(0.4, 2.0));
  const double size = dice.between(0.2, 0.6);
  Sides out = seats.front();
  if (seats.size() > 1) {
    const Point to = seats[1].front().first();
    const double rise = to.y + dice.between(0.1, 0.5) * (top - to.y);
    add_line(out, {-0.85 * to.x, rise}, size);
    add_line(out, {0.85 * to.x, rise}, size);
    add_line(out, to, size);
    append(out, seats[1]);
  }
  Sides half = {line(right, {right.x, top}, along(top - right.y, size))};
  add_line(half, {dice.between(0.2, 0.8) * right.x, top}, size);
  add_line(half, {0, top}, size);
  append(out, half);
  append(out, images(half));
  return out;
}

void mark(Seats& seats) {
  for (size_t i = 0; i < seats.size(); ++i)
    for (Side& side : seats[i]) side.zone = static_cast<int>(i) + 1;
}

// A rounded foot over a flat or a hollow.
void round_off(Scene& scene, Seats& seat1, Seats& seat2, Dice& dice, int32_t elements) {
  const double under = dice.chance(0.5) ? 0 : dice.between(0.02, 0.1), bulge = under + dice.power(-3, -0.8);
  const double lift = dice.chance(0.3) ? dice.power(-5, -2) : 0;
  scene.free_zones = dice.chance(0.3);
  const int32_t other = scene.free_zones ? std::max(2, elements + dice.whole(-2, 3)) : elements;
  seat1 = {{across(dice, 0.5, 0, other, under)}};
  seat2 = {{arc({-0.5, bulge - under + lift}, {0.5, bulge - under + lift}, elements, bulge)}};
  seat2[0][0].breaks = scene.free_zones ? even_breaks(dice, elements) : seat1[0][0].breaks;
  scene.round = true;
}

} // namespace

Scene make_symmetric_scene(Dice& dice, int32_t function_nodes) {
  struct Kind {
    const char* name;
    Seats (*make)(Dice&, int32_t);
  };
  static const Kind kinds[] = {{"table", table_seat},   {"bump", bump_seat},     {"vee", vee_seat},
                               {"groove", groove_seat}, {"portal", portal_seat}, {"rounded", nullptr}};
  const Kind& kind = kinds[dice.whole(0, 5)];
  const int32_t most = dice.chance(0.6) ? 12 : 30;
  const int32_t elements = std::max(1, dice.whole(2, most) / std::max(1, function_nodes - 1));
  Scene scene;
  scene.name = std::string("symmetric ") + kind.name;
  Seats seat1, seat2;
  if (kind.make) {
    seat1 = seat2 = kind.make(dice, elements);
    scene.same_surfaces = scene.touching = true;
  } else {
    round_off(scene, seat1, seat2, dice, std::max(3, elements));
  }
  scene.zones = static_cast<int>(seat1.size());
  mark(seat1), mark(seat2);
  scene.body[0].regions = {below(seat1, kind.make == groove_seat, dice)};
  scene.body[1].regions = {above(seat2, dice)};
  scene.base_other = static_cast<int32_t>(scene.body[0].regions[0].size()) - 1; // the other half of side 0
  scene.top = static_cast<int32_t>(scene.body[1].regions[0].size()) - 5;        // of four
  return scene;
}

} // namespace random_decks
