// Derivatives of wanted numbers by parameters with tolerances (tolerances_of). For each parameter:
//   1. Solve on the divisions of the final mesh with the parameter one step up and one down. On a mesh that stands still the
//      error of a number oscillates while edges of contact and stick borders cross its elements; so take from this pair only
//      where these move (Marks), unless there are none.
//   2. Solve again, one step up and down, with the element ends moving along with the edges: central differences.
//   3. The same with half the step and the moves found in phase 2. Where both differences agree, the second is the derivative.
#include "program/estimate/tolerances.hpp"

#include "program/estimate/torsion.hpp"

#include "program/estimate/error.hpp"
#include "program/estimate/fatigue.hpp"
#include "program/estimate/marks.hpp"
#include "program/estimate/wanted.hpp"
#include "program/interrupt.hpp"
#include "program/sketch/moving.hpp"
#include "program/sketch/same_divisions.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kStepOfValue = 1e-2;      // largest step by the value of a parameter
constexpr double kStepOfTolerance = 1e-1;  // least step by its tolerance
constexpr double kStepOfDigits = 1e-5;     // least step by its value: below it round-off shows
constexpr double kDifferencesAgree = 0.02; // two differences agree to this fraction
constexpr double kNoDifference = 5e-3;     // of the scale of a number over the value of the parameter: less is none
constexpr double kUnseenDerivative = 1e-8; // of the same: so small a derivative is round-off
constexpr double kMarksApart = 0.5;        // of the element there: places nearer to another one do not move the mesh

// Edges of contact and stick borders at the turns of the loads, in the order of the history.
using Marks = std::vector<sketch::MeshPlace>;

Marks marks_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  Marks out;
  for (const sketch::Spot& spot : edges_of(trial)) out.push_back(sketch::place_on(sketch, spot, mesh));
  return out;
}

// The result with changed parameters.
struct Changed {
  std::vector<app::Stated> numbers;
  Marks marks;
};

// Solves the deck of a changed sketch. Throws a sketch::Fault.
Trial solve_changed(const Nominal& at, const sketch::Sketch& changed, const sketch::Mesh& mesh, const Demand& demand,
                    TrialKeeper* keeper) {
  Demand own = demand;
  own.drawn = true, own.store = nullptr, own.points.clear();
  ask(changed, own);
  ask_below(changed, mesh, own.cycle);
  const std::string deck = sketch::deck_of(changed, mesh);
  Trial out;
  std::string why;
  const bool known = keeper != nullptr && keeper->recall(deck, out);
  const c2d_status status = known ? c2d_status{C2D_OK} : solve(deck, own, out, why);
  if (status != C2D_OK) throw sketch::Fault{{}, why};
  if (!known && keeper != nullptr && !keeper->keep(deck, out)) throw sketch::Fault{{}, keeper->error()};
  if (out.outcome != at.trial.outcome) throw sketch::Fault{{}, "the history ends otherwise: " + out.why};
  if (out.pairs != at.trial.pairs || out.zones.size() != at.trial.zones.size())
    throw sketch::Fault{{}, "other parts of the bodies face each other"};
  return out;
}

// Draws, divides and solves the sketch with changed parameters. Throws a sketch::Fault.
Changed solve_with(const Nominal& at, const sketch::Parameters& changed, const sketch::Stretchings& stretchings,
                   const Redraw& redraw, const Demand& demand, TrialKeeper* keeper) {
  sketch::Reading reading = redraw(changed);
  if (!reading.faults.empty()) {
    const sketch::Fault& f = reading.faults.front();
    throw sketch::Fault{{}, (f.at.line > 0 ? "line " + std::to_string(f.at.line) + ": " : "") + f.text};
  }
  sketch::Sketch& sketch = reading.sketch;
  sketch.order = at.sketch.order, sketch.chooses_order = false;
  sketch::take_positions(sketch, at.sketch);
  const sketch::Mesh mesh = sketch::same_divisions(at.sketch, at.mesh, sketch, stretchings);
  const Trial trial = solve_changed(at, sketch, mesh, demand, keeper);
  return {numbers_of({sketch, mesh, trial}), marks_of(sketch, mesh, trial)};
}

// The solutions for one parameter.
class Steps {
public:
  Steps(const Nominal& at, const sketch::Tolerance& parameter, const Redraw& redraw, const Demand& demand, TrialKeeper* keeper)
      : at_(at), parameter_(parameter), redraw_(redraw), demand_(demand), keeper_(keeper),
        marks_(marks_of(at.sketch, at.mesh, at.trial)) {}
  Changed solve(double change) const;
  bool has_marks() const { return !marks_.empty(); }
  void take_moves(const Changed& up, const Changed& down, double step); // of the marks

private:
  sketch::Stretchings stretchings(double change) const;
  const Nominal& at_;
  const sketch::Tolerance& parameter_;
  const Redraw& redraw_;
  const Demand& demand_;
  TrialKeeper* keeper_;
  Marks marks_;
  std::vector<double> moves_; // of every mark, by the change of the parameter; empty: not known
};

