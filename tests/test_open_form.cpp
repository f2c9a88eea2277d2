// The contact system with every pair open (METHOD 10.11) against that with every pair sticking, of the same bodies' equations.
#include "contact/asleep.hpp"
#include "contact/basis.hpp"
#include "contact/reduction/open_form.hpp"
#include "contact/reduction/reduction.hpp"
#include "family_runs.hpp"
#include "many_bodies.hpp"
#include "reduction_by_hand.hpp"
#include "solver/judge.hpp"
#include "solver/session.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace runs;

namespace {

constexpr double kAlike = sizeof(c2d::Real) == 8 ? 1e-9 : 1e-2;

std::string family(const std::string& name, const std::vector<std::string>& settings) {
  std::string text, error;
  REQUIRE_MESSAGE(families::make_deck(name, settings, text, error), error);
  return text;
}
std::string deck_of(const many::Model& m) {
  std::vector<int32_t> order;
  return many::deck_of(m, "open", order);
}

struct Solver {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  Deck deck;
  std::unique_ptr<Machine> machine;
  c2d_solver* s = nullptr;
  explicit Solver(const std::string& text) {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
    store.serve(port);
    const host::Limits limits = deck.limits();
    uint64_t in_core = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &in_core, nullptr) == C2D_OK);
    machine = std::make_unique<Machine>(limits, in_core, &port);
    s = machine->solver;
    c2d_options options = C2D_INIT(c2d_options);
    options.keep_factors = 1;
    REQUIRE(c2d_set_options(s, &options) == C2D_OK);
    REQUIRE_MESSAGE(read_deck(s, deck) == C2D_OK, error_of(s).text);
    REQUIRE_MESSAGE(c2d_prepare(s) == C2D_OK, error_of(s).text);
  }
};

std::vector<double> run(Solver& solver, c2d_outcome& outcome) {
  Numbers out;
  REQUIRE(run_prepared(solver.s, out) == C2D_OK);
  outcome = out.outcome;
  std::vector<double> all = out.steps;
  all.insert(all.end(), out.boundary.begin(), out.boundary.end());
  return all;
}

// Two bodies between walls: a roof on which the one lies that is pressed, both free to move.
many::Model wedged(int32_t on_the_floor = 60, int32_t on_the_wall = 30) {
  using namespace many;
  Model m;
  m.add(rectangle(0, -2, 2, 0, {10, 10, on_the_floor, 10}));         // floor
  m.add(rectangle(2, 0, 3, 1, {5, 8, 5, on_the_wall}));              // wall
  m.add(rectangle(0, 0, 2, 1, {on_the_floor, on_the_wall, 20, 10})); // block
  m.join(C2D_ZONE_MATCHING, 1, 3, 3, 1);
  m.join(C2D_ZONE_MATCHING, 2, 4, 3, 2);
  m.zones.back().without[1] = 1; // the corner is on the floor
  m.set(1, 1, end_of(kHeld));
  m.set(2, 2, end_of(kHeld));
  m.set(3, 3, end_of(kPulled, 0, -1));
  m.set(3, 4, end_of(kPulled, 0.4, 0));
  m.friction = 0.3;
  return m;
}

// A block in a trough of this depth, which alone keeps it from moving aside.
many::Model in_a_trough(double depth) {
  using namespace many;
  Model m;
  m.add(polygon({{0, -2, 8}, {2, -2, 8}, {2, 0, 45}, {1, -depth, 45}, {0, 0, 8}}));
  m.add(polygon({{0, 0, 45}, {1, -depth, 45}, {2, 0, 8}, {2, 1, 8}, {0, 1, 8}}));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 2);
  m.join(C2D_ZONE_MATCHING, 1, 4, 2, 1);
  m.zones.back().without[0] = 1;
  m.set(1, 1, end_of(kHeld));
  m.set(2, 4, end_of(kPulled, 0, -1));
  m.friction = 0.3;
  return m;
}

// A column of width 1, held at its foot, and a block on it that is pressed and pushed.
many::Model on_a_column(double height, double mu) {
  using namespace many;
  Model m;
  m.add(rectangle(0, -height, 1, 0, {8, 40, 90, 40}));
  m.add(rectangle(0, 0, 1, 1, {90, 10, 10, 10}));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of("1001", 0, -1));
  m.friction = mu;
  return m;
}

// Half a layer on a base that hardly gives way, `length` times as long as thick.
std::string layer(const std::string& length) { return family("layer_lifted", {"n=28", "order=1", "L=" + length}); }

} // namespace

