#include "program/estimate/wanted.hpp"

#include "program/sketch/cycle.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

using sketch::Want;

constexpr const char* kStresses[3] = {"stress xx", "stress yy", "stress xy"};

app::Stated number(const std::string& name, size_t body, double value, double scale, double tolerance) {
  app::Stated s;
  s.name = name;
  s.body = static_cast<int32_t>(body) + 1;
  s.value = value, s.scale = scale, s.tolerance = tolerance;
  return s;
}

// How far a stress goes over states.
struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void take(double v) { low = std::min(low, v), high = std::max(high, v); }
  double size() const { return high - low; }
  double largest() const { return std::max(std::fabs(low), std::fabs(high)); }
};

// The three stresses at a place, at the end, and how far each goes from the state `first` on; of a cycle this alone.
void add_place(std::vector<app::Stated>& out, const Trial& trial, const Want& want, size_t place, double tolerance,
               size_t first) {
  Range range[3];
  double largest = 0;
  for (size_t i = first; i < trial.states.size(); ++i)
    for (size_t c = 0; c < 3; ++c) range[c].take(trial.states[i].inside[place][c + 2]);
  for (const Range& r : range) largest = std::max(largest, r.largest());
  const auto add = [&](const std::string& name, double value) {
    out.push_back(number(name, static_cast<size_t>(want.body), value, largest, tolerance));
    out.back().at[0] = want.where.x, out.back().at[1] = want.where.y;
  };
  for (size_t c = 0; c < 3 && first < trial.states.size(); ++c) {
    if (!want.cycle) add(kStresses[c], trial.states.back().inside[place][c + 2]);
    add(std::string(want.cycle ? "cycle range of " : "range of ") + kStresses[c], range[c].size());
  }
}

// A value along curves and where it is.
struct Along {
  double value;
  sketch::Point at;
};

// The largest and the smallest stress along curves from the state `first` on, and the largest range at one place; of a cycle
// this alone.
void add_hoop(std::vector<app::Stated>& out, const sketch::Mesh& mesh, const Trial& trial, const Want& want, double tolerance,
              size_t first) {
  const auto body = static_cast<size_t>(want.side->body);
  Along high{-HUGE_VAL, {}}, low{HUGE_VAL, {}}, widest{-1, {}};
  size_t element = 0;
  for (const sketch::MeshedOutline& outline : mesh.bodies[body])
    for (const sketch::MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e, ++element) {
        if (!want.side->has(curve.curve->name)) continue;
        for (int32_t i = 0; i < trial.nodes; ++i) {
          const double f = trial.nodes == 1 ? 0.5 : static_cast<double>(i) / (trial.nodes - 1);
          const double s = curve.ends[e] + f * (curve.ends[e + 1] - curve.ends[e]);
          const sketch::Point p = curve.curve->shape->at(curve.measure.u_at(s));
          const size_t end = element * static_cast<size_t>(trial.nodes) + static_cast<size_t>(i);
          Range range;
          for (size_t k = first; k < trial.states.size(); ++k) range.take(trial.states[k].ends[body][kHoop][end]);
          if (range.high > high.value) high = {range.high, p};
          if (range.low < low.value) low = {range.low, p};
          if (range.size() > widest.value) widest = {range.size(), p};
        }
      }
  if (widest.value < 0) return;
  const auto add = [&](const char* name, const Along& a) {
    const double scale = std::max(std::fabs(high.value), std::fabs(low.value));
    out.push_back(number(name + want.side->names[0], body, a.value, scale, tolerance));
    out.back().at[0] = a.at.x, out.back().at[1] = a.at.y;
  };
  if (want.cycle) return add("cycle range of stress along ", widest);
  add("largest stress along ", high), add("smallest stress along ", low), add("range of stress along ", widest);
}

// The state at which the history's last cycle begins; behind the last one if it ended before the cycle did.
size_t state_of_cycle(const sketch::Sketch& sketch, const Trial& trial) {
  const int start = sketch::cycle_start(sketch);
  int turns = 0;
  for (size_t i = 0; i < trial.states.size() && trial.outcome == C2D_REACHED; ++i)
    if (trial.states[i].turn && ++turns == start) return i;
  return trial.states.size();
}

} // namespace

void ask(const sketch::Sketch& sketch, Demand& demand) {
  for (const Want& want : sketch.wants) {
    if (want.kind == Want::kStress) demand.points.push_back({want.body + 1, want.where.x, want.where.y});
    demand.all_steps = demand.all_steps || want.kind == Want::kStress || want.kind == Want::kHoop;
  }
}

// Cycles come last: a history that ends early has none, and the others keep their places.
std::vector<app::Stated> wanted_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  std::vector<app::Stated> out;
  for (const bool cycle : {false, true}) {
    const size_t first = cycle ? state_of_cycle(sketch, trial) : 0;
    size_t places = 0;
    for (const Want& want : sketch.wants) {
      const size_t place = places;
      if (want.kind == Want::kStress) ++places;
      if (want.cycle != cycle) continue;
      const double tolerance = want.tolerance.value_or(sketch.tolerance);
      if (want.kind == Want::kStress) add_place(out, trial, want, place, tolerance, first);
      if (want.kind == Want::kHoop) add_hoop(out, mesh, trial, want, tolerance, first);
    }
  }
  return out;
}

} // namespace estimate
