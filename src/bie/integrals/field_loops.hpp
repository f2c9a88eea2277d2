#pragma once
// Displacement and stress at points far from a straight element: part of batch_loops.hpp, included nowhere else. Names and
// formulas are those of interior_straight.cpp; with n = -i all factors i are written out.
#include "bie/integrals/moment_loops.hpp"

namespace c2d {
namespace {

// Sums of moments times the real and the imaginary parts of a density, a + i b and a - i b of its own and its conjugate's.
struct Parts {
  Complexes a, b;
};
INLINE void gather(Parts& sum, Doubles re, Doubles im, Complexes moment) {
  sum.a = {sum.a.re + re * moment.re, sum.a.im + re * moment.im};
  sum.b = {sum.b.re + im * moment.re, sum.b.im + im * moment.im};
}
INLINE Complexes own(const Parts& p) { return {p.a.re - p.b.im, p.a.im + p.b.re}; }
INLINE Complexes conjugates(const Parts& p) { return {p.a.re + p.b.im, p.a.im - p.b.re}; }

struct FieldSums { // in the element's axes
  Complexes u, deviator;
  Doubles trace;
};

// int eta^k/(eta-z)^3.
template <int F> INLINE void third_moments(Complexes z, const Many<F>& m, Complexes* f) {
  const Complexes half = 0.5 * m.d[0]; // 1/(z^2-1)
  const Complexes f1 = -2.0 * (half * half);
  f[0] = z * f1;
  if (F > 1) f[F > 1 ? 1 : 0] = f1;
  if (F > 2) f[F > 2 ? 2 : 0] = f[0] + m.d[F > 2 ? 1 : 0];
}

template <int F> INLINE void add_tractions(const BatchFieldElement& e, Complexes z, const Many<F>& m, FieldSums& sum) {
  Parts c = {};
  Complexes d = {}, log = {};
#pragma GCC unroll 3
  for (int k = 0; k < F; ++k) {
    const double re = e.t[k].re, im = e.t[k].im;
    const Doubles moment = ((k % 2 == 0 ? m.log_product : m.c[0].re) - m.c[k + 1].re) * (1.0 / (k + 1));
    log = {log.re + re * moment, log.im + im * moment};
    gather(c, all(re), all(im), m.c[k]);
    d = {d.re + (re * m.d[k].re - im * m.d[k].im), d.im + (re * m.d[k].im + im * m.d[k].re)};
  }
  const Complexes tc = own(c);
  const Doubles turned = e.k_t * z.im, twice = 2.0 * z.im;
  sum.u = {(e.u0.re - e.k_log * log.re) - turned * tc.im, (e.u0.im - e.k_log * log.im) - turned * tc.re};
  sum.trace = (2.0 * e.k_d) * tc.re;
  const Complexes bar = conjugates(c);
  sum.deviator = {e.k_d * (e.kappa * bar.re + (tc.re - twice * d.im)), e.k_d * (e.kappa * bar.im + (tc.im + twice * d.re))};
}

template <int F>
INLINE void add_displacements(const BatchFieldElement& e, Complexes reference, Complexes z, const Many<F>& m, FieldSums& sum) {
  Complexes third[F], f = {};
  third_moments<F>(z, m, third);
  Parts c = {}, d = {};
#pragma GCC unroll 3
  for (int k = 0; k < F; ++k) {
    const Doubles re = k == 0 ? e.u[k].re - reference.re : all(e.u[k].re);
    const Doubles im = k == 0 ? e.u[k].im - reference.im : all(e.u[k].im);
    gather(c, re, im, m.c[k]);
    gather(d, re, im, m.d[k]);
    f = {f.re + (re * third[k].re - im * third[k].im), f.im + (re * third[k].im + im * third[k].re)};
  }
  const Complexes uc = own(c), ud = own(d);
  const Doubles twice = 2.0 * z.im;
  // kappa n uc + conj(n (uc_bar - uc) + n uc + (rho* - rho) n ud)
  const Doubles x = (uc.im - 2.0 * c.b.re) + twice * ud.re, y = (twice * ud.im - 2.0 * c.b.im) - uc.re;
  sum.u = {sum.u.re + e.half_k * (e.kappa * uc.im + x), sum.u.im - e.half_k * (e.kappa * uc.re + y)};
  sum.trace += e.k_s * ud.im;
  sum.deviator = {sum.deviator.re + e.k_s * ((ud.im - d.b.re) + twice * f.re),
                  sum.deviator.im + e.k_s * ((twice * f.im - d.b.im) - ud.re)};
}

template <int F> INLINE void field_at(const BatchFieldElement& e, const BatchPoints& p, int at, BatchField& out) {
  const Doubles ax = load(p.x + at) - e.x0, ay = load(p.y + at) - e.y0;
  Complexes z = {(ax * e.ux + ay * e.uy) - 1.0, ay * e.ux - ax * e.uy};
  Doubles z2 = squared_size(z);
  if (!(least(z2) >= kFarStart[F])) { // near lanes get some place far away
    const Bits near = z2 < kFarStart[F];
    z = choose(near, Complexes{all(8.0), all(0.0)}, z);
    z2 = near ? all(64.0) : z2;                      // (lanes)
    const Doubles mark = near ? all(1.0) : all(0.0); // (lanes)
    save(out.near + at, mark);
    out.some_near = true;
  } else {
    save(out.near + at, all(0.0));
  }
  Many<F> m;
  far_moments<F>(z, z2, kFarStart[F], true, m); // the same number of terms for all: no point depends on the others in its batch
  FieldSums sum;
  add_tractions<F>(e, z, m, sum);
  if (e.displaced) {
    const Doubles rx = load(p.reference_x + at), ry = load(p.reference_y + at);
    const Complexes reference = {rx * e.axis.re + ry * e.axis.im, ry * e.axis.re - rx * e.axis.im};
    add_displacements<F>(e, reference, z, m, sum);
  }
  save(out.ux + at, sum.u.re * e.axis.re - sum.u.im * e.axis.im);
  save(out.uy + at, sum.u.re * e.axis.im + sum.u.im * e.axis.re);
  save(out.trace + at, sum.trace);
  save(out.deviator_re + at, sum.deviator.re * e.axis2.re + sum.deviator.im * e.axis2.im);
  save(out.deviator_im + at, sum.deviator.im * e.axis2.re - sum.deviator.re * e.axis2.im);
}

template <int F> void field_of(const BatchFieldElement& e, const BatchPoints& p, BatchField& out) {
  out.some_near = false;
  for (int at = 0; at < kBatch; at += kDoubles) field_at<F>(e, p, at, out);
}

void field(const BatchFieldElement& e, const BatchPoints& p, BatchField& out) {
  switch (e.functions) {
  case 1: return field_of<1>(e, p, out);
  case 2: return field_of<2>(e, p, out);
  default: return field_of<3>(e, p, out);
  }
}

} // namespace
} // namespace c2d