TEST_CASE("open form: the same contact system as with every pair sticking") {
  const struct {
    std::string text;
    bool sliding;
    int32_t motions;
  } models[] = {{family("hertz", {"n=70"}), true, 1},
                {family("hertz", {"n=70", "order=2", "symmetry=line"}), true, 1},
                {family("mindlin", {"n=36"}), false, 1},
                {deck_of(wedged()), false, 3},
                {family("disc_in_hole", {"n=100"}), true, 0}};
  for (const auto& model : models) {
    CAPTURE(model.text.substr(0, 200));
    Solver solver(model.text);
    REQUIRE(solver.s->open == 1);
    REQUIRE((solver.s->sliding != 0) == model.sliding);
    ByHand open(solver.s, model.sliding);
    const std::vector<c2d::Real> t = open.tableau();
    std::vector<c2d::Real> column(static_cast<size_t>(open.m));
    c2d::Form form;
    REQUIRE(c2d::read_form(open.r.tape, column.data(), &form) == C2D_OK);
    CHECK(form.count == model.motions);
    ByHand closed(solver.s, model.sliding);
    closed.r.open = false;
    REQUIRE(c2d::reduce(closed.r) == C2D_OK);
    const std::vector<c2d::Real> stick = closed.tableau();
    // For any motions and loads: forces of the one put into the other give these motions again.
    const size_t m = static_cast<size_t>(open.m), cases = static_cast<size_t>(open.model.head->load_cases);
    const auto sum = [&](const std::vector<c2d::Real>& from, const std::vector<double>& z, size_t row) {
      double out = 0;
      for (size_t j = 0; j < m + cases; ++j) out += static_cast<double>(from[j * m + row]) * z[j];
      return out;
    };
    const auto slides = [&](size_t i) { return model.sliding && c2d::is_sliding_slot(open.model, static_cast<int32_t>(i)); };
    const auto held = [&](size_t i) { return c2d::has_force(form, open.model, static_cast<int32_t>(i)); };
    for (int turn = 0; turn < 3; ++turn) {
      std::vector<double> motion(m + cases), given(m + cases);
      for (size_t i = 0; i < m; ++i) motion[i] = slides(i) ? 0 : std::sin(0.1 * (turn + 1) * static_cast<double>(i) + turn);
      for (size_t k = 0; k < cases; ++k) given[m + k] = motion[m + k] = turn - 1.0;
      std::vector<double> force(m), rest(m);
      for (size_t i = 0; i < m; ++i) (slides(i) ? rest : force)[i] = sum(stick, motion, i);
      for (size_t i = 0; i < m; ++i)
        if (!slides(i)) rest[i] = motion[i];
      double size[2] = {0, 0};
      for (size_t i = 0; i < m; ++i) {
        given[i] = held(i) ? rest[i] : force[i];
        size[0] = std::max(size[0], std::fabs(rest[i]));
        size[1] = std::max(size[1], std::fabs(force[i]));
      }
      double off = 0;
      for (size_t i = 0; i < m; ++i)
        off = std::max(off, std::fabs(sum(t, given, i) - (held(i) ? force[i] : rest[i])) / size[held(i) ? 1 : 0]);
      CHECK(off < kAlike);
    }
  }
}

TEST_CASE("open form: the same path as from every pair sticking") {
  const std::string texts[] = {family("hertz", {"n=70"}),
                               family("mindlin", {"n=36"}),
                               deck_of(wedged()),
                               family("disc_in_hole", {"n=100"}),
                               deck_of(on_a_column(1, 0.3)),
                               deck_of(on_a_column(1, 0)),
                               deck_of(on_a_column(5, 0.3)),
                               deck_of(wedged(100, 1)),
                               deck_of(wedged(100, 2)),
                               layer("6")};
  for (const std::string& text : texts) {
    CAPTURE(text.substr(0, 200));
    Solver open(text), closed(text);
    REQUIRE(open.s->open == 1);
    ByHand sticking(closed.s, closed.s->sliding != 0);
    sticking.r.open = false;
    REQUIRE(c2d::reduce(sticking.r) == C2D_OK);
    REQUIRE(c2d::build_judge(closed.s) == C2D_OK);
    REQUIRE(closed.s->open == 0);
    c2d_outcome ends[2];
    const std::vector<double> a = run(open, ends[0]), b = run(closed, ends[1]);
    CHECK(ends[0] == ends[1]);
    REQUIRE(a.size() == b.size());
    double off = 0, size = 0;
    for (size_t i = 0; i < a.size(); ++i) {
      off = std::max(off, std::fabs(a[i] - b[i]));
      size = std::max(size, std::fabs(b[i]));
    }
    CHECK(off < kAlike * size);
    CHECK(summary_of(open.s).max_residual < 1e-13);
    CHECK(open.s->stats.events == closed.s->stats.events);
    if (open.s->stats.events > 50) CHECK(open.s->exchanges < closed.s->exchanges); // most pairs are open for long
  }
}

