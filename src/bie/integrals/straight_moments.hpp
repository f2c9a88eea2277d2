#pragma once
// Moments of powers against the poles of all kernels, on a straight element: METHOD (3.1). In units of the half chord vector h
// (a complex number), about the middle, a point is z = xi + i zeta, and
//   C_k = int eta^k/(eta-z), D_k = int eta^k/(eta-z)^2, F_k = int eta^k/(eta-z)^3, E_k = int eta^k ln|eta-z|
// over -1 < eta < 1, k < functions. Boundary integrals need C, D and E, stresses inside need F too.
#include "bie/integrals/complex.hpp"
#include "bie/integrals/integrals.hpp"

namespace c2d {

// A point seen from both ends: w1 = z+1, w2 = z-1 and their reciprocals.
struct SeenPoint {
  Complex z, iw1, iw2;
  double xi1, xi2, n1, n2; // Re w1, Re w2, |w1|^2, |w2|^2
};
SeenPoint see(const Integrator& in, double x, double y);

struct Moments {
  Complex c[kElementNodes + 1], d[kElementNodes]; // C_0 ... C_functions
  double e[kElementNodes];
};

// Squared distance from the middle beyond which series in 1/z^2 replace logarithm and angle: the recurrence of the moments
// loses |z|^functions, and the series converges slowly near 1.
constexpr double kFarStart[] = {0.0, 60.0, 60.0, 12.0, 12.0}; // by number of functions

// E only if wanted.
void find_moments(const SeenPoint& s, int functions, bool want_e, Moments& m);
// C_0 alone.
Complex zeroth_moment(const SeenPoint& s);
// F_0 ... F_(functions-1), from C and D.
void find_third_moments(const SeenPoint& s, int functions, const Moments& m, Complex f[kElementNodes]);

} // namespace c2d
