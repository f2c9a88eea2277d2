#pragma once
// Where blocks go, and linear elements at a distance, the most frequent case: part of batch_loops.hpp, included nowhere else.
#include "bie/integrals/moment_loops.hpp"

namespace c2d {
namespace {

// Sinks: scatter(kind, l, j, row0, row1) takes the rows 0 and 1 of one column of a block, kind 0: h, 1: g.

struct Room { // from the first of the sources in a BatchBlocks on
  double* at;
  INLINE void scatter(int kind, int l, int j, Doubles row0, Doubles row1) const {
    double* to = at + ((kind * 4 + l) * 2 + j) * (2 * kBatch);
    save(to, evens(row0, row1));
    save(to + kDoubles, odds(row0, row1));
  }
};

struct Columns { // from `row` on
  const BatchColumns* columns;
  int64_t row;
  INLINE void scatter(int kind, int l, int j, Doubles row0, Doubles row1) const {
    double* to = reinterpret_cast<double*>(columns->to[kind][l][j]);
    if (!to) return;
    to += row;
    const Doubles factor = all(columns->factor[kind][l][j]);
    save(to, load(to) + factor * evens(row0, row1));
    save(to + kDoubles, load(to + kDoubles) + factor * odds(row0, row1));
  }
};

// With S_q = sum w^m/(2m+q) the halves of the moments of 1 and eta are
//   C: -S_1/z and -w S_3, D: w R and (w R - w S_3)/z, R = sum w^m,
// and those of the logarithm, with C_2 = -2 S_3/z, ln|z|^2/2 - Re w P, P = sum w^m/((2m+3)(2m+2)), and -Re (S_1 - S_3)/(2z).
// The functions are the difference and the sum of the two.
struct LinearFar {
  Complexes c0, c1, d0, d1; // c0, c1: without their sign
  Doubles log0, log1;
};

constexpr double kLogs[] = {1.0 / 6,   1.0 / 20,  1.0 / 42,  1.0 / 72,  1.0 / 110, 1.0 / 156, 1.0 / 210,
                            1.0 / 272, 1.0 / 342, 1.0 / 420, 1.0 / 506, 1.0 / 600, 1.0 / 702, 1.0 / 812};

INLINE LinearFar linear_far(Complexes z, Doubles z2, int terms, bool want_log) {
  LinearFar f;
  const Doubles q = 1.0 / z2;
  const Complexes iz = {z.re * q, -z.im * q};
  const Complexes w = {iz.re * iz.re - iz.im * iz.im, 2.0 * (iz.re * iz.im)};
  // Polynomials with real coefficients at a complex argument, as in sum_series().
  const Doubles trace = 2.0 * w.re, norm = q * q;
  int m = terms - 2;
  Doubles odd2 = all(kThirds[m + 1]), one2 = all(1.0), log2 = all(kLogs[m + 1]);
  Doubles odd = kThirds[m] + trace * odd2, one = 1.0 + trace, log = kLogs[m] + trace * log2;
  while (--m > 0) {
    const Doubles next_odd = kThirds[m] + (trace * odd - norm * odd2), next_one = 1.0 + (trace * one - norm * one2),
                  next_log = kLogs[m] + (trace * log - norm * log2);
    odd2 = odd, one2 = one, log2 = log;
    odd = next_odd, one = next_one, log = next_log;
  }
  const Complexes s3 = {kThirds[0] + (w.re * odd - norm * odd2), w.im * odd};
  const Complexes r = {1.0 + (w.re * one - norm * one2), w.im * one};
  f.c1 = w * s3;
  f.c0 = iz + iz * f.c1;
  f.d0 = w * r;
  f.d1 = iz * (f.d0 - f.c1);
  if (want_log) {
    const Complexes p = {kLogs[0] + (w.re * log - norm * log2), w.im * log};
    const Complexes v = {(f.c1.re - s3.re) + 1.0, f.c1.im - s3.im};
    f.log0 = 0.5 * logarithm(z2) + (w.im * p.im - w.re * p.re);
    f.log1 = -0.5 * (iz.re * v.re - iz.im * v.im);
  }
  return f;
}

// Entries of the 2x2 blocks of both functions from those of 1 and eta.
struct Entries {
  Doubles a00, a10, a01, a11;
};
template <class Sink> INLINE void scatter_linear(const Entries& even, const Entries& odd, int kind, const Sink& sink) {
  sink.scatter(kind, 0, 0, even.a00 - odd.a00, even.a10 - odd.a10);
  sink.scatter(kind, 0, 1, even.a01 - odd.a01, even.a11 - odd.a11);
  sink.scatter(kind, 1, 0, even.a00 + odd.a00, even.a10 + odd.a10);
  sink.scatter(kind, 1, 1, even.a01 + odd.a01, even.a11 + odd.a11);
}

INLINE Entries entries_h(const BatchElement& e, Complexes c, Complexes d, Complexes turn) {
  const Doubles alpha = e.h_alpha * c.im, delta = e.h_delta * c.re; // of the negative moment
  const Doubles beta = turn.re * d.re + turn.im * d.im, gamma = turn.im * d.re - turn.re * d.im;
  return {beta - alpha, gamma - delta, gamma + delta, -alpha - beta};
}

INLINE Entries entries_g(Doubles alpha, Doubles beta, Doubles gamma) { return {alpha + beta, gamma, gamma, alpha - beta}; }

template <class Sink>
INLINE void far_linear(const BatchElement& e, Complexes z, Doubles z2, int terms, bool want_h, bool want_g, const Sink& sink) {
  const LinearFar f = linear_far(z, z2, terms, want_g);
  if (want_h) {
    const Complexes turn = {z.im * e.h_cos2, z.im * e.h_sin2};
    scatter_linear(entries_h(e, f.c0, f.d0, turn), entries_h(e, f.c1, f.d1, turn), 0, sink);
  }
  if (want_g) {
    const Complexes turn = {z.im * e.g_cos2, z.im * e.g_sin2};
    const Doubles beta0 = e.g_half_cos2 + (turn.im * f.c0.re - turn.re * f.c0.im);
    const Doubles gamma0 = e.g_half_sin2 - (turn.im * f.c0.im + turn.re * f.c0.re);
    const Doubles beta1 = turn.im * f.c1.re - turn.re * f.c1.im;
    const Doubles gamma1 = -(turn.im * f.c1.im + turn.re * f.c1.re);
    scatter_linear(entries_g(e.g_alpha - e.g_log * f.log0, beta0, gamma0), entries_g(-e.g_log * f.log1, beta1, gamma1), 1,
                   sink);
  }
}

} // namespace
} // namespace c2d