TEST_CASE("open form: not where a body bends much more than it gives way, nor where it slides freely, or nearly") {
  CHECK(Solver(deck_of(on_a_column(1, 0.3))).s->open == 1);
  CHECK(Solver(deck_of(on_a_column(60, 0.3))).s->open == 0);
  CHECK(Solver(layer("12")).s->open == 0);
  many::Model flat = on_a_column(1, 0.3);
  flat.set(2, 3, many::end_of(many::kPulled, 0, -1)); // the block is held by friction alone
  CHECK(Solver(deck_of(flat)).s->open == 0);
  CHECK(Solver(deck_of(in_a_trough(0.5))).s->open == 1);
  CHECK(Solver(deck_of(in_a_trough(0.02))).s->open == 0);
  many::Model guided = in_a_trough(1e-6); // it can move in this one way
  guided.set(2, 4, many::end_of("0110", 0, 0, 0, -1e-3));
  CHECK(Solver(deck_of(guided)).s->open == 0);
  Solver tied(family("coating", {"n=24"}));
  CHECK(tied.s->open == 0);
}

namespace {

// So many draws of statuses for the tableau of a path that has begun. What holds the bodies on the tape is one thing after
// another.
int32_t count_asleep(const c2d::Tableau& t) {
  int32_t count = 0;
  for (int32_t i = 0; i < t.pairs; ++i) count += c2d::is_asleep(t, i);
  return count;
}

struct Draws {
  c2d::Session session;
  uint32_t state = 7;
  int32_t asleep = 0; // before they were woken
  explicit Draws(c2d_solver* s) { c2d::open_session(s, session); }
  uint32_t next() { return state = state * 1664525u + 1013904223u, state >> 16; }
  void take(c2d::Pair& pair, uint32_t which) {
    constexpr int8_t kStatus[] = {C2D_OPEN, C2D_STICK, C2D_SLIP, C2D_SLIP}, kSign[] = {0, 0, 1, -1};
    pair.status = kStatus[which];
    pair.sign = kSign[which];
    pair.offset = pair.status == C2D_STICK ? static_cast<c2d::Real>(1e-4 * (next() % 7)) : c2d::Real(0);
  }
  // All columns of the tableau, forces in units of a stiffness.
  std::vector<double> tableau(uint32_t draw, const c2d::Form& form, double stiffness, c2d_status& status) {
    c2d::Tableau& t = session.tableau;
    state = draw;
    for (int32_t i = 0; i < t.pairs; ++i) take(t.pair[i], next() % 4);
    for (int32_t i = 0; i < form.count; ++i)
      for (int32_t p = 0; p < t.pairs; ++p)
        if (t.pair[p].dof == form.held[i]) take(t.pair[p], draw % 4);
    t.guided = 0; // every third time a pair slides along with a body that is free to
    for (int32_t p = t.pairs - 1; p >= 0 && draw % 3 == 0; --p)
      if (t.pair[p].status == C2D_SLIP && t.pair[p].tangential &&
          (t.guided == 0 || c2d::has_force(form, session.model, t.pair[p].dof)))
        t.guided = p + 1; // one that holds a body, if there is such a one
    int32_t culprit = -1;
    status = c2d::build_tableau(t, session.tape, &culprit);
    asleep = count_asleep(t);
    if (status == C2D_OK) status = c2d::wake_all(session.follower);
    std::vector<double> out;
    const auto add = [&](int32_t j, bool of_force) {
      for (int32_t i = 0; i < t.m; ++i)
        out.push_back(static_cast<double>(t.t[static_cast<int64_t>(j) * t.m + i]) / (is_force(i) ? stiffness : 1) *
                      (of_force ? 1 : stiffness));
    };
    for (int32_t p = 0; p < t.pairs && status == C2D_OK; ++p)
      for (int slot = 0; slot <= t.pair[p].tangential; ++slot) add(c2d::column_of(t, p, slot), is_force(t.pair[p].dof + slot));
    for (int32_t j = t.n; j < c2d::tableau_columns(t.n, t.cases) && status == C2D_OK; ++j) add(j, true);
    return out;
  }
  bool is_force(int32_t slot) const { // in a row
    const c2d::Tableau& t = session.tableau;
    for (int32_t p = 0;; ++p)
      if (slot <= t.pair[p].dof + t.pair[p].tangential)
        return slot == t.pair[p].dof ? t.pair[p].status != C2D_OPEN : t.pair[p].status == C2D_STICK || t.guided == p + 1;
  }
};

} // namespace

