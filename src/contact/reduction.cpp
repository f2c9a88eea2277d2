#include "contact/reduction.hpp"

#include <math.h>

#include "contact/rigid_balance.hpp"
#include "linalg/dense.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

using Matrix = ContactMatrix;

ContactMatrix of_body(ContactMatrix first_body, int body) {
  return static_cast<Matrix>(static_cast<int32_t>(first_body) + 3 * body);
}

// The strip is free: norms take a part of it.
c2d_status factor(const Reduction& r, Real* matrix) {
  return lu_factor(r.engine, r.tape.m, matrix, r.tape.m, r.pivots, r.strip, nullptr) == 0 ? C2D_OK : C2D_ERR_SINGULAR;
}

// v of the inverted body, whose factored S_u is in `first`.
c2d_status solve_loads(const Reduction& r) {
  if (r.model.head->rigid != 0) return kRigidPart.move_rigidly(r);
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < r.tape.cases && status == C2D_OK; ++k) {
    status = read_column(r.tape, of_body(Matrix::load1, r.inverted), k, r.strip);
    if (status != C2D_OK) break;
    lu_solve(r.engine, r.tape.m, 1, r.first, r.tape.m, r.pivots, r.strip, r.tape.m);
    status = write_column(r.tape, Matrix::flexibility_load, k, r.strip);
  }
  return status;
}

c2d_status factor_inverted(const Reduction& r) {
  if (r.model.head->rigid != 0) return C2D_OK;
  const c2d_status status = read_matrix(r.tape, of_body(Matrix::displacement1, r.inverted), r.first);
  return status == C2D_OK ? factor(r, r.first) : status;
}

// F and v of the inverted body; F stays in `second`. A rigid body does not give way, F = 0.
c2d_status invert_body(const Reduction& r) {
  const int32_t m = r.tape.m;
  const bool rigid = r.model.head->rigid != 0;
  c2d_status status = factor_inverted(r);
  if (status == C2D_OK && !rigid) status = read_matrix(r.tape, of_body(Matrix::traction1, r.inverted), r.second);
  if (status != C2D_OK) return status;
  for (int64_t i = 0; i < static_cast<int64_t>(m) * m; ++i) r.second[i] = rigid ? Real(0) : -r.second[i];
  if (!rigid) lu_solve(r.engine, m, m, r.first, m, r.pivots, r.second, m);
  status = write_matrix(r.tape, Matrix::flexibility, r.second);
  return status == C2D_OK ? solve_loads(r) : status;
}

// Columns of a product that go through memory of their own. With a kernel half of its scratch holds more of them, so
// that packing the left factor serves more columns; how many depends on m alone.
struct Strip {
  Engine engine;
  Real* columns;
  int32_t count;
};

Strip strip_of(const Reduction& r) {
  const int32_t m = r.tape.m;
  const int64_t half = full_scratch(m, m) / 2 / 8 * 8, wide = half / m / 8 * 8;
  if (kSmallCode || !r.engine.kernel || r.engine.numbers < 2 * half || wide < 2 * kStripColumns)
    return {r.engine, r.strip, kStripColumns};
  const int32_t most = m < 64 ? m : 64;
  Strip strip = {r.engine, r.engine.scratch + half, wide < most ? static_cast<int32_t>(wide) : most};
  strip.engine.numbers = half;
  strip.engine.used = nullptr;
  const int64_t used = half + static_cast<int64_t>(strip.count) * m;
  if (r.engine.used && *r.engine.used < used) *r.engine.used = used;
  return strip;
}

// M = S_t - S_u F of the other body, in place of F, whose columns are used up one strip after another.
c2d_status form_compliance(const Reduction& r) {
  const int32_t m = r.tape.m;
  const int other = 1 - r.inverted;
  c2d_status status = read_matrix(r.tape, of_body(Matrix::displacement1, other), r.first);
  const Strip strip = strip_of(r);
  for (int32_t j = 0; j < m && status == C2D_OK; j += strip.count) {
    const int32_t count = m - j < strip.count ? m - j : strip.count;
    for (int32_t c = 0; c < count && status == C2D_OK; ++c)
      status = read_column(r.tape, of_body(Matrix::traction1, other), j + c, strip.columns + static_cast<int64_t>(c) * m);
    if (status != C2D_OK) return status;
    Real* columns = r.second + static_cast<int64_t>(j) * m;
    gemm_minus(strip.engine, m, count, m, r.first, m, columns, m, strip.columns, m);
    for (int64_t i = 0; i < static_cast<int64_t>(count) * m; ++i) columns[i] = strip.columns[i];
  }
  return status == C2D_OK ? write_matrix(r.tape, Matrix::compliance, r.second) : status;
}

