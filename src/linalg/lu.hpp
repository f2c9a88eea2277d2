#pragma once
// LU factors with partial pivoting, P A = L U, of tall panels. A square matrix is a panel with as many
// columns as rows; there is no other LU. Column-major as in dense.hpp.
#include "linalg/engine.hpp"
#include <stdint.h>

namespace c2d {

// Pivot statistics. Ratios are of |pivot| over the largest entry of the pivot's column before elimination: they do not depend
// on the scale of columns. Columns are counted from `base`.
struct PivotStats {
  int32_t base;                         // set by the caller: the number of the panel's first column
  int32_t unusable;                     // number of columns without a usable pivot
  int32_t first_unusable;               // the first of them; -1: none
  int32_t smallest_column;              // where the smallest ratio is; -1: no column yet
  double smallest_ratio, largest_ratio; // over the columns with a usable pivot; infinity, 0 without one
  double growth;                        // largest entry of a column of U over the column's largest entry before
};
void start_stats(PivotStats& stats);

// The panel A, rows x cols, of which the first `own` <= rows columns are factored in place: L below the diagonal (its unit
// diagonal is not stored), U on and above it. The other columns are updated to L^-1 P times their old values. pivots[j] is the
// row (from 0 in the panel) exchanged with row j at step j, j <= pivots[j] < rows. norms[j] is the largest entry of column j
// before any elimination. `stats` is added to, not started anew. A column whose largest remaining entry is zero, or so far
// below its norm (sqrt of the smallest normal number) that arithmetic with it could overflow, has no usable pivot: its
// remaining entries are set to zero, no rows are exchanged, and the factoring goes on.
struct Lu {
  const Engine& engine;
  int32_t rows, own, cols;
  Real* a;
  int64_t lda;
  int32_t* pivots;   // own
  const Real* norms; // own
  PivotStats* stats;
};

// Columns are factored in blocks of lu_width(rows), counted from the first. Blocks must be wide enough to fill the tiles and
// narrow enough that a block alone, which tiles help less, is a small part of the whole. lu_step(lu, first), for first = 0,
// lu_width, 2 lu_width ... below `own`, in this order: all columns to the right of the block at `first` are updated by it, and
// the block after it is factored at the same time. Returns the number of columns found without a usable pivot. A factored block
// of L keeps the row order that it had then, until lu_settle puts all blocks into the order of P.
constexpr int32_t kWidestLuBlock = 384;
int32_t lu_width(int32_t rows);
int32_t lu_step(const Lu& lu, int32_t first);
// All steps.
int32_t lu_panel(const Lu& lu);
void lu_settle(int32_t rows, int32_t cols, Real* a, int64_t lda, const int32_t* pivots);

// X (rows x count) := L^-1 P X for the first `cols` columns of a factored panel that has not been settled: the effect of the
// elimination on columns further right.
void lu_apply(const Engine& engine, int32_t rows, int32_t cols, const Real* a, int64_t lda, const int32_t* pivots,
              int32_t count, Real* x, int64_t ldx);

// Exchange rows i and pivots[i] of A (cols columns) for i = first ... first+count-1, in this order.
void apply_pivots(int32_t cols, Real* a, int64_t lda, const int32_t* pivots, int32_t first, int32_t count);

// P A = L U of a square matrix, not settled, for lu_solve. norms: room for n numbers, the columns' largest entries
// afterwards. `stats` (may be null) is started anew. Returns the number of columns without a usable pivot.
int32_t lu_factor(const Engine& engine, int32_t n, Real* a, int64_t lda, int32_t* pivots, Real* norms, PivotStats* stats);
// B (n x nrhs) := A^-1 B by the factors of lu_factor. Meaningless, but harmless, if a pivot was not usable.
void lu_solve(const Engine& engine, int32_t n, int32_t nrhs, const Real* lu, int64_t lda, const int32_t* pivots, Real* b,
              int64_t ldb);

} // namespace c2d