TEST_CASE("open form: the tableau of any statuses, from either form of the tape") {
  for (const std::string& text : {family("mindlin", {"n=36"}), deck_of(wedged())}) {
    CAPTURE(text.substr(0, 200));
    Solver solver(text);
    const double mu = 0.3;
    REQUIRE(c2d_begin(solver.s, &mu, 1) == C2D_OK);
    Draws draws(solver.s);
    std::vector<c2d::Real> column(static_cast<size_t>(draws.session.tableau.m));
    c2d::Form form;
    REQUIRE(c2d::read_form(draws.session.tape, column.data(), &form) == C2D_OK);
    REQUIRE(form.count > 0);
    const double stiffness = draws.session.tableau.stiffness;
    std::vector<std::vector<double>> open;
    std::vector<c2d_status> built;
    for (uint32_t draw = 1; draw <= 12; ++draw) {
      built.push_back(C2D_OK);
      open.push_back(draws.tableau(draw, form, stiffness, built.back()));
      CHECK(draws.asleep > draws.session.tableau.pairs / 8); // a quarter is open
    }
    ByHand sticking(solver.s, false);
    sticking.r.open = false;
    REQUIRE(c2d::reduce(sticking.r) == C2D_OK);
    for (uint32_t draw = 1; draw <= 12; ++draw) {
      CAPTURE(draw);
      c2d_status status = C2D_OK;
      const std::vector<double> closed = draws.tableau(draw, form, stiffness, status);
      CHECK(status == built[draw - 1]);
      CHECK(draws.asleep == 0);
      REQUIRE(closed.size() == open[draw - 1].size());
      double off = 0, size = 0;
      for (size_t i = 0; i < closed.size(); ++i) {
        off = std::max(off, std::fabs(closed[i] - open[draw - 1][i]));
        size = std::max(size, std::fabs(closed[i]));
      }
      CHECK(off < kAlike * size);
    }
    // What pivots are judged by is told from T's own entries here, else from A.
    CHECK(stiffness < 4 * draws.session.tableau.stiffness);
    CHECK(draws.session.tableau.stiffness < 4 * stiffness);
  }
}

// Columns of nothing: pairs that give way to no force of their own.
TEST_CASE("open form: a pair that does not give way cannot come in, and is named") {
  Solver solver(deck_of(wedged()));
  const double mu = 0.3;
  REQUIRE(c2d_begin(solver.s, &mu, 1) == C2D_OK);
  Draws draws(solver.s);
  c2d::Tableau& t = draws.session.tableau;
  const size_t m = static_cast<size_t>(t.m);
  std::vector<c2d::Real> column(m), kept(m);
  const std::vector<c2d::Real> nothing(m);
  c2d::Form form;
  REQUIRE(c2d::read_form(draws.session.tape, column.data(), &form) == C2D_OK);
  int32_t held = 0;
  while (t.pair[held].dof != form.held[0]) ++held;
  const int32_t free = held == 20 ? 21 : 20;
  // (That A says so of a pair, too, is no division by zero.)
  REQUIRE(c2d::write_column(draws.session.tape, c2d::ContactMatrix::compliance, t.pair[free].dof, nothing.data()) == C2D_OK);
  const struct {
    int32_t pair, slot;
    uint32_t status;
  } ways[] = {{free, 0, 1}, {free, 0, 2}, {held, 1, 1}, {held, 1, 3}};
  for (const auto& way : ways) {
    CAPTURE(way.pair);
    CAPTURE(way.status);
    const int32_t dof = t.pair[way.pair].dof + way.slot;
    REQUIRE(c2d::read_column(draws.session.tape, c2d::ContactMatrix::stiffness, dof, kept.data()) == C2D_OK);
    REQUIRE(c2d::write_column(draws.session.tape, c2d::ContactMatrix::stiffness, dof, nothing.data()) == C2D_OK);
    for (int32_t i = 0; i < t.pairs; ++i) draws.take(t.pair[i], i == way.pair ? way.status : 0);
    int32_t culprit = -1;
    // (friction pushes along a column that is left: the normal alone is not enough to be stiff)
    if (way.status == 2) t.pair[way.pair].law.mu = 0;
    CHECK(c2d::build_tableau(t, draws.session.tape, &culprit) == C2D_ERR_SINGULAR);
    CHECK(culprit == way.pair);
    t.pair[way.pair].law.mu = 0.3;
    REQUIRE(c2d::write_column(draws.session.tape, c2d::ContactMatrix::stiffness, dof, kept.data()) == C2D_OK);
  }
}

TEST_CASE("open form: whichever operation of the store fails while a tableau is built, that is told") {
  Solver solver(family("mindlin", {"n=36"}));
  const double mu = 0.3;
  REQUIRE(c2d_begin(solver.s, &mu, 1) == C2D_OK);
  Draws draws(solver.s);
  const size_t first = solver.store.done.size();
  const auto build = [&] {
    int32_t culprit = -1;
    const c2d_status status = c2d::build_tableau(draws.session.tableau, draws.session.tape, &culprit);
    return status == C2D_OK ? c2d::wake_all(draws.session.follower) : status;
  };
  REQUIRE(build() == C2D_OK);
  const size_t operations = solver.store.done.size() - first;
  REQUIRE(operations > 2 * static_cast<size_t>(draws.session.tableau.m));
  for (size_t n = 0; n < operations; n += n < 5 || n + 10 > operations ? 1 : 7) {
    CAPTURE(n);
    const size_t at = solver.store.done.size() + n;
    solver.store.before = [at](const RamStore::Operation&, size_t i) { return i == at ? 7 : 0; };
    CHECK(build() == C2D_ERR_STORE_READ);
    solver.store.before = nullptr;
  }
  CHECK(build() == C2D_OK);
}

