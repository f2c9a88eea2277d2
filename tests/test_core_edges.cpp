// Rare branches of model, contact and results, one by one: what is asked in odd states, models at the border of what is
// allowed, and stores that fail at every operation of one step of a solver.
#include "contact2d_cycle.h"
#include "cyclic_cylinder.hpp"
#include "on_demand.hpp"
#include "paths.hpp"
#include "shell.hpp"
#include "slip_pads.hpp"

#include "contact/tableau.hpp"
#include "memory/parts.hpp"
#include "model/surface.hpp"
#include "results/approach.hpp"
#include "solver/cycle.hpp"
#include "solver/demand/hold_demand.hpp"
#include "solver/demand/on_demand.hpp"
#include "solver/session.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

using namespace demand;

namespace {

std::string last_text(c2d_solver* s) { return runs::error_of(s).text; }

// A block pressed on another.
many::Model two_blocks() {
  many::Model m;
  m.add(many::rectangle(0, 0, 3, 1, {4, 2, 4, 2}, 100));
  m.add(many::rectangle(0, 1, 3, 2, {4, 2, 4, 2}, 60));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  return m;
}

const int32_t kTouching = 60;

} // namespace

// ---- calls -------------------------------------------------------------------------------------------------------------

TEST_CASE("core edges: a coordinate that is no number is refused, whichever of the two it is") {
  many::Model m = two_blocks();
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    for (const int place : {0, 1, 7}) {
      CAPTURE(place);
      many::Model other = m;
      other.body(2).xy[static_cast<size_t>(place)] = bad;
      many::Machine machine(other);
      CHECK(machine.status == C2D_ERR_ARGUMENT);
      CHECK(last_text(machine.solver).find("a coordinate") != std::string::npos);
    }
}

TEST_CASE("core edges: zones are asked for their state in a step callback") {
  many::Machine machine(two_blocks());
  struct Seen {
    c2d_solver* s;
    c2d_zone_state state = C2D_INIT(c2d_zone_state);
    int steps = 0;
  } seen{machine.solver};
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  const auto ask = [](void* to, const c2d_step*) -> int32_t {
    Seen& own = *static_cast<Seen*>(to);
    ++own.steps;
    if (c2d_get_zone_state(own.s, 2, &own.state) != C2D_ERR_ARGUMENT) return 1;
    return c2d_get_zone_state(own.s, 1, &own.state) == C2D_OK ? 0 : 1;
  };
  REQUIRE(c2d_run(machine.solver, ask, &seen) == C2D_OK);
  CHECK(seen.steps > 0);
  c2d_zone_state after = C2D_INIT(c2d_zone_state);
  REQUIRE(c2d_get_zone_state(machine.solver, 1, &after) == C2D_OK);
  CHECK((seen.state.stick == after.stick && seen.state.slip == after.slip && seen.state.open == after.open));
  for (int c = 0; c < 2; ++c) CHECK(seen.state.force[c] == after.force[c]);
  CHECK(std::fabs(after.force[1]) == doctest::Approx(3));
}

TEST_CASE("core edges: a zone is not asked for its state after the store has failed in a step callback") {
  Host host(two_blocks());
  REQUIRE(c2d_prepare(host.solver()) == C2D_OK);
  struct Seen {
    Host& host;
    c2d_status looked = C2D_OK, asked = C2D_OK;
  } seen{host};
  const auto ask = [](void* to, const c2d_step*) -> int32_t {
    Seen& own = *static_cast<Seen*>(to);
    own.host.own.before = [](const runs::RamStore::Operation&, size_t) { return 5; };
    c2d_body_state body = C2D_INIT(c2d_body_state);
    c2d_zone_state zone = C2D_INIT(c2d_zone_state);
    double all[400] = {};
    own.looked = c2d_get_body_state(own.host.solver(), 1, &body);
    if (own.looked == C2D_OK) own.looked = c2d_get(own.host.solver(), C2D_END_TX, 1, 1, 4, all, 1);
    own.asked = c2d_get_zone_state(own.host.solver(), 1, &zone);
    return 0;
  };
  CHECK(c2d_run(host.solver(), ask, &seen) == C2D_ERR_STORE_READ);
  CHECK(seen.looked == C2D_ERR_STORE_READ);
  CHECK(seen.asked == C2D_ERR_STATE);
  CHECK(c2d_get_state(host.solver()) == C2D_STATE_BROKEN);
}

TEST_CASE("core edges: forces of bodies whose energies are not kept are those of the pairs") {
  many::Model m = two_blocks();
  m.add(many::rectangle(9, 0, 12, 1, {4, 2, 4, 2}, 100)); // touches nothing
  m.set(3, 1, many::end_of(many::kHeld));
  std::vector<c2d_body_state> states[2];
  for (const int kept : {1, 0}) {
    many::Machine machine(m);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    machine.solver->keeps_energy = kept; // as where the part for energies is not linked
    REQUIRE(c2d_run(machine.solver, nullptr, nullptr) == C2D_OK);
    for (int32_t b = 1; b <= 3; ++b) {
      c2d_body_state state = C2D_INIT(c2d_body_state);
      REQUIRE(c2d_get_body_state(machine.solver, b, &state) == C2D_OK);
      states[kept].push_back(state);
    }
  }
  for (size_t b = 0; b < 3; ++b)
    for (int c = 0; c < 3; ++c)
      CHECK(states[0][b].contact[c] == doctest::Approx(states[1][b].contact[c]).scale(1).epsilon(1e-9));
  CHECK(states[0][1].contact[1] == doctest::Approx(3));
  CHECK(states[0][2].contact[1] == 0);
}

// ---- models ------------------------------------------------------------------------------------------------------------

