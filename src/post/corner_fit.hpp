// Generalised stress intensities at a corner, by least squares from results near it (METHOD 10.9).
#pragma once

#include "post/corner_exponent.hpp"

#include <vector>

namespace app {

struct CornerFit {
  double K = 0, K2 = 0; // K2 of a notch alone
  double misfit = 0;    // root mean square of the residual over that of the values; both relative to the first term
  // Change due to the term for the error of the elements at the corner: an estimate of the error, except for linear
  // functions.
  double K_error = 0, K2_error = 0;
};

// Pressures at distances from a corner, p = K d^(lambda - 1) + what follows; of a complex lambda K is the amplitude,
// |c| of Re(c d^(lambda - 1)). `exponents`: those of the corner by rising real part, as many as may count.
struct PressureSample {
  double d, p;
};
CornerFit fit_pressure(const std::vector<PressureSample>& samples, const std::vector<Complex>& exponents);

// Displacements (x, y) of points on both faces of a notch.
struct NotchSample {
  double d;
  bool first; // on the face from which the material is counted counter-clockwise
  double ux, uy;
};
struct Notch {
  Sector sector;
  double bisector = 0; // its direction, into the material, from the x axis
};
// K of the even mode, s_tt = K d^(lambda - 1) / sqrt(2 pi) on the bisector, and K2 of the odd one, with s_rt; 0 where that mode
// is not singular.
CornerFit fit_notch(const std::vector<NotchSample>& samples, const Notch& notch);

// Exponents of the even and the odd modes of a notch with free faces.
std::vector<Complex> notch_exponents(const Sector& sector, bool even, double below = 1);

} // namespace app
