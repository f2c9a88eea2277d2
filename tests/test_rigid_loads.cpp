// Rigid bodies with free motions: the force and the moment on them are given, where they go follows.
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;
using namespace solved_bodies;

namespace {

void load(Body& body, double fx, double fy, double moment, double x, double y, const char* motions = "XYT") {
  body.rigid = 1;
  const std::string words = motions;
  for (int i = 0; i < 3; ++i) body.is_free[i] = words.find("XYT"[i]) != std::string::npos;
  body.load[0] = fx, body.load[1] = fy, body.load[2] = moment;
  body.point[0] = x, body.point[1] = y;
}

// A plate on rollers, 3 wide, and a rigid platen of the same width on it. rigid_side: which side of the zone the platen is.
Model platen(int32_t kind, int rigid_side, double mu, int32_t elements = 4, int32_t function_nodes = 2) {
  Model m;
  m.function_nodes = function_nodes;
  const bool same = kind % 2 == C2D_ZONE_MATCHING;
  m.add(rectangle(0, 0, 3, 1, {6, 2, 6, 2}, 100));
  m.add(rectangle(0, 1, 3, 1.5, {same ? 6 : elements, 1, 3, 1}));
  m.set(1, 1, end_of("0110"));
  m.body(1).ends[0] = end_of(kHeld);
  load(m.body(2), 0, -3, 0, 1.5, 1.5);
  if (rigid_side == 1)
    m.join(kind, 1, 3, 2, 1);
  else
    m.join(kind, 2, 1, 1, 3);
  m.friction = mu;
  m.paths = {{2, 1.0}};
  return m;
}

// The platen's balance, its motion as that of its mesh, and the laws.
void check_laws(const Model& m, const Result& r) {
  CHECK(breach(m, r) == "");
  CHECK(imbalance(m, r) < 1e-12);
  for (size_t b = 0; b < m.bodies.size(); ++b) {
    if (m.bodies[b].rigid == 0) continue;
    for (int k = 0; k < 2; ++k)
      if (m.bodies[b].is_free[k] != 0)
        CHECK(std::fabs(r.bodies[b].contact[k] + m.bodies[b].load[k]) <=
              1e-12 * std::hypot(m.bodies[b].load[0], m.bodies[b].load[1]));
  }
}

// (ux, uy, rotation) of a rigid body about the origin, from its mesh.
std::array<double, 3> motion_of(const Result& r, size_t body) {
  const EndResult &a = r.boundary[body][0], *b = &a;
  for (const EndResult& e : r.boundary[body])
    if (std::hypot(e.x - a.x, e.y - a.y) > std::hypot(b->x - a.x, b->y - a.y)) b = &e;
  const double dx = b->x - a.x, dy = b->y - a.y;
  const double turn = (dx * (b->uy - a.uy) - dy * (b->ux - a.ux)) / (dx * dx + dy * dy);
  return {a.ux + turn * a.y, a.uy - turn * a.x, turn};
}

} // namespace

TEST_CASE("rigid loads: a platen with a centred force, smooth or tied, presses evenly") {
  for (const int32_t kind : kKinds)
    for (const int rigid_side : {0, 1}) {
      CAPTURE(kind);
      CAPTURE(rigid_side);
      const Model m = platen(kind, rigid_side, 0);
      const Result r = solved(m);
      check_laws(m, r);
      for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10);
      CHECK(std::fabs(r.last().defect) < 1e-9);
      CHECK(std::fabs(motion_of(r, 1)[1] + 1 / (100 / 0.91)) < 1e-12);
      CHECK(std::fabs(r.last().work - 0.5 * 3 / (100 / 0.91)) < 1e-11);
      CHECK(std::fabs(motion_of(r, 1)[2]) < 1e-12);
      CHECK(std::fabs(r.bodies[1].applied[1] + 3) < 1e-12);
      CHECK(std::fabs(r.bodies[1].applied[2] + 4.5) < 1e-11);
    }
}