// h - B (overlap, 0), in place of h; B is in `first`.
void close_overlaps(const Reduction& r) {
  const int32_t m = r.tape.m;
  for (int32_t i = 0; i < r.model.head->pairs; ++i) {
    const Pair& pair = r.model.pair[i];
    if (pair.overlap == 0.0) continue;
    const Real overlap = static_cast<Real>(pair.overlap / r.model.head->length_unit);
    const Real* column = r.first + static_cast<int64_t>(pair.dof) * m;
    for (int32_t j = 0; j < m; ++j) r.strip[j] -= overlap * column[j];
  }
}

double largest(const Real* x, int64_t n) {
  double most = 0.0;
  for (int64_t i = 0; i < n; ++i) most = fmax(most, fabs(static_cast<double>(x[i])));
  return most;
}

// h = +-(s - S_u v); S_u of the other body is in `first`. What is left of a load that moves all pairs as a rigid body, on a
// body that is free to go along, is round-off, and set to zero: or its last digits would be the load.
c2d_status form_closing(const Reduction& r) {
  const int32_t m = r.tape.m;
  constexpr double kNothing = sizeof(Real) == 8 ? 1e-12 : 1e-5;
  Real* v = r.strip + m;
  const double most = largest(r.first, static_cast<int64_t>(m) * m);
  for (int32_t k = 0; k < r.tape.cases; ++k) {
    c2d_status status = read_column(r.tape, of_body(Matrix::load1, 1 - r.inverted), k, r.strip);
    if (status == C2D_OK) status = read_column(r.tape, Matrix::flexibility_load, k, v);
    if (status != C2D_OK) return status;
    const double terms = largest(r.strip, m) + most * largest(v, m);
    gemm_minus(r.engine, m, 1, m, r.first, m, v, m, r.strip, m);
    if (largest(r.strip, m) <= kNothing * terms)
      for (int32_t i = 0; i < m; ++i) r.strip[i] = 0;
    if (r.inverted == 1)
      for (int32_t i = 0; i < m; ++i) r.strip[i] = -r.strip[i];
    if (k + 1 == r.model.head->interference) close_overlaps(r);
    status = write_column(r.tape, Matrix::closing, k, r.strip);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

// b = -M^-1 h, balanced; M, factored, is in `second`.
c2d_status form_rates(const Reduction& r) {
  const int32_t m = r.tape.m;
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < r.tape.cases && status == C2D_OK; ++k) {
    status = read_column(r.tape, Matrix::closing, k, r.strip);
    if (status != C2D_OK) break;
    lu_solve(r.engine, m, 1, r.second, m, r.pivots, r.strip, m);
    for (int32_t i = 0; i < m; ++i) r.strip[i] = -r.strip[i];
    status = balance_rate(r, k);
    if (status == C2D_OK) status = write_column(r.tape, Matrix::stiffness_load, k, r.strip);
  }
  return status;
}

// T = M^-1 B in place of B, and b.
c2d_status form_stiffness(const Reduction& r) {
  const int32_t m = r.tape.m;
  c2d_status status = factor(r, r.second);
  if (status != C2D_OK) return status;
  lu_solve(r.engine, m, m, r.second, m, r.pivots, r.first, m);
  status = form_rates(r);
  if (status == C2D_OK) status = balance_stiffness(r);
  return status == C2D_OK ? write_matrix(r.tape, Matrix::stiffness, r.first) : status;
}

// The same steps for the loads alone, with the matrices that are on the tape.
c2d_status solve_loads_again(const Reduction& r) {
  const c2d_status status = factor_inverted(r);
  return status == C2D_OK ? solve_loads(r) : status;
}
c2d_status form_closing_again(const Reduction& r) {
  const c2d_status status = read_matrix(r.tape, of_body(Matrix::displacement1, 1 - r.inverted), r.first);
  return status == C2D_OK ? form_closing(r) : status;
}
c2d_status form_rates_again(const Reduction& r) {
  c2d_status status = read_matrix(r.tape, Matrix::compliance, r.second);
  if (status == C2D_OK) status = factor(r, r.second);
  return status == C2D_OK ? form_rates(r) : status;
}

using Step = c2d_status (*)(const Reduction&);
template <int n> c2d_status take_steps(const Reduction& r, const Step (&steps)[n]) {
  for (const Step& step : steps) {
    c2d_status status = r.tick(r.watch_context);
    if (status == C2D_OK) status = step(r);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace

c2d_status reduce(const Reduction& r) {
  const Step steps[] = {find_balance, invert_body, form_compliance, form_closing, form_stiffness};
  return take_steps(r, steps);
}

c2d_status reduce_loads(const Reduction& r) {
  const Step steps[] = {solve_loads_again, form_closing_again, form_rates_again};
  return take_steps(r, steps);
}

} // namespace c2d
