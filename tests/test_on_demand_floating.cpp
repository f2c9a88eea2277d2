// Contact on demand of bodies that the contact alone holds, wholly or in some of their motions.
#include "on_demand.hpp"

using namespace demand;

namespace {

// The upper block of many::rough, pressed by a pressure instead.
many::Model floating(int32_t pairs, double pressure = 0.05) {
  many::Model m = many::rough(pairs);
  m.set(2, 3, many::end_of(many::kPulled, 0, -pressure));
  return m;
}

// The line x = 0 is one of symmetry, by images: without the elements on it.
many::Model halved(many::Model m) {
  for (many::Body& body : m.bodies) {
    const int32_t count = body.sides[2].last;
    body.xy.resize(2 * static_cast<size_t>(count + 1));
    body.ends.resize(static_cast<size_t>(count) * static_cast<size_t>(m.function_nodes));
    body.regions = {{1, count}};
    body.sides.resize(3);
    body.open_regions = 1;
  }
  m.symmetry = 1;
  return m;
}

// One more block like the upper one, on top of that.
many::Model stacked(int32_t pairs, double pressure) {
  many::Model m = many::rough(pairs);
  many::Body third = m.body(2);
  for (size_t i = 1; i < third.xy.size(); i += 2) third.xy[i] += 1;
  m.set(2, 3, many::End());
  m.add(third);
  const many::Range below = m.side(2, 3), above = m.side(3, 1);
  m.zones.push_back({C2D_ZONE_MATCHING, {{2, below.first, below.last}, {3, above.last, above.first}}});
  m.set(3, 3, many::end_of(many::kPulled, 0, -pressure));
  return m;
}

} // namespace

TEST_CASE("on demand: a block that the contact alone holds, pressed by a pressure" * doctest::skip(c2d::kSmallCode)) {
  for (double mu : {0.3, 1.5}) {
    CAPTURE(mu);
    many::Model m = floating(300);
    m.friction = mu;
    check_alike(m, 100);
  }
}
TEST_CASE("on demand: a block that is held along x, and one along y, and pressed" * doctest::skip(c2d::kSmallCode)) {
  for (const bool along_x : {false, true})
    for (double mu : {0.0, 0.3}) {
      if (mu == 0 && !along_x) continue; // slides freely
      CAPTURE(mu);
      CAPTURE(along_x);
      many::Model m = many::rough(300);
      m.friction = mu;
      m.set(2, 3, along_x ? many::end_of("1001", 0, -0.05) : many::end_of("0110", 0, 0, 0, -1.5e-4));
      check_alike(m, 100);
    }
}

TEST_CASE("on demand: a floating block on the first side of the zone" * doctest::skip(c2d::kSmallCode)) {
  check_alike(many::with_swapped_sides(floating(300), 1), 100);
}

TEST_CASE("on demand: a point force with a moment, a body force, holes, nu = 1/2" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(200, 0.01);
  m.point_loads.push_back({2, 0.42, 0.6, 0.004, -0.03});
  SUBCASE("point force") {}
  SUBCASE("body force") { m.body(2).force[1] = -0.02, m.body(2).force[0] = 0.001; }
  SUBCASE("holes") {
    for (double x : {0.3, 0.7})
      many::add_curve(m.body(2), 30, [x](double s, double& at, double& up) {
        at = x + 0.1 * std::cos(2 * 3.141592653589793 * s), up = 0.5 - 0.1 * std::sin(2 * 3.141592653589793 * s);
      });
    m.point_loads[0].y = 0.8;
    m.body(2).poisson_ratio = 0.5, m.body(1).poisson_ratio = 0.1;
  }
  check_alike(m, 90);
}

TEST_CASE("on demand: functions of all orders on a floating block" * doctest::skip(c2d::kSmallCode)) {
  for (int32_t nodes : {1, 3, 4}) {
    CAPTURE(nodes);
    many::Model m = quadratic(many::rough(nodes == 1 ? 260 : 120), nodes);
    m.set(2, 3, many::end_of(many::kPulled, 0, -0.03));
    check_alike(m, nodes == 1 ? 100 : 120);
  }
}

TEST_CASE("on demand: a floating block pressed, rubbed to and fro, let go and pressed again" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(200);
  m.cases = 2;
  for (many::Body& body : m.bodies) body.second.assign(body.ends.size(), many::End());
  m.set_second(1, 1, many::end_of(many::kHeld));
  m.set_second(2, 3, many::end_of(many::kPulled, 0.05, 0));
  SUBCASE("rubbed") { m.paths = {{2, 1.0, 0.0}, {2, 1.0, 0.2}, {1, 1.0, -0.2}, {1, 0.6, 0.0}}; }
  SUBCASE("let go") { m.paths = {{1, 1.0, 0.0}, {1, 0.0, 0.0}, {1, 0.8, 0.1}, {1, 0.0, 0.0}}; }
  check_alike(m, 90);
}

TEST_CASE("on demand: a floating block on a line of symmetry, by images and with elements on it" *
          doctest::skip(c2d::kSmallCode)) {
  for (double mu : {0.0, 0.3}) {
    CAPTURE(mu);
    for (bool images : {true, false}) {
      CAPTURE(images);
      many::Model m = images ? halved(floating(200)) : floating(200);
      m.friction = mu;
      for (int32_t body : {1, 2})
        if (!images) m.set(body, 4, many::end_of("1001"));
      check_alike(m, 100);
    }
  }
}

TEST_CASE("on demand: two floating blocks, one on the other" * doctest::skip(c2d::kSmallCode)) {
  check_alike(stacked(150, 0.03), 100);
}

TEST_CASE("on demand: rigid blocks under given forces" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(200);
  m.set(2, 3, many::End());
  many::Body& body = m.body(2);
  body.rigid = 1;
  body.point[0] = 0.5, body.point[1] = 0.5;
  body.load[1] = -0.05, body.load[2] = 0.002;
  SUBCASE("free") { body.is_free[0] = body.is_free[1] = body.is_free[2] = 1; }
  SUBCASE("guided") { body.is_free[1] = 1; }
  SUBCASE("below") {
    body.is_free[0] = body.is_free[1] = body.is_free[2] = 1;
    m = many::with_swapped_sides(m, 1);
  }
  check_alike(m, 90);
}

TEST_CASE("on demand: a floating block with a part of its face that touches from the start" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(300, 0.03);
  for (int32_t i = 100; i < 140; ++i) m.body(2).xy[2 * static_cast<size_t>(i) + 1] = 0;
  check_alike(m, 120);
}

TEST_CASE("on demand: a floating block is pulled off" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(200);
  m.paths = {{1, 1.0}, {1, -0.5}};
  const many::Result dense = many::solve(m);
  many::Machine machine(on_demand(m, 90));
  const many::Result own = machine.run();
  CHECK(own.outcome == C2D_FREE_MOTION);
  CHECK(dense.outcome == own.outcome);
  CHECK(apart(dense, own).tractions < kNear);
}
