// A path whose store fails, whose host cancels, or that stops: at any of its operations, while overlaps are closed, when
// changes are shown, and when results are asked for. Two squares, the upper one pressed and pushed, by 0.01 too deep or not.
#include "many_bodies.hpp"
#include "memory/config.hpp"
#include "program/commands/families.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <sstream>

using namespace runs;

namespace {

// `deep`: how far they overlap; less than 0: what they are apart.
Deck squares(double deep, const std::string& friction, const std::string& push, const std::string& press = "-1") {
  const auto at = [&](double y) { return std::to_string(y - deep); };
  Deck deck;
  deck.lines = {"*FREE",   "1",       "SQUARES", "0 2", "2 1 2", "1 2 4 4", "1 2 4 4", "1 4",  "1 4",
                "1e3 0.3", "1e3 0.3", friction,  "0 0", "1 0 0", "2 1 0",   "3 1 1",   "4 0 1"};
  deck.lines.insert(deck.lines.end(), {"0 0", "1 0 " + at(1), "2 1 " + at(1), "3 1 " + at(2), "4 0 " + at(2)});
  deck.lines.insert(deck.lines.end(), {"2", "1 1 1100 0 0 0 0", "1 2 1100 0 0 0 0", "0", "2",
                                       "3 1 0011 " + push + " " + press + " 0 0", "3 2 0011 " + push + " " + press + " 0 0",
                                       "0", "1 2 2 1", "3 3 1 1", "3 4 2 1", "2 1", "2 1", "1 50", "2 1"});
  if (deep > 0) deck.lines.push_back("*INTERFERENCE 2");
  return deck;
}

// In the least memory, so that most numbers are read when they are needed.
struct Run : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  int64_t left = -1, asked = 0; // until the read that fails, or the host cancels; < 0: never
  bool cancels = false;
  std::unique_ptr<Machine> machine;
  c2d_solver* s = nullptr;

  explicit Run(const Deck& deck, bool every_change, int32_t bodies = 2) {
    const host::Limits limits = deck.limits();
    REQUIRE(limits.bodies == bodies);
    uint64_t least = 0;
    REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
    serve(port);
    before = [this](const Operation& operation, size_t) { return !cancels && operation.kind == 'r' && is_now() ? 77 : 0; };
    port.cancel = [](void* context) {
      Run& run = static_cast<Run&>(self(context));
      return run.cancels && run.is_now() ? 1 : 0;
    };
    machine = std::make_unique<Machine>(limits, least, &port);
    s = machine->solver;
    c2d_options options = C2D_INIT(c2d_options);
    options.every_change = every_change;
    REQUIRE(c2d_set_options(s, &options) == C2D_OK);
    REQUIRE_MESSAGE(read_deck(s, deck) == C2D_OK, error_of(s).text);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  bool is_now() {
    ++asked;
    return left-- == 0;
  }
  void go_wrong(bool by_cancel, int64_t after) { cancels = by_cancel, left = after, asked = 0; }
};

} // namespace

TEST_CASE("path faults: wherever a read fails or the host cancels on the way, also where overlaps are closed, that is told") {
  for (const double deep : {0.0, 0.01, -0.1, -0.2})
    for (const bool every_change : {false, true})
      for (const bool cancel : {false, true}) {
        CAPTURE(deep);
        CAPTURE(every_change);
        CAPTURE(cancel);
        const bool slides = deep == 0 && every_change; // until nothing holds it
        const bool apart = deep < -0.1;                // nothing moves it
        const Deck deck = squares(deep, slides ? "2 0.05 0.6" : "2 0.3 0.6", apart ? "0" : (slides ? "0.1" : "0.4"),
                                  apart || (deep < 0 && every_change) ? "0" : "-1");
        const auto run = [&](int64_t after, int64_t* asked) {
          Run r(deck, every_change);
          REQUIRE(c2d_prepare(r.s) == C2D_OK);
          r.go_wrong(cancel, after);
          const c2d_status status = c2d_run(r.s, Numbers::take, std::make_unique<Numbers>().get());
          *asked = r.asked;
          return status;
        };
        int64_t all = 0, unused = 0;
        REQUIRE(run(-1, &all) == C2D_OK);
        REQUIRE(all > 1);
        for (int64_t n = 0; n < all; ++n) CHECK(run(n, &unused) == (cancel ? C2D_ERR_CANCELLED : C2D_ERR_STORE_READ));
      }
}