TEST_CASE("core edges: a rigid body on the axis that is moved off it") {
  many::Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.add(many::open_polygon({{0, -1, 4}, {1, -1, 2}, {1, 0, 4}, {0, 0, 0}}));
  m.add(many::open_polygon({{0, 0, 4}, {1, 0, 2}, {1, 1, 4}, {0, 1, 0}}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.body(2).rigid = 1;
  m.body(2).motion[0] = 0.1, m.body(2).motion[1] = -0.01;
  many::Machine machine(m);
  many::Result r;
  if (machine.status == C2D_OK) r = machine.run();
  CHECK((machine.status == C2D_ERR_INPUT || r.status == C2D_ERR_INPUT));
  bool told = r.told_of("leaves the axis");
  for (const c2d_error& e : machine.told) told = told || std::string(e.text).find("leaves the axis") != std::string::npos;
  CHECK_MESSAGE(told, last_text(machine.solver));
}

namespace {

void check_told(const many::Model& m, const std::string& words) {
  many::Machine machine(m);
  many::Result r;
  if (machine.status == C2D_OK) r = machine.run();
  CHECK((machine.status == C2D_ERR_INPUT || r.status == C2D_ERR_INPUT));
  bool told = r.told_of(words) || last_text(machine.solver).find(words) != std::string::npos;
  for (const c2d_error& e : machine.told) told = told || std::string(e.text).find(words) != std::string::npos;
  CHECK_MESSAGE(told, words, ": ", last_text(machine.solver), r.messages());
}

} // namespace

TEST_CASE("core edges: what is prescribed at a pair's nodes is no symmetry if it is not zero, or along the normal") {
  for (const int c : {0, 1}) {
    many::Model m = two_blocks();
    const many::End end = many::end_of(c == 0 ? "1001" : "0110", 0, 0, c == 0 ? 0.1 : 0, c == 1 ? 0.1 : 0);
    m.body(1).ends[2 * static_cast<size_t>(m.side(1, 2).last) - 1] = end; // at the right end of the zone
    m.body(2).ends[2 * static_cast<size_t>(m.side(2, 2).first - 1)] = end;
    check_told(m, c == 0 ? "a nonzero ux is prescribed" : "a nonzero uy is prescribed");
  }
  many::Model m; // side by side
  m.add(many::rectangle(0, 0, 1, 3, {2, 4, 2, 4}, 100));
  m.add(many::rectangle(1, 0, 2, 3, {2, 4, 2, 4}, 100));
  m.set(1, 4, many::end_of(many::kHeld));
  m.set(2, 2, many::end_of(many::kPulled, -1, 0));
  for (const int32_t b : {1, 2}) m.set(b, 1, many::end_of("1001"));
  m.join(C2D_ZONE_MATCHING, 1, 2, 2, 4);
  m.friction = 0.3;
  check_told(m, "ux is prescribed nearly along the normal");
}

TEST_CASE("core edges: of elements that do not face each other the worst is named, wherever it is") {
  many::Model m = two_blocks();
  // The upper body's "lower" side is above it: slanted, flat, slanted.
  m.bodies[1] = many::polygon({{0, 1, 4}, {3, 1, 2}, {3, 2, 1}, {2, 2.4, 2}, {1, 2.4, 1}, {0, 2, 2}}, 60);
  m.zones.clear();
  m.zones.push_back(
      {C2D_ZONE_MATCHING, {{1, m.side(1, 3).first, m.side(1, 3).last}, {2, m.side(2, 5).last + 1, m.side(2, 3).first}}});
  m.zones[0].side[1].first = m.side(2, 3).first, m.zones[0].side[1].last = m.side(2, 5).last;
  std::swap(m.zones[0].side[1].first, m.zones[0].side[1].last);
  check_told(m, "do not face each other, the worst of 4");
}

TEST_CASE("core edges: bodies of revolution take no images of elements") {
  many::Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.add(many::open_polygon({{0, -1, 4}, {1, -1, 2}, {1, 0, 4}, {0, 0, 0}}));
  m.set(1, 1, many::end_of(many::kHeld));
  std::vector<int32_t> order;
  runs::Deck deck;
  std::stringstream text(many::deck_of(m, "disc", order));
  for (std::string line; std::getline(text, line);) deck.lines.push_back(line);
  const host::Limits limits = deck.limits();
  uint64_t bytes = 0;
  REQUIRE(c2d_memory_need(&limits, nullptr, &bytes, nullptr) == C2D_OK);
  runs::Machine machine(limits, bytes, nullptr);
  REQUIRE(machine.created == C2D_OK);
  c2d_options options = C2D_INIT(c2d_options);
  options.symmetry = C2D_SYMMETRY_IMAGES;
  REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
  CHECK(runs::read_deck(machine.solver, deck) == C2D_ERR_INPUT);
  CHECK(last_text(machine.solver).find("symmetry by images of elements in a model of bodies of revolution") !=
        std::string::npos);
}

// With quadratic functions; the node at either end of the zone makes no pair, and has no traction.
TEST_CASE("core edges: ends of a zone without a pair carry no pressure between nodes") {
  many::Model m = quadratic(two_blocks(), 3);
  m.zones[0].without[0] = m.zones[0].without[1] = 1;
  many::Machine machine(m);
  REQUIRE_MESSAGE(machine.status == C2D_OK, last_text(machine.solver));
  const many::Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  double force = 0;
  for (const c2d_body_result& b : r.bodies) force = std::max(force, std::fabs(b.contact[1]));
  CHECK(force == doctest::Approx(3).epsilon(1e-6));
}

// A plate between the arms of a clevis: the faces of the gap may touch the plate, not each other.
TEST_CASE("core edges: a gap whose faces touch in different zones is a slit") {
  many::Model m;
  const double t = 0.04;
  m.add(many::polygon(
      {{0, -1, 4}, {4, -1, 2}, {4, 0, 3}, {1, 0, 1}, {0.5, 0, 1}, {0.5, t, 1}, {1, t, 3}, {4, t, 2}, {4, 1, 4}, {0, 1, 3}},
      100));
  m.add(many::rectangle(1, 0, 4, t, {3, 1, 3, 1}, 100));
  m.set(1, 10, many::end_of(many::kHeld));
  m.set(1, 9, many::end_of(many::kPulled, 0, -0.01));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.join(C2D_ZONE_MATCHING, 1, 7, 2, 3);
  m.friction = 0.3;
  many::Machine machine(m);
  REQUIRE_MESSAGE(machine.status == C2D_OK, last_text(machine.solver));
  const many::Result r = machine.run();
  bool told = r.told_of("lies beside a slit 0.04 wide");
  for (const c2d_error& e : machine.told)
    told = told || std::string(e.text).find("lies beside a slit 0.04") != std::string::npos;
  CHECK_MESSAGE(told, r.messages());
}

// A disc that touches its hole all round: there is no room for two sums at once.
TEST_CASE(
    "core edges: the approach of bodies that touch all round, before other results and after, and on a store that fails") {
  runs::Deck deck;
  std::ifstream file(paths::root() + "/tests/data/sweep/disc_in_hole.dat");
  for (std::string line; std::getline(file, line);) deck.lines.push_back(line);
  const host::Limits limits = deck.limits();
  uint64_t bytes = 0;
  REQUIRE(c2d_memory_need(&limits, &bytes, nullptr, nullptr) == C2D_OK);
  int failed = 0;
  double approach[2] = {};
  for (bool whole = false; !whole; ++failed) {
    REQUIRE(failed < 1000);
    runs::RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    runs::Machine machine(limits, bytes, &port);
    REQUIRE(machine.created == C2D_OK);
    c2d_solver* const s = machine.solver;
    REQUIRE((runs::read_deck(s, deck) == C2D_OK && c2d_prepare(s) == C2D_OK && c2d_run(s, nullptr, nullptr) == C2D_OK));
    const size_t n = store.done.size() + static_cast<size_t>(failed);
    store.before = [n](const runs::RamStore::Operation&, size_t i) { return i == n ? 5 : 0; };
    c2d_zone_state zone = C2D_INIT(c2d_zone_state);
    const c2d_status status = c2d_get_zone_state(s, 1, &zone);
    whole = store.done.size() <= n;
    if (!whole) {
      CHECK(status == C2D_ERR_STORE_READ);
      CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);
      continue;
    }
    store.before = {};
    approach[0] = zone.approach;
    double ux[2];
    REQUIRE((status == C2D_OK && c2d_get(s, C2D_END_UX, 1, 1, 2, ux, 1) == C2D_OK));
    REQUIRE(c2d_get_zone_state(s, 1, &zone) == C2D_OK);
    approach[1] = zone.approach;
  }
  CHECK(approach[0] == doctest::Approx(approach[1]).epsilon(1e-9));
}

// A cylinder above another, pressed on it by what the contact alone balances.
TEST_CASE("core edges: a cylinder that rests on another, with functions of all orders") {
  double force[3] = {};
  for (const int32_t nodes : {2, 3, 4}) {
    many::Model m;
    m.plane = C2D_AXISYMMETRIC;
    m.function_nodes = nodes;
    m.add(many::open_polygon({{0, -1, 4}, {1, -1, 2}, {1, 0, 4}, {0, 0, 0}}));
    m.add(many::open_polygon({{0, 0.01, 4}, {1, 0.01, 2}, {1, 1.01, 4}, {0, 1.01, 0}}));
    for (many::Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * nodes), many::End());
    m.set(1, 1, many::end_of(many::kHeld));
    m.set(2, 3, many::end_of(many::kPulled, 0, -1));
    m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    m.friction = 0.3;
    const many::Result r = many::solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(r.outcome == C2D_REACHED);
    force[nodes - 2] = std::fabs(r.bodies[1].contact[1]);
  }
  CHECK(force[0] > 0.1);
  for (const double f : force) CHECK(f == doctest::Approx(force[0]).epsilon(1e-6));
}

