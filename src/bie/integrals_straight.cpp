// Closed forms on straight elements. In units of the half chord vector h (a complex number), about the
// middle, the source is z = xi + i zeta, and with rho^2 = |eta - z|^2
//   1/(eta-z) = (eta-xi + i zeta)/rho^2,
// so that all kernels follow from the complex moments C_k = int eta^k/(eta-z), D_k = int eta^k/(eta-z)^2 and
// E_k = int eta^k ln|eta-z|, k < functions. In axes along the element, with n = (0,-1):
//   T: alpha = -(2-2nu) Im C, beta = -zeta Re D, gamma = zeta Im D, delta = -(1-2nu) Re C     (times k)
//   U: alpha = -kappa (mu ln|h| + E) + mu/2, beta = mu/2 - zeta Im C, gamma = -zeta Re C       (times k |h|)
// with mu_k = int eta^k.
#include "bie/integrals_detail.hpp"
#include "bie/kernels.hpp"
#include "bie/shape.hpp"

#include <math.h>

namespace c2d {
namespace {

struct Complex {
  double re, im;
};

Complex operator*(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Complex operator+(Complex a, Complex b) {
  return {a.re + b.re, a.im + b.im};
}

Complex operator-(Complex a, Complex b) {
  return {a.re - b.re, a.im - b.im};
}

Complex operator*(double s, Complex a) {
  return {s * a.re, s * a.im};
}

// The source seen from both ends: w1 = z+1, w2 = z-1 and their reciprocals.
struct Source {
  Complex z, iw1, iw2;
  double xi1, xi2, n1, n2; // Re w1, Re w2, |w1|^2, |w2|^2
};

struct Moments {
  Complex c[5], d[4]; // D_k without the factor zeta
  double e[4];
};

// Squared distance from the middle beyond which the series in 1/z^2 replaces logarithm and angle: the
// recurrence loses |z|^functions, the series is slow near 1.
constexpr double kFarStart[] = {0.0, 60.0, 60.0, 12.0, 12.0}; // by number of functions
constexpr double kSmallest = 1e-290;

// Zeta, and the position along the element, are taken from the nearer end, where they are small numbers
// exactly.
Source locate(const Integrator& in, double sx, double sy) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double ax = sx - e.x[0], ay = sy - e.y[0], bx = sx - e.x[last], by = sy - e.y[last];
  Source s;
  s.xi1 = ax * in.ux + ay * in.uy;
  s.xi2 = bx * in.ux + by * in.uy;
  const bool first_nearer = ax * ax + ay * ay < bx * bx + by * by;
  const double zeta = first_nearer ? ay * in.ux - ax * in.uy : by * in.ux - bx * in.uy;
  s.z = {first_nearer ? s.xi1 - 1.0 : s.xi2 + 1.0, zeta};
  const double zeta2 = zeta * zeta + kSmallest; // a source on an end must not divide by zero
  s.n1 = s.xi1 * s.xi1 + zeta2;
  s.n2 = s.xi2 * s.xi2 + zeta2;
  const double q1 = 1.0 / s.n1, q2 = 1.0 / s.n2;
  s.iw1 = {s.xi1 * q1, -zeta * q1};
  s.iw2 = {s.xi2 * q2, -zeta * q2};
  return s;
}

// int eta^k/(eta-z), k = 0: half the logarithm of the ratio of squared distances, and the angle subtended.
Complex logarithm(const Source& s, double log1, double log2) {
  return {0.5 * (log2 - log1), atan2(2.0 * s.z.im, s.xi1 * s.xi2 + s.z.im * s.z.im)};
}

// Forward recurrence C_{k+1} = z C_k + mu_k, D_k = [-eta^k/(eta-z)] + k C_{k-1}: loses |z|^functions,
// harmless here. Returns ln|z^2-1|.
double near_moments(const Source& s, int functions, Moments& m) {
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

constexpr double kReciprocal[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
                                  1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21,
                                  1.0 / 23, 1.0 / 25, 1.0 / 27, 1.0 / 29, 1.0 / 31};

// sum_{m<terms} w^m/(2m+first) by the recurrence for polynomials with real coefficients at a complex
// argument.
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
void far_moments(const Source& s, double z2, int functions, Moments& m) {
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

inline void find_moments(const Source& s, int functions, bool want_g, Moments& m) {
  const double z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  double log_product = 0.0; // ln|z^2-1|
  if (z2 < kFarStart[functions]) {
    log_product = near_moments(s, functions, m);
  } else {
    far_moments(s, z2, functions, m);
    if (want_g) log_product = 0.5 * log(s.n1 * s.n2);
  }
  // By parts: (k+1) E_k = [eta^(k+1) ln|eta-z|] - Re C_{k+1}.
  for (int k = 0; k < functions; ++k) {
    m.e[k] = ((k % 2 == 0 ? log_product : m.c[0].re) - m.c[k + 1].re) / (k + 1);
  }
}

// Turns a block from the element's axes into the global ones.
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

// Source at functional node `singular`: zeta = 0, the moments are numbers.
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
inline void store_node(const Integrator& in, double zeta, Complex c, Complex d, double e, double mu,
                       bool want_h, bool want_g, int l, Blocks& out) {
  if (want_h) {
    const Tensor t = {-in.t2 * c.im, -zeta * d.re, zeta * d.im, -in.t1 * c.re};
    store(rotated(in, t), in.k, out.h[l]);
  }
  if (want_g) {
    const Tensor u = {0.5 * mu - in.kappa * (mu * in.log_half + e), 0.5 * mu - zeta * c.im, -zeta * c.re,
                      0.0};
    store(rotated(in, u), in.k * in.g_jacobian, out.g[l]);
  }
}

// The commonest order, M = (1 -+ eta)/2, without a loop.
void store_linear(const Integrator& in, double zeta, const Moments& m, bool want_h, bool want_g,
                  Blocks& out) {
  const Complex c = 0.5 * m.c[0], c1 = 0.5 * m.c[1], d = 0.5 * m.d[0], d1 = 0.5 * m.d[1];
  const double e = 0.5 * m.e[0], e1 = 0.5 * m.e[1];
  store_node(in, zeta, c - c1, d - d1, e - e1, 1.0, want_h, want_g, 0, out);
  store_node(in, zeta, c + c1, d + d1, e + e1, 1.0, want_h, want_g, 1, out);
}

} // namespace

void integrate_straight(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g,
                        Blocks& out) {
  if (singular >= 0) {
    integrate_own_line(in, singular, want_h, want_g, out);
    return;
  }
  const Source s = locate(in, sx, sy);
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

void rigid_sum_chord(const Integrator& in, double sx, double sy, double sum[2][2]) {
  const Source s = locate(in, sx, sy);
  const double z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  Complex c;
  if (z2 < kFarStart[1]) {
    c = logarithm(s, log(s.n1), log(s.n2));
  } else {
    const double q = 1.0 / z2;
    const Complex iz = {s.z.re * q, -s.z.im * q};
    const Complex w = iz * iz;
    Complex s1 = w * odd_series(w, 3, series_terms(z2));
    s1.re += 1.0;
    c = -2.0 * (iz * s1);
  }
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
