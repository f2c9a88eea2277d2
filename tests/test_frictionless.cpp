// The contact system without friction (METHOD 10.10) against that with every pair sticking, which the same model has as soon as
// one of its coefficients is not zero.
#include "contact/basis.hpp"
#include "contact/reduction/body_compliance.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "contact/reduction/rigid_balance.hpp"
#include "effort.hpp"
#include "family_runs.hpp"
#include "many_bodies.hpp"
#include "reduction_by_hand.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace runs;

namespace {

constexpr double kEpsilon = static_cast<double>(std::numeric_limits<c2d::Real>::epsilon());
constexpr double kAlike = sizeof(c2d::Real) == 8 ? 1e-9 : 1e-2;

// A family's deck with these coefficients of friction.
Deck deck_of(const std::string& name, const std::vector<std::string>& settings, const std::string& friction) {
  std::string text, error;
  REQUIRE(families::make_deck(name, settings, text, error));
  Deck deck;
  std::istringstream in(text);
  bool next = false;
  for (std::string line; std::getline(in, line); next = line == "! coefficients of friction")
    deck.lines.push_back(next ? friction : line);
  return deck;
}

struct Solver {
  RamStore own, &store;
  c2d_port port = C2D_INIT(c2d_port);
  Deck deck;
  std::unique_ptr<Machine> machine;
  c2d_solver* s = nullptr;

  explicit Solver(const Deck& d, bool least = false, RamStore* other = nullptr) : store(other ? *other : own), deck(d) {
    store.serve(port);
    const host::Limits limits = deck.limits();
    uint64_t minimum = 0, in_core = 0;
    REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
    machine = std::make_unique<Machine>(limits, least ? minimum : in_core, &port);
    REQUIRE(machine->created == C2D_OK);
    s = machine->solver;
    c2d_options options = C2D_INIT(c2d_options);
    options.keep_factors = 1;
    REQUIRE(c2d_set_options(s, &options) == C2D_OK);
    REQUIRE(read_deck(s, deck) == C2D_OK);
  }
  Solver& prepared() {
    REQUIRE(c2d_prepare(s) == C2D_OK);
    return *this;
  }
  void begin(double mu) { REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK); }
  void advance(double load) {
    const std::vector<double> loads(static_cast<size_t>(summary_of(s).load_cases), load);
    c2d_outcome outcome = C2D_UNDECIDED;
    REQUIRE(c2d_advance(s, loads.data(), static_cast<int32_t>(loads.size()), &outcome) == C2D_OK);
    CHECK(outcome == C2D_REACHED);
  }
  // Pairs and boundary as they stand.
  Numbers now() {
    Numbers out;
    const size_t pairs = static_cast<size_t>(summary_of(s).pairs);
    out.steps.resize(pairs * C2D_PAIR_FIELDS);
    for (int32_t f = 0; f < C2D_PAIR_FIELDS; ++f)
      REQUIRE(c2d_get(s, f, 1, 1, static_cast<int32_t>(pairs), out.steps.data() + static_cast<size_t>(f) * pairs, 1) == C2D_OK);
    REQUIRE(get_boundary(s, out) == C2D_OK);
    return out;
  }
  Numbers follow(double mu) {
    begin(mu);
    advance(0.4);
    advance(1);
    return now();
  }
};

// The largest difference of these fields of the pairs, over the largest number in any of them.
double difference(const Numbers& a, const Numbers& b, std::initializer_list<int32_t> fields) {
  REQUIRE(a.steps.size() == b.steps.size());
  const size_t pairs = a.steps.size() / C2D_PAIR_FIELDS;
  double most = 0, size = 0;
  for (const int32_t f : fields)
    for (size_t i = static_cast<size_t>(f) * pairs; i < static_cast<size_t>(f + 1) * pairs; ++i) {
      most = std::max(most, std::fabs(a.steps[i] - b.steps[i]));
      size = std::max(size, std::fabs(b.steps[i]));
    }
  return most / size;
}
// The same of the boundary: all kinds of numbers, by the largest of the kind.
double boundary_difference(const Numbers& a, const Numbers& b) {
  REQUIRE(a.boundary.size() == b.boundary.size());
  double most = 0, size = 0;
  for (size_t i = 0; i < a.boundary.size(); ++i) {
    most = std::max(most, std::fabs(a.boundary[i] - b.boundary[i]));
    size = std::max(size, std::fabs(b.boundary[i]));
  }
  return most / size;
}

