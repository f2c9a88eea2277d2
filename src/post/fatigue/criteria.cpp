#include "post/fatigue/criteria.hpp"

#include "post/fatigue/ball.hpp"
#include "post/fatigue/planes.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kSameState = 1e-13; // of the largest stress: closer states are one

double largest_of(const StressCycle& cycle) {
  double out = 0;
  for (const StressState& s : cycle) out = std::max({out, std::fabs(s.xx), std::fabs(s.yy), std::fabs(s.xy), std::fabs(s.zz)});
  return out;
}

// Without the states that repeat the one before.
StressCycle without_repeats(const StressCycle& cycle) {
  const double same = kSameState * largest_of(cycle);
  StressCycle out;
  for (const StressState& s : cycle) {
    const StressState d = out.empty() ? StressState{} : s + -1.0 * out.back();
    if (out.empty() || std::max({std::fabs(d.xx), std::fabs(d.yy), std::fabs(d.xy), std::fabs(d.zz)}) > same) out.push_back(s);
  }
  return out;
}

PlaneWave normal_stress(const StressState& s) { return {(s.xx + s.yy) / 2, (s.xx - s.yy) / 2, s.xy}; }
PlaneWave shear_stress(const StressState& s) { return {0, s.xy, -(s.xx - s.yy) / 2}; }

// ((1 + nu) s_n - nu (xx + yy + zz)) / E
PlaneWave normal_strain(const StressState& s, const FatigueMaterial& m) {
  const PlaneWave n = normal_stress(s);
  const double f = (1 + m.poisson_ratio) / m.youngs_modulus;
  return {f * n.mean - m.poisson_ratio * (s.xx + s.yy + s.zz) / m.youngs_modulus, f * n.cosine, f * n.sine};
}
PlaneWave shear_strain(const StressState& s, const FatigueMaterial& m) { // engineering: shear stress over G
  const PlaneWave t = shear_stress(s);
  const double f = 2 * (1 + m.poisson_ratio) / m.youngs_modulus;
  return {0, f * t.cosine, f * t.sine};
}

// The waves of the states, and the parameter of them.
struct PlaneProblem {
  std::vector<PlaneWave> stress, ranged;
  PlaneParameter parameter;
};
PlaneProblem problem_of(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& m) {
  PlaneProblem out;
  for (const StressState& s : cycle) {
    out.stress.push_back(normal_stress(s));
    out.ranged.push_back(criterion == FatigueCriterion::kSwt           ? normal_strain(s, m)
                         : criterion == FatigueCriterion::kFatemiSocie ? shear_strain(s, m)
                                                                       : shear_stress(s));
  }
  out.parameter = {0, 1, 0};
  if (criterion == FatigueCriterion::kFatemiSocie) out.parameter = {1, m.fatemi_socie, 0};
  if (criterion == FatigueCriterion::kFindley)
    out.parameter = {1, 0, m.findley};
  else
    out.stress.push_back({}); // compression does not count
  return out;
}

FatigueValue on_planes(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& m) {
  const PlaneProblem p = problem_of(criterion, cycle, m);
  const PlaneMaximum most = largest_over_planes(p.stress, p.ranged, p.parameter);
  return {most.value, most.angle};
}

double hydrostatic(const StressState& s) { return (s.xx + s.yy + s.zz) / 3; }

// The deviator by three coordinates whose distance is sqrt(s:s/2).
SpacePoint deviator(const StressState& s) { return {(s.xx - s.yy) / 2, s.xy, std::sqrt(0.75) * (s.zz - hydrostatic(s))}; }

// Half the difference of the largest and the smallest principal stress of a deviator.
double largest_shear(const SpacePoint& d) {
  const double in_plane = std::hypot(d[0], d[1]), zz = d[2] / std::sqrt(0.75);
  return std::max(in_plane, (in_plane + 1.5 * std::fabs(zz)) / 2);
}

FatigueValue by_ball(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& m) {
  std::vector<SpacePoint> path;
  double pressure = -HUGE_VAL;
  for (const StressState& s : cycle) path.push_back(deviator(s)), pressure = std::max(pressure, hydrostatic(s));
  const Ball ball = smallest_ball(path);
  if (criterion == FatigueCriterion::kCrossland) return {ball.radius + m.crossland * pressure, NAN};
  double most = -HUGE_VAL;
  for (size_t i = 0; i < path.size(); ++i) {
    SpacePoint d = path[i];
    for (size_t k = 0; k < 3; ++k) d[k] -= ball.centre[k];
    most = std::max(most, largest_shear(d) + m.dang_van * hydrostatic(cycle[i]));
  }
  return {most, NAN};
}

bool has_planes(FatigueCriterion criterion) {
  return criterion != FatigueCriterion::kCrossland && criterion != FatigueCriterion::kDangVan;
}

} // namespace

double fatigue_bound(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& material) {
  if (!has_planes(criterion) || cycle.empty()) return HUGE_VAL;
  const PlaneProblem p = problem_of(criterion, cycle, material);
  double stress = -HUGE_VAL, high = -HUGE_VAL, low = HUGE_VAL;
  for (const PlaneWave& w : p.stress) stress = std::max(stress, w.mean + std::hypot(w.cosine, w.sine));
  for (const PlaneWave& w : p.ranged) {
    const double size = std::hypot(w.cosine, w.sine);
    high = std::max(high, w.mean + size), low = std::min(low, w.mean - size);
  }
  return (high - low) / 2 * (p.parameter.alone + p.parameter.times * stress) + p.parameter.stress * stress;
}

FatigueValue fatigue_value(FatigueCriterion criterion, const StressCycle& all, const FatigueMaterial& material) {
  if (all.empty()) return {0, NAN};
  const StressCycle cycle = without_repeats(all);
  return has_planes(criterion) ? on_planes(criterion, cycle, material) : by_ball(criterion, cycle, material);
}

} // namespace app
