// Gauss-Jordan exchange of a tableau y = T z (METHOD 11, equation METHOD (11.3)): with the pivot p = T_rc
//   T_rc' = 1/p,  T_rj' = -T_rj/p,  T_ic' = T_ic/p,  T_ij' = T_ij - T_ic T_rj/p.
// It solves row r for z_c and inserts the result into all other rows: the principal pivot of complementarity problems. The
// work goes column by column, since T is stored by columns. A column with a zero in row r does not change at all.
// Literature: Cottle, Pang and Stone, The Linear Complementarity Problem (1992) (principal pivoting).
#include "linalg/exchange.hpp"
#include "memory/hostile.hpp"

namespace c2d {
namespace {

void plain_add(int32_t n, Real factor, const Real* __restrict x, Real* __restrict y) {
  for (int32_t i = 0; i < n; ++i) y[i] += factor * x[i];
}

void plain_add_two(int32_t n, Real f, const Real* __restrict x, Real g, const Real* __restrict z, Real* __restrict y) {
  for (int32_t i = 0; i < n; ++i) y[i] = y[i] + f * x[i] + g * z[i];
}

// Below the smallest normal number a quotient would overflow or lose its digits.
bool usable(Real pivot) { return (pivot < 0 ? -pivot : pivot) >= kSmallestReal; }

// The pivot's own column comes last, because all other columns need it unchanged.
void finish(int32_t rows, int32_t r, Real* column) {
  const Real pivot = column[r];
  for (int32_t i = 0; i < rows; ++i) column[i] /= pivot;
  column[r] = 1 / pivot;
}

} // namespace

bool exchange(int32_t rows, int32_t cols, Real* t, int64_t ld, int32_t r, int32_t c, const Kernel* kernel) {
  C2D_ASSERT(r >= 0 && r < rows && c >= 0 && c < cols && ld >= rows);
  Real* pivot_column = t + c * ld;
  const Real pivot = pivot_column[r];
  if (!usable(pivot)) return false;
  const auto add = !kSmallCode && kernel ? kernel->add : plain_add;
  for (int32_t j = 0; j < cols; ++j) {
    Real* column = t + j * ld;
    if (j == c || column[r] == 0) continue;
    const Real entry = -column[r] / pivot;
    add(rows, entry, pivot_column, column);
    column[r] = entry;
  }
  finish(rows, r, pivot_column);
  return true;
}

// Both pivots of a pair in one pass: every other column is read and written once. This works because the entry of row b after
// the first exchange is known beforehand: T_bj + f T_ba, with f = -T_aj / T_aa.
bool exchange_two(int32_t rows, int32_t cols, Real* t, int64_t ld, int32_t a, int32_t b, const Kernel* kernel) {
  if (kSmallCode) return exchange(rows, cols, t, ld, a, a) && exchange(rows, cols, t, ld, b, b);
  Real *first = t + a * ld, *second = t + b * ld;
  // The second pivot is that after the first exchange, a Schur complement. Both are checked before anything changes.
  if (!usable(first[a]) || !usable(second[b] - first[b] * second[a] / first[a])) return false;
  const auto add = kernel ? kernel->add : plain_add;
  const auto add_two = kernel ? kernel->add_two : plain_add_two;
  // The second pivot column after the first exchange; all other columns use it.
  const Real corner = -second[a] / first[a];
  add(rows, corner, first, second);
  second[a] = corner;
  for (int32_t j = 0; j < cols; ++j) {
    Real* column = t + j * ld;
    if (j == a || j == b || (column[a] == 0 && column[b] == 0)) continue;
    const Real f = -column[a] / first[a], g = -(column[b] + f * first[b]) / second[b];
    add_two(rows, f, first, g, second, column);
    column[a] = f + g * second[a];
    column[b] = g;
  }
  // The first pivot column passes through the second exchange, like any other column.
  finish(rows, a, first);
  const Real entry = -first[b] / second[b];
  add(rows, entry, second, first);
  first[b] = entry;
  finish(rows, b, second);
  return true;
}

void row_add(int32_t cols, Real* t, int64_t ld, int32_t target, int32_t source, Real factor) {
  for (int32_t j = 0; j < cols; ++j) t[target + j * ld] += factor * t[source + j * ld];
}

void column_add(int32_t rows, Real* t, int64_t ld, int32_t target, int32_t source, Real factor) {
  Real* to = t + target * ld;
  const Real* from = t + source * ld;
  for (int32_t i = 0; i < rows; ++i) to[i] += factor * from[i];
}

} // namespace c2d
