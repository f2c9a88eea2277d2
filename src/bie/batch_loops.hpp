// The loops of one instruction set: included by one source file per set, which defines C2D_VECTOR_BYTES and
// is compiled with that set's flags. Nothing in here may be seen by another file, nor anything be used that
// is inline elsewhere: a function shared by the linker would carry instructions into machines that lack them.
//
// Names and formulas are those of straight_moments.hpp and integrals_straight.cpp; series there and here are
// those of C_k, in w = 1/z^2.
#include "bie/batch.hpp"
#include "bie/shape.hpp"
#include "bie/straight_moments.hpp"
#include "bie/vector_loops.hpp"

namespace c2d {
namespace {

struct Complexes { // a complex number per lane
  Doubles re, im;
};
INLINE Complexes operator+(Complexes a, Complexes b) {
  return {a.re + b.re, a.im + b.im};
}
INLINE Complexes operator-(Complexes a, Complexes b) {
  return {a.re - b.re, a.im - b.im};
}
INLINE Complexes operator*(Complexes a, Complexes b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
INLINE Complexes operator*(double s, Complexes a) {
  return {s * a.re, s * a.im};
}
INLINE Complexes choose(Bits which, Complexes a, Complexes b) {
  return {which ? a.re : b.re, which ? a.im : b.im};
}

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
  s.z.im = (first ? ay : by) * e.ux - (first ? ax : bx) * e.uy;
  s.z.re = first ? s.xi1 - 1.0 : s.xi2 + 1.0;
  return s;
}

// z of sources farther away, from the first end alone.
INLINE Complexes see_far(const BatchElement& e, const double* xy) {
  const Doubles v = load(xy), w = load(xy + kDoubles), ax = evens(v, w) - e.x0, ay = odds(v, w) - e.y0;
  return {(ax * e.ux + ay * e.uy) - 1.0, ay * e.ux - ax * e.uy};
}

INLINE Doubles squared_size(Complexes z) {
  return z.re * z.re + z.im * z.im;
}

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
  if (z2 >= 1e4) return 4;
  if (z2 >= 1e3) return 5;
  if (z2 >= 1e2) return 8;
  return z2 >= 32.0 ? 10 : 14;
}

constexpr double kThirds[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17,
                              1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25, 1.0 / 27, 1.0 / 29, 1.0 / 31};
constexpr double kEach[] = {1.0,     1.0 / 2, 1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,
                            1.0 / 8, 1.0 / 9, 1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14};

// 1/z and w, and sum w^m/(2m+q), q = 3 or 5, sum w^m = 1/(1-w), Re sum w^m/(m+1) = -ln(1-w)/w. A polynomial
// with real coefficients at a complex argument takes two real recurrences, here all three together, highest
// power first.
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
    const Doubles next_odd = a[m] + (trace * odd - norm * odd2),
                  next_each = kEach[m] + (trace * each - norm * each2),
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

template <int F>
INLINE void far_moments(Complexes z, Doubles z2, double least_z2, bool want_log, Many<F>& m) {
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

// ---- blocks
// -------------------------------------------------------------------------------------------------------

// Rows 0 and 1 of one column of a block, as they follow each other.
INLINE void save_rows(double* to, Doubles row0, Doubles row1) {
  save(to, evens(row0, row1));
  save(to + kDoubles, odds(row0, row1));
}

// From powers of eta to shape functions.
template <int F, class T> INLINE void shaped(const T* power, T* node) {
  if (F == 1) {
    node[0] = power[0];
  } else if (F == 2) {
    const T even = 0.5 * power[0], odd = 0.5 * power[F - 1];
    node[0] = even - odd;
    node[F - 1] = even + odd;
  } else {
#pragma GCC unroll 4
    for (int l = 0; l < F; ++l) {
      const double* a = shape_coefficients(F, l);
      node[l] = a[0] * power[0];
#pragma GCC unroll 4
      for (int k = 1; k < F; ++k) node[l] = node[l] + a[k] * power[k];
    }
  }
}

template <int F>
INLINE void store_h(const BatchElement& e, const Complexes* c, const Complexes* moment, Doubles zeta,
                    double (*out)[2][2 * kBatch], int at) {
  Complexes d[F];
  shaped<F>(moment, d);
  const Doubles turn_re = zeta * e.h_cos2, turn_im = zeta * e.h_sin2;
#pragma GCC unroll 4
  for (int l = 0; l < F; ++l) {
    const Doubles beta = turn_re * d[l].re + turn_im * d[l].im, gamma = turn_im * d[l].re - turn_re * d[l].im;
    save_rows(out[l][0] + at, beta + e.h_alpha * c[l].im, gamma + e.h_delta * c[l].re);
    save_rows(out[l][1] + at, gamma - e.h_delta * c[l].re, e.h_alpha * c[l].im - beta);
  }
}

// int M_l.
constexpr double kMean[4][4] = {
    {2.0, 0.0, 0.0, 0.0}, {1.0, 1.0, 0.0, 0.0}, {1.0 / 3, 4.0 / 3, 1.0 / 3, 0.0}, {0.25, 0.75, 0.75, 0.25}};

// E by parts: (k+1) E_k = [eta^(k+1) ln|eta-z|] - Re C_{k+1}.
template <int F>
INLINE void store_g(const BatchElement& e, const Complexes* c, const Many<F>& m, Doubles zeta,
                    double (*out)[2][2 * kBatch], int at) {
  Doubles power[F], logs[F];
#pragma GCC unroll 4
  for (int k = 0; k < F; ++k)
    power[k] = ((k % 2 == 0 ? m.log_product : m.c[0].re) - m.c[k + 1].re) * (1.0 / (k + 1));
  shaped<F>(power, logs);
  const Doubles turn_re = zeta * e.g_cos2, turn_im = zeta * e.g_sin2;
#pragma GCC unroll 4
  for (int l = 0; l < F; ++l) {
    const double mean = kMean[F - 1][l];
    const Doubles alpha = mean * e.g_alpha - e.g_log * logs[l];
    const Doubles beta = mean * e.g_half_cos2 + (turn_re * c[l].im - turn_im * c[l].re);
    const Doubles gamma = mean * e.g_half_sin2 + (turn_im * c[l].im + turn_re * c[l].re);
    save_rows(out[l][0] + at, alpha + beta, gamma);
    save_rows(out[l][1] + at, gamma, alpha - beta);
  }
}

template <int F>
INLINE void store(const BatchElement& e, const Many<F>& m, Doubles zeta, bool want_h, bool want_g,
                  BatchBlocks& out, int at) {
  Complexes c[F];
  shaped<F>(m.c, c);
  if (want_h) store_h<F>(e, c, m.d, zeta, out.h, at);
  if (want_g) store_g<F>(e, c, m, zeta, out.g, at);
}

// Some sources near: lanes that the series must not see are given z = 8 there.
template <int F> INLINE void mixed_moments(const Seen& s, bool want_log, Many<F>& m) {
  const Doubles z2 = squared_size(s.z);
  const Bits near = z2 < kFarStart[F];
  near_moments<F>(s, m);
  if (!(least(-z2) <= -kFarStart[F])) return;
  const Doubles far_z2 = near ? all(64.0) : z2;
  Many<F> far;
  far_moments<F>(choose(near, Complexes{all(8.0), all(0.0)}, s.z), far_z2, least(far_z2), want_log, far);
  for (int k = 0; k <= F; ++k) m.c[k] = choose(near, m.c[k], far.c[k]);
  for (int k = 0; k < F; ++k) m.d[k] = choose(near, m.d[k], far.d[k]);
  m.log_product = near ? m.log_product : far.log_product;
}

// Apart, so that the frequent case keeps its numbers in registers.
template <int F>
OUTLINE void integrate_mixed(const BatchElement& e, const double* xy, bool want_h, bool want_g,
                             BatchBlocks& out, int at) {
  const Seen s = see(e, xy);
  Many<F> m;
  mixed_moments<F>(s, want_g, m);
  store<F>(e, m, s.z.im, want_h, want_g, out, at);
}

template <int F>
INLINE void integrate_sources(const BatchElement& e, const double* xy, bool want_h, bool want_g,
                              BatchBlocks& out) {
  for (int at = 0; at < 2 * kBatch; at += 2 * kDoubles) {
    const Complexes z = see_far(e, xy + at);
    const Doubles z2 = squared_size(z);
    const double least_z2 = least(z2);
    if (least_z2 < kFarStart[F]) {
      integrate_mixed<F>(e, xy + at, want_h, want_g, out, at);
      continue;
    }
    Many<F> m;
    far_moments<F>(z, z2, least_z2, want_g, m);
    store<F>(e, m, z.im, want_h, want_g, out, at);
  }
}

// ---- deposits
// -----------------------------------------------------------------------------------------------------

INLINE void pay_batch(const BatchRun& run, int32_t first, const BatchBlocks& out) {
  const double* numbers = &out.h[0][0][0];
  const double* blocks = &run.blocks->h[0][0][0];
  for (int n = 0; n < run.deposits->count; ++n) {
    const Deposit& d = run.deposits->list[n];
    const uint32_t at = static_cast<uint32_t>(d.block - blocks); // h and g one after the other in both
    const double* values = numbers + (at / 4 * 2 + at % 2) * (2 * kBatch);
    Real* to = d.column + 2 * static_cast<int64_t>(first);
    if constexpr (sizeof(Real) == sizeof(double)) {
      double* sums = reinterpret_cast<double*>(to);
      const Doubles factor = evens(all(run.sign[0] * d.factor), all(run.sign[1] * d.factor));
#pragma GCC unroll 8
      for (int i = 0; i < 2 * kBatch; i += kDoubles)
        save(sums + i, load(sums + i) + factor * load(values + i));
    } else {
      for (int i = 0; i < 2 * kBatch; ++i) to[i] += static_cast<Real>(run.sign[i % 2] * d.factor * values[i]);
    }
  }
}

void pay(const BatchRun& run, int32_t first, int32_t count, const BatchBlocks& out) {
  if (count == kBatch) return pay_batch(run, first, out);
  const double* blocks = &run.blocks->h[0][0][0];
  for (int n = 0; n < run.deposits->count; ++n) {
    const Deposit& d = run.deposits->list[n];
    const uint32_t at = static_cast<uint32_t>(d.block - blocks);
    const double* values = &out.h[0][0][0] + (at / 4 * 2 + at % 2) * (2 * kBatch);
    Real* to = d.column + 2 * static_cast<int64_t>(first);
    for (int i = 0; i < 2 * count; ++i) to[i] += static_cast<Real>(run.sign[i % 2] * d.factor * values[i]);
  }
}

void integrate_batch(const BatchElement& e, const double* xy, bool want_h, bool want_g, BatchBlocks& out) {
  switch (e.functions) {
  case 1:
    return integrate_sources<1>(e, xy, want_h, want_g, out);
  case 2:
    return integrate_sources<2>(e, xy, want_h, want_g, out);
  case 3:
    return integrate_sources<3>(e, xy, want_h, want_g, out);
  default:
    return integrate_sources<4>(e, xy, want_h, want_g, out);
  }
}

void integrate_and_pay(const BatchRun& run, const double* xy, int32_t first, int32_t count,
                       BatchBlocks& room) {
  for (int32_t s = 0; s < count; s += kBatch) {
    integrate_batch(run.element, xy + 2 * s, run.want_h, run.want_g, room);
    pay_batch(run, first + s, room);
  }
}

// ---- rigid translation
// --------------------------------------------------------------------------------------------

// The first and the last half of kDoubles sources, four numbers each, 2 i + j.
struct Rigid {
  Doubles part[4];
};

INLINE Rigid rigid_blocks(const BatchElement& e, Complexes c, Complexes d, Doubles zeta) {
  const Doubles turn_re = zeta * e.h_cos2, turn_im = zeta * e.h_sin2;
  const Doubles beta = turn_re * d.re + turn_im * d.im, gamma = turn_im * d.re - turn_re * d.im;
  const Doubles h00 = beta + e.h_alpha * c.im, h01 = gamma - e.h_delta * c.re;
  const Doubles h10 = gamma + e.h_delta * c.re, h11 = e.h_alpha * c.im - beta;
  const Doubles row0 = evens(h00, h01), row1 = evens(h10, h11), last0 = odds(h00, h01),
                last1 = odds(h10, h11);
  return {{low_pairs(row0, row1), high_pairs(row0, row1), low_pairs(last0, last1), high_pairs(last0, last1)}};
}

OUTLINE void rigid_mixed(const BatchElement& e, const double* xy, Rigid& out) {
  const Seen s = see(e, xy);
  Many<1> m;
  mixed_moments<1>(s, false, m);
  out = rigid_blocks(e, m.c[0], m.d[0], s.z.im);
}

// add(i, v): v belongs to the numbers i ... i + kDoubles - 1 of 4 kBatch.
template <class Add> INLINE void sum_rigid(const BatchElement& e, const double* xy, Add add) {
  for (int at = 0; at < 2 * kBatch; at += 2 * kDoubles) {
    const Complexes z = see_far(e, xy + at);
    const Doubles z2 = squared_size(z);
    const double least_z2 = least(z2);
    if (least_z2 < kFarStart[1]) {
      Rigid near;
      rigid_mixed(e, xy + at, near);
      for (int k = 0; k < 4; ++k) add(2 * at + k * kDoubles, near.part[k]);
      continue;
    }
    Many<1> m;
    far_moments<1>(z, z2, least_z2, false, m);
    const Rigid far = rigid_blocks(e, m.c[0], m.d[0], z.im);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) add(2 * at + k * kDoubles, far.part[k]);
  }
}

void rigid(const BatchElement& e, const double* xy, double* sum) {
  sum_rigid(e, xy, [&](int i, Doubles v) INLINED { save(sum + i, v); });
}

void rigid_off(const BatchElement& e, const double* xy, int32_t count, double* diagonal) {
  for (int32_t s = 0; s < count; s += kBatch) {
    double* to = diagonal + 4 * s;
    sum_rigid(e, xy + 2 * s, [&](int i, Doubles v) INLINED { save(to + i, load(to + i) - v); });
  }
}

void logarithms(const double* x, double* out) {
  for (int i = 0; i < kBatch; i += kDoubles) save(out + i, logarithm(load(x + i)));
}

void angles(const double* y, const double* x, double* out) {
  for (int i = 0; i < kBatch; i += kDoubles) save(out + i, angle(load(y + i), load(x + i)));
}

constexpr BatchKernel kBatchLoops = {integrate_batch, pay,   integrate_and_pay, rigid, rigid_off,
                                     logarithms,      angles};

} // namespace
} // namespace c2d

#undef INLINE
#undef INLINED
#undef OUTLINE
