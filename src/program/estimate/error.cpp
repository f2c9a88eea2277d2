#include "program/estimate/error.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kSmooth = 0.4; // what is left of an error at least, from a mesh to the halved one
// Error of the coarse mesh over its distance from the finer one, whose own error is no larger than that.
constexpr double kOfCoarse = 2.2;
constexpr double kNoEarlier = 2; // with nothing but two meshes
// Places lie between pairs: of the distance of these.
constexpr double kEdgeOfPairs = 0.2, kBorderOfPairs = 0.2;
constexpr double kExact = 1e-7; // numbers nearer than that on both meshes are given by the loads
constexpr double kRoundOff = 1e-9;
// An intensity is fitted through a number of pairs: what that adds stays as meshes become finer.
constexpr double kEdgeFit = 3e-3;

bool is_same(const app::Quantity& a, const app::Quantity& b) {
  return a.what == b.what && a.zone == b.zone && a.item == b.item;
}
const app::Quantity* find(const State& state, const app::Quantity& wanted) {
  const auto found = std::find_if(state.quantities.begin(), state.quantities.end(),
                                  [&](const app::Quantity& q) { return is_same(q, wanted); });
  return found == state.quantities.end() ? nullptr : &*found;
}

double distance_of(const Distance& d, int32_t zone) {
  if (zone > 0) return static_cast<size_t>(zone) <= d.pressure.size() ? d.pressure[static_cast<size_t>(zone) - 1] : 0;
  double largest = 0;
  for (const double p : d.pressure) largest = std::max(largest, p);
  return largest;
}

// What the error of a number is to be compared with.
double scale_of(const State& state, const app::Quantity& q) {
  using app::Measure;
  double forces = 0, largest = 0, mean = 0;
  int edges = 0;
  for (const app::Quantity& other : state.quantities) {
    if (other.what == Measure::kApproach || other.what == Measure::kShift) largest = std::max(largest, std::fabs(other.value));
    if (other.zone != q.zone) continue;
    if (other.what == Measure::kForceX || other.what == Measure::kForceY) forces = std::hypot(forces, other.value);
    if (other.what == Measure::kMeanPressure) mean = other.value;
    if (other.what == Measure::kContactEdge) ++edges;
  }
  switch (q.what) {
  case Measure::kFrictionForce:
  case Measure::kForceX:
  case Measure::kForceY: return forces;
  case Measure::kMoment: return std::max(std::fabs(q.value), mean > 0 ? forces * forces / mean : 0.0);
  case Measure::kApproach:
  case Measure::kShift: return largest;
  case Measure::kContactEdge:
  case Measure::kStickBorder: return mean > 0 ? forces / mean / std::max(1, edges) : std::fabs(q.value);
  default: return std::fabs(q.value);
  }
}

// What an agreement of two meshes may hide, of the distance of the tractions: values that happen to be near each other tell
// nothing of those that do not.
double doubt(app::Measure what) {
  using app::Measure;
  switch (what) {
  case Measure::kPeakPressure: return 0.5;
  case Measure::kContactEdge: return 0.25;
  case Measure::kStickBorder: return 0.5;
  case Measure::kSlipRange:
  case Measure::kDissipated: return 2;
  case Measure::kEdgePressure:
  case Measure::kEdgeFriction: return 3;
  case Measure::kMeanPressure: return 0.5;
  default: return 0.2;
  }
}

// How far two values of a number are apart; places by their positions, since lengths begin at a pair that may be another.
double apart(const app::Quantity& a, const app::Quantity& b) {
  const bool place = a.what == app::Measure::kContactEdge || a.what == app::Measure::kStickBorder;
  return place && !std::isnan(a.at[0]) && !std::isnan(b.at[0]) ? std::hypot(a.at[0] - b.at[0], a.at[1] - b.at[1])
                                                               : std::fabs(a.value - b.value);
}

// What a number's values are taken to be apart at least, `step` that they are: d of the tractions, of the size `scale`.
double floor_of(const app::Quantity& q, double step, double d, double scale) {
  using app::Measure;
  if (step <= kExact * scale) return kRoundOff * scale;
  const double floor = doubt(q.what) * d * scale;
  switch (q.what) {
  case Measure::kContactEdge: return floor + kEdgeOfPairs * q.spacing;
  case Measure::kStickBorder: return floor + kBorderOfPairs * q.spacing;
  case Measure::kEdgePressure:
  case Measure::kEdgeFriction: return std::max(floor, kEdgeFit * scale);
  default: return floor;
  }
}

// How far apart two meshes have a number, and, if that is less, a little more than it has moved since the round before.
double step_of(const app::Quantity& coarse, const app::Quantity& fine, const app::Quantity* earlier) {
  const double step = apart(coarse, fine);
  return earlier == nullptr ? step : std::clamp(2 * apart(*earlier, fine), kSmooth * step, step);
}

} // namespace

double stated_error(double apart, double floor) { return std::max(apart, floor); }

std::vector<app::Stated> state_numbers(const Trial& coarse, const Trial& halved, const Distance& between,
                                       const Trial* earlier) {
  std::vector<app::Stated> out;
  for (size_t z = 0; z < between.pressure.size(); ++z) {
    if (halved.tied[z] != 0) continue;
    app::Stated s;
    s.name = kTractions;
    s.zone = static_cast<int32_t>(z) + 1;
    s.value = s.scale = 1;
    s.error = stated_error(between.pressure[z], 0) * (earlier == nullptr ? kNoEarlier : 1);
    out.push_back(s);
  }
  const size_t common = std::min(halved.states.size(), coarse.states.size()); // a history may end early
  if (common == 0) return out;
  const State &f = halved.states[common - 1], &c = coarse.states[common - 1];
  const State* b = earlier != nullptr && earlier->states.size() >= common ? &earlier->states[common - 1] : nullptr;
  for (const app::Quantity& q : f.quantities) {
    const app::Quantity* other = find(c, q);
    app::Stated s;
    s.name = app::name_of(q.what);
    s.zone = q.zone, s.item = q.item, s.value = q.value;
    s.at[0] = q.at[0], s.at[1] = q.at[1];
    s.scale = scale_of(f, q);
    if (other != nullptr) {
      s.error = stated_error(step_of(*other, q, b == nullptr ? nullptr : find(*b, q)),
                             floor_of(q, apart(*other, q), distance_of(between, q.zone), s.scale));
      if (b == nullptr) s.error *= kNoEarlier;
    }
    out.push_back(s);
  }
  return out;
}

std::vector<app::Stated> state_of_coarse(const Trial& coarse, const Trial& halved, const Distance& between) {
  std::vector<app::Stated> out = state_numbers(coarse, halved, between, nullptr);
  for (app::Stated& s : out) {
    s.error *= kOfCoarse / kNoEarlier; // an error of the finer mesh falls by this rate
    for (const app::Quantity& q : coarse.states.back().quantities)
      if (s.zone == q.zone && s.item == q.item && s.name == app::name_of(q.what)) {
        s.value = q.value;
        s.at[0] = q.at[0], s.at[1] = q.at[1];
      }
  }
  return out;
}

} // namespace estimate
