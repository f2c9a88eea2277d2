// How bodies begin to move where contact holds them no longer: which of them, and along what motion.
#include "many_bodies.hpp"
#include "solver/energy/motion.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace many;

namespace {

Result stopped(const Model& m) {
  const Result r = solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE(r.outcome != C2D_REACHED);
  return r;
}

// The motion that is told turns the body about (x, y), this way.
void turns_about(const Result& r, double x, double y, double way) {
  const double* v = r.summary.free_motion; // about the origin
  REQUIRE(v[2] * way > 0);
  CHECK(std::fabs(v[0] - v[2] * y) < 1e-6 * std::fabs(v[2]));
  CHECK(std::fabs(v[1] + v[2] * x) < 1e-6 * std::fabs(v[2]));
}

} // namespace

// The pair at x = 0 has no tangential direction: ux is prescribed on both sides.
TEST_CASE("outcomes: a block tips over the end of its zone, the node of which moves up and down alone") {
  for (const double mu : {0.0, 0.4}) {
    CAPTURE(mu);
    Model m;
    m.add(rectangle(-1, -1, 2, 0, {3, 1, 3, 1}));
    m.add(rectangle(-1, 0, 2, 1, {3, 1, 3, 1}));
    m.set(1, 1, end_of(kHeld));
    const Range below = m.side(1, 3), above = m.side(2, 1);
    m.body(1).ends[static_cast<size_t>(2 * below.last - 2)] = end_of("1001");
    m.body(2).ends[static_cast<size_t>(2 * above.first - 1)] = end_of("1001");
    m.zones.push_back({C2D_ZONE_MATCHING, {{1, below.first, below.last - 1}, {2, above.last, above.first + 1}}});
    m.point_loads = {{2, -0.5, 0.5, 0, -1}};
    m.friction = mu;
    const Result r = stopped(m);
    CHECK(r.summary.outcome_body == 2);
    turns_about(r, 0, 0, 1);
  }
}

// The pairs are so near each other that which of them it turns about is round-off: neither the normals of both nor friction at
// the one and the normal of the other may hold it.
TEST_CASE("outcomes: a block on two pairs close together tips over them") {
  for (const double mu : {0.0, 0.5})
    for (const double apart : {1e-2, 1e-4, 1e-6, -1e-2, -1e-4, -1e-6}) {
      CAPTURE(mu);
      CAPTURE(apart);
      const double d = std::fabs(apart) / 2, way = apart > 0 ? 1 : -1;
      Model m;
      m.add(polygon({{-1, -1, 2}, {1, -1, 1}, {1, 0, 1}, {d, 0, 1}, {-d, 0, 1}, {-1, 0, 1}}));
      m.add(polygon({{-1, 0, 1}, {-d, 0, 1}, {d, 0, 1}, {1, 0, 1}, {1, 1, 2}, {-1, 1, 1}}));
      m.set(1, 1, end_of(kHeld));
      m.join(C2D_ZONE_MATCHING, 1, 4, 2, 2);
      m.point_loads = {{2, way * 0.5, 0.5, 0, -1}};
      m.friction = mu;
      const Result r = stopped(m);
      CHECK(r.summary.outcome_body == 2);
      const double* v = r.summary.free_motion;
      REQUIRE(way * v[2] < 0);
      CHECK(std::fabs(v[1]) < 4 * d * std::fabs(v[2])); // neither lifts off, or goes down
      if (mu > 0) CHECK(std::fabs(v[0]) < 1e-3 * std::fabs(v[2]));
      if (mu == 0) CHECK(std::fabs(v[0] - v[2] / 2) < 1e-3 * std::fabs(v[2])); // the middle goes straight down
    }
}

