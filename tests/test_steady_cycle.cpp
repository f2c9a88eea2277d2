// c2d_cycle: the steady cycle against plain cycles, closed statements and a path followed by hand; what is refused; saved
// states.
#include "contact2d_cycle.h"
#include "contact2d_memory.h"
#include "cyclic_cylinder.hpp"
#include "effort.hpp"
#include "many_bodies.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace many;
using cyclic::cylinder, cyclic::kA, cyclic::kMu;

namespace {

using Loads = std::vector<double>;
const Loads kPressed = {0.4, 0, 1, 0}, kRound = {1, .06, .5, .06, .5, -.06, 1, -.06, 1, 0};

struct Ends { // of a run
  c2d_status status = C2D_OK;
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  std::vector<double> tn, tt, slip;
};

std::vector<double> field(c2d_solver* s, int32_t which) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  REQUIRE(c2d_get_summary(s, &summary) == C2D_OK);
  std::vector<double> out(static_cast<size_t>(summary.pairs));
  REQUIRE(c2d_get(s, which, 0, 1, summary.pairs, out.data(), 1) == C2D_OK);
  return out;
}

void begin(Machine& machine, const Loads& cycle, double mu = kMu) {
  c2d_outcome outcome = C2D_NO_PROGRESS;
  REQUIRE(machine.status == C2D_OK);
  if (c2d_get_state(machine.solver) == C2D_STATE_MODEL) REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(machine.solver, &cycle[cycle.size() - 2], 2, &outcome) == C2D_OK);
  REQUIRE(outcome == C2D_REACHED);
}

c2d_cycle_request request_of(const Loads& cycle, int32_t mode = C2D_CYCLES_EXACT, int32_t limit = 0, double tolerance = 0) {
  c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
  request.corners = static_cast<int32_t>(cycle.size()) / 2;
  request.cases = 2;
  request.load = cycle.data();
  request.mode = mode;
  request.limit = limit;
  request.tolerance = tolerance;
  return request;
}

Ends look(Machine& machine, c2d_status status, const c2d_cycle_state& state) {
  return {status, state, field(machine.solver, C2D_TN), field(machine.solver, C2D_TT), field(machine.solver, C2D_SLIP_SUM)};
}

Ends follow(Machine& machine, const c2d_cycle_request& request, c2d_cycle_fn each = nullptr, void* context = nullptr) {
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  const c2d_status status = c2d_cycle(machine.solver, &request, each, context, &state);
  return look(machine, status, state);
}

// Once round by hand.
void go_round(Machine& machine, const Loads& cycle) {
  for (size_t i = 0; i < cycle.size(); i += 2) {
    c2d_outcome outcome = C2D_NO_PROGRESS;
    REQUIRE(c2d_advance(machine.solver, &cycle[i], 2, &outcome) == C2D_OK);
    REQUIRE(outcome == C2D_REACHED);
  }
}

double largest(const std::vector<double>& numbers) {
  double most = 0;
  for (const double x : numbers) most = std::fmax(most, std::fabs(x));
  return most;
}
double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::fmax(most, std::fabs(a[i] - b[i]));
  return most;
}

double dissipated(c2d_solver* s) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  REQUIRE(c2d_get_summary(s, &summary) == C2D_OK);
  return summary.dissipated;
}

std::string message_of(c2d_solver* s) {
  c2d_error error = C2D_INIT(c2d_error);
  REQUIRE(c2d_last_error(s, &error) == C2D_OK);
  return error.text;
}

} // namespace

TEST_CASE("steady cycle: extrapolation ends where plain cycles end, and a cycle by hand repeats it") {
  for (const Loads& cycle : {kPressed, kRound}) {
    Machine machine(cylinder(12));
    begin(machine, cycle);
    const Ends plain = follow(machine, request_of(cycle, C2D_CYCLES_PLAIN, 500, 1e-11));
    REQUIRE(plain.status == C2D_OK);
    CHECK((plain.state.result == C2D_CYCLE_SLIPS && plain.state.extrapolations == 0));
    begin(machine, cycle);
    const Ends found = follow(machine, request_of(cycle));
    REQUIRE(found.status == C2D_OK);
    CHECK((found.state.result == C2D_CYCLE_SLIPS && found.state.outcome == C2D_REACHED));
    CHECK(found.state.extrapolations > 0);
    CHECK(found.state.cycles <= 20);
    CHECK(plain.state.cycles > 2 * found.state.cycles - 10);
    CHECK(found.state.change <= 1e-10);
    const double p = largest(plain.tn);
    CHECK(apart(plain.tn, found.tn) < 1e-9 * p);
    CHECK(apart(plain.tt, found.tt) < 1e-9 * p);
    CHECK(found.state.dissipated == doctest::Approx(plain.state.dissipated).epsilon(1e-7).scale(0));
    CHECK(found.state.slip_range == doctest::Approx(plain.state.slip_range).epsilon(1e-7).scale(0));
    const double before = dissipated(machine.solver);
    go_round(machine, cycle);
    CHECK(apart(found.tt, field(machine.solver, C2D_TT)) < 1e-9 * p);
    CHECK(apart(found.tn, field(machine.solver, C2D_TN)) < 1e-9 * p);
    CHECK(dissipated(machine.solver) - before == doctest::Approx(found.state.dissipated).epsilon(1e-7).scale(0));
    c2d_summary summary = C2D_INIT(c2d_summary);
    REQUIRE(c2d_get_summary(machine.solver, &summary) == C2D_OK);
    CHECK(std::fabs(summary.energy_defect) < 1e-3);
  }
}

