// The loops of one instruction set: included by one source file per set, which defines C2D_VECTOR_BYTES and is compiled
// with that set's flags. Nothing in here may be seen by another file, nor anything be used that is inline elsewhere: a
// function shared by the linker would carry instructions into machines that lack them.
//
// Names and formulas are those of straight_moments.hpp and integrals_straight.cpp; series there and here are those of
// C_k, in w = 1/z^2.
#include "bie/batch.hpp"
#include "bie/shape.hpp"
#include "bie/straight_moments.hpp"
#include "bie/vector_loops.hpp"

namespace c2d {
namespace {

struct Pair { // a complex number per lane
  Vector re, im;
};
inline Pair operator+(Pair a, Pair b) {
  return {a.re + b.re, a.im + b.im};
}
inline Pair operator-(Pair a, Pair b) {
  return {a.re - b.re, a.im - b.im};
}
inline Pair operator*(Pair a, Pair b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Pair operator*(double s, Pair a) {
  return {s * a.re, s * a.im};
}
inline Pair choose(Bits which, Pair a, Pair b) {
  return {which ? a.re : b.re, which ? a.im : b.im};
}

// The sources as the element's ends see them: z = xi + i zeta from the nearer one.
struct Seen {
  Vector xi1, xi2, z2; // Re (z + 1), Re (z - 1), |z|^2
  Pair z;
};

inline Seen see(const Integrator& in, Vector x, Vector y) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const Vector ax = x - e.x[0], ay = y - e.y[0], bx = x - e.x[last], by = y - e.y[last];
  Seen s;
  s.xi1 = ax * in.ux + ay * in.uy;
  s.xi2 = bx * in.ux + by * in.uy;
  const Bits first = s.xi1 < -s.xi2;
  s.z.im = first ? ay * in.ux - ax * in.uy : by * in.ux - bx * in.uy;
  s.z.re = first ? s.xi1 - 1.0 : s.xi2 + 1.0;
  s.z2 = s.z.re * s.z.re + s.z.im * s.z.im;
  return s;
}

template <int F> struct Many {
  Pair c[F + 1], d[F];
  Vector log_product; // ln |z^2 - 1|
};

// ---- near: forward recurrences ------------------------------------------------------------------------------------

struct Ends {
  Pair iw1, iw2, c0; // 1/(z+1), 1/(z-1), C_0
  Vector log_product;
};

inline Ends see_ends(const Seen& s) {
  const Vector zeta2 = s.z.im * s.z.im + 1e-290; // a source on an end must not divide by zero
  const Vector n1 = s.xi1 * s.xi1 + zeta2, n2 = s.xi2 * s.xi2 + zeta2;
  const Vector q = 1.0 / (n1 * n2), q1 = n2 * q, q2 = n1 * q;
  const Vector log1 = logarithm(n1), log2 = logarithm(n2);
  Ends e;
  e.iw1 = {s.xi1 * q1, -s.z.im * q1};
  e.iw2 = {s.xi2 * q2, -s.z.im * q2};
  e.c0 = {0.5 * (log2 - log1), angle(2.0 * s.z.im, s.xi1 * s.xi2 + s.z.im * s.z.im)};
  e.log_product = 0.5 * (log1 + log2);
  return e;
}

template <int F> inline void near_moments(const Seen& s, Many<F>& m) {
  const Ends e = see_ends(s);
  m.c[0] = e.c0;
  for (int k = 0; k < F; ++k) {
    m.c[k + 1] = s.z * m.c[k];
    if (k % 2 == 0) m.c[k + 1].re += 2.0 / (k + 1);
  }
  const Pair even = e.iw2 - e.iw1, odd = e.iw2 + e.iw1;
  m.d[0] = even;
  for (int k = 1; k < F; ++k) m.d[k] = (k % 2 == 0 ? even : odd) + static_cast<double>(k) * m.c[k - 1];
  m.log_product = e.log_product;
}

// ---- far: series --------------------------------------------------------------------------------------------------

// Terms after which w^m < 1e-15.
inline int terms_of(double z2) {
  if (z2 < 32.0) return 14;
  if (z2 < 1e2) return 10;
  if (z2 < 1e3) return 8;
  if (z2 < 1e4) return 5;
  return z2 < 1e5 ? 4 : 3;
}

constexpr double kThirds[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15,
                              1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25, 1.0 / 27, 1.0 / 29, 1.0 / 31};
constexpr double kEach[] = {1.0,     1.0 / 2, 1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,
                            1.0 / 8, 1.0 / 9, 1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14};

// A polynomial with real coefficients at a complex argument, from the highest down.
struct Descent {
  Vector b1, b2;
  inline void take(double a, Vector trace, Vector norm) {
    const Vector b = a + trace * b1 - norm * b2;
    b2 = b1;
    b1 = b;
  }
  inline Pair end(double a, Pair w, Vector norm) const { return {a + w.re * b1 - norm * b2, w.im * b1}; }
};

// 1/z and w, and sum w^m/(2m+q), q = 3 or 5, sum w^m = 1/(1-w), sum w^m/(m+1) = -ln(1-w)/w.
struct Series {
  Pair iz, w, odd, geometric, logs;
};

template <int Q, bool LOGS> inline Series sum_series(const Pair& z, Vector z2, double least_z2) {
  const double* a = kThirds + (Q - 3) / 2;
  const Vector q = 1.0 / z2;
  Series s;
  s.iz = {z.re * q, -z.im * q};
  s.w = s.iz * s.iz;
  const Vector trace = 2.0 * s.w.re, norm = q * q;
  Descent odd{}, geometric{}, logs{};
  for (int m = terms_of(least_z2) - 1; m > 0; --m) {
    odd.take(a[m], trace, norm);
    geometric.take(1.0, trace, norm);
    if (LOGS) logs.take(kEach[m], trace, norm);
  }
  s.odd = odd.end(a[0], s.w, norm);
  s.geometric = geometric.end(1.0, s.w, norm);
  if (LOGS) s.logs = logs.end(1.0, s.w, norm);
  return s;
}

template <int F> inline void far_moments(const Pair& z, Vector z2, double least_z2, bool want_log, Many<F>& m) {
  constexpr bool high = F > 2;
  const Series s = sum_series<high ? 5 : 3, true>(z, z2, least_z2);
  Pair s3 = s.odd;
  if (high) {
    s3 = s.w * s.odd;
    s3.re += 1.0 / 3;
  }
  Pair s1 = s.w * s3;
  s1.re += 1.0;
  const Pair minus_w = -2.0 * s.w, minus_iz = -2.0 * s.iz;
  m.c[0] = minus_iz * s1;
  m.c[1] = minus_w * s3;
  m.d[0] = 2.0 * (s.w * s.geometric);
  const Pair iz3 = 2.0 * (s.iz * s.w);
  if (F > 1) {
    m.c[2] = minus_iz * s3;
    m.d[1] = iz3 * (s.geometric - s3);
  }
  if (F > 2) {
    m.c[3] = minus_w * s.odd;
    m.d[2] = 2.0 * (s.w * (s.geometric - 2.0 * s3));
  }
  if (F > 3) {
    m.c[4] = minus_iz * s.odd;
    m.d[3] = iz3 * (s.geometric - 3.0 * s.odd);
  }
  if (want_log) m.log_product = logarithm(z2) - (s.w.re * s.logs.re - s.w.im * s.logs.im);
}

// ---- both ---------------------------------------------------------------------------------------------------------

// Lanes that the series must not see are given z = 8.
struct Split {
  Bits near;
  Pair z;
  Vector z2;
  double least, least_far;
  inline Split(const Seen& s, double start) {
    least = c2d::least(s.z2);
    near = s.z2 < start;
    z = s.z;
    z2 = s.z2;
    least_far = least;
    if (!(least < start)) return;
    z.re = near ? all(8.0) : s.z.re;
    z.im = near ? all(0.0) : s.z.im;
    z2 = near ? all(64.0) : s.z2;
    least_far = c2d::least(z2);
  }
};

inline bool any_far(const Seen& s, double start) {
  return !(-least(-s.z2) < start);
}

template <int F> inline void find_moments(const Seen& s, bool want_log, Many<F>& m) {
  constexpr double start = kFarStart[F];
  const Split split(s, start);
  if (!(split.least < start)) return far_moments<F>(s.z, s.z2, split.least, want_log, m);
  near_moments<F>(s, m);
  if (!any_far(s, start)) return;
  Many<F> far;
  far_moments<F>(split.z, split.z2, split.least_far, want_log, far);
  for (int k = 0; k <= F; ++k) m.c[k] = choose(split.near, m.c[k], far.c[k]);
  for (int k = 0; k < F; ++k) m.d[k] = choose(split.near, m.d[k], far.d[k]);
  if (want_log) m.log_product = split.near ? m.log_product : far.log_product;
}

// ---- blocks -------------------------------------------------------------------------------------------------------

// Rows 0 and 1 of one column of a block, as they follow each other.
inline void save_rows(double* to, Vector row0, Vector row1) {
  save(to, evens(row0, row1));
  save(to + kLanes, odds(row0, row1));
}

template <int F> inline void store_h(const Integrator& in, const Pair* c, const Pair* d, Vector zeta, int at,
                                     BatchBlocks& out) {
  const double a = -in.k * in.t2, delta = in.k * in.t1;
  const Vector turn_re = zeta * (-in.k * in.cos2), turn_im = zeta * (-in.k * in.sin2);
  for (int l = 0; l < F; ++l) {
    const Vector beta = turn_re * d[l].re + turn_im * d[l].im, gamma = turn_im * d[l].re - turn_re * d[l].im;
    save_rows(out.h[l][0] + at, beta + a * c[l].im, gamma + delta * c[l].re);
    save_rows(out.h[l][1] + at, gamma - delta * c[l].re, a * c[l].im - beta);
  }
}

// Tractions: alpha = mean (1/2 - kappa ln|h|) - kappa E, and what turns with the axes about mean/2.
template <int F> inline void store_g(const Integrator& in, const Pair* c, const Vector* e, Vector zeta, int at,
                                     BatchBlocks& out) {
  const double k = in.k * in.g_jacobian, half_re = 0.5 * k * in.cos2, half_im = 0.5 * k * in.sin2;
  const double constant = k * (0.5 - in.kappa * in.log_half), per_e = k * in.kappa;
  const Vector turn_re = zeta * (-k * in.cos2), turn_im = zeta * (-k * in.sin2);
  for (int l = 0; l < F; ++l) {
    const double* s = shape_coefficients(F, l);
    const double mean = F == 2 ? 1.0 : 2.0 * s[0] + (F > 2 ? 2.0 / 3.0 * s[F > 2 ? 2 : 0] : 0.0);
    const Vector alpha = mean * constant - per_e * e[l];
    const Vector beta = mean * half_re + turn_re * c[l].im - turn_im * c[l].re;
    const Vector gamma = mean * half_im + turn_im * c[l].im + turn_re * c[l].re;
    save_rows(out.g[l][0] + at, alpha + beta, gamma);
    save_rows(out.g[l][1] + at, gamma, alpha - beta);
  }
}

// From powers of eta to shape functions.
template <int F, class T> inline void shaped(const T* power, T* node) {
  if (F == 1) {
    node[0] = power[0];
  } else if (F == 2) {
    const T even = 0.5 * power[0], odd = 0.5 * power[1];
    node[0] = even - odd;
    node[1] = even + odd;
  } else {
    for (int l = 0; l < F; ++l) {
      const double* a = shape_coefficients(F, l);
      node[l] = a[0] * power[0];
      for (int k = 1; k < F; ++k) node[l] = node[l] + a[k] * power[k];
    }
  }
}

template <int F> void integrate_sources(const Integrator& in, const double* xy, bool want_h, bool want_g,
                                        BatchBlocks& out) {
  for (int at = 0; at < 2 * kBatch; at += 2 * kLanes) {
    const Vector first = load(xy + at), second = load(xy + at + kLanes);
    const Seen s = see(in, evens(first, second), odds(first, second));
    Many<F> m;
    find_moments<F>(s, want_g, m);
    Pair c[F];
    shaped<F>(m.c, c);
    if (want_h) {
      Pair d[F];
      shaped<F>(m.d, d);
      store_h<F>(in, c, d, s.z.im, at, out);
    }
    if (!want_g) continue;
    Vector power[F], e[F]; // by parts: (k+1) E_k = [eta^(k+1) ln|eta-z|] - Re C_{k+1}
    for (int k = 0; k < F; ++k)
      power[k] = ((k % 2 == 0 ? m.log_product : m.c[0].re) - m.c[k + 1].re) * (1.0 / (k + 1));
    shaped<F>(power, e);
    store_g<F>(in, c, e, s.z.im, at, out);
  }
}

void integrate_batch(const Integrator& in, const double* xy, bool want_h, bool want_g, BatchBlocks& out) {
  switch (in.functions) {
  case 1:
    return integrate_sources<1>(in, xy, want_h, want_g, out);
  case 2:
    return integrate_sources<2>(in, xy, want_h, want_g, out);
  case 3:
    return integrate_sources<3>(in, xy, want_h, want_g, out);
  default:
    return integrate_sources<4>(in, xy, want_h, want_g, out);
  }
}

void rigid_batch(const Integrator& in, const double* xy, double sum[2][2 * kBatch]) {
  constexpr double start = kFarStart[1];
  const double a = -in.k * in.t2, delta = in.k * in.t1;
  for (int at = 0; at < 2 * kBatch; at += 2 * kLanes) {
    const Vector first = load(xy + at), second = load(xy + at + kLanes);
    const Seen s = see(in, evens(first, second), odds(first, second));
    const Split split(s, start);
    Pair c, d;
    if (!(split.least < start) || any_far(s, start)) {
      const Series series = sum_series<3, false>(split.z, split.z2, split.least_far);
      Pair s1 = series.w * series.odd;
      s1.re += 1.0;
      c = -2.0 * (series.iz * s1);
      d = 2.0 * (series.w * series.geometric);
    }
    if (split.least < start) {
      const Ends e = see_ends(s);
      const Pair near_d = 2.0 * (e.iw1 * e.iw2);
      const bool mixed = any_far(s, start);
      c = mixed ? choose(split.near, e.c0, c) : e.c0;
      d = mixed ? choose(split.near, near_d, d) : near_d;
    }
    const Vector turn_re = s.z.im * (-in.k * in.cos2), turn_im = s.z.im * (-in.k * in.sin2);
    const Vector beta = turn_re * d.re + turn_im * d.im, gamma = turn_im * d.re - turn_re * d.im;
    save_rows(sum[0] + at, beta + a * c.im, gamma - delta * c.re);
    save_rows(sum[1] + at, gamma + delta * c.re, a * c.im - beta);
  }
}

void deposit(const double* values, const double factor[2], Real* to) {
  if constexpr (sizeof(Real) == sizeof(double)) {
    double* numbers = reinterpret_cast<double*>(to);
    const Vector factors = evens(all(factor[0]), all(factor[1]));
    for (int i = 0; i < 2 * kBatch; i += kLanes) save(numbers + i, load(numbers + i) + factors * load(values + i));
  } else {
    for (int i = 0; i < 2 * kBatch; ++i) to[i] += static_cast<Real>(factor[i % 2] * values[i]);
  }
}

void logarithms(const double* x, double* out) {
  for (int i = 0; i < kBatch; i += kLanes) save(out + i, logarithm(load(x + i)));
}

void angles(const double* y, const double* x, double* out) {
  for (int i = 0; i < kBatch; i += kLanes) save(out + i, angle(load(y + i), load(x + i)));
}

constexpr BatchKernel kLoops = {integrate_batch, rigid_batch, deposit, logarithms, angles};

} // namespace
} // namespace c2d