namespace {

// The block of the tape that says what is basic.
uint64_t block_of_basis(Solver& solver) {
  Draws draws(solver.s);
  std::vector<c2d::Real> column(static_cast<size_t>(draws.session.tableau.m));
  c2d::Form form;
  REQUIRE(c2d::read_form(draws.session.tape, column.data(), &form) == C2D_OK);
  return solver.store.done.back().block;
}

} // namespace

TEST_CASE("open form: whichever read of what is basic fails, that is told") {
  // Held by friction alone and pushed off, or not: the search for what moves asks, too.
  many::Model pushed = on_a_column(1, 0.3);
  pushed.set(2, 3, many::end_of(many::kPulled, 0.5, -1));
  for (const std::string& text : {deck_of(pushed), family("mindlin", {"n=36"})}) {
    Solver first(text);
    const uint64_t basis = block_of_basis(first);
    const double mu = 0.3;
    int asked = 0, told = 0;
    for (int n = 0; n <= asked; ++n) { // the last one fails nowhere
      CAPTURE(n);
      Solver solver(text);
      REQUIRE(c2d_change_loads(solver.s) == C2D_OK);
      int seen = 0;
      solver.store.before = [&seen, n, basis](const RamStore::Operation& o, size_t) {
        return o.tape == C2D_TAPE_CONTACT && o.kind == 'r' && o.block == basis && seen++ == n ? 7 : 0;
      };
      Numbers out;
      c2d_status status = c2d_prepare(solver.s);
      if (status == C2D_OK) status = c2d_begin(solver.s, &mu, 1);
      if (status == C2D_OK) status = run_prepared(solver.s, out);
      asked = std::max(asked, seen);
      told += status == C2D_ERR_STORE_READ;
      CHECK((status == C2D_ERR_STORE_READ) == (seen > n));
      solver.store.before = nullptr;
    }
    CHECK(asked > 1);
    CHECK(told == asked);
  }
}

TEST_CASE("open form: loads that move bodies as if rigid press nothing, free bodies or held ones") {
  many::Model raised = on_a_column(1, 0.3); // the block, free to go up, goes along with the foot of the column
  raised.set(1, 1, many::end_of("1100", 0, 0, 0, 0.01));
  raised.set(2, 3, many::end_of("1001"));
  many::Model shifted = on_a_column(1, 0.3); // both are held, and moved alike
  shifted.set(1, 1, many::end_of("1100", 0, 0, 0.01, 0.02));
  shifted.set(2, 3, many::end_of("1100", 0, 0, 0.01, 0.02));
  for (const many::Model& m : {raised, shifted}) {
    Solver solver(deck_of(m));
    REQUIRE(solver.s->open == 1);
    const double mu = 0.3, load = 1;
    REQUIRE(c2d_begin(solver.s, &mu, 1) == C2D_OK);
    c2d_outcome outcome = C2D_UNDECIDED;
    REQUIRE_MESSAGE(c2d_advance(solver.s, &load, 1, &outcome) == C2D_OK, error_of(solver.s).text);
    CHECK(outcome == C2D_REACHED);
    const int32_t pairs = summary_of(solver.s).pairs;
    std::vector<double> tn(static_cast<size_t>(pairs)), moved(tn);
    REQUIRE(c2d_get(solver.s, C2D_TN, 1, 1, pairs, tn.data(), 1) == C2D_OK);
    REQUIRE(c2d_get(solver.s, C2D_UN1, 1, 1, pairs, moved.data(), 1) == C2D_OK);
    for (size_t i = 0; i < tn.size(); ++i) {
      CHECK(tn[i] == 0);
      CHECK(std::fabs(moved[i]) > 0.009);
    }
  }
}

