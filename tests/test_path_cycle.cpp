// A load path with a cycle that c2d_run repeats: it ends where c2d_cycle ends, and goes on from a saved state with the same
// bytes.
#include "contact2d_cycle.h"
#include "cyclic_cylinder.hpp"
#include "is_resumed.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace many;

namespace {

// P to 1, then 0.4 and back in `steps` increments each; or with a load sideways.
Model with_cycle(int n, int32_t steps = 2, int32_t limit = 0) {
  Model m = cyclic::cylinder(n);
  m.paths = {{2, 1.0, 0}, {steps, 0.4, 0}, {steps, 1.0, 0}};
  m.repeated = 2;
  m.cycle_limit = limit;
  return m;
}

struct Seen { // by the step callback
  c2d_solver* solver;
  std::vector<int32_t> kinds, steps;
  std::vector<c2d_cycle_state> cycles;
};
int32_t see(void* context, const c2d_step* now) {
  Seen& seen = *static_cast<Seen*>(context);
  seen.kinds.push_back(now->kind), seen.steps.push_back(now->step);
  if (now->kind != C2D_STEP_CYCLE) return 0;
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  if (c2d_get_cycle_state(seen.solver, &state) != C2D_OK) return 1;
  seen.cycles.push_back(state);
  return 0;
}

Seen run(Machine& machine) {
  Seen seen = {machine.solver, {}, {}, {}};
  REQUIRE(machine.status == C2D_OK);
  if (c2d_get_state(machine.solver) == C2D_STATE_MODEL) REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(c2d_run(machine.solver, see, &seen) == C2D_OK);
  return seen;
}

std::vector<double> field(c2d_solver* s, int32_t which) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  REQUIRE(c2d_get_summary(s, &summary) == C2D_OK);
  std::vector<double> out(static_cast<size_t>(summary.pairs));
  REQUIRE(c2d_get(s, which, 0, 1, summary.pairs, out.data(), 1) == C2D_OK);
  return out;
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::fmax(most, std::fabs(a[i] - b[i]));
  return most;
}

std::string message_of(c2d_solver* s) {
  c2d_error error = C2D_INIT(c2d_error);
  REQUIRE(c2d_last_error(s, &error) == C2D_OK);
  return error.text;
}

} // namespace

TEST_CASE("cycle of a path: c2d_run follows the cycles of c2d_cycle, then records the steps of one more") {
  Machine machine(with_cycle(10));
  const Seen seen = run(machine);
  const c2d_cycle_state last = seen.cycles.back();
  CHECK((last.result == C2D_CYCLE_SLIPS && last.change <= 1e-10 && last.extrapolations > 0));
  const auto cycles = static_cast<size_t>(last.cycles);
  REQUIRE(seen.cycles.size() == cycles);
  REQUIRE(seen.kinds.size() == 6 + cycles); // the steps count as without cycles
  CHECK((seen.steps.back() == 6 && seen.kinds.back() == C2D_STEP_RECORDED && seen.steps[2] == 2));
  CHECK(seen.kinds[2] == C2D_STEP_CYCLE);
  const std::vector<double> tt = field(machine.solver, C2D_TT), tn = field(machine.solver, C2D_TN);
  std::vector<double> stuck(static_cast<size_t>(last.stuck));
  CHECK(c2d_get_cycle(machine.solver, C2D_CYCLE_STUCK, 1, last.stuck, stuck.data(), 1) == C2D_OK);

  const double mu = cyclic::kMu, load[] = {0.4, 0, 1, 0};
  c2d_outcome outcome = C2D_NO_PROGRESS;
  REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(machine.solver, load + 2, 2, &outcome) == C2D_OK);
  c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
  request.corners = request.cases = 2, request.load = load;
  c2d_cycle_state by_hand = C2D_INIT(c2d_cycle_state);
  REQUIRE(c2d_cycle(machine.solver, &request, nullptr, nullptr, &by_hand) == C2D_OK);
  CHECK((by_hand.cycles == last.cycles && by_hand.stuck == last.stuck));
  CHECK(by_hand.dissipated == doctest::Approx(last.dissipated).epsilon(1e-9).scale(0));
  double largest = 0;
  for (const double p : tn) largest = std::fmax(largest, p);
  CHECK(apart(tt, field(machine.solver, C2D_TT)) < 1e-9 * largest);
}

