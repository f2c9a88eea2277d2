#pragma once
// Dense kernels: product, triangular solves, and what LU with partial pivoting needs. Matrices are column-major: entry (i, j)
// of A is a[i + j * lda], lda >= max(1, rows). Sizes may be 0. Arguments that are written must not overlap others. Nothing
// here traps: there is no division by zero, and no operation on anything but the given numbers. kPlainEngine is always allowed
// as the engine; another engine is faster and rounds differently.
#include "linalg/engine.hpp"
#include <stdint.h>

namespace c2d {

// C (m x n) -= A (m x k) B (k x n).
void gemm_minus(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                Real* c, int64_t ldc);
// C (m x n) -= A (m x k) B^T, B n x k.
void outer_minus(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                 Real* c, int64_t ldc);

// The update of an elimination: X = (X1, X2) of w + m rows and n columns := (L1^-1 X1, X2 - L2 L1^-1 X1) with L = (L1, L2)
// unit lower trapezoidal, (w + m) x w.
void update_by(const Engine& engine, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x, int64_t ldx);

// B (n x nrhs) := U^-1 B; U upper triangular: entries below its diagonal are not read. Where a diagonal entry is zero, the
// solution's entry is set to zero; the result is then no solution.
void trsm_upper(const Engine& engine, int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* b, int64_t ldb);

// Columns shared by several parts are cut into pieces, which run_items hands out from both ends: wide at the ends, narrower
// towards the middle, so that all parts finish at about the same time, but never too narrow to justify packing.
struct Piece {
  int32_t first, count;
};
int32_t pieces_of(int32_t columns, int32_t parts);
Piece piece_of(int32_t columns, int32_t parts, int32_t item);

// Largest absolute value of x[0 .. n); 0 if n = 0.
Real largest(const Engine& engine, int32_t n, const Real* x);
// Are all of x[0 .. n) finite?
bool all_finite(int32_t n, const Real* x);

} // namespace c2d
