#pragma once
// Products and triangular solves by a kernel. A right factor is packed once, in slices of as many columns as a tile has, and
// serves all rows below. The left factor is packed slice by slice, just before use.
#include "linalg/engine.hpp"

namespace c2d {

// Can this engine pack at all?
bool can_pack(const Engine& engine);

// C (m x n) -= A (m x k) B (k x n).
void packed_product(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b,
                    int64_t ldb, Real* c, int64_t ldc);
// C (m x n) -= A (m x k) B^T, B n x k.
void packed_outer(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                  Real* c, int64_t ldc);

// X = (X1, X2) of w + m rows and n columns := (L1^-1 X1, X2 - L2 L1^-1 X1); L = (L1, L2) is unit lower trapezoidal.
void packed_update(const Engine& engine, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x, int64_t ldx);

// X (n x nrhs) := U^-1 X; U upper triangular, zeros on its diagonal as in dense.hpp.
void packed_upper(const Engine& engine, int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* x, int64_t ldx);

} // namespace c2d
