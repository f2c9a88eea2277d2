#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace random_decks {

namespace {

// What body 2 rests on, from left to right, as seen by body 2.
using Seat = std::vector<Side>;

void mark(Seat& seat, int zone) {
  for (Side& side : seat) side.zone = zone;
}

std::vector<double> graded_breaks(Dice& dice, int32_t elements) {
  std::vector<double> breaks = equal_breaks(elements);
  const double power = dice.chance(0.3) ? dice.between(1.0, 2.5) : 1.0;
  const bool from_end = dice.chance(0.5);
  for (double& s : breaks) s = from_end ? 1 - std::pow(1 - s, power) : std::pow(s, power);
  return breaks;
}

int32_t contact_elements(Dice& dice, int32_t function_nodes, bool few) {
  const int32_t per = std::max(1, function_nodes - 1);
  if (few) return std::max(1, (function_nodes == 1 ? 4 : 3) / per);
  return dice.whole(1, 12 / per);
}

Side seat_side(Dice& dice, Point a, Point b, int32_t elements, double bulge) {
  Side side = arc(a, b, elements, bulge);
  side.breaks = graded_breaks(dice, elements);
  return side;
}

// ---- seats ------------------------------------------------------------------------------------------------------------

Seat flat_seat(Dice& dice, int32_t elements) { return {seat_side(dice, {0, 0}, {1, 0}, elements, 0)}; }
Seat bumped_seat(Dice& dice, int32_t elements) {
  return {seat_side(dice, {0, 0}, {1, 0}, elements, dice.sign() * dice.between(0.02, 0.25))};
}
Seat kinked_seat(Dice& dice, int32_t elements) { // a notch or a roof
  const Point tip = {dice.between(0.3, 0.7), dice.sign() * dice.power(-2, -0.3)};
  const int32_t left = std::max(1, elements / 2);
  return {seat_side(dice, {0, 0}, tip, left, 0), seat_side(dice, tip, {1, 0}, std::max(1, elements - left), 0)};
}
Seat corner_seat(Dice& dice, int32_t elements) { // a floor and a wall
  const double height = dice.between(0.2, 0.9), lean = dice.chance(0.5) ? 0 : -dice.between(0.02, 0.3);
  const int32_t left = std::max(1, elements / 2);
  return {seat_side(dice, {lean, height}, {0, 0}, left, 0), seat_side(dice, {0, 0}, {1, 0}, std::max(1, elements - left), 0)};
}
Seat slot_seat(Dice& dice, int32_t elements) { // a floor and two walls
  const double height = dice.between(0.2, 0.9), lean = dice.chance(0.5) ? 0 : dice.between(0.02, 0.3);
  const int32_t wall = std::max(1, elements / 3);
  return {seat_side(dice, {-lean, height}, {0, 0}, wall, 0),
          seat_side(dice, {0, 0}, {1, 0}, std::max(1, elements - 2 * wall), 0),
          seat_side(dice, {1, 0}, {1 + lean, height}, wall, 0)};
}

// ---- bodies around a seat ---------------------------------------------------------------------------------------------

int32_t along(double length, double size) { return std::max(1, std::min(8, static_cast<int32_t>(std::lround(length / size)))); }

void add_line(std::vector<Side>& outline, Point to, double size) {
  const Point from = outline.back().last();
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length > 1e-12) outline.push_back(line(from, to, along(length, size)));
}