// The corner of the lower body is in a pair of the contact; the tie's end faces it.
TEST_CASE("core edges: a tie that ends where a contact does") {
  many::Model m;
  m.add(many::rectangle(0, 0, 1, 1, {4, 4, 4, 4}, 100));
  m.add(many::rectangle(1, 0, 2, 1, {4, 4, 4, 4}, 100));
  m.add(many::rectangle(0, 1, 1, 2, {4, 4, 4, 4}, 100));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(3, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 3, 1, 1, 3);
  m.join(C2D_ZONE_FREE + C2D_ZONE_TIED, 1, 2, 2, 4);
  m.friction = 0.3;
  const many::Result r = many::solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(std::fabs(r.bodies[2].contact[1]) == doctest::Approx(1));
  CHECK(many::imbalance(m, r) < 1e-8);
}

TEST_CASE("core edges: a weight in one of two load cases, with sums over cells" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = pushed(many::rough(210));
  m.body(2).force[1] = -0.01;
  check_alike(m, 95);
}

// At the tip, where the boundary begins and ends, two elements lie back to back.
TEST_CASE("core edges: the tip of a sliver is no slit") {
  many::Model m = two_blocks();
  const int32_t sliver = m.add(many::polygon({{6, 0, 3}, {9, -0.1, 1}, {9, 0.1, 3}}, 100));
  m.set(sliver, 2, many::end_of(many::kHeld));
  const many::Result r = many::solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(!r.told_of("slit"));
}

TEST_CASE("core edges: points of two curves of a body may not be in one place") {
  many::Model m = two_blocks();
  many::add_polygon(m.body(1), {{0.5, 0.8, 2}, {1, 0.2, 2}, {0.2, 0.2, 2}});
  many::add_polygon(m.body(1), {{1, 0.2, 2}, {2, 0.8, 2}, {2, 0.1, 2}}); // at a corner of the first hole
  m.body(1).ends.resize(static_cast<size_t>(m.body(1).elements()) * 2);
  many::Machine machine(m);
  many::Result r;
  if (machine.status == C2D_OK) r = machine.run();
  CHECK((machine.status == C2D_ERR_INPUT || r.status == C2D_ERR_INPUT));
  INFO(r.messages());
  INFO(last_text(machine.solver));
  CHECK((r.told_of("points") || last_text(machine.solver).find("points") != std::string::npos));
}