TEST_CASE("steady cycle: like bodies repeat from the second cycle on; with much friction nothing slips") {
  const Loads cycle = {1, -.1, 1, .1};
  Machine machine(cylinder(10, true));
  begin(machine, cycle);
  const Ends like = follow(machine, request_of(cycle));
  REQUIRE(like.status == C2D_OK);
  CHECK((like.state.result == C2D_CYCLE_SLIPS && like.state.cycles <= 2 && like.state.extrapolations == 0));
  CHECK(like.state.change < 1e-11);
  // Mindlin and Deresiewicz: the range of a full reversal is that of Q at twice the friction; the middle sticks.
  CHECK((like.state.stuck > 0 && like.state.slipped > 0 && std::fabs(like.state.walk) < 1e-9 * like.state.slip_range));
  const Loads small = {1, -.01, 1, .01};
  begin(machine, small, 5.0);
  const Ends shaken = follow(machine, request_of(small));
  REQUIRE(shaken.status == C2D_OK);
  CHECK((shaken.state.result == C2D_CYCLE_SHAKES_DOWN && shaken.state.slipped == 0));
  CHECK(std::fabs(shaken.state.dissipated) < 1e-18);
}

TEST_CASE("steady cycle: surfaces that move on by the same amount in every cycle") {
  // Sideways under little pressure, back under much.
  const Loads cycle = {1, .29, .4, 0, 1, 0};
  Machine machine(cylinder(10));
  begin(machine, cycle);
  const Ends walks = follow(machine, request_of(cycle));
  REQUIRE(walks.status == C2D_OK);
  c2d_cycle_zone zone = C2D_INIT(c2d_cycle_zone);
  REQUIRE(c2d_get_cycle_zone(machine.solver, 1, &zone) == C2D_OK);
  const size_t pairs = walks.slip.size(); // (those of the platen's tie come last, and take no part)
  std::vector<double> walk(pairs), range(pairs), stuck(pairs), touched(pairs);
  c2d_zone first = C2D_INIT(c2d_zone);
  REQUIRE(c2d_get_zone(machine.solver, 1, &first) == C2D_OK);
  const int32_t count = first.pairs;
  std::fill(walk.begin(), walk.end(), 1.0);
  REQUIRE(c2d_get_cycle(machine.solver, C2D_CYCLE_WALK, 1, static_cast<int32_t>(pairs), walk.data(), 1) == C2D_OK);
  for (size_t i = static_cast<size_t>(count); i < pairs; ++i) CHECK(walk[i] == 0);
  REQUIRE(c2d_get_cycle(machine.solver, C2D_CYCLE_RANGE, 1, count, range.data(), 1) == C2D_OK);
  REQUIRE(c2d_get_cycle(machine.solver, C2D_CYCLE_STUCK, 1, count, stuck.data(), 1) == C2D_OK);
  REQUIRE(c2d_get_cycle(machine.solver, C2D_CYCLE_TOUCHED, 1, count, touched.data(), 1) == C2D_OK);
  const std::vector<double> ut1 = field(machine.solver, C2D_UT1), ut2 = field(machine.solver, C2D_UT2);
  go_round(machine, cycle);
  const std::vector<double> after1 = field(machine.solver, C2D_UT1), after2 = field(machine.solver, C2D_UT2),
                            slip = field(machine.solver, C2D_SLIP_SUM);
  double most = 0;
  int32_t stuck_pairs = 0, touched_pairs = 0;
  for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
    stuck_pairs += stuck[i] != 0;
    touched_pairs += touched[i] != 0;
    if (touched[i] == 0) continue;
    const double moved = after2[i] - after1[i] - ut2[i] + ut1[i];
    CHECK(walk[i] == doctest::Approx(moved).epsilon(1e-6).scale(walks.state.slip_range));
    CHECK(range[i] >= std::fabs(slip[i] - walks.slip[i]) - 1e-6 * walks.state.slip_range);
    most = std::fmax(most, std::fabs(moved));
  }
  CHECK(std::fabs(walks.state.walk) == doctest::Approx(most).epsilon(1e-6).scale(walks.state.slip_range));
  CHECK((stuck_pairs == walks.state.stuck && zone.stuck == stuck_pairs && zone.touched == touched_pairs));
  CHECK(zone.slip_range == walks.state.slip_range);
  const bool ratchets = most > 1e-6 * walks.state.slip_range;
  CHECK((walks.state.result == C2D_CYCLE_RATCHETS) == ratchets);
  CHECK(ratchets);
}