TEST_CASE("cycle of a path: changes within the cycles are not shown, those of the recorded steps are") {
  Machine machine(with_cycle(6, 1, 3));
  c2d_options options = C2D_INIT(c2d_options);
  options.every_change = 1;
  REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
  const Seen seen = run(machine);
  CHECK(seen.cycles.size() == 3);
  CHECK((seen.cycles.back().result == C2D_CYCLE_NOT_STEADY && seen.cycles.back().cycles == 3));
  size_t first = 0; // of the cycles
  while (seen.kinds[first] != C2D_STEP_CYCLE) ++first;
  for (size_t i = first; i < first + 3; ++i) CHECK((seen.kinds[i] == C2D_STEP_CYCLE && seen.steps[i] == 2));
  CHECK((seen.kinds[first + 3] == C2D_STEP_CHANGE && seen.steps[first + 3] == 3));
}

TEST_CASE("cycle of a path: without extrapolation after the last cycle that is allowed") {
  // So what is recorded begins where plain cycles end.
  Machine whole(with_cycle(10, 1));
  const std::vector<c2d_cycle_state> all = run(whole).cycles;
  size_t i = 0; // the first that ends in an extrapolated state
  while (all[i].extrapolations == 0) ++i;
  Machine machine(with_cycle(10, 1, static_cast<int32_t>(i) + 1));
  const Seen seen = run(machine);
  CHECK((seen.cycles.size() == i + 1 && seen.cycles[i].extrapolations == 0 && all[i].extrapolations == 1));
  CHECK(seen.cycles[i].result == C2D_CYCLE_NOT_STEADY);
}

TEST_CASE("cycle of a path: steady to so many digits") {
  Model model = with_cycle(10, 1);
  int32_t before = 0;
  for (const int32_t digits : {2, 4, 8}) {
    model.cycle_digits = digits;
    Machine machine(model);
    const std::vector<c2d_cycle_state> cycles = run(machine).cycles;
    const double tolerance = std::pow(10.0, -digits);
    CHECK((cycles.back().result != C2D_CYCLE_NOT_STEADY && cycles.back().change <= tolerance));
    CHECK((cycles[cycles.size() - 2].change > tolerance && cycles.back().cycles > before));
    before = cycles.back().cycles;
  }
}

TEST_CASE("cycle of a path: started without friction, a contact of unlike bodies ends in another steady cycle") {
  Model model = with_cycle(10);
  Machine loaded(model);
  const Seen one = run(loaded);
  model.cycle_start = C2D_START_WITHOUT_FRICTION;
  Machine smooth(model);
  const Seen two = run(smooth);
  REQUIRE((one.cycles.back().result == C2D_CYCLE_SLIPS && two.cycles.back().result == C2D_CYCLE_SLIPS));
  const std::vector<double> p = field(loaded.solver, C2D_TN), q = field(loaded.solver, C2D_TT);
  double largest = 0;
  for (const double v : p) largest = std::fmax(largest, v);
  CHECK(apart(q, field(smooth.solver, C2D_TT)) > 1e-2 * largest);
  CHECK(two.cycles.back().dissipated > 0);

  // All pairs slide to and fro: then nothing is left of the start.
  Model sliding = cyclic::cylinder(8);
  sliding.platens[0].is_free[0] = 0;
  sliding.platens[0].second_motion[0] = 0.02;
  sliding.paths = {{1, 1.0, 0}, {1, 1.0, 1}, {1, 1.0, -1}, {1, 1.0, 1}};
  sliding.repeated = 2;
  Machine a(sliding);
  const Seen as_loaded = run(a);
  CHECK((as_loaded.cycles.back().result == C2D_CYCLE_SLIPS && as_loaded.cycles.back().stuck == 0));
  sliding.cycle_start = C2D_START_WITHOUT_FRICTION;
  Machine b(sliding);
  run(b);
  CHECK(apart(field(a.solver, C2D_TT), field(b.solver, C2D_TT)) < 1e-9 * largest);
}