TEST_CASE("open form: not of more free motions than there is room to hold") {
  many::Model m;
  m.add(many::rectangle(0, -1, 10, 0, {10, 2, 100, 2}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.friction = 0.3;
  for (int i = 0; i < 5; ++i) {
    m.add(many::rectangle(2 * i, 0, 2 * i + 1.8, 1, {18, 4, 4, 4}));
    m.set(i + 2, 3, many::end_of(many::kPulled, 0, -1));
    const int32_t right = m.side(1, 3).first + (4 - i) * 20 + 2; // of the floor's elements the one at the block's right
    const many::Range under = m.side(i + 2, 1);
    m.zones.push_back({C2D_ZONE_MATCHING, {{1, right, right + 17}, {i + 2, under.last, under.first}}});
  }
  Solver solver(deck_of(m));
  REQUIRE(solver.s->model.motions == 15);
  REQUIRE(solver.s->model.border == 0);
  CHECK(solver.s->open == 0);
}

TEST_CASE("open form: of more slots said to have forces than motions can be held so many are listed") {
  Solver solver(deck_of(wedged()));
  Draws draws(solver.s);
  std::vector<c2d::Real> basis(static_cast<size_t>(draws.session.tableau.m), c2d::kBasisForce);
  basis.back() = c2d::kBasisMotion;
  REQUIRE(c2d::write_column(draws.session.tape, c2d::ContactMatrix::basis, 0, basis.data()) == C2D_OK);
  c2d::Form form;
  REQUIRE(c2d::read_form(draws.session.tape, basis.data(), &form) == C2D_OK);
  CHECK(form.open);
  CHECK(form.count == c2d::kMostHeld);
}

TEST_CASE("open form: friction that a stranger has put where the tape has none is no reason to leave columns out") {
  Solver solver(family("hertz", {"n=70"}));
  const double mu = 0;
  REQUIRE(c2d_begin(solver.s, &mu, 1) == C2D_OK);
  Draws draws(solver.s);
  c2d::Tableau& t = draws.session.tableau;
  int32_t culprit = -1;
  REQUIRE(c2d::build_tableau(t, draws.session.tape, &culprit) == C2D_OK);
  CHECK(t.smooth);
  for (int32_t i = 0; i < t.pairs; ++i) t.pair[i].law.mu = 0.3;
  c2d::build_tableau(t, draws.session.tape, &culprit);
  CHECK_FALSE(t.smooth);
  CHECK(t.delayed.cols == t.n);
}

TEST_CASE("open form: what no normal moves along with is not held") {
  Solver solver(deck_of(wedged()));
  ByHand hand(solver.s, false);
  std::vector<c2d::Real> motion(static_cast<size_t>(hand.m));
  for (int32_t k = 0; k < 3; ++k) {
    REQUIRE(c2d::read_column(hand.r.tape, c2d::ContactMatrix::motions, k, motion.data()) == C2D_OK);
    for (int32_t i = 0; i < hand.model.head->pairs; ++i) motion[static_cast<size_t>(hand.model.pair[i].dof)] = 0;
    REQUIRE(c2d::write_column(hand.r.tape, c2d::ContactMatrix::motions, k, motion.data()) == C2D_OK);
  }
  CHECK(c2d::form_open_stiffness(hand.r) == C2D_ERR_SINGULAR);
}

// ---- pairs that sleep (contact/asleep.hpp) --------------------------------------------------------------------------------

namespace {

void begin(Solver& solver, double mu) { REQUIRE(c2d_begin(solver.s, &mu, 1) == C2D_OK); }
c2d_status advance(c2d_solver* s, double load) { // of the first case
  c2d_outcome outcome = C2D_UNDECIDED;
  std::vector<double> factors(static_cast<size_t>(s->model.load_cases));
  factors[0] = load;
  const c2d_status status = c2d_advance(s, factors.data(), s->model.load_cases, &outcome);
  if (status == C2D_OK) CHECK(outcome == C2D_REACHED);
  return status;
}
int32_t count_asleep(c2d_solver* s) {
  c2d::Session session;
  c2d::open_session(s, session);
  return count_asleep(session.tableau);
}

} // namespace

TEST_CASE("asleep: the tableau has columns of what touches and of what is about to, few as long as few touch") {
  for (const bool friction : {true, false}) {
    CAPTURE(friction);
    Solver solver(friction ? family("mindlin", {"n=36"}) : family("hertz", {"n=140"}));
    begin(solver, friction ? 0.3 : 0);
    int32_t first = 0, before = summary_of(solver.s).pairs;
    for (const double load : {0.001, 0.1, 0.4}) {
      CAPTURE(load);
      REQUIRE(advance(solver.s, load) == C2D_OK);
      Draws draws(solver.s);
      const c2d::Tableau& t = draws.session.tableau;
      int32_t touching = 0, columns = 0;
      for (int32_t i = 0; i < t.pairs; ++i) {
        const bool asleep = c2d::is_asleep(t, i);
        touching += t.pair[i].status != C2D_OPEN;
        columns += asleep ? 0 : 1 + c2d::last_slot(t, t.pair[i]);
        if (asleep) CHECK(t.pair[i].status == C2D_OPEN);
      }
      const int32_t asleep = count_asleep(t);
      CHECK(columns == c2d::used_columns(t));
      CHECK(asleep <= before);
      CHECK(touching < t.pairs - asleep);
      CHECK(touching + 2 * t.delayed.most > t.pairs - asleep); // no more than one lot is ready beforehand
      first = std::max(first, asleep);
      before = asleep;
    }
    CHECK(before < first);
  }
}

TEST_CASE("asleep: a contact that opens again leaves few columns, and closes to the same numbers") {
  for (const double mu : {0.0, 0.3}) {
    CAPTURE(mu);
    Solver solver(family("hertz", {"n=150"}));
    begin(solver, mu);
    const int32_t pairs = summary_of(solver.s).pairs, most = c2d::delayed_exchanges(solver.s->model.contact);
    std::vector<double> first(static_cast<size_t>(pairs)), again(first);
    int32_t widest = 0;
    for (int round = 0; round < 3; ++round) {
      REQUIRE(advance(solver.s, 1) == C2D_OK);
      CHECK(c2d_get(solver.s, C2D_TN, 0, 1, pairs, (round == 0 ? first : again).data(), 1) == C2D_OK);
      widest = solver.s->awake;
      REQUIRE(advance(solver.s, 0.02) == C2D_OK);
      int32_t touching = 0;
      for (int32_t i = 0; i < pairs; ++i) touching += c2d::array_of<c2d::Pair>(solver.s, c2d::kPairs)[i].status != C2D_OPEN;
      CHECK(touching > 0);
      CHECK(solver.s->awake <= 2 * touching + 4 * most);
      CHECK(solver.s->awake < widest - most / 2);
      if (round == 0) continue;
      double size = 0, apart = 0;
      for (size_t i = 0; i < first.size(); ++i)
        size = std::fmax(size, first[i]), apart = std::fmax(apart, std::fabs(first[i] - again[i]));
      CHECK(apart < (mu == 0 ? 1e-11 : 0.02) * size); // friction remembers
    }
    CHECK(summary_of(solver.s).max_residual < 1e-12);
    CHECK(solver.s->rebuilds == 0);
  }
}

TEST_CASE("asleep: not where friction has no bound, a body is let go, rests or slides freely, nor increment by increment") {
  Solver solver(family("mindlin", {"n=36"}));
  begin(solver, INFINITY);
  REQUIRE(advance(solver.s, 0.1) == C2D_OK);
  CHECK(count_asleep(solver.s) == 0);
  begin(solver, 0.3);
  REQUIRE(advance(solver.s, 0.1) == C2D_OK);
  CHECK(count_asleep(solver.s) > 0);
  Draws draws(solver.s);
  c2d::Tableau& t = draws.session.tableau;
  int32_t culprit = -1;
  const auto built_with = [&](int32_t& number) {
    number = 1;
    const c2d_status status = c2d::build_tableau(t, draws.session.tape, &culprit);
    number = 0;
    CHECK(status == C2D_OK);
    return count_asleep(t);
  };
  CHECK(built_with(t.may_rest) == 0);
  CHECK(built_with(draws.session.free_body.slides) == 0);
  CHECK(c2d::build_tableau(t, draws.session.tape, &culprit) == C2D_OK);
  CHECK(count_asleep(t) > 0);
  for (int32_t i = 0; i < t.pairs; ++i) draws.take(t.pair[i], 0);
  CHECK(c2d::build_tableau(t, draws.session.tape, &culprit) == C2D_OK);
  CHECK(count_asleep(t) == 0);

  Solver stepping(family("mindlin", {"n=36"}));
  begin(stepping, 0.3);
  REQUIRE(advance(stepping.s, 0.01) == C2D_OK); // by events: what touches first holds the body
  c2d_options options = C2D_INIT(c2d_options);
  options.stepping = C2D_STEPPING_DECK;
  REQUIRE(c2d_set_options(stepping.s, &options) == C2D_ERR_STATE); // (not on the way)
  stepping.s->options.stepping = C2D_STEPPING_DECK;
  CHECK(count_asleep(stepping.s) > 0);
  REQUIRE(advance(stepping.s, 0.02) == C2D_OK);
  CHECK(count_asleep(stepping.s) == 0);
}

TEST_CASE("asleep: a flat face touches as a whole, lot by lot") {
  Solver solver(deck_of(on_a_column(1, 0.3)));
  begin(solver, 0.3);
  REQUIRE(count_asleep(solver.s) == 0); // all touch from the start
  Draws draws(solver.s);
  c2d::Tableau& t = draws.session.tableau;
  for (int32_t i = 0; i < t.pairs; ++i) draws.take(t.pair[i], i == 3 || i == 60 ? 1 : 0);
  int32_t culprit = -1;
  REQUIRE(c2d::build_tableau(t, draws.session.tape, &culprit) == C2D_OK);
  const int32_t asleep = count_asleep(t);
  CHECK(2 * asleep > t.pairs);
  c2d::refresh(draws.session.follower);
  for (int32_t i = 0; i < t.pairs; ++i) draws.session.follower.y[t.pair[i].dof] = 0; // no gap anywhere
  REQUIRE(c2d::wake_touching(draws.session.follower, c2d::path_scales(draws.session.follower)) == C2D_OK);
  CHECK(count_asleep(t) == 0);
  CHECK(2 * asleep > t.delayed.most); // (more than one lot)
}

TEST_CASE("asleep: whichever read of a column that wakes fails, that is told") {
  const auto at_little_load = [](Solver& solver) {
    begin(solver, 0.3);
    REQUIRE(advance(solver.s, 0.001) == C2D_OK);
    REQUIRE(count_asleep(solver.s) > 0);
  };
  int reads = 0;
  for (int n = 0; n <= reads; n += n < 8 || n + 4 > reads ? 1 : 9) {
    CAPTURE(n);
    Solver solver(family("mindlin", {"n=48"}));
    at_little_load(solver);
    int seen = 0;
    solver.store.before = [&seen, n](const RamStore::Operation& o, size_t) {
      return o.tape == C2D_TAPE_CONTACT && o.kind == 'r' && seen++ == n ? 7 : 0;
    };
    const c2d_status status = advance(solver.s, 0.3);
    CHECK(status == (seen > n ? C2D_ERR_STORE_READ : C2D_OK));
    reads = std::max(reads, seen);
    solver.store.before = nullptr;
  }
  CHECK(reads > 40);
}

TEST_CASE("asleep: a read that fails as pairs fall asleep again is told") {
  int reads = 0;
  for (int n = 0; n <= reads; ++n) {
    CAPTURE(n);
    Solver solver(family("hertz", {"n=150"}));
    begin(solver, 0);
    REQUIRE(advance(solver.s, 1) == C2D_OK);
    int seen = 0;
    solver.store.before = [&seen, n](const RamStore::Operation& o, size_t) {
      return o.tape == C2D_TAPE_CONTACT && o.kind == 'r' && seen++ == n ? 7 : 0;
    };
    const c2d_status status = advance(solver.s, 0.02);
    CHECK(status == (seen > n ? C2D_ERR_STORE_READ : C2D_OK));
    reads = std::max(reads, seen);
    solver.store.before = nullptr;
  }
  CHECK(reads > 0);
}

TEST_CASE("asleep: a saved state goes on to the same numbers, and forged columns are refused") {
  const std::string text = family("mindlin", {"n=36"});
  Solver solver(text);
  begin(solver, 0.3);
  REQUIRE(advance(solver.s, 0.1) == C2D_OK);
  REQUIRE(count_asleep(solver.s) > 0);
  REQUIRE(c2d_save(solver.s) == C2D_OK);
  const auto resumed = [&](c2d_status expected) {
    auto other = std::make_unique<Machine>(solver.deck.limits(), solver.s->bytes, &solver.port);
    REQUIRE(read_deck(other->solver, solver.deck) == C2D_OK);
    c2d_options options = C2D_INIT(c2d_options);
    options.keep_factors = 1;
    REQUIRE(c2d_set_options(other->solver, &options) == C2D_OK);
    CHECK(c2d_restore(other->solver) == expected);
    return other;
  };
  const auto pressures = [](c2d_solver* s) {
    std::vector<double> tn(static_cast<size_t>(summary_of(s).pairs));
    REQUIRE(c2d_get(s, C2D_TN, 1, 1, summary_of(s).pairs, tn.data(), 1) == C2D_OK);
    return tn;
  };
  std::vector<double> expected;
  {
    const auto other = resumed(C2D_OK);
    CHECK(count_asleep(other->solver) == count_asleep(solver.s));
    REQUIRE(advance(other->solver, 0.5) == C2D_OK);
    expected = pressures(other->solver);
  }
  const auto column = [&]() -> int32_t* {
    Draws draws(solver.s);
    return draws.session.tableau.column;
  }();
  const int32_t n = summary_of(solver.s).contact_unknowns, kept = column[5], awake = solver.s->awake;
  for (const int32_t forged : {-2, awake - 1, n}) {
    CAPTURE(forged);
    column[5] = forged;
    REQUIRE(c2d_save(solver.s) == C2D_OK);
    resumed(C2D_ERR_STORE_FORMAT);
  }
  column[5] = kept;
  const auto pair_asleep = [&]() -> c2d::Pair& {
    Draws draws(solver.s);
    int32_t i = 0;
    while (column[i] >= 0) ++i;
    return draws.session.model.pair[i];
  };
  pair_asleep().status = C2D_STICK; // that it is closed
  REQUIRE(c2d_save(solver.s) == C2D_OK);
  resumed(C2D_ERR_STORE_FORMAT);
  pair_asleep().status = C2D_OPEN;
  for (const int32_t forged : {-1, n, n + 1}) { // no room for those that sleep; none at all
    CAPTURE(forged);
    solver.s->awake = forged;
    REQUIRE(c2d_save(solver.s) == C2D_OK);
    resumed(C2D_ERR_STORE_FORMAT);
  }
  solver.s->awake = awake;
  REQUIRE(advance(solver.s, 0.5) == C2D_OK);
  CHECK(pressures(solver.s) == expected);
}
