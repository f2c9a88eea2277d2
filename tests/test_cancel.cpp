// Cancelling at every chance, progress, and floating-point traps around whole runs.
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <map>

using namespace runs;

namespace {

struct Host : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  c2d_solver* solver = nullptr;
  int64_t calls = 0, cancel_at = -1;                                // of cancel
  int64_t told = 0, tell_cancel_at = -1;                            // of progress
  std::vector<int32_t> cancelled_in;                                // phase
  std::map<std::pair<int32_t, int32_t>, std::set<int64_t>> columns; // (phase, body): done
  std::map<int32_t, int64_t> phases;
  static int32_t cancel(void* context) {
    Host& h = static_cast<Host&>(self(context));
    return h.calls++ == h.cancel_at ? 1 : 0;
  }
  static void progress(void* context, const c2d_progress* now) {
    Host& h = static_cast<Host&>(self(context));
    h.phases[now->phase] += 1;
    h.columns[{now->phase, now->body}].insert(now->done);
    if (h.told++ == h.tell_cancel_at) {
      h.cancelled_in.push_back(now->phase);
      c2d_cancel(h.solver);
    }
  }
  Host() {
    serve(port);
    port.cancel = cancel;
    port.progress = progress;
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
};

uint64_t size_of(const c2d_limits& limits, bool in_core) {
  uint64_t minimum = 0, most = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, &most, nullptr) == C2D_OK);
  return in_core ? most : minimum;
}

// Cancelled at the n-th chance, then gone on with: the same bits as an undisturbed run.
struct Loop {
  size_t tried = 0, in_prepare = 0, in_run = 0;
  void run(const char* name, int32_t panel_columns, bool through_progress, int64_t stride) {
    CAPTURE(std::string(name));
    CAPTURE(through_progress);
    const Deck deck = deck_named(name);
    host::Limits limits = deck.limits();
    limits.panel_columns = panel_columns;
    Numbers clean;
    int64_t preparing = 0; // calls while preparing: every `stride`-th is tried there, every one after
    {
      Host host;
      Machine machine(limits, size_of(limits, false), &host.port);
      REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
      REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
      preparing = through_progress ? host.told : host.calls;
      REQUIRE(run_prepared(machine.solver, clean) == C2D_OK);
    }
    for (int64_t n = 0;; n += n + stride < preparing ? stride : 1) {
      CAPTURE(n);
      Host host;
      Machine machine(limits, size_of(limits, false), &host.port);
      host.solver = machine.solver;
      REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
      (through_progress ? host.tell_cancel_at : host.cancel_at) = n;
      c2d_status status = c2d_prepare(machine.solver);
      if (status == C2D_ERR_CANCELLED) {
        ++in_prepare;
        REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_MODEL);
        REQUIRE(error_of(machine.solver).status == C2D_ERR_CANCELLED);
        status = c2d_prepare(machine.solver);
      }
      REQUIRE(status == C2D_OK);
      Numbers numbers;
      status = c2d_run(machine.solver, Numbers::take, &numbers);
      if (status == C2D_ERR_CANCELLED) {
        ++in_run;
        REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_RUNNING);
        REQUIRE(error_of(machine.solver).status == C2D_ERR_CANCELLED);
        Numbers there; // valid at the load reached
        REQUIRE(get_boundary(machine.solver, there) == C2D_OK);
        for (double value : there.boundary) REQUIRE(std::isfinite(value));
      }
      const bool stopped = in_prepare + in_run > tried;
      const bool asked = through_progress ? host.told > n : host.calls > n;
      // The last call of progress, after the back substitution, comes when there is nothing left to stop but the next call.
      const bool too_late = through_progress && !host.cancelled_in.empty() && host.cancelled_in[0] == C2D_PHASE_BACK;
      if (!too_late) REQUIRE(stopped == asked);
      if (stopped) ++tried;
      if (!stopped) {
        REQUIRE(status == C2D_OK);
        if (too_late) REQUIRE(c2d_run(machine.solver, nullptr, nullptr) == C2D_ERR_CANCELLED);
        break;
      }
      REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
      REQUIRE(numbers == clean);
      REQUIRE(machine.guards_are_whole());
    }
  }
};

} // namespace

TEST_CASE("cancel: at every chance, in every phase; what follows gives the same bits") {
  for (bool through_progress : {false, true}) {
    Loop loop;
    loop.run("plate", 0, through_progress, 17);
    loop.run("hertz_lin_l", 40, through_progress, 13);
    loop.run("layer_t", 60, through_progress, 41);
    loop.run("sample", 200, through_progress, 101);
    MESSAGE(std::string(through_progress ? "c2d_cancel from progress: " : "port.cancel: ")
            << loop.tried << " cancelled, " << loop.in_prepare << " in prepare, " << loop.in_run << " in run");
    CHECK(loop.in_prepare > 100);
    CHECK(loop.in_run > 20);
  }
}

