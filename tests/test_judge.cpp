// Nothing is shown that is not within its limits: tableaus that were spoilt on purpose, on the way and from outside, decks
// on which small pivots spoil them, and what is left of a path that cannot be followed within the limits.
#include "callable.hpp"
#include "many_bodies.hpp"
#include "problem.hpp"
#include "solver/judge.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

using namespace runs;

namespace {

using Interference = test::Callable<void(c2d_solver*, int32_t step)>;

// What else a run does: before and after it, and whenever the path asks whether to go on.
struct Hooks {
  test::Callable<void(c2d_solver*)> before, after, asked;
};

// Runs the deck; after every recorded row `interfere` may spoil the workspace.
struct Store : RamStore { // the port's context, which leads to the run
  void* run = nullptr;
};
struct Run {
  Store store;
  c2d_port port = C2D_INIT(c2d_port);
  Interference interfere;
  Hooks hooks;
  c2d_solver* solver = nullptr;
  std::vector<problem::Step> steps;
  host::Summary summary;
  c2d_status status = C2D_OK;
  std::vector<std::string> told;
  bool running = false;

  explicit Run(const Deck& deck, Interference spoil = nullptr, Hooks other = Hooks())
      : interfere(std::move(spoil)), hooks(std::move(other)) {
    store.serve(port);
    store.run = this;
    port.log = [](void* context, const c2d_error* entry) { of(context).told.push_back(entry->text); };
    if (hooks.asked)
      port.progress = [](void* context, const c2d_progress*) {
        if (of(context).running) of(context).hooks.asked(of(context).solver);
      };
    const host::Limits limits = deck.limits();
    uint64_t minimum = 0, in_core = 0;
    REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
    Machine machine(limits, in_core, &port);
    REQUIRE(machine.created == C2D_OK);
    solver = machine.solver;
    REQUIRE(read_deck(solver, deck) == C2D_OK);
    REQUIRE(c2d_prepare(solver) == C2D_OK);
    if (hooks.before) hooks.before(solver);
    running = true;
    status = c2d_run(solver, show, this);
    running = false;
    summary = summary_of(solver);
    if (hooks.after) hooks.after(solver);
  }
  static Run& of(void* store) { return *static_cast<Run*>(static_cast<Store*>(store)->run); }
  static int32_t show(void* context, const c2d_step* step) {
    Run& run = *static_cast<Run*>(context);
    problem::Step now{step->kind, step->coefficient, step->step, step->changes, step->iterations, step->outcome,
                      step->mu,   step->load,        {}};
    for (int32_t i = 0; i < step->pairs; ++i)
      now.table.insert(now.table.end(), step->table + i * step->stride, step->table + i * step->stride + C2D_PAIR_FIELDS);
    run.steps.push_back(now);
    if (run.interfere && step->kind == C2D_STEP_RECORDED) run.interfere(run.solver, static_cast<int32_t>(run.steps.size()));
    return 0;
  }
};

double worst(const Run& a, const Run& b) {
  REQUIRE(a.steps.size() == b.steps.size());
  problem::Difference all;
  for (size_t i = 0; i < a.steps.size(); ++i) all.join(problem::compare(a.steps[i], b.steps[i]));
  CHECK(all.statuses == 0);
  return all.worst();
}

c2d::Session session_of(c2d_solver* s) {
  c2d::Session session;
  c2d::open_session(s, session);
  return session;
}

} // namespace

TEST_CASE("judge: a tableau that was spoilt is built anew before the next row") {
  const Deck deck = deck_named("sample");
  const Run sound(deck);
  REQUIRE(sound.summary.outcome == C2D_REACHED);
  CHECK(sound.summary.max_residual < 1e-12);
  for (double by : {1e-9, 1e-6, 1e-2, 10.0})
    for (int what : {0, 1, 2}) { // all of it; the loads' rates; one number of them
      CAPTURE(by);
      CAPTURE(what);
      const Run spoilt(deck, [&](c2d_solver* s, int32_t step) {
        if (step != 5) return;
        const c2d::Session session = session_of(s);
        const int64_t m = session.tableau.m, all = m * c2d::tableau_columns(m, 1), rates = m * (m + 1);
        const int64_t from = what == 0 ? 0 : rates, to = what == 0 ? all : what == 1 ? rates + m : rates + 1;
        for (int64_t i = from; i < to; ++i)
          session.area.tableau[i] *= static_cast<c2d::Real>(1 + by * std::cos(7.0 * static_cast<double>(i)));
      });
      CHECK(spoilt.status == C2D_OK);
      CHECK(spoilt.summary.outcome == C2D_REACHED);
      CHECK(spoilt.summary.tableau_rebuilds > sound.summary.tableau_rebuilds - 1);
      CHECK(worst(sound, spoilt) < (sizeof(c2d::Real) == 8 ? 1e-10 : 1e-3));
    }
}

