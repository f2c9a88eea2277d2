#include "program/estimate/loop.hpp"

#include "program/estimate/far.hpp"
#include "program/estimate/halved.hpp"
#include "program/estimate/mesh_curves.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/refine.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kFirst = 0.25; // fineness of the first mesh
constexpr double kStalls = 0.7; // of the distance of the round before
constexpr int kMostRounds = 14, kMostLevels = 2;
constexpr double kPredicted = 0.3;         // from the distance of two meshes to the error of the one after them
constexpr double kEdge = 2.8, kSmooth = 8; // by how much a share falls if its element is bisected

struct Level {
  sketch::Mesh mesh;
  std::string deck;
  Trial trial;
};

class Loop {
public:
  Loop(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& told)
      : s_(sketch), demand_(demand), told_(told) {}
  Adapted run();

private:
  void search();
  bool solve_level(Level& level, const Trial* before, bool adapted);
  bool is_within_limits(const sketch::Mesh& mesh);
  void judge(const Level* coarse, const Level& middle, const Level& fine, const Distance* before, const Distance& last);
  bool all_met() const;
  bool has_outgrown(Level& level) const;
  Level next_mesh(const Level& level, const Distance& distance);
  bool is_near(const Distance& distance) const;
  void tighten();
  sketch::Levels marks(const Distance& distance) const;
  double tolerance(sketch::Want::Kind kind) const;
  double tolerance_of(const app::Stated& s, const Trial& trial) const;
  bool take(Level& level, const std::string& why);

  const sketch::Sketch& s_;
  const Demand& demand_;
  const std::function<void(const app::MeshRound&)>& told_;
  Adapted out_;
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
  // A mesh with twice the elements takes about six times as long.
  const double next = out_.loop.rounds.empty() ? 0 : 6 * out_.loop.rounds.back().seconds;
  if (s_.most_seconds > 0 && seconds_ + next > s_.most_seconds) {
    out_.loop.stopped = "the next mesh would take more than the limit of time";
    return false;
  }
  return true;
}

