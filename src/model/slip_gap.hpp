#pragma once
// What sliding adds to the gap of a pair where the surfaces' curvature changes along them, METHOD 8.7. The motion along the
// drawn normal is that of both profiles to the first order; where a pair slides past a change of curvature it has a kink, which
// surfaces that slide have not. So the gap is that of the points that have come to face each other.
#include "model/free_zones.hpp"

namespace c2d {

// Finds the pairs whose gap follows their slip. Once the model has its frames.
void find_slip_gaps(const Model& m);
// What slip by w_t = s, in the caller's unit, adds to the gap along n between two points that faced each other. Beyond the ends
// of the curves that are given it stays what it is there.
double slip_gap(const Model& m, const Zone& z, const FacePoint at[2], const double n[2], double s, double even);
// The same of a pair.
double slip_gap(const Model& m, int32_t pair, double s);

} // namespace c2d
