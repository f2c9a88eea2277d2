#include "contact/reduction/open_form.hpp"

#include "contact/reduction/rigid_balance.hpp"
#include "linalg/dense.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

// R with 1 at the slots that hold may have so much elsewhere. T has squares of that, which cancel where pairs stick.
constexpr double kMovesMost = 10, kWeighs = 1e-12;
constexpr double kNothing = sizeof(Real) == 8 ? 1e-12 : 1e-5;

// R and G combined so that each column has 1 in its own slot among those held and 0 in the others. G turned by `turn`.
struct Held {
  const Reduction& r;
  int32_t m, count;
  int32_t slot[kMostHeld];
  Real *motion, *resultant;           // R and G, m * count
  double turn[kMostHeld * kMostHeld]; // the columns' factors

  // So much and more of r.second behind them.
  Real* rest() const { return resultant + static_cast<int64_t>(count) * m; }
  Real& motion_at(int32_t i, int32_t k) const { return motion[static_cast<int64_t>(k) * m + i]; }
  Real& resultant_at(int32_t i, int32_t k) const { return resultant[static_cast<int64_t>(k) * m + i]; }
  bool is_held(int32_t dof) const {
    for (int32_t k = 0; k < count; ++k)
      if (slot[k] == dof) return true;
    return false;
  }
};

template <class Number> void swap_columns_of(Number* a, int64_t rows, int32_t i, int32_t j) {
  for (int64_t k = 0; k < rows; ++k) {
    const Number kept = a[i * rows + k];
    a[i * rows + k] = a[j * rows + k];
    a[j * rows + k] = kept;
  }
}

// Column `own` gets 1 in a row, and the others, by it, 0.
template <class Number> void clear_row(Number* a, int64_t rows, int32_t columns, int32_t own, const Number* row) {
  const Number by = row[own];
  for (int64_t k = 0; k < rows; ++k) a[own * rows + k] /= by;
  for (int32_t j = 0; j < columns; ++j)
    for (int64_t k = 0; k < rows && j != own; ++k) a[j * rows + k] -= row[j] * a[own * rows + k];
}

// The normals along which what is left moves farthest, by the length on which a force would act. (Where they hold it, no body
// slides freely whatever the friction, METHOD 13.6.)
bool hold_motions(Held& h) {
  for (int32_t s = 0; s < h.count; ++s) {
    double best = 0.0;
    int32_t column = s;
    for (int32_t i = 0; i < h.r.model.head->pairs; ++i) {
      const Pair& pair = h.r.model.pair[i];
      for (int32_t k = s; k < h.count && !h.is_held(pair.dof); ++k) {
        const double moves = fabs(static_cast<double>(h.motion_at(pair.dof, k)));
        if (moves * pair.weight <= best) continue;
        best = moves * pair.weight;
        column = k;
        h.slot[s] = pair.dof;
      }
    }
    if (best == 0.0) return false;
    swap_columns_of(h.motion, h.m, s, column);
    Real row[kMostHeld];
    for (int32_t k = 0; k < h.count; ++k) row[k] = h.motion_at(h.slot[s], k);
    clear_row(h.motion, h.m, h.count, s, row);
  }
  const double most = static_cast<double>(largest(h.r.engine, h.m * h.count, h.motion));
  return h.count == 0 || most <= kMovesMost;
}

// False: there forces hold nothing.
bool hold_resultants(Held& h) {
  bool holds = true;
  for (int32_t s = 0; s < h.count; ++s) {
    const auto size = [&](int32_t k) { return fabs(static_cast<double>(h.resultant_at(h.slot[s], k))); };
    int32_t column = s;
    for (int32_t k = s; k < h.count; ++k)
      if (size(k) > size(column)) column = k;
    holds = holds & (size(column) > kWeighs);
    swap_columns_of(h.resultant, h.m, s, column);
    swap_columns_of(h.turn, h.count, s, column);
    Real row[kMostHeld];
    double same[kMostHeld];
    for (int32_t k = 0; k < h.count; ++k) same[k] = row[k] = h.resultant_at(h.slot[s], k);
    clear_row(h.resultant, h.m, h.count, s, row);
    clear_row(h.turn, h.count, h.count, s, same);
  }
  return holds;
}

// Uses r.second.
c2d_status hold(Held& h) {
  const ContactTape& tape = h.r.tape;
  c2d_status status = h.count > 0 ? read_matrix(tape, ContactMatrix::motions, h.motion, h.m) : c2d_status{C2D_OK};
  if (status == C2D_OK && h.count > 0) status = read_matrix(tape, ContactMatrix::resultants, h.resultant, h.m);
  if (status != C2D_OK) return status;
  for (int32_t i = 0; i < h.count * h.count; ++i) h.turn[i] = i % (h.count + 1) == 0 ? 1.0 : 0.0;
  for (int32_t& slot : h.slot) slot = -1;
  if (!hold_motions(h)) return C2D_ERR_SINGULAR;
  const bool holds = hold_resultants(h);
  if (C2D_NEVER(!holds)) return C2D_ERR_SINGULAR; // a pressure works on what moves along its normal
  return C2D_OK;
}

Held held_of(const Reduction& r) {
  const int32_t m = contact_unknowns(r.tape), count = free_motions(r.tape);
  return Held{r, m, count, {}, r.second, r.second + static_cast<int64_t>(count) * m, {}};
}

