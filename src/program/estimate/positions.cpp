// Positions of moving loads (METHOD 22). A path from position to position is a chain of straight pieces; what a number is off
// by falls with their number N at least like 1/N, so that the change from N/2 to N covers what is left.
//   1. On a coarse mesh the positions of the sketch are doubled until no wanted number changes by more than a third. With fewer
//      a number may be a small difference of large ones, and a mesh that resolves it would be of no use.
//   2. adapt() finds the mesh with these positions, to a part of the tolerances; its errors are those of the mesh.
//   3. The history is solved on it with these positions, with twice and four times as many, and so on until the sum of both
//      errors is small enough.
#include "program/estimate/positions.hpp"

#include "program/commands/drawn_words.hpp"
#include "program/estimate/error.hpp"
#include "program/estimate/fatigue.hpp"
#include "program/estimate/tolerances.hpp"
#include "program/interrupt.hpp"
#include "program/sketch/moving.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kOfDoubling = 1.5;     // times the change by it: the error of what may fall a little slower
constexpr int kMostOfPeriod = 4000;     // positions
constexpr double kWorkOfDoubling = 2.5; // work with twice the positions, over that with these
constexpr double kCoarse = 0.5;         // tolerance of the mesh on which the first positions are sought
constexpr double kChangesMuch = 1.0 / 3;
constexpr double kOfMesh = 0.7; // of the tolerances
constexpr int kMostFirst = 4;   // doublings there

using Numbers = std::vector<app::Stated>;

// The numbers as the last solution has them, with errors of the mesh and of the positions. `with`: solutions, each with twice
// as many positions as the one before. Two of few positions may agree by chance: half the change before counts as well.
Numbers with_errors(const Numbers& of_mesh, const std::vector<Numbers>& with) {
  const Numbers &few = with[with.size() - 3], &more = with[with.size() - 2], &most = with.back();
  Numbers out = of_mesh;
  for (size_t i = 0; i < out.size(); ++i) {
    app::Stated& s = out[i];
    if (!s.has_value()) continue;
    const auto equal = static_cast<size_t>(std::count_if(of_mesh.begin(), of_mesh.begin() + static_cast<std::ptrdiff_t>(i),
                                                         [&](const app::Stated& other) { return is_same_number(other, s); }));
    const app::Stated *a = find_number(few, s, equal), *b = find_number(more, s, equal), *c = find_number(most, s, equal);
    const bool all = a != nullptr && b != nullptr && c != nullptr;
    s.error = all ? s.error + kOfDoubling * std::max(apart(*b, *c), apart(*a, *b) / 2) : NAN;
    if (c != nullptr) s.value = c->value, s.at[0] = c->at[0], s.at[1] = c->at[1], s.along = c->along;
  }
  return out;
}

// Does no wanted one of these numbers change much from `few` to `more` positions?
bool are_settled(const Numbers& numbers, const Numbers& few, const Numbers& more) {
  return std::all_of(numbers.begin(), numbers.end(), [&](const app::Stated& s) {
    const app::Stated *a = find_number(few, s, 0), *b = find_number(more, s, 0);
    if (std::isnan(s.tolerance) || !s.has_value() || (a == nullptr && b == nullptr)) return true;
    return a != nullptr && b != nullptr && apart(*a, *b) <= kChangesMuch * std::max(s.scale, std::fabs(b->value));
  });
}

bool all_are_met(const std::vector<app::Stated>& stated) {
  return std::all_of(stated.begin(), stated.end(), [](const app::Stated& s) { return s.is_met() || s.endless; });
}

int most_positions(const sketch::Sketch& s) {
  int out = 0;
  for (const sketch::LoadCase& one : s.cases)
    if (one.course) out = std::max(out, one.course->positions);
  return out;
}

class Positions {
public:
  Positions(Adapted& adapted, const Demand& demand, TrialKeeper* keeper)
      : out_(adapted), demand_(demand), keeper_(keeper), of_mesh_(adapted.loop.stated),
        has_ends_(adapted.deck == sketch::deck_of(adapted.sketch, adapted.mesh)) {
    demand_.drawn = true;
  }
  void refine();
  // The sketch with as many positions as phase 2 needs.
  sketch::Sketch with_first_positions();

private:
  bool solve_with(const sketch::Sketch& sketch, Numbers& numbers);
  bool may_double() const;
  void stop(const std::string& why) { out_.loop.stopped = why + (out_.loop.stopped.empty() ? "" : "; " + out_.loop.stopped); }

  Adapted& out_;
  Demand demand_;
  TrialKeeper* keeper_;
  const std::vector<app::Stated> of_mesh_;
  const bool has_ends_; // of zones that the mesh has cut
  double work_ = 0;
  std::string deck_;
};

