#include "linalg/lu.hpp"
#include "linalg/dense.hpp"
#include <limits>

namespace c2d {
namespace {

// Squaring a number above this does not underflow, and a quotient of two numbers up to 1 / this by it does
// not overflow.
constexpr Real smallest_safe() {
  return sizeof(Real) == 8 ? static_cast<Real>(1.5e-154) : static_cast<Real>(1.1e-19);
}

int32_t row_of_largest(int32_t first, int32_t rows, const Real* column) {
  int32_t row = first;
  Real most = 0;
  for (int32_t i = first; i < rows; ++i) {
    const Real size = column[i] < 0 ? -column[i] : column[i];
    if (size <= most) continue;
    most = size;
    row = i;
  }
  return row;
}

void note_unusable(int32_t column, PivotStats* stats) {
  stats->unusable += 1;
  if (stats->first_unusable < 0) stats->first_unusable = column;
}

// `column_of_u`: the j+1 entries of U's column j; its last is the pivot.
void note_pivot(int32_t j, const Real* column_of_u, Real norm, PivotStats* stats) {
  const Real pivot = column_of_u[j] < 0 ? -column_of_u[j] : column_of_u[j];
  const double ratio = static_cast<double>(pivot) / static_cast<double>(norm);
  if (stats->smallest_column < 0 || ratio < stats->smallest_ratio) {
    stats->smallest_ratio = ratio;
    stats->smallest_column = stats->base + j;
  }
  if (ratio > stats->largest_ratio) stats->largest_ratio = ratio;
  const double growth = static_cast<double>(largest(j + 1, column_of_u)) / static_cast<double>(norm);
  if (growth > stats->growth) stats->growth = growth;
}

void exchange_rows(int32_t cols, Real* a, int64_t lda, int32_t i, int32_t k) {
  if (i == k) return;
  for (int32_t j = 0; j < cols; ++j) {
    const Real kept = a[i + j * lda];
    a[i + j * lda] = a[k + j * lda];
    a[k + j * lda] = kept;
  }
}

// Factor columns first ... first+count-1, which have been updated by all columns before them, from row
// `first` down. Only these columns are touched.
int32_t factor_strip(int32_t rows, int32_t first, int32_t count, Real* a, int64_t lda, int32_t* pivots,
                     const Real* norms, PivotStats* stats) {
  int32_t unusable = 0;
  Real* strip = a + first * lda;
  for (int32_t j = first; j < first + count; ++j) {
    Real* column = a + j * lda;
    const Real norm = norms[j - first];
    const int32_t row = row_of_largest(j, rows, column);
    const Real size = column[row] < 0 ? -column[row] : column[row];
    const bool usable = size > norm * smallest_safe() && size >= std::numeric_limits<Real>::min();
    pivots[j] = usable ? row : j;
    if (!usable) {
      for (int32_t i = j; i < rows; ++i) column[i] = 0;
      note_unusable(stats->base + j, stats);
      ++unusable;
      continue;
    }
    exchange_rows(count, strip, lda, j, row);
    // Divide, do not multiply by the reciprocal, which could overflow: the quotients are at most 1.
    const Real pivot = column[j];
    for (int32_t i = j + 1; i < rows; ++i) column[i] /= pivot;
    note_pivot(j, column, norm, stats);
    gemm_minus(rows - j - 1, first + count - j - 1, 1, column + j + 1, lda, column + j + lda, lda,
               column + j + 1 + lda, lda);
  }
  return unusable;
}

} // namespace

void start_stats(PivotStats& stats) {
  stats = {0, 0, -1, -1, std::numeric_limits<double>::infinity(), 0, 0};
}

int32_t lu_strip(int32_t rows, int32_t first, int32_t count, Real* a, int64_t lda, int32_t* pivots,
                 const Real* norms, PivotStats* stats) {
  Real own_norms[kLuStrip];
  Real* strip = a + first * lda;
  for (int32_t j = 0; j < count; ++j)
    own_norms[j] = norms ? norms[first + j] : largest(rows, strip + j * lda);
  // Left-looking: everything the columns before have to say, at once.
  apply_pivots(count, strip, lda, pivots, 0, first);
  trsm_lower_unit(first, count, a, lda, strip, lda);
  gemm_minus(rows - first, count, first, a + first, lda, strip, lda, strip + first, lda);
  const int32_t unusable = factor_strip(rows, first, count, a, lda, pivots, own_norms, stats);
  apply_pivots(first, a, lda, pivots, first, count); // the columns of L before follow the rows
  return unusable;
}

int32_t lu_panel(int32_t rows, int32_t cols, Real* a, int64_t lda, int32_t* pivots, const Real* norms,
                 PivotStats* stats) {
  int32_t unusable = 0;
  for (int32_t first = 0; first < cols; first += kLuStrip) {
    const int32_t count = cols - first < kLuStrip ? cols - first : kLuStrip;
    unusable += lu_strip(rows, first, count, a, lda, pivots, norms, stats);
  }
  return unusable;
}

void apply_pivots(int32_t cols, Real* a, int64_t lda, const int32_t* pivots, int32_t first, int32_t count) {
  for (int32_t j = 0; j < cols; ++j) {
    Real* column = a + j * lda;
    for (int32_t i = first; i < first + count; ++i) {
      const Real kept = column[i];
      column[i] = column[pivots[i]];
      column[pivots[i]] = kept;
    }
  }
}

int32_t lu_factor(int32_t n, Real* a, int64_t lda, int32_t* pivots, PivotStats* stats) {
  PivotStats own;
  PivotStats* used = stats ? stats : &own;
  start_stats(*used);
  return lu_panel(n, n, a, lda, pivots, nullptr, used);
}

void lu_solve(int32_t n, int32_t nrhs, const Real* lu, int64_t lda, const int32_t* pivots, Real* b,
              int64_t ldb) {
  apply_pivots(nrhs, b, ldb, pivots, 0, n);
  trsm_lower_unit(n, nrhs, lu, lda, b, ldb);
  trsm_upper(n, nrhs, lu, lda, b, ldb);
}

} // namespace c2d
