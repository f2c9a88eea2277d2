// Cycles of loads (solver/cycle.cpp) where extrapolation fails, may not be tried, or is not needed.
#include "contact2d_cycle.h"
#include "cyclic_cylinder.hpp"
#include "paths.hpp"
#include "shell.hpp"
#include "slip_pads.hpp"
#include "solver/cycle.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <functional>

using namespace many;
using cyclic::cylinder;
using cyclic::kMu;

namespace {

using Loads = std::vector<double>;

struct Run {
  c2d_status status = C2D_OK;
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  std::vector<double> tn, tt;
};

std::vector<double> field(c2d_solver* s, int32_t which) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  REQUIRE(c2d_get_summary(s, &summary) == C2D_OK);
  std::vector<double> out(static_cast<size_t>(summary.pairs));
  REQUIRE(c2d_get(s, which, 0, 1, summary.pairs, out.data(), 1) == C2D_OK);
  return out;
}

using Each = std::function<void(c2d_solver*, const c2d_cycle_state&)>;
struct Called {
  c2d_solver* solver;
  const Each* each;
};
int32_t call(void* context, const c2d_cycle_state* now) {
  const Called& called = *static_cast<const Called*>(context);
  if (*called.each) (*called.each)(called.solver, *now);
  return 0;
}

int64_t reads_left = -1; // until one that fails; < 0: never
decltype(c2d_port::read) whole_read = nullptr;

struct How {
  int32_t mode = C2D_CYCLES_EXACT, limit = 400;
  double tolerance = 0;
};

// From nothing to the last of the loads, then cycles.
Run follow(Machine& machine, const Loads& cycle, double mu, const How& how = {}, const Each& each = {}) {
  c2d_solver* const s = machine.solver;
  c2d_outcome outcome = C2D_NO_PROGRESS;
  REQUIRE(machine.status == C2D_OK);
  if (c2d_get_state(s) == C2D_STATE_MODEL) REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(s, &cycle[cycle.size() - 2], 2, &outcome) == C2D_OK);
  REQUIRE(outcome == C2D_REACHED);
  c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
  request.corners = static_cast<int32_t>(cycle.size()) / 2;
  request.cases = 2;
  request.load = cycle.data();
  request.mode = how.mode;
  request.limit = how.limit;
  request.tolerance = how.tolerance;
  Called called = {s, &each};
  Run run;
  run.status = c2d_cycle(s, &request, call, &called, &run.state);
  reads_left = -1;
  if (run.status == C2D_OK) run.tn = field(s, C2D_TN), run.tt = field(s, C2D_TT);
  return run;
}

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0, largest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    most = std::fmax(most, std::fabs(a[i] - b[i]));
    largest = std::fmax(largest, std::fabs(b[i]));
  }
  return most / largest;
}

// Do the cycles end in the state in which plain cycles end?
void check_alike(const Run& run, const Run& plain, double within = 1e-9) {
  REQUIRE((run.status == C2D_OK && plain.status == C2D_OK));
  CHECK(run.state.result == plain.state.result);
  CHECK(apart(run.tn, plain.tn) < within);
  CHECK(apart(run.tt, plain.tt) < within);
  const double expected = plain.state.dissipated;
  CHECK(std::fabs(run.state.dissipated - expected) <= 2e-6 * expected); // seen: 1.2e-6, of fast ones
}

std::string mesh_of(const std::string& sketch) {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", sketch);
  const test::Result made = test::run_shell("'" + paths::program() + "' mesh '" + (folder / "a.c2s") + "'");
  REQUIRE_MESSAGE(made.status == 0, made.err);
  return made.out;
}

const Loads kPressed = {0.4, 0, 1, 0}, kRound = {1, .06, .5, .06, .5, -.06, 1, -.06, 1, 0};
const How kPlain = {C2D_CYCLES_PLAIN, 2000, 1e-12};
const How kExact = {C2D_CYCLES_EXACT, 400, 1e-12}; // a state is as far from the steady one as a hundred changes or more

} // namespace

TEST_CASE("cycle edges: fast, cycles of slowly changing events") {
  const Model model = cylinder(28);
  Machine machine(model), other(model);
  const Run fast = follow(machine, kPressed, .1, {C2D_CYCLES_FAST});
  check_alike(fast, follow(other, kPressed, .1, kPlain), 1e-3);
  CHECK(fast.state.cycles < 30);
}