struct Alike {
  const char* name;
  std::vector<std::string> settings;
  bool sliding;
};
void check_alike(const Alike& model) {
  CAPTURE(std::string(model.name));
  CAPTURE(model.settings.front());
  Solver without(deck_of(model.name, model.settings, "1 0")), with(deck_of(model.name, model.settings, "2 0 0.3"));
  with.prepared();
  without.prepared();
  REQUIRE(summary_of(with.s).contact_unknowns >= 160);
  CHECK(with.s->sliding == 0);
  CHECK((without.s->sliding != 0) == model.sliding);
  const Numbers a = without.follow(0), b = with.follow(0);
  CHECK(a.outcome == C2D_REACHED);
  CHECK(difference(a, b, {C2D_STATUS}) == 0);
  CHECK(difference(a, b, {C2D_TN, C2D_TT}) < kAlike); // 2e-10 where a layer floats, else 7e-12
  CHECK(difference(a, b, {C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2, C2D_SLIP_SUM}) < kAlike);
  CHECK(boundary_difference(a, b) < kAlike);
}

} // namespace

TEST_CASE("frictionless: the same numbers as with pairs that could rub") {
  const Alike models[] = {
      {"hertz", {"n=70"}, true},                                   // a free body
      {"hertz", {"n=70", "order=2", "symmetry=line"}, true},       // and pairs without a tangent
      {"layer_lifted", {"n=12"}, true},                            // pairs that lift
      {"receding_layer", {"n=20"}, true},                          //
      {"disc_in_hole", {"n=100"}, true},                           // all round
      {"coating", {"n=24"}, true},                                 // a tie
      {"coating", {"n=24", "bond=free"}, true},                    //
      {"shrink", {"n=40"}, true},                                  // an overlap that is closed, and a tie
      {"crack_edge", {"order=3", "bending=1", "tension=0"}, true}, //
  };
  for (const Alike& model : models) check_alike(model);
}

TEST_CASE("frictionless: of several bodies that move, too, the same numbers as with pairs that could rub") {
  const Alike models[] = {
      {"rollers", {"n=24"}, true},                            // most of them free
      {"bearing", {"n=6"}, true},                             // rigid rings
      {"stack", {"n=100", "plates=2", "q=0", "mu=0"}, false}, // slides freely,
      {"stack", {"n=60", "q=0", "mu=0"}, false},              // on another that does
  };
  for (const Alike& model : models) check_alike(model);
}

TEST_CASE("frictionless: bodies that are unloaded, and pressed again") {
  for (const char* name : {"hertz", "rollers", "bearing", "receding_layer"}) {
    CAPTURE(std::string(name));
    if (!test::in_full() && name[0] != 'h' && name[0] != 'b') continue;
    const std::vector<std::string> settings = {std::string(name) == "hertz" ? "n=70" : "n=20"};
    Solver without(deck_of(name, settings, "1 0")), with(deck_of(name, settings, "2 0 0.3"));
    for (Solver* solver : {&without, &with}) solver->prepared().begin(0);
    CHECK(without.s->sliding != 0);
    for (const double load : {1.0, 0.0, 0.6, 0.0, 1.0}) {
      CAPTURE(load);
      for (Solver* solver : {&without, &with}) solver->advance(load);
      if (load > 0) CHECK(difference(without.now(), with.now(), {C2D_TN, C2D_TT}) < kAlike);
      if (load > 0) CHECK(boundary_difference(without.now(), with.now()) < kAlike);
    }
    CHECK(summary_of(without.s).max_residual < 1e3 * kEpsilon);
  }
}