bool Loop::solve_level(Level& level, const Trial* before, bool adapted) {
  level.deck = sketch::deck_of(s_, level.mesh);
  std::string why;
  const c2d_status status = solve(level.deck, demand_, level.trial, why);
  seconds_ += level.trial.seconds;
  if (status != C2D_OK) {
    if (before == nullptr && out_.deck.empty()) out_.status = status, out_.why = why, out_.deck = level.deck;
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
    if (s.name == app::name_of(measure)) return tolerance(kind);
  return s.name == kTractions ? tolerance(Want::kPressure) : NAN;
}

void Loop::judge(const Level* coarse, const Level& middle, const Level& fine, const Distance* before, const Distance& last) {
  std::vector<app::Stated>& stated = out_.loop.stated;
  stated = state_numbers(coarse == nullptr ? nullptr : &coarse->trial, middle.trial, fine.trial, before, last);
  for (app::Stated& s : stated) s.tolerance = tolerance_of(s, fine.trial);
  double worst = 0;
  for (const double p : last.pressure) worst = std::max(worst, p);
  const std::vector<app::Stated> now = wanted_of(s_, fine.mesh, fine.trial), then = wanted_of(s_, middle.mesh, middle.trial);
  const std::vector<app::Stated> first =
      coarse == nullptr ? std::vector<app::Stated>() : wanted_of(s_, coarse->mesh, coarse->trial);
  for (size_t i = 0; i < now.size(); ++i) {
    stated.push_back(now[i]);
    if (i >= then.size()) continue; // the history ended early there: no error can be told
    const double earlier = i < first.size() ? std::fabs(then[i].value - first[i].value) : 0;
    stated.back().error = stated_error(earlier, std::fabs(now[i].value - then[i].value), kMostRate, 0.1 * worst * now[i].scale);
  }
  out_.loop.rounds.back().stated = stated;
}

bool Loop::all_met() const {
  return std::all_of(out_.loop.stated.begin(), out_.loop.stated.end(), [](const app::Stated& s) { return s.is_met(); });
}

// Elements whose shares are above those of a mesh that meets the tolerances with shares alike.
// Has contact grown up to what was taken to be far? Then nothing is, for now.
bool Loop::has_outgrown(Level& level) const {
  if (!is_cut_off(level.trial, level.mesh)) return false;
  for (auto& outlines : level.mesh.bodies)
    for (sketch::MeshedOutline& outline : outlines)
      for (sketch::MeshedCurve& curve : outline.curves) curve.far.clear();
  return true;
}

// The next coarse mesh: what is far by now left out, what adds most bisected.
Level Loop::next_mesh(const Level& level, const Distance& distance) {
  sketch::Mesh mesh = level.mesh;
  mark_far(s_, level.trial, mesh);
  double worst = 0;
  for (const double p : distance.pressure) worst = std::max(worst, p);
  if (worst > kStalls * worst_) rest_ /= 8;
  worst_ = worst;
  return {sketch::refined(s_, mesh, marks(distance)), {}, {}};
}

// Is the distance what marks() asks for?
bool Loop::is_near(const Distance& d) const {
  double wanted = s_.tolerance;
  for (const sketch::Want& want : s_.wants) wanted = std::min(wanted, want.tolerance.value_or(s_.tolerance));
  return std::all_of(d.pressure.begin(), d.pressure.end(), [&](double p) { return p < strictness_ * wanted / kPredicted; });
}

// By as much as the worst number is off.
void Loop::tighten() {
  double worst = 1;
  for (const app::Stated& s : out_.loop.stated)
    if (!s.is_met()) worst = std::max(worst, s.error / (s.tolerance * s.scale));
  strictness_ *= std::clamp(1 / worst, 0.15, 0.6);
}

sketch::Levels Loop::marks(const Distance& d) const {
  double wanted = s_.tolerance;
  for (const sketch::Want& want : s_.wants) wanted = std::min(wanted, want.tolerance.value_or(s_.tolerance));
  const double pressure = strictness_ * wanted / kPredicted, energy = 4 * strictness_ * rest_ * wanted;
  size_t parts = 0, all = 0;
  for (const auto& shares : d.shares) {
    all += shares.size();
    for (const Share& s : shares) parts += s.pressure > 0 ? 1 : 0;
  }
  sketch::Levels out;
  double worst = 0;
  for (const auto& shares : d.shares)
    for (const Share& s : shares)
      worst =
          std::max({worst, s.pressure / pressure * static_cast<double>(parts), s.energy / energy * static_cast<double>(all)});
  const double least = std::min(1.0, 0.3 * worst); // the largest are marked in any case
  for (const auto& shares : d.shares) {
    out.push_back({});
    for (const Share& s : shares) {
      const double excess =
          std::max(s.pressure / pressure * static_cast<double>(parts), s.energy / energy * static_cast<double>(all));
      const int more = excess > 1 ? static_cast<int>(std::log(excess) / std::log(s.edge ? kEdge : kSmooth)) : 0;
      out.back().push_back(excess > least ? std::min(1 + more, kMostLevels) : 0);
    }
  }
  return out;
}

bool Loop::take(Level& level, const std::string& why) {
  out_.mesh = level.mesh;
  out_.deck = level.deck;
  out_.loop.taken = out_.loop.rounds.size() - 1;
  if (out_.loop.stopped.empty()) out_.loop.stopped = why;
  return true;
}

void Loop::search() {
  Level coarse, middle, fine;
  coarse.mesh = sketch::first_mesh(s_, kFirst);
  for (int round = 0; round < kMostRounds; ++round) {
    coarse.trial = Trial();
    if (!solve_level(coarse, nullptr, true)) return;
    told_(out_.loop.rounds.back());
    if (has_outgrown(coarse) || (round == 0 && mark_far(s_, coarse.trial, coarse.mesh))) continue;
    middle = Level{sketch::halved(s_, coarse.mesh), {}, {}};
    if (!is_within_limits(middle.mesh) || !solve_level(middle, &coarse.trial, false)) {
      if (out_.deck.empty()) take(coarse, "");
      return;
    }
    const Distance first = distance_of(coarse, middle);
    tell_distance(first, middle.trial, out_.loop.rounds.back());
    told_(out_.loop.rounds.back());
    judge(nullptr, coarse, middle, nullptr, first);
    take(middle, "");
    // What two meshes say of the one after them.
    bool promising = true;
    for (const app::Stated& s : out_.loop.stated)
      promising = promising && (std::isnan(s.tolerance) || 0.35 * s.error <= s.tolerance * s.scale);
    if (promising) {
      fine = Level{sketch::halved(s_, middle.mesh), {}, {}};
      if (!is_within_limits(fine.mesh) || !solve_level(fine, &middle.trial, false)) return;
      const Distance second = distance_of(middle, fine);
      tell_distance(second, fine.trial, out_.loop.rounds.back());
      told_(out_.loop.rounds.back());
      judge(&coarse, middle, fine, &first, second);
      take(fine, "");
      if (all_met()) return;
      tighten();
      coarse = next_mesh(middle, second);
    } else {
      if (is_near(first)) tighten();
      coarse = next_mesh(coarse, first);
    }
    if (!is_within_limits(coarse.mesh)) return;
  }
  out_.loop.stopped = "after " + std::to_string(kMostRounds) + " rounds";
}

Adapted Loop::run() {
  search();
  std::string& stopped = out_.loop.stopped;
  if (!history_.empty()) stopped = "the history ended early: " + history_ + (stopped.empty() ? "" : "; " + stopped);
  return std::move(out_);
}

} // namespace

Adapted adapt(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& told) {
  return Loop(sketch, demand, told).run();
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
