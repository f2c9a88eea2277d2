// The largest value of a fatigue parameter over the planes whose normal lies in the x-y plane.
#pragma once

#include <vector>

namespace app {

// A stress or strain on the plane with the normal (cos t, sin t): mean + cosine cos 2t + sine sin 2t.
struct PlaneWave {
  double mean = 0, cosine = 0, sine = 0;
};

// The parameter W/2 (alone + times S) + stress S of a plane: S the largest of its normal stresses, W the range of its strains
// or shear stresses, over the states. alone + times S must not be negative on any plane: give S the wave 0 if it may be.
struct PlaneParameter {
  double alone = 0, times = 0, stress = 0;
};

struct PlaneMaximum {
  double value = 0, angle = 0; // of the normal from x, in degrees, above -90 and at most 90
};
PlaneMaximum largest_over_planes(const std::vector<PlaneWave>& stress, const std::vector<PlaneWave>& ranged,
                                 const PlaneParameter& parameter);

} // namespace app