// The one on the line x = 0 has a pair there whose nodes do not move along x.
TEST_CASE("outcomes: a block that slides beside one that lies still") {
  Model m;
  m.add(polygon({{-1, -1, 3}, {6, -1, 1}, {6, 0, 1}, {5, 0, 2}, {3, 0, 1}, {2, 0, 2}, {0, 0, 1}, {-1, 0, 1}}));
  m.add(rectangle(0, 0, 2, 1, {2, 1, 1, 1}));
  m.add(rectangle(3, 0, 5, 1, {2, 1, 1, 1}));
  m.set(1, 1, end_of(kHeld));
  m.body(1).ends[static_cast<size_t>(2 * m.side(1, 7).first - 2)] = end_of("1001");
  m.set(2, 4, end_of("1001"));
  m.cases = 2;
  for (const int32_t body : {2, 3}) m.set(body, 3, end_of(kPulled, 0, -1));
  m.set_second(3, 3, end_of(kPulled, 1));
  m.join(C2D_ZONE_MATCHING, 1, 6, 2, 1);
  m.join(C2D_ZONE_MATCHING, 1, 4, 3, 1);
  m.friction = 0.3;
  m.paths = {{1, 1, 0}, {2, 1, 1}};
  const Result r = stopped(m);
  CHECK(r.outcome == C2D_GROSS_SLIDING);
  CHECK(r.summary.outcome_body == 3);
  const double* v = r.summary.free_motion;
  CHECK(v[0] == doctest::Approx(1));
  CHECK(std::fabs(v[1]) < 1e-9);
  CHECK(std::fabs(v[2]) < 1e-9);
}

TEST_CASE("outcomes: of bodies that float the one is told that is pushed, by what comes or else by what is there") {
  struct Case {
    double load, direction;
    int32_t body;
  };
  for (const bool held : {false, true}) {
    CAPTURE(held);
    Model m;
    m.add(rectangle(0, 0, 3, 1, {3, 1, 3, 1}));
    m.add(rectangle(0, 1.1, 3, 2, {3, 1, 3, 1}));
    m.set(1, 1, end_of(kHeld));
    m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    if (held) {
      m.set(2, 3, end_of(kHeld));
    } else {
      m.add(rectangle(0, 2.1, 3, 3, {3, 1, 3, 1}));
      m.set(3, 3, end_of(kPulled, 0, 1));
      m.join(C2D_ZONE_MATCHING, 2, 3, 3, 1);
    }
    m.paths = {{1, 0}};
    Machine machine(m);
    REQUIRE(machine.status == C2D_OK);
    REQUIRE(machine.run().status == C2D_OK);
    c2d_solver* const s = machine.solver;
    c2d::Session session;
    c2d::open_session(s, session);
    for (const Case& c : {Case{0, 1, 3}, Case{2, 0, 3}, Case{0, 0, 2}}) {
      CAPTURE(c.load);
      CAPTURE(c.direction);
      session.follower.load[0] = c.load, session.follower.direction[0] = c.direction;
      s->outcome_body = 0;
      c2d::find_outcome_motion(session, C2D_FREE_MOTION);
      CHECK(s->outcome_body == (held ? 0 : c.body));
      CHECK((s->outcome_motion[1] > 0) == (!held && c.body == 3));
      if (held) CHECK((s->outcome_motion[0] == 0 && s->outcome_motion[2] == 0));
    }
  }
}

// Friction beyond the limit up to which rates exist, between bodies that are held.
TEST_CASE("outcomes: where nothing can move no change is admissible, and no body is told") {
  struct Case {
    const char* deck;
    double mu;
  };
  for (const Case& c : {Case{"../hard/nonunique_19", 3}, Case{"../hard/D1_4pairs_endless_12", 3}}) {
    CAPTURE(std::string(c.deck));
    const runs::Deck deck = runs::deck_named(c.deck);
    const host::Limits limits = deck.limits();
    uint64_t most = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &most, nullptr) == C2D_OK);
    runs::RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    runs::Machine machine(limits, most, &port);
    c2d_solver* const s = machine.solver;
    REQUIRE(runs::read_deck(s, deck) == C2D_OK);
    REQUIRE(c2d_prepare(s) == C2D_OK);
    REQUIRE(c2d_begin(s, &c.mu, 1) == C2D_OK);
    c2d_outcome outcome = C2D_REACHED;
    for (const double part : {0.5, 1.0, 1.5, 0.3, -1.0}) {
      const std::vector<double> load(static_cast<size_t>(runs::summary_of(s).load_cases), part);
      REQUIRE(c2d_advance(s, load.data(), static_cast<int32_t>(load.size()), &outcome) == C2D_OK);
      CHECK(outcome == (part > 0 ? C2D_REACHED : C2D_NO_ADMISSIBLE_CHANGE));
    }
    const host::Summary summary = runs::summary_of(s);
    CHECK(summary.outcome_body == 0);
    for (const double part : summary.free_motion) CHECK(part == 0);
  }
}
