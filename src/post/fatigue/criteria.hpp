// Fatigue parameters of a stress cycle at a point of an isotropic elastic body.
#pragma once

#include "post/fatigue/states.hpp"

namespace app {

enum class FatigueCriterion { kSwt, kFatemiSocie, kFindley, kCrossland, kDangVan };

struct FatigueMaterial {
  double youngs_modulus = 1, poisson_ratio = 0;
  double fatemi_socie = 0; // k over the yield stress
  double findley = 0, crossland = 0, dang_van = 0;
};

struct FatigueValue {
  double value = 0;
  double angle = 0; // of the normal of the plane from x, in degrees; NaN: the parameter has no plane
};

// SWT: s de/2. Fatemi-Socie: dg/2 (1 + k s/s_y). Findley: dt/2 + k s. Each the largest over the planes whose normal lies in the
// x-y plane, s the largest normal stress on the plane (SWT and Fatemi-Socie: at least 0), de, dg and dt the ranges of normal
// strain, shear strain (engineering) and shear stress.
// Crossland: sqrt(J2a) + alpha p, p the largest hydrostatic stress, sqrt(J2a) the radius of the smallest ball round the path of
// the deviator, in the norm sqrt(s:s/2).
// Dang Van: the largest over the states of t + a p, t the largest shear stress of the deviator less the centre of that ball.
// All are largest at corners of the cycle, so that nothing between them is needed.
// The value is no larger than this, which costs little; infinite for parameters without a plane.
double fatigue_bound(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& material);
FatigueValue fatigue_value(FatigueCriterion criterion, const StressCycle& cycle, const FatigueMaterial& material);

} // namespace app