// A ring with a patch of pressure that goes round inside it, which another program saw walk by 0.550 um in a revolution of 96
// positions, and backwards by 0.147 um in one of 24 (rounded). All of it turns as one.
TEST_CASE("steady cycle: a ring walks round in its housing") {
  const std::string ring =
      "parameter K 24\nbody ring E 210e3 nu 0.3\ncircle outer centre 0 0 radius 43\nhole\n"
      "circle bore centre 0 0 radius 40\nbody housing E 210e3 nu 0.3\ncircle rim centre 0 0 radius 60\nhole\n"
      "circle seat centre 0 0 radius 43\ncontact ring.outer housing.seat mu 0.2\nfix housing.rim\n"
      "case fit\npressure ring.bore 0.5\ncase roll round 0 0 positions K\n"
      "pressure ring.bore {400*max(0, cos(atan2(y, x)) - cos(25*deg))}\n"
      "history fit 1; roll 1; roll to 1\nfunctions quadratic\ntolerance off\n"
      "elements ring.outer 80\nelements housing.seat 80\nelements ring.bore 80\n";
  const test::Folder folder;
  test::write_file(folder / "ring.c2s", ring);
  const std::vector<std::pair<int32_t, double>> walks = {{24, -0.147e-3}, {96, 0.550e-3}};
  for (size_t i = 0; i < test::effort<size_t>(1, 2); ++i) {
    const auto [positions, walk] = walks[i];
    CAPTURE(positions);
    const test::Result made =
        test::run_shell("'" + paths::program() + "' mesh '" + (folder / "ring.c2s") + "' K=" + std::to_string(positions));
    REQUIRE_MESSAGE(made.status == 0, made.err);
    Machine machine(made.out, 20);
    c2d_solver* const s = machine.solver;
    REQUIRE(machine.status == C2D_OK);
    REQUIRE(c2d_prepare(s) == C2D_OK);
    const double mu = 0.2;
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    c2d_summary summary = C2D_INIT(c2d_summary);
    REQUIRE(c2d_get_summary(s, &summary) == C2D_OK);
    REQUIRE(summary.paths == positions + 2);
    const int32_t cases = summary.load_cases;
    std::vector<double> loads; // of a revolution
    for (int32_t p = 1; p <= summary.paths; ++p) {
      std::vector<double> load(static_cast<size_t>(cases));
      int32_t increments = 0;
      REQUIRE(c2d_get_path(s, p, &increments, load.data(), cases) == C2D_OK);
      c2d_outcome outcome = C2D_NO_PROGRESS;
      if (p <= 2) REQUIRE((c2d_advance(s, load.data(), cases, &outcome) == C2D_OK && outcome == C2D_REACHED));
      if (p > 2) loads.insert(loads.end(), load.begin(), load.end());
    }
    c2d_cycle_request request = request_of(loads);
    request.corners = positions;
    request.cases = cases;
    const Ends found = follow(machine, request);
    REQUIRE(found.status == C2D_OK);
    CHECK((found.state.result == C2D_CYCLE_RATCHETS && found.state.cycles <= 20));
    c2d_cycle_zone zone = C2D_INIT(c2d_cycle_zone);
    REQUIRE(c2d_get_cycle_zone(s, 1, &zone) == C2D_OK);
    CHECK(std::fabs(zone.walk - walk) < 1e-6);
    CHECK((zone.touched == 160 && zone.stuck == found.state.stuck));
    std::vector<double> pairs(160);
    REQUIRE(c2d_get_cycle(s, C2D_CYCLE_WALK, 1, 160, pairs.data(), 1) == C2D_OK);
    for (const double w : pairs) CHECK(w == doctest::Approx(zone.walk).epsilon(1e-6).scale(0));
  }
}

