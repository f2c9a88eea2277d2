// Platens: ends of a body that move as one rigid body, against closed forms, a rigid body that is drawn and tied, prescribed
// displacements, and themselves told otherwise.
#include "contact2d_memory.h"
#include "json.hpp"
#include "many_bodies.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;

namespace {

const std::string kProgram = "'" + paths::program() + "'";

using Three = std::array<double, 3>;

Result solved(const Model& m, int32_t stepping = C2D_STEPPING_EVENTS) {
  const Result r = solve(m, stepping);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE_MESSAGE(r.outcome == C2D_REACHED, c2d_outcome_message(r.outcome) << "\n" << r.messages());
  return r;
}

void load(Platen& p, double fx, double fy, double moment, double x, double y) {
  p.load[0] = fx, p.load[1] = fy, p.load[2] = moment;
  p.point[0] = x, p.point[1] = y;
}

// A block on a foundation that is held below, with friction. Without a platen yet.
Model block(int32_t function_nodes = 2) {
  Model m;
  m.function_nodes = function_nodes;
  m.add(rectangle(-1, -2, 3, 0, {8, 4, 8, 4}));
  m.add(rectangle(0, 0, 2, 1, {4, 3, 4, 3}, 400, 0.25));
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * function_nodes), End());
  m.set(1, 1, end_of(kHeld));
  // Of the foundation's upper side the elements below the block.
  const Range top = m.side(1, 3), low = m.side(2, 1);
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, top.first + 2, top.first + 5}, {2, low.last, low.first}}});
  m.friction = 0.3;
  m.paths = {{2, 1.0}, {3, 0.5}};
  return m;
}
Model pressed(int32_t function_nodes = 2) {
  Model m = block(function_nodes);
  load(m.move(2, 3), 0.5, -3, 0.2, 1, 1);
  return m;
}

// The same with a rigid body drawn on the block, on side 1 of a tie.
Model drawn(Model m) {
  const Platen p = m.platens.at(0);
  m.platens.clear();
  Body& top = m.body(m.add(rectangle(0, 1, 2, 1.3, {4, 1, 4, 1})));
  top.ends.assign(static_cast<size_t>(top.elements() * m.function_nodes), End());
  top.rigid = 1;
  std::copy(p.is_free, p.is_free + 3, top.is_free);
  std::copy(p.load, p.load + 3, top.load);
  std::copy(p.motion, p.motion + 3, top.motion);
  std::copy(p.point, p.point + 2, top.point);
  m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 3, 1, 2, 3);
  return m;
}

Three motion_of(const Result& r, size_t body) {
  const double* u = r.states.at(body).motion;
  return {u[0], u[1], u[2]};
}
Three force_on_bodies(const Result& r, size_t body) { // what a platen hands over, moment about the origin
  const double* f = r.states.at(body).contact;
  return {-f[0], -f[1], -f[2]};
}
double distance(const Three& a, const Three& b) {
  double most = 0;
  for (size_t k = 0; k < 3; ++k) most = std::max(most, std::fabs(a[k] - b[k]));
  return most;
}

// A strip held at the left, nu = 0 in plane stress: bent by its ends alone without any disturbance.
struct Strip {
  double length = 10, height = 1, modulus = 1000;
  Model model(const char* free, double angle = 0) const {
    Model m;
    m.plane = C2D_PLANE_STRESS;
    m.function_nodes = 3;
    m.add(rectangle(0, -0.5, length, 0.5, {12, 4, 12, 4}, modulus, 0));
    m.body(1).ends.assign(static_cast<size_t>(m.body(1).elements() * m.function_nodes), End());
    m.set(1, 4, end_of(kHeld));
    Platen& p = m.move(1, 2);
    p.point[0] = length;
    for (int k = 0; k < 3; ++k) p.is_free[k] = free[k] == '1';
    m.paths = {{1, 1.0}};
    return angle == 0 ? m : turned(m, angle);
  }
  double inertia() const { return height * height * height / 12; }
};

} // namespace

TEST_CASE("platens: tension and bending of a strip with a rigid end, in any direction, closed form") {
  const Strip s;
  for (const double angle : {0.0, 90.0, 30.0}) {
    CAPTURE(angle);
    Model m = s.model("111");
    m.platens[0].load[0] = 2, m.platens[0].load[2] = 0.5;
    if (angle != 0) m = turned(m, angle);
    const Result r = solved(m);
    const double turn = 0.5 * s.length / (s.modulus * s.inertia()), pull = 2 * s.length / (s.modulus * s.height);
    const double down = 0.5 * turn * s.length, c = std::cos(angle * std::acos(-1.0) / 180),
                 n = std::sin(angle * std::acos(-1.0) / 180);
    const Three found = motion_of(r, 1), truth = {c * pull - n * down, n * pull + c * down, turn};
    CHECK(distance(found, truth) < 1e-9 * down);
    CHECK(std::fabs(r.last().work - 0.5 * (2 * pull + 0.5 * turn)) < 1e-9 * r.last().work);
    CHECK(std::fabs(r.last().elastic - r.last().work) < 1e-9 * r.last().work);
    CHECK(imbalance(m, r) < 1e-12);
    CHECK(std::fabs(r.states[1].load[2] - (0.5 + m.platens[0].point[0] * m.platens[0].load[1] -
                                           m.platens[0].point[1] * m.platens[0].load[0])) < 1e-12);
  }
}