TEST_CASE("cancel: an advance that was cancelled goes on to the same state") {
  const Deck deck = deck_named("hertz_lin_l");
  const host::Limits limits = deck.limits();
  const double mu = 0.4, load = 1.0;
  std::vector<double> clean, row(static_cast<size_t>(limits.pairs));
  const auto read = [&](c2d_solver* s, std::vector<double>& out) {
    out.clear();
    for (int32_t field : {C2D_STATUS, C2D_TN, C2D_TT, C2D_UN1, C2D_UT2, C2D_GAP, C2D_SLIP_SUM}) {
      REQUIRE(c2d_get(s, field, 1, 1, limits.pairs, row.data(), 1) == C2D_OK);
      const double size = std::max(1e-300, std::fabs(*std::max_element(row.begin(), row.end(), [](double a, double b) {
                                     return std::fabs(a) < std::fabs(b);
                                   })));
      for (double value : row) out.push_back(field == C2D_STATUS ? value : value / size);
    }
  };
  int64_t cancelled = 0;
  for (int64_t n = -1;; ++n) {
    CAPTURE(n);
    Host host;
    Machine machine(limits, size_of(limits, true), &host.port);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
    host.calls = 0;
    host.cancel_at = n;
    c2d_outcome outcome = -1;
    c2d_status status = c2d_advance(machine.solver, &load, 1, &outcome);
    std::vector<double> now;
    if (n < 0) {
      REQUIRE(status == C2D_OK);
      read(machine.solver, clean);
      continue;
    }
    if (status == C2D_OK) {
      REQUIRE(host.calls <= n);
      break;
    }
    REQUIRE(status == C2D_ERR_CANCELLED);
    ++cancelled;
    REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_RUNNING);
    const host::Summary at = summary_of(machine.solver);
    CHECK(at.load >= 0.0);
    CHECK(at.load <= load);
    REQUIRE(c2d_advance(machine.solver, &load, 1, &outcome) == C2D_OK);
    REQUIRE(outcome == C2D_REACHED);
    read(machine.solver, now);
    REQUIRE(now.size() == clean.size());
    // One step or two steps to the same load: round-off through at most a few dozen exchanges.
    for (size_t i = 0; i < now.size(); ++i) REQUIRE(std::fabs(now[i] - clean[i]) <= 1e-9);
  }
  MESSAGE("advance cancelled at " << cancelled << " places");
  CHECK(cancelled > 5);
}

namespace {

// A call, and whether it is one that a cancel stops.
struct Named {
  const char* name;
  bool stops;
  test::Callable<c2d_status(c2d_solver*)> make;
};

// Every call of a solver that follows its load, in an order that is legal from state prepared on.
std::vector<Named> calls_of_a_path(int32_t pairs) {
  static const double mu = 0.4, load = 0.5, point[] = {0.3, 0.3};
  static double out[64];
  static c2d_outcome outcome;
  return {{"save", false, c2d_save},
          {"set_units", false, [](c2d_solver* s) { return c2d_set_units(s, "m", "N"); }},
          {"begin", false, [](c2d_solver* s) { return c2d_begin(s, &mu, 1); }},
          {"advance", true, [](c2d_solver* s) { return c2d_advance(s, &load, 1, &outcome); }},
          {"next_event", false, [](c2d_solver* s) { return c2d_next_event(s, &load, 1, out); }},
          {"get", false, [](c2d_solver* s) { return c2d_get(s, C2D_END_X, 1, 1, 2, out, 1); }},
          {"get pairs", false, [pairs](c2d_solver* s) { return c2d_get(s, C2D_TN, 1, 1, pairs > 0 ? 1 : 0, out, 1); }},
          {"interior", true, [](c2d_solver* s) { return c2d_interior(s, 1, 1, point, 2, out, C2D_POINT_FIELDS); }},
          {"indicators", true, [](c2d_solver* s) { return c2d_indicators(s, 1, 1, 1, out, C2D_OFF_FIELDS); }},
          {"run", true, [](c2d_solver* s) { return c2d_run(s, nullptr, nullptr); }},
          {"save", false, c2d_save},
          {"restore", false, c2d_restore},
          {"change_loads", false, c2d_change_loads},
          {"prepare", true, c2d_prepare}};
}

} // namespace

