#include "judge.hpp"

#include "deck_text.hpp"
#include "statuses.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace random_decks {

namespace {

using namespace problem;

constexpr double kSecondsAllowed = 20;
constexpr double kResidualAllowed = 1e-9;

double processor_seconds() { return static_cast<double>(clock()) / CLOCKS_PER_SEC; }

Result solve_deck(const std::string& deck, int32_t every_change) {
  Setup setup;
  setup.seconds = kSecondsAllowed;
  setup.every_change = every_change;
  return solve_text(deck, setup);
}

// The recorded loads once more, with boundaries. A press fit closes its overlaps by a load of its own.
Result solve_rows(const Model& model, const Result& deck) {
  Setup setup;
  setup.seconds = kSecondsAllowed;
  setup.boundaries = true;
  setup.advance_mu = model.problem.friction[0];
  for (const Step& s : deck.recorded()) {
    setup.advance_loads.push_back(s.load);
    if (model.problem.two_cases()) setup.advance_second.push_back(s.second);
  }
  if (setup.advance_loads.empty() || model.problem.interference > 0) return Result();
  return solve(model.problem, setup);
}

bool same_rows(const Result& deck, const Result& rows) {
  const std::vector<Step> a = deck.recorded(), b = rows.recorded();
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (a[i].table != b[i].table) return false;
  return true;
}

Model generate_kind(Kind kind, uint64_t seed) {
  switch (kind) {
  case Kind::few_pairs: return generate_few_pairs(seed);
  case Kind::lifted: return generate_lifted(seed);
  case Kind::symmetric: return generate_symmetric(seed);
  default: return generate(seed);
  }
}

class Judge {
public:
  Judge(Kind kind, uint64_t seed) : seed_(seed), model_(generate_kind(kind, seed)) {}
  Verdict all();

private:
  void solve_it();
  void laws();
  void elasticity(const Runs& runs);
  void statuses(const Runs& runs);
  bool is_said_of_another_load() const;
  void forms();
  void find(const std::string& what) { verdict_.findings.push_back(what); }

  const uint64_t seed_;
  const Model model_;
  Verdict verdict_;
  Result deck_;
};

void Judge::solve_it() {
  const std::vector<Body>& bodies = model_.problem.bodies;
  verdict_.title = model_.title + ", " + std::to_string(bodies[0].regions.size() - 1) + "+" +
                   std::to_string(bodies[1].regions.size() - 1) + " holes, orders " + std::to_string(bodies[0].element_nodes) +
                   " " + std::to_string(model_.problem.function_nodes);
  verdict_.deck = deck_of(model_.problem, model_.title);
  const double start = processor_seconds();
  deck_ = solve_deck(verdict_.deck, 0);
  verdict_.seconds = processor_seconds() - start;
  verdict_.status = deck_.status;
  verdict_.outcome = deck_.outcome;
  verdict_.load = deck_.summary.load;
  verdict_.not_unique = deck_.warned(C2D_WARN_NOT_UNIQUE);
  verdict_.undefined_place = deck_.warned(C2D_WARN_UNDEFINED_PLACE);
  if (verdict_.status == C2D_ERR_CANCELLED)
    find("no end in 20 s");
  else if (verdict_.status != C2D_OK && verdict_.status != C2D_ERR_INPUT)
    find("status " + std::to_string(verdict_.status) + ": " + deck_.messages());
}

void Judge::laws() {
  Runs runs;
  runs.changes = solve_deck(verdict_.deck, 1);
  runs.rows = solve_rows(model_, deck_);
  if (!runs.rows.steps.empty() && !same_rows(deck_, runs.rows)) find("advance does not repeat run");
  for (const std::string& law : broken_laws(model_, runs)) find(law);
  const std::string unlike = model_.symmetric ? asymmetry(model_, deck_) : "";
  verdict_.unlike_its_image = !unlike.empty();
  if (!unlike.empty() && !verdict_.not_unique) find("not symmetric: " + unlike);
  elasticity(runs);
  statuses(runs);
}

// The equations of elasticity, for one deck in eight: it takes longer than all the rest.
void Judge::elasticity(const Runs& runs) {
  if (seed_ % 8 != 0) return;
  const Step* most = nullptr; // the row with the largest displacements
  double largest = 0;
  for (const Step& s : runs.rows.steps)
    for (int i = 0; i < s.pairs() && !s.boundary[0].empty(); ++i)
      for (int field : {C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2})
        if (std::fabs(s.at(i, field)) > largest) largest = std::fabs(s.at(i, field)), most = &s;
  if (!most) return;
  const double residual = elastic_residual(model_, *most);
  if (residual > kResidualAllowed) find("the equations of elasticity: residual " + std::to_string(1e9 * residual) + "e-9");
}

// Tried are the statuses at the first load, which is none. At another load, or where the path comes back to none, there may be
// more states: a pair at its bound may slip on, or stick while its pressure falls.
bool Judge::is_said_of_another_load() const {
  const std::vector<Path>& paths = model_.problem.paths;
  bool comes_back = false;
  for (size_t i = 1; i < paths.size(); ++i) comes_back = comes_back || paths[i - 1].load * paths[i].load <= 0;
  double at = 0;
  for (const c2d_error& e : deck_.told)
    if (e.status == C2D_WARN_NOT_UNIQUE) at = e.load;
  return std::fabs(at) > 0 || comes_back;
}

void Judge::statuses(const Runs& runs) {
  if (runs.changes.steps.empty()) return;
  const Trial trial = try_statuses(model_, runs.changes.steps[0]);
  verdict_.tried = trial.done;
  const bool said = verdict_.not_unique && !(trial.clear() == 1 && is_said_of_another_load());
  const std::string against = against_trial(model_, trial, deck_, said);
  if (!against.empty()) find(against);
}

void Judge::forms() {
  for (Form& form : forms_of(model_, seed_)) {
    form.setup.seconds = kSecondsAllowed;
    const Result other = solve(form.problem, form.setup);
    const std::string how = difference(model_, deck_, form, other);
    if (how.empty()) continue;
    // Where the solution is not unique, and this is said, equivalent decks may choose otherwise.
    const bool said = verdict_.not_unique && other.warned(C2D_WARN_NOT_UNIQUE);
    if (said && !form.equal_bits)
      ++verdict_.other_choices;
    else
      find(form.name + ": " + how);
  }
}

Verdict Judge::all() {
  solve_it();
  if (verdict_.status == C2D_OK) laws();
  forms();
  return verdict_;
}

} // namespace

Verdict judge(Kind kind, uint64_t seed) { return Judge(kind, seed).all(); }

} // namespace random_decks