TEST_CASE("steady cycle: a limit, a path that ends, the tolerance") {
  Machine machine(cylinder(10));
  begin(machine, kPressed);
  const Ends few = follow(machine, request_of(kPressed, C2D_CYCLES_EXACT, 2));
  CHECK((few.status == C2D_OK && few.state.result == C2D_CYCLE_NOT_STEADY && few.state.cycles == 2));
  begin(machine, kPressed);
  const Ends loose = follow(machine, request_of(kPressed, C2D_CYCLES_EXACT, 0, 0.5));
  CHECK((loose.status == C2D_OK && loose.state.cycles == 1 && loose.state.change <= 0.5));
  const Loads slides = {1, .5, 1, 0};
  begin(machine, slides);
  const Ends stopped = follow(machine, request_of(slides));
  CHECK((stopped.status == C2D_OK && stopped.state.result == C2D_CYCLE_STOPPED && stopped.state.cycles == 0));
  CHECK(stopped.state.outcome == C2D_GROSS_SLIDING);
}

namespace {

struct Saved {
  c2d_solver* solver;
  int32_t at, seen;
};
int32_t save_at(void* context, const c2d_cycle_state* now) {
  Saved& saved = *static_cast<Saved*>(context);
  ++saved.seen;
  if (now->cycles != saved.at) return 0;
  double tn = 0;
  if (c2d_get(saved.solver, C2D_TN, 0, 20, 1, &tn, 1) != C2D_OK || c2d_save(saved.solver) != C2D_OK) return 2;
  return 1;
}

} // namespace

TEST_CASE("steady cycle: saved at any cycle it goes on with the same bits") {
  const Model model = cylinder(10);
  Machine whole(model);
  begin(whole, kPressed);
  const Ends one = follow(whole, request_of(kPressed));
  REQUIRE(one.state.cycles > 4);
  for (int32_t at = 1; at <= one.state.cycles; ++at) {
    Machine machine(model);
    begin(machine, kPressed);
    Saved saved = {machine.solver, at, 0};
    const c2d_cycle_request request = request_of(kPressed);
    c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
    REQUIRE(c2d_cycle(machine.solver, &request, save_at, &saved, &state) == C2D_ERR_CALLBACK);
    CHECK((saved.seen == at && message_of(machine.solver) == c2d_message(C2D_ERR_CALLBACK)));
    go_round(machine, kPressed); // something else, then back
    REQUIRE(c2d_restore(machine.solver) == C2D_OK);
    saved = {machine.solver, 0, 0};
    const Ends two = follow(machine, request, save_at, &saved);
    CHECK((two.status == C2D_OK && saved.seen == one.state.cycles - at));
    CHECK(std::memcmp(&one.state, &two.state, sizeof one.state) == 0);
    CHECK((one.tn == two.tn && one.tt == two.tt && one.slip == two.slip));
  }
}

TEST_CASE("steady cycle: another request after a saved one begins anew, and so does c2d_run") {
  Machine machine(cylinder(10));
  begin(machine, kPressed);
  Saved saved = {machine.solver, 2, 0};
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  c2d_cycle_request request = request_of(kPressed);
  REQUIRE(c2d_cycle(machine.solver, &request, save_at, &saved, &state) == C2D_ERR_CALLBACK);
  REQUIRE(c2d_restore(machine.solver) == C2D_OK);
  c2d_summary summary = C2D_INIT(c2d_summary);
  REQUIRE(c2d_get_summary(machine.solver, &summary) == C2D_OK);
  CHECK((summary.run_step == 0 && summary.run_coefficient == 0));
  request.tolerance = 0.9;
  REQUIRE(c2d_cycle(machine.solver, &request, nullptr, nullptr, &state) == C2D_OK);
  CHECK(state.cycles == 1);
  REQUIRE(c2d_restore(machine.solver) == C2D_OK);
  CHECK(c2d_run(machine.solver, nullptr, nullptr) == C2D_OK);
}