TEST_CASE("judge: a status that was spoilt is taken back") {
  const Deck deck = deck_named("sample");
  const Run sound(deck);
  const Run spoilt(deck, [&](c2d_solver* s, int32_t step) {
    if (step != 3) return;
    const c2d::Session session = session_of(s);
    for (int32_t i = 0; i < session.tableau.pairs; ++i)
      if (session.model.pair[i].status == C2D_OPEN) session.model.pair[i].status = C2D_STICK;
  });
  CHECK(spoilt.summary.outcome == C2D_REACHED);
  CHECK(worst(sound, spoilt) < (sizeof(c2d::Real) == 8 ? 1e-10 : 1e-3));
}

TEST_CASE("judge: what no new tableau helps ends the path, with the rows up to there, and says why") {
  const Deck deck = deck_named("sample");
  const Run sound(deck);
  const int64_t m = 2 * 15 - 1, others = 2 + 5; // solver/judge.cpp: Book: of a zone and a case
  struct Case {
    int32_t breach;
    int64_t from, to;
  };
  for (const Case& c : {Case{C2D_BREACH_TABLEAU, 0, m}, Case{C2D_BREACH_EQUATIONS, m, 2 * m}, Case{C2D_BREACH_BALANCE, 0, 3}}) {
    CAPTURE(c.breach);
    const Run run(deck, [&](c2d_solver* s, int32_t step) {
      if (step != 4) return;
      REQUIRE(session_of(s).tableau.m == m);
      double* book = c2d::array_of<double>(s, c2d::kJudge);
      double* load_work = c2d::model_of(s).load_work[1]; // of the body that floats
      c2d::Real* of_unknowns = reinterpret_cast<c2d::Real*>(book + others);
      for (int64_t i = c.from; i < c.to; ++i) {
        if (c.breach == C2D_BREACH_BALANCE)
          load_work[i] *= 1.1;
        else
          of_unknowns[i] *= c2d::Real(1.1);
      }
    });
    CHECK(run.status == C2D_OK);
    REQUIRE(run.steps.size() >= 5);
    const problem::Step &last = run.steps[3], &stop = run.steps[4];
    CHECK(stop.kind == C2D_STEP_STOPPED);
    CHECK(stop.outcome == C2D_BEYOND_LIMITS);
    CHECK(stop.load == last.load);
    CHECK(problem::compare(stop, last).worst() < (sizeof(c2d::Real) == 8 ? 1e-12 : 1e-4));
    for (size_t i = 0; i < 4; ++i) CHECK(run.steps[i].table == sound.steps[i].table);
    CHECK(run.summary.outcome == C2D_BEYOND_LIMITS);
    CHECK(run.summary.breach == c.breach);
    CHECK(run.summary.breach_size > 1e-5);
  }
  CHECK(std::string(c2d_outcome_message(C2D_BEYOND_LIMITS)) == "beyond the limits of accuracy");
  CHECK(sound.summary.breach == C2D_BREACH_NONE);
  CHECK(sound.summary.breach_size == 0);
}

namespace {

// Zeros in place of the contact system's matrix on its tape, with good labels: no tableau can be built any more.
void lose_matrix(c2d_solver* s) {
  const c2d::Session session = session_of(s);
  const int64_t m = session.tableau.m;
  const std::vector<c2d::Real> zeros(static_cast<size_t>(m * m));
  REQUIRE(c2d::write_matrix(session.tape, c2d::ContactMatrix::stiffness, zeros.data(), m) == C2D_OK);
}
void spoil_tableau(c2d_solver* s) {
  const c2d::Session session = session_of(s);
  const int64_t all = int64_t{session.tableau.m} * c2d::tableau_columns(session.tableau.n, session.tableau.cases);
  for (int64_t i = 0; i < all; ++i) session.area.tableau[i] *= c2d::Real(1.5);
}
// What the contact equations are judged by (solver/judge.cpp: Book).
void spoil_equations(c2d_solver* s) {
  const c2d::ModelHeader& head = s->model;
  c2d::Real* const of_unknowns =
      reinterpret_cast<c2d::Real*>(c2d::array_of<double>(s, c2d::kJudge) + 2 * head.zones + 5 * head.load_cases);
  for (int32_t i = head.contact; i < 3 * head.contact; ++i) of_unknowns[i] *= c2d::Real(1.1);
}

} // namespace

