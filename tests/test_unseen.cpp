// What contact conditions at nodes, in zones and at the places where surfaces faced each other at the start do not see,
// reported by how much.
#include "json.hpp"
#include "many_bodies.hpp"
#include "memory/config.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace many;

namespace {

int32_t count_of(const Result& r, int32_t number) {
  int32_t count = 0;
  for (const c2d_error& e : r.told) count += e.severity == C2D_WARNING && e.status == number ? 1 : 0;
  return count;
}
std::string text_of(const Result& r, int32_t number) {
  for (const c2d_error& e : r.told)
    if (e.status == number) return e.text;
  return "";
}

// One block upon another; the lower face's points at odd places stand out by `bump`, between the nodes of the upper block.
Model bumps(double bump, int32_t upper) {
  Model m;
  m.add(rectangle(0, 0, 2, 1, {4, 4, 16, 4}));
  m.add(rectangle(0, 1, 2, 2, {upper, 4, 4, 4}));
  const Range face = m.side(1, 3);
  for (int32_t k = 2; k < 16; k += 4) m.body(1).xy[2 * static_cast<size_t>(face.first - 1 + k) + 1] += bump;
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of(kHeld, 0, 0, 0, -0.001));
  m.join(C2D_ZONE_FREE, 1, 3, 2, 1);
  m.friction = 0.2;
  return m;
}

// Blocks with nodes at the same places, but for those of the upper one's face, which are shifted.
Model shifted(double shift) {
  Model m;
  m.add(rectangle(0, 0, 1, 1, {4, 4, 4, 4}));
  m.add(rectangle(0, 1, 1, 2, {4, 4, 4, 4}));
  const Range face = m.side(2, 1);
  for (int32_t k = 1; k < 4; ++k) m.body(2).xy[2 * static_cast<size_t>(face.first - 1 + k)] += shift;
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of(kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  return m;
}

// A block with another one that has no zone, reaching into it by `depth`, or driven as far.
Model without_zone(double depth, double motion) {
  Model m;
  m.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}));
  m.add(rectangle(0.5, 1 - depth, 1.5, 2 - depth, {4, 4, 4, 4}));
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of(kHeld, 0, 0, 0, motion));
  return m;
}

// A round foot above a flat: moved sideways in load case 2, then pressed in case 1.
Model moved(double sideways) {
  Model m;
  m.cases = 2;
  m.add(rectangle(-3, -3, 3, 0, {6, 6, 60, 6}, 1000));
  Body foot;
  const int32_t half = 20;
  for (int32_t i = 0; i <= 2 * half; ++i) {
    const double angle = 0.5 * (i - half) / half;
    foot.xy.insert(foot.xy.end(), {2 * std::sin(angle), 2 - 2 * std::cos(angle) + 1e-3});
  }
  const double edge = 2 * std::sin(0.5);
  for (int32_t i = 1; i <= 4; ++i) foot.xy.insert(foot.xy.end(), {edge, 0.246 + 0.4 * i});
  for (int32_t i = 1; i <= 8; ++i) foot.xy.insert(foot.xy.end(), {edge - edge / 4 * i, 1.846});
  for (int32_t i = 1; i <= 3; ++i) foot.xy.insert(foot.xy.end(), {-edge, 1.846 - 0.4 * i});
  const int32_t count = 2 * half + 16;
  foot.regions.push_back({1, count});
  foot.sides = {{1, 2 * half}, {2 * half + 1, 2 * half + 4}, {2 * half + 5, 2 * half + 12}, {2 * half + 13, count}};
  m.add(foot);
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of(kHeld, 0, 0, 0, -0.03));
  m.set_second(2, 3, end_of(kHeld, 0, 0, sideways, 0));
  m.join(C2D_ZONE_FREE, 1, 3, 2, 1);
  m.friction = 0.3;
  m.paths = {{1, 0.0, 1.0}, {4, 1.0, 1.0}};
  return m;
}

} // namespace

TEST_CASE("unseen: overlaps between the nodes of side 2" * doctest::skip(c2d::kSmallCode)) {
  const Result r = solve(bumps(0.01, 4));
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(count_of(r, C2D_WARN_BETWEEN) == 1);
  CHECK(text_of(r, C2D_WARN_BETWEEN).find("between the nodes of side 2 the bodies overlap by 0.01 at (") != std::string::npos);
  CHECK(count_of(solve(bumps(0.0, 4)), C2D_WARN_BETWEEN) == 0);
  CHECK(count_of(solve(bumps(-0.01, 4)), C2D_WARN_BETWEEN) == 0); // dents are gaps
  CHECK(count_of(solve(bumps(1e-5, 4)), C2D_WARN_BETWEEN) == 0);  // little beside what the pressure does there
}