TEST_CASE("frictionless: a block that may slide to a wall rests where it is, and what pushes it ends the path") {
  using namespace many;
  const auto pressed = [](double mu_of_wall) {
    Model m;
    m.add(rectangle(0, -2, 2, 0, {10, 10, 60, 10})); // floor
    m.add(rectangle(2.01, 0, 3, 1, {5, 8, 5, 30}));  // wall
    m.add(rectangle(0, 0, 2, 1, {60, 30, 20, 10}));  // block
    m.join(C2D_ZONE_MATCHING, 1, 3, 3, 1);
    m.join(C2D_ZONE_MATCHING, 2, 4, 3, 2);
    m.zones.back().mu = mu_of_wall;
    m.zones.back().without[1] = 1; // the corner is on the floor
    m.set(1, 1, end_of(kHeld));
    m.set(2, 2, end_of(kHeld));
    m.set(3, 3, end_of(kPulled, 0, -1));
    m.set_second(3, 4, end_of(kPulled, 0.01, 0));
    m.cases = 2;
    m.paths = {{1, 1.0, 0.0}, {1, 1.0, 1.0}};
    return m;
  };
  many::Machine sliding(pressed(-1)), sticking(pressed(0.3));
  const Result a = sliding.run(), b = sticking.run();
  REQUIRE_MESSAGE(a.status == C2D_OK, a.messages());
  REQUIRE(a.summary.contact_unknowns >= 160);
  CHECK(sliding.solver->sliding != 0);
  CHECK(sticking.solver->sliding == 0);
  CHECK(a.outcome == C2D_FREE_MOTION);
  CHECK(b.outcome == C2D_FREE_MOTION);
  REQUIRE(a.steps.size() == 2);
  REQUIRE(b.steps.size() == 2);
  for (size_t step = 0; step < 2; ++step)
    for (const size_t field : {C2D_TN, C2D_GAP, C2D_UT2, C2D_UN2}) {
      double most = 0, size = 0;
      for (size_t i = 0; i < a.steps[step].rows.size(); ++i) {
        const double x = a.steps[step].rows[i][field], y = b.steps[step].rows[i][field];
        most = std::max(most, std::fabs(x - y));
        size = std::max(size, std::fabs(y));
      }
      CHECK(most < kAlike * size);
    }
}

TEST_CASE("frictionless: friction that is told after the preparation") {
  for (const char* name : {"hertz", "rollers"}) {
    CAPTURE(std::string(name));
    const std::vector<std::string> settings = {std::string(name) == "hertz" ? "n=70" : "n=12"};
    Solver with(deck_of(name, settings, "2 0 0.3")), without(deck_of(name, settings, "1 0"));
    with.prepared();
    without.prepared();
    const Numbers rubbing = with.follow(0.3), smooth = without.follow(0);
    CHECK(without.s->sliding != 0);
    without.begin(0); // that it is told again is nothing new
    CHECK(without.s->sliding != 0);
    REQUIRE(c2d_cancel(without.s) == C2D_OK);
    without.begin(0.3); // nothing stops that, and no cancel is lost
    CHECK(without.s->sliding == 0);
    const std::vector<double> loads(static_cast<size_t>(summary_of(without.s).load_cases), 1);
    c2d_outcome outcome = C2D_REACHED;
    CHECK(c2d_advance(without.s, loads.data(), static_cast<int32_t>(loads.size()), &outcome) == C2D_ERR_CANCELLED);
    CHECK(without.follow(0.3) == rubbing);
    CHECK(without.follow(0) == with.follow(0));
    CHECK(difference(without.now(), smooth, {C2D_TN, C2D_TT}) < kAlike);
    CHECK(difference(smooth, rubbing, {C2D_TT}) > 1e-3);
  }
}

TEST_CASE("frictionless: friction that is told later where no energies are kept") {
  const Deck deck = deck_of("hertz", {"n=70"}, "1 0");
  Solver with(deck), without(deck);
  with.prepared(), without.prepared();
  without.s->keeps_energy = 0;
  CHECK(without.follow(0.3) == with.follow(0.3));
  CHECK(without.s->sliding == 0);
}

