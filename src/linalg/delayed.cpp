#include "linalg/delayed.hpp"

#include "linalg/dense.hpp"
#include "linalg/exchange.hpp"
#include "memory/hostile.hpp"

namespace c2d {
namespace {

Real* column(const DelayedExchanges& d, int32_t j) { return d.t + static_cast<int64_t>(j) * d.rows; }

// x (n) -= M (n x count) times row i of `other`, both with the list's exchanges as columns.
void subtract_list(const DelayedExchanges& d, const Engine& engine, int32_t n, const Real* m, const Real* other, int32_t others,
                   int32_t i, Real factor, Real* x) {
  Real by[kMostDelayed];
  for (int32_t k = 0; k < d.count; ++k) by[k] = factor * other[i + static_cast<int64_t>(k) * others];
  gemm_minus(engine, n, 1, d.count, m, n, by, d.count, x, n);
}

} // namespace

void read_column(const DelayedExchanges& d, const Engine& engine, int32_t j, Real* out) {
  const Real* const from = column(d, j);
  for (int32_t i = 0; i < d.rows; ++i) out[i] = from[i];
  subtract_list(d, engine, d.rows, d.left, d.right, d.cols, j, 1, out);
}

void read_row(const DelayedExchanges& d, const Engine& engine, int32_t i, Real* out) {
  for (int32_t j = 0; j < d.cols; ++j) out[j] = column(d, j)[i];
  subtract_list(d, engine, d.cols, d.right, d.left, d.rows, i, 1, out);
}

Real read_entry(const DelayedExchanges& d, int32_t i, int32_t j) {
  Real sum = column(d, j)[i];
  for (int32_t k = 0; k < d.count; ++k)
    sum -= d.left[i + static_cast<int64_t>(k) * d.rows] * d.right[j + static_cast<int64_t>(k) * d.cols];
  return sum;
}

void add_column_to(const DelayedExchanges& d, const Engine& engine, int32_t j, Real factor, Real* y) {
  const Real* const from = column(d, j);
  for (int32_t i = 0; i < d.rows; ++i) y[i] += factor * from[i];
  subtract_list(d, engine, d.rows, d.left, d.right, d.cols, j, factor, y);
}

// Row r and column c of T - L R^T become zero, so that the new term alone stands there.
bool delay_exchange(DelayedExchanges& d, const Engine& engine, int32_t r, int32_t c, const Real** u, const Real** v) {
  C2D_ASSERT(d.most > 0 && d.most <= kMostDelayed && r >= 0 && r < d.rows && c >= 0 && c < d.cols);
  if (d.count == d.most) apply_delayed(d, engine);
  Real* const left = d.left + static_cast<int64_t>(d.count) * d.rows;
  Real* const right = d.right + static_cast<int64_t>(d.count) * d.cols;
  read_column(d, engine, c, left);
  const Real pivot = left[r];
  if ((pivot < 0 ? -pivot : pivot) < kSmallestReal) return false;
  read_row(d, engine, r, right);
  for (int32_t i = 0; i < d.rows; ++i) left[i] /= pivot, column(d, c)[i] = 0;
  for (int32_t j = 0; j < d.cols; ++j) column(d, j)[r] = 0;
  left[r] = 1 / pivot;
  right[c] = -1;
  for (int32_t k = 0; k < d.count; ++k)
    d.left[r + static_cast<int64_t>(k) * d.rows] = d.right[c + static_cast<int64_t>(k) * d.cols] = 0;
  ++d.count;
  *u = left;
  *v = right;
  return true;
}

void delayed_row_add(DelayedExchanges& d, int32_t target, int32_t source, Real factor) {
  row_add(d.cols, d.t, d.rows, target, source, factor);
  row_add(d.count, d.left, d.rows, target, source, factor);
}

void delayed_column_add(DelayedExchanges& d, int32_t target, int32_t source, Real factor) {
  column_add(d.rows, d.t, d.rows, target, source, factor);
  row_add(d.count, d.right, d.cols, target, source, factor);
}

void apply_delayed(DelayedExchanges& d, const Engine& engine) {
  outer_minus(engine, d.rows, d.cols, d.count, d.left, d.rows, d.right, d.cols, d.t, d.rows);
  d.count = 0;
}

} // namespace c2d
