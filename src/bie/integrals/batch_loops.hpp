// The loops of one instruction set. One source file per set includes this one; it defines C2D_VECTOR_BYTES and is compiled with
// that set's flags. Nothing in here may be visible to another file, and nothing inline from elsewhere may be used: a function
// merged by the linker would bring instructions to machines that lack them.
//
// Names and formulas are those of integrals_straight.cpp.
#include "bie/integrals/field_loops.hpp"
#include "bie/integrals/linear_loops.hpp"
#include "bie/integrals/ring_loops.hpp"
#include "model/shape.hpp"

namespace c2d {
namespace {

// ---- blocks
// -------------------------------------------------------------------------------------------------------

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

template <int F, class Sink>
INLINE void store_h(const BatchElement& e, const Complexes* c, const Complexes* moment, Doubles zeta, const Sink& sink) {
  Complexes d[F];
  shaped<F>(moment, d);
  const Doubles turn_re = zeta * e.h_cos2, turn_im = zeta * e.h_sin2;
#pragma GCC unroll 4
  for (int l = 0; l < F; ++l) {
    const Doubles beta = turn_re * d[l].re + turn_im * d[l].im, gamma = turn_im * d[l].re - turn_re * d[l].im;
    sink.scatter(0, l, 0, beta + e.h_alpha * c[l].im, gamma + e.h_delta * c[l].re);
    sink.scatter(0, l, 1, gamma - e.h_delta * c[l].re, e.h_alpha * c[l].im - beta);
  }
}

// int M_l.
constexpr double kMean[kElementNodes][kElementNodes] = {
    {2.0, 0.0, 0.0, 0.0}, {1.0, 1.0, 0.0, 0.0}, {1.0 / 3, 4.0 / 3, 1.0 / 3, 0.0}, {0.25, 0.75, 0.75, 0.25}};

// E by parts: (k+1) E_k = [eta^(k+1) ln|eta-z|] - Re C_{k+1}.
template <int F, class Sink>
INLINE void store_g(const BatchElement& e, const Complexes* c, const Many<F>& m, Doubles zeta, const Sink& sink) {
  Doubles power[F], logs[F];
#pragma GCC unroll 4
  for (int k = 0; k < F; ++k) power[k] = ((k % 2 == 0 ? m.log_product : m.c[0].re) - m.c[k + 1].re) * (1.0 / (k + 1));
  shaped<F>(power, logs);
  const Doubles turn_re = zeta * e.g_cos2, turn_im = zeta * e.g_sin2;
#pragma GCC unroll 4
  for (int l = 0; l < F; ++l) {
    const double mean = kMean[F - 1][l];
    const Doubles alpha = mean * e.g_alpha - e.g_log * logs[l];
    const Doubles beta = mean * e.g_half_cos2 + (turn_re * c[l].im - turn_im * c[l].re);
    const Doubles gamma = mean * e.g_half_sin2 + (turn_im * c[l].im + turn_re * c[l].re);
    sink.scatter(1, l, 0, alpha + beta, gamma);
    sink.scatter(1, l, 1, gamma, alpha - beta);
  }
}

template <int F, class Sink>
INLINE void store(const BatchElement& e, const Many<F>& m, Doubles zeta, bool want_h, bool want_g, const Sink& sink) {
  Complexes c[F];
  shaped<F>(m.c, c);
  if (want_h) store_h<F>(e, c, m.d, zeta, sink);
  if (want_g) store_g<F>(e, c, m, zeta, sink);
}

// Some sources are near: lanes that the series cannot serve get z = 8 there.
template <int F> INLINE void mixed_moments(const Seen& s, bool want_log, Many<F>& m) {
  const Doubles z2 = squared_size(s.z);
  const Bits near = z2 < kFarStart[F];
  near_moments<F>(s, m);
  if (!(least(-z2) <= -kFarStart[F])) return;
  const Doubles far_z2 = near ? all(64.0) : z2; // (lanes)
  Many<F> far;
  far_moments<F>(choose(near, Complexes{all(8.0), all(0.0)}, s.z), far_z2, least(far_z2), want_log, far);
  for (int k = 0; k <= F; ++k) m.c[k] = choose(near, m.c[k], far.c[k]);
  for (int k = 0; k < F; ++k) m.d[k] = choose(near, m.d[k], far.d[k]);
  m.log_product = near ? m.log_product : far.log_product; // (lanes)
}

// A function of its own, so that the frequent case keeps its numbers in registers.
template <int F>
OUTLINE void integrate_mixed(const BatchElement& e, const double* xy, bool want_h, bool want_g, const Room& room) {
  const Seen s = see(e, xy);
  Many<F> m;
  mixed_moments<F>(s, want_g, m);
  store<F>(e, m, s.z.im, want_h, want_g, room);
}

// kDoubles sources far away.
template <int F, class Sink>
INLINE void integrate_far(const BatchElement& e, Complexes z, Doubles z2, double least_z2, bool want_h, bool want_g,
                          const Sink& sink) {
  if (F == 2) return far_linear(e, z, z2, terms_of(least_z2), want_h, want_g, sink);
  Many<F> m;
  far_moments<F>(z, z2, least_z2, want_g, m);
  store<F>(e, m, z.im, want_h, want_g, sink);
}

template <int F>
INLINE void integrate_sources(const BatchElement& e, const double* xy, bool want_h, bool want_g, BatchBlocks& out) {
  for (int at = 0; at < 2 * kBatch; at += 2 * kDoubles) {
    const Complexes z = see_far(e, xy + at);
    const Doubles z2 = squared_size(z);
    const double least_z2 = least(z2);
    const Room room = {&out.h[0][0][at]};
    if (least_z2 < kFarStart[F])
      integrate_mixed<F>(e, xy + at, want_h, want_g, room);
    else
      integrate_far<F>(e, z, z2, least_z2, want_h, want_g, room);
  }
}

// ---- deposits
// -----------------------------------------------------------------------------------------------------

// Where the integrals of a deposit's component begin in `out`.
INLINE const double* scattered_from(const BatchRun& run, const Deposit& d, const BatchBlocks& out) {
  const uint64_t at = static_cast<uint64_t>(d.block - &run.blocks->h[0][0][0]); // h and g one after the other in both
  return &out.h[0][0][0] + (at / 4 * 2 + at % 2) * (2 * kBatch);
}

void scatter(const BatchRun& run, int32_t first, int32_t count, const BatchBlocks& out) {
  for (int n = 0; n < run.deposits->count; ++n) {
    const Deposit& d = run.deposits->list[n];
    const double* values = scattered_from(run, d, out);
    Real* to = d.column + 2 * static_cast<int64_t>(first);
    int i = 0;
    if constexpr (sizeof(Real) == sizeof(double)) {
      double* sums = reinterpret_cast<double*>(to);
      const Doubles factor = evens(all(run.sign[0] * d.factor), all(run.sign[1] * d.factor));
      for (; i + kDoubles <= 2 * count; i += kDoubles) save(sums + i, load(sums + i) + factor * load(values + i));
    }
    for (; i < 2 * count; ++i) to[i] += static_cast<Real>(run.sign[i % 2] * d.factor * values[i]);
  }
}

void integrate_batch(const BatchElement& e, const double* xy, bool want_h, bool want_g, BatchBlocks& out) {
  switch (e.functions) {
  case 1: return integrate_sources<1>(e, xy, want_h, want_g, out);
  case 2: return integrate_sources<2>(e, xy, want_h, want_g, out);
  case 3: return integrate_sources<3>(e, xy, want_h, want_g, out);
  default: return integrate_sources<4>(e, xy, want_h, want_g, out);
  }
}

// Adds to the columns while the numbers are in registers. Sources near the element go through `room`.
template <int F> void integrate_into(const BatchRun& run, const double* xy, int32_t first, int32_t count, BatchBlocks& room) {
  const BatchElement e = run.element;
  const bool want_h = run.want_h, want_g = run.want_g;
  Columns to = {run.direct, 2 * static_cast<int64_t>(first)};
  for (int32_t s = 0; s < count; s += kDoubles, to.row += 2 * kDoubles) {
    const Complexes z = see_far(e, xy + 2 * s);
    const Doubles z2 = squared_size(z);
    const double least_z2 = least(z2);
    if (least_z2 < kFarStart[F]) {
      integrate_mixed<F>(e, xy + 2 * s, want_h, want_g, Room{&room.h[0][0][0]});
      scatter(run, first + s, kDoubles, room);
    } else {
      integrate_far<F>(e, z, z2, least_z2, want_h, want_g, to);
    }
  }
}

void integrate_and_scatter(const BatchRun& run, const double* xy, int32_t first, int32_t count, BatchBlocks& room) {
  if (run.direct) {
    switch (run.element.functions) {
    case 1: return integrate_into<1>(run, xy, first, count, room);
    case 2: return integrate_into<2>(run, xy, first, count, room);
    case 3: return integrate_into<3>(run, xy, first, count, room);
    default: return integrate_into<4>(run, xy, first, count, room);
    }
  }
  for (int32_t s = 0; s < count; s += kBatch) {
    integrate_batch(run.element, xy + 2 * s, run.want_h, run.want_g, room);
    scatter(run, first + s, kBatch, room);
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
  const Doubles row0 = evens(h00, h01), row1 = evens(h10, h11), last0 = odds(h00, h01), last1 = odds(h10, h11);
  return {{low_pairs(row0, row1), high_pairs(row0, row1), low_pairs(last0, last1), high_pairs(last0, last1)}};
}

OUTLINE void rigid_mixed(const BatchElement& e, const double* xy, Rigid& out) {
  const Seen s = see(e, xy);
  Many<1> m;
  mixed_moments<1>(s, false, m);
  out = rigid_blocks(e, m.c[0], m.d[0], s.z.im);
}

// add(i, v): v contains the numbers i ... i + kDoubles - 1 of 4 kBatch.
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

constexpr BatchKernel kBatchLoops = {
    integrate_batch, scatter, integrate_and_scatter, rigid, rigid_off, field, integrate_ring_batch, ring_rigid, ring_panel,
    logarithms,      angles};

} // namespace
} // namespace c2d

#undef INLINE
#undef INLINED
#undef OUTLINE