TEST_CASE("rigid loads: force and moment are what the contact transmits, on either side of a free zone, in any order") {
  for (const int32_t kind : kKinds)
    for (const int rigid_side : {0, 1}) {
      CAPTURE(kind);
      CAPTURE(rigid_side);
      Model m = platen(kind, rigid_side, 0.2);
      m.body(2).load[0] = 0.3, m.body(2).load[2] = -0.3;
      const Result r = solved(m);
      check_laws(m, r);
      CHECK(std::fabs(r.last().defect) < 1e-9);
      CHECK(r.last().dissipated > 0);
      const double sign = rigid_side == 1 ? 1 : -1; // force on side 2
      CHECK(std::fabs(r.zones[0].force[0] + sign * 0.3) < 1e-12);
      CHECK(std::fabs(r.zones[0].force[1] - sign * 3) < 1e-12);
      CHECK(std::fabs(r.zones[0].moment - sign * (4.5 + 0.3 + 0.3 * 1.5)) < 1e-10);
      CHECK(difference(r, solved(with_bodies_in_order(m, {2, 1}))) < 1e-10);
      Mapping mirror;
      mirror.tangential = -1;
      mirror.place = [](double& x, double&) { x = -x; };
      CHECK(difference(r, solved(reflected(m)), mirror) < 1e-10);
      Mapping units;
      units.length = 1e-3, units.stress = 1e5;
      units.place = [](double& x, double& y) { x *= 1e-3, y *= 1e-3; };
      CHECK(difference(r, solved(scaled(m, 1e-3, 1e5)), units) < 1e-10);
    }
}

TEST_CASE("rigid loads: a moment is a force that is shifted") {
  for (const int32_t kind : {0, 1, 2, 3}) {
    CAPTURE(kind);
    Model turned = platen(kind, 1, 0.2), shifted = turned;
    turned.body(2).load[2] = -3 * 0.2;
    shifted.body(2).point[0] += 0.2;
    const Result a = solved(turned), b = solved(shifted);
    CHECK(difference(a, b) < 1e-10);
    for (size_t k = 0; k < 3; ++k) CHECK(std::fabs(motion_of(a, 1)[k] - motion_of(b, 1)[k]) < 1e-12);
    CHECK(motion_of(a, 1)[2] < -1e-4);
  }
}

TEST_CASE("rigid loads: motions that are given, and motions that are free") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    // Y alone is free: sideways it is moved, so that friction slips, and it does not turn.
    Model m = platen(kind, 1, 0.3);
    load(m.body(2), 0, -3, 7, 1.5, 1.5, "Y");
    m.body(2).load[0] = -1e9; // not looked at
    m.body(2).motion[0] = 0.2, m.body(2).motion[1] = 44, m.body(2).motion[2] = 0.001;
    m.body(1).ends[0] = end_of(kHeld);
    m.set(1, 1, end_of(kHeld));
    const Result r = solved(m);
    CHECK(breach(m, r) == "");
    CHECK(imbalance(m, r) < 1e-12);
    const std::array<double, 3> motion = motion_of(r, 1);
    CHECK(std::fabs(motion[0] - (0.2 + 0.001 * 1.5)) < 1e-13); // rotation of 0.001 about (1.5, 1.5)
    CHECK(std::fabs(motion[2] - 0.001) < 1e-13);
    CHECK(std::fabs(r.bodies[1].contact[1] - 3) < 1e-12);
    // The same by the motion that followed: then the force follows.
    Model given = m;
    std::fill(given.body(2).is_free, given.body(2).is_free + 3, 0);
    given.body(2).motion[1] = motion[1] + motion[2] * 1.5;
    const Result moved = solved(given);
    Result a = r, b = moved;
    a.steps.erase(a.steps.begin(), a.steps.end() - 1), b.steps.erase(b.steps.begin(), b.steps.end() - 1);
    // Its path is another: the uy of the first grows in another way with the load; the end is the same where all slips.
    bool all_slip = true;
    for (const Row& row : a.last().rows) all_slip = all_slip && static_cast<int>(row[C2D_STATUS]) != C2D_STICK;
    CHECK(all_slip);
    for (size_t i = 0; i < a.last().rows.size(); ++i)
      for (const int field : {C2D_TN, C2D_TT})
        CHECK(std::fabs(a.last().rows[i][static_cast<size_t>(field)] - b.last().rows[i][static_cast<size_t>(field)]) < 1e-9);
  }
}

