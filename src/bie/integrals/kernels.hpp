#pragma once
#include "memory/math.hpp"
// The 2-D Kelvin kernels as four numbers with simple behaviour under rotation: a 2x2 block is
//   [ alpha + beta,  gamma + delta ]
//   [ gamma - delta, alpha - beta  ],
// alpha and delta do not change when the axes turn, (beta, gamma) turn by twice the angle.

namespace c2d {

constexpr double kPi = 3.14159265358979323846; // M_PI is no name of C++

struct Tensor {
  double alpha, beta, gamma, delta;
};

inline void add(Tensor& sum, double weight, const Tensor& t) {
  sum.alpha += weight * t.alpha;
  sum.beta += weight * t.beta;
  sum.gamma += weight * t.gamma;
  sum.delta += weight * t.delta;
}

inline void store(const Tensor& t, double factor, double out[2][2]) {
  out[0][0] = factor * (t.alpha + t.beta);
  out[0][1] = factor * (t.gamma + t.delta);
  out[1][0] = factor * (t.gamma - t.delta);
  out[1][1] = factor * (t.alpha - t.beta);
}

// T J / k, METHOD (2.3): (rx,ry) = field point minus source, q = 1/r^2, (nx,ny) = outward normal times J, t1 = 1-2nu.
inline Tensor traction_kernel(double rx, double ry, double q, double nx, double ny, double t1) {
  const double rn = (rx * nx + ry * ny) * q, cross = (rx * ny - ry * nx) * q;
  return {-rn * (t1 + 1.0), -rn * (rx * rx - ry * ry) * q, -2.0 * rn * rx * ry * q, t1 * cross};
}

// U / k times 2G, METHOD (2.2): q = 1/r^2, kappa = 3-4nu; the logarithm is half that of `log_of`: r^2,
// unless a factor is split off.
inline Tensor displacement_kernel(double rx, double ry, double q, double log_of, double kappa) {
  return {0.5 - 0.5 * kappa * log(log_of), 0.5 * (rx * rx - ry * ry) * q, rx * ry * q, 0.0};
}

// The same with nothing split off: r2 = rx^2 + ry^2.
inline Tensor displacement_kernel(double rx, double ry, double r2, double kappa) {
  return displacement_kernel(rx, ry, 1.0 / r2, r2, kappa);
}

} // namespace c2d