// What mean motions are found from lies with the path, and goes with it.
TEST_CASE("frictionless: bodies approach alike in each of several paths, with friction given before or after the preparation") {
  const auto state_of = [](Solver& solver) {
    c2d_zone_state state = C2D_INIT(c2d_zone_state);
    REQUIRE(c2d_get_zone_state(solver.s, 1, &state) == C2D_OK);
    return state;
  };
  Solver with(deck_of("hertz", {"n=70"}, "2 0 0.3")), without(deck_of("hertz", {"n=70"}, "1 0"));
  with.prepared().follow(0.3);
  without.prepared().follow(0);
  const c2d_zone_state smooth = state_of(without);
  without.follow(0.3);
  const c2d_zone_state rubbing = state_of(without), expected = state_of(with);
  CHECK(rubbing.approach == doctest::Approx(expected.approach).epsilon(kAlike));
  CHECK(rubbing.shift == doctest::Approx(expected.shift).epsilon(kAlike));
  without.follow(0);
  CHECK(state_of(without).approach == doctest::Approx(smooth.approach).epsilon(kAlike));
}

TEST_CASE("frictionless: saved states go with either form of the tape") {
  const Deck deck = deck_of("hertz", {"n=70"}, "1 0");
  Solver plain(deck);
  const Numbers smooth = plain.prepared().follow(0), rubbing = plain.follow(0.3);
  Solver solver(deck);
  solver.prepared().begin(0);
  solver.advance(0.4);
  REQUIRE(c2d_save(solver.s) == C2D_OK);
  solver.follow(0.3);
  REQUIRE(c2d_restore(solver.s) == C2D_OK); // the form of the state is back, and every bit
  CHECK(solver.s->sliding != 0);
  solver.advance(1);
  CHECK(solver.now() == smooth);
  solver.begin(0.3);
  solver.advance(0.4);
  REQUIRE(c2d_save(solver.s) == C2D_OK);
  solver.follow(0);
  REQUIRE(c2d_restore(solver.s) == C2D_OK);
  CHECK(solver.s->sliding == 0);
  solver.advance(1);
  CHECK(solver.now() == rubbing);
}

TEST_CASE("frictionless: a prepared state serves a run with friction") {
  Solver first(deck_of("hertz", {"n=70"}, "1 0"));
  first.prepared();
  REQUIRE(c2d_save(first.s) == C2D_OK);
  Solver second(deck_of("hertz", {"n=70"}, "1 0.3"), false, &first.store), alone(deck_of("hertz", {"n=70"}, "1 0.3"));
  REQUIRE(c2d_restore(second.s) == C2D_OK);
  CHECK(second.s->sliding != 0);
  Numbers a, b;
  REQUIRE(run_prepared(second.s, a) == C2D_OK);
  REQUIRE(run_prepared(alone.prepared().s, b) == C2D_OK);
  CHECK(a == b);
}