TEST_CASE("cycle edges: fast, with 80 elements on the half width of contact") {
  Machine machine(cylinder(80));
  for (const Loads& cycle : {kPressed, kRound}) {
    const Run fast = follow(machine, cycle, kMu, {C2D_CYCLES_FAST, 400, 1e-6});
    CHECK((fast.state.result == C2D_CYCLE_SLIPS && fast.state.cycles <= 20));
    const Run exact = follow(machine, cycle, kMu);
    CHECK((apart(fast.tt, exact.tt) < 1e-4 && apart(fast.tn, exact.tn) < 1e-4));
    CHECK(fast.state.dissipated == doctest::Approx(exact.state.dissipated).epsilon(1e-4).scale(0));
  }
}

TEST_CASE("cycle edges: the increments of 1987 extrapolate nothing") {
  const Model model = cylinder(8);
  Machine one(model, 0, C2D_STEPPING_DECK), two(model, 0, C2D_STEPPING_DECK);
  const Run exact = follow(one, kPressed, kMu, {C2D_CYCLES_EXACT, 12});
  const Run plain = follow(two, kPressed, kMu, {C2D_CYCLES_PLAIN, 12});
  CHECK((exact.state.extrapolations == 0 && exact.state.cycles == plain.state.cycles));
  CHECK((exact.tn == plain.tn && exact.tt == plain.tt));
}

namespace {

// A block that only contact holds, between a table and a punch that a platen moves down and sideways.
const char* const kLoose = R"(
body table E 1000 nu 0.3
  from -2 -2
  line base to 2 -2
  line right to 2 0
  line top to -2 0
  line left to -2 -2
body block E 1000 nu 0.3
  from -1 0
  line under to 1 0
  line east to 1 1
  line over to -1 1
  line west to -1 0
body punch E 1000 nu 0.3
  from -0.5 1.01
  line tip to 0.5 1.01
  line pe to 0.5 2
  line grip to -0.5 2
  line pw to -0.5 1.01
contact table.top block.under mu 0.3
contact block.over punch.tip mu 0.3
fix table.base
case down
  platen punch.grip x 0 y -0.02 turn 0
case push
  platen punch.grip x 0.003 y 0 turn 0
history down 1; push 0.1; down 0; down 1
tolerance off
elements block.under 12
elements punch.tip 8
)";

} // namespace

TEST_CASE("cycle edges: nothing touches, in the whole cycle or at its end") {
  Machine machine(mesh_of(kLoose), 8);
  const Run above = follow(machine, {0, .5, .2, 0}, 0.3);
  REQUIRE(above.status == C2D_OK);
  CHECK((above.state.result == C2D_CYCLE_SHAKES_DOWN && above.state.cycles == 1 && above.state.slipped == 0));
  CHECK((above.state.dissipated == 0 && above.state.slip_range == 0));
  const Run lifted = follow(machine, {1, 0, 1, .5, 0, 0}, 0.3, {C2D_CYCLES_EXACT, 6, 1e-300});
  REQUIRE(lifted.status == C2D_OK);
  CHECK((lifted.state.cycles == 6 && lifted.state.extrapolations == 0));
}

TEST_CASE("cycle edges: a gap that follows slip past changes of curvature") {
  std::string pads = test::slip_pads() + "history normal 1; shift 1\ntolerance 5 %\n";
  pads.replace(pads.find("body pad E E"), 12, "body pad E {100*E}");
  const std::string deck = mesh_of(pads);
  Machine machine(deck, 20), other(deck, 20);
  const Loads cycle = {1, .2, .5, 0, 1, -.1, 1, 0};
  const Run plain = follow(other, cycle, 0.3, kPlain);
  for (const int32_t mode : {C2D_CYCLES_EXACT, C2D_CYCLES_FAST}) {
    const Run run = follow(machine, cycle, 0.3, {mode});
    CHECK((run.state.extrapolations > 0 && run.state.cycles < plain.state.cycles));
    check_alike(run, plain);
  }
}

