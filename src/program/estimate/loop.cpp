#include "program/estimate/loop.hpp"

#include "program/estimate/error.hpp"
#include "program/sketch/refine.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kFirst = 0.25;  // fineness of the first mesh
constexpr int kMostRounds = 12, kMostLevels = 5;
constexpr double kPredicted = 0.3; // from the distance of two meshes to the error of the one after them
constexpr double kEdge = 4, kSmooth = 32; // by how much a share falls if its element is bisected

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
  bool solve_level(Level& level, const Trial* before, bool adapted);
  bool is_within_limits(const sketch::Mesh& mesh);
  void judge(const Trial* coarse, const Trial& middle, const Trial& fine, const Distance* before, const Distance& last);
  bool all_met() const;
  sketch::Levels marks(const Level& level, const Distance& distance) const;
  double tolerance(sketch::Want::Kind kind) const;
  bool take(Level& level, const std::string& why);

  const sketch::Sketch& s_;
  const Demand& demand_;
  const std::function<void(const app::MeshRound&)>& told_;
  Adapted out_;
  double seconds_ = 0;
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
  app::MeshRound round;
  round.elements = level.trial.elements, round.pairs = level.trial.pairs, round.equations = level.trial.equations;
  round.seconds = level.trial.seconds;
  round.adapted = adapted;
  out_.loop.rounds.push_back(round);
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

void Loop::judge(const Trial* coarse, const Trial& middle, const Trial& fine, const Distance* before, const Distance& last) {
  using sketch::Want;
  out_.loop.stated = state_numbers(coarse, middle, fine, before, last);
  for (app::Stated& s : out_.loop.stated) {
    if (s.name == "tractions, L2" || s.name == app::name_of(app::Measure::kPeakPressure)) s.tolerance = tolerance(Want::kPressure);
    if (s.name == app::name_of(app::Measure::kContactEdge) || s.name == app::name_of(app::Measure::kStickBorder))
      s.tolerance = tolerance(Want::kEdges);
    if (s.name == app::name_of(app::Measure::kForceX) || s.name == app::name_of(app::Measure::kForceY))
      s.tolerance = tolerance(Want::kForces);
    if (s.name == app::name_of(app::Measure::kApproach)) s.tolerance = tolerance(Want::kApproach);
    if (s.name == app::name_of(app::Measure::kDissipated)) s.tolerance = tolerance(Want::kDissipation);
    if (s.zone > 0 && fine.tied[static_cast<size_t>(s.zone) - 1] != 0) s.tolerance = NAN;
  }
}

bool Loop::all_met() const {
  return std::all_of(out_.loop.stated.begin(), out_.loop.stated.end(), [](const app::Stated& s) { return s.is_met(); });
}

// Elements whose shares are above those of a mesh that meets the tolerances with shares alike.
sketch::Levels Loop::marks(const Level& level, const Distance& d) const {
  double wanted = s_.tolerance;
  for (const sketch::Want& want : s_.wants) wanted = std::min(wanted, want.tolerance.value_or(s_.tolerance));
  const double pressure = std::pow(wanted / kPredicted, 2), energy = 4 * wanted;
  std::vector<char> contact; // of every zone: does it count?
  size_t parts = 0, all = 0;
  for (const auto& shares : d.shares) {
    all += shares.size();
    for (const Share& s : shares) parts += s.pressure > 0 ? 1 : 0;
  }
  sketch::Levels out;
  double worst = 0;
  for (const auto& shares : d.shares)
    for (const Share& s : shares)
      worst = std::max({worst, s.pressure / pressure * static_cast<double>(parts), s.energy / energy * static_cast<double>(all)});
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
  if (getenv("C2DBG")) for (size_t b=0;b<d.shares.size();++b){ size_t e=0; for(auto&ol:level.mesh.bodies.size()>b?level.mesh.bodies[b]:std::vector<sketch::MeshedOutline>{}) for(auto&c:ol.curves) for(size_t k=0;k<c.elements();++k,++e){ auto p=c.curve->shape->at(c.measure.u_at((c.ends[k]+c.ends[k+1])/2)); if(d.shares[b][e].pressure>1e-9)printf("b%zu e%zu %.5f %.5f h %.5f share %.3g energy %.3g lev %d\n",b,e,p.x,p.y,c.ends[k+1]-c.ends[k],d.shares[b][e].pressure,d.shares[b][e].energy,out[b][e]);}}
  static_cast<void>(level);
  return out;
}

bool Loop::take(Level& level, const std::string& why) {
  out_.mesh = level.mesh;
  out_.deck = level.deck;
  if (out_.loop.stopped.empty()) out_.loop.stopped = why;
  return true;
}

Adapted Loop::run() {
  Level coarse, middle, fine;
  coarse.mesh = sketch::first_mesh(s_, kFirst);
  for (int round = 0; round < kMostRounds; ++round) {
    coarse.trial = Trial();
    if (!solve_level(coarse, nullptr, true)) return std::move(out_);
    told_(out_.loop.rounds.back());
    middle = Level{sketch::halved(s_, coarse.mesh), {}, {}};
    if (!is_within_limits(middle.mesh) || !solve_level(middle, &coarse.trial, false)) {
      if (out_.deck.empty()) take(coarse, "");
      return std::move(out_);
    }
    const Distance first = distance_of(coarse, middle);
    app::MeshRound& told = out_.loop.rounds.back();
    for (size_t z = 0; z < first.pressure.size(); ++z)
      if (middle.trial.tied[z] == 0) told.pressure = std::fmax(told.pressure, first.pressure[z]);
    told.energy = first.energy;
    told_(told);
    judge(nullptr, coarse.trial, middle.trial, nullptr, first);
    take(middle, "");
    // What two meshes say of the one after them.
    bool promising = true;
    for (const app::Stated& s : out_.loop.stated)
      promising = promising && (std::isnan(s.tolerance) || 0.35 * s.error <= s.tolerance * s.scale);
    sketch::Levels marked;
    if (promising) {
      fine = Level{sketch::halved(s_, middle.mesh), {}, {}};
      if (!is_within_limits(fine.mesh) || !solve_level(fine, &middle.trial, false)) return std::move(out_);
      const Distance second = distance_of(middle, fine);
      app::MeshRound& now = out_.loop.rounds.back();
      for (size_t z = 0; z < second.pressure.size(); ++z)
        if (fine.trial.tied[z] == 0) now.pressure = std::fmax(now.pressure, second.pressure[z]);
      now.energy = second.energy;
      told_(now);
      judge(&coarse.trial, middle.trial, fine.trial, &first, second);
      take(fine, "");
      if (all_met()) return std::move(out_);
      marked = marks(middle, second);
      coarse = Level{sketch::refined(s_, middle.mesh, marked), {}, {}};
    } else {
      marked = marks(coarse, first);
      coarse = Level{sketch::refined(s_, coarse.mesh, marked), {}, {}};
    }
    if (!is_within_limits(coarse.mesh)) return std::move(out_);
  }
  out_.loop.stopped = "after " + std::to_string(kMostRounds) + " rounds";
  return std::move(out_);
}

} // namespace

Adapted adapt(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& told) {
  return Loop(sketch, demand, told).run();
}

} // namespace estimate