TEST_CASE("rigid loads: a tied platen is pulled and turned") {
  for (const int32_t kind : kKinds)
    for (const int rigid_side : {0, 1}) {
      CAPTURE(kind);
      CAPTURE(rigid_side);
      Model m = platen(kind + C2D_ZONE_TIED, rigid_side, 0);
      load(m.body(2), 0.5, 3, 0.4, 1.5, 1.5);
      m.paths = {{1, 1.0}, {2, -1.0}};
      const Result r = solved(m);
      CHECK(breach(m, r) == "");
      CHECK(imbalance(m, r) < 1e-12);
      CHECK(std::fabs(r.bodies[1].contact[0] - 0.5) < 1e-12);
      CHECK(std::fabs(r.bodies[1].contact[1] - 3) < 1e-12);
      const Row &one = r.steps[0].rows[2], &last = r.last().rows[2];
      CHECK(std::fabs(one[C2D_TN] + last[C2D_TN]) < 1e-10 * std::fabs(one[C2D_TN]));
      CHECK(r.steps[0].rows[2][C2D_TN] < 0);
      CHECK(std::fabs(r.last().work - r.steps[0].work) < 1e-10 * r.steps[0].work);
      // Its motion, given, needs these forces.
      Model given = m;
      const std::array<double, 3> motion = motion_of(r, 1);
      std::fill(given.body(2).is_free, given.body(2).is_free + 3, 0);
      given.paths = {{1, 1.0}};
      std::copy(motion.begin(), motion.end(), given.body(2).motion);
      given.body(2).point[0] = given.body(2).point[1] = 0;
      const Result moved = solved(given);
      for (int k = 0; k < 3; ++k) CHECK(std::fabs(moved.bodies[1].contact[k] - r.bodies[1].contact[k]) < 1e-10 * 3);
    }
}

// ---- a cylinder between two rigid plates

namespace {

// The half x >= 0, smooth.
Model cylinder(bool by_force) {
  const double turn = 2 * std::acos(-1.0), zone = 0.2; // contact as far as this angle
  const int n = 40, between = 24;
  Body disc;
  disc.youngs_modulus = 1000, disc.poisson_ratio = 0.3;
  for (int k = 0; k <= 2 * n + between; ++k) {
    double angle = -turn / 4;
    if (k <= n)
      angle += zone * k / n;
    else if (k <= n + between)
      angle += zone + (turn / 2 - 2 * zone) * (k - n) / between;
    else
      angle += turn / 2 - zone + zone * (k - n - between) / n;
    disc.xy.insert(disc.xy.end(), {std::cos(angle), 1 + std::sin(angle)});
  }
  disc.xy[0] = disc.xy[disc.xy.size() - 2] = 0;
  disc.regions = {{1, 2 * n + between}};
  disc.sides = {{1, n}, {n + between + 1, 2 * n + between}};
  disc.open_regions = 1;
  Model m;
  m.add(disc);
  const double w = std::sin(zone) * 1.05;
  m.add(open_polygon({{0, -0.3, 2}, {w, -0.3, 2}, {w, 0, 20}, {0, 0, 0}}));
  m.add(open_polygon({{0, 2, 20}, {w, 2, 2}, {w, 2.3, 2}, {0, 2.3, 0}}));
  m.body(2).rigid = m.body(3).rigid = 1;
  if (by_force) load(m.body(3), 0, -4, 0, 0, 2, "Y");
  m.join(C2D_ZONE_FREE, 2, 3, 1, 1);
  m.join(C2D_ZONE_FREE, 3, 1, 1, 2);
  m.symmetry = 1;
  m.paths = {{1, 1.0}};
  return m;
}

} // namespace

