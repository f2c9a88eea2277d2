#pragma once
// LU factors with partial pivoting, P A = L U, of tall panels. A square matrix is a panel with as many
// columns as rows; there is no other LU. Column-major as in dense.hpp.
#include "linalg/kernel.hpp"
#include <stdint.h>

namespace c2d {

// What the pivots say about the matrix. Ratios are of |pivot| over the largest entry of the pivot's column
// before elimination: they do not depend on the scale of columns. Columns are counted from `base`.
struct PivotStats {
  int32_t base;                         // set by the caller: the number of the panel's first column
  int32_t unusable;                     // how many columns had no usable pivot
  int32_t first_unusable;               // the first of them; -1: none
  int32_t smallest_column;              // where the smallest ratio is; -1: no column yet
  double smallest_ratio, largest_ratio; // over the columns with a usable pivot; infinity, 0 without one
  double growth; // largest entry of a column of U over the column's largest entry before
};
void start_stats(PivotStats& stats);

// Factor the panel A (rows x cols, rows >= cols) in place: L below the diagonal (its unit diagonal is not
// stored), U on and above it. pivots[j] is the row (from 0 in the panel) exchanged with row j at step j, j <=
// pivots[j] < rows. norms[j] is the largest entry of column j before any elimination; null: take it from the
// panel as given. `stats` is added to, not started anew. A column whose largest remaining entry is zero, or
// so far below its norm (sqrt of the smallest normal number) that arithmetic with it could overflow, has no
// usable pivot: its remaining entries are set to zero, no rows are exchanged, and the factoring goes on.
// Returns the number of such columns in this panel.
int32_t lu_panel(const Engine& engine, int32_t rows, int32_t cols, Real* a, int64_t lda, int32_t* pivots,
                 const Real* norms, PivotStats* stats);

// The steps of lu_panel, for callers who want to be asked between them. A panel is factored in blocks of
// kLuBlock columns, counted from its first. lu_block brings one block up to date with the blocks before it
// and factors it; it leaves the blocks before alone, so the rows of their L stay as they were when they were
// factored, until lu_settle puts all of them into the order of P. Blocks in order and lu_settle make up
// lu_panel.
constexpr int32_t kLuBlock = 128;
int32_t lu_block(const Engine& engine, int32_t rows, int32_t first, int32_t count, Real* a, int64_t lda,
                 int32_t* pivots, const Real* norms, PivotStats* stats);
void lu_settle(int32_t cols, Real* a, int64_t lda, const int32_t* pivots);

// X (rows x count) := L^-1 P X for the first `cols` columns of a factored panel that has not been settled:
// what elimination does to columns further right.
void lu_apply(const Engine& engine, int32_t rows, int32_t cols, const Real* a, int64_t lda,
              const int32_t* pivots, int32_t count, Real* x, int64_t ldx);

// Exchange rows i and pivots[i] of A (cols columns) for i = first ... first+count-1, in this order.
void apply_pivots(int32_t cols, Real* a, int64_t lda, const int32_t* pivots, int32_t first, int32_t count);

// P A = L U of a square matrix, not settled, for lu_solve; `stats` (may be null) is started anew.
int32_t lu_factor(const Engine& engine, int32_t n, Real* a, int64_t lda, int32_t* pivots, PivotStats* stats);
// B (n x nrhs) := A^-1 B by the factors of lu_factor. Meaningless, but harmless, if a pivot was not usable.
void lu_solve(const Engine& engine, int32_t n, int32_t nrhs, const Real* lu, int64_t lda,
              const int32_t* pivots, Real* b, int64_t ldb);

} // namespace c2d