TEST_CASE("cancel: one that no call saw is told by the next that can be cancelled, once, and by no other") {
  int told = 0, passed = 0;
  for (const char* name : {"plate", "hertz_lin_l", "layer_t"}) {
    CAPTURE(std::string(name));
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    const std::vector<Named> calls = calls_of_a_path(limits.pairs);
    for (size_t at = 0; at <= calls.size(); ++at) { // the cancel comes before call `at`; at the end: before the first
      Host host;
      Machine machine(limits, size_of(limits, true), &host.port);
      REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
      bool pending = at == calls.size();
      if (pending) c2d_cancel(machine.solver);
      REQUIRE(c2d_prepare(machine.solver) == (pending ? C2D_ERR_CANCELLED : C2D_OK));
      if (pending) REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
      pending = false;
      for (size_t i = 0; i < calls.size(); ++i) {
        CAPTURE(std::string(calls[i].name));
        if (i == at) pending = c2d_cancel(machine.solver) == C2D_OK;
        const int32_t before = c2d_get_state(machine.solver);
        c2d_status status = calls[i].make(machine.solver);
        REQUIRE(status == (pending && calls[i].stops ? C2D_ERR_CANCELLED : C2D_OK));
        ++(status == C2D_OK ? passed : told);
        if (status == C2D_OK) continue;
        REQUIRE(c2d_get_state(machine.solver) == before);
        REQUIRE(error_of(machine.solver).status == C2D_ERR_CANCELLED);
        pending = false;
        REQUIRE(calls[i].make(machine.solver) == C2D_OK);
      }
      REQUIRE(!pending);
    }
  }
  MESSAGE("calls: " << passed << " went through, " << told << " told a cancel");
  CHECK(told == 3 * 14);
}

TEST_CASE("cancel: refused calls do not use it up, nor does a store that fails") {
  const Deck deck = deck_named("hertz_lin_l");
  const host::Limits limits = deck.limits();
  Host host;
  Machine machine(limits, size_of(limits, true), &host.port);
  c2d_solver* const s = machine.solver;
  const double mu = 0.4, load = 0.5, none = std::nan("");
  c2d_outcome outcome = 7;
  REQUIRE(read_deck(s, deck) == C2D_OK);
  REQUIRE(c2d_cancel(s) == C2D_OK);
  CHECK(c2d_advance(s, &load, 1, &outcome) == C2D_ERR_STATE);
  CHECK(c2d_prepare(s) == C2D_ERR_CANCELLED);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_save(s) == C2D_OK);
  REQUIRE(c2d_cancel(s) == C2D_OK);
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  CHECK(c2d_advance(s, &none, 1, &outcome) == C2D_ERR_ARGUMENT);
  CHECK(c2d_interior(s, 9, 0, nullptr, 0, nullptr, 0) == C2D_ERR_ARGUMENT);
  host.before = [](const RamStore::Operation&, size_t) { return 5; };
  CHECK(c2d_begin(s, &mu, 1) == C2D_ERR_STORE_READ);
  CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);
  host.before = nullptr;
  REQUIRE(c2d_restore(s) == C2D_OK);
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  CHECK(c2d_advance(s, &load, 1, &outcome) == C2D_ERR_CANCELLED);
  CHECK(outcome == 7); // nothing is written by a call that fails
  CHECK(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
  CHECK(outcome == C2D_REACHED);
}

TEST_CASE("cancel: neither c2d_begin nor c2d_next_event is cut short") {
  for (const char* name : {"hertz_lin_l", "layer_t", "sample"}) {
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    Host host;
    Machine machine(limits, size_of(limits, true), &host.port);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    const double mu = 0.4, load = 1.0, half = 0.5;
    double step = -1.0;
    host.solver = machine.solver;
    for (const bool through_progress : {false, true}) {
      c2d_outcome outcome = 7;
      (through_progress ? host.tell_cancel_at : host.cancel_at) = through_progress ? host.told : host.calls;
      REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
      REQUIRE(c2d_next_event(machine.solver, &load, 1, &step) == C2D_OK);
      REQUIRE(step >= 0.0);
      REQUIRE(c2d_advance(machine.solver, &half, 1, &outcome) == C2D_ERR_CANCELLED);
      REQUIRE(c2d_advance(machine.solver, &half, 1, &outcome) == C2D_OK);
    }
  }
}

