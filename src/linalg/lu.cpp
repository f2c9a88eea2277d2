// LU factorisation with partial pivoting of tall panels, P A = L U (METHOD 7.1).
//
// Structure, from the outside in:
// 1. lu_step(): right-looking blocks of lu_width() columns. Each block updates everything to its right. The next block is
//    updated first and factored by one worker while the others update the rest (look-ahead).
// 2. factor_block(): a block in leaves of kLeaf columns. After each leaf, groups of 1, 2, 4 ... leaves update as many columns
//    behind them. These are the updates of the recursive algorithm, without recursion.
// 3. factor_leaf(): column by column, left-looking inside the leaf: update, find the largest entry, exchange rows, divide.
// A column whose largest remaining entry is negligible has no pivot. Its remaining entries become zero and the factorisation
// continues, so all such columns are reported at once.
// Literature: Golub and Van Loan, Matrix Computations, section 3.4 (partial pivoting); Toledo, SIAM J. Matrix Anal. Appl. 18
// (1997) (recursive blocking); Higham, Accuracy and Stability of Numerical Algorithms, chapter 9 (growth).
#include "linalg/lu.hpp"
#include "linalg/dense.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {
namespace {

// A number above this can be squared without underflow, and a quotient of two numbers up to its reciprocal does not overflow.
constexpr Real smallest_safe() { return sizeof(Real) == 8 ? static_cast<Real>(1.5e-154) : static_cast<Real>(1.1e-19); }

// A leaf is factored column by column: so few columns stay in the first-level cache.
constexpr int32_t kLeaf = 8;

int32_t smaller(int32_t a, int32_t b) { return a < b ? a : b; }

// x (m) -= L (m x k) u; returns the place of the largest entry, as Kernel::column. The search joins the update, because x is
// in the cache then.
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

void plain_scale(int32_t n, Real factor, Real* x) {
  for (int32_t i = 0; i < n; ++i) x[i] *= factor;
}

// Divides by multiplying with the reciprocal of the pivot, unless the reciprocal would be denormal. Quotients are at most 1.
void divide(const Engine& engine, int32_t n, Real pivot, Real* x) {
  const Real size = pivot < 0 ? -pivot : pivot;
  if (kSmallCode || size * kSmallestReal > Real(0.25)) {
    for (int32_t i = 0; i < n; ++i) x[i] /= pivot;
    return;
  }
  const auto scale = !kSmallCode && engine.kernel ? engine.kernel->scale : plain_scale;
  scale(n, 1 / pivot, x);
}

void note_unusable(int32_t column, PivotStats* stats) {
  stats->unusable += 1;
  if (stats->first_unusable < 0) stats->first_unusable = column;
}

// Statistics for METHOD 7.4. `column_of_u`: the j+1 entries of column j of U; the last one is the pivot.
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

using Work = Lu;

inline Real* column_of(const Work& w, int32_t j) { return w.a + j * w.lda; }

// Updates column j with the columns of its leaf from `first` on. Returns the row of its largest entry on and below the
// diagonal, or -1.
int32_t finish_column(const Work& w, int32_t first, int32_t j) {
  Real* x = column_of(w, j);
  const int32_t before = j - first;
  for (int32_t p = first; p < j; ++p) {
    const Real* l = column_of(w, p);
    const Real f = x[p];
    for (int32_t i = p + 1; i < j; ++i) x[i] -= l[i] * f;
  }
  const auto update = !kSmallCode && w.engine.kernel ? w.engine.kernel->column : plain_column;
  const int32_t row = update(w.rows - j, before, column_of(w, first) + j, w.lda, x + first, x + j);
  return row < 0 ? row : row + j;
}

// Factors columns first ... first+count-1, which all earlier columns have updated, from row `first` down. Touches only these
// columns: their row exchanges reach the others later, many at once.
int32_t factor_leaf(const Work& w, int32_t first, int32_t count, const Real* norms) {
  int32_t unusable = 0;
  for (int32_t j = first; j < first + count; ++j) {
    Real* column = column_of(w, j);
    const Real norm = norms[j - first];
    const int32_t row = finish_column(w, first, j);
    C2D_ASSERT(row < 0 || (row >= j && row < w.rows));
    const Real size = row < 0 ? Real(0) : (column[row] < 0 ? -column[row] : column[row]);
    // Relative to the column before elimination, so that the unit of a column does not matter.
    const bool usable = size > norm * smallest_safe() && size >= kSmallestReal;
    w.pivots[j] = usable ? row : j;
    if (!usable) {
      for (int32_t i = j; i < w.rows; ++i) column[i] = 0;
      note_unusable(w.stats->base + j, w.stats);
      ++unusable;
      continue;
    }
    exchange_rows(count, column_of(w, first), w.lda, j, row);
    divide(w.engine, w.rows - j - 1, column[j], column + j + 1);
    note_pivot(w.engine, j, column, norm, w.stats);
  }
  return unusable;
}

// A block. After every leaf, the largest power of two of leaves that ends there updates as many columns behind it. So each
// column is updated by a few, ever wider groups, and wide groups make the products fast.
int32_t factor_block(const Work& w, const Engine& engine, int32_t first, int32_t count) {
  int32_t unusable = 0;
  for (int32_t leaf = 0; leaf < count; leaf += kLeaf) {
    const int32_t at = first + leaf, n = smaller(kLeaf, count - leaf), end = leaf + n;
    unusable += factor_leaf(w, at, n, w.norms + at);
    apply_pivots(leaf, column_of(w, first), w.lda, w.pivots, at, n);
    apply_pivots(count - end, column_of(w, first + end), w.lda, w.pivots, at, n);
    // The lowest bit of `end` is the width of that group.
    const int32_t group = end & -end, from = first + end - group;
    update_by(engine, group, w.rows - first - end, smaller(group, count - end), column_of(w, from) + from, w.lda,
              column_of(w, first + end) + from, w.lda);
  }
  return unusable;
}

// Updates columns to the right of a block: row exchanges, then L^-1.
void update_right(const Work& w, const Engine& engine, int32_t first, int32_t width, int32_t from, int32_t count) {
  apply_pivots(count, column_of(w, from), w.lda, w.pivots, first, width);
  update_by(engine, width, w.rows - first - width, count, column_of(w, first) + first, w.lda, column_of(w, from) + first,
            w.lda);
}

// The next block is updated by all workers at once: number of pieces, and these. The last piece takes the remainder.
constexpr int32_t kLeastPiece = 16;
int32_t next_pieces(int32_t width, int32_t parts) {
  const int32_t most = width / kLeastPiece;
  return most < parts ? (most < 1 ? width > 0 : most) : parts;
}
Piece next_piece(int32_t width, int32_t pieces, int32_t item) {
  const int32_t each = width / pieces / 8 * 8, first = item * each;
  return {first, item + 1 < pieces ? each : width - first};
}

// One step. The items at both ends, which start first, update the next block. The worker that finishes the last of them
// factors that block while the others update the columns to its right: the factorisation of a block, which has little
// parallelism, is hidden.
struct Step {
  const Work& work;
  int32_t first, width, next, next_width; // the block that is factored, and the next one
  int32_t parts, pieces, beyond;          // pieces of the next block, and of the columns to its right
  int32_t left;                           // pieces of the next block that are not updated yet
  int32_t unusable;                       // of the next block
};

void take_part(void* argument, const Engine& engine, int32_t item) {
  Step& s = *static_cast<Step*>(argument);
  const int32_t front = (s.pieces + 1) / 2, right = s.next + s.next_width;
  if (item >= front && item < front + s.beyond) {
    const Piece piece = piece_of(s.work.cols - right, s.parts, item - front);
    return update_right(s.work, engine, s.first, s.width, right + piece.first, piece.count);
  }
  const Piece piece = next_piece(s.next_width, s.pieces, item < front ? item : item - s.beyond);
  update_right(s.work, engine, s.first, s.width, s.next + piece.first, piece.count);
  if (is_last(&s.left)) s.unusable = factor_block(s.work, engine, s.next, s.next_width);
}

// The largest entries of columns, by all workers.
struct Norms {
  int32_t rows, cols, parts;
  const Real* a;
  int64_t lda;
  Real* most;
};

void take_largest(void* argument, const Engine& engine, int32_t item) {
  const Norms& all = *static_cast<const Norms*>(argument);
  const Piece piece = piece_of(all.cols, all.parts, item);
  for (int32_t j = piece.first; j < piece.first + piece.count; ++j)
    all.most[j] = largest(engine, all.rows, all.a + j * all.lda);
}

void find_largest(const Engine& engine, int32_t rows, int32_t cols, const Real* a, int64_t lda, Real* most) {
  Norms all = {rows, cols, parts_of(engine), a, lda, most};
  run_items(engine, pieces_of(cols, all.parts), take_largest, &all);
}

int32_t at_least_none(int32_t n) { return n > 0 ? n : 0; }

} // namespace