Changed Steps::solve(double change) const {
  const double value = parameter_.value + change;
  try {
    return solve_with(at_, {{parameter_.parameter, value}}, stretchings(change), redraw_, demand_, keeper_);
  } catch (const sketch::Fault& fault) {
    throw sketch::Fault{{}, "with " + parameter_.parameter + " = " + sketch::rounded(value) + ": " + fault.text};
  }
}

void Steps::take_moves(const Changed& up, const Changed& down, double step) {
  if (up.marks.size() != marks_.size() || down.marks.size() != marks_.size()) return;
  moves_.assign(marks_.size(), 0);
  for (size_t i = 0; i < marks_.size(); ++i)
    if (up.marks[i].curve == marks_[i].curve && down.marks[i].curve == marks_[i].curve)
      moves_[i] = (up.marks[i].part - down.marks[i].part) / (2 * step);
}

// Length of the element at a place, as a fraction of the length of its curve.
double element_at(const sketch::Mesh& mesh, const sketch::MeshPlace& place) {
  size_t index = 0;
  for (const auto& outlines : mesh.bodies)
    for (const sketch::MeshedOutline& outline : outlines)
      for (const sketch::MeshedCurve& curve : outline.curves) {
        if (index++ != place.curve) continue;
        const double s = place.part * curve.ends.back();
        const auto above = std::upper_bound(curve.ends.begin() + 1, curve.ends.end() - 1, s);
        return (*above - *(above - 1)) / curve.ends.back();
      }
  return 1;
}

// The last marks of the history come first: places near to one that is taken already do not move the mesh.
sketch::Stretchings Steps::stretchings(double change) const {
  sketch::Stretchings out;
  for (size_t i = moves_.size(); i-- > 0;) {
    const sketch::MeshPlace& mark = marks_[i];
    sketch::Stretching& s = out[mark.curve];
    const double room = kMarksApart * element_at(at_.mesh, mark), to = mark.part + moves_[i] * change;
    const auto above = std::upper_bound(s.from.begin(), s.from.end(), mark.part);
    if (above == s.from.begin() || above == s.from.end()) continue;
    const auto k = above - s.from.begin();
    if (*above - mark.part < room || mark.part - *(above - 1) < room) continue;
    if (!(to > s.to[static_cast<size_t>(k) - 1] && to < s.to[static_cast<size_t>(k)])) continue;
    s.from.insert(above, mark.part), s.to.insert(s.to.begin() + k, to);
  }
  return out;
}

// The n-th of the numbers of a kind, of all numbers with the same names.
class Distinct {
public:
  explicit Distinct(const std::vector<app::Toleranced>& numbers) {
    for (const app::Toleranced& t : numbers) {
      size_t before = 0;
      for (size_t i = 0; i < which_.size(); ++i) before += is_same_number(numbers[i].number, t.number) ? 1 : 0;
      which_.push_back(before);
    }
  }
  // The value of number i in another list, as it is shown; NaN: it has none.
  double value(size_t i, const app::Stated& number, const std::vector<app::Stated>& all) const {
    const app::Stated* const s = find_number(all, number, which_[i]);
    return s == nullptr ? NAN : app::shown_value(s->what, s->value, s->along);
  }

private:
  std::vector<size_t> which_;
};

// Central differences of all numbers by one parameter, and the derivatives they agree on.
class Differences {
public:
  Differences(const Steps& steps, const sketch::Tolerance& parameter, const Distinct& names,
              std::vector<app::Toleranced>& numbers)
      : steps_(steps), parameter_(parameter), names_(names), numbers_(numbers) {}
  void find(); // sets the last influence of every number

private:
  std::vector<double> pair(double step);
  double size_of(size_t i, double fraction) const;
  bool agree(size_t i, double a, double b) const;
  bool settle(); // true: all numbers agree
  Steps steps_;
  const sketch::Tolerance& parameter_;
  const Distinct& names_;
  std::vector<app::Toleranced>& numbers_;
  std::vector<std::vector<double>> all_; // differences, pair by pair
};

std::vector<double> Differences::pair(double step) {
  const Changed up = steps_.solve(step), down = steps_.solve(-step);
  std::vector<double> out;
  for (size_t i = 0; i < numbers_.size(); ++i) {
    const app::Stated& n = numbers_[i].number;
    out.push_back((names_.value(i, n, up.numbers) - names_.value(i, n, down.numbers)) / (2 * step));
  }
  steps_.take_moves(up, down, step);
  return out;
}