TEST_CASE("cycle edges: few and many directions, exact and fast, and a tolerance that round-off never meets") {
  for (const int n : {6, 13})
    for (const double mu : {.3, .6})
      for (const Loads& cycle : {kPressed, kRound, Loads{.05, .01, 1, 0}}) {
        Model model = cylinder(n);
        Machine other(model);
        const Run plain = follow(other, cycle, mu, kPlain);
        for (const int32_t states : {1, 30}) {
          model.cycle_states = states;
          Machine machine(model);
          check_alike(follow(machine, cycle, mu, kExact), plain, 1e-8);
          check_alike(follow(machine, cycle, mu, {C2D_CYCLES_FAST}), plain, 1e-3);
          const Run never = follow(machine, cycle, mu, {C2D_CYCLES_EXACT, 60, 1e-300});
          REQUIRE(never.status == C2D_OK);
          CHECK((never.state.change < 1e-10 && apart(never.tt, plain.tt) < 1e-8));
        }
      }
}

namespace {

// At the end of cycle `at`, if directions are kept then.
Each forged(const std::function<void(c2d_solver*, c2d::CycleRecord&)>& change, int* times, int most = 1) {
  return [=](c2d_solver* s, const c2d_cycle_state&) {
    c2d::CycleRecord record = c2d::cycle_record(s);
    if (record.head->directions == 0 || *times >= most) return;
    ++*times;
    change(s, record);
  };
}

// Directions that lead far away.
void lead_astray(c2d_solver* s, c2d::CycleRecord& record) {
  const int64_t pairs = s->model.path_pairs;
  for (int64_t i = 2 * pairs; i < 6 * pairs; ++i) record.direction[i] *= -1e4; // of the first: its memory
}

} // namespace

TEST_CASE("cycle edges: a state that violates the conditions is dropped, and cycles go on from the last one followed") {
  const Model model = cylinder(13);
  Machine other(model);
  const Run plain = follow(other, kPressed, kMu, kPlain);
  for (const bool keeps_energy : {true, false}) {
    Machine machine(model);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    machine.solver->keeps_energy = keeps_energy ? 1 : 0;
    int times = 0;
    const Run run = follow(machine, kPressed, kMu, {}, forged(lead_astray, &times, 3));
    CHECK(times == 3);
    REQUIRE(run.status == C2D_OK);
    CHECK((apart(run.tn, plain.tn) < 1e-9 && apart(run.tt, plain.tt) < 1e-9));
    const double expected = keeps_energy ? plain.state.dissipated : 0;
    CHECK(std::fabs(run.state.dissipated - expected) <= 1e-6 * expected);
  }
}

namespace {

// After an extrapolation: the next cycle is another one than the state belongs to.
Each strayed(const std::function<void(c2d_solver*, c2d::CycleRecord&)>& change, int* times) {
  return [=](c2d_solver* s, const c2d_cycle_state&) {
    c2d::CycleRecord record = c2d::cycle_record(s);
    if (record.head->extrapolated == 0 || *times > 0) return;
    ++*times;
    record.head->sequence = ~record.head->sequence;
    change(s, record);
  };
}

} // namespace

TEST_CASE("cycle edges: the last state followed has no tableau, or contradicts the equations: the path ends") {
  int times = 0;
  Machine open(cylinder(13));
  const Run loose = follow(open, kPressed, kMu, {},
                           strayed(
                               [](c2d_solver* s, c2d::CycleRecord& record) {
                                 for (int32_t i = 0; i < s->model.path_pairs; ++i) record.pair[i].end_status = C2D_OPEN;
                               },
                               &times));
  CHECK(times == 1);
  CHECK((loose.status == C2D_OK && loose.state.result == C2D_CYCLE_STOPPED));
  CHECK(loose.state.outcome == C2D_BEYOND_LIMITS);
  times = 0;
  Machine wrong(cylinder(13));
  const Run bad = follow(wrong, kPressed, kMu, {},
                         strayed(
                             [](c2d_solver* s, c2d::CycleRecord& record) {
                               for (int32_t i = 0; i < s->model.path_pairs; ++i) record.pair[i].end.offset += 10 * (i % 3 - 1);
                             },
                             &times));
  CHECK(times == 1);
  CHECK((bad.status == C2D_OK && bad.state.result == C2D_CYCLE_STOPPED));
  times = 0;
  Machine right(cylinder(13)), other(cylinder(13));
  const Run plain = follow(other, kPressed, kMu, kPlain);
  check_alike(follow(right, kPressed, kMu, {}, strayed([](c2d_solver*, c2d::CycleRecord&) {}, &times)), plain);
  CHECK(times == 1);
}

