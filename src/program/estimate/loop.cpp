#include "program/estimate/loop.hpp"

#include "program/drawn_words.hpp"
#include "program/estimate/far.hpp"
#include "program/estimate/halved.hpp"
#include "program/estimate/marks.hpp"
#include "program/estimate/mesh_curves.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/refine.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace estimate {
namespace {

constexpr double kFirst = 0.25; // fineness of the first mesh
constexpr double kStalls = 0.7; // of the distance of the round before
constexpr double kOwn = 0.5;    // of a zone's distance: from its own elements; of less the rest of the boundary is to blame
constexpr int kMostRounds = 14;
constexpr double kSettles = 0.8; // of the error before: more is none that falls
constexpr int kPatience = 3;
constexpr int kEarlyRounds = 3;     // bisections of the contacts before an early end of the history is believed
constexpr double kOfElements = 2.6; // the power of their number that time goes with
constexpr double kOfPlaces = 0.75;  // if nothing but places are off
constexpr double kOfEnergy = 8;     // energy that elements cannot follow, over the tolerance

constexpr app::Measure kLocal[] = {app::Measure::kPeakPressure, app::Measure::kContactEdge, app::Measure::kStickBorder,
                                   app::Measure::kDissipated};

struct Level {
  sketch::Mesh mesh;
  std::string deck;
  Trial trial;
};

class Loop {
public:
  Loop(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& told,
       TrialKeeper* keeper)
      : s_(sketch), demand_(demand), told_(told), keeper_(keeper) {
    demand_.drawn = true;
  }
  Adapted run();

private:
  void search();
  bool solve_level(Level& level, bool adapted);
  bool is_within_limits(const sketch::Mesh& mesh);
  void judge(const Level& coarse, const Level& fine, const Distance& between);
  bool all_met() const;
  void watch();
  void tell_endless();
  sketch::Mesh with_finer_contacts(const sketch::Mesh& mesh) const;
  Level next_mesh(const Level& coarse, const Level& fine, const Distance& distance, bool near);
  double aim() const;
  double energy_aim() const;
  bool is_near(const Distance& distance) const;
  void tighten(const Distance& distance);
  double tolerance(sketch::Want::Kind kind) const;
  double tolerance_of(const app::Stated& s, const Trial& trial) const;
  bool take(Level& level, const std::string& why);