TEST_CASE("rigid loads: a cylinder between a loaded plate and a held one") {
  const Model m = cylinder(true);
  const Result r = solved(m);
  check_laws(m, r);
  CHECK(std::fabs(r.bodies[1].contact[1] + 4) < 1e-11); // the held one carries it
  CHECK(std::fabs(r.bodies[1].applied[1] - 4) < 1e-11);
  const double pi = std::acos(-1.0), a = std::sqrt(4 * 8 / (pi * 1000 / 0.91)), p0 = 2 * 8 / (pi * a); // of the whole
  for (int32_t zone = 1; zone <= 2; ++zone) {
    double peak = 0, edge = 0;
    for (const Row& row : r.zone_rows(zone)) {
      peak = std::max(peak, row[C2D_TN]);
      if (static_cast<int>(row[C2D_STATUS]) != C2D_OPEN) edge = std::max(edge, std::fabs(row[C2D_X]));
    }
    CHECK(std::fabs(peak / p0 - 1) < 0.01); // a/R is 0.1
    CHECK(std::fabs(edge - a) < 0.2 / 40);
  }
  // Moved as far by hand.
  Model given = cylinder(false);
  given.body(3).motion[1] = motion_of(r, 2)[1];
  const Result moved = solved(given);
  CHECK(std::fabs(moved.bodies[2].applied[1] + 4) < 1e-10 * 4);
  REQUIRE(moved.last().rows.size() == r.last().rows.size());
  for (size_t i = 0; i < r.last().rows.size(); ++i)
    CHECK(std::fabs(r.last().rows[i][C2D_TN] - moved.last().rows[i][C2D_TN]) < 1e-10 * p0);
}

// ---- new loads

TEST_CASE("rigid loads: another force on a model that is prepared") {
  for (const int32_t keep_factors : {0, 1})
    for (const int32_t kind : kKinds) {
      CAPTURE(keep_factors);
      CAPTURE(kind);
      const Model m = platen(kind, 1, 0.2);
      Model other = m;
      load(other.body(2), 0.2, -4, 0.5, 1.5, 1.5);
      const Result fresh = solved(other);
      Machine machine(m, keep_factors);
      REQUIRE(machine.run().status == C2D_OK);
      REQUIRE(c2d_change_loads(machine.solver) == C2D_OK);
      REQUIRE(c2d_set_rigid_load(machine.solver, 2, 1, nullptr, other.body(2).load, nullptr) == C2D_OK);
      const Result r = machine.run();
      REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
      CHECK(difference(fresh, r) < 1e-10);
    }
}

// ---- what is refused

TEST_CASE("rigid loads: a force that nothing holds") {
  Model m = platen(C2D_ZONE_MATCHING, 1, 0.1);
  m.body(2).load[0] = 0.5;
  Result r = solve(m);
  CHECK(r.outcome == C2D_GROSS_SLIDING);
  CHECK(r.summary.outcome_body == 2);
  CHECK(r.summary.free_motion[0] > 0);
  CHECK(std::fabs(r.summary.free_motion[2]) < 1e-9);
  m = platen(C2D_ZONE_MATCHING, 1, 0.1);
  m.body(2).load[1] = 3; // off it goes
  r = solve(m);
  CHECK(r.outcome == C2D_FREE_MOTION);
  CHECK(r.summary.outcome_body == 2);
  CHECK(r.summary.free_motion[1] > 0);
  m = platen(C2D_ZONE_MATCHING, 1, 0.5);
  m.body(2).point[0] = 3.2; // beyond its edge
  r = solve(m);
  CHECK(r.outcome == C2D_TIPPING);
  CHECK(r.summary.outcome_body == 2);
  CHECK(r.summary.free_motion[2] < 0);
}

