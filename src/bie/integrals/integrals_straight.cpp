// Closed forms of the integrals over straight elements (METHOD 3.2, equation METHOD (3.2)). With zeta and the moments C, D, E
// of bie/integrals/straight_moments.hpp about the source, in axes along the element with n = (0,-1):
//   T: alpha = -(2-2nu) Im C, beta = -zeta Re D, gamma = zeta Im D, delta = -(1-2nu) Re C     (times k)
//   U: alpha = -kappa (mu ln|h| + E) + mu/2, beta = mu/2 - zeta Im C, gamma = -zeta Re C       (times k |h|)
// with mu_k = int eta^k.
//
// Steps: 1. see the source in the element's axes; 2. find the moments of the powers of eta; 3. combine them to shape
// functions; 4. rotate the block back (kernels.hpp: alpha and delta are invariant, beta and gamma rotate by twice the angle).
// A source on one of the element's own nodes has zeta = 0, and its moments are constants.
// Literature: closed forms of this kind for constant and linear elements are classical, for example Crouch and Starfield,
// Boundary Element Methods in Solid Mechanics (1983); complex notation after Muskhelishvili, Some Basic Problems of the
// Mathematical Theory of Elasticity.
#include "bie/integrals/integrals_detail.hpp"
#include "bie/integrals/kernels.hpp"
#include "bie/integrals/straight_moments.hpp"
#include "model/shape.hpp"

namespace c2d {
namespace {

// Rotates a block from the element's axes to the global ones.
Tensor rotated(const Integrator& in, const Tensor& t) {
  return {t.alpha, t.beta * in.cos2 - t.gamma * in.sin2, t.beta * in.sin2 + t.gamma * in.cos2, t.delta};
}

// int M_l over [-1,1].
double mean(int functions, int l) {
  const double* s = shape_coefficients(functions, l);
  return 2.0 * s[0] + (functions > 2 ? 2.0 / 3.0 * s[2] : 0.0);
}

// For functional orders 1, 2, 3, 4, source node l, function m, row by row:
// int M_m/(eta-eta_l) (0 for m = l), and int M_m ln|eta-eta_l|.
// clang-format off
constexpr double kPole[] = {
    0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 2.0, 0.0, -1.0, 0.0, 1.0, 0.0, -2.0, 0.0, 0.0, 2.25, 0.0, 0.25, -0.75,
    0.0, 2.25, 0.0, 0.0, -2.25, 0.0, 0.75, -0.25, 0.0, -2.25, 0.0};
constexpr double kLog[] = {
    -2.0, -0.80685281944005469, 0.19314718055994531, 0.19314718055994531, -0.80685281944005469,
    -0.71339538425779601, -0.18691487036451737, 0.28660461574220399, -0.11111111111111111,
    -1.7777777777777778, -0.11111111111111111, 0.28660461574220399, -0.18691487036451737,
    -0.71339538425779601, -0.51421320486001367, -0.66763961458004102, 0.45736038541995898,
    0.11078679513998633, -0.16386627702704110, -1.5458994576233577, -0.20880133725006079,
    0.031833096430724529, 0.031833096430724529, -0.20880133725006079, -1.5458994576233577,
    -0.16386627702704110, 0.11078679513998633, 0.45736038541995898, -0.66763961458004102,
    -0.51421320486001367};
// clang-format on

int own_offset(int functions, int singular) {
  constexpr int kStart[] = {0, 1, 5, 14};
  return kStart[functions - 1] + functions * singular;
}

// Source at functional node `singular`: zeta = 0, the moments are constants. The principal value of the node's own function is
// left to the diagonal.
void integrate_own_line(const Integrator& in, int singular, bool want_h, bool want_g, Blocks& out) {
  const int offset = own_offset(in.functions, singular);
  for (int l = 0; l < in.functions; ++l) {
    if (want_h) store({0.0, 0.0, 0.0, -in.t1 * kPole[offset + l]}, in.k, out.h[l]);
    if (!want_g) continue;
    const double mu = mean(in.functions, l);
    const Tensor along = {0.5 * mu - in.kappa * (mu * in.log_half + kLog[offset + l]), 0.5 * mu, 0.0, 0.0};
    store(rotated(in, along), in.k * in.g_jacobian, out.g[l]);
  }
}

// One local node from its moments c = int M/(eta-z), d = int M/(eta-z)^2, e = int M ln|eta-z|, mu = int M.
inline void store_node(const Integrator& in, double zeta, Complex c, Complex d, double e, double mu, bool want_h, bool want_g,
                       int l, Blocks& out) {
  if (want_h) {
    const Tensor t = {-in.t2 * c.im, -zeta * d.re, zeta * d.im, -in.t1 * c.re};
    store(rotated(in, t), in.k, out.h[l]);
  }
  if (want_g) {
    const Tensor u = {0.5 * mu - in.kappa * (mu * in.log_half + e), 0.5 * mu - zeta * c.im, -zeta * c.re, 0.0};
    store(rotated(in, u), in.k * in.g_jacobian, out.g[l]);
  }
}

// The most frequent case, M = (1 -+ eta)/2, without a loop.
void store_linear(const Integrator& in, double zeta, const Moments& m, bool want_h, bool want_g, Blocks& out) {
  const Complex c = 0.5 * m.c[0], c1 = 0.5 * m.c[1], d = 0.5 * m.d[0], d1 = 0.5 * m.d[1];
  const double e = 0.5 * m.e[0], e1 = 0.5 * m.e[1];
  store_node(in, zeta, c - c1, d - d1, e - e1, 1.0, want_h, want_g, 0, out);
  store_node(in, zeta, c + c1, d + d1, e + e1, 1.0, want_h, want_g, 1, out);
}

} // namespace

void integrate_straight(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out) {
  if (singular >= 0) {
    integrate_own_line(in, singular, want_h, want_g, out);
    return;
  }
  const SeenPoint s = see(in, sx, sy);
  Moments m;
  if (in.functions == 2) {
    find_moments(s, 2, want_g, m);
    store_linear(in, s.z.im, m, want_h, want_g, out);
    return;
  }
  find_moments(s, in.functions, want_g, m);
  for (int l = 0; l < in.functions; ++l) {
    const double* a = shape_coefficients(in.functions, l);
    Complex c = a[0] * m.c[0], d = a[0] * m.d[0];
    double e = a[0] * m.e[0];
    for (int k = 1; k < in.functions; ++k) {
      c = c + a[k] * m.c[k];
      d = d + a[k] * m.d[k];
      e += a[k] * m.e[k];
    }
    store_node(in, s.z.im, c, d, e, mean(in.functions, l), want_h, want_g, l, out);
  }
}

// The shape functions add up to 1, so the sum over nodes needs only C_0 and D_0, METHOD (2.4).
void rigid_sum_chord(const Integrator& in, double sx, double sy, double sum[2][2]) {
  const SeenPoint s = see(in, sx, sy);
  const Complex c = zeroth_moment(s);
  const Complex d = 2.0 * (s.iw1 * s.iw2);
  const Tensor t = {-in.t2 * c.im, -s.z.im * d.re, s.z.im * d.im, -in.t1 * c.re};
  store(rotated(in, t), in.k, sum);
}

void rigid_sum_own_line(const Integrator& in, int singular, double sum[2][2]) {
  const int offset = own_offset(in.functions, singular);
  double pole = 0.0;
  for (int l = 0; l < in.functions; ++l) pole += kPole[offset + l];
  store({0.0, 0.0, 0.0, -in.t1 * pole}, in.k, sum);
}

} // namespace c2d