TEST_CASE("core edges: an arc through its own centre has the normal of its chord there") {
  c2d::SurfaceElement s = {};
  s.nodes = 2;
  s.x[0] = -1, s.x[1] = 1;
  s.radius = 1, s.length = 2;
  const c2d::SurfacePoint p = c2d::surface_point(s, 0);
  CHECK((p.x == 0 && p.y == 0 && p.nx == 0 && p.ny == -1));
  const c2d::SurfacePoint q = c2d::surface_point(s, 0.5);
  CHECK((q.x == 1 && q.y == 0));
}

// Both profiles are arcs and flats: with corrections of the gap, and without, indicators are of the same small size.
TEST_CASE("core edges: indicators on surfaces whose gaps follow slip") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", test::slip_pads() + "history normal 1; shift 1\nsteps 2\n");
  const test::Result made = test::run_shell("'" + paths::program() + "' mesh '" + (folder / "a.c2s") + "' mu=0.3 d=0.43");
  REQUIRE_MESSAGE(made.status == 0, made.err);
  many::Machine machine(made.out);
  REQUIRE(machine.status == C2D_OK);
  const many::Result r = machine.run();
  REQUIRE(r.status == C2D_OK);
  CHECK(machine.solver->model.bodies >= 2);
  double most = 0;
  for (int32_t b = 1; b <= 2; ++b) {
    c2d_body_result own = C2D_INIT(c2d_body_result);
    REQUIRE(c2d_get_body_result(machine.solver, b, &own) == C2D_OK);
    std::vector<double> off(static_cast<size_t>(own.elements) * C2D_OFF_FIELDS);
    REQUIRE(c2d_indicators(machine.solver, b, 1, own.elements, off.data(), C2D_OFF_FIELDS) == C2D_OK);
    for (const double each : off) {
      CHECK(std::isfinite(each));
      most = std::max(most, std::fabs(each));
    }
  }
  CHECK(most > 0);
}

// ---- contact on demand -------------------------------------------------------------------------------------------------

namespace {

many::Model floating(double pressure) {
  many::Model m = many::rough(84);
  m.set(2, 3, many::end_of(many::kPulled, 0, -pressure));
  return m;
}

void check_refused(const many::Model& m) {
  many::Machine machine(on_demand(m, kTouching));
  REQUIRE(machine.status == C2D_OK);
  const many::Result r = machine.run();
  CHECK(r.status == C2D_ERR_LIMIT);
  CHECK_MESSAGE(r.told_of("cannot be on demand"), r.messages());
}

} // namespace

TEST_CASE("core edges: zones meshed freely cannot be on demand, nor bodies with more motions than can be held" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(84);
  m.zones[0].kind = C2D_ZONE_FREE;
  check_refused(m);
  m = many::rough(84); // beside a body whose slit may close
  const int32_t slit =
      m.add(many::polygon({{2, 0, 4}, {6, 0, 4}, {6, 1.99, 4}, {4, 2, 4}, {6, 2.01, 4}, {6, 4, 4}, {2, 4, 4}}));
  m.set(slit, 1, many::end_of(many::kHeld));
  m.join(C2D_ZONE_MATCHING + C2D_ZONE_SELF, slit, 3, slit, 4);
  m.zones.back().without[1] = 1;
  check_refused(m);
  many::Machine few(on_demand(two_blocks(), 1)); // too few for columns that are made later
  REQUIRE(few.status == C2D_OK);
  CHECK(few.run().status == C2D_ERR_MEMORY);
  m = floating(0.03);
  for (int32_t k = 0; k < 4; ++k) { // each with three motions of its own
    const double x = 2 + 2 * k;
    const int32_t low = m.add(many::rectangle(x, -1, x + 1, 0, {4, 4, 4, 4}));
    const int32_t high = m.add(many::rectangle(x, 0, x + 1, 1, {4, 4, 4, 4}));
    m.set(low, 1, many::end_of(many::kHeld));
    m.set(high, 3, many::end_of(many::kPulled, 0, -1));
    m.join(C2D_ZONE_MATCHING, low, 3, high, 1);
  }
  check_refused(m);
}

TEST_CASE("core edges: on demand by the quadrature of the thesis, and without energies" * doctest::skip(c2d::kSmallCode)) {
  const many::Model m = many::rough(84);
  std::vector<double> tn[3];
  for (const int kind : {0, 1, 2}) { // whole, on demand, on demand without energies
    many::Machine machine(kind == 0 ? m : on_demand(m, kTouching));
    REQUIRE(machine.status == C2D_OK);
    c2d_options options = C2D_INIT(c2d_options);
    options.quadrature = C2D_QUADRATURE_THESIS;
    options.elimination = kind == 0 ? 0 : static_cast<int32_t>(C2D_ELIMINATION_COMPRESSED);
    REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    if (kind == 2) machine.solver->keeps_energy = 0;
    REQUIRE(c2d_run(machine.solver, nullptr, nullptr) == C2D_OK);
    CHECK((machine.solver->model.columns > 0) == (kind > 0));
    tn[kind].resize(84);
    REQUIRE(c2d_get(machine.solver, C2D_TN, 0, 1, 84, tn[kind].data(), 1) == C2D_OK);
  }
  double most = 0;
  for (const double p : tn[0]) most = std::max(most, std::fabs(p));
  CHECK(most > 0);
  for (size_t i = 0; i < 84; ++i) {
    CHECK(std::fabs(tn[1][i] - tn[0][i]) < kNear * most);
    CHECK(std::fabs(tn[2][i] - tn[1][i]) < kNear * most);
  }
}

TEST_CASE("core edges: on demand with all pairs in touch there is room for all that is asked for next" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model m = on_demand(many::rough(84), 50);
  m.set(2, 3, many::end_of("1100", 0, 0, 0, -5e-2));
  many::Machine machine(m);
  REQUIRE(machine.status == C2D_OK);
  CHECK(machine.run().status == C2D_ERR_MEMORY);
  CHECK(last_text(machine.solver).find("than the 50 of c2d_limits.touching; room for 84 takes ") != std::string::npos);
}