TEST_CASE("unseen: nodes of pairs that are shifted by less than half an element" * doctest::skip(c2d::kSmallCode)) {
  for (const double shift : {0.06, 0.02}) {
    const Result r = solve(shifted(shift));
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(count_of(r, C2D_WARN_SHIFTED) == 1);
    CHECK(text_of(r, C2D_WARN_SHIFTED).find("they are shifted by " + std::string(shift > 0.05 ? "0.06" : "0.02")) !=
          std::string::npos);
    double most = 0; // of a pressure that should be 1, against the reported part of the element
    for (const Row& row : r.last().rows) most = std::max(most, std::fabs(row[C2D_TN] - 1));
    CHECK(most > 0.1 * shift / 0.25);
    CHECK(most < 3 * shift / 0.25);
  }
  CHECK(count_of(solve(shifted(0.0)), C2D_WARN_SHIFTED) == 0);
  const Result far = solve(shifted(0.1)); // by two thirds of the last element
  CHECK(count_of(far, C2D_WARN_SHIFTED) == 0);
  CHECK(count_of(far, C2D_WARN_OFFSET) == 1);
}

TEST_CASE("unseen: bodies inside each other where no zone is between them" * doctest::skip(c2d::kSmallCode)) {
  const Result made = solve(without_zone(0.4, 0.0)), driven = solve(without_zone(-0.1, -0.5));
  REQUIRE_MESSAGE(made.status == C2D_OK, made.messages());
  CHECK(count_of(made, C2D_WARN_OVERLAPPING) == 1);
  CHECK(text_of(made, C2D_WARN_OVERLAPPING).find("overlap by 0.4 at (") != std::string::npos);
  CHECK(count_of(driven, C2D_WARN_OVERLAPPING) == 1);
  CHECK(text_of(driven, C2D_WARN_OVERLAPPING).find("overlap by 0.4 at (") != std::string::npos);
  CHECK(text_of(driven, C2D_WARN_OVERLAPPING).find("at the load reached") != std::string::npos);
  CHECK(count_of(solve(without_zone(0.0, 0.0)), C2D_WARN_OVERLAPPING) == 0);   // they touch
  CHECK(count_of(solve(without_zone(-0.5, -0.2)), C2D_WARN_OVERLAPPING) == 0); // they stay apart
}

TEST_CASE("unseen: sideways motion before bodies touch, and rotations" * doctest::skip(c2d::kSmallCode)) {
  const Result far = solve(moved(0.5)), near = solve(moved(0.02));
  REQUIRE_MESSAGE(far.status == C2D_OK, far.messages());
  CHECK(count_of(far, C2D_WARN_SIDEWAYS) == 1);
  CHECK(text_of(far, C2D_WARN_SIDEWAYS).find("the bodies have moved sideways by 0.5, ") != std::string::npos);
  CHECK(count_of(near, C2D_WARN_SIDEWAYS) == 0);
  for (const double angle : {0.08, 0.15}) { // a block turned as it is
    Model m;
    m.add(rectangle(0, 0, 1, 1, {4, 4, 4, 4}));
    m.body(1).ends.assign(32, End());
    for (int32_t side = 1; side <= 4; ++side)
      m.set(1, side, [angle](double x, double y) { return end_of(kHeld, 0, 0, -angle * y, angle * x); });
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(count_of(r, C2D_WARN_ROTATION) == (angle > 0.1 ? 1 : 0));
    CHECK(count_of(r, C2D_WARN_STRAIN) == 0);
  }
}

TEST_CASE("unseen: no force, no error of the force") {
  const test::Folder folder;
  Model m;
  m.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}));
  m.add(rectangle(0, 1, 2, 2, {4, 2, 4, 2}));
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
  m.set(1, 1, end_of(kHeld));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  for (const bool rigid : {false, true}) {
    m.body(2).rigid = rigid;
    if (rigid)
      m.body(2).is_free[1] = 1, m.body(2).load[1] = -1;
    else
      m.set(2, 3, end_of(kPulled, 0, -1));
    std::vector<int32_t> order;
    test::write_file(folder / "deck", deck_of(m, "two blocks", order));
    const test::Result run = test::run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' run deck --json j -q");
    REQUIRE_MESSAGE(run.status == 0, run.err);
    CHECK(test::JsonReader::read(test::read_file(folder / "j"))["force"].has("error") == !rigid);
    m.set(2, 3, End());
  }
}