bool Positions::solve_with(const sketch::Sketch& sketch, Numbers& numbers) {
  deck_ = sketch::deck_of(sketch, out_.mesh);
  ask_below(sketch, out_.mesh, demand_.cycle);
  Trial trial;
  std::string why;
  const bool known = keeper_ != nullptr && keeper_->recall(deck_, trial);
  if (!known && solve(deck_, demand_, trial, why) != C2D_OK) {
    stop(app::interrupted() ? "the search was interrupted" : app::in_words_of_drawing(why, deck_));
    return false;
  }
  if (!known && keeper_ != nullptr && !keeper_->keep(deck_, trial)) return false;
  if (trial.outcome != C2D_REACHED) {
    stop("with more positions of the moving loads the history ended early: " + trial.why);
    return false;
  }
  work_ = trial.work;
  numbers = numbers_of({out_.sketch, out_.mesh, trial});
  if (!out_.sketch.tolerances.empty()) out_.trial = std::move(trial);
  return true;
}

bool Positions::may_double() const {
  return 2 * most_positions(out_.sketch) <= kMostOfPeriod && kWorkOfDoubling * work_ <= out_.sketch.most_work;
}

void Positions::refine() {
  for (app::Stated& s : out_.loop.stated) // not known before three solutions
    if (s.has_value()) s.error = NAN;
  std::vector<Numbers> with(1);
  if (!solve_with(out_.sketch, with.back())) return;
  while (with.size() < 3 || !all_are_met(out_.loop.stated)) {
    if (!may_double()) return stop("more positions of the moving loads would exceed the work limit");
    with.emplace_back();
    const sketch::Sketch twice = sketch::with_twice_the_positions(out_.sketch);
    if (!solve_with(twice, with.back())) return;
    sketch::take_positions(out_.sketch, twice);
    out_.deck = has_ends_ ? deck_ : app::without_cut_ends(deck_);
    if (with.size() < 3) continue;
    out_.loop.stated = with_errors(of_mesh_, with);
    out_.loop.rounds[out_.loop.taken].stated = out_.loop.stated;
    out_.loop.positions = most_positions(out_.sketch);
    if (!all_are_met(of_mesh_)) return; // the mesh has met a limit
  }
}

sketch::Sketch Positions::with_first_positions() {
  sketch::Sketch few = out_.sketch;
  Numbers before, now;
  bool solved = solve_with(few, before);
  for (int i = 0; i < kMostFirst && solved && may_double(); ++i) {
    const sketch::Sketch twice = sketch::with_twice_the_positions(few);
    solved = solve_with(twice, now);
    if (!solved || are_settled(of_mesh_, before, now)) break;
    few = twice;
    before = now;
  }
  return few;
}

template <class Change> void change_tolerances(sketch::Sketch& s, Change change) {
  s.tolerance = change(s.tolerance);
  for (sketch::Want& want : s.wants)
    if (want.tolerance) want.tolerance = change(*want.tolerance);
}

sketch::Sketch with_first_positions(const sketch::Sketch& sketch, const Demand& demand, TrialKeeper* keeper) {
  sketch::Sketch coarse = sketch, out = sketch;
  change_tolerances(coarse, [](double tolerance) { return std::max(tolerance, kCoarse); });
  coarse.tolerances.clear();
  Adapted first = adapt(
      coarse, demand, [](const app::MeshRound&) {}, keeper);
  if (first.status == C2D_OK && !first.loop.stated.empty() && !app::interrupted())
    sketch::take_positions(out, Positions(first, demand, keeper).with_first_positions());
  return out;
}

} // namespace

Adapted adapt_positions(const sketch::Sketch& sketch, const Demand& demand,
                        const std::function<void(const app::MeshRound&)>& report, TrialKeeper* keeper) {
  if (!sketch::has_moving_loads(sketch)) return adapt(sketch, demand, report, keeper);
  sketch::Sketch first = with_first_positions(sketch, demand, keeper);
  change_tolerances(first, [](double tolerance) { return kOfMesh * tolerance; });
  Adapted out = adapt(first, demand, report, keeper);
  change_tolerances(out.sketch, [](double tolerance) { return tolerance / kOfMesh; });
  for (app::Stated& s : out.loop.stated) s.tolerance /= kOfMesh;
  for (app::MeshRound& round : out.loop.rounds)
    for (app::Stated& s : round.stated) s.tolerance /= kOfMesh;
  const bool is_whole = out.status == C2D_OK && !out.loop.stated.empty();
  if (is_whole && !app::interrupted()) Positions(out, demand, keeper).refine();
  return out;
}

} // namespace estimate
