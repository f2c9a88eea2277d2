// A draw of random decks (all of them: make random), and that their judge sees what is wrong.
#include "effort.hpp"
#include "family_runs.hpp"
#include "random/elastic.hpp"
#include "random/judge.hpp"
#include "random/spence.hpp"
#include "random/statuses.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace random_decks;
using problem::Problem;
using problem::Result;
using problem::Setup;
using problem::Step;

namespace {

std::string findings(const Verdict& v) {
  std::string all;
  for (const std::string& f : v.findings) all += "\n" + f;
  return all;
}

bool is_solved(Kind kind, uint64_t seed) {
  const Verdict v = judge(kind, seed);
  CHECK_MESSAGE(v.findings.empty(), "make random N=1 SEED=" << seed << ": " << v.title << findings(v));
  return v.status == C2D_OK && v.outcome == C2D_REACHED;
}

void draw(Kind kind, uint64_t first, uint64_t count) {
  uint64_t solved = 0;
  for (uint64_t seed = first; seed < first + count; ++seed) solved += is_solved(kind, seed);
  CHECK(solved > count / 3); // or the draw says little
}

// A deck whose pairs open, stick and slip.
struct Judged {
  Model model;
  Runs runs;
};
Judged mixed_deck() {
  for (uint64_t seed = 1;; ++seed) {
    Judged j;
    j.model = generate_few_pairs(seed);
    Setup setup;
    setup.every_change = 1;
    j.runs.changes = solve(j.model.problem, setup);
    if (j.runs.changes.status != C2D_OK || j.runs.changes.recorded().empty()) continue;
    bool has[3] = {false, false, false};
    const Step row = j.runs.changes.recorded().back();
    for (int i = 0; i < row.pairs(); ++i) has[static_cast<int>(row.at(i, C2D_STATUS))] = true;
    if (!has[0] || !has[1] || !has[2] || !try_statuses(j.model, row).done) continue;
    setup.boundaries = true;
    setup.advance_mu = j.model.problem.friction[0];
    for (const Step& s : j.runs.changes.recorded()) setup.advance_loads.push_back(s.load);
    j.runs.rows = solve(j.model.problem, setup);
    return j;
  }
}

int pair_of(const Step& row, int status) {
  for (int i = 0; i < row.pairs(); ++i)
    if (static_cast<int>(row.at(i, C2D_STATUS)) == status) return i;
  return -1;
}

double& entry(Step& row, int status, int field) {
  return row.table[static_cast<size_t>(pair_of(row, status) * C2D_PAIR_FIELDS + field)];
}

// The law that is found broken when `spoil` has changed the last row.
template <class Spoil> std::string broken_by(Judged j, Spoil spoil) {
  spoil(j.runs.changes.steps.back(), j.runs.rows.steps.back());
  const std::vector<std::string> found = broken_laws(j.model, j.runs);
  std::string all;
  for (const std::string& law : found) all += law.substr(0, law.find(':')) + ";";
  return all;
}

bool holds(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("random decks: a draw") { draw(Kind::any, 1, test::effort<uint64_t>(20, 40)); }

TEST_CASE("random decks: bodies that touch without any force, which round-off once took for one") {
  for (const uint64_t seed : {2533u, 103814u, 109514u, 100076u, 109109u, 109283u}) is_solved(Kind::any, seed);
  for (const uint64_t seed : {104023u, 106915u, 108229u, 109222u}) is_solved(Kind::any, seed); // pressed from there on
}

TEST_CASE("random decks: a first touch whose pressure is but a last digit, and slides at once") {
  for (const uint64_t seed : {4114u, 104383u}) is_solved(Kind::any, seed);
}

TEST_CASE("random decks: a body that may tilt either way on one pair has two solutions, however alike they are") {
  const Verdict v = judge(Kind::any, 106816);
  CHECK_MESSAGE(v.findings.empty(), findings(v));
  CHECK(v.not_unique);
}

TEST_CASE("random decks: a load straight above the only pair that touches does not turn the body to one side") {
  for (const uint64_t seed : {50u, 629u}) is_solved(Kind::any, seed);
}

TEST_CASE("random decks: with much friction there are more states than can be counted, and the warning says so") {
  Model model = generate(385);
  model.problem.friction = {8};
  std::string said;
  for (const c2d_error& e : problem::solve(model.problem).told)
    if (e.status == C2D_WARN_NOT_UNIQUE) said = e.text;
  CHECK(holds(said, "the solution is not unique: at least "));
}

TEST_CASE("random decks: a body that nothing moves lies where it was made, whichever gap the tableau leaves free") {
  is_solved(Kind::any, 104971);
}

TEST_CASE("random decks: a body without friction that only the slope of a bump holds is in equilibrium to the last digits") {
  is_solved(Kind::any, 4900);
}

TEST_CASE("random decks: round-off of the motion of a stiff body is no load on it") { is_solved(Kind::any, 304104); }

TEST_CASE("random decks: back to no load, the last pairs of a body are not let go into what round-off holds") {
  for (const uint64_t seed : {103288u, 104777u, 106939u, 108176u}) is_solved(Kind::any, seed);
}

TEST_CASE("random decks: pairs that slide into place without a force have the slip of that way, called open or not") {
  is_solved(Kind::any, 305822);
}

TEST_CASE("random decks: a single pair has fewer unknowns than its body has motions, and its blocks hold both") {
  is_solved(Kind::any, 249);
}

TEST_CASE("random decks: a jump that nothing catches ends the path at its load, however the path is divided") {
  is_solved(Kind::any, 307219);
}

TEST_CASE("random decks: a draw of few pairs, all statuses tried") { draw(Kind::few_pairs, 1, 20); }

TEST_CASE("random decks: a draw of bodies that are lifted off and put back") { draw(Kind::lifted, 1, 25); }

TEST_CASE("random decks: a draw of symmetric bodies") { draw(Kind::symmetric, 1, 12); }

TEST_CASE("random decks: pairs that offend alike change together, so that symmetric bodies stay so") {
  for (const uint64_t seed : {295u, 345u}) is_solved(Kind::symmetric, seed);
}

TEST_CASE("random decks: a body in a range goes back to its middle as it is unloaded, too") {
  is_solved(Kind::symmetric, 1156);
}

TEST_CASE("random decks: where the loads go back to zero the last round-off makes no events") {
  is_solved(Kind::symmetric, 580);
}

TEST_CASE("random decks: rates of forces on a body without any are judged by its motion") {
  is_solved(Kind::symmetric, 526);
  is_solved(Kind::any, 401601);
  for (const uint64_t seed : {51u, 169u, 256u, 572u}) is_solved(Kind::lifted, seed);
  for (const uint64_t seed : {7093u, 7367u}) is_solved(Kind::lifted, seed); // a body loaded only through another slender one
}

TEST_CASE("random decks: punches of Spence stick up to where the half plane says") {
  const std::vector<Punch> all = all_punches();
  for (size_t i = 0; i < all.size(); i += 17) { // make random KIND=punch: all of them
    Punch p = solve_punch(all[i].mu, all[i].nu);
    REQUIRE_MESSAGE(p.solved, "mu " << p.mu << " nu " << p.nu << ": " << p.message);
    p.border = spence_border(p.mu, p.nu);
    CHECK_MESSAGE(p.border_within_a_node(), "mu " << p.mu << " nu " << p.nu << ": sticks up to " << p.sticks << ", slips from "
                                                  << p.slips << ", reference " << p.border);
  }
}

TEST_CASE("random decks: where Spence's punch sticks, from a half plane's integrals") {
  const families_test::Table table = families_test::reference("p04_spence_c_over_a");
  for (size_t i = 0; i < table.size(); i += 3) {
    const std::vector<double>& row = table[i];
    const double border = spence_border(row[0], row[1]);
    CHECK(std::fabs(border - row[2]) < 0.1 * std::min(row[2], 1 - row[2]));
  }
}

TEST_CASE("random decks: the judge passes what is right and sees what is wrong") {
  const Judged right = mixed_deck();
  CHECK(broken_by(right, [](Step&, Step&) {}) == "");
  const auto spoiled = [&](int status, int field, double factor, double step) {
    return broken_by(right, [&](Step& row, Step&) { entry(row, status, field) = entry(row, status, field) * factor + step; });
  };
  const Sizes size = sizes_of(right.model.problem, right.runs);
  CHECK(holds(spoiled(C2D_OPEN, C2D_TN, 1, 1e-6 * size.traction), "an open pair carries a force"));
  CHECK(holds(spoiled(C2D_OPEN, C2D_GAP, 0, -1e-6 * size.displacement), "an open pair overlaps"));
  CHECK(holds(spoiled(C2D_STICK, C2D_TN, -1, 0), "a closed pair pulls"));
  CHECK(holds(spoiled(C2D_STICK, C2D_GAP, 1, 1e-6 * size.displacement), "a closed pair gapes"));
  CHECK(holds(spoiled(C2D_SLIP, C2D_TT, 1.001, 0), "friction beyond the cone"));
  CHECK(holds(spoiled(C2D_SLIP, C2D_TT, 0.999, 0), "a slipping pair is inside the cone"));
  CHECK(holds(spoiled(C2D_SLIP, C2D_SLIP_SUM, -1, 0), "dissipation is not friction times slip"));
  CHECK(holds(spoiled(C2D_STICK, C2D_UN1, 1, std::nan("")), "a result is no number"));
  const std::string forces = broken_by(right, [](Step&, Step& row) { row.boundary[1][0].ty += 1; });
  CHECK(holds(forces, "forces on body 2"));
  CHECK(holds(forces, "moments on body 2"));
  const std::string nodes = broken_by(right, [&](Step&, Step& row) {
    for (problem::EndResult& e : row.boundary[0]) e.ux += 1e-6 * size.displacement;
  });
  CHECK(holds(nodes, "a pair's displacement is not its node's"));
  CHECK(holds(nodes, "a prescribed displacement is missed"));
}

TEST_CASE("random decks: the judge sees what is not symmetric") {
  const Model model = generate_symmetric(4);
  Result deck = solve(model.problem);
  REQUIRE(deck.recorded().size() > 1);
  CHECK(asymmetry(model, deck) == "");
  Result other = deck;
  entry(other.steps[0], C2D_STICK, C2D_TT) *= 1.001;
  CHECK(holds(asymmetry(model, other), "tractions differ"));
  other = deck;
  entry(other.steps[0], C2D_STICK, C2D_UT2) *= 1.001;
  CHECK(holds(asymmetry(model, other), "displacements differ"));
  other.steps[0].second = 1; // no longer symmetric
  CHECK(asymmetry(model, other) == "");
}

TEST_CASE("random decks: energies and slip that a judge must see") {
  Judged j = mixed_deck();
  std::vector<Step>& steps = j.runs.changes.steps;
  steps.back().dissipated -= 1;
  CHECK(holds(broken_by(j, [](Step&, Step&) {}), "friction gives energy back"));
  j = mixed_deck();
  Step change = steps.back();
  change.kind = C2D_STEP_CHANGE;
  steps.insert(steps.end() - 1, change);
  const double step = 1e-6 * sizes_of(j.model.problem, j.runs).displacement;
  const auto moved = [&](int status, double way) {
    return broken_by(j, [&](Step& row, Step&) {
      entry(row, status, C2D_SLIP_SUM) += way;
      entry(row, status, C2D_UT2) += way;
    });
  };
  CHECK(holds(moved(C2D_STICK, step), "a sticking pair slips"));
  const double along = entry(change, C2D_SLIP, C2D_TT) > 0 ? step : -step;
  CHECK(holds(moved(C2D_SLIP, along), "friction pushes along the slip"));
  CHECK_FALSE(holds(moved(C2D_SLIP, -along), "friction pushes along the slip"));
}

TEST_CASE("random decks: other statuses than the library's are seen, and equations that are not satisfied") {
  const Judged j = mixed_deck();
  const Trial trial = try_statuses(j.model, j.runs.changes.steps[0]);
  REQUIRE(trial.done);
  REQUIRE(trial.clear() == 1);
  CHECK(against_trial(j.model, trial, j.runs.changes, false) == "");
  CHECK(holds(against_trial(j.model, trial, j.runs.changes, true), "one solution"));
  Result other = j.runs.changes;
  for (Step& s : other.steps) entry(s, C2D_SLIP, C2D_TT) *= 1.001;
  CHECK(holds(against_trial(j.model, trial, other, false), "none of the 1 solutions"));
  other.steps.clear();
  other.outcome = C2D_NO_PROGRESS;
  CHECK(holds(against_trial(j.model, trial, other, false), "solvable, but not solved"));
  Trial none = trial;
  none.found.clear();
  CHECK(holds(against_trial(j.model, none, j.runs.changes, false), "no set of statuses"));
  Trial two = trial;
  two.found.push_back(trial.found[0]);
  CHECK(holds(against_trial(j.model, two, j.runs.changes, false), "not unique without a word"));
  Step row = j.runs.rows.steps.back();
  CHECK(elastic_residual(j.model, row) < 1e-10);
  row.boundary[0][0].ty += 1e-3;
  CHECK(elastic_residual(j.model, row) > 1e-7);
}

// A square under uniform tension: what the equations of this folder say of a state that is known.
TEST_CASE("random decks: the equations of their own pass a uniform state") {
  for (const int32_t order : {2, 3, 4})
    for (const int32_t plane : {C2D_PLANE_STRAIN, C2D_PLANE_STRESS}) {
      Problem p;
      p.plane = plane;
      p.function_nodes = order;
      p.bodies.resize(1);
      problem::add_polygon(p.bodies[0], {{0, 0, 2}, {1.5, 0.2, 2}, {1.2, 1, 2}, {0, 0.8, 2}});
      const double e = p.bodies[0].youngs_modulus, nu = p.bodies[0].poisson_ratio;
      const double exx = plane == C2D_PLANE_STRAIN ? (1 - nu * nu) / e : 1 / e;
      const double eyy = plane == C2D_PLANE_STRAIN ? -nu * (1 + nu) / e : -nu / e;
      const Equations q = equations_of(p, 1);
      std::vector<double> values(q.columns(), 0);
      int32_t end = 0;
      problem::set_ends(p, 1, [&](double x, double y, double nx, double, problem::End&) {
        const int32_t node = node_of_end(p, p.bodies[0], end / order + 1, end % order);
        values[q.u(node, 0)] = exx * x, values[q.u(node, 1)] = eyy * y;
        values[q.t(end++, 0)] = nx;
      });
      for (const std::vector<double>& row : q.rows) {
        double sum = 0;
        for (size_t i = 0; i < values.size(); ++i) sum += row[i] * values[i];
        CHECK(std::fabs(sum) < 1e-12);
      }
    }
}
