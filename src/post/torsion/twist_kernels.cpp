// v cos f is a harmonic function in space, so Green's third identity holds for it. Integrated round the axis, with
// u = 1 - cos f, rho^2 = b + c u, b = a^2 + z^2, c = 2 r R, and after partial integration in f,
//   int cos f/rho df = r R int sin^2 f/rho^3 df,
//   u = r^2/(4 pi) int sin^2 f/rho^3 df,   t = -3 r^3/(4 pi) int sin^2 f (D0 + D1 u)/rho^5 df,
// D0 = n_r a + n_z z, D1 = n_r R. The integrands have one sign: nothing cancels, and the source may lie on the axis.
#include "post/torsion/twist_kernels.hpp"

#include <cmath>

namespace app {
namespace {

constexpr double kTwistPi = 3.14159265358979323846;
constexpr double kFarRing = 0.4; // of the parameter m; below it the trapezoidal rule has all digits

// The trapezoidal rule with 24 points; those at f and -f are equal, those at 0 and pi vanish.
TwistKernels far_kernels(double radius, double a, double z, const double n[2]) {
  static constexpr int kPoints = 11;
  struct Angles {
    double u[kPoints], sine2[kPoints];
    Angles() {
      for (int k = 0; k < kPoints; ++k) {
        const double half = std::sin(kTwistPi * (k + 1) / 24), whole = std::sin(kTwistPi * (k + 1) / 12);
        u[k] = 2 * half * half, sine2[k] = whole * whole;
      }
    }
  };
  static const Angles at;
  const double r = radius + a, b = a * a + z * z, c = 2 * r * radius, d0 = n[0] * a + n[1] * z, d1 = n[0] * radius;
  double s3 = 0, s5 = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double rho2 = b + c * at.u[k], of3 = at.sine2[k] / (rho2 * std::sqrt(rho2));
    s3 += of3, s5 += of3 / rho2 * (d0 + d1 * at.u[k]);
  }
  constexpr double kStep = 2 * kTwistPi / 12; // twice that of the rule
  return {r * r / (4 * kTwistPi) * kStep * s3, -3 * r * r * r / (4 * kTwistPi) * kStep * s5};
}

// Complete elliptic integrals K and E by the arithmetic-geometric mean, from the complementary parameter.
void elliptic(double rest, double& k, double& e) {
  double a = 1, g = std::sqrt(rest), sum = (1 - rest) / 2, factor = 1;
  for (int step = 0; step < 40; ++step) {
    const double c = (a - g) / 2;
    if (c <= 1e-17 * a) break;
    sum += factor * c * c;
    const double mean = std::sqrt(a * g);
    a = (a + g) / 2, g = mean, factor *= 2;
  }
  k = kTwistPi / (2 * a), e = k * (1 - sum);
}

} // namespace

// Near the source in terms of K(3,k) of METHOD (21.4).
TwistKernels twist_kernels(double radius, double a, double z, const double n[2]) {
  const double r = radius + a, b = a * a + z * z, c = 2 * r * radius, s2 = b + 2 * c;
  if (2 * c < kFarRing * s2) return far_kernels(radius, a, z, n);
  double k = 0, e = 0;
  elliptic(b / s2, k, e);
  const double s = std::sqrt(s2), k1 = 4 * k / s, k30 = 4 * e / (b * s), k31 = (k1 - 4 * e / s) / c,
               k11 = (4 * s * e - b * k1) / c, k32 = (k11 - b * k31) / c;
  const double d0 = n[0] * a + n[1] * z, d1 = n[0] * radius;
  return {r * r / (4 * kTwistPi) * (2 * k31 - k32),
          -r * r / (4 * kTwistPi * radius) * (d0 * (k30 - k31) + d1 * (3 * k31 - 2 * k32))};
}

} // namespace app