TEST_CASE("cycle edges: a read that fails while an extrapolated state is judged, or the last one is taken up again") {
  Model model = cylinder(7, true);
  model.body(2).youngs_modulus *= 50;
  model.touching = 24; // columns on demand, so that a tableau is built from the store
  for (int64_t after = 0;; after += 5) {
    Machine machine(model);
    c2d_solver* const s = machine.solver;
    REQUIRE(c2d_prepare(s) == C2D_OK);
    whole_read = s->port.read;
    s->port.read = [](void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
      return reads_left-- == 0 ? 5 : whole_read(context, tape, block, data, bytes);
    };
    int times = 0;
    const Run run = follow(machine, kPressed, kMu, {}, [&](c2d_solver* solver, const c2d_cycle_state& now) {
      if (now.cycles == 1) reads_left = after;
      forged(lead_astray, &times, 2)(solver, now);
    });
    if (run.status == C2D_OK) break;
    CHECK(run.status == C2D_ERR_STORE_READ);
    CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);
  }
}

TEST_CASE("cycle edges: a read that fails in the callback, which goes on all the same") {
  Machine machine(cylinder(6));
  c2d_solver* const s = machine.solver;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  whole_read = s->port.read;
  s->port.read = [](void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
    return reads_left-- == 0 ? 5 : whole_read(context, tape, block, data, bytes);
  };
  const Run run = follow(machine, kPressed, kMu, {}, [](c2d_solver* solver, const c2d_cycle_state& now) {
    double tn = 0;
    if (now.cycles == 2) reads_left = 0;
    (void)c2d_get(solver, C2D_END_UX, 1, 1, 1, &tn, 1);
  });
  CHECK((run.status == C2D_ERR_STORE_READ && c2d_get_state(s) == C2D_STATE_BROKEN));
}

TEST_CASE("cycle edges: half of a model behind a line of symmetry, where a pair has no tangential direction") {
  const auto part = [](bool half) {
    Model m;
    m.cases = 2, m.friction = kMu, m.cycle_states = 30;
    const double left = half ? 0 : -2;
    const int32_t n = half ? 1 : 2;
    const auto shape = half ? open_polygon : polygon;
    const Body block = shape({{left, -2, 4 * n}, {2, -2, 4}, {2, 0, 10 * n}, {left, 0, 4}}, 1, 2.0 / 7);
    Body punch = shape({{left, 0, 10 * n}, {2, 0, 4}, {2, 2, 4 * n}, {left, 2, 4}}, 50, 2.0 / 7);
    for (size_t i = 0; i < punch.xy.size(); i += 2)
      if (punch.xy[i + 1] == 0) punch.xy[i + 1] = punch.xy[i] * punch.xy[i] / 100;
    const int32_t lower = m.add(block), upper = m.add(punch);
    m.join(C2D_ZONE_MATCHING, lower, 3, upper, 1);
    m.set(lower, 1, end_of(kHeld));
    m.set(upper, 3, [](double, double) { return end_of("1100", 0, 0, 0, -0.02); });
    m.set_second(upper, 3, end_of("1100", 0, 0, 0, -0.01));
    if (half) m.symmetry = 1;
    return m;
  };
  Machine whole(part(false)), half(part(true));
  const Loads cycle = {0.4, 0, 1, 0};
  const Run all = follow(whole, cycle, .1, {C2D_CYCLES_EXACT, 100}), one = follow(half, cycle, .1, {C2D_CYCLES_EXACT, 100});
  REQUIRE((all.status == C2D_OK && one.status == C2D_OK));
  CHECK((one.state.result == C2D_CYCLE_SLIPS && all.state.result == C2D_CYCLE_SLIPS));
  CHECK(2 * one.state.dissipated == doctest::Approx(all.state.dissipated).epsilon(1e-6).scale(0));
}

TEST_CASE("cycle edges: a smooth body that contact leaves free sideways") {
  Machine machine(mesh_of(kLoose), 8);
  const Run run = follow(machine, {0.6, 0, 1, 0}, 0);
  REQUIRE(run.status == C2D_OK);
  CHECK((run.state.extrapolations == 0 && run.state.result == C2D_CYCLE_SLIPS));
  CHECK(std::fabs(run.state.dissipated) < 1e-15);
}