TEST_CASE("steady cycle: what is refused") {
  Machine machine(cylinder(10));
  c2d_solver* const s = machine.solver;
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  c2d_cycle_request request = request_of(kPressed);
  CHECK(c2d_cycle(s, &request, nullptr, nullptr, &state) == C2D_ERR_STATE);
  begin(machine, kPressed);
  double number = 0;
  c2d_cycle_zone zone = C2D_INIT(c2d_cycle_zone);
  CHECK(c2d_get_cycle(s, C2D_CYCLE_WALK, 1, 1, &number, 1) == C2D_ERR_ARGUMENT);
  CHECK(message_of(s) == "no cycle has been followed: c2d_cycle follows them, and c2d_run after c2d_repeat_paths");
  CHECK(c2d_get_cycle_zone(s, 1, &zone) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_cycle_state(s, &state) == C2D_ERR_ARGUMENT);
  const auto refused = [&](const c2d_cycle_request& r, const std::string& words) {
    CHECK(c2d_cycle(s, &r, nullptr, nullptr, &state) == C2D_ERR_ARGUMENT);
    CHECK_MESSAGE(message_of(s) == words, message_of(s));
  };
  const Loads open = {0.4, 0, 0.5, 0}, still = {1, 0, 1, 0}, odd = {0.4, HUGE_VAL, 1, 0};
  refused(request_of(open), "the cycle does not close: its last corner is not the load reached");
  refused(request_of(still), "all corners of the cycle are the same load, expected two different ones");
  refused(request_of(odd), "load is inf, expected a finite number");
  request.corners = 1;
  refused(request, "corners is 1, expected 2 or more");
  request = request_of(kPressed);
  request.cases = 1;
  refused(request, "cases is 1, expected 2");
  request = request_of(kPressed, 3);
  refused(request, "mode is 3, expected 0 to 2");
  request = request_of(kPressed, 0, -1);
  refused(request, "limit is -1, expected 0 or more");
  request = request_of(kPressed, 0, 0, -1);
  refused(request, "tolerance is -1, expected 0 to 1");
  request = request_of(kPressed);
  request.load = nullptr;
  refused(request, "load is null");
  CHECK(c2d_cycle(s, nullptr, nullptr, nullptr, &state) == C2D_ERR_ARGUMENT);
  request = request_of(kPressed, 0, 1);
  CHECK(c2d_cycle(s, &request, nullptr, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  REQUIRE(c2d_cycle(s, &request, nullptr, nullptr, &state) == C2D_OK);
  CHECK(c2d_get_cycle(s, 4, 1, 1, &number, 1) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_cycle(s, 0, 0, 1, &number, 1) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_cycle(s, 0, 1, 100000, &number, 1) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_cycle(s, 0, 1, 1, nullptr, 1) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_cycle(s, 0, 1, 0, nullptr, 1) == C2D_OK);
  CHECK(c2d_get_cycle_zone(s, 0, &zone) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_cycle_zone(s, 1, nullptr) == C2D_ERR_ARGUMENT);
  REQUIRE(c2d_cancel(s) == C2D_OK);
  CHECK(c2d_cycle(s, &request, nullptr, nullptr, &state) == C2D_ERR_CANCELLED);
  Model none = cylinder(10);
  none.cycle_states = 0;
  Machine without(none);
  begin(without, kPressed);
  CHECK(c2d_cycle(without.solver, &request, nullptr, nullptr, &state) == C2D_ERR_ARGUMENT);
  CHECK(message_of(without.solver) == "c2d_limits.cycle_states is 0: there is no room for the states of cycles");
  CHECK(c2d_get_cycle(without.solver, 0, 1, 1, &number, 1) == C2D_ERR_ARGUMENT);
}

TEST_CASE("steady cycle: room for its states, none when not asked") {
  Model model = cylinder(10);
  std::vector<c2d_body_limits> list;
  const auto need = [&](int32_t states) {
    model.cycle_states = states;
    const c2d_limits limits = limits_of(model, list);
    uint64_t minimum = 0;
    c2d_error why = C2D_INIT(c2d_error);
    CHECK(c2d_memory_need(&limits, &minimum, nullptr, &why) == C2D_OK);
    return minimum;
  };
  const uint64_t none = need(0), pairs = static_cast<uint64_t>(limits_of(model, list).pairs);
  for (const int32_t states : {1, 7, 30}) {
    const uint64_t more = need(states) - none, bytes = C2D_CYCLE_BYTES(pairs, states);
    CHECK((more <= bytes && more + 128 > bytes));
  }
  model.cycle_states = -1;
  const c2d_limits limits = limits_of(model, list);
  uint64_t minimum = 0;
  CHECK(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  // Few directions: they are begun anew, and the cycle is found all the same.
  model.cycle_states = 2;
  Machine machine(model);
  begin(machine, kRound);
  const Ends found = follow(machine, request_of(kRound, C2D_CYCLES_FAST, 200));
  CHECK((found.status == C2D_OK && found.state.result == C2D_CYCLE_SLIPS));
}