  const sketch::Sketch& s_;
  Demand demand_;
  const std::function<void(const app::MeshRound&)>& told_;
  TrialKeeper* keeper_;
  Adapted out_;
  struct Watched {
    double error = HUGE_VAL;
    int stays = 0; // rounds in a row
  };
  std::map<std::tuple<std::string, int32_t, int32_t, int32_t, int>, Watched>
      watched_;  // by name, zone, item, body, which of these
  Round before_; // what was stated in the round before
  double seconds_ = 0;
  double rest_ = 1, worst_ = HUGE_VAL; // the rest of the boundary is held to more while the contact's distance does not fall
  std::string history_;                // why it ended early, of the last mesh
  double strictness_ = 1;              // below 1 where numbers are still off though the tractions are near enough
};

// The overlaps of elements of two meshes on the same curves.
Overlaps overlaps_of(const sketch::Mesh& coarse, const sketch::Mesh& fine) {
  Overlaps out;
  for (size_t b = 0; b < coarse.bodies.size(); ++b) {
    out.push_back({});
    int32_t first = 0, first_fine = 0;
    for (size_t o = 0; o < coarse.bodies[b].size(); ++o)
      for (size_t c = 0; c < coarse.bodies[b][o].curves.size(); ++c) {
        const std::vector<double>&p = coarse.bodies[b][o].curves[c].ends, &q = fine.bodies[b][o].curves[c].ends;
        const auto eta = [](const std::vector<double>& ends, size_t e, double s) {
          return -1 + 2 * (s - ends[e]) / (ends[e + 1] - ends[e]);
        };
        for (size_t e = 0, f = 0; e + 1 < p.size() && f + 1 < q.size();) {
          const double from = std::max(p[e], q[f]), to = std::min(p[e + 1], q[f + 1]);
          if (to - from > 1e-9 * (q[f + 1] - q[f]))
            out.back().push_back({first + static_cast<int32_t>(e), first_fine + static_cast<int32_t>(f), eta(p, e, from),
                                  eta(p, e, to), eta(q, f, from), eta(q, f, to)});
          if (p[e + 1] <= q[f + 1])
            ++e;
          else
            ++f;
        }
        first += static_cast<int32_t>(p.size()) - 1, first_fine += static_cast<int32_t>(q.size()) - 1;
      }
  }
  for (size_t b = coarse.bodies.size(); b > out.size();) out.push_back({});
  return out;
}

Distance distance_of(const Level& coarse, const Level& fine) {
  return distance(coarse.trial, fine.trial, overlaps_of(coarse.mesh, fine.mesh));
}

app::MeshRound round_of(const Trial& trial) {
  app::MeshRound round;
  round.elements = trial.elements, round.pairs = trial.pairs, round.equations = trial.equations;
  round.seconds = trial.seconds;
  return round;
}

void tell_distance(const Distance& d, const Trial& trial, app::MeshRound& round) {
  for (size_t z = 0; z < d.pressure.size(); ++z)
    if (trial.tied[z] == 0) round.pressure = std::fmax(round.pressure, d.pressure[z]);
  round.energy = d.energy;
}

bool Loop::is_within_limits(const sketch::Mesh& mesh) {
  if (sketch::elements_of(mesh) > s_.most_elements) {
    out_.loop.stopped = "the mesh would have more than " + std::to_string(s_.most_elements) + " elements";
    return false;
  }
  double next = 0; // a mesh with twice the elements takes about six times as long
  if (!out_.loop.rounds.empty()) {
    const app::MeshRound& last = out_.loop.rounds.back();
    next = last.seconds * std::pow(static_cast<double>(sketch::elements_of(mesh)) / last.elements, kOfElements);
  }
  if (s_.most_seconds > 0 && seconds_ + next > s_.most_seconds) {
    out_.loop.stopped = "the next mesh would take more than the limit of time";
    return false;
  }
  return true;
}

bool Loop::solve_level(Level& level, bool adapted) {
  level.deck = sketch::deck_of(s_, level.mesh);
  std::string why;
  const bool known = keeper_ != nullptr && keeper_->recall(level.deck, level.trial);
  const c2d_status status = known ? c2d_status{C2D_OK} : solve(level.deck, demand_, level.trial, why);
  if (status == C2D_OK && !known && keeper_ != nullptr && !keeper_->keep(level.deck, level.trial)) return false;
  seconds_ += level.trial.seconds;
  if (status != C2D_OK) {
    why = app::in_words_of_drawing(why, level.deck);
    if (out_.deck.empty()) out_.status = status, out_.why = why, out_.deck = level.deck;
    out_.loop.stopped = why;
    return false;
  }
  out_.loop.rounds.push_back(round_of(level.trial));
  out_.loop.rounds.back().adapted = adapted;
  history_ = level.trial.why;
  out_.loop.rounds.back().curves = curves_of(level.mesh);
  return true;
}

double Loop::tolerance(sketch::Want::Kind kind) const {
  if (s_.wants.empty())
    return kind == sketch::Want::kDissipation || kind == sketch::Want::kStress || kind == sketch::Want::kHoop ? NAN
                                                                                                              : s_.tolerance;
  double least = NAN;
  for (const sketch::Want& want : s_.wants)
    if (want.kind == kind) least = std::fmin(least, want.tolerance.value_or(s_.tolerance));
  return least;
}

double Loop::tolerance_of(const app::Stated& s, const Trial& trial) const {
  using app::Measure;
  using sketch::Want;
  if (s.zone > 0 && trial.tied[static_cast<size_t>(s.zone) - 1] != 0) return NAN;
  const std::pair<Measure, Want::Kind> kinds[] = {
      {Measure::kPeakPressure, Want::kPressure}, {Measure::kContactEdge, Want::kEdges}, {Measure::kStickBorder, Want::kEdges},
      {Measure::kForceX, Want::kForces},         {Measure::kForceY, Want::kForces},     {Measure::kApproach, Want::kApproach},
      {Measure::kDissipated, Want::kDissipation}};
  for (const auto& [measure, kind] : kinds)
    if (s.name == app::name_of(measure)) return measure == Measure::kDissipated && s.zone > 0 ? NAN : tolerance(kind);
  return s.name == kTractions ? tolerance(Want::kPressure) : NAN;
}

void Loop::judge(const Level& coarse, const Level& fine, const Distance& between) {
  std::vector<app::Stated>& stated = out_.loop.stated;
  const Round* before = before_.stated.empty() ? nullptr : &before_;
  stated = state_numbers(coarse.trial, fine.trial, between, before);
  for (app::Stated& s : stated) s.tolerance = tolerance_of(s, fine.trial);
  for (const app::Stated& s :
       state_wanted(wanted_of(s_, coarse.mesh, coarse.trial), wanted_of(s_, fine.mesh, fine.trial), between, before))
    stated.push_back(s);
  drop_unknown(stated);
  confirm(stated, fine.trial, before);
  out_.loop.rounds.back().stated = stated;
  before_ = {stated, between.pressure, fine.trial.states.empty() ? std::vector<double>() : fine.trial.states.back().loads};
}

// Numbers at one place whose errors no longer fall though the mesh there becomes finer: at a sharp corner there may be no
// bound.
void Loop::watch() {
  std::map<std::tuple<std::string, int32_t, int32_t, int32_t>, int> seen;
  for (app::Stated& s : out_.loop.stated) {
    const int which = seen[{s.name, s.zone, s.item, s.body}]++;
    if (s.is_within() || !is_place(s)) continue;
    Watched& w = watched_[{s.name, s.zone, s.item, s.body, which}];
    w.stays = s.error > kSettles * w.error ? w.stays + 1 : 0;
    w.error = s.error;
    s.endless = w.stays >= kPatience;
  }
}

bool Loop::all_met() const {
  return std::all_of(out_.loop.stated.begin(), out_.loop.stated.end(),
                     [](const app::Stated& s) { return s.is_met() || s.endless; });
}

sketch::Mesh without_far(sketch::Mesh mesh) {
  for (auto& outlines : mesh.bodies)
    for (sketch::MeshedOutline& outline : outlines)
      for (sketch::MeshedCurve& curve : outline.curves) curve.far.clear();
  return mesh;
}

// Does a number hang on the tractions of the contact alone?
bool is_local(const app::Stated& s) {
  using app::Measure;
  return s.name == kTractions ||
         std::any_of(std::begin(kLocal), std::end(kLocal), [&](Measure m) { return s.name == app::name_of(m); });
}

// A body that rests on too few pairs slides or turns off them: the same history may go on where there are more.
sketch::Mesh Loop::with_finer_contacts(const sketch::Mesh& mesh) const {
  sketch::Levels levels;
  for (const auto& outlines : mesh.bodies) {
    levels.push_back({});
    for (const sketch::MeshedOutline& outline : outlines)
      for (const sketch::MeshedCurve& curve : outline.curves)
        levels.back().insert(levels.back().end(), curve.elements(), curve.curve->contact >= 0 ? 1 : 0);
  }
  return sketch::refined(s_, without_far(mesh), levels, {});
}

// What is far by now left out, what adds most bisected, ends of elements at the ends of contact and stick.
Level Loop::next_mesh(const Level& coarse, const Level& fine, const Distance& distance, bool near) {
  sketch::Mesh mesh = coarse.mesh;
  mark_far(s_, coarse.trial, mesh);
  double worst = 0, own = 0;
  for (size_t z = 0; z < distance.pressure.size(); ++z)
    if (distance.pressure[z] > worst) worst = distance.pressure[z], own = distance.own[z];
  if (worst > kStalls * worst_ && own < kOwn * worst) rest_ /= 8;
  worst_ = worst;
  sketch::Levels levels = marks(distance, aim(), energy_aim());
  if (near) mark_places(s_, fine.trial, out_.loop.stated, mesh, levels);
  return {sketch::refined(s_, mesh, levels, edges_of(fine.trial)), {}, {}};
}

// The distance of the tractions at which every number is expected to be met.
double Loop::aim() const {
  double wanted = s_.tolerance;
  for (const sketch::Want& want : s_.wants) wanted = std::min(wanted, want.tolerance.value_or(s_.tolerance));
  return strictness_ * wanted;
}

// The same of the energy that elements cannot follow, which numbers beside those of the contact depend on.
double Loop::energy_aim() const { return kOfEnergy * rest_ / strictness_ * aim(); }

bool Loop::is_near(const Distance& d) const {
  return std::all_of(d.pressure.begin(), d.pressure.end(), [&](double p) { return p < aim(); });
}

// By as much as the worst number is off on a mesh that should have met all; places have marks of their own.
void Loop::tighten(const Distance& d) {
  double contact = 1, rest = 1;
  for (const app::Stated& s : out_.loop.stated) {
    if (s.is_within() || s.endless) continue;
    double& worst = is_local(s) ? contact : rest;
    worst = std::min(worst, is_place(s) ? kOfPlaces : s.tolerance * s.scale / s.error);
  }
  if (contact < 1) strictness_ *= std::clamp(contact, 0.15, kOfPlaces);
  if (d.energy < energy_aim() && rest < 1) rest_ *= std::clamp(rest, 0.05, 0.6);
}

void Loop::tell_endless() {
  const std::vector<app::Stated>& all = out_.loop.stated;
  if (std::any_of(all.begin(), all.end(), [&](const app::Stated& s) { return !s.is_met(); }))
    out_.loop.stopped = "it does not settle as the mesh there becomes finer: it may have no bound";
}

bool Loop::take(Level& level, const std::string& why) {
  out_.mesh = level.mesh;
  out_.deck = level.deck;
  out_.loop.taken = out_.loop.rounds.size() - 1;
  if (out_.loop.stopped.empty()) out_.loop.stopped = why;
  return true;
}

void Loop::search() {
  Level coarse;
  coarse.mesh = sketch::first_mesh(s_, kFirst);
  int early = 0; // rounds whose history ended early
  for (int round = 0; round < kMostRounds; ++round) {
    coarse.trial = Trial();
    if (!solve_level(coarse, true)) return;
    told_(out_.loop.rounds.back());
    if (round == 0) take(coarse, "");            // what is kept where no later mesh can be made or solved
    if (is_cut_off(coarse.trial, coarse.mesh)) { // contact has grown up to what was taken to be far
      coarse.mesh = without_far(coarse.mesh);
      continue;
    }
    if (round == 0) mark_far(s_, coarse.trial, coarse.mesh);
    Level fine{sketch::halved(s_, coarse.mesh), {}, {}};
    if (!is_within_limits(fine.mesh) || !solve_level(fine, false)) {
      return;
    }
    if (fine.trial.zones.size() != coarse.trial.zones.size()) continue; // what is far parts one
    const Distance between = distance_of(coarse, fine);
    tell_distance(between, fine.trial, out_.loop.rounds.back());
    told_(out_.loop.rounds.back());
    judge(coarse, fine, between);
    take(fine, "");
    if (is_cut_off(fine.trial, fine.mesh)) {
      coarse.mesh = without_far(coarse.mesh);
      continue;
    }
    if (!history_.empty() && early++ < kEarlyRounds) {
      coarse.mesh = with_finer_contacts(coarse.mesh);
      if (!is_within_limits(coarse.mesh)) return;
      continue;
    }
    const bool near = is_near(between);
    if (near) watch();
    if (all_met()) return tell_endless();
    if (near) tighten(between);
    coarse = next_mesh(coarse, fine, between, near);
    if (!is_within_limits(coarse.mesh)) return;
  }
  out_.loop.stopped = "after " + std::to_string(kMostRounds) + " rounds";
}

Adapted Loop::run() {
  std::string& stopped = out_.loop.stopped;
  try {
    search();
  } catch (const sketch::Fault& fault) { // of a later mesh: the results of the last one stand
    if (out_.deck.empty()) throw;
    stopped = fault.text;
  }
  if (!history_.empty()) stopped = "the history ended early: " + history_ + (stopped.empty() ? "" : "; " + stopped);
  return std::move(out_);
}

} // namespace

Adapted adapt(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& told,
              TrialKeeper* keeper) {
  return Loop(sketch, demand, told, keeper).run();
}

app::MeshLoop estimate_deck(c2d_solver* solver, const std::string& deck, const Demand& demand) {
  app::MeshLoop out;
  const std::string decks[2] = {deck, halved_deck(solver, deck, out.stopped)};
  Trial trials[2];
  for (size_t k = 0; k < 2 && out.stopped.empty(); ++k)
    if (solve(decks[k], demand, trials[k], out.stopped) == C2D_OK) out.rounds.push_back(round_of(trials[k]));
  if (!out.stopped.empty() || trials[0].states.empty() || trials[1].states.empty()) return out;
  const Distance between = distance(trials[0], trials[1], overlaps_of_halves(trials[0]));
  tell_distance(between, trials[1], out.rounds.back());
  out.stated = state_of_coarse(trials[0], trials[1], between);
  return out;
}

} // namespace estimate
