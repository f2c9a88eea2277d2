// Moments C_k, D_k, E_k, F_k of METHOD (3.1) on a straight element.
//
// Two algorithms, selected by the distance |z| from the middle of the element in half lengths:
// 1. Near: C_0 from logarithm and angle, then the forward recurrence C_{k+1} = z C_k + mu_k. It amplifies rounding like |z|^k,
//    which is harmless near the element.
// 2. Far: power series in w = 1/z^2. The closed form would cancel there: C_0 is a small difference of two logarithms.
// E follows by parts from C, and F from C and D.
// Literature: Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity (Cauchy integrals); Knuth, The Art
// of Computer Programming, vol. 2, section 4.6.4 (real polynomials at complex arguments).
#include "bie/integrals/straight_moments.hpp"

#include "memory/math.hpp"

namespace c2d {
namespace {

constexpr double kSmallest = 1e-290;

// C_0 = int 1/(eta-z): half the logarithm of the ratio of squared distances, and the angle subtended. atan2 of a product form,
// because a difference of two angles could be off by 2 pi.
Complex logarithm(const SeenPoint& s, double log1, double log2) {
  return {0.5 * (log2 - log1), atan2(2.0 * s.z.im, s.xi1 * s.xi2 + s.z.im * s.z.im)};
}

// Forward recurrence C_{k+1} = z C_k + mu_k, D_k = [-eta^k/(eta-z)] + k C_{k-1}. It loses a factor |z|^functions, harmless
// here. Returns ln|z^2-1|.
double near_moments(const SeenPoint& s, int functions, Moments& m) {
  const double log1 = log(s.n1), log2 = log(s.n2);
  m.c[0] = logarithm(s, log1, log2);
  for (int k = 0; k < functions; ++k) {
    m.c[k + 1] = s.z * m.c[k];
    if (k % 2 == 0) m.c[k + 1].re += 2.0 / (k + 1);
  }
  const Complex even = s.iw2 - s.iw1, odd = s.iw2 + s.iw1;
  m.d[0] = even;
  for (int k = 1; k < functions; ++k) m.d[k] = (k % 2 == 0 ? even : odd) + k * m.c[k - 1];
  return 0.5 * (log1 + log2);
}

constexpr double kReciprocal[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17,
                                  1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25, 1.0 / 27, 1.0 / 29, 1.0 / 31};

// sum_{m<terms} w^m/(2m+first). A polynomial with real coefficients at a complex argument takes two real multiplications per
// term instead of four.
Complex odd_series(Complex w, int first, int terms) {
  const double trace = 2.0 * w.re, norm = w.re * w.re + w.im * w.im;
  const double* a = kReciprocal + (first - 3) / 2;
  double b1 = 0.0, b2 = 0.0;
  for (int m = terms - 1; m > 0; --m) {
    const double b = a[m] + trace * b1 - norm * b2;
    b2 = b1;
    b1 = b;
  }
  return {a[0] + w.re * b1 - norm * b2, w.im * b1};
}

// Number of terms after which w^m < 1e-15, |z|^2 = 1/|w|.
int series_terms(double z2) {
  if (z2 < 32.0) return 14;
  if (z2 < 1e3) return 10;
  return z2 < 1e5 ? 5 : 3;
}

// With S_q = sum w^m/(2m+q), w = 1/z^2, R = 1/(1-w) (expand the integrands in powers of eta/z):
//   C_0, C_2, C_4 = -(2/z) S_1, S_3, S_5; C_1, C_3 = -2w S_3, S_5; D_0 = 2w R, D_1 = 2 z^-3 (R - S_3),
//   D_2 = 2w (R - 2 S_3), D_3 = 2 z^-3 (R - 3 S_5). Every number keeps its relative accuracy at any distance.
void far_moments(const SeenPoint& s, double z2, int functions, Moments& m) {
  const double q = 1.0 / z2;
  const Complex iz = {s.z.re * q, -s.z.im * q};
  const Complex w = iz * iz;
  const Complex r = (s.z * s.z) * (s.iw1 * s.iw2);
  const bool high = functions > 2;
  const Complex s5 = high ? odd_series(w, 5, series_terms(z2)) : Complex{0.0, 0.0};
  Complex s3 = high ? w * s5 : odd_series(w, 3, series_terms(z2));
  if (high) s3.re += 1.0 / 3;
  Complex s1 = w * s3;
  s1.re += 1.0;
  const Complex minus_w = -2.0 * w, minus_iz = -2.0 * iz;
  m.c[0] = minus_iz * s1;
  m.c[1] = minus_w * s3;
  m.c[2] = minus_iz * s3;
  m.d[0] = 2.0 * (s.iw1 * s.iw2);
  const Complex iz3 = 2.0 * (iz * w);
  m.d[1] = iz3 * (r - s3);
  if (high) {
    m.c[3] = minus_w * s5;
    m.c[4] = minus_iz * s5;
    m.d[2] = 2.0 * (w * (r - 2.0 * s3));
    m.d[3] = iz3 * (r - 3.0 * s5);
  }
}

} // namespace

// Zeta, and the position along the element, are measured from the nearer end, where they are small numbers without
// cancellation.
SeenPoint see(const Integrator& in, double x, double y) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double ax = x - e.x[0], ay = y - e.y[0], bx = x - e.x[last], by = y - e.y[last];
  SeenPoint s;
  s.xi1 = ax * in.ux + ay * in.uy;
  s.xi2 = bx * in.ux + by * in.uy;
  const bool first_nearer = ax * ax + ay * ay < bx * bx + by * by;
  const double zeta = first_nearer ? ay * in.ux - ax * in.uy : by * in.ux - bx * in.uy;
  s.z = {first_nearer ? s.xi1 - 1.0 : s.xi2 + 1.0, zeta};
  const double zeta2 = zeta * zeta + kSmallest; // a point on an end must not divide by zero
  s.n1 = s.xi1 * s.xi1 + zeta2;
  s.n2 = s.xi2 * s.xi2 + zeta2;
  const double q1 = 1.0 / s.n1, q2 = 1.0 / s.n2;
  s.iw1 = {s.xi1 * q1, -zeta * q1};
  s.iw2 = {s.xi2 * q2, -zeta * q2};
  return s;
}