TEST_CASE("platens: a force across a strip bends it as a beam with shear") {
  const Strip s;
  Model m = s.model("111");
  m.platens[0].load[1] = 1;
  const Result r = solved(m);
  const double bending = std::pow(s.length, 3) / (3 * s.modulus * s.inertia());
  const double shear = 1.2 * s.length / (0.5 * s.modulus * s.height);
  CHECK(std::fabs(motion_of(r, 1)[1] - bending - shear) < 0.002 * bending);
  CHECK(std::fabs(motion_of(r, 1)[2] - s.length * s.length / (2 * s.modulus * s.inertia())) < 0.002 * motion_of(r, 1)[2]);
  CHECK(std::fabs(r.last().work - 0.5 * motion_of(r, 1)[1]) < 1e-12 * r.last().work);
  CHECK(std::fabs(r.last().defect) < 1e-4);
}

TEST_CASE("platens: motions that are given carry the force that makes them, and a moment turns what is free") {
  const Strip s;
  Model m = s.model("101");                                                               // uy is given
  m.platens[0].motion[1] = 0.01, m.platens[0].motion[0] = 77, m.platens[0].load[1] = 1e9; // these two are not looked at
  m.platens[0].load[0] = 2;
  const Result r = solved(m);
  const Three u = motion_of(r, 1);
  CHECK(std::fabs(u[1] - 0.01) < 1e-15);
  CHECK(std::fabs(u[0] - 2 * s.length / (s.modulus * s.height)) < 1e-9 * u[0]);
  const Three f = force_on_bodies(r, 1);
  CHECK(std::fabs(f[0] - 2) < 1e-12);
  CHECK(std::fabs(f[2] - s.length * f[1]) < 1e-11); // no moment about the end
  // That force, given, makes that motion.
  Model back = s.model("111");
  back.platens[0].load[0] = 2, back.platens[0].load[1] = f[1];
  CHECK(distance(motion_of(solved(back), 1), u) < 1e-11);
  // So does all of the motion.
  Model given = s.model("000");
  for (size_t k = 0; k < 3; ++k) given.platens[0].motion[k] = u[k];
  const Result moved = solved(given);
  CHECK(distance(force_on_bodies(moved, 1), f) < 1e-10);
  CHECK(std::fabs(moved.last().elastic - r.last().elastic) < 1e-9 * r.last().elastic);
  CHECK(std::fabs(moved.last().work - moved.last().elastic) < 1e-12 * moved.last().elastic);
}

TEST_CASE("platens: work is force times motion, given or found, however coarse the mesh") {
  for (const int32_t function_nodes : {1, 2, 3}) {
    CAPTURE(function_nodes);
    Model m;
    m.function_nodes = function_nodes;
    m.add(rectangle(0, 0, 1, 1, {2, 2, 2, 2}));
    m.body(1).ends.assign(static_cast<size_t>(m.body(1).elements() * function_nodes), End());
    m.set(1, 1, end_of(kHeld));
    Platen& p = m.move(1, 3);
    p.point[0] = 0.3, p.point[1] = 1;
    m.paths = {{1, 1.0}};
    std::fill(p.is_free, p.is_free + 3, 0);
    p.motion[0] = 2e-4, p.motion[1] = -1e-3, p.motion[2] = 3e-3;
    const Result given = solved(m);
    const Three f = force_on_bodies(given, 1), load = {f[0], f[1], f[2] - (0.3 * f[1] - f[0])}; // about the point
    const double work = 0.5 * (load[0] * p.motion[0] + load[1] * p.motion[1] + load[2] * p.motion[2]);
    CHECK(std::fabs(given.last().work - work) < 1e-12 * work);
    CHECK(std::fabs(given.last().elastic - work) < 1e-12 * work);
    std::fill(p.is_free, p.is_free + 3, 1);
    std::copy(load.begin(), load.end(), p.load);
    std::fill(p.motion, p.motion + 3, 0.0);
    const Result found = solved(m);
    CHECK(std::fabs(found.last().work - work) < 1e-10 * work);
    CHECK(std::fabs(found.last().elastic - work) < 1e-10 * work);
    CHECK(distance(motion_of(found, 1), motion_of(given, 1)) < 1e-12);
  }
}

TEST_CASE("platens: what a rigid body that is drawn and tied does") {
  for (const int32_t function_nodes : {1, 2, 3, 4})
    for (const int32_t stepping : {C2D_STEPPING_EVENTS, C2D_STEPPING_DECK}) {
      CAPTURE(function_nodes);
      CAPTURE(stepping);
      const Model m = pressed(function_nodes);
      const Result r = solved(m, stepping), other = solved(drawn(m), stepping);
      CHECK(difference(r, other) < 1e-10);
      CHECK(distance(motion_of(r, 2), motion_of(other, 2)) < 1e-10 * std::fabs(motion_of(r, 2)[1]));
      CHECK(distance(force_on_bodies(r, 2), force_on_bodies(other, 2)) < 1e-11);
      CHECK(breach(m, r) == "");
      CHECK(imbalance(m, r) < 1e-12);
      CHECK(distance(force_on_bodies(r, 2), {0.25, -1.5, 0.5 * (0.2 - 3 - 0.5)}) < 1e-12);
      CHECK((function_nodes == 1 || r.last().dissipated > 0));
      CHECK(r.states[2].is_rigid == 1);
      CHECK(r.bodies[2].elements == 0);
      CHECK(r.bodies[2].unknowns == 0);
      for (const Row& row : r.zone_rows(2)) {
        CHECK(row[C2D_PAIR_NODE1] == row[C2D_PAIR_NODE2]);
        CHECK(row[C2D_NY] == doctest::Approx(-1));
      }
    }
}