bool bends_too_much(const Reduction& r) {
  const int64_t m = contact_unknowns(r.tape);
  for (int32_t i = 0; i < r.model.head->pairs; ++i)
    for (int slot = 0; slot <= r.model.pair[i].tangential; ++slot) {
      const int32_t dof = r.model.pair[i].dof + slot;
      if (slides(r, dof)) continue;
      const double most = static_cast<double>(largest(r.engine, static_cast<int32_t>(m), r.first + dof * m));
      if (loses_digits(r.model, i, slot, r.first + dof * m, most)) return true;
    }
  return false;
}

// In r.first A becomes T: with tau_H = -G^T tau and w'_O = A tau + R (w'_H - (A tau)_H), H the slots held.
void hold_stiffness(const Held& h) {
  const int32_t m = h.m, n = h.count;
  Real *a = h.r.first, *columns = h.rest(), *across = columns + static_cast<int64_t>(n) * m;
  for (int32_t k = 0; k < n; ++k)
    for (int32_t i = 0; i < m; ++i) columns[static_cast<int64_t>(k) * m + i] = a[static_cast<int64_t>(h.slot[k]) * m + i];
  for (int32_t j = 0; j < m; ++j)
    for (int32_t k = 0; k < n; ++k) across[static_cast<int64_t>(j) * n + k] = h.resultant_at(j, k);
  gemm_minus(h.r.engine, m, m, n, columns, m, across, n, a, m);
  for (int32_t j = 0; j < m; ++j)
    for (int32_t k = 0; k < n; ++k) across[static_cast<int64_t>(j) * n + k] = a[static_cast<int64_t>(j) * m + h.slot[k]];
  gemm_minus(h.r.engine, m, m, n, h.motion, m, across, n, a, m);
  for (int32_t k = 0; k < n; ++k) {
    for (int32_t j = 0; j < m; ++j) a[static_cast<int64_t>(j) * m + h.slot[k]] = -h.resultant_at(j, k);
    for (int32_t i = 0; i < m; ++i) a[static_cast<int64_t>(h.slot[k]) * m + i] = h.motion_at(i, k);
  }
  for (int32_t j = 0; j < n; ++j)
    for (int32_t k = 0; k < n; ++k) a[static_cast<int64_t>(h.slot[j]) * m + h.slot[k]] = 0;
}

// y -= R y_H.
void move_along(const Held& h, Real* y) {
  Real at[kMostHeld];
  for (int32_t k = 0; k < h.count; ++k) at[k] = y[h.slot[k]];
  for (int32_t k = 0; k < h.count; ++k)
    for (int32_t i = 0; i < h.m; ++i) y[i] -= at[k] * h.motion_at(i, k);
}

double largest_in(const Held& h, const Real* x) { return static_cast<double>(largest(h.r.engine, h.m, x)); }

// h of a load case in strip column 0 becomes its rates: with tau_H = -g, and as above.
c2d_status hold_rate(const Held& h, int32_t k) {
  const Reduction& r = h.r;
  Real *b = r.strip, *given = r.strip + r.strip_length;
  c2d_status status = given_resultants(r, k, given);
  double force[kMostHeld] = {};
  for (int32_t s = 0; s < h.count; ++s)
    for (int32_t j = 0; j < h.count; ++j) force[s] -= h.turn[s * h.count + j] * given[j];
  const double terms = largest_in(h, b);
  move_along(h, b);
  for (int32_t i = 0; i < h.m && largest_in(h, b) <= kNothing * terms; ++i) b[i] = 0; // the loads move bodies as if rigid
  for (int32_t s = 0; s < h.count; ++s)
    for (int32_t i = 0; i < h.m; ++i) b[i] += static_cast<Real>(force[s]) * h.rest()[static_cast<int64_t>(s) * h.m + i];
  move_along(h, b);
  for (int32_t s = 0; s < h.count; ++s) b[h.slot[s]] = static_cast<Real>(force[s]);
  return status;
}

} // namespace

c2d_status form_open_stiffness(const Reduction& r) {
  Held h = held_of(r);
  c2d_status status = hold(h);
  if (status != C2D_OK || bends_too_much(r)) return status == C2D_OK ? c2d_status{C2D_ERR_SINGULAR} : status;
  if (h.count > 0) hold_stiffness(h);
  return write_matrix(r.tape, ContactMatrix::stiffness, r.first, h.m);
}

c2d_status form_open_rates(const Reduction& r) {
  Held h = held_of(r);
  c2d_status status = hold(h);
  for (int32_t s = 0; s < h.count && status == C2D_OK; ++s)
    status = read_column(r.tape, ContactMatrix::compliance, h.slot[s], h.rest() + static_cast<int64_t>(s) * h.m);
  for (int32_t k = 0; k < r.model.head->load_cases && status == C2D_OK; ++k) {
    status = read_column(r.tape, ContactMatrix::closing, k, r.strip);
    if (status == C2D_OK) status = hold_rate(h, k);
    if (status == C2D_OK) status = write_column(r.tape, ContactMatrix::stiffness_load, k, r.strip);
  }
  for (int32_t i = 0; i < h.m; ++i) r.strip[i] = h.is_held(i) ? kBasisForce : (slides(r, i) ? kBasisNoForce : kBasisMotion);
  return status == C2D_OK ? write_column(r.tape, ContactMatrix::basis, 0, r.strip) : status;
}

} // namespace c2d
