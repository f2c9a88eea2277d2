// Bodies that only smooth contact holds: one outcome and the same numbers however the model is described, those of a
// coefficient of friction that vanishes.
#include "dice.hpp"
#include "many_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace many;

namespace {

const double kPi = std::acos(-1.0);
constexpr int32_t kFine = 8; // elements of a face that may touch

// A circle of radius 1 about (x, y). Elements 1 to 8 lie about its lowest point, as many from `highest()` on about its highest.
Body roller(double x, double y, int32_t coarse, double nu) {
  Body b;
  b.poisson_ratio = nu;
  const double step = 2.8 * kPi / 180, rest = (kPi - kFine * step) / coarse;
  int32_t count = 0;
  for (const double middle : {-kPi / 2, kPi / 2})
    for (int32_t i = 0; i < kFine + coarse; ++i, ++count) {
      const double angle = middle - kFine / 2 * step + (i < kFine ? i * step : kFine * step + (i - kFine) * rest);
      b.xy.insert(b.xy.end(), {x + std::cos(angle), y + std::sin(angle)});
    }
  b.regions.push_back({1, count});
  b.ends.resize(static_cast<size_t>(2 * count));
  return b;
}
int32_t highest(const Body& roller) { return roller.elements() / 2 + 1; }

// A plate whose upper (or lower) face has eight elements of length 0.05 about each of the places `at`, the first from `face()`
// on, one element between two of them and one at either end. The other face has four elements.
Body plate(double x0, double y0, double x1, double y1, std::vector<double> at, bool is_upper) {
  std::vector<double> face = {x0};
  for (const double x : at)
    for (int32_t i = 0; i <= kFine; ++i) face.push_back(x + 0.05 * (i - kFine / 2));
  if (is_upper) std::reverse(face.begin() + 1, face.end()), face[0] = x1;
  std::vector<Corner> corners;
  const auto add_face = [&](double y) {
    for (const double x : face) corners.push_back({x, y, 1});
  };
  if (is_upper) {
    corners = {{x0, y0, 4}, {x1, y0, 2}};
    add_face(y1);
    corners.push_back({x0, y1, 2});
  } else {
    add_face(y0);
    corners.insert(corners.end(), {{x1, y0, 2}, {x1, y1, 4}, {x0, y1, 2}});
  }
  return polygon(corners);
}
// First of the eight elements about place k of n of the face.
int32_t face(bool is_upper, int32_t k, int32_t n) { return is_upper ? 8 + 9 * (n - 1 - k) : 2 + 9 * k; }

void hold(Body& b, double at, const End& end) { // all ends at this height
  for (size_t i = 0; i < b.ends.size(); ++i) {
    const size_t node = (i / 2 + i % 2) % (b.xy.size() / 2), other = (i / 2 + (i + 1) % 2) % (b.xy.size() / 2);
    if (std::fabs(b.xy[2 * node + 1] - at) < 1e-9 && std::fabs(b.xy[2 * other + 1] - at) < 1e-9) b.ends[i] = end;
  }
}
void touch(Model& m, int32_t a, int32_t first, int32_t b, int32_t other) {
  m.zones.push_back({C2D_ZONE_FREE, {{a, first, first + kFine - 1, kFine}, {b, other + kFine - 1, other, kFine}}});
}

// Rollers between a plate that is held below and one that is moved down; nodes lie at their lowest and highest points.
Model between_plates(const std::vector<double>& at, double nu) {
  Model m;
  const double width = at.back() + at.front();
  const int32_t n = static_cast<int32_t>(at.size());
  m.add(plate(0, -1, width, 0, at, true));
  m.add(plate(0, 2, width, 3, at, false));
  hold(m.body(1), -1, end_of(kHeld));
  hold(m.body(2), 3, end_of("1100", 0, 0, 0, -0.003));
  for (int32_t k = 0; k < n; ++k) {
    const int32_t b = m.add(roller(at[static_cast<size_t>(k)], 1, 6, nu));
    touch(m, 1, face(true, k, n), b, 1);
    touch(m, 2, face(false, k, n), b, highest(m.body(b)));
  }
  m.paths = {{3, 1.0}};
  return m;
}
// The same, the upper plate rigid and pressed by a force while its rotation is given.
Model below_a_rigid_plate(const std::vector<double>& at, double nu, double turn) {
  Model m = between_plates(at, nu);
  Body& top = m.body(2);
  top.ends.assign(top.ends.size(), End());
  top.rigid = 1;
  top.is_free[0] = top.is_free[1] = 1;
  top.point[0] = (at.front() + at.back()) / 2, top.point[1] = 3;
  top.load[1] = -4;
  top.motion[2] = turn;
  return m;
}
// Plates upon each other, the uppermost moved down by a platen, those between held by contact alone.
Model plates(int32_t count) {
  Model m;
  for (int32_t k = 0; k < count; ++k) m.add(rectangle(0, k, 2, k + 1, {4, 3, 4, 3}));
  m.set(1, 1, end_of(kHeld));
  for (int32_t k = 1; k < count; ++k) m.join(C2D_ZONE_MATCHING, k, 3, k + 1, 1);
  m.move(count, 3);
  Platen& p = m.platens[0];
  std::fill(p.is_free, p.is_free + 3, 0);
  p.motion[1] = -0.01;
  return m;
}

// ---- forms

// Element e of a region of n elements becomes element e + shift, round the region's end.
Model renumbered(Model m, const std::vector<int32_t>& shift) {
  for (size_t b = 0; b < m.bodies.size(); ++b) {
    Body& body = m.bodies[b];
    const int32_t n = body.elements(), by = shift[b] % n;
    std::rotate(body.xy.begin(), body.xy.end() - 2 * by, body.xy.end());
    std::rotate(body.ends.begin(), body.ends.end() - 2 * by, body.ends.end());
    body.sides.clear();
    const auto move = [&](Side& side) {
      if (side.body != static_cast<int32_t>(b) + 1) return;
      if (side.elements == 0) side.elements = std::abs(side.last - side.first) + 1;
      side.first = (side.first - 1 + by) % n + 1, side.last = (side.last - 1 + by) % n + 1;
    };
    for (Zone& zone : m.zones)
      for (Side& side : zone.side) move(side);
    for (Platen& platen : m.platens) move(platen.side);
  }
  return m;
}
Model with_all_sides_swapped(Model m) {
  for (int32_t i = 1; i <= static_cast<int32_t>(m.zones.size()); ++i) m = with_swapped_sides(m, i);
  return m;
}
Model with_bodies_reversed(const Model& m) {
  std::vector<int32_t> order;
  for (size_t b = m.bodies.size(); b > 0; --b) order.push_back(static_cast<int32_t>(b));
  return with_bodies_in_order(m, order);
}
Model in_forty_increments(Model m) {
  for (Path& path : m.paths) path.increments *= 40;
  return m;
}

struct Form {
  std::string name;
  Model model;
  double force = 1;
  bool has_swapped_sides = false;
};
std::vector<Form> ten_forms(const Model& m, uint64_t seed) {
  std::vector<int32_t> half, any;
  random_decks::Dice dice(seed);
  for (const Body& b : m.bodies) half.push_back(b.elements() / 2), any.push_back(dice.whole(1, b.elements() - 1));
  const Model other = with_bodies_reversed(renumbered(with_all_sides_swapped(m), any));
  return {{"numbered from the other end", renumbered(m, half)},
          {"numbered at random", renumbered(m, any)},
          {"bodies in the opposite order", with_bodies_reversed(m)},
          {"sides swapped", with_all_sides_swapped(m), 1, true},
          {"turned", turned(m, 37)},
          {"mirrored", reflected(m)},
          {"lengths x 1000", scaled(m, 1e3, 1), 1e3},
          {"forces x 1000", scaled(m, 1, 1e3), 1e3},
          {"in forty increments", in_forty_increments(m)},
          {"all together", in_forty_increments(scaled(turned(reflected(other), 37), 1e3, 1e3)), 1e6, true}};
}

// Magnitudes of the forces in the zones of a model that reaches its load.
std::vector<double> forces_of(const Model& m) {
  const Result r = solve(m);
  CHECK_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.outcome == C2D_REACHED);
  std::vector<double> out(m.zones.size());
  for (size_t i = 0; i < out.size() && i < r.zones.size(); ++i) out[i] = std::hypot(r.zones[i].force[0], r.zones[i].force[1]);
  return out;
}

