#pragma once
// Complex numbers, the sources as an element sees them, and the moments of its kernels: part of batch_loops.hpp, included
// nowhere else. Names and formulas are those of straight_moments.hpp; series there and here are those of C_k, in w = 1/z^2.
#include "bie/integrals/batch.hpp"
#include "bie/integrals/straight_moments.hpp"
#include "bie/integrals/vector_loops.hpp"

namespace c2d {
namespace {

struct Complexes { // a complex number per lane
  Doubles re, im;
};
INLINE Complexes operator+(Complexes a, Complexes b) { return {a.re + b.re, a.im + b.im}; }
INLINE Complexes operator-(Complexes a, Complexes b) { return {a.re - b.re, a.im - b.im}; }
INLINE Complexes operator*(Complexes a, Complexes b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
INLINE Complexes operator*(double s, Complexes a) { return {s * a.re, s * a.im}; }
INLINE Complexes choose(Bits which, Complexes a, Complexes b) { return {which ? a.re : b.re, which ? a.im : b.im}; } // (lanes)

// The sources as the element's ends see them: z = xi + i zeta from the nearer one.
struct Seen {
  Doubles xi1, xi2; // Re (z + 1), Re (z - 1)
  Complexes z;
};

INLINE Seen see(const BatchElement& e, const double* xy) {
  const Doubles v = load(xy), w = load(xy + kDoubles), x = evens(v, w), y = odds(v, w);
  const Doubles ax = x - e.x0, ay = y - e.y0, bx = x - e.x1, by = y - e.y1;
  Seen s;
  s.xi1 = ax * e.ux + ay * e.uy;
  s.xi2 = bx * e.ux + by * e.uy;
  const Bits first = s.xi1 < -s.xi2;
  s.z.im = (first ? ay : by) * e.ux - (first ? ax : bx) * e.uy; // (lanes)
  s.z.re = first ? s.xi1 - 1.0 : s.xi2 + 1.0;                   // (lanes)
  return s;
}

// z of sources farther away, from the first end alone.
INLINE Complexes see_far(const BatchElement& e, const double* xy) {
  const Doubles v = load(xy), w = load(xy + kDoubles), ax = evens(v, w) - e.x0, ay = odds(v, w) - e.y0;
  return {(ax * e.ux + ay * e.uy) - 1.0, ay * e.ux - ax * e.uy};
}

INLINE Doubles squared_size(Complexes z) { return z.re * z.re + z.im * z.im; }

template <int F> struct Many {
  Complexes c[F + 1], d[F];
  Doubles log_product; // ln |z^2 - 1|
};

// ---- near: forward recurrences
// ------------------------------------------------------------------------------------

struct Ends {
  Complexes iw1, iw2, c0; // 1/(z+1), 1/(z-1), C_0
  Doubles log_product;
};

INLINE Ends see_ends(const Seen& s) {
  const Doubles zeta2 = s.z.im * s.z.im + 1e-290; // a source on an end must not divide by zero
  const Doubles n1 = s.xi1 * s.xi1 + zeta2, n2 = s.xi2 * s.xi2 + zeta2;
  const Doubles q = 1.0 / (n1 * n2), q1 = n2 * q, q2 = n1 * q;
  const Doubles log1 = logarithm(n1), log2 = logarithm(n2);
  Ends e;
  e.iw1 = {s.xi1 * q1, -s.z.im * q1};
  e.iw2 = {s.xi2 * q2, -s.z.im * q2};
  e.c0 = {0.5 * (log2 - log1), angle(2.0 * s.z.im, s.xi1 * s.xi2 + s.z.im * s.z.im)};
  e.log_product = 0.5 * (log1 + log2);
  return e;
}

template <int F> INLINE void near_moments(const Seen& s, Many<F>& m) {
  const Ends e = see_ends(s);
  m.c[0] = e.c0;
  for (int k = 0; k < F; ++k) {
    m.c[k + 1] = s.z * m.c[k];
    if (k % 2 == 0) m.c[k + 1].re += 2.0 / (k + 1);
  }
  const Complexes even = e.iw2 - e.iw1, odd = e.iw2 + e.iw1;
  m.d[0] = even;
  for (int k = 1; k < F; ++k) m.d[k] = (k % 2 == 0 ? even : odd) + static_cast<double>(k) * m.c[k - 1];
  m.log_product = e.log_product;
}

// ---- far: series
// --------------------------------------------------------------------------------------------------

// Terms after which w^m < 1e-15.
INLINE int terms_of(double z2) {
  if (z2 >= 1e5) return 3;
  if (z2 >= 5.7e3) return 4;
  if (z2 >= 1e3) return 5;
  if (z2 >= 320.0) return 6;
  if (z2 >= 140.0) return 7;
  return z2 >= 75.0 ? 8 : (z2 >= 32.0 ? 10 : 14);
}

constexpr double kThirds[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17,
                              1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25, 1.0 / 27, 1.0 / 29, 1.0 / 31};
constexpr double kEach[] = {1.0,     1.0 / 2, 1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,
                            1.0 / 8, 1.0 / 9, 1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14};

// 1/z and w, and sum w^m/(2m+q), q = 3 or 5, sum w^m = 1/(1-w), Re sum w^m/(m+1) = -ln(1-w)/w. A polynomial with real
// coefficients at a complex argument takes two real recurrences, here all three together, highest power first.
struct Series {
  Complexes iz, w, odd, geometric;
  Doubles log_1_w; // ln |1-w|
};

template <int Q> INLINE Series sum_series(Complexes z, Doubles z2, int terms) {
  const double* a = kThirds + (Q - 3) / 2;
  const Doubles q = 1.0 / z2;
  Series s;
  s.iz = {z.re * q, -z.im * q};
  s.w = {s.iz.re * s.iz.re - s.iz.im * s.iz.im, 2.0 * (s.iz.re * s.iz.im)};
  const Doubles trace = 2.0 * s.w.re, norm = q * q;
  // The highest terms: b_(n-1) = a_(n-1), b_(n-2) = a_(n-2) + trace b_(n-1).
  int m = terms - 2;
  Doubles odd2 = all(a[m + 1]), each2 = all(kEach[m + 1]), one2 = all(1.0);
  Doubles odd = a[m] + trace * odd2, each = kEach[m] + trace * each2, one = 1.0 + trace;
  while (--m > 0) {
    const Doubles next_odd = a[m] + (trace * odd - norm * odd2), next_each = kEach[m] + (trace * each - norm * each2),
                  next_one = 1.0 + (trace * one - norm * one2);
    odd2 = odd, each2 = each, one2 = one;
    odd = next_odd, each = next_each, one = next_one;
  }
  s.odd = {a[0] + (s.w.re * odd - norm * odd2), s.w.im * odd};
  s.geometric = {1.0 + (s.w.re * one - norm * one2), s.w.im * one};
  const Complexes logs = {1.0 + (s.w.re * each - norm * each2), s.w.im * each};
  s.log_1_w = s.w.im * logs.im - s.w.re * logs.re;
  return s;
}

template <int F> INLINE void far_moments(Complexes z, Doubles z2, double least_z2, bool want_log, Many<F>& m) {
  constexpr bool high = F > 2;
  const Series s = sum_series < high ? 5 : 3 > (z, z2, terms_of(least_z2));
  Complexes s3 = s.odd;
  if (high) {
    s3 = s.w * s.odd;
    s3.re += 1.0 / 3;
  }
  Complexes s1 = s.w * s3;
  s1.re += 1.0;
  const Complexes two_w = 2.0 * s.w, minus_w = {-two_w.re, -two_w.im}, minus_iz = -2.0 * s.iz;
  m.c[0] = minus_iz * s1;
  m.c[1] = minus_w * s3;
  m.d[0] = two_w * s.geometric;
  const Complexes iz3 = two_w * s.iz;
  if (F > 1) {
    m.c[2] = minus_iz * s3;
    m.d[1] = iz3 * (s.geometric - s3);
  }
  if (F > 2) {
    m.c[3] = minus_w * s.odd;
    m.d[2] = two_w * (s.geometric - 2.0 * s3);
  }
  if (F > 3) {
    m.c[4] = minus_iz * s.odd;
    m.d[3] = iz3 * (s.geometric - 3.0 * s.odd);
  }
  m.log_product = want_log ? logarithm(z2) + s.log_1_w : Doubles{};
}

} // namespace
} // namespace c2d