// All normals are along y: friction alone holds the upper body along x, and turned.
TEST_CASE("core edges: on demand, tangents hold what normals do not" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(0.03);
  const many::Range face = m.side(2, 1);
  for (int32_t i = face.first - 1; i <= face.last; ++i) m.body(2).xy[2 * static_cast<size_t>(i) + 1] = 1e-6;
  many::Machine machine(on_demand(m, kTouching));
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  CHECK(machine.solver->model.columns > 0);
  CHECK(c2d_run(machine.solver, nullptr, nullptr) == C2D_ERR_MEMORY); // all 84 pairs touch at once
  CHECK(last_text(machine.solver).find("room for 84 takes ") != std::string::npos);
}

TEST_CASE("core edges: on demand of bodies that contact holds, room for few pairs is enough for rates" *
          doctest::skip(c2d::kSmallCode)) {
  uint64_t bytes[3] = {};
  for (const int k : {0, 1, 2}) {
    const many::Model m = on_demand(floating(0.03), k == 0 ? 3 : k == 1 ? 10 : 60);
    std::vector<c2d_body_limits> list;
    const c2d_limits limits = many::limits_of(m, list);
    REQUIRE(c2d_memory_need(&limits, &bytes[k], nullptr, nullptr) == C2D_OK);
  }
  CHECK((bytes[0] <= bytes[1] && bytes[1] <= bytes[2]));
  check_alike(floating(0.03), 3); // hardly any touch
}

// Kernels of vectors and those without make the same results, up to round-off.
TEST_CASE("core edges: without vectors, compressed and inside" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(200);
  m.elimination = C2D_ELIMINATION_COMPRESSED;
  std::vector<double> of[2];
  for (const int plain : {0, 1}) {
    many::Machine machine(m);
    REQUIRE(machine.status == C2D_OK);
    if (plain != 0) machine.solver->instructions = c2d::Instructions::plain;
    REQUIRE((c2d_prepare(machine.solver) == C2D_OK && c2d_run(machine.solver, nullptr, nullptr) == C2D_OK));
    of[plain].resize(200 + 3 * C2D_POINT_FIELDS);
    REQUIRE(c2d_get(machine.solver, C2D_TN, 0, 1, 200, of[plain].data(), 1) == C2D_OK);
    const double at[] = {0.3, -0.1, 0.5, -0.5, 0.7, -0.3};
    REQUIRE(c2d_interior(machine.solver, 1, 3, at, 2, of[plain].data() + 200, C2D_POINT_FIELDS) == C2D_OK);
  }
  double most = 0;
  for (const double each : of[0]) most = std::max(most, std::fabs(each));
  for (size_t i = 0; i < of[0].size(); ++i) CHECK(std::fabs(of[1][i] - of[0][i]) < 10 * kNear * most);
}

// Each load case of a free body has its own point loads.
TEST_CASE("core edges: point loads of two load cases on a body that contact holds") {
  many::Model m = two_blocks();
  m.cases = 2;
  for (many::Body& body : m.bodies) body.second.assign(body.ends.size(), many::End());
  m.set_second(1, 1, many::end_of(many::kHeld));
  m.set_second(2, 3, many::end_of(many::kPulled, 0, -1));
  m.paths = {{1, 1.0, 1.0}, {1, -1.0, 0.5}};       // and off
  m.point_loads.push_back({2, 1.5, 1.5, 0, -0.5}); // near the surface: its share is known roughly
  m.point_loads.push_back({1, 1.5, 0.5, 0, -0.25});
  many::Machine machine(m);
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  const double mu = 0.3, on[] = {1, 1}, off[] = {-1, 0.5};
  c2d_outcome outcome = C2D_UNDECIDED;
  REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(machine.solver, on, 2, &outcome) == C2D_OK);
  CHECK(outcome == C2D_REACHED);
  c2d_body_state body = C2D_INIT(c2d_body_state);
  REQUIRE(c2d_get_body_state(machine.solver, 2, &body) == C2D_OK);
  CHECK(std::fabs(body.contact[1]) == doctest::Approx(6.5).epsilon(0.05));
  REQUIRE(c2d_advance(machine.solver, off, 2, &outcome) == C2D_OK);
  CHECK(outcome == C2D_FREE_MOTION);
}

// Held along x by friction alone, which any of the coefficients has.
TEST_CASE("core edges: on demand, a body that friction holds, with two coefficients" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(0.03);
  m.friction = 0.125;
  const many::Range face = m.side(2, 1);
  for (int32_t i = face.first - 1; i <= face.last; ++i) m.body(2).xy[2 * static_cast<size_t>(i) + 1] = 1e-3;
  for (const int32_t i : {10, 11, 12, 70, 71, 72}) m.body(2).xy[2 * static_cast<size_t>(i) + 1] = 0; // two flats touch
  std::vector<int32_t> order;
  std::stringstream text(many::deck_of(m, "two coefficients", order));
  std::vector<double> tn[2];
  for (const int two : {0, 1}) {
    runs::Deck deck;
    text.clear(), text.seekg(0);
    for (std::string line; std::getline(text, line);) {
      std::stringstream words(line);
      double count = 0, mu = 0, more = 0;
      if (two != 0 && words >> count >> mu && !(words >> more) && count == 1 && mu == m.friction) line = "2 0.125 0.25";
      deck.lines.push_back(line);
    }
    host::Limits limits = deck.limits();
    limits.touching = kTouching;
    CHECK(limits.coefficients == 1 + two);
    uint64_t bytes = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &bytes, nullptr) == C2D_OK);
    runs::RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    runs::Machine machine(limits, bytes, &port);
    REQUIRE(machine.created == C2D_OK);
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = C2D_ELIMINATION_COMPRESSED;
    REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
    REQUIRE(runs::read_deck(machine.solver, deck) == C2D_OK);
    const c2d_status prepared = c2d_prepare(machine.solver);
    REQUIRE_MESSAGE(prepared == C2D_OK, last_text(machine.solver));
    CHECK(machine.solver->model.columns > 0);
    const double mu = 0.3, all = 1;
    c2d_outcome outcome = C2D_UNDECIDED;
    REQUIRE((c2d_begin(machine.solver, &mu, 1) == C2D_OK && c2d_advance(machine.solver, &all, 1, &outcome) == C2D_OK));
    tn[two].resize(84);
    REQUIRE(c2d_get(machine.solver, C2D_TN, 0, 1, 84, tn[two].data(), 1) == C2D_OK);
  }
  CHECK(tn[0] == tn[1]);
}