TEST_CASE("frictionless: a store that fails while the contact system changes its form") {
  const Deck deck = deck_of("hertz", {"n=64"}, "1 0");
  Numbers smooth, rubbing;
  size_t all = 0; // operations that the change takes
  {
    Solver solver(deck);
    smooth = solver.prepared().follow(0);
    const size_t before = solver.store.done.size();
    solver.begin(0.3);
    all = solver.store.done.size() - before;
    rubbing = solver.follow(0.3);
  }
  Solver solver(deck);
  solver.prepared().begin(0);
  solver.advance(0.4);
  REQUIRE(c2d_save(solver.s) == C2D_OK);
  for (const double part : {0.0, 0.001, 0.3, 0.6, 0.8, 0.9, 0.95, 0.99}) {
    CAPTURE(part);
    const size_t at = solver.store.done.size() + static_cast<size_t>(part * static_cast<double>(all));
    solver.store.before = [=](const RamStore::Operation&, size_t i) { return i >= at ? 7 : 0; };
    const double mu = 0.3;
    const c2d_status status = c2d_begin(solver.s, &mu, 1);
    CHECK((status == C2D_ERR_STORE_READ || status == C2D_ERR_STORE_WRITE));
    CHECK(c2d_get_state(solver.s) == C2D_STATE_BROKEN);
    solver.store.before = nullptr;
    REQUIRE(c2d_restore(solver.s) == C2D_OK);
    solver.advance(1);
    CHECK(solver.now() == smooth);
  }
  // And as a state brings its form back.
  REQUIRE(c2d_restore(solver.s) == C2D_OK);
  size_t taken = 0;
  for (const double part : {1.0, 0.2, 0.5, 0.8, 0.95}) {
    CAPTURE(part);
    CHECK(solver.follow(0.3) == rubbing);
    const size_t before = solver.store.done.size(), at = before + static_cast<size_t>(part * static_cast<double>(taken));
    if (part < 1) solver.store.before = [=](const RamStore::Operation&, size_t i) { return i >= at ? 7 : 0; };
    CHECK((c2d_restore(solver.s) == C2D_OK) == (part == 1));
    solver.store.before = nullptr;
    taken = std::max(taken, solver.store.done.size() - before);
    REQUIRE(c2d_restore(solver.s) == C2D_OK);
    solver.advance(1);
    CHECK(solver.now() == smooth);
  }
  CHECK(solver.follow(0.3) == rubbing);
}

TEST_CASE("frictionless: new loads, the least memory") {
  const Deck deck = deck_of("coating", {"n=24"}, "1 0");
  Solver plain(deck), least(deck, true);
  const Numbers smooth = plain.prepared().follow(0);
  const Numbers narrow = least.prepared().follow(0);
  CHECK(least.s->sliding != 0);
  CHECK(difference(narrow, smooth, {C2D_TN, C2D_UN1, C2D_UT1}) < kAlike);
  CHECK(least.machine->guards_are_whole());
  REQUIRE(c2d_change_loads(plain.s) == C2D_OK);
  plain.prepared();
  CHECK(plain.s->sliding != 0);
  const Numbers again = plain.follow(0);
  CHECK(difference(again, smooth, {C2D_TN}) < kAlike);
  CHECK(boundary_difference(again, smooth) < kAlike);
  const Numbers late = plain.follow(0.3);
  REQUIRE(c2d_change_loads(plain.s) == C2D_OK);
  plain.prepared();
  CHECK(plain.s->sliding == 0);
  CHECK(difference(plain.follow(0.3), late, {C2D_TN, C2D_TT}) < kAlike);
}

// ---- the reduction, called by hand -----------------------------------------------------------------------------------------

TEST_CASE(
    "frictionless: the contact system is the same whatever the engine has, and however long the columns that pass through") {
  for (const bool sliding : {true, false}) {
    Solver solver(deck_of("rollers", {"n=12"}, sliding ? "1 0" : "1 0.3"));
    const std::vector<c2d::Real> whole = ByHand(solver.prepared().s, sliding).tableau();
    double size = 0;
    for (const c2d::Real x : whole) size = std::max(size, std::fabs(static_cast<double>(x)));
    const struct {
      bool kernel, tells;
      int64_t longer;
    } engines[] = {{true, true, 0}, {true, false, 0}, {false, true, 0}, {true, true, 20000}};
    for (const auto& engine : engines) {
      CAPTURE(engine.kernel);
      CAPTURE(engine.longer);
      ByHand hand(solver.s, sliding, engine.longer);
      if (!engine.kernel) hand.r.engine.kernel = nullptr;
      if (!engine.tells) hand.r.engine.used = nullptr;
      REQUIRE(c2d::reduce(hand.r) == C2D_OK);
      CHECK((hand.used > 0) == (engine.kernel && engine.tells));
      const std::vector<c2d::Real> again = hand.tableau();
      double off = 0;
      for (size_t i = 0; i < whole.size(); ++i) off = std::max(off, std::fabs(static_cast<double>(again[i] - whole[i])));
      CHECK(off < kAlike * size);
    }
  }
}

