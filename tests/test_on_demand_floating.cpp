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

// Geometry of elements with three points: with functions of lower order no rotation strains nothing.
many::Model curved(many::Model m) {
  for (many::Body& body : m.bodies) {
    std::vector<many::End> ends;
    for (size_t e = 0; e < body.ends.size() / 4; ++e) ends.insert(ends.end(), 2, body.ends[4 * e]);
    body.ends = ends;
    body.element_nodes = 3;
    for (many::Range* range : {&body.regions[0], &body.sides[0], &body.sides[1], &body.sides[2], &body.sides[3]})
      range->first = (range->first + 1) / 2, range->last /= 2;
  }
  for (many::Side& side : m.zones[0].side) side.first = (side.first + 1) / 2, side.last = (side.last + 1) / 2;
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

TEST_CASE("on demand: a floating block with curved elements" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(417); // 208 elements of the face, 26 of the other sides
  m.set(2, 3, many::end_of(many::kPulled, 0.001, -0.04));
  check_alike(curved(m), 90);
}

TEST_CASE("on demand: overlaps that are closed push a floating block off" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(200);
  for (size_t i = 1; i < m.body(2).xy.size(); i += 2) m.body(2).xy[i] -= 2e-5;
  m.cases = m.interference = 2;
  for (many::Body& body : m.bodies) body.second.assign(body.ends.size(), many::End());
  m.set_second(1, 1, many::end_of(many::kHeld));
  m.set_second(2, 3, many::end_of(many::kPulled));
  m.paths = {{1, 1.0, 1.0}, {1, 0.5, 1.0}};
  check_alike(m, 90);
}

TEST_CASE("on demand: friction told after a preparation without, on a line of symmetry" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = halved(floating(200));
  m.friction = 0;
  many::Machine whole(m), own(on_demand(m, 90));
  std::vector<double> result[2];
  for (int k = 0; k < 2; ++k) {
    c2d_solver* const s = (k == 0 ? whole : own).solver;
    REQUIRE(c2d_prepare(s) == C2D_OK);
    for (const double mu : {0.0, 0.4}) {
      REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
      const double all = 1;
      c2d_outcome outcome = C2D_UNDECIDED;
      REQUIRE(c2d_advance(s, &all, 1, &outcome) == C2D_OK);
      CHECK(outcome == C2D_REACHED);
      for (const int32_t field : {C2D_TN, C2D_TT, C2D_UN1, C2D_UN2}) {
        std::vector<double> of(200);
        REQUIRE(c2d_get(s, field, 0, 1, 200, of.data(), 1) == C2D_OK);
        result[k].insert(result[k].end(), of.begin(), of.end());
      }
    }
  }
  double size = 0, apart_by = 0;
  for (size_t i = 0; i < result[0].size(); ++i)
    size = std::max(size, std::fabs(result[0][i])), apart_by = std::max(apart_by, std::fabs(result[0][i] - result[1][i]));
  CHECK(apart_by < kNear * size);
}

TEST_CASE("on demand: points inside a floating block, the residual, forces" * doctest::skip(c2d::kSmallCode)) {
  const many::Model m = floating(200);
  many::Machine whole(m), own(on_demand(m, 90));
  const many::Result a = whole.run(), b = own.run();
  REQUIRE(b.status == C2D_OK);
  std::vector<double> xy, in[2];
  for (int k = 0; k < 40; ++k) xy.insert(xy.end(), {0.02 + 0.024 * k, 0.02 + 0.02 * k});
  for (int k = 0; k < 2; ++k) {
    in[k].resize(40 * C2D_POINT_FIELDS);
    REQUIRE(c2d_interior((k == 0 ? whole : own).solver, 2, 40, xy.data(), 2, in[k].data(), C2D_POINT_FIELDS) == C2D_OK);
  }
  for (bool stresses : {false, true}) {
    double size = 0, apart_by = 0;
    for (size_t i = 0; i < in[0].size(); ++i) {
      if ((i % C2D_POINT_FIELDS >= C2D_POINT_SXX) != stresses) continue;
      size = std::max(size, std::fabs(in[0][i])), apart_by = std::max(apart_by, std::fabs(in[0][i] - in[1][i]));
    }
    CHECK(apart_by < 10 * kNear * size);
  }
  CHECK(b.summary.compression_residual > 0);
  CHECK(b.summary.compression_residual < (kIsDouble ? 1e-10 : 1e-3));
  for (size_t k = 0; k < a.bodies.size(); ++k)
    for (int c = 0; c < 3; ++c) CHECK(a.bodies[k].contact[c] == doctest::Approx(b.bodies[k].contact[c]).epsilon(1e-7));
  CHECK(many::imbalance(m, b) < kNear);
}

// ---- saved, moved, failing, cut off ------------------------------------------------------------------------------------

namespace {

many::Model little() { return on_demand(floating(100, 0.03), 80); }

} // namespace

TEST_CASE("on demand: states of a floating block are taken up by another process; same bits" * doctest::skip(c2d::kSmallCode)) {
  Host whole(little());
  REQUIRE(whole.begin() == C2D_OK);
  REQUIRE(whole.go(1) == C2D_OK);
  const std::vector<double> expected = whole.results();
  for (const double at : {0.0, 0.4}) { // 0: it lies nowhere yet
    CAPTURE(at);
    Host first(little());
    REQUIRE(first.begin() == C2D_OK);
    CHECK(first.solver()->floating == 1);
    if (at > 0) REQUIRE(first.go(at) == C2D_OK);
    CHECK(first.solver()->floating == (at > 0 ? 0 : 1));
    REQUIRE(c2d_save(first.solver()) == C2D_OK);
    runs::RamStore kept = first.own;
    REQUIRE(first.go(1) == C2D_OK);
    const std::vector<double> on = first.results();
    if (at == 0) CHECK(on == expected);
    Host second(little(), &kept);
    REQUIRE(c2d_restore(second.solver()) == C2D_OK);
    REQUIRE(second.go(1) == C2D_OK);
    CHECK(second.results() == on);
    CHECK(second.machine->guards_are_whole());
  }
}

TEST_CASE("on demand: a floating block that has been let go is taken up and pressed again" * doctest::skip(c2d::kSmallCode)) {
  Host first(little());
  REQUIRE(first.begin() == C2D_OK);
  REQUIRE(first.go(1) == C2D_OK);
  REQUIRE(first.go(0) == C2D_OK);
  REQUIRE(c2d_save(first.solver()) == C2D_OK);
  runs::RamStore kept = first.own;
  REQUIRE(first.go(0.7) == C2D_OK);
  Host second(little(), &kept);
  REQUIRE(c2d_restore(second.solver()) == C2D_OK);
  REQUIRE(second.go(0.7) == C2D_OK);
  CHECK(second.results() == first.results());
}

TEST_CASE("on demand: a state without friction is taken up when friction has been told since" *
          doctest::skip(c2d::kSmallCode)) {
  for (bool floats : {false, true}) {
    CAPTURE(floats);
    many::Model m = on_demand(floats ? halved(floating(100, 0.03)) : many::rough(100), 80);
    m.friction = 0;
    Host host(m);
    REQUIRE(c2d_prepare(host.solver()) == C2D_OK);
    const double mu[] = {0, 0.4};
    REQUIRE(c2d_begin(host.solver(), &mu[0], 1) == C2D_OK);
    REQUIRE(host.go(0.5) == C2D_OK);
    REQUIRE(host.solver()->sliding == 1);
    REQUIRE(c2d_save(host.solver()) == C2D_OK);
    REQUIRE(host.go(1) == C2D_OK);
    const std::vector<double> expected = host.results();
    REQUIRE(c2d_begin(host.solver(), &mu[1], 1) == C2D_OK);
    REQUIRE(host.go(1) == C2D_OK);
    REQUIRE(host.solver()->sliding == 0);
    REQUIRE(c2d_restore(host.solver()) == C2D_OK);
    CHECK(host.solver()->sliding == 1);
    REQUIRE(host.go(1) == C2D_OK);
    const std::vector<double> there = host.results(); // (columns were made in other company: last digits differ)
    double size = 0, apart_by = 0;
    for (size_t i = 0; i < 400; ++i) // tractions and displacements
      size = std::max(size, std::fabs(expected[i])), apart_by = std::max(apart_by, std::fabs(there[i] - expected[i]));
    CHECK(apart_by < kNear * size);
    CHECK(std::equal(there.begin() + 400, there.begin() + 500, expected.begin() + 400));               // statuses
    for (size_t i = 600; i < 603; ++i) CHECK(there[i] == doctest::Approx(expected[i]).epsilon(kNear)); // energies
  }
}

TEST_CASE("on demand: a store that fails at any operation with a floating block" * doctest::skip(c2d::kSmallCode)) {
  check_failing_store(little(), 30);
}

TEST_CASE("on demand: cancelled at any chance a floating block goes on to the same bits" * doctest::skip(c2d::kSmallCode)) {
  check_cancelled(little());
}

TEST_CASE("on demand: slender floating blocks as with the whole contact system, and those that bend too much refused" *
          doctest::skip(c2d::kSmallCode)) {
  for (double height : {0.01, 0.05, 10.0}) {
    CAPTURE(height);
    many::Model m = floating(200, height > 1 ? 0.05 : 1e-3);
    for (size_t i = 1; i < m.body(2).xy.size(); i += 2)
      if (m.body(2).xy[i] > 0.03) m.body(2).xy[i] *= height;
    if (height > 0.03) {
      check_alike(m, 90);
      continue;
    }
    many::Machine machine(on_demand(m, 90));
    const many::Result r = machine.run();
    CHECK(r.status == C2D_ERR_LIMIT);
    CHECK_MESSAGE(r.told_of("cannot be on demand"), r.messages());
  }
}
