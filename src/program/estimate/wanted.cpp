#include "program/estimate/wanted.hpp"

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

// The three stresses at a place, at the end, and how far each goes over the history.
void add_place(std::vector<app::Stated>& out, const Trial& trial, const Want& want, size_t place, double tolerance) {
  double largest = 0, low[3], high[3];
  std::fill(low, low + 3, HUGE_VAL), std::fill(high, high + 3, -HUGE_VAL);
  for (const State& state : trial.states)
    for (size_t c = 0; c < 3; ++c) {
      const double v = state.inside[place][c + 2];
      largest = std::max(largest, std::fabs(v));
      low[c] = std::min(low[c], v), high[c] = std::max(high[c], v);
    }
  for (size_t c = 0; c < 3 && !trial.states.empty(); ++c) {
    const auto body = static_cast<size_t>(want.body);
    out.push_back(number(kStresses[c], body, trial.states.back().inside[place][c + 2], largest, tolerance));
    out.push_back(number(std::string("range of ") + kStresses[c], body, high[c] - low[c], largest, tolerance));
    for (size_t k = out.size() - 2; k < out.size(); ++k) out[k].at[0] = want.where.x, out[k].at[1] = want.where.y;
  }
}

// The largest and the smallest stress along curves over the history, and the largest range at one place.
void add_hoop(std::vector<app::Stated>& out, const sketch::Mesh& mesh, const Trial& trial, const Want& want, double tolerance) {
  const auto body = static_cast<size_t>(want.side->body);
  double value[3] = {-HUGE_VAL, HUGE_VAL, -1}; // largest, smallest, range
  sketch::Point at[3];
  const auto take = [&](size_t k, double v, sketch::Point p) {
    if (k == 1 ? v < value[k] : v > value[k]) value[k] = v, at[k] = p;
  };
  size_t element = 0;
  for (const sketch::MeshedOutline& outline : mesh.bodies[body])
    for (const sketch::MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e, ++element) {
        if (!want.side->has(curve.curve->name)) continue;
        for (int32_t i = 0; i < trial.nodes; ++i) {
          const double f = trial.nodes == 1 ? 0.5 : static_cast<double>(i) / (trial.nodes - 1);
          const double s = curve.ends[e] + f * (curve.ends[e + 1] - curve.ends[e]);
          const sketch::Point p = curve.curve->shape->at(curve.measure.u_at(s));
          double low = HUGE_VAL, high = -HUGE_VAL;
          for (const State& state : trial.states) {
            const double v = state.ends[body][kHoop][element * static_cast<size_t>(trial.nodes) + static_cast<size_t>(i)];
            low = std::min(low, v), high = std::max(high, v);
          }
          take(0, high, p), take(1, low, p), take(2, high - low, p);
        }
      }
  if (value[2] < 0) return;
  const double scale = std::max(std::fabs(value[0]), std::fabs(value[1]));
  const char* const names[3] = {"largest stress along ", "smallest stress along ", "range of stress along "};
  for (size_t k = 0; k < 3; ++k) {
    out.push_back(number(names[k] + want.side->names[0], body, value[k], scale, tolerance));
    out.back().at[0] = at[k].x, out.back().at[1] = at[k].y;
  }
}

} // namespace

std::vector<Place> places_of(const sketch::Sketch& sketch) {
  std::vector<Place> out;
  for (const Want& want : sketch.wants)
    if (want.kind == Want::kStress) out.push_back({want.body + 1, want.where.x, want.where.y});
  return out;
}

std::vector<app::Stated> wanted_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  std::vector<app::Stated> out;
  size_t place = 0;
  for (const Want& want : sketch.wants) {
    const double tolerance = want.tolerance.value_or(sketch.tolerance);
    if (want.kind == Want::kStress) add_place(out, trial, want, place++, tolerance);
    if (want.kind == Want::kHoop) add_hoop(out, mesh, trial, want, tolerance);
  }
  return out;
}

} // namespace estimate