TEST_CASE("cycle of a path: a path that ends within a cycle says so") {
  Model model = with_cycle(8);
  model.paths = {{1, 1.0, 0}, {1, 1.0, 0.4}, {1, 1.0, 0}}; // more than friction carries
  Machine machine(model);
  const Seen seen = run(machine);
  CHECK(seen.cycles.empty());
  CHECK((seen.kinds.back() == C2D_STEP_STOPPED && seen.steps.back() == 2));
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  CHECK(c2d_get_cycle_state(machine.solver, &state) == C2D_ERR_ARGUMENT); // none was whole
}

TEST_CASE("cycle of a path: stopped after any step or cycle and resumed, with the same bytes") {
  interrupted::is_resumed("cycle", interrupted::job_of(with_cycle(6)), 10, 40);
  Model smooth = with_cycle(4, 1);
  smooth.cycle_start = C2D_START_WITHOUT_FRICTION;
  interrupted::is_resumed("without friction", interrupted::job_of(smooth), 4, 40);
}

TEST_CASE("cycle of a path: two coefficients of friction, each with its cycles") {
  Model model = with_cycle(4, 1);
  const interrupted::Job two = interrupted::also_with(0.1, interrupted::job_of(model));
  interrupted::is_resumed("two coefficients", two, 8, 9);
}

TEST_CASE("cycle of a path: what is refused, and what is given back") {
  Model model = with_cycle(4);
  Machine machine(model);
  int32_t first = 0, pieces = 0, limit = 0, digits = 0, start = -1;
  REQUIRE(c2d_get_repeated(machine.solver, &first, &pieces, &limit, &digits, &start) == C2D_OK);
  CHECK((first == 2 && pieces == 2 && limit == 50 && digits == 10 && start == C2D_START_AS_LOADED));
  CHECK(c2d_get_repeated(machine.solver, nullptr, &pieces, &limit, &digits, &start) == C2D_ERR_ARGUMENT);
  CHECK(c2d_repeat_paths(machine.solver, 2, 0, 0, 0) == C2D_ERR_STATE);
  Machine plain(cyclic::cylinder(4));
  REQUIRE(c2d_get_repeated(plain.solver, &first, &pieces, &limit, &digits, &start) == C2D_OK);
  CHECK((first == 0 && pieces == 0 && limit == 0 && start == 0));

  const auto refused = [](const Model& m, const std::string& words) {
    Machine bad(m);
    CHECK(bad.status == C2D_ERR_ARGUMENT);
    REQUIRE(bad.solver != nullptr);
    CHECK_MESSAGE(message_of(bad.solver) == words, message_of(bad.solver));
  };
  model.repeated = 3;
  refused(model, "the cycle has no segment of the path before it, expected one that leads to its first load");
  model.repeated = 1;
  refused(model, "pieces is 1, expected 2 or more");
  model.repeated = 2, model.cycle_limit = -1;
  refused(model, "limit is -1, expected 0 to 1000000");
  model.cycle_limit = 0, model.cycle_start = 3;
  refused(model, "start is 3, expected 0 to 2");
  model.cycle_start = 0, model.cycle_digits = 13;
  refused(model, "digits is 13, expected 0 to 12");
  model.cycle_digits = 0, model.paths[2].load = 0.9;
  refused(model, "the cycle does not close: its last load is not the one at which it begins");
  model.paths = {{1, 1.0}, {1, 1.0}, {1, 1.0}};
  refused(model, "all loads of the cycle are the same, expected two different ones");
}