TEST_CASE("core edges: on demand behind a body that touches nothing" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(84);
  m.add(many::rectangle(5, 0, 6, 1, {4, 4, 4, 4}));
  m.set(3, 1, many::end_of(many::kHeld));
  m.set(3, 3, many::end_of(many::kPulled, 0, 1));
  check_alike(many::with_bodies_in_order(m, {3, 1, 2}), kTouching);
}

namespace {

// step(session) with the n-th operation of the store failing, for every n: it says so. Then without.
template <class Step> int check_step(Host& host, Step step) {
  int failed = 0;
  for (;; ++failed) {
    const size_t from = host.own.done.size();
    const size_t n = from + static_cast<size_t>(failed);
    host.own.before = [n](const runs::RamStore::Operation&, size_t i) { return i == n ? 5 : 0; };
    const c2d_status status = step();
    const bool went_off = host.own.done.size() > n;
    host.own.before = {};
    CAPTURE(failed);
    if (!went_off) {
      CHECK(status == C2D_OK);
      return failed;
    }
    CHECK(status >= C2D_ERR_STORE_OPEN);
    CHECK(status <= C2D_ERR_STORE_SYNC);
  }
}

} // namespace

TEST_CASE("core edges: columns that are made when the store fails are not made" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = on_demand(floating(0.03), kTouching);
  Host host(m);
  REQUIRE(host.begin() == C2D_OK);
  REQUIRE(host.go(0.2) == C2D_OK);
  c2d_solver* const s = host.solver();
  c2d::Session session;
  c2d::open_session(s, session);
  std::vector<int32_t> pairs;
  const int32_t room = session.model.head->columns - s->made;
  for (int32_t i = 0; i < session.model.head->pairs && 2 * static_cast<int32_t>(pairs.size() + 1) <= room; ++i)
    if (session.model.pair[i].made < 0) pairs.push_back(i);
  REQUIRE(pairs.size() > 20); // more than are made together
  const int32_t made = s->made;
  const int failed = check_step(host, [&] {
    s->made = made;
    for (const int32_t i : pairs) session.model.pair[i].made = -1;
    return c2d::make_some(session, pairs.data(), static_cast<int32_t>(pairs.size()), true);
  });
  CHECK(failed > 10);
  CHECK(s->made == made + 2 * static_cast<int32_t>(pairs.size()));
  for (const int32_t i : pairs) session.model.pair[i].made = -1; // numbers that no pair has
  CHECK(c2d::remake_columns(s) == C2D_ERR_INTERNAL);
}

TEST_CASE("core edges: what holds bodies on demand is not found on a store that fails" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = many::rough(84);
  m.set(2, 3, many::End());
  many::Body& body = m.body(2);
  body.rigid = 1, body.is_free[0] = body.is_free[1] = body.is_free[2] = 1;
  body.point[0] = body.point[1] = 0.5, body.load[1] = -0.03;
  Host host(on_demand(many::with_bodies_in_order(m, {2, 1}), kTouching)); // the rigid one first
  REQUIRE(host.begin() == C2D_OK);
  REQUIRE(host.go(1) == C2D_OK);
  c2d_solver* const s = host.solver();
  c2d::Session session;
  c2d::open_session(s, session);
  CHECK(check_step(host, [&] { return c2d::fit_rigid(session); }) > 0);
  const std::vector<double> before = host.results();
  const int32_t made = s->made;
  std::vector<int32_t> kept;
  for (int32_t i = 0; i < session.model.head->pairs; ++i) kept.push_back(session.model.pair[i].made);
  CHECK(check_step(host, [&] {
          s->made = 0;
          for (int32_t i = 0; i < session.model.head->pairs; ++i) session.model.pair[i].made = -1;
          return c2d::hold_on_demand(s, false);
        }) > 3);
  CHECK(s->made > 0);
  CHECK(s->made <= made);
}

// ---- every operation of the store -----------------------------------------------------------------------------------

namespace {

// life(host, arm), in which arm() is called where failures begin, with each operation behind that failing, one after another.
// What it returns is the status of the first call that failed.
template <class LifeOf> int check_life(const many::Model& m, size_t at_most, LifeOf life) {
  size_t armed = 0, operations = 0;
  uint64_t least = 0;
  {
    Host first(m);
    life(first, [] {});
    least = runs::error_of(first.solver()).bytes_needed; // (thin layers take more)
  }
  {
    Host whole(m, nullptr, least);
    REQUIRE(life(whole, [&] { armed = whole.own.done.size(); }) == C2D_OK);
    operations = whole.own.done.size() - armed;
  }
  REQUIRE(operations > 0);
  int failed = 0;
  const size_t step = 1 + operations / at_most;
  for (size_t n = 0; n < operations; n += step) {
    CAPTURE(n);
    Host host(m, nullptr, least);
    runs::RamStore::Operation operation{};
    const c2d_status status = life(host, [&] {
      const size_t which = host.own.done.size() + n;
      host.own.before = [&operation, which](const runs::RamStore::Operation& now, size_t i) {
        if (i == which) operation = now;
        return i == which ? 5 : 0;
      };
    });
    if (status == C2D_OK) { // at most what says how far the tapes are used
      CHECK(operation.tape == C2D_TAPE_CONTROL);
      continue;
    }
    CHECK(status >= C2D_ERR_STORE_OPEN);
    CHECK(status <= C2D_ERR_STORE_SYNC);
    CHECK(c2d_get_state(host.solver()) == C2D_STATE_BROKEN);
    ++failed;
  }
  return failed;
}

} // namespace