TEST_CASE("path faults: results that are asked for where their table is not yet made, and the store fails") {
  const double mu = 0.3, load = 1;
  c2d_outcome outcome = C2D_REACHED;
  const auto fails = [&](auto call) {
    Run r(squares(0, "1 0.3", "0.1"), false);
    REQUIRE(c2d_prepare(r.s) == C2D_OK);
    REQUIRE(c2d_begin(r.s, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(r.s, &load, 1, &outcome) == C2D_OK);
    r.go_wrong(false, 0);
    CHECK(call(r.s) == C2D_ERR_STORE_READ);
    CHECK(c2d_get_state(r.s) == C2D_STATE_BROKEN);
  };
  double pressure[2];
  c2d_body_state state = C2D_INIT(c2d_body_state);
  fails([&](c2d_solver* s) { return c2d_get(s, C2D_TN, 0, 1, 2, pressure, 1); });
  fails([&](c2d_solver* s) { return c2d_get_body_state(s, 1, &state); });
}

TEST_CASE(
    "path faults: whoever asks for stresses inside or indicators may cancel, and the numbers of a surface are in their range") {
  const double mu = 0.3, load = 1;
  c2d_outcome outcome = C2D_REACHED;
  Run r(squares(0, "1 0.3", "0.1"), false);
  REQUIRE(c2d_prepare(r.s) == C2D_OK);
  REQUIRE(c2d_begin(r.s, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(r.s, &load, 1, &outcome) == C2D_OK);
  std::vector<double> out(4 * C2D_OFF_FIELDS + 4 * C2D_POINT_FIELDS);
  const double xy[] = {0.3, 0.4, 0.5, 0.6};
  for (const bool inside : {false, true}) {
    CAPTURE(inside);
    const auto ask = [&] {
      return inside ? c2d_interior(r.s, 1, 2, xy, 2, out.data(), C2D_POINT_FIELDS)
                    : c2d_indicators(r.s, 1, 1, 4, out.data(), C2D_OFF_FIELDS);
    };
    r.go_wrong(true, -1);
    REQUIRE(ask() == C2D_OK);
    const int64_t all = r.asked;
    REQUIRE(all > 0);
    for (int64_t n = 0; n < all; ++n) {
      r.go_wrong(true, n);
      CHECK(ask() == C2D_ERR_CANCELLED);
    }
  }
  CHECK(c2d_get(r.s, C2D_SURFACE_X, 1, 1, 4, out.data(), 1) == C2D_OK);
  CHECK(c2d_get(r.s, C2D_SURFACE_X, 1, 1, 5, out.data(), 1) == C2D_ERR_ARGUMENT);
}

// Of three bodies each meets others: what one makes is read when the next is looked at.
TEST_CASE("path faults: whichever read of a preparation fails, that is told") {
  Deck deck;
  std::ifstream in(paths::root() + "/examples/three_bodies.dat");
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  const host::Limits limits = deck.limits();
  uint64_t least = 0;
  REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
  int64_t reads = 0;
  for (int64_t n = -1; n < reads; n += 1 + (n < 0 ? 0 : reads / 120)) {
    CAPTURE(n);
    RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    int64_t asked = 0;
    store.before = [&](const RamStore::Operation& operation, size_t) { return operation.kind == 'r' && asked++ == n ? 9 : 0; };
    Machine machine(limits, least, &port);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    asked = 0;
    const c2d_status status = c2d_prepare(machine.solver);
    if (n < 0) {
      REQUIRE(status == C2D_OK);
      reads = asked;
      REQUIRE(reads > 50);
    } else {
      CHECK((status == C2D_ERR_STORE_READ || n == 0)); // (the first is of the count, which a new store need not have)
    }
  }
}

// A rigid square, free to move, is pressed on another: its motions and what forces do to them are columns one by one. What
// fails once and goes well from then on is told as well.
TEST_CASE("path faults: whichever operation fails once while a rigid body is prepared, that is told") {
  many::Model m;
  m.add(many::rectangle(0, 0, 1, 1, {2, 2, 2, 2}));
  m.add(many::rectangle(0, 1, 1, 2, {2, 2, 2, 2}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.bodies[1].rigid = 1;
  for (int32_t& is_free : m.bodies[1].is_free) is_free = 1;
  m.bodies[1].load[1] = -1;
  m.bodies[1].point[0] = 0.5, m.bodies[1].point[1] = 1.5;
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  std::vector<int32_t> order;
  std::istringstream in(many::deck_of(m, "rigid", order));
  Deck deck;
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  const host::Limits limits = deck.limits();
  uint64_t least = 0;
  REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
  size_t operations = 1;
  for (size_t n = 0; n <= operations; ++n) { // the last one fails nowhere
    CAPTURE(n);
    RamStore store;
    char failed = ' ';
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    Machine machine(limits, least, &port);
    REQUIRE_MESSAGE(read_deck(machine.solver, deck) == C2D_OK, error_of(machine.solver).text);
    const size_t begun = store.done.size(), faulty = operations == 1 ? SIZE_MAX : begun + n;
    store.before = [&failed, faulty](const RamStore::Operation& operation, size_t i) {
      if (i != faulty) return 0;
      failed = operation.kind;
      return 9;
    };
    const c2d_status status = c2d_prepare(machine.solver);
    if (operations == 1) {
      REQUIRE(status == C2D_OK);
      operations = store.done.size() - begun;
      REQUIRE(operations > 50);
    } else if (failed == 'r' || failed == 'w') {
      CHECK((status == (failed == 'r' ? C2D_ERR_STORE_READ : C2D_ERR_STORE_WRITE) || n == 1));
    }
  }
}

// Plates upon each other, the upper two of which slide off: what moves is found from the matrices of all.
TEST_CASE("path faults: whichever read fails, or where the host cancels, while two bodies are found to slide") {
  std::string text, error;
  REQUIRE(families::make_deck("stack", {"n=1"}, text, error));
  const std::string friction = "! coefficients of friction\n1 0.3\n"; // less than holds them
  const size_t at = text.find(friction);
  REQUIRE(at != std::string::npos);
  text.replace(at, friction.size(), "1 0.1\n");
  Deck deck;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  for (const bool cancel : {false, true}) {
    CAPTURE(cancel);
    int64_t all = 0;
    for (int64_t n = -1; n < all; n += 1 + (n < 0 ? 0 : all / 60)) {
      CAPTURE(n);
      Run r(deck, false, 3);
      REQUIRE(c2d_prepare(r.s) == C2D_OK);
      r.go_wrong(cancel, n);
      const c2d_status status = c2d_run(r.s, nullptr, nullptr);
      if (n >= 0) {
        CHECK(status == (cancel ? C2D_ERR_CANCELLED : C2D_ERR_STORE_READ));
        continue;
      }
      REQUIRE(status == C2D_OK);
      CHECK(summary_of(r.s).outcome == C2D_GROSS_SLIDING);
      all = r.asked;
      REQUIRE(all > 1);
    }
  }
}

TEST_CASE("path faults: a preparation that is cancelled, and whose tapes cannot be closed then") {
  Run r(squares(0, "1 0.3", "0.1"), false);
  const auto read = r.before;
  r.before = [&](const RamStore::Operation& operation, size_t n) { return operation.kind == 'c' ? 5 : read(operation, n); };
  r.go_wrong(true, 2);
  CHECK(c2d_prepare(r.s) == C2D_ERR_STORE_CLOSE);
  CHECK(error_of(r.s).host_code == 5);
}

// The first coefficient does not hold the upper square: its path stops. What was saved there goes on with the second.
TEST_CASE("path faults: a run that was saved where a path stopped goes on with the next coefficient, the same bits") {
  if (c2d::kSmallCode) return; // (it does not save there)
  const Deck deck = squares(0, "2 0.05 0.6", "0.1");
  Numbers whole;
  Run first(deck, false);
  REQUIRE(c2d_prepare(first.s) == C2D_OK);
  struct Show {
    Run& run;
    Numbers& numbers;
    std::vector<Bytes> tape[C2D_TAPES];
    size_t before = 0; // numbers told when the state was saved
  } show{first, whole, {}, 0};
  const auto step = [](void* context, const c2d_step* now) -> int32_t {
    Show& to = *static_cast<Show*>(context);
    Numbers::take(&to.numbers, now);
    if (now->kind != C2D_STEP_STOPPED) return 0;
    CHECK(now->outcome == C2D_GROSS_SLIDING);
    CHECK(c2d_save(to.run.s) == C2D_OK);
    for (int32_t t = 0; t < C2D_TAPES; ++t) to.tape[t] = to.run.tape[t];
    to.before = to.numbers.steps.size();
    return 0;
  };
  REQUIRE(c2d_run(first.s, step, &show) == C2D_OK);
  REQUIRE(show.before > 0);
  REQUIRE(whole.steps.size() > show.before);
  Run second(deck, false);
  for (int32_t t = 0; t < C2D_TAPES; ++t) second.tape[t] = show.tape[t];
  REQUIRE_MESSAGE(c2d_restore(second.s) == C2D_OK, error_of(second.s).text);
  Numbers rest;
  REQUIRE(c2d_run(second.s, Numbers::take, &rest) == C2D_OK);
  CHECK(Numbers::same(rest.steps,
                      std::vector<double>(whole.steps.begin() + static_cast<int64_t>(show.before), whole.steps.end())));
}