TEST_CASE("cycle edges: zones, one of which nothing touches; results in states without any") {
  Machine machine(mesh_of(kLoose), 8);
  c2d_solver* const s = machine.solver;
  c2d_cycle_zone zone = C2D_INIT(c2d_cycle_zone);
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  double number = 0;
  CHECK(c2d_get_cycle(s, C2D_CYCLE_WALK, 1, 1, &number, 1) == C2D_ERR_STATE);
  CHECK(c2d_get_cycle_zone(s, 1, &zone) == C2D_ERR_STATE);
  CHECK(c2d_get_cycle_state(s, &state) == C2D_ERR_STATE);
  const Run above = follow(machine, {0, .5, .2, 0}, 0.3);
  REQUIRE(above.status == C2D_OK);
  REQUIRE(c2d_get_cycle_zone(s, 1, &zone) == C2D_OK);
  CHECK((zone.touched > 0 && zone.slipped == 0 && zone.walk == 0));
  REQUIRE(c2d_get_cycle_zone(s, 2, &zone) == C2D_OK);
  CHECK((zone.touched == 0 && zone.walk == 0));
}

TEST_CASE("cycle edges: a tolerance out of range; what a restored state says of directions is checked") {
  Machine machine(cylinder(6));
  CHECK(follow(machine, kPressed, kMu, {C2D_CYCLES_EXACT, 5, 2}).status == C2D_ERR_ARGUMENT);
  CHECK(follow(machine, kPressed, kMu, {C2D_CYCLES_EXACT, 5, std::nan("")}).status == C2D_ERR_ARGUMENT);
  c2d_solver* const s = machine.solver;
  const Run whole = follow(machine, kPressed, kMu);
  for (const int32_t directions : {-1, 31}) {
    REQUIRE(follow(machine, kPressed, kMu, {}, [](c2d_solver* solver, const c2d_cycle_state& now) {
              if (now.cycles == 3) REQUIRE(c2d_save(solver) == C2D_OK);
            }).status == C2D_OK);
    REQUIRE(c2d_restore(s) == C2D_OK);
    c2d::cycle_record(s).head->directions = directions;
    c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
    request.corners = request.cases = 2, request.load = kPressed.data(), request.limit = 400;
    c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
    REQUIRE(c2d_cycle(s, &request, nullptr, nullptr, &state) == C2D_OK);
    CHECK((state.result == C2D_CYCLE_SLIPS && apart(field(s, C2D_TT), whole.tt) < 1e-9)); // begun anew
  }
}

TEST_CASE("cycle edges: a path that begins without friction, and none of it or friction without bound after that") {
  for (const double mu : {0.0, static_cast<double>(HUGE_VAL)}) {
    Model model = cylinder(6);
    model.friction = mu;
    model.paths = {{1, 1.0, 0}, {1, 0.4, 0}, {1, 1.0, 0}};
    model.repeated = 2;
    Machine loaded(model);
    model.cycle_start = C2D_START_WITHOUT_FRICTION;
    Machine smooth(model);
    std::vector<double> tn[2], tt[2];
    for (Machine* machine : {&loaded, &smooth}) {
      REQUIRE(machine->status == C2D_OK);
      REQUIRE(c2d_prepare(machine->solver) == C2D_OK);
      REQUIRE(c2d_run(machine->solver, nullptr, nullptr) == C2D_OK);
      c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
      REQUIRE(c2d_get_cycle_state(machine->solver, &state) == C2D_OK);
      CHECK((state.outcome == C2D_REACHED && state.cycles <= 3 && std::fabs(state.dissipated) < 1e-15));
      const int k = machine == &smooth ? 1 : 0;
      tn[k] = field(machine->solver, C2D_TN), tt[k] = field(machine->solver, C2D_TT);
    }
    CHECK(apart(tn[1], tn[0]) < 1e-12); // friction without bound holds from the beginning
    if (mu > 0) CHECK(apart(tt[1], tt[0]) < 1e-12);
  }
}