// Q^T T = 0 (METHOD 10.5) to the digits of Q and T: what a stiff body leaves of round-off in the forces under it is taken away.
TEST_CASE("frictionless: no column of the contact system has a resultant of a free body, however stiff that is") {
  many::Model m;
  m.add(many::rectangle(0, -1, 2, 0, {6, 3, 6, 3}, 1));
  m.add(many::rectangle(0, 0, 2, 1, {6, 3, 6, 3}, 1e3));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  many::Machine machine(m);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  ByHand hand(machine.solver, false);
  const std::vector<c2d::Real> t = hand.tableau();
  const int32_t slots = static_cast<int32_t>(hand.m), motions = hand.model.head->motions;
  REQUIRE(motions == 3);
  std::vector<c2d::Real> q(static_cast<size_t>(slots * motions));
  REQUIRE(read_matrix(hand.r.tape, c2d::ContactMatrix::resultants, q.data(), slots) == C2D_OK);
  for (int32_t j = 0; j < slots; ++j) {
    const c2d::Real* column = t.data() + j * slots;
    for (int32_t k = 0; k < motions; ++k)
      CHECK(std::fabs(c2d::product(q.data() + k * slots, column, slots)) <
            2 * kEpsilon * std::sqrt(c2d::product(column, column, slots)));
  }
}

// Of each step the first operations, the last ones, and those beside the last turns from reads to writes or back: there begins
// or ends what the step does for one matrix. (A free body of the coating is solved for.)
TEST_CASE("frictionless: whichever operation of the store fails in a step of the reduction, that is told") {
  const struct {
    const char *name, *setting;
    bool sliding;
  } models[] = {{"rollers", "n=12", true},
                {"coating", "n=24", true},
                {"coating", "n=6", false},
                {"hertz", "n=70", true}, // with every pair open (METHOD 10.11)
                {"mindlin", "n=36", false}};
  for (const auto& model : models) {
    CAPTURE(std::string(model.name));
    CAPTURE(model.sliding);
    Solver solver(deck_of(model.name, {model.setting}, model.sliding ? "1 0" : "1 0.3"));
    ByHand hand(solver.prepared().s, model.sliding);
    std::vector<size_t> begins; // of each step, and the end
    hand.before = [&](int32_t) {
      begins.push_back(solver.store.done.size());
      return c2d_status{C2D_OK};
    };
    REQUIRE(c2d::reduce(hand.r) == C2D_OK);
    const std::vector<RamStore::Operation> done = solver.store.done;
    begins.push_back(done.size());
    hand.before = [](int32_t) { return c2d_status{C2D_OK}; };
    for (size_t step = 0; step + 1 < begins.size(); ++step) {
      CAPTURE(step);
      const size_t first = begins[step], end = begins[step + 1];
      const auto turns_at = [&](size_t n) { return n > first && n < end && done[n - 1].kind != done[n].kind; };
      int turns = 0;
      for (size_t n = end; n-- > first;) {
        turns += turns_at(n + 1);
        const bool beside = turns <= 7 && (turns_at(n + 1) || turns_at(n));
        if (n > first + 1 && n + 2 < end && !beside) continue;
        CAPTURE(n);
        const size_t at = solver.store.done.size() + n - begins[0];
        solver.store.before = [=](const RamStore::Operation&, size_t i) { return i == at ? 7 : 0; };
        const c2d_status status = c2d::reduce(hand.r);
        CHECK(status == (done[n].kind == 'r' ? C2D_ERR_STORE_READ : C2D_ERR_STORE_WRITE));
        solver.store.before = nullptr;
      }
    }
    REQUIRE(c2d::reduce(hand.r) == C2D_OK);
    std::vector<c2d::Real> column(static_cast<size_t>(hand.m));
    c2d::Form form;
    REQUIRE(c2d::read_form(hand.r.tape, column.data(), &form) == C2D_OK);
    CHECK(form.sliding == model.sliding);
    if (!form.sliding) continue;
    solver.store.before = [](const RamStore::Operation&, size_t) { return 7; };
    CHECK(c2d::read_form(hand.r.tape, column.data(), &form) == C2D_ERR_STORE_READ);
  }
}