// Wide blocks for large matrices: the product dominates. Narrow ones for small matrices: the block itself would dominate.
int32_t lu_width(int32_t rows) {
  if (kSmallCode) return 32;
  if (rows <= 640) return 32;
  return rows <= 1280 ? 128 : (rows <= 2400 ? 256 : kWidestLuBlock);
}

int32_t lu_step(const Lu& lu, int32_t first) {
  const int32_t most = lu_width(lu.rows), width = smaller(most, lu.own - first), next = first + width;
  int32_t unusable =
      first == 0 ? factor_block(lu, lu.engine, 0, width) : 0; // the first block has no predecessor that factors it
  if (kSmallCode) {
    if (next < lu.cols) update_right(lu, lu.engine, first, width, next, lu.cols - next);
    return next < lu.own ? unusable + factor_block(lu, lu.engine, next, smaller(most, lu.own - next)) : unusable;
  }
  const int32_t next_width = smaller(most, at_least_none(lu.own - next)), parts = parts_of(lu.engine);
  const int32_t pieces = next_pieces(next_width, parts), beyond = pieces_of(lu.cols - next - next_width, parts);
  Step step = {lu, first, width, next, next_width, parts, pieces, beyond, pieces, 0};
  run_items(lu.engine, pieces + beyond, take_part, &step);
  return unusable + step.unusable;
}