// Body 1 below the seat: the seat backwards, with land beside it, walls and a base.
void add_below(Scene& scene, const std::vector<Seat>& seats, Dice& dice, bool walls = false) {
  const Point left = seats.front().front().first(), right = seats.back().back().last();
  double lowest = 0;
  for (const Seat& seat : seats)
    for (const Side& side : seat)
      for (double s : {0.0, 0.5, 1.0}) lowest = std::min(lowest, side.curve.at(s).y);
  const double depth = dice.chance(0.2) ? dice.power(-1.3, -0.5) : dice.between(0.6, 2.0), bottom = lowest - depth;
  const double x0 = left.x - (!walls && dice.chance(0.3) ? 0 : dice.between(0.2, 1.2));
  const double x1 = right.x + (!walls && dice.chance(0.3) ? 0 : dice.between(0.2, 1.2));
  const double size = dice.between(0.2, 0.6);
  std::vector<Side> out;
  out.push_back(line({x0, bottom}, {x1, bottom}, along(x1 - x0, size)));
  add_line(out, {x1, right.y}, size);
  add_line(out, right, size);
  for (size_t i = seats.size(); i-- > 0;) {
    for (size_t k = seats[i].size(); k-- > 0;) out.push_back(opposite(seats[i][k]));
    if (i > 0) add_line(out, seats[i - 1].back().last(), size); // the land between two seats
  }
  add_line(out, {x0, left.y}, size);
  const double middle = left.y + 0.5 * (bottom - left.y); // what is held does not touch the contact
  scene.flush_left = x0 == left.x;
  scene.left_wall[0] = static_cast<int32_t>(out.size());
  add_line(out, {x0, middle}, size);
  scene.base_other = static_cast<int32_t>(out.size());
  add_line(out, {x0, bottom}, size);
  scene.base = 0;
  if (depth > 0.5) {
    scene.room[0][0] = {x0 + 0.1, bottom + 0.1};
    scene.room[0][1] = {x1 - 0.1, lowest - 0.12};
  }
  scene.body[0].regions.push_back(out);
}

// Body 2 above: the seat, walls, a top.
void add_above(Scene& scene, const std::vector<Seat>& seats, Dice& dice) {
  const Point left = seats.front().front().first(), right = seats.back().back().last();
  double highest = 0;
  for (const Seat& seat : seats)
    for (const Side& side : seat)
      for (double s : {0.0, 0.5, 1.0}) highest = std::max(highest, side.curve.at(s).y);
  const double height = dice.chance(0.25) ? dice.power(-1.5, -0.5) : dice.between(0.4, 2.0), top = highest + height;
  const double size = dice.between(0.2, 0.6);
  std::vector<Side> out;
  for (size_t i = 0; i < seats.size(); ++i) {
    if (i > 0) { // the bridge between two feet
      const Point from = out.back().last(), to = seats[i].front().first();
      const double rise = dice.between(0.1, 0.5) * (top - std::max(from.y, to.y));
      add_line(out, {from.x + 0.15 * (to.x - from.x), from.y + rise}, size);
      add_line(out, {to.x - 0.15 * (to.x - from.x), from.y + rise}, size);
      add_line(out, to, size);
    }
    out.insert(out.end(), seats[i].begin(), seats[i].end());
  }
  add_line(out, {right.x, top}, size);
  scene.top = static_cast<int32_t>(out.size());
  const double split = dice.chance(0.4) ? dice.between(0.2, 0.8) : 0; // so that a part of the top may be loaded
  if (split > 0) add_line(out, {left.x + split * (right.x - left.x), top}, size);
  add_line(out, {left.x, top}, size);
  scene.top_other = scene.left_wall[1] = static_cast<int32_t>(out.size());
  add_line(out, {left.x, left.y + 0.5 * (top - left.y)}, size); // what is held does not touch the contact
  add_line(out, left, size);
  if (height > 0.5) {
    const double bridge = seats.size() > 1 ? 0.5 * height : 0;
    scene.room[1][0] = {std::max(left.x, 0.0) + 0.1, highest + bridge + 0.1};
    scene.room[1][1] = {std::min(right.x, 1.0) - 0.1, top - 0.1};
  }
  scene.body[1].regions.push_back(out);
}

// ---- scenes -----------------------------------------------------------------------------------------------------------

Scene seated(Dice& dice, int32_t elements, bool few) {
  struct Kind {
    const char* name;
    Seat (*make)(Dice&, int32_t);
  };
  static const Kind kinds[] = {
      {"flat", flat_seat}, {"bump", bumped_seat}, {"kink", kinked_seat}, {"corner", corner_seat}, {"slot", slot_seat}};
  const Kind& kind = kinds[dice.chance(0.3) ? 0 : dice.whole(0, few ? 3 : 4)];
  Scene scene;
  scene.name = kind.name;
  scene.same_surfaces = scene.touching = true;
  Seat seat = kind.make(dice, elements);
  mark(seat, 1);
  add_below(scene, {seat}, dice, kind.make == corner_seat || kind.make == slot_seat);
  add_above(scene, {seat}, dice);
  return scene;
}

