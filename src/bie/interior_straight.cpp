// Closed forms on straight elements. In axes along the element, in units of its half length, about its middle, P is the
// complex number z = xi + i zeta and rho = eta - z with real eta: then rho* = rho + 2 i zeta and n = -i, and all kernels
// follow from the complex moments
//   C_k = int eta^k/(eta-z), D_k = int eta^k/(eta-z)^2, F_k = int eta^k/(eta-z)^3, E_k = int eta^k ln|eta-z|.
// C is a logarithm; D and F are its derivatives by z, D = C', F = D'/2.
#include <math.h>

#include "bie/interior_detail.hpp"

namespace c2d {
namespace {

struct PointMoments {
  Complex c[5], d[4], f[4];
  double e[4];
};

// P seen from the middle and both ends; q = 1/(z^2-1).
struct Seen {
  Complex z, q;
  double xi1, xi2, n1, n2; // Re(z+1), Re(z-1), |z+1|^2, |z-1|^2
};

// Measured from the nearer end, where the differences are small numbers exactly.
Seen seen_from(const Integrator& in, double x, double y) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double ax = x - e.x[0], ay = y - e.y[0], bx = x - e.x[last], by = y - e.y[last];
  Seen s;
  s.xi1 = ax * in.ux + ay * in.uy;
  s.xi2 = bx * in.ux + by * in.uy;
  const bool first = ax * ax + ay * ay < bx * bx + by * by;
  const double zeta = first ? ay * in.ux - ax * in.uy : by * in.ux - bx * in.uy;
  s.z = {first ? s.xi1 - 1.0 : s.xi2 + 1.0, zeta};
  s.n1 = s.xi1 * s.xi1 + zeta * zeta;
  s.n2 = s.xi2 * s.xi2 + zeta * zeta;
  s.q = (1.0 / (s.n1 * s.n2)) * (Complex{s.xi1, -zeta} * Complex{s.xi2, -zeta});
  return s;
}

// By parts from the logarithm: C_{k+1} = z C_k + [mu_k], D_k and F_k from the ends and the order below. Loses |z|^k.
void near_moments(const Seen& s, int functions, PointMoments& m) {
  m.c[0] = {0.5 * log(s.n2 / s.n1), atan2(2.0 * s.z.im, s.xi1 * s.xi2 + s.z.im * s.z.im)};
  for (int k = 0; k < functions; ++k) {
    m.c[k + 1] = s.z * m.c[k];
    if (k % 2 == 0) m.c[k + 1].re += 2.0 / (k + 1);
  }
  const Complex even = 2.0 * s.q, odd = s.z * even;
  for (int k = 1; k < functions; ++k) m.d[k] = (k % 2 == 0 ? even : odd) + k * m.c[k - 1];
  if (functions > 3) {
    const Complex z2 = s.z * s.z;
    m.f[3] = 1.5 * m.d[2] - Complex{z2.re + 1.0, z2.im} * (s.q * s.q);
  }
}

// Far away, with w = 1/z^2, S_p = sum_m w^m/(2m+p), R = 1/(1-w): expand 1/(eta-z) in powers of eta/z. No digit is lost
// at any distance.
void far_moments(const Seen& s, double z2, int functions, PointMoments& m) {
  const Complex iz = (1.0 / z2) * conj(s.z), w = iz * iz, r = (s.z * s.z) * s.q;
  const int terms = z2 > 1e5 ? 4 : (z2 > 300.0 ? 7 : (z2 > 50.0 ? 10 : 15));
  Complex s5 = {0.0, 0.0};
  for (int i = terms - 1; i >= 0; --i) {
    s5 = w * s5;
    s5.re += 1.0 / (2 * i + 5);
  }
  Complex s3 = w * s5;
  s3.re += 1.0 / 3.0;
  Complex s1 = w * s3;
  s1.re += 1.0;
  const Complex odd = -2.0 * iz, even = -2.0 * w, cube = 2.0 * (iz * w);
  m.c[0] = odd * s1;
  m.c[1] = even * s3;
  m.c[2] = odd * s3;
  m.d[1] = cube * (r - s3);
  if (functions < 3) return;
  m.c[3] = even * s5;
  m.c[4] = odd * s5;
  m.d[2] = 2.0 * (w * (r - 2.0 * s3));
  m.d[3] = cube * (r - 3.0 * s5);
  m.f[3] = -2.0 * (w * w * (w * r * r + 3.0 * s5));
}

void find_moments(const Seen& s, int functions, PointMoments& m) {
  constexpr double kFar = 12.0;
  const double z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  if (z2 < kFar) near_moments(s, functions, m);
  else far_moments(s, z2, functions, m);
  m.d[0] = 2.0 * s.q;
  m.f[1] = -2.0 * (s.q * s.q);
  m.f[0] = s.z * m.f[1];
  if (functions > 2) m.f[2] = m.f[0] + m.d[1];
  const double log_product = 0.5 * log(s.n1 * s.n2);
  for (int k = 0; k < functions; ++k)
    m.e[k] = ((k % 2 == 0 ? log_product : m.c[0].re) - m.c[k + 1].re) / (k + 1);
}

// The integrals of both densities against every kernel part.
struct DensityMoments {
  Complex t_log;      // int t ln|rho|
  double t_mean;      // int Re t
  Complex tc, tc_bar; // int t/rho, int t*/rho
  Complex td;         // int t/rho^2
  Complex uc, uc_bar, ud, ud_bar, uf;
};

DensityMoments apply(const FieldElement& e, Complex reference, const PointMoments& m) {
  DensityMoments s = {};
  for (int k = 0; k < e.in.functions; ++k) {
    const Complex t = e.t[k], u = k == 0 ? e.u[0] - reference : e.u[k];
    const double mean = k % 2 == 0 ? 2.0 / (k + 1) : 0.0;
    add(s.t_log, (m.e[k] + mean * e.in.log_half) * t);
    s.t_mean += mean * t.re;
    add(s.tc, t * m.c[k]);
    add(s.tc_bar, conj(t) * m.c[k]);
    add(s.td, t * m.d[k]);
    add(s.uc, u * m.c[k]);
    add(s.uc_bar, conj(u) * m.c[k]);
    add(s.ud, u * m.d[k]);
    add(s.ud_bar, conj(u) * m.d[k]);
    add(s.uf, u * m.f[k]);
  }
  return s;
}

} // namespace