void check_same(const std::vector<double>& forces, const std::vector<double>& others, double unit, double tolerance) {
  const double size = *std::max_element(forces.begin(), forces.end());
  CHECK(size > 0);
  for (size_t i = 0; i < forces.size(); ++i) CHECK(std::fabs(others[i] / unit - forces[i]) < tolerance * size);
}

// All forms carry the forces of the first, or of that with swapped sides, whose pairs lie at the nodes of the other side. The
// force in zone 1.
double solved_in_ten_forms(const Model& m, uint64_t seed) {
  const std::vector<double> forces = forces_of(m), swapped = forces_of(with_all_sides_swapped(m));
  check_same(forces, swapped, 1, 0.02);
  for (const Form& form : ten_forms(m, seed)) {
    CAPTURE(form.name);
    check_same(form.has_swapped_sides ? swapped : forces, forces_of(form.model), form.force, 1e-7);
  }
  Model rough = m;
  rough.friction = 1e-7;
  check_same(forces, forces_of(rough), 1, 1e-5);
  return forces[0];
}

} // namespace

TEST_CASE("smooth bodies: rollers between plates, in ten forms") {
  solved_in_ten_forms(between_plates({1.5}, 0.3), 1);
  solved_in_ten_forms(between_plates({1.5, 4.1}, -0.2), 2);
}

TEST_CASE("smooth bodies: rollers below a rigid plate, in ten forms") {
  const double force = solved_in_ten_forms(below_a_rigid_plate({1.5, 4.1}, 0.3, 0), 3);
  CHECK(std::fabs(force - 2) < 1e-9); // the plate stands on both
  solved_in_ten_forms(below_a_rigid_plate({1.5, 4.1}, -0.2, 2e-5), 4);
}

TEST_CASE("smooth bodies: plates upon each other below a platen, in ten forms") {
  Model given = plates(3);
  given.platens.clear();
  given.set(3, 3, end_of("1100", 0, 0, 0, -0.01));
  const Result right = solve(given);
  REQUIRE(right.outcome == C2D_REACHED);
  const double force = solved_in_ten_forms(plates(3), 6);
  CHECK(std::fabs(force / std::hypot(right.zones[0].force[0], right.zones[0].force[1]) - 1) < 1e-9);
  solved_in_ten_forms(plates(4), 7);
}