TEST_CASE("core edges: layers whose displacements are unknowns, prepared and pressed on a store that fails" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model lowered = many::pressed_layers(2, 1e-4, C2D_ZONE_MATCHING, 4); // by what moves its upper side: no force is given
  lowered.set(4, 3, many::end_of(many::kHeld, 0, 0, 0, -1e-3));
  for (const many::Model& m : {many::pressed_layers(2, 1e-4, C2D_ZONE_MATCHING, 4),
                               many::pressed_layers(2, 1e-4, C2D_ZONE_MATCHING + C2D_ZONE_TIED, 4), lowered})
    CHECK(check_life(m, 4000, [](Host& host, auto arm) {
            arm();
            c2d_status status = host.begin();
            if (status == C2D_OK) status = host.go(1);
            c2d_body_result body = C2D_INIT(c2d_body_result);
            c2d_zone_state zone = C2D_INIT(c2d_zone_state);
            double step = 0;
            const double forth = 1;
            if (status == C2D_OK) status = c2d_get_zone_state(host.solver(), 1, &zone);
            if (status == C2D_OK) status = c2d_get_body_result(host.solver(), 2, &body);
            return status == C2D_OK ? c2d_next_event(host.solver(), &forth, 1, &step) : status;
          }) > 100);
}

TEST_CASE("core edges: on demand, begun, advanced and looked at on a store that fails" * doctest::skip(c2d::kSmallCode)) {
  for (const int rigid : {0, 1}) {
    many::Model m = floating(0.03);
    if (rigid != 0) {
      m.set(2, 3, many::End());
      many::Body& body = m.body(2);
      body.rigid = 1, body.is_free[0] = body.is_free[1] = body.is_free[2] = 1;
      body.point[0] = body.point[1] = 0.5, body.load[1] = -0.03;
    }
    CHECK(check_life(on_demand(m, kTouching), 40, [](Host& host, auto arm) {
            c2d_status status = c2d_prepare(host.solver());
            const double mu = 0.3;
            arm();
            if (status == C2D_OK) status = c2d_begin(host.solver(), &mu, 1);
            return status == C2D_OK ? host.go(1) : status;
          }) > 30);
    CHECK(check_life(on_demand(m, kTouching), 20, [](Host& host, auto arm) {
            c2d_status status = host.begin();
            if (status == C2D_OK) status = host.go(1);
            arm();
            c2d_zone_state zone = C2D_INIT(c2d_zone_state);
            c2d_body_result body = C2D_INIT(c2d_body_result);
            c2d_body_state state = C2D_INIT(c2d_body_state);
            double ends[4];
            if (status == C2D_OK) status = c2d_get_body_state(host.solver(), 2, &state);
            if (status == C2D_OK) status = c2d_get_zone_state(host.solver(), 1, &zone);
            if (status == C2D_OK) status = c2d_get(host.solver(), C2D_END_UX, 1, 1, 4, ends, 1);
            return status == C2D_OK ? c2d_get_body_result(host.solver(), 1, &body) : status;
          }) > 1);
  }
}

TEST_CASE("core edges: a cycle behind a path without friction, on a store that fails" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = cyclic::cylinder(4);
  m.paths = {{1, 1.0, 0}, {1, 0.4, 0}, {1, 1.0, 0}};
  m.repeated = 2, m.cycle_start = C2D_START_WITHOUT_FRICTION;
  m.cycle_states = 4;
  CHECK(check_life(m, 3000, [](Host& host, auto arm) {
          const c2d_status status = c2d_prepare(host.solver());
          arm();
          return status == C2D_OK ? c2d_run(host.solver(), nullptr, nullptr) : status;
        }) > 20);
}

TEST_CASE("core edges: plates that fall on each other, and a compressed body, on a store that fails" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model m;
  for (const double y : {0.0, 1.01, 2.03}) m.add(many::rectangle(0, y, 3, y + 1, {4, 2, 4, 2}, 100));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(3, 3, [](double x, double) { return many::end_of(many::kPulled, 0.1, -1 - 0.2 * x); });
  for (int i = 1; i <= 2; ++i) m.join(C2D_ZONE_MATCHING, i, 3, i + 1, 1);
  m.friction = 0.4;
  const auto pressed = [](Host& host, auto arm) {
    arm();
    const c2d_status status = host.begin();
    return status == C2D_OK ? host.go(1) : status;
  };
  CHECK(check_life(m, 3000, pressed) > 50);
  m = many::rough(40);
  m.elimination = C2D_ELIMINATION_COMPRESSED;
  CHECK(check_life(m, test::effort<size_t>(300, 2000), pressed) > 50);
}

TEST_CASE("core edges: a tableau some of whose pairs sleep is not built on a store that fails" *
          doctest::skip(c2d::kSmallCode)) {
  Host host(many::rough(84));
  REQUIRE(host.begin() == C2D_OK);
  REQUIRE(host.go(0.5) == C2D_OK);
  c2d::Session session;
  c2d::open_session(host.solver(), session);
  int32_t culprit = -1;
  CHECK(check_step(host, [&] { return c2d::build_tableau(session.tableau, *session.follower.tape, &culprit); }) > 10);
  CHECK(host.go(1) == C2D_OK);
}

TEST_CASE("core edges: friction that begins on a store that fails") {
  many::Model m = cyclic::cylinder(6);
  m.cycle_states = 4;
  Host host(m);
  const double mu = 0.3, loads[] = {1, 0};
  c2d_outcome outcome = C2D_UNDECIDED;
  REQUIRE((c2d_prepare(host.solver()) == C2D_OK && c2d_begin(host.solver(), &mu, 1) == C2D_OK));
  REQUIRE(c2d_advance(host.solver(), loads, 2, &outcome) == C2D_OK);
  c2d::Session session;
  c2d::open_session(host.solver(), session);
  host.solver()->coefficient = 1;
  CHECK(check_step(host, [&] { return c2d::start_friction(session); }) > 0);
}