void add_field_straight(const FieldElement& e, Complex reference, double x, double y, PointField& sum) {
  const Integrator& in = e.in;
  const Seen seen = seen_from(in, x, y);
  PointMoments m;
  find_moments(seen, in.functions, m);
  const DensityMoments s = apply(e, reference * conj(e.axis), m);
  const Complex n = {0.0, -1.0}, twice_zeta = {0.0, 2.0 * seen.z.im}; // rho* - rho
  const double per_length = sqrt(in.ux * in.ux + in.uy * in.uy);        // 1/|h|
  const double k_t = in.k * in.g_jacobian, k_d = k_t * per_length, k_s = 2.0 * in.k * per_length;

  Complex u = k_t * (-in.kappa * s.t_log + Complex{s.t_mean, 0.0} + 0.5 * conj(twice_zeta * s.tc));
  const Complex nuc = n * s.uc;
  add(u, (0.5 * in.k) * (in.kappa * nuc + conj(n * (s.uc_bar - s.uc) + nuc + twice_zeta * (n * s.ud))));
  add(sum.u, u * e.axis);

  const Complex nud = n * s.ud;
  sum.trace += 2.0 * k_d * s.tc.re + k_s * nud.re;
  const Complex deviator = k_d * (in.kappa * s.tc_bar + s.tc + twice_zeta * s.td) +
                           k_s * (0.5 * (n * (s.ud_bar - s.ud)) + nud + twice_zeta * (n * s.uf));
  add(sum.deviator, deviator * conj(e.axis * e.axis));
}

} // namespace c2d