// Two feet, each flat or inclined.
Scene bridge(Dice& dice, int32_t elements, bool few) {
  Scene scene;
  scene.name = "bridge";
  scene.same_surfaces = scene.touching = true;
  scene.zones = 2;
  const double slope = dice.chance(0.5) ? 0 : dice.sign() * dice.between(0.02, 0.3);
  const int32_t each = few ? 1 : std::max(1, elements / 2);
  Seat one = {seat_side(dice, {0, slope}, {0.3, 0}, each, 0)}, two = {seat_side(dice, {0.7, 0}, {1, slope}, each, 0)};
  mark(one, 1), mark(two, 2);
  add_below(scene, {one, two}, dice);
  add_above(scene, {one, two}, dice);
  return scene;
}

// A rounded body 2 over a flat or rounded body 1: gaps at first.
Scene rounded(Dice& dice, int32_t elements) {
  Scene scene;
  scene.name = "rounded";
  scene.free_zones = dice.chance(0.35);
  scene.round = true;
  const double under = dice.chance(0.5) ? 0 : dice.sign() * dice.between(0.02, 0.1);
  const double bulge = std::max(under, 0.0) + dice.power(-3, -0.8); // more than the seat's hollow
  const int32_t below = scene.free_zones ? std::max(2, elements + dice.whole(-2, 3)) : elements;
  const double lift = dice.chance(0.3) ? dice.power(-5, -2) : 0;
  Seat seat1 = {arc({0, 0}, {1, 0}, below, under)};
  // As deep in the middle as body 1's surface is there.
  const double height = bulge - under + lift;
  Seat seat2 = {arc({0, height}, {1, height}, elements, bulge)};
  if (!scene.free_zones && bulge < 0.03) seat2[0].breaks = seat1[0].breaks = graded_breaks(dice, elements);
  mark(seat1, 1), mark(seat2, 1);
  add_below(scene, {seat1}, dice);
  add_above(scene, {seat2}, dice);
  return scene;
}

// Flat on flat or arc on arc, meshed independently of each other.
Scene independent(Dice& dice, int32_t elements) {
  Scene scene;
  scene.name = "independent";
  scene.free_zones = scene.touching = true;
  const double bulge = dice.chance(0.8) ? 0 : dice.sign() * dice.between(0.02, 0.2);
  Seat seat1 = {arc({0, 0}, {1, 0}, std::max(2, elements + dice.whole(-2, 3)), bulge)};
  Seat seat2 = {arc({0, 0}, {1, 0}, elements, bulge)};
  mark(seat1, 1), mark(seat2, 1);
  add_below(scene, {seat1}, dice);
  add_above(scene, {seat2}, dice);
  return scene;
}

Side ring_part(Point centre, double radius, double from, double to, int32_t elements) {
  const Point a = {centre.x + radius * std::cos(from), centre.y + radius * std::sin(from)};
  const Point b = {centre.x + radius * std::cos(to), centre.y + radius * std::sin(to)};
  Side side = arc(a, b, elements, 0.5 * std::tan(0.25 * (to - from)));
  side.curve.by_angle = true;
  return side;
}