TEST_CASE("platens: displacements that are prescribed at its ends, the same as it found") {
  Model m = pressed();
  m.platens[0].load[0] = 0.1, m.platens[0].load[2] = 0;
  m.friction = 2; // sticks: no history
  m.paths = {{1, 1.0}};
  const Result r = solved(m);
  const Three u = motion_of(r, 2);
  Model held = block();
  held.friction = 2;
  held.paths = {{1, 1.0}};
  held.set(2, 3, [&](double x, double y) { return end_of(kHeld, 0, 0, u[0] - u[2] * (y - 1), u[1] + u[2] * (x - 1)); });
  const Result other = solved(held);
  for (const Row& row : other.last().rows) {
    double best = 1e9;
    for (const Row& own : r.zone_rows(1))
      if (own[C2D_X] == row[C2D_X]) best = std::hypot(own[C2D_TN] - row[C2D_TN], own[C2D_TT] - row[C2D_TT]);
    CHECK(best < 1e-10 * 1.5);
  }
  for (int k = 0; k < 3; ++k) CHECK(std::fabs(other.bodies[1].applied[k] - r.bodies[2].applied[k]) < 1e-10 * 3);
}

TEST_CASE("platens: turned, in other units") {
  const Model m = pressed(3);
  const Result r = solved(m);
  for (const double degrees : {90.0, 30.0}) {
    CAPTURE(degrees);
    const double angle = degrees * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
    Mapping turn;
    turn.place = [c, s](double& x, double& y) {
      const double old = x;
      x = c * old - s * y, y = s * old + c * y;
    };
    const Result other = solved(turned(m, degrees));
    CHECK(difference(r, other, turn) < 1e-10);
    const Three u = motion_of(r, 2), v = motion_of(other, 2);
    CHECK(distance(v, {c * u[0] - s * u[1], s * u[0] + c * u[1], u[2]}) < 1e-10 * std::fabs(u[1]));
  }
  Mapping units;
  units.length = 1e-3, units.stress = 1e5;
  units.place = [](double& x, double& y) { x *= 1e-3, y *= 1e-3; };
  CHECK(difference(r, solved(scaled(m, 1e-3, 1e5)), units) < 1e-10);
}

// ---- lines of symmetry

namespace {

// A block of width 4 on rollers, a platen in the middle of its upper side or two of them beside it; the half x >= 0 or all.
Model indented(bool half, bool beside) {
  Model m;
  if (half) {
    m.add(open_polygon({{0, 0, 6}, {2, 0, 3}, {2, 1, 2}, {1.5, 1, 2}, {1, 1, 2}, {0.5, 1, 2}, {0, 1, 0}}));
    m.symmetry = 1;
  } else {
    m.add(polygon({{-2, 0, 12},
                   {2, 0, 3},
                   {2, 1, 2},
                   {1.5, 1, 2},
                   {1, 1, 2},
                   {0.5, 1, 4},
                   {-0.5, 1, 2},
                   {-1, 1, 2},
                   {-1.5, 1, 2},
                   {-2, 1, 3}}));
  }
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
  m.set(1, 1, end_of("0110"));
  if (!half) m.set(1, 1, [](double x, double) { return x == 0 ? end_of(kHeld) : end_of("0110"); });
  const int32_t sides[] = {half ? (beside ? 4 : 6) : (beside ? 4 : 6), 8};
  for (int k = 0; k < (beside && !half ? 2 : 1); ++k) {
    Platen& p = m.move(1, sides[k]);
    const double sign = k == 0 ? 1 : -1;
    if (beside)
      load(p, 0.1 * sign, -1, 0.05 * sign, 1.25 * sign, 1);
    else
      load(p, 0, half ? -1 : -2, 0, 0, 1);
    if (!beside && half) p.is_free[0] = p.is_free[2] = 0;
  }
  m.paths = {{1, 1.0}};
  return m;
}

} // namespace

TEST_CASE("platens: on a line of symmetry with half of the load, and beside it with an image") {
  for (const bool beside : {false, true}) {
    CAPTURE(beside);
    const Result half = solved(indented(true, beside)), all = solved(indented(false, beside));
    CHECK(distance(motion_of(half, 1), motion_of(all, 1)) < 1e-9 * std::fabs(motion_of(all, 1)[1]));
    for (const Row& row : half.last().rows) {
      double best = 1e9;
      for (const Row& own : all.zone_rows(1))
        if (own[C2D_X] == row[C2D_X]) best = std::hypot(own[C2D_TN] - row[C2D_TN], own[C2D_TT] - row[C2D_TT]);
      CHECK(best < 1e-8);
    }
    CHECK(std::fabs(2 * half.last().work - all.last().work) < 1e-9 * all.last().work);
    CHECK(imbalance(indented(true, beside), half) < 1e-12);
  }
  for (const int free : {0, 2}) {
    Model m = indented(true, false);
    m.platens[0].is_free[free] = 1;
    const Result r = solve(m);
    CHECK(r.status == C2D_ERR_INPUT);
    CHECK(r.told_of("the rigid body 2 (platen 1) may move freely across a line of symmetry"));
  }
  Model m = indented(true, false);
  m.platens[0].motion[2] = 0.1;
  CHECK(solve(m).told_of("the motion of the rigid body 2 (platen 1) in load case 1 leaves the line of symmetry"));
}