TEST_CASE("progress: every assembled column of every body, every event") {
  for (const char* name : {"plate", "hertz_lin_l", "sample"}) {
    CAPTURE(std::string(name));
    const Deck deck = deck_named(name);
    for (int32_t forced : {1, 7, 0}) {
      CAPTURE(forced);
      host::Limits limits = deck.limits();
      limits.panel_columns = forced;
      Host host;
      Machine machine(limits, size_of(limits, forced == 0), &host.port);
      Numbers numbers;
      REQUIRE(run_all(machine.solver, deck, numbers) == C2D_OK);
      const host::Summary s = summary_of(machine.solver);
      for (int32_t body = 1; body <= s.bodies; ++body) {
        const int64_t eliminated = s.body[body - 1].unknowns - s.contact_unknowns;
        const int64_t columns = eliminated + 2 * s.contact_unknowns + 1;
        // Columns are filled many at a time, then each is told at least once.
        const auto& seen = host.columns[{C2D_PHASE_ELIMINATE, body}];
        for (int64_t column = 0; column < columns; ++column) REQUIRE(seen.count(column) == 1);
        CHECK(static_cast<int64_t>(host.columns[{C2D_PHASE_ASSEMBLE, body}].size()) >= 1);
      }
      CHECK(host.phases[C2D_PHASE_CONTACT] >= s.events);
    }
  }
}

TEST_CASE("traps: no run raises invalid, zero-divide or overflow, or turns the rounding") {
#if defined(__GLIBC__) && !defined(__SANITIZE_THREAD__)
  const int watched = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
  int runs_made = 0;
  for (const std::string& name : deck_names())
    for (int32_t stepping : {C2D_STEPPING_EVENTS, C2D_STEPPING_DECK})
      for (int32_t quadrature : {C2D_QUADRATURE_ACCURATE, C2D_QUADRATURE_THESIS})
        for (bool in_core : {false, true}) {
          if (name == "sample56" && !in_core && quadrature == C2D_QUADRATURE_THESIS) continue; // for time
          CAPTURE(std::string(name));
          CAPTURE(stepping);
          CAPTURE(quadrature);
          const Deck deck = deck_named(name);
          c2d_options options = C2D_INIT(c2d_options);
          options.stepping = stepping;
          options.quadrature = quadrature;
          Host host;
          const host::Limits limits = deck.limits();
          Machine machine(limits, size_of(limits, in_core), &host.port);
          Numbers numbers;
          std::feclearexcept(FE_ALL_EXCEPT);
          REQUIRE(feenableexcept(watched) != -1);
          const int rounding = std::fegetround();
          const c2d_status status = run_all(machine.solver, deck, numbers, &options);
          const c2d_status closed = c2d_close(machine.solver);
          fedisableexcept(watched);
          CHECK(std::fetestexcept(watched) == 0);
          CHECK(std::fegetround() == rounding);
          CHECK(status == C2D_OK);
          CHECK(closed == C2D_OK);
          ++runs_made;
        }
  MESSAGE("runs with traps: " << runs_made);
  CHECK(runs_made >= 70);
#endif
}

TEST_CASE("cancel: at every chance while indicators and points inside are asked for, which come out the same afterwards") {
  for (const char* name : {"hertz_lin_l", "ring3"}) {
    CAPTURE(std::string(name));
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    Host host;
    Machine machine(limits, size_of(limits, true), &host.port);
    Numbers numbers;
    REQUIRE(run_all(machine.solver, deck, numbers) == C2D_OK);
    const auto ask = [&](std::vector<double>& out) {
      out.clear();
      for (int32_t body = 1; body <= summary_of(machine.solver).bodies; ++body) {
        c2d_body_result own = C2D_INIT(c2d_body_result);
        REQUIRE(c2d_get_body_result(machine.solver, body, &own) == C2D_OK);
        const size_t at = out.size(), points = at + static_cast<size_t>(own.elements) * C2D_OFF_FIELDS;
        out.resize(points + 40 * C2D_POINT_FIELDS);
        c2d_status status = c2d_indicators(machine.solver, body, 1, own.elements, out.data() + at, C2D_OFF_FIELDS);
        double xy[2 * 40];
        for (int i = 0; i < 40; ++i) xy[2 * i] = 0.3 + 0.01 * i, xy[2 * i + 1] = body == 1 ? 0.4 : -0.4;
        if (status == C2D_OK) status = c2d_interior(machine.solver, body, 40, xy, 2, out.data() + points, C2D_POINT_FIELDS);
        if (status != C2D_OK) return status;
      }
      return c2d_status{C2D_OK};
    };
    std::vector<double> clean, out;
    REQUIRE(ask(clean) == C2D_OK);
    int64_t stopped = 0;
    for (;; ++stopped) {
      host.calls = 0, host.cancel_at = stopped;
      const c2d_status status = ask(out);
      if (status == C2D_OK) break;
      REQUIRE(status == C2D_ERR_CANCELLED);
    }
    host.cancel_at = -1;
    CHECK(stopped > 1);
    CHECK(ask(out) == C2D_OK);
    CHECK(Numbers::same(out, clean));
  }
}
