#pragma once
// Change of the gap of a pair due to slip where the curvature of the surfaces varies, METHOD 8.7. The motion along the original
// normal displaces both profiles to first order only; past a change of curvature the gap gets a kink that real sliding surfaces
// have not. So the gap is evaluated at the points that face each other after the slip.
#include "model/free_zones.hpp"

namespace c2d {

// Finds the pairs whose gap follows their slip. Once the model has its frames.
void find_slip_gaps(const Model& m);
// Change of the gap along n, due to slip w_t = s in the caller's unit, between two points that faced each other. Beyond the
// ends of the given curves it is constant.
double slip_gap(const Model& m, const Zone& z, const FacePoint at[2], const double n[2], double s, double even);
// The same for a pair.
double slip_gap(const Model& m, int32_t pair, double s);

} // namespace c2d
