// The contact system with every pair open (METHOD 10.11) against that with every pair sticking, of the same bodies' equations.
#include "contact/basis.hpp"
#include "contact/reduction.hpp"
#include "family_runs.hpp"
#include "many_bodies.hpp"
#include "reduction_by_hand.hpp"
#include "solver/judge.hpp"
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
many::Model wedged() {
  using namespace many;
  Model m;
  m.add(rectangle(0, -2, 2, 0, {10, 10, 60, 10})); // floor
  m.add(rectangle(2, 0, 3, 1, {5, 8, 5, 30}));     // wall
  m.add(rectangle(0, 0, 2, 1, {60, 30, 20, 10}));  // block
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
  const std::string texts[] = {family("hertz", {"n=70"}),         family("mindlin", {"n=36"}),  deck_of(wedged()),
                               family("disc_in_hole", {"n=100"}), deck_of(on_a_column(1, 0.3)), deck_of(on_a_column(1, 0)),
                               deck_of(on_a_column(10, 0.3))};
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

TEST_CASE("open form: not where a body bends much more than it gives way, nor where it slides freely") {
  CHECK(Solver(deck_of(on_a_column(1, 0.3))).s->open == 1);
  CHECK(Solver(deck_of(on_a_column(60, 0.3))).s->open == 0);
  many::Model flat = on_a_column(1, 0.3);
  flat.set(2, 3, many::end_of(many::kPulled, 0, -1)); // the block is held by friction alone
  CHECK(Solver(deck_of(flat)).s->open == 0);
  Solver tied(family("coating", {"n=24"}));
  CHECK(tied.s->open == 0);
}