TEST_CASE("judge: where no new tableau has pivots the path ends at the last good state, and goes nowhere from there") {
  constexpr int kAt = 12;
  const Deck deck = deck_named("sample");
  for (const bool late : {false, true}) { // at once; when the state has been found beyond the limits, and is tried again
    CAPTURE(late);
    bool lost = false;
    Hooks hooks;
    hooks.asked = [&](c2d_solver* s) {
      if (!late || lost || s->careful == 0) return;
      lose_matrix(s);
      --s->built_exchanges; // as if a pair had changed since
      lost = true;
    };
    hooks.before = [=](c2d_solver* s) { s->model.coefficients = 1, s->keeps_energy = late ? 0 : 1; };
    hooks.after = [&](c2d_solver* s) {
      const double at = summary_of(s).load;
      double step = 7.0, load = 1.0;
      CHECK(c2d_next_event(s, &load, 1, &step) == C2D_OK);
      CHECK(step == 0.0);
      c2d_outcome outcome = C2D_REACHED;
      CHECK(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
      CHECK(outcome == C2D_BEYOND_LIMITS);
      CHECK(summary_of(s).load == at);
    };
    const Run run(
        deck,
        [&](c2d_solver* s, int32_t step) {
          if (step != kAt) return;
          if (!late) lose_matrix(s);
          if (!late) spoil_tableau(s);
          c2d::Real* of_unknowns = reinterpret_cast<c2d::Real*>(c2d::array_of<double>(s, c2d::kJudge) + 2 + 5);
          for (int64_t i = session_of(s).tableau.m; late && i < 2 * session_of(s).tableau.m; ++i)
            of_unknowns[i] *= c2d::Real(1.1);
        },
        hooks);
    CHECK(lost == late);
    CHECK(run.status == C2D_OK);
    REQUIRE(run.steps.size() == kAt + 1);
    const problem::Step &last = run.steps[kAt - 1], &stop = run.steps[kAt];
    CHECK(stop.kind == C2D_STEP_STOPPED);
    CHECK(stop.outcome == C2D_BEYOND_LIMITS);
    CHECK(stop.load == last.load);
    CHECK(problem::compare(stop, last).worst() < (sizeof(c2d::Real) == 8 ? 1e-12 : 1e-4));
    CHECK(run.summary.breach == C2D_BREACH_SINGULAR);
    bool said = false;
    for (const std::string& text : run.told) said = said || text.find("equations have no unique solution") != std::string::npos;
    CHECK(said);
  }
}

TEST_CASE("judge: a tableau that is spoilt again after every repair ends the path, and not the program") {
  constexpr int kAt = 5;
  const Deck deck = deck_named("sample");
  const Run sound(deck);
  int64_t repairs = 0;
  Hooks hooks;
  hooks.before = [](c2d_solver* s) { s->model.coefficients = 1; };
  hooks.asked = [&](c2d_solver* s) { // between a repair and the look at what it came to
    if (s->rebuilds == repairs) return;
    repairs = s->rebuilds;
    const c2d::Session session = session_of(s);
    for (int32_t i = 0; i < session.tableau.m; ++i) session.area.y[i] *= c2d::Real(sizeof(c2d::Real) == 8 ? 1 + 1e-5 : 1.1);
    --s->built_exchanges; // as if a pair had changed since
  };
  const Run run(
      deck, [](c2d_solver* s, int32_t step) { step == kAt ? spoil_tableau(s) : void(); }, hooks);
  CHECK(run.status == C2D_OK);
  REQUIRE(run.steps.size() == kAt + 1);
  const problem::Step &last = run.steps[kAt - 1], &stop = run.steps[kAt];
  CHECK(stop.kind == C2D_STEP_STOPPED);
  CHECK(stop.outcome == C2D_BEYOND_LIMITS);
  CHECK(stop.load == last.load);
  CHECK(problem::compare(stop, last).worst() < (sizeof(c2d::Real) == 8 ? 1e-12 : 1e-4));
  for (int i = 0; i < kAt; ++i) CHECK(run.steps[static_cast<size_t>(i)].table == sound.steps[static_cast<size_t>(i)].table);
  CHECK(run.summary.breach == C2D_BREACH_TABLEAU);
  CHECK(run.summary.tableau_rebuilds % 4 == 0); // all rounds of each repair
  CHECK(run.summary.tableau_rebuilds > 0);
  CHECK(run.summary.tableau_rebuilds == repairs);
}

TEST_CASE("judge: a change that is beyond the limits is shown to nobody, and the rows are those of a sound path") {
  const Deck deck = deck_named("sample");
  const auto shown = [](const Run& run, bool change) {
    std::vector<problem::Step> steps;
    for (const problem::Step& step : run.steps)
      if ((step.kind == C2D_STEP_CHANGE) == change) steps.push_back(step);
    return steps;
  };
  Hooks hooks;
  hooks.before = [](c2d_solver* s) { s->model.coefficients = 1, s->options.every_change = 1; };
  int64_t asked = 0, at = -1;
  hooks.asked = [&](c2d_solver* s) {
    if (asked++ == at) spoil_tableau(s);
  };
  const Run sound(deck, nullptr, hooks);
  const std::vector<problem::Step> rows = shown(sound, false), changes = shown(sound, true);
  REQUIRE(changes.size() > 10);
  const int64_t all = asked;
  for (at = 1; at < all; at += 1 + all / 12) {
    CAPTURE(at);
    asked = 0;
    const Run spoilt(deck, nullptr, hooks);
    CHECK(spoilt.summary.outcome == C2D_REACHED);
    const std::vector<problem::Step> found = shown(spoilt, false);
    REQUIRE(found.size() == rows.size());
    for (size_t i = 0; i < rows.size(); ++i)
      CHECK(problem::compare(found[i], rows[i]).worst() < (sizeof(c2d::Real) == 8 ? 1e-10 : 1e-3));
    for (const problem::Step& change : shown(spoilt, true)) { // each is one of the sound path's
      double nearest = 1;
      for (const problem::Step& known : changes)
        if (std::fabs(known.load - change.load) < 1e-6) nearest = std::min(nearest, problem::compare(known, change).worst());
      CHECK(nearest < (sizeof(c2d::Real) == 8 ? 1e-10 : 1e-3));
    }
  }
}

TEST_CASE("judge: equations that are spoilt at any event end the path there, before a jump too") {
  for (const char* name : {"sample", "../hard/F5_lets_go_of_friction", "../hard/D2_unload_3-41"}) {
    CAPTURE(std::string(name));
    const Deck deck = deck_named(name);
    int64_t asked = 0, at = -1;
    Hooks hooks;
    hooks.before = [](c2d_solver* s) { s->model.coefficients = 1; };
    hooks.asked = [&](c2d_solver* s) {
      if (asked++ == at) spoil_equations(s);
    };
    const Run sound(deck, nullptr, hooks);
    const int64_t all = asked;
    for (at = 0; at < all; at += 1 + all / 40) {
      CAPTURE(at);
      asked = 0;
      const Run spoilt(deck, nullptr, hooks);
      CHECK(spoilt.status == C2D_OK);
      REQUIRE(spoilt.steps.size() <= sound.steps.size());
      if (spoilt.summary.outcome == sound.summary.outcome) continue; // nothing was loaded
      CHECK(spoilt.summary.outcome == C2D_BEYOND_LIMITS);
      CHECK(spoilt.summary.breach == C2D_BREACH_EQUATIONS);
      for (size_t i = 0; i + 1 < spoilt.steps.size(); ++i) CHECK(spoilt.steps[i].table == sound.steps[i].table);
    }
  }
}

TEST_CASE("judge: bodies that float do so again where what they come to is beyond the limits") {
  many::Model m;
  m.add(many::rectangle(0, -1, 2, 0, {1, 1, 2, 1}));
  m.add(many::rectangle(0, 0.1, 2, 1.1, {2, 1, 1, 1}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  std::vector<int32_t> order;
  std::stringstream text(many::deck_of(m, "hovers", order));
  Deck deck;
  for (std::string line; std::getline(text, line);) deck.lines.push_back(line);
  CHECK(Run(deck).summary.outcome == C2D_REACHED);
  Hooks hooks;
  hooks.before = spoil_equations;
  hooks.after = [](c2d_solver* s) { CHECK(s->floating == 1); };
  const Run run(deck, nullptr, hooks);
  CHECK(run.status == C2D_OK);
  REQUIRE(run.steps.size() == 1);
  CHECK(run.steps[0].kind == C2D_STEP_STOPPED);
  CHECK(run.steps[0].outcome == C2D_BEYOND_LIMITS);
  CHECK(run.steps[0].load == 0);
  CHECK(run.summary.breach == C2D_BREACH_EQUATIONS);
}

// What is tried to find rates, and found wanting, is taken back with a new tableau.
TEST_CASE("judge: the next event where no new tableau has pivots is here, and the path goes nowhere") {
  for (const char* name : {"../hard/D2_loose_41-21", "../coarse/pad"}) {
    CAPTURE(std::string(name));
    Hooks hooks;
    hooks.after = [&](c2d_solver* s) {
      const double mu = 0.3;
      const std::vector<double> way(static_cast<size_t>(summary_of(s).load_cases), -1.0);
      const int32_t cases = static_cast<int32_t>(way.size());
      double step = 7, pressure = 7;
      REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
      lose_matrix(s);
      CHECK(c2d_next_event(s, way.data(), cases, &step) == C2D_OK);
      CHECK(s->unsound == 1);
      CHECK(step == 0.0);
      CHECK(summary_of(s).load == 0.0);
      for (int32_t i = 1; i <= summary_of(s).pairs; ++i) {
        CHECK(c2d_get(s, C2D_TN, 0, i, 1, &pressure, 1) == C2D_OK);
        CHECK(pressure == 0.0);
      }
      c2d_outcome outcome = C2D_REACHED;
      CHECK(c2d_advance(s, way.data(), cases, &outcome) == C2D_OK);
      CHECK(outcome == C2D_BEYOND_LIMITS);
    };
    Run(deck_named(name), nullptr, hooks);
  }
}

TEST_CASE("judge: a path goes the same way where no energies are kept") {
  for (const char* name : {"sample", "hertz_lin_l", "../hard/F5_lets_go_of_friction", "../hard/W1_arc_1_1_3_3_4_0.25"})
    for (const bool by_deck : {false, true}) {
      CAPTURE(std::string(name));
      CAPTURE(by_deck);
      const Deck deck = deck_named(name);
      const auto run = [&](bool keeps) {
        Hooks hooks;
        hooks.before = [=](c2d_solver* s) {
          REQUIRE(s->keeps_energy == 1);
          s->keeps_energy = keeps ? 1 : 0;
          s->options.stepping = by_deck ? C2D_STEPPING_DECK : C2D_STEPPING_EVENTS;
        };
        return Run(deck, nullptr, hooks);
      };
      const Run with = run(true), without = run(false);
      REQUIRE(with.steps.size() == without.steps.size());
      for (size_t i = 0; i < with.steps.size(); ++i) CHECK(with.steps[i].table == without.steps[i].table);
      CHECK(with.summary.outcome == without.summary.outcome);
    }
}

TEST_CASE("judge: small pivots change no digit beyond the tenth, whatever the memory") {
  // Before every state was judged, the slip of these rows was 10 % wrong, and another with every size of memory.
  const std::string text = problem::deck_text("../judge/drifting.dat");
  const problem::Result whole = problem::solve_text(text);
  REQUIRE(whole.status == C2D_OK);
  CHECK(whole.summary.max_residual < 1e-12);
  CHECK(whole.summary.force_error < 1e-11);
  for (uint64_t bytes : {uint64_t(0), uint64_t(60) << 10, uint64_t(100) << 10, uint64_t(200) << 10}) {
    CAPTURE(bytes);
    problem::Setup setup;
    setup.memory = problem::Memory::minimum;
    setup.bytes = bytes;
    const problem::Result r = problem::solve_text(text, setup);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(r.outcome == whole.outcome);
    CHECK(problem::compare(r, whole).worst() < 1e-10);
  }
}

TEST_CASE("judge: a path that meets equations without a solution keeps its rows") {
  const problem::Result r = problem::solve_text(problem::deck_text("../judge/on_an_arc.dat"));
  CHECK_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.outcome != C2D_REACHED);
  REQUIRE(r.steps.size() == 1);
  CHECK(r.steps[0].kind == C2D_STEP_STOPPED);
  CHECK(r.steps[0].load < 1);
  for (double number : r.steps[0].table) CHECK(std::fabs(number) < 1e6);
}

TEST_CASE("judge: the balance of forces where nothing is loaded") {
  problem::Problem p = problem::load("sample.dat");
  const problem::Result loaded = problem::solve(problem::with_paths(p, {{1, 1.0}}));
  CHECK(loaded.summary.force_contact > 1);
  CHECK(loaded.summary.force_error < 1e-11);
  const problem::Result back = problem::solve(problem::with_paths(p, {{1, 1.0}, {1, 0.0}}));
  REQUIRE(back.status == C2D_OK);
  CHECK(back.summary.force_contact < 1e-9 * loaded.summary.force_contact);
  CHECK(back.summary.force_error == 0.0);
}

namespace {

// A strip [0, 1] x [0, t] held on its left, in a state of constant stress or of bending that is exact in the discrete
// equations: how much of the largest displacement is wrong, and what was said.
struct Strip {
  double error, condition;
  bool warned;
};

Strip strip(double t, int32_t functions, bool bending) {
  problem::Problem p;
  p.analysis = C2D_ANALYSIS_STRESS;
  p.function_nodes = functions;
  p.bodies.resize(1);
  problem::add_polygon(p.bodies[0], {{0, 0, 10}, {1, 0, 1}, {1, t, 10}, {0, t, 1}});
  const double g = 1000 / 2.6, nu = 0.3, k = 2 / t;
  const auto stress = [&](double y, double s[3]) {
    s[0] = bending ? k * (y - t / 2) : 3.0, s[1] = bending ? 0.0 : -4.6, s[2] = bending ? 0.0 : 0.6;
  };
  const auto displacement = [&](double x, double y, double u[2]) {
    const double c = y - t / 2, e = (1 - nu) / (2 * g) * k;
    u[0] = bending ? e * x * c : ((1 - nu) * 3.0 + nu * 4.6) / (2 * g) * x;
    u[1] = bending ? -e * x * x / 2 - nu / (2 * g) * k * c * c / 2 : (-(1 - nu) * 4.6 - nu * 3.0) / (2 * g) * y + 0.6 / g * x;
  };
  std::vector<double> wanted;
  problem::set_ends(p, 1, [&](double x, double y, double nx, double ny, problem::End& end) {
    double s[3], u[2];
    stress(y, s);
    displacement(x, y, u);
    const bool held = nx < -0.5, corner = x == 0;
    const double traction[2] = {s[0] * nx + s[2] * ny, s[2] * nx + s[1] * ny};
    for (int c = 0; c < 2; ++c) {
      end.codes[c] = held ? 1 : 0;
      end.codes[2 + c] = held || corner ? 0 : 1;
      if (!held) end.values[c] = traction[c];
      if (held || corner) end.values[2 + c] = u[c];
      wanted.push_back(u[c]);
    }
  });
  const problem::Result r = problem::solve(p);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  double worst = 0, size = 0;
  for (size_t i = 0; i < r.boundary[0].size(); ++i) {
    const problem::EndResult& end = r.boundary[0][i];
    worst = std::max(worst, std::max(std::fabs(end.ux - wanted[2 * i]), std::fabs(end.uy - wanted[2 * i + 1])));
    size = std::max(size, std::max(std::fabs(wanted[2 * i]), std::fabs(wanted[2 * i + 1])));
  }
  return {worst / size, r.summary.condition, r.warned(C2D_WARN_CONDITION)};
}

} // namespace

TEST_CASE("judge: a strip however thin is right, or the loss of digits is told and bounds the error") {
  // Thickness 1e-5, quadratic functions: once wrong by 220 % without a word, at a ratio of pivots of 6e8.
  if (sizeof(c2d::Real) != 8) return;
  for (int32_t functions : {2, 3, 4})
    for (bool bending : {false, true})
      for (double t : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        if (bending && functions == 2) continue; // linear functions do not hold it
        CAPTURE(functions);
        CAPTURE(bending);
        CAPTURE(t);
        const Strip s = strip(t, functions, bending);
        CAPTURE(s.condition);
        CHECK(s.error < 1e-11 + c2d::kDigit * s.condition);
        CHECK(s.warned == (c2d::kDigit * s.condition > 1e-6));
        if (t >= 0.01) CHECK_FALSE(s.warned);
        if (t >= 0.01) CHECK(s.error < 1e-8);
        if (s.error > 1e-6) CHECK(s.warned);
      }
}