TEST_CASE("frictionless: bodies whose equations say nothing, and more motions than unknowns, are told as singular") {
  const auto nothing_of = [](ByHand& hand, int b, c2d::BodyMatrix matrix) {
    const int64_t n = hand.model.body[b].contact;
    const std::vector<c2d::Real> nothing(static_cast<size_t>(n * n));
    REQUIRE(write_matrix(hand.r.tape, b, matrix, nothing.data(), n) == C2D_OK);
    hand.step = 0;
    return c2d::reduce(hand.r);
  };
  { // an elastic body with a free motion, between others: no traction does work on it
    Solver solver(deck_of("rollers", {"n=12"}, "1 0.3"));
    ByHand hand(solver.prepared().s, false);
    const int32_t bodies = hand.model.head->bodies;
    c2d::Body& roller = hand.model.body[3];
    REQUIRE(roller.free_motions == 1);
    REQUIRE(reduce(hand.r) == C2D_OK);
    const int32_t contact = roller.contact, all = hand.model.head->contact;
    roller.contact = 0;
    CHECK(c2d::find_compliance(hand.r, 3) == C2D_ERR_SINGULAR);
    roller.contact = contact;
    hand.model.head->contact = hand.model.head->motions - 1;
    CHECK(c2d::join_motions(hand.r) == C2D_ERR_SINGULAR);
    hand.model.head->contact = all;
    CHECK(nothing_of(hand, 3, c2d::BodyMatrix::traction) == C2D_ERR_SINGULAR);
    CHECK(hand.step == bodies + 1); // join_motions
  }
  { // a rigid body on an elastic one that is held: its motions do nothing to that
    many::Model m;
    m.add(many::rectangle(0, -1, 2, 0, {2, 2, 4, 2}));
    m.add(many::rectangle(0, 0, 2, 1, {4, 1, 1, 1}));
    m.set(1, 1, many::end_of(many::kHeld));
    m.body(2).rigid = m.body(2).is_free[0] = m.body(2).is_free[1] = m.body(2).is_free[2] = 1;
    m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    m.friction = 0.3;
    many::Machine machine(m);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    ByHand hand(machine.solver, false);
    REQUIRE(reduce(hand.r) == C2D_OK);
    CHECK(nothing_of(hand, 0, c2d::BodyMatrix::displacement) == C2D_ERR_SINGULAR);
    CHECK(hand.step == 2 + 2); // form_compliance
  }
}

namespace {

// A block on a rigid table whose middle is lower by so much, as (x - 1)^4, and with another load that pushes it along.
many::Model in_a_hollow(double depth, double push, int32_t elements) {
  using namespace many;
  Model m;
  m.add(rectangle(0, -1, 2, 0, {2, 1, elements, 1}));
  m.add(rectangle(0, 0, 2, 1, {elements, 10, 20, 10}));
  for (many::Body& body : m.bodies)
    for (size_t i = 0; i < body.xy.size(); i += 2)
      if (std::fabs(body.xy[i + 1]) < 1e-12) body.xy[i + 1] = depth * std::pow(body.xy[i] - 1, 4);
  m.body(1).rigid = 1;
  m.set(2, 3, end_of(kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  if (push == 0) return m;
  m.set_second(2, 2, end_of(kPulled, -push, 0));
  m.cases = 2;
  m.paths = {{1, 1.0, 0.0}, {1, 1.0, 1.0}};
  return m;
}

} // namespace

TEST_CASE("frictionless: a block that hardly anything keeps from sliding is pressed like one that slides freely") {
  for (const double depth : {0.01, 1e-6}) {
    CAPTURE(depth);
    many::Machine machine(in_a_hollow(depth, 0, 80));
    const many::Result r = machine.run();
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    REQUIRE(r.outcome == C2D_REACHED);
    CHECK((machine.solver->sliding != 0) == (depth > 1e-3));
    for (const many::Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN]) == doctest::Approx(1).epsilon(30 * depth));
  }
}