void find_moments(const SeenPoint& s, int functions, bool want_e, Moments& m) {
  const double z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  double log_product = 0.0; // ln|z^2-1|
  if (z2 < kFarStart[functions]) {
    log_product = near_moments(s, functions, m);
  } else {
    far_moments(s, z2, functions, m);
    if (want_e) log_product = 0.5 * log(s.n1 * s.n2);
  }
  // By parts: (k+1) E_k = [eta^(k+1) ln|eta-z|] - Re C_{k+1}. At the ends eta^(k+1) is 1 or -1, so even k take the sum of the
  // two logarithms and odd k their difference, which is Re C_0.
  for (int k = 0; k < functions; ++k) {
    m.e[k] = ((k % 2 == 0 ? log_product : m.c[0].re) - m.c[k + 1].re) / (k + 1);
  }
}

Complex zeroth_moment(const SeenPoint& s) {
  const double z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  if (z2 < kFarStart[1]) return logarithm(s, log(s.n1), log(s.n2));
  const double q = 1.0 / z2;
  const Complex iz = {s.z.re * q, -s.z.im * q};
  const Complex w = iz * iz;
  Complex s1 = w * odd_series(w, 3, series_terms(z2));
  s1.re += 1.0;
  return -2.0 * (iz * s1);
}

// With q = 1/(z^2-1) the ends give F_1 = -2 q^2, F_0 = z F_1, F_2 = F_0 + D_1, and by parts F_3 =
// 3/2 D_2 - (z^2+1) q^2; far away, where that cancels, F_3 = -2 w^2 (w R^2 + 3 S_5) as in far_moments.
void find_third_moments(const SeenPoint& s, int functions, const Moments& m, Complex f[kElementNodes]) {
  const Complex q = s.iw1 * s.iw2, q2 = q * q, z_square = s.z * s.z;
  f[1] = -2.0 * q2;
  f[0] = s.z * f[1];
  if (functions > 2) f[2] = f[0] + m.d[1];
  if (functions < 4) return;
  const double z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  if (z2 < kFarStart[functions]) {
    f[3] = 1.5 * m.d[2] - Complex{z_square.re + 1.0, z_square.im} * q2;
    return;
  }
  const Complex iz = (1.0 / z2) * conj(s.z), w = iz * iz, r = z_square * q;
  f[3] = -2.0 * (w * w * (w * r * r + 3.0 * odd_series(w, 5, series_terms(z2))));
}

} // namespace c2d