// ---- several platens, several curves

namespace {

// A plate with a round hole, whose whole edge is a platen, and a second one at its right side.
Model plate_with_pin(int32_t function_nodes) {
  Model m;
  m.function_nodes = function_nodes;
  m.add(rectangle(-2, -2, 2, 2, {6, 6, 6, 6}));
  add_curve(m.body(1), 16, [](double s, double& x, double& y) {
    const double angle = -2 * std::acos(-1.0) * s;
    x = 0.7 * std::cos(angle), y = 0.7 * std::sin(angle);
  });
  m.body(1).ends.assign(static_cast<size_t>(function_nodes * m.body(1).elements()), End());
  m.set(1, 4, end_of(kHeld));
  load(m.move(1, 5), 1, 0.3, 0.2, 0, 0);
  load(m.move(1, 2), -0.4, 0, 0, 2, 0);
  m.paths = {{1, 1.0}};
  return m;
}

} // namespace

TEST_CASE("platens: the whole edge of a hole, and a second platen") {
  for (const int32_t function_nodes : {1, 2, 3}) {
    CAPTURE(function_nodes);
    const Model m = plate_with_pin(function_nodes);
    const Result r = solved(m);
    CHECK(imbalance(m, r) < 1e-12);
    CHECK(distance(force_on_bodies(r, 1), {1, 0.3, 0.2}) < 1e-12);
    CHECK(distance(force_on_bodies(r, 2), {-0.4, 0, 0}) < 1e-12);
    CHECK(r.summary.bodies == 3);
    CHECK(r.zone_rows(1).size() == static_cast<size_t>(16 * std::max(1, function_nodes - 1)));
    // Begun elsewhere on the edge, round its end.
    Model round = m;
    round.platens[0].side = {1, 30, 29, 16};
    const Result other = solved(round);
    CHECK(distance(motion_of(r, 1), motion_of(other, 1)) < 1e-12);
    std::swap(round.platens[0], round.platens[1]); // in the other order
    const Result swapped = solved(round);
    for (size_t k = 1; k < 3; ++k) CHECK(distance(motion_of(r, k), motion_of(swapped, 3 - k)) < 1e-11);
    // Reciprocity of the two (Betti).
    Model one = m, two = m;
    std::fill(one.platens[1].load, one.platens[1].load + 3, 0.0), std::fill(two.platens[0].load, two.platens[0].load + 3, 0.0);
    const Three by_one = motion_of(solved(one), 2), by_two = motion_of(solved(two), 1);
    const double work = 1 * by_two[0] + 0.3 * by_two[1] + 0.2 * by_two[2];
    CHECK(std::fabs(-0.4 * by_one[0] - work) < (function_nodes == 1 ? 0.1 : 0.02) * std::fabs(work));
  }
}

// ---- new loads, saved states, memory

TEST_CASE("platens: new loads, a second load case, saved and taken up again") {
  Model m = pressed();
  m.cases = 2;
  m.body(2).second = m.body(2).ends, m.body(1).second = m.body(1).ends;
  for (Platen& p : m.platens) p.second_load[0] = 0.3, p.second_load[2] = -0.1;
  m.paths = {{2, 1.0, 0.0}, {2, 1.0, 1.0}};
  Model other = m;
  load(other.platens[0], -0.2, -4, 0.3, 1, 1);
  other.platens[0].second_load[1] = 0.5;
  const Result fresh = solved(other);
  for (const int32_t keep_factors : {0, 1}) {
    CAPTURE(keep_factors);
    Machine machine(m, keep_factors);
    REQUIRE(machine.run().outcome == C2D_REACHED);
    REQUIRE(c2d_change_loads(machine.solver) == C2D_OK);
    REQUIRE(c2d_set_rigid_load(machine.solver, 3, 1, nullptr, other.platens[0].load, nullptr) == C2D_OK);
    REQUIRE(c2d_set_rigid_load(machine.solver, 3, 2, nullptr, other.platens[0].second_load, nullptr) == C2D_OK);
    CHECK(difference(machine.run(), fresh) < 1e-11);
  }
  Machine machine(m);
  c2d_solver* s = machine.solver;
  const double mu = 0.3, half[2] = {0.5, 0.25}, whole[2] = {1, 1};
  c2d_outcome outcome;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(s, half, 2, &outcome) == C2D_OK);
  REQUIRE(c2d_save(s) == C2D_OK);
  REQUIRE(c2d_advance(s, whole, 2, &outcome) == C2D_OK);
  const Result first = machine.look();
  REQUIRE(c2d_restore(s) == C2D_OK);
  REQUIRE(c2d_advance(s, whole, 2, &outcome) == C2D_OK);
  CHECK(distance(motion_of(first, 2), motion_of(machine.look(), 2)) == 0);
}

