// Marking of elements for bisection (METHOD 16.5): elements with a share, METHOD (16.6), above that of a mesh with equal shares
// that meets the tolerance, elements at the places of numbers not yet met, and neighbours of these.
#include "program/estimate/marks.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kEdge = 2.8, kSmoothShare = 8; // factor by which bisection reduces a share
constexpr double kLargest = 0.3;                // of the largest share: always marked
constexpr int kMostLevels = 2;
constexpr double kSteep = 4;   // ratio of the shares of neighbours beside a singular point
constexpr int kMostGraded = 6; // bisections toward it
constexpr double kAlone = 0.2; // share of an element that is much longer than the contact within it
constexpr int kMostAlone = 4;  // bisections toward its touching end

// Grades elements at the ends of curves: bisected in equal parts, the share beside a singular point would fall but slowly.
void grade(const sketch::MeshedCurve& curve, const double* excess, sketch::Bisection* bisections) {
  const size_t last = curve.elements() - 1;
  if (curve.curve->contact >= 0 || last == 0) return;
  const auto toward = [&](size_t e, size_t next, int end) {
    if (bisections[e].level < kMostLevels || excess[e] < kSteep * excess[next]) return;
    bisections[e] = {std::min(1 + static_cast<int>(std::log(excess[e]) / std::log(kEdge)), kMostGraded), end};
  };
  toward(0, 1, -1);
  toward(last, last - 1, 1);
}

} // namespace

bool is_place(const app::Stated& s) { return !std::isnan(s.at[0]) && app::row_of(s.what).place == app::PlaceKind::kRefined; }

std::vector<sketch::Spot> edges_of(const Trial& trial) {
  using app::Measure;
  std::vector<sketch::Spot> out;
  for (const State& state : trial.states)
    for (const app::Quantity& q : state.quantities)
      if (state.turn && !std::isnan(q.at[0]) && (q.what == Measure::kContactEdge || q.what == Measure::kStickBorder))
        out.push_back({trial.zones[static_cast<size_t>(q.zone) - 1][1].body, {q.at[0], q.at[1]}});
  return out;
}

sketch::Levels marks(const sketch::Mesh& mesh, const Distance& distance, double pressure, double energy) {
  size_t parts = 0, all = 0;
  for (const auto& shares : distance.shares) {
    all += shares.size();
    for (const Share& s : shares) parts += s.pressure > 0 ? 1 : 0;
  }
  double worst = 0;
  std::vector<std::vector<double>> excess;
  for (const auto& shares : distance.shares) {
    excess.push_back({});
    for (const Share& s : shares) {
      excess.back().push_back(
          std::max(s.pressure / pressure * static_cast<double>(parts), s.energy / energy * static_cast<double>(all)));
      worst = std::max(worst, excess.back().back());
    }
  }
  const double least = std::min(1.0, kLargest * worst);
  sketch::Levels out;
  for (size_t b = 0; b < excess.size(); ++b) {
    out.push_back({});
    for (size_t i = 0; i < excess[b].size(); ++i) {
      const Share& s = distance.shares[b][i];
      const double e = excess[b][i];
      const int more = e > 1 ? static_cast<int>(std::log(e) / std::log(s.edge ? kEdge : kSmoothShare)) : 0;
      const bool alone = s.pressure > kAlone && s.touch != 0;
      out.back().push_back({e > least ? std::min(1 + more, alone ? kMostAlone : kMostLevels) : 0, alone ? s.touch : 0});
    }
  }
  for (size_t b = 0; b < mesh.bodies.size(); ++b) {
    size_t first = 0;
    for (const sketch::MeshedOutline& outline : mesh.bodies[b])
      for (const sketch::MeshedCurve& curve : outline.curves) {
        grade(curve, &excess[b][first], &out[b][first]);
        first += curve.elements();
      }
  }
  return out;
}

void mark_places(const sketch::Sketch& sketch, const Trial& trial, const std::vector<app::Stated>& stated, sketch::Mesh& mesh,
                 sketch::Levels& levels) {
  for (const app::Stated& s : stated) {
    if (s.is_within() || !is_place(s)) continue;
    const int32_t at = s.zone > 0 ? trial.zones[static_cast<size_t>(s.zone) - 1][1].body : s.body - 1;
    const auto body = static_cast<size_t>(at);
    const sketch::Located place = sketch::locate(sketch, {at, {s.at[0], s.at[1]}}, s.zone > 0, mesh);
    if (place.curve == nullptr) continue;
    const std::vector<double>& ends = place.curve->ends;
    const size_t last = ends.size() - 2;
    size_t e = static_cast<size_t>(std::upper_bound(ends.begin(), ends.end(), place.length) - ends.begin());
    e = std::min(e == 0 ? 0 : e - 1, last);
    for (size_t k = e == 0 ? 0 : e - 1; k <= std::min(e + 1, last); ++k)
      levels[body][place.first + k].level = std::max(levels[body][place.first + k].level, 1);
  }
}

} // namespace estimate