// A disc, a half disc or a ring in a hole of a plate: the lower part of the hole is in contact.
Scene disc(Dice& dice, int32_t elements) {
  constexpr double kPi = 3.14159265358979323846;
  Scene scene;
  scene.name = "disc";
  scene.round = true;
  const double half = dice.between(0.2, 0.5) * kPi, from = -0.5 * kPi - half, to = -0.5 * kPi + half;
  const double fit = dice.unit();
  scene.overlap = fit > 0.9;
  scene.same_surfaces = scene.touching = fit < 0.5;
  const double play = scene.touching ? 0 : scene.overlap ? -dice.power(-4, -2.5) : dice.power(-4, -1.5);
  const double radius = 0.5 - play;
  const Point centre = {0.5, scene.overlap ? 0.5 : 0.5 - play}; // resting at the lowest point, or in the middle
  Side hole_side = ring_part({0.5, 0.5}, 0.5, from, to, elements), disc_side = ring_part(centre, radius, from, to, elements);
  if (scene.touching) disc_side = hole_side;
  hole_side.zone = disc_side.zone = 1;
  const double edge = dice.between(0.3, 1.0);
  const int32_t per_edge = dice.whole(2, 4);
  std::vector<Side> plate;
  const Point corners[4] = {{-edge, -edge}, {1 + edge, -edge}, {1 + edge, 1 + edge}, {-edge, 1 + edge}};
  for (int i = 0; i < 4; ++i) plate.push_back(line(corners[i], corners[(i + 1) % 4], per_edge));
  // Both curves begin beside the contact, so that it does not go round the end of the region.
  const double turn = 2 * kPi - 2 * half;
  const int32_t rest = std::max(2, static_cast<int32_t>(std::lround(elements * turn / (2 * half))));
  std::vector<Side> hole = {opposite(hole_side), opposite(ring_part({0.5, 0.5}, 0.5, to, to + turn, rest))};
  std::vector<Side> out;
  const bool half_disc = dice.chance(0.3);
  out.push_back(disc_side);
  if (half_disc) {
    const Point a = disc_side.last(), b = disc_side.first();
    const Point third = {a.x + (b.x - a.x) / 3, a.y + (b.y - a.y) / 3};
    const Point thirds = {a.x + 2 * (b.x - a.x) / 3, a.y + 2 * (b.y - a.y) / 3};
    out.push_back(line(a, third, 1));
    out.push_back(line(third, thirds, dice.whole(1, 2)));
    out.push_back(line(thirds, b, 1));
  } else {
    const double third = turn / 3;
    const int32_t each = std::max(2, rest / 3);
    for (int i = 0; i < 3; ++i) out.push_back(ring_part(centre, radius, to + i * third, to + (i + 1) * third, each));
    for (size_t i = 1; i < out.size(); ++i) { // joined without a last digit between them
      out[i].curve.a = out[i - 1].last();
      if (i + 1 == out.size()) out[i].curve.b = out[0].first();
    }
    scene.room[1][0] = {centre.x - 0.25 * radius, centre.y - 0.25 * radius};
    scene.room[1][1] = {centre.x + 0.25 * radius, centre.y + 0.25 * radius};
  }
  hole[1].curve.a = hole_side.last(), hole[1].curve.b = hole_side.first();
  scene.top = scene.top_other = 2;
  scene.base_other = 3;
  scene.body[0].regions = {plate, hole};
  scene.body[1].regions = {out};
  return scene;
}

// ---- holes ------------------------------------------------------------------------------------------------------------

void add_holes(Scene& scene, Dice& dice, int b) {
  const Point low = scene.room[b][0], high = scene.room[b][1];
  const double width = high.x - low.x, height = high.y - low.y;
  if (width < 0.15 || height < 0.15) return;
  const int32_t count = dice.whole(1, 3);
  for (int32_t i = 0; i < count; ++i) { // side by side
    const double share = width / count, radius = dice.between(0.15, 0.4) * std::min(share, height);
    const Point centre = {low.x + (i + 0.5) * share, low.y + dice.between(0.45, 0.55) * height};
    const int32_t corners = dice.whole(3, 8);
    const double start = dice.between(0, 6.28);
    std::vector<Side> hole;
    const auto corner = [&](int32_t k) {
      const double angle = start - 2 * 3.14159265358979323846 * (k % corners) / corners;
      return Point{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
    };
    for (int32_t k = 0; k < corners; ++k) hole.push_back(line(corner(k), corner(k + 1), 1));
    scene.body[b].regions.push_back(hole);
  }
}

} // namespace

Scene make_scene(Dice& dice, int32_t function_nodes, bool few) {
  const int32_t elements = contact_elements(dice, function_nodes, few);
  const double kind = dice.unit();
  Scene scene;
  if (few)
    scene = kind < 0.85 || function_nodes > 2 ? seated(dice, elements, few) : bridge(dice, elements, few);
  else if (kind < 0.45)
    scene = seated(dice, elements, few);
  else if (kind < 0.55)
    scene = bridge(dice, elements, few);
  else if (kind < 0.75)
    scene = rounded(dice, std::max(3, elements));
  else if (kind < 0.85)
    scene = independent(dice, std::max(2, elements));
  else
    scene = disc(dice, std::max(3, elements));
  for (int b = 0; b < 2; ++b)
    if (dice.chance(few ? 0.1 : 0.3)) add_holes(scene, dice, b);
  return scene;
}

} // namespace random_decks