TEST_CASE("platens: a solver that was moved") {
  Model m = plate_with_pin(2);
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = limits_of(m, list);
  uint64_t bytes = 0;
  REQUIRE(c2d_memory_need(&limits, &bytes, nullptr, nullptr) == C2D_OK);
  std::vector<unsigned char> memory(bytes + 256), copy(bytes + 256);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, memory.data(), bytes, &limits, nullptr, nullptr) == C2D_OK);
  REQUIRE(feed(s, m) == C2D_OK);
  std::copy(memory.begin(), memory.begin() + static_cast<std::ptrdiff_t>(bytes), copy.begin() + 13);
  c2d_solver* moved = nullptr;
  REQUIRE(c2d_attach(&moved, copy.data() + 13, bytes, nullptr, nullptr) == C2D_OK);
  char name[32];
  CHECK(c2d_get_name(moved, C2D_NAME_BODY, 3, name) == C2D_OK);
  CHECK(std::string(name) == "platen 2");
  c2d_zone zone = C2D_INIT(c2d_zone);
  REQUIRE(c2d_get_zone(moved, 2, &zone) == C2D_OK);
  CHECK(zone.kind == C2D_ZONE_MATCHING + C2D_ZONE_TIED);
  CHECK(zone.side1.body == 3);
  CHECK(zone.side2.body == 1);
  CHECK(zone.side1.first_element == zone.side2.first_element);
  c2d_close(moved);
  c2d_close(s);
}

TEST_CASE("platens: memory by limits is enough with every size of blocks, and one that is too small is refused") {
  const Model m = pressed(3);
  std::vector<c2d_body_limits> list;
  c2d_limits limits = limits_of(m, list);
  uint64_t minimum = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK);
  c2d_solver* s = nullptr;
  std::vector<unsigned char> memory(minimum);
  for (int32_t c2d_limits::*const member :
       {&c2d_limits::platens, &c2d_limits::zones, &c2d_limits::pairs, &c2d_limits::contact_elements}) {
    c2d_limits small = limits;
    --(small.*member);
    REQUIRE(c2d_create(&s, memory.data(), minimum, &small, nullptr, nullptr) == C2D_OK);
    CHECK(feed(s, m) == C2D_ERR_LIMIT);
    c2d_close(s);
  }
  const auto size = [](int32_t count) { return static_cast<uint64_t>(count); };
  const uint64_t points[2] = {size(list[0].points), size(list[1].points)};
  const uint64_t elements[2] = {size(list[0].elements), size(list[1].elements)};
  const uint64_t bodies = C2D_BODY_BYTES(3, points[0], elements[0], 1, 1) + C2D_BODY_BYTES(3, points[1], elements[1], 1, 1) +
                          C2D_BODY_BYTES(3, 0, 0, 0, 1);
  const uint64_t results = C2D_RESULT_BYTES(3, points[0], elements[0], 1) + C2D_RESULT_BYTES(3, points[1], elements[1], 1);
  const uint64_t bound = C2D_BODIES_BYTES(3, bodies, results, C2D_NODES_(3, points[0], elements[0], 1), size(limits.zones),
                                          size(limits.pairs), size(limits.contact_elements), 0, 1, 2, 1, 0, 0, 0, 0);
  CHECK(bound >= minimum);
  CHECK(static_cast<double>(bound) <= 1.05 * static_cast<double>(minimum) + 1024);
  uint64_t with[2] = {0, 0}, without[2] = {0, 0};
  for (const int32_t tape : {C2D_TAPE_LOWER, C2D_TAPE_UPPER}) { // a platen has no equations
    limits.platens = 0;
    REQUIRE(c2d_tape_need(&limits, nullptr, 4 * minimum, tape, &without[0], &without[1], nullptr) == C2D_OK);
    limits.platens = 1;
    REQUIRE(c2d_tape_need(&limits, nullptr, 4 * minimum, tape, &with[0], &with[1], nullptr) == C2D_OK);
    CHECK(with[0] == without[0]);
    CHECK(with[1] == without[1]);
  }
  limits.platens = 2; // one is not used
  REQUIRE(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK);
  memory.resize(minimum);
  REQUIRE(c2d_create(&s, memory.data(), minimum, &limits, nullptr, nullptr) == C2D_OK);
  CHECK(feed(s, m) == C2D_ERR_INPUT);
  c2d_close(s);
}

// ---- interior points, supports

TEST_CASE("platens: stresses inside are those below a body that is drawn") {
  const Model m = pressed();
  Machine own(m), other(drawn(m));
  own.run(), other.run();
  const double xy[] = {0.4, 0.5, 1.7, 0.8, 1, -0.3, 1, 1, 5, 5};
  double a[5 * C2D_POINT_FIELDS], b[5 * C2D_POINT_FIELDS];
  REQUIRE(c2d_interior(own.solver, 0, 5, xy, 2, a, C2D_POINT_FIELDS) == C2D_OK);
  REQUIRE(c2d_interior(other.solver, 0, 5, xy, 2, b, C2D_POINT_FIELDS) == C2D_OK);
  for (int i = 0; i < 5 * C2D_POINT_FIELDS; ++i) CHECK(std::fabs(a[i] - b[i]) < 1e-10);
  CHECK(std::fabs(a[C2D_POINT_SYY]) > 0.1);
  REQUIRE(c2d_interior(own.solver, 3, 5, xy, 2, a, C2D_POINT_FIELDS) == C2D_OK);
  for (int i = 0; i < 5; ++i) CHECK(static_cast<int>(a[i * C2D_POINT_FIELDS + C2D_POINT_FLAG]) == C2D_POINT_OUTSIDE);
}

