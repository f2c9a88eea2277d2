// Batches: constants of a straight element for the vector loops (batch_loops.hpp), and the choice of the loops. Everything
// that does not depend on the source is multiplied out here, once per element.
#include "bie/integrals/batch.hpp"

#include "memory/math.hpp"

namespace c2d {

const BatchKernel* batch_for(Instructions set) {
  switch (set) {
  case Instructions::avx512: return avx512_batch();
  case Instructions::avx2: return avx2_batch();
  case Instructions::baseline: return baseline_batch();
  default: return nullptr;
  }
}

BatchElement batch_element(const Integrator& in) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double k = in.k, kg = in.k * in.g_jacobian;
  BatchElement b;
  b.x0 = e.x[0];
  b.y0 = e.y[0];
  b.x1 = e.x[last];
  b.y1 = e.y[last];
  b.ux = in.ux;
  b.uy = in.uy;
  b.h_alpha = -k * in.t2;
  b.h_delta = k * in.t1;
  b.h_cos2 = -k * in.cos2;
  b.h_sin2 = -k * in.sin2;
  b.g_alpha = kg * (0.5 - in.kappa * in.log_half);
  b.g_log = kg * in.kappa;
  b.g_cos2 = -kg * in.cos2;
  b.g_sin2 = -kg * in.sin2;
  b.g_half_cos2 = 0.5 * kg * in.cos2;
  b.g_half_sin2 = 0.5 * kg * in.sin2;
  b.functions = in.functions;
  return b;
}

bool batch_field_element(const FieldElement& e, BatchFieldElement& out) {
  const Integrator& in = e.in;
  // Cubic functions are evaluated point by point, by add_field().
  if (!e.closed_form || in.functions > 3) return false;
  const double per_length = sqrt(in.ux * in.ux + in.uy * in.uy); // 1/|h|
  out.x0 = in.element.x[0];
  out.y0 = in.element.y[0];
  out.ux = in.ux;
  out.uy = in.uy;
  out.kappa = in.kappa;
  out.k_t = in.k * in.g_jacobian;
  out.k_log = out.k_t * in.kappa;
  out.k_d = out.k_t * per_length;
  out.k_s = 2.0 * in.k * per_length;
  out.half_k = 0.5 * in.k;
  out.axis = e.axis;
  out.axis2 = e.axis * e.axis;
  // The part of the displacement that is the same at all points.
  Complex mean = {0.0, 0.0};
  for (int k = 0; k < 3; ++k) {
    out.t[k] = e.t[k];
    out.u[k] = e.u[k];
    if (k % 2 == 0) add(mean, (2.0 / (k + 1)) * e.t[k]);
  }
  const double logs = out.k_log * in.log_half;
  out.u0 = {out.k_t * mean.re - logs * mean.re, -logs * mean.im};
  out.functions = in.functions;
  out.displaced = e.displaced;
  return true;
}

void aim_columns(const BatchRun& run, BatchColumns& out) {
  // The place of a block's entry says which component it is; so each component finds its column without a search.
  out = BatchColumns{};
  for (int n = 0; n < run.deposits->count; ++n) {
    const Deposit& d = run.deposits->list[n];
    const int64_t at = d.block - &run.blocks->h[0][0][0], kind = at / 16, l = at / 4 % 4, j = at % 2;
    C2D_ASSERT(!out.to[kind][l][j]);
    out.to[kind][l][j] = d.column;
    out.factor[kind][l][j] = d.factor;
  }
}

bool is_batched(const Integrator& in, bool want_g) {
  return in.mode == Quadrature::accurate && !is_ring(in) && in.element.straight && (!want_g || in.closed_form_g);
}

} // namespace c2d