// A fraction of the scale of a number over the value of the parameter.
double Differences::size_of(size_t i, double fraction) const {
  return fraction * numbers_[i].number.scale / std::max(std::fabs(parameter_.value), parameter_.size);
}

bool Differences::agree(size_t i, double a, double b) const {
  return std::fabs(a - b) <= std::max(kDifferencesAgree * std::max(std::fabs(a), std::fabs(b)), size_of(i, kNoDifference));
}

// Compares the last two pairs; numbers at a fixed place, past which the elements move, with the pair at rest, too.
bool Differences::settle() {
  bool all_agree = true;
  const std::vector<double>&first = all_.front(), &before = all_[all_.size() - 2], &last = all_.back();
  for (size_t i = 0; i < numbers_.size(); ++i) {
    app::Influence& out = numbers_[i].by.back();
    const bool fixed = numbers_[i].number.what == app::Measure::kPressureOn;
    if (std::isnan(before[i]) || std::isnan(last[i]))
      out = {NAN, "it does not exist on both sides of the value"};
    else if (!agree(i, before[i], last[i]))
      out = {NAN, "two steps give " + sketch::rounded(before[i], 4) + " and " + sketch::rounded(last[i], 4)}, all_agree = false;
    else if (fixed && !agree(i, first[i], last[i]))
      out = {NAN,
             "elements at rest and moving ones give " + sketch::rounded(first[i], 4) + " and " + sketch::rounded(last[i], 4)};
    else
      out = {std::fabs(last[i]) <= size_of(i, kUnseenDerivative) ? 0 : last[i], ""};
    if (numbers_[i].number.is_unbounded()) out = {NAN, "it is unbounded"};
  }
  return all_agree;
}

void Differences::find() {
  const double step = first_step(parameter_);
  all_.push_back(pair(step));
  if (steps_.has_marks()) all_.push_back(pair(step));
  all_.push_back(pair(step / 2));
  if (settle() || !steps_.has_marks()) return;
  all_.push_back(pair(step / 2));
  settle();
}

// The numbers of the nominal solution that were asked for.
std::vector<app::Stated> wanted_numbers(const Nominal& at) {
  std::vector<app::Stated> out = numbers_of(at);
  for (app::Stated& s : out)
    if (std::isnan(s.tolerance)) s.tolerance = tolerance_of(at.sketch, s, at.trial);
  return out;
}

} // namespace

double first_step(const sketch::Tolerance& t) {
  const double size = std::fabs(t.value);
  return std::max({std::min(t.size, kStepOfValue * size), kStepOfTolerance * t.size, kStepOfDigits * size});
}

std::vector<app::Stated> numbers_of(const Nominal& at) {
  Distance none;
  none.pressure.assign(at.trial.zones.size(), 0.0);
  std::vector<app::Stated> out = state_numbers(at.trial, at.trial, none, nullptr);
  for (const app::Stated& s : wanted_of(at.sketch, at.mesh, at.trial)) out.push_back(s);
  if (at.sketch.torsion.any())
    for (const app::Stated& s : twist(at.sketch, at.mesh, at.trial).numbers) out.push_back(s);
  return out;
}

std::vector<app::Stated> numbers_with(const Nominal& at, const sketch::Parameters& changed, const Redraw& redraw,
                                      const Demand& demand) {
  return solve_with(at, changed, {}, redraw, demand, nullptr).numbers;
}

app::ToleranceTable tolerances_of(const Nominal& at, const std::vector<app::Stated>& stated, const Redraw& redraw,
                                  const Demand& demand, TrialKeeper* keeper) {
  app::ToleranceTable out;
  for (const sketch::Tolerance& t : at.sketch.tolerances) out.parameters.push_back({t.parameter, t.value, t.size, ""});
  if (at.trial.outcome != C2D_REACHED) {
    out.why = "the history ended early: " + at.trial.why;
    return out;
  }
  for (const app::Stated& s : stated.empty() ? wanted_numbers(at) : stated)
    if (!std::isnan(s.tolerance) && s.has_value()) out.numbers.push_back({s, {}});
  const Distinct names(out.numbers);
  for (size_t p = 0; p < out.parameters.size() && !app::interrupted(); ++p) {
    for (app::Toleranced& n : out.numbers) n.by.push_back({});
    try {
      Differences(Steps(at, at.sketch.tolerances[p], redraw, demand, keeper), at.sketch.tolerances[p], names, out.numbers)
          .find();
    } catch (const sketch::Fault& fault) {
      out.parameters[p].why = fault.text;
      for (app::Toleranced& n : out.numbers) n.by.back() = {NAN, fault.text};
    }
  }
  if (!app::interrupted()) return out;
  out.why = "the search was interrupted";
  out.numbers.clear();
  return out;
}

} // namespace estimate