TEST_CASE("platens: forces hold nothing, given motions do") {
  Model m;
  m.add(rectangle(0, 0, 2, 1, {4, 3, 4, 3}));
  m.body(1).ends.assign(static_cast<size_t>(2 * m.body(1).elements()), End());
  m.move(1, 1);
  load(m.move(1, 3), 0, 1, 0.3, 1, 1);
  m.paths = {{1, 1.0}};
  for (const char* free : {"111", "011", "110", "001", "000"}) {
    CAPTURE(free);
    for (int k = 0; k < 3; ++k) m.platens[0].is_free[k] = free[k] == '1';
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    if (std::string(free) == "000") {
      CHECK(r.outcome == C2D_REACHED);
      CHECK(distance(force_on_bodies(r, 1), {0, -1, -1.3}) < 1e-11);
    } else {
      CHECK(r.outcome == C2D_FREE_MOTION);
      CHECK(r.told_of("nothing holds"));
    }
  }
}

// All that the tied tractions do is a rigid motion: what is left of the equations that the state is judged by is round-off,
// which must not be compared with itself.
TEST_CASE("platens: a square of four elements, nu = 0, is pulled evenly") {
  for (const double high : {1.0, 0.7, 3.0}) {
    CAPTURE(high);
    Model m;
    m.plane = C2D_PLANE_STRESS;
    m.add(rectangle(0, 0, 1, high, {1, 1, 1, 1}, 1000, 0));
    m.body(1).ends.assign(8, End());
    m.set(1, 1, end_of(kHeld));
    load(m.move(1, 3), 0, 2, 0, 0.5, high);
    m.paths = {{1, 1.0}};
    const Result r = solve(m);
    REQUIRE(r.outcome == C2D_REACHED);
    CHECK(r.summary.max_residual < 1e-9);
    CHECK(distance(force_on_bodies(r, 1), {0, 2, 1}) < 1e-12);
  }
}

// ---- bad input

namespace {

std::string refusal(const Model& m) {
  const Result r = solve(m);
  CHECK((r.status == C2D_ERR_INPUT || r.status == C2D_ERR_ARGUMENT));
  return r.messages();
}
bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

} // namespace

TEST_CASE("platens: ends with other conditions, in a contact zone, in two platens") {
  Model m = pressed();
  m.set(2, 3, end_of(kPulled, 0, -1));
  CHECK(says(refusal(m), "end 1 of element 8 of body 2 is moved by body 3 (platen 1) and has a boundary condition as well, "
                         "expected no condition there"));
  m.set(2, 3, end_of("0110"));
  CHECK(says(refusal(m), "is moved by body 3 (platen 1) and has a boundary condition as well"));
  m = pressed();
  m.set(2, 4, end_of("1001")); // the side beside it is held along x
  CHECK(says(refusal(m), "node 12 of body 2 is moved by body 3 (platen 1), and the element beside it prescribes ux there"));
  m.platens[0].is_free[0] = m.platens[0].is_free[2] = 0;
  CHECK(solve(m).outcome == C2D_REACHED); // it does not move so
  m.platens[0].motion[0] = 0.1;
  CHECK(says(refusal(m), "the element beside it prescribes ux there"));
  m = block();
  load(m.move(2, 1), 0, -1, 0, 1, 1);
  CHECK(says(refusal(m), "element 1 of body 2 is in zones 1 and 2 (platen 1), the first of 4"));
  m = block();
  load(m.move(2, 2), 0, -1, 0, 1, 1);
  CHECK(says(refusal(m), "node 5 of body 2 is in pairs 1 and 6 of zones 1 and 2 (platen 1), expected in one pair only"));
  m = pressed();
  load(m.move(2, 4), 0, -1, 0, 1, 1);
  CHECK(says(refusal(m),
             "node 12 of body 2 is in pairs 10 and 11 of zones 2 (platen 1) and 3 (platen 2), expected in one pair only"));
  m = pressed();
  load(m.move(2, 3), 0, -1, 0, 1, 1);
  CHECK(says(refusal(m), "element 8 of body 2 is in zones 2 (platen 1) and 3 (platen 2), the first of 4"));
  m = pressed();
  m.body(2).rigid = 1;
  CHECK(says(refusal(m), "bodies 3 (platen 1) and 2 are both rigid"));
  m = pressed();
  m.point_loads.push_back({3, 1, 1, 0, 1});
  CHECK(says(refusal(m), "body 3 (platen 1) is rigid, expected no tractions"));
}

