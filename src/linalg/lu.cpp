#include "linalg/lu.hpp"
#include "linalg/dense.hpp"
#include "memory/hostile.hpp"
#include <limits>

namespace c2d {
namespace {

// Squaring a number above this does not underflow, and a quotient of two numbers up to 1 / this by it does
// not overflow.
constexpr Real smallest_safe() {
  return sizeof(Real) == 8 ? static_cast<Real>(1.5e-154) : static_cast<Real>(1.1e-19);
}

// A leaf of a block is factored column by column.
constexpr int32_t kLeaf = 16;

int32_t smaller(int32_t a, int32_t b) {
  return a < b ? a : b;
}

// x (m) -= L (m x k) u, and where its largest entry is: as Kernel::column.
int32_t plain_column(int32_t m, int32_t k, const Real* l, int64_t ldl, const Real* u, Real* x) {
  for (int32_t p = 0; p < k; ++p) {
    const Real* column = l + p * ldl;
    const Real f = u[p];
    for (int32_t i = 0; i < m; ++i) x[i] -= column[i] * f;
  }
  int32_t row = -1;
  Real most = 0;
  for (int32_t i = 0; i < m; ++i) {
    const Real size = x[i] < 0 ? -x[i] : x[i];
    if (size <= most) continue;
    most = size;
    row = i;
  }
  return row;
}

// Divide, do not multiply by the reciprocal, which could overflow: the quotients are at most 1.
void plain_divide(int32_t n, Real pivot, Real* x) {
  for (int32_t i = 0; i < n; ++i) x[i] /= pivot;
}

void note_unusable(int32_t column, PivotStats* stats) {
  stats->unusable += 1;
  if (stats->first_unusable < 0) stats->first_unusable = column;
}

// `column_of_u`: the j+1 entries of U's column j; its last is the pivot.
void note_pivot(const Engine& engine, int32_t j, const Real* column_of_u, Real norm, PivotStats* stats) {
  const Real pivot = column_of_u[j] < 0 ? -column_of_u[j] : column_of_u[j];
  const double ratio = static_cast<double>(pivot) / static_cast<double>(norm);
  if (stats->smallest_column < 0 || ratio < stats->smallest_ratio) {
    stats->smallest_ratio = ratio;
    stats->smallest_column = stats->base + j;
  }
  if (ratio > stats->largest_ratio) stats->largest_ratio = ratio;
  const double growth = static_cast<double>(largest(engine, j + 1, column_of_u)) / static_cast<double>(norm);
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

// A panel on its way.
struct Work {
  const Engine& engine;
  int32_t rows;
  Real* a;
  int64_t lda;
  int32_t* pivots;
  PivotStats* stats;
  Real* column(int32_t j) const { return a + j * lda; }
};

// Column j is brought up to date with the columns from `first` on, which belong to its leaf. Returns the row
// of its largest entry on and below the diagonal, or -1.
int32_t finish_column(const Work& w, int32_t first, int32_t j) {
  Real* x = w.column(j);
  const int32_t before = j - first;
  for (int32_t p = first; p < j; ++p) {
    const Real* l = w.column(p);
    const Real f = x[p];
    for (int32_t i = p + 1; i < j; ++i) x[i] -= l[i] * f;
  }
  const auto update = !kSmallCode && w.engine.kernel ? w.engine.kernel->column : plain_column;
  const int32_t row = update(w.rows - j, before, w.column(first) + j, w.lda, x + first, x + j);
  return row < 0 ? row : row + j;
}

// Factor columns first ... first+count-1, which have been updated by all columns before them, from row
// `first` down. Only these columns are touched.
int32_t factor_leaf(const Work& w, int32_t first, int32_t count, const Real* norms) {
  int32_t unusable = 0;
  const auto divide = !kSmallCode && w.engine.kernel ? w.engine.kernel->divide : plain_divide;
  for (int32_t j = first; j < first + count; ++j) {
    Real* column = w.column(j);
    const Real norm = norms[j - first];
    const int32_t row = finish_column(w, first, j);
    C2D_ASSERT(row < 0 || (row >= j && row < w.rows));
    const Real size = row < 0 ? Real(0) : (column[row] < 0 ? -column[row] : column[row]);
    const bool usable = size > norm * smallest_safe() && size >= std::numeric_limits<Real>::min();
    w.pivots[j] = usable ? row : j;
    if (!usable) {
      for (int32_t i = j; i < w.rows; ++i) column[i] = 0;
      note_unusable(w.stats->base + j, w.stats);
      ++unusable;
      continue;
    }
    exchange_rows(count, w.column(first), w.lda, j, row);
    divide(w.rows - j - 1, column[j], column + j + 1);
    note_pivot(w.engine, j, column, norm, w.stats);
  }
  return unusable;
}

// The same for a block: leaf after leaf, each updated by the leaves before it.
int32_t factor_block(const Work& w, int32_t first, int32_t count, const Real* norms) {
  int32_t unusable = 0;
  const int32_t end = first + count;
  for (int32_t leaf = first; leaf < end; leaf += kLeaf) {
    const int32_t n = smaller(kLeaf, end - leaf);
    update_by(w.engine, leaf - first, w.rows - leaf, n, w.column(first) + first, w.lda,
              w.column(leaf) + first, w.lda);
    unusable += factor_leaf(w, leaf, n, norms + (leaf - first));
    apply_pivots(leaf - first, w.column(first), w.lda, w.pivots, leaf, n);
    apply_pivots(end - leaf - n, w.column(leaf + n), w.lda, w.pivots, leaf, n);
  }
  return unusable;
}

} // namespace

void start_stats(PivotStats& stats) {
  stats = {0, 0, -1, -1, std::numeric_limits<double>::infinity(), 0, 0};
}

int32_t lu_block(const Engine& engine, int32_t rows, int32_t first, int32_t count, Real* a, int64_t lda,
                 int32_t* pivots, const Real* norms, PivotStats* stats) {
  Real own_norms[kLuBlock];
  Real* block = a + first * lda;
  for (int32_t j = 0; j < count; ++j)
    own_norms[j] = norms ? norms[first + j] : largest(engine, rows, block + j * lda);
  lu_apply(engine, rows, first, a, lda, pivots, count, block, lda);
  return factor_block({engine, rows, a, lda, pivots, stats}, first, count, own_norms);
}

void lu_settle(int32_t cols, Real* a, int64_t lda, const int32_t* pivots) {
  for (int32_t first = 0; first < cols; first += kLuBlock) {
    const int32_t end = smaller(first + kLuBlock, cols);
    apply_pivots(end - first, a + first * lda, lda, pivots, end, cols - end);
  }
}

void lu_apply(const Engine& engine, int32_t rows, int32_t cols, const Real* a, int64_t lda,
              const int32_t* pivots, int32_t count, Real* x, int64_t ldx) {
  for (int32_t first = 0; first < cols; first += kLuBlock) {
    const int32_t w = smaller(kLuBlock, cols - first);
    apply_pivots(count, x, ldx, pivots, first, w);
    update_by(engine, w, rows - first - w, count, a + first + first * lda, lda, x + first, ldx);
  }
}

int32_t lu_panel(const Engine& engine, int32_t rows, int32_t cols, Real* a, int64_t lda, int32_t* pivots,
                 const Real* norms, PivotStats* stats) {
  int32_t unusable = 0;
  for (int32_t first = 0; first < cols; first += kLuBlock)
    unusable += lu_block(engine, rows, first, smaller(kLuBlock, cols - first), a, lda, pivots, norms, stats);
  lu_settle(cols, a, lda, pivots);
  return unusable;
}

void apply_pivots(int32_t cols, Real* a, int64_t lda, const int32_t* pivots, int32_t first, int32_t count) {
  for (int32_t j = 0; j < cols; ++j) {
    Real* column = a + j * lda;
    for (int32_t i = first; i < first + count; ++i) {
      C2D_ASSERT(pivots[i] >= i);
      const Real kept = column[i];
      column[i] = column[pivots[i]];
      column[pivots[i]] = kept;
    }
  }
}

int32_t lu_factor(const Engine& engine, int32_t n, Real* a, int64_t lda, int32_t* pivots, PivotStats* stats) {
  PivotStats own;
  PivotStats* used = stats ? stats : &own;
  start_stats(*used);
  int32_t unusable = 0;
  for (int32_t first = 0; first < n; first += kLuBlock)
    unusable += lu_block(engine, n, first, smaller(kLuBlock, n - first), a, lda, pivots, nullptr, used);
  return unusable;
}

void lu_solve(const Engine& engine, int32_t n, int32_t nrhs, const Real* lu, int64_t lda,
              const int32_t* pivots, Real* b, int64_t ldb) {
  lu_apply(engine, n, n, lu, lda, pivots, nrhs, b, ldb);
  trsm_upper(engine, n, nrhs, lu, lda, b, ldb);
}

} // namespace c2d