TEST_CASE("rigid loads: bad numbers, the wrong state, lines of symmetry, rigid on rigid") {
  const Model m = platen(C2D_ZONE_MATCHING, 1, 0.2);
  const double force[3] = {0, -1, 0}, point[2] = {0, 0}, bad[3] = {0, std::nan(""), 0};
  const int32_t all[3] = {1, 1, 1};
  {
    Machine machine(m);
    c2d_solver* s = machine.solver;
    REQUIRE(machine.status == C2D_OK);
    CHECK(c2d_set_rigid_load(s, 0, 1, nullptr, force, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(c2d_set_rigid_load(s, 3, 1, nullptr, force, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(c2d_set_rigid_load(s, 2, 2, nullptr, force, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(c2d_set_rigid_load(s, 2, -1, nullptr, force, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(c2d_set_rigid_load(s, 2, 1, nullptr, nullptr, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(c2d_set_rigid_load(s, 2, 1, nullptr, bad, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(c2d_set_rigid_load(s, 2, 0, all, nullptr, point) == C2D_ERR_STATE);     // said too late
    CHECK(c2d_set_rigid_load(s, 1, 1, nullptr, force, nullptr) == C2D_ERR_STATE); // not one of those
    CHECK(c2d_set_rigid_load(s, 2, 1, nullptr, force, nullptr) == C2D_OK);
    REQUIRE(machine.run().status == C2D_OK);
    CHECK(c2d_set_rigid_load(s, 2, 1, nullptr, force, nullptr) == C2D_ERR_STATE); // c2d_change_loads first
    CHECK(c2d_set_rigid_load(nullptr, 2, 1, nullptr, force, nullptr) == C2D_ERR_ARGUMENT);
  }
  Model image;
  image.add(open_polygon({{0, 0, 4}, {2, 0, 3}, {2, 1, 5}, {0, 1, 0}}, 1000));
  image.add(open_polygon({{0, 1, 5}, {2, 1, 1}, {2, 2, 2}, {0, 2, 0}}));
  image.set(1, 1, end_of("0110"));
  image.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  image.symmetry = 1;
  for (const char* motions : {"X", "T", "XY", "YT", "XYT"}) {
    CAPTURE(motions);
    load(image.body(2), 0, -2, 0, 0, 2, motions);
    const Result r = solve(image);
    CHECK(r.status == C2D_ERR_INPUT);
    CHECK(r.told_of("the rigid body 2 may move freely across a line of symmetry"));
  }
  load(image.body(2), 0, -2, 0, 0, 2, "Y");
  const Result half = solved(image);
  for (const Row& row : half.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10); // the force of the half that is modelled

  Model both = m;
  both.body(1).rigid = 1;
  const Result r = solve(both);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.told_of("zone 1: bodies 1 and 2 are both rigid, expected one at most"));
}

TEST_CASE("rigid loads: the moment on a rigid body on side 1 of a free zone") {
  for (const int32_t kind : {1, 3}) {
    Model m = platen(kind, 0, 0.2, 5);
    m.body(2).load[2] = -0.3;
    const Result r = solved(m);
    CHECK(imbalance(m, r) < 1e-12);
    CHECK(std::fabs(r.zones[0].moment + 4.8) < 1e-10);
  }
}

// More pairs than nodes of the elastic surface: as side 1 it may be finer.
TEST_CASE("rigid loads: a rigid body of finer elements on side 2 of a free zone") {
  for (const int32_t nodes : {1, 2, 3})
    for (const int32_t kind : {1, 3})
      for (const int32_t elements : {3, 4, 5, 6, 7, 12}) {
        CAPTURE(nodes);
        CAPTURE(elements);
        const Result r = solve(platen(kind, 1, 0, elements, nodes));
        if (elements <= 6) CHECK_MESSAGE(r.status == C2D_OK, r.messages());
        if (elements > 6) CHECK_MESSAGE(r.status == C2D_ERR_INPUT, r.messages());
        if (elements > 6) CHECK(r.told_of("zone 1: the mesh of the rigid body 2 is finer than that of body 1"));
      }
  CHECK(solved(platen(C2D_ZONE_FREE, 0, 0, 7)).outcome == C2D_REACHED);
  Model graded = platen(C2D_ZONE_FREE, 1, 0); // fewer of them, three on one element
  Body& body = graded.body(2);
  const std::vector<End> ends = body.ends;
  body = polygon({{0, 1, 4, 4.0}, {3, 1, 1}, {3, 1.5, 3}, {0, 1.5, 1}});
  body.ends = ends;
  load(body, 0, -3, 0, 1.5, 1.5);
  CHECK(solve(graded).told_of("up to element 14;"));
}