TEST_CASE("platens: bad arguments and states of c2d_add_platen") {
  const Model m = pressed();
  std::vector<c2d_body_limits> list;
  c2d_limits limits = limits_of(m, list);
  limits.platens = 3, limits.zones = 4, limits.pairs = 40, limits.contact_elements = 40;
  uint64_t bytes = 0;
  REQUIRE(c2d_memory_need(&limits, &bytes, nullptr, nullptr) == C2D_OK);
  std::vector<unsigned char> memory(bytes);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, memory.data(), bytes, &limits, nullptr, nullptr) == C2D_OK);
  const int32_t all[3] = {1, 1, 1};
  const double point[2] = {0, 0}, bad[2] = {0, std::nan("")};
  const auto why = [&] {
    c2d_error error = C2D_INIT(c2d_error);
    c2d_last_error(s, &error);
    return std::string(error.text);
  };
  CHECK(c2d_add_platen(nullptr, 2, 8, 11, 0, all, point) == C2D_ERR_ARGUMENT);
  CHECK(c2d_add_platen(s, 2, 8, 11, 0, all, point) == C2D_ERR_ARGUMENT);
  CHECK(why() == "give the body and all its regions first");
  c2d_body data = C2D_INIT(c2d_body);
  data.element_nodes = 2, data.elements = 14, data.regions = 1, data.youngs_modulus = 1;
  REQUIRE(c2d_set_body(s, 2, &data) == C2D_OK);
  REQUIRE(c2d_add_region(s, 2, 1, 14) == C2D_OK);
  for (const int32_t body : {0, 3, 6}) CHECK(c2d_add_platen(s, body, 8, 11, 0, all, point) == C2D_ERR_ARGUMENT);
  CHECK(why() == "body number is 6, expected 1 to 2");
  CHECK(c2d_add_platen(s, 2, 8, 15, 0, all, point) == C2D_ERR_ARGUMENT);
  CHECK(why() == "contact element of body 2 is 15, expected 1 to 14");
  CHECK(c2d_add_platen(s, 2, 0, 11, 0, all, point) == C2D_ERR_ARGUMENT);
  for (const int32_t count : {0, 5, 15, -1}) CHECK(c2d_add_platen(s, 2, 11, 8, count, all, point) == C2D_ERR_ARGUMENT);
  CHECK(why() ==
        "the element range of body 2 does not contain the number of elements given, in one region and in the direction "
        "of its boundary");
  CHECK(c2d_add_platen(s, 2, 8, 11, 3, all, point) == C2D_ERR_ARGUMENT);
  CHECK(c2d_add_platen(s, 2, 8, 11, 0, nullptr, point) == C2D_ERR_ARGUMENT);
  CHECK(why() == "is_free is null");
  CHECK(c2d_add_platen(s, 2, 8, 11, 0, all, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_add_platen(s, 2, 8, 11, 0, all, bad) == C2D_ERR_ARGUMENT);
  CHECK(c2d_add_platen(s, 2, 13, 2, 4, all, point) == C2D_OK); // round the end of the curve
  CHECK(c2d_add_platen(s, 2, 8, 11, 0, all, point) == C2D_OK);
  CHECK(c2d_set_body(s, 4, &data) == C2D_ERR_LIMIT); // a platen has no mesh
  CHECK(c2d_add_platen(s, 2, 4, 4, 1, all, point) == C2D_OK);
  CHECK(c2d_add_platen(s, 2, 6, 6, 0, all, point) == C2D_ERR_LIMIT);
  CHECK(why() == "c2d_limits.platens is 3, expected 4 or more");
  c2d_close(s);
  Machine machine(m);
  CHECK(c2d_add_platen(machine.solver, 2, 8, 11, 0, all, point) == C2D_ERR_STATE);
  c2d_limits wrong = limits;
  wrong.platens = -1;
  CHECK(c2d_memory_need(&wrong, &bytes, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  wrong.platens = INT32_MAX;
  CHECK(c2d_memory_need(&wrong, &bytes, nullptr, nullptr) == C2D_ERR_ARGUMENT);
}

// ---- the deck

namespace {

std::string deck_with(const std::string& keywords, const Model& m = block()) {
  std::vector<int32_t> order;
  return deck_of(m, "BLOCK", order) + keywords;
}
std::string fault_of(const std::string& keywords) {
  const Machine machine(deck_with(keywords));
  CHECK(machine.status == C2D_ERR_INPUT);
  std::string all;
  for (const c2d_error& e : machine.told) all += e.text + std::string("\n");
  return all;
}

} // namespace

TEST_CASE("platens: the deck's card, by words and in any order of the cards") {
  const Model m = pressed();
  const Result r = solved(m), by_deck = solve_deck(deck_with("*PLATEN 2 8 11 1 1\n1 FX 0.5 FY -3 MOMENT 0.2\n"));
  REQUIRE_MESSAGE(by_deck.status == C2D_OK, by_deck.messages());
  CHECK(difference(r, by_deck) == 0);
  Model held = m;
  held.platens[0].is_free[2] = 0, held.platens[0].motion[2] = -1e-3;
  const Result turned_by = solved(held),
               cards = solve_deck(deck_with("*NAME BODY 1 floor\n*platen 2 8 11 1 1 4 ! four elements\n1 fy -3, turn -1e-3, FX "
                                            "0.5\n*NAME BODY 3 pad\n*NAME ZONE 2 pad's\n"));
  REQUIRE_MESSAGE(cards.status == C2D_OK, cards.messages());
  CHECK(difference(turned_by, cards) == 0);
  const std::string held_twice = deck_with("*PLATEN 2 8 11 1 1\n1 FY -3 UX 0 TURN 0\n*PLATEN 1 1 1 0 0\n");
  const Result refused = solve_deck(held_twice);
  CHECK(refused.told_of("end 1 of element 1 of body 1 is moved by body 4 (platen 2)"));
  REQUIRE(!refused.told.empty());
  CHECK(refused.told[0].line == std::count(held_twice.begin(), held_twice.end(), '\n')); // its own card, the last
}

TEST_CASE("platens: in every output of the program, carried by convert, and with images for elements on a line") {
  const test::Folder folder;
  test::write_file(folder / "a", deck_with("*platen 2 8 11 1 1\n1 FX 0.5 FY -3 MOMENT 0.2\n*NAME BODY 3 pad\n"));
  const test::Result ran =
      test::run_shell("cd '" + folder.path() + "' && " + kProgram +
                      " run a --csv a.csv --json a.json --bodies a.bodies --listing a.txt --boundary a.ends "
                      "--vtk a.vtk --report a.html --figures figures --trace a.trace");
  REQUIRE_MESSAGE(ran.status == 0, ran.err);
  const Model m = pressed();
  const Three u = motion_of(solved(m), 2);
  const test::Json json = test::JsonReader::read(test::read_file(folder / "a.json"));
  const test::Json& last = json["steps_detail"][4]["bodies"][2];
  for (size_t k = 0; k < 3; ++k) CHECK(std::fabs(last["motion"][k].number - u[k]) < 1e-11 * std::fabs(u[1]));
  CHECK(last["load"][1].number == doctest::Approx(-1.5));
  CHECK(last["contact"][1].number == doctest::Approx(1.5));
  CHECK(json["force"]["bodies"][2]["name"].text == "pad");
  CHECK(json["zones"][1]["name"].text == "platen 1");
  const auto has = [&](const char* file, const char* part) {
    CHECK_MESSAGE(test::contains(test::read_file(folder / file), part), file << ": " << part);
  };
  has("a.txt", "\nBody 3 (pad)\n");
  has("a.txt", "  a platen that moves ...................... elements 8 to 11 of body 2\n");
  has("a.txt", "body 3 (pad): loads and supports");
  has("a.html", "body 3 (pad) moves elements 8 to 11 of body 2 as if rigid");
  has("figures/model.svg", ">body 3 (pad): ends that it moves</text>");
  has("figures/tractions_zone2.svg", "pad");
  has("a.csv", ",tied,");
  const std::string bodies = test::read_file(folder / "a.bodies");
  CHECK(std::count(bodies.begin(), bodies.end(), '\n') == 1 + 5 * 3);
  CHECK(!test::contains(test::read_file(folder / "a.txt"), "Body 3 (pad) in global components"));
  const test::Result there = test::run_shell("cd '" + folder.path() + "' && " + kProgram + " convert a --to free -o b && " +
                                             kProgram + " check b && " + kProgram + " run b --csv b.csv");
  REQUIRE_MESSAGE(there.status == 0, there.err);
  CHECK(test::contains(there.out, "body 3 (pad), zone 2 (platen 1)"));
  CHECK(test::read_file(folder / "b.csv") == test::read_file(folder / "a.csv"));
  // Half a block on rollers with a meshed line of symmetry, a platen that ends on it.
  Model half;
  half.add(polygon({{0, 0, 6}, {2, 0, 3}, {2, 1, 2}, {1.5, 1, 4}, {0.5, 1, 2}, {0, 1, 3}}));
  half.body(1).ends.assign(static_cast<size_t>(2 * half.body(1).elements()), End());
  half.set(1, 1, end_of("0110")), half.set(1, 6, end_of("1001"));
  test::write_file(folder / "half", deck_with("*PLATEN 1 16 17 0 1\n1 FY -1 UX 0 TURN 0\n", half));
  double down[2];
  for (int images = 0; images < 2; ++images) {
    const test::Result run =
        test::run_shell(kProgram + " run '" + (folder / "half") + "' --json - --symmetry " + (images != 0 ? "images" : "deck"));
    REQUIRE_MESSAGE(run.status == 0, run.err);
    const test::Json half_json = test::JsonReader::read(run.out);
    const test::Json& platen = half_json["steps_detail"][0]["bodies"][1];
    CHECK(std::fabs(platen["contact"][1].number - 1) < 1e-12);
    down[images] = platen["motion"][1].number;
  }
  CHECK(std::fabs(down[1] - down[0]) < 1e-3 * std::fabs(down[0]));
}

TEST_CASE("platens: faults of the deck's card") {
  CHECK(says(fault_of("*PLATEN 3 8 11 1 1\n"), "body number is 3, expected 1 to 2"));
  CHECK(says(fault_of("*PLATEN 2 8 15 1 1\n"), "last element of the platen is 15, expected 1 to 14"));
  CHECK(says(fault_of("*PLATEN 2 11 8 1 1\n"), "last element of the platen is 8, expected 11 or more; for a range across the "
                                               "end of its curve give the number of elements after the point"));
  CHECK(says(fault_of("*PLATEN 2 11 8 1 1 4\n"), "the element range of body 2 does not contain the number of elements given"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1\n"), "y of the point"));
  CHECK(
      says(fault_of("*PLATEN 2 8 11 1 1\n1 FY -3 UY 0\n"),
           "UY of a platen whose FY is prescribed on this card or an earlier one, expected one of the two in all load cases"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1 1\n1 TURN 0\n2 MOMENT 1\n"),
             "MOMENT of a platen whose TURN is prescribed on this card or an earlier one"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1 1\n0 FY -3\n"), "load case is 0, expected 1 to 10000"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1 1\nx FY -3\n"), "load case"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1 1\n1 FY -3\n1 FX 2\n"), "load case 1 of this platen has two cards, expected one"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1 1\n1 FZ -3\n"),
             "expected UX, UY, TURN (prescribed motions), FX, FY or MOMENT, and its value"));
  CHECK(says(fault_of("*PLATEN 2 8 11 1 1\n1 FY\n"), "FY"));
  std::string stress = deck_with("*PLATEN 2 8 11 1 1\n1 FY -3\n");
  Model one;
  one.add(rectangle(0, 0, 2, 1, {4, 3, 4, 3}));
  one.body(1).ends.assign(28, End());
  stress = deck_with("*PLATEN 1 8 11 1 1\n1 FY -3\n", one);
  const size_t at = stress.find("\n0 2\n");
  REQUIRE(at != std::string::npos);
  stress.replace(at, 5, "\n0 0\n");
  CHECK(solve_deck(stress).told_of("a contact zone or platen in a stress analysis (IOUT 0), expected IOUT 1 or 2"));
}