void start_stats(PivotStats& stats) { stats = {0, 0, -1, -1, static_cast<double>(INFINITY), 0, 0}; }

// A block of L was left with the rows as they were after its own factorisation. Later exchanges are applied now.
void lu_settle(int32_t rows, int32_t cols, Real* a, int64_t lda, const int32_t* pivots) {
  const int32_t width = lu_width(rows);
  for (int32_t first = 0; first < cols; first += width) {
    const int32_t end = smaller(first + width, cols);
    apply_pivots(end - first, a + first * lda, lda, pivots, end, cols - end);
  }
}

// X := L^-1 P X block by block, with the exchanges of each block just before its update, as during the factorisation.
void lu_apply(const Engine& engine, int32_t rows, int32_t cols, const Real* a, int64_t lda, const int32_t* pivots,
              int32_t count, Real* x, int64_t ldx) {
  const int32_t width = lu_width(rows);
  for (int32_t first = 0; first < cols; first += width) {
    const int32_t w = smaller(width, cols - first);
    apply_pivots(count, x, ldx, pivots, first, w);
    update_by(engine, w, rows - first - w, count, a + first + first * lda, lda, x + first, ldx);
  }
}

int32_t lu_panel(const Lu& lu) {
  int32_t unusable = 0;
  for (int32_t first = 0; first < lu.own; first += lu_width(lu.rows)) unusable += lu_step(lu, first);
  return unusable;
}

// Four columns at a time: the loads of one column overlap with those of the others. The rows of the next four columns are
// prefetched one by one, since the hardware cannot predict them. This halves the time of the exchanges.
void apply_pivots(int32_t cols, Real* a, int64_t lda, const int32_t* pivots, int32_t first, int32_t count) {
  int32_t j = 0;
  for (; !kSmallCode && j + 4 <= cols; j += 4) {
    Real *a0 = a + j * lda, *a1 = a0 + lda, *a2 = a1 + lda, *a3 = a2 + lda;
    const bool more = j + 8 <= cols;
    for (int32_t i = first; i < first + count; ++i) {
      const int32_t k = pivots[i];
      C2D_ASSERT(k >= i);
      for (int64_t next = 1; more && next <= 4; ++next) C2D_FETCH(a3 + next * lda + k, 1, 2);
      if (k == i) continue;
      const Real x0 = a0[i], x1 = a1[i], x2 = a2[i], x3 = a3[i];
      a0[i] = a0[k], a1[i] = a1[k], a2[i] = a2[k], a3[i] = a3[k];
      a0[k] = x0, a1[k] = x1, a2[k] = x2, a3[k] = x3;
    }
  }
  for (; j < cols; ++j) {
    Real* column = a + j * lda;
    for (int32_t i = first; i < first + count; ++i) {
      const Real kept = column[i];
      column[i] = column[pivots[i]];
      column[pivots[i]] = kept;
    }
  }
}

int32_t lu_factor(const Engine& engine, int32_t n, Real* a, int64_t lda, int32_t* pivots, Real* norms, PivotStats* stats) {
  PivotStats own;
  PivotStats* used = stats ? stats : &own;
  start_stats(*used);
  if (kSmallCode)
    for (int32_t j = 0; j < n; ++j) norms[j] = largest(engine, n, a + j * lda);
  else
    find_largest(engine, n, n, a, lda, norms);
  return lu_panel({engine, n, n, n, a, lda, pivots, norms, used});
}

void lu_solve(const Engine& engine, int32_t n, int32_t nrhs, const Real* lu, int64_t lda, const int32_t* pivots, Real* b,
              int64_t ldb) {
  lu_apply(engine, n, n, lu, lda, pivots, nrhs, b, ldb);
  trsm_upper(engine, n, nrhs, lu, lda, b, ldb);
}

} // namespace c2d