TEST_CASE(
    "frictionless: a block that is pushed out of a hollow slides, of as few pairs as stick in the contact system or of many") {
  for (const int32_t elements : {40, 80}) {
    CAPTURE(elements);
    many::Machine machine(in_a_hollow(0.01, 0.1, elements));
    const many::Result r = machine.run();
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK((machine.solver->sliding != 0) == (elements == 80));
    CHECK(r.outcome == C2D_GROSS_SLIDING);
    CHECK(r.summary.outcome_body == 2);
  }
}

// Rigid blocks that do not turn, each on one pair: forces are those of the loads alone.
TEST_CASE("frictionless: of as many motions as unknowns all columns are zero, and that is not the form of pairs that slide") {
  using namespace many;
  for (const int32_t blocks : {1, 3, 80}) {
    CAPTURE(blocks);
    Model m;
    m.function_nodes = 1;
    m.friction = 0.3;
    m.add(rectangle(0, -4, blocks, 0, {20, 2, blocks, 2}));
    m.set(1, 1, end_of(kHeld));
    for (int32_t i = 0; i < blocks; ++i) {
      const double x = i;
      const int32_t block = m.add(polygon({{x, 0, 1}, {x + 1, 0, 1}, {x + 0.5, 1, 1}})), element = m.side(1, 3).last - i;
      m.body(block).rigid = m.body(block).is_free[0] = m.body(block).is_free[1] = 1;
      m.body(block).load[0] = 0.1, m.body(block).load[1] = -1;
      m.zones.push_back({C2D_ZONE_MATCHING, {{1, element, element}, {block, 1, 1}}});
    }
    many::Machine machine(m);
    const Result r = machine.run();
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    REQUIRE_MESSAGE(r.outcome == C2D_REACHED, r.messages());
    CHECK(r.summary.contact_unknowns == 2 * blocks);
    CHECK(machine.solver->sliding == 0);
    for (const Row& row : r.last().rows) {
      CHECK(std::fabs(row[C2D_TN]) == doctest::Approx(1));
      CHECK(std::fabs(row[C2D_TT]) == doctest::Approx(0.1));
      CHECK(row[C2D_STATUS] == C2D_STICK);
    }
  }
}

// Rigid blocks that do not turn, side by side, each on three pairs: so many motions go through orthonormalise() in parts.
TEST_CASE("frictionless: many rigid blocks on one body, each presses and rubs as much as its load") {
  using namespace many;
  for (const int32_t blocks : {6, 9, 12}) {
    CAPTURE(blocks);
    Model m;
    m.function_nodes = 1;
    m.friction = 0.5;
    m.add(rectangle(0, -4, blocks, 0, {20, 2, 3 * blocks, 2}));
    m.set(1, 1, end_of(kHeld));
    for (int32_t i = 0; i < blocks; ++i) {
      const double x = i;
      const int32_t block = m.add(polygon({{x, 0, 3}, {x + 1, 0, 1}, {x + 0.5, 1, 1}})), last = m.side(1, 3).last - 3 * i;
      m.body(block).rigid = m.body(block).is_free[0] = m.body(block).is_free[1] = 1;
      m.body(block).load[0] = 0.1, m.body(block).load[1] = -1;
      m.zones.push_back({C2D_ZONE_MATCHING, {{1, last - 2, last}, {block, 3, 1}}});
    }
    const Result r = many::Machine(m).run();
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    REQUIRE_MESSAGE(r.outcome == C2D_REACHED, r.messages());
    CHECK(r.summary.contact_unknowns == 6 * blocks);
    for (size_t b = 1; b < r.bodies.size(); ++b)
      for (int k = 0; k < 2; ++k) CHECK(r.bodies[b].contact[k] == doctest::Approx(k == 0 ? -0.1 : 1.0).epsilon(1e-9));
  }
}