// A double node in the middle of a straight side, between two elements in line.
TEST_CASE("core edges: stresses on either side of a double node") {
  many::Model m;
  m.add(many::polygon({{0, 0, 3}, {3, 0, 1}, {3, 0.5, 1}, {3, 0.5, 1}, {3, 1, 3}, {0, 1, 2}}, 100));
  m.set(1, 1, many::end_of("0110"));
  m.set(1, 6, many::end_of("1001"));
  m.set(1, 5, many::end_of(many::kPulled, 0, -1));
  const many::Result r = many::solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  for (size_t i = 0; i < r.boundary[0].size(); ++i) {
    const many::EndResult& e = r.boundary[0][i];
    if (static_cast<int32_t>(i / 2) + 1 == m.side(1, 3).first) continue; // has no length
    CHECK(e.syy == doctest::Approx(-1).epsilon(1e-8));
    CHECK(std::fabs(e.sxx) < 1e-8);
  }
}

TEST_CASE("core edges: a state in which a path was begun without a coefficient, or whose title has no end, is refused") {
  for (const int kind : {0, 1, 2}) {
    CAPTURE(kind);
    Host host(two_blocks());
    REQUIRE((host.begin() == C2D_OK && host.go(1) == C2D_OK));
    c2d_solver* const s = host.solver();
    if (kind == 1) s->run_step = 1, s->coefficient = 0;
    if (kind == 2) std::memset(s->model.title, 'x', sizeof s->model.title);
    REQUIRE(c2d_save(s) == C2D_OK);
    const c2d_status status = c2d_restore(s);
    CHECK((status == C2D_OK) == (kind == 0));
    if (kind != 0) CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);
  }
}

TEST_CASE("core edges: tied bodies, compressed, on a store that fails" * doctest::skip(c2d::kSmallCode)) {
  many::Model m;
  m.add(many::rectangle(0, 0, 1, 1, {8, 8, 8, 8}, 100));
  m.add(many::rectangle(0, 1, 1, 2, {8, 8, 8, 8}, 60));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 1, 3, 2, 1);
  m.elimination = C2D_ELIMINATION_COMPRESSED;
  CHECK(check_life(m, 1000, [](Host& host, auto arm) {
          arm();
          c2d_status status = host.begin();
          if (status == C2D_OK) status = host.go(1);
          double ends[4];
          c2d_summary sum = C2D_INIT(c2d_summary);
          if (status == C2D_OK) status = c2d_get(host.solver(), C2D_END_UX, 1, 1, 4, ends, 1);
          return status == C2D_OK ? c2d_get_summary(host.solver(), &sum) : status;
        }) > 50);
}

TEST_CASE("core edges: on demand, a state of a preparation that has been replaced is refused, and nothing is lost" *
          doctest::skip(c2d::kSmallCode)) {
  Host host(on_demand(floating(0.03), kTouching));
  REQUIRE((host.begin() == C2D_OK && host.go(0.7) == C2D_OK && c2d_save(host.solver()) == C2D_OK));
  const std::vector<double> before = host.results();
  REQUIRE((c2d_change_loads(host.solver()) == C2D_OK && c2d_prepare(host.solver()) == C2D_OK));
  REQUIRE(c2d_get_state(host.solver()) == C2D_STATE_PREPARED);
  const c2d_status refused = c2d_restore(host.solver());
  CHECK((refused == C2D_ERR_STORE_STALE || refused == C2D_ERR_STORE_FORMAT)); // older, or overwritten
  CHECK(c2d_get_state(host.solver()) == C2D_STATE_PREPARED);
  const double mu = 0.3;
  REQUIRE((c2d_begin(host.solver(), &mu, 1) == C2D_OK && host.go(0.7) == C2D_OK));
  const std::vector<double> after = host.results();
  double most = 0;
  for (size_t i = 0; i < 84; ++i) most = std::max(most, std::fabs(before[i])); // the normal tractions come first
  for (size_t i = 0; i < 84; ++i) CHECK(std::fabs(after[i] - before[i]) < kNear * most);
}

TEST_CASE("core edges: a cylinder that falls on another, on a store that fails") {
  many::Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = 3;
  m.add(many::open_polygon({{0, -1, 4}, {1, -1, 2}, {1, 0, 4}, {0, 0, 0}}));
  m.add(many::open_polygon({{0, 0.01, 4}, {1, 0.01, 2}, {1, 1.01, 4}, {0, 1.01, 0}}));
  for (size_t i = 0; i + 1 < 10; i += 2) m.body(2).xy[i + 1] += 1e-3 * m.body(2).xy[i]; // touches on the axis first
  for (many::Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * 3), many::End());
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  CHECK(check_life(m, 2000, [](Host& host, auto arm) {
          arm();
          const c2d_status status = host.begin();
          return status == C2D_OK ? host.go(1) : status;
        }) > 50);
}

TEST_CASE("core edges: a cycle of a path is cancelled wherever that is asked for, and run again") {
  many::Model m = cyclic::cylinder(4);
  m.paths = {{1, 1.0, 0}, {1, 0.4, 0}, {1, 1.0, 0}};
  m.repeated = 2, m.cycle_start = C2D_START_WITHOUT_FRICTION;
  m.cycle_states = 4;
  Host whole(m);
  REQUIRE((c2d_prepare(whole.solver()) == C2D_OK && c2d_run(whole.solver(), nullptr, nullptr) == C2D_OK));
  const std::vector<double> expected = whole.results();
  int cancelled = 0;
  for (int64_t chance = 0; chance < 400; ++chance) {
    CAPTURE(chance);
    Host host(m);
    REQUIRE(c2d_prepare(host.solver()) == C2D_OK);
    host.chances = chance;
    const c2d_status status = c2d_run(host.solver(), nullptr, nullptr);
    if (status == C2D_OK) break;
    CHECK(status == C2D_ERR_CANCELLED);
    ++cancelled;
    host.chances = -1;
    REQUIRE(c2d_run(host.solver(), nullptr, nullptr) == C2D_OK);
    CHECK(host.results() == expected);
  }
  CHECK(cancelled > 5);
}