TEST_CASE("cycle edges: paths with a cycle whose callback or store fails") {
  Model model = cylinder(6);
  model.paths = {{1, 1.0, 0}, {1, 0.4, 0}, {1, 1.0, 0}};
  model.repeated = 2;
  Machine called(model);
  REQUIRE(c2d_prepare(called.solver) == C2D_OK);
  CHECK(c2d_run(
            called.solver, [](void*, const c2d_step* now) { return now->kind == C2D_STEP_CYCLE ? 3 : 0; }, nullptr) ==
        C2D_ERR_CALLBACK);
  Machine machine(model);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  whole_read = machine.solver->port.read;
  machine.solver->port.read = [](void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
    return reads_left-- == 0 ? 5 : whole_read(context, tape, block, data, bytes);
  };
  const c2d_status status = c2d_run(
      machine.solver,
      [](void*, const c2d_step* now) {
        if (now->kind == C2D_STEP_CYCLE) reads_left = 0;
        return 0;
      },
      nullptr);
  reads_left = -1;
  CHECK((status == C2D_ERR_STORE_READ && c2d_get_state(machine.solver) == C2D_STATE_BROKEN));
}

TEST_CASE("cycle edges: calls that make a cycle of a path, without room, twice, or before there is any") {
  Model model = cylinder(4);
  model.paths = {{1, 1.0, 0}, {1, 0.4, 0}, {1, 1.0, 0}};
  model.repeated = 2, model.cycle_states = 0;
  CHECK(Machine(model).status == C2D_ERR_LIMIT);
  model.cycle_states = 4;
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = limits_of(model, list);
  uint64_t bytes = 0;
  REQUIRE(c2d_memory_need(&limits, &bytes, nullptr, nullptr) == C2D_OK);
  std::vector<double> room(bytes / sizeof(double) + 64);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, room.data(), room.size() * sizeof(double), &limits, nullptr, nullptr) == C2D_OK);
  int32_t first = 0, pieces = 0, limit = 0, digits = 0, start = 0;
  CHECK(c2d_get_repeated(s, &first, &pieces, &limit, &digits, &start) == C2D_ERR_STATE);
  c2d_problem problem = C2D_INIT(c2d_problem);
  REQUIRE(c2d_set_problem(s, &problem) == C2D_OK);
  for (const double load : {1.0, 0.4, 1.0}) {
    const double factors[2] = {load, 0};
    REQUIRE(c2d_add_path(s, 1, factors, 2) == C2D_OK);
  }
  REQUIRE(c2d_repeat_paths(s, 2, 0, 0, 0) == C2D_OK);
  CHECK(c2d_repeat_paths(s, 2, 0, 0, 0) == C2D_ERR_ARGUMENT);
  c2d_close(s);
}

TEST_CASE("cycle edges: a cycle of a path with overlaps that are closed first and stay closed") {
  Model model = cylinder(6);
  for (size_t i = 1; i < model.body(2).xy.size(); i += 2) model.body(2).xy[i] -= 1e-3;
  model.interference = 2;
  model.platens[0].second_load[0] = 0;
  model.paths = {{1, 1.0, 0}, {1, 0.4, 0}, {1, 1.0, 0}};
  model.repeated = 2;
  Machine machine(model);
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(c2d_run(machine.solver, nullptr, nullptr) == C2D_OK);
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  REQUIRE(c2d_get_cycle_state(machine.solver, &state) == C2D_OK);
  CHECK((state.result == C2D_CYCLE_SLIPS && state.outcome == C2D_REACHED));
  const std::vector<double> tn = field(machine.solver, C2D_TN), tt = field(machine.solver, C2D_TT);
  Machine other(model);
  const double mu = kMu, closed[] = {0, 1}, loaded[] = {1, 1}, cycle[] = {0.4, 1, 1, 1};
  c2d_outcome outcome = C2D_NO_PROGRESS;
  c2d_solver* const s = other.solver;
  REQUIRE((c2d_prepare(s) == C2D_OK && c2d_begin(s, &mu, 1) == C2D_OK));
  REQUIRE((c2d_advance(s, closed, 2, &outcome) == C2D_OK && c2d_advance(s, loaded, 2, &outcome) == C2D_OK));
  c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
  request.corners = request.cases = 2, request.load = cycle;
  REQUIRE(c2d_cycle(s, &request, nullptr, nullptr, &state) == C2D_OK);
  CHECK((apart(field(s, C2D_TN), tn) < 1e-9 && apart(field(s, C2D_TT), tt) < 1e-9));
}
