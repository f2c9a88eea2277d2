#include "linalg/dense.hpp"
#include "linalg/packed.hpp"
#include <math.h>

namespace c2d {
namespace {

// A tile of C is kept in registers while the inner index runs: 4 x 4 numbers are 16 registers at worst and 8
// with the shortest vectors in use. Loops over a tile have constant length so that compilers turn them into
// vectors.
constexpr int32_t kTile = 4;
// A piece of A of kInner columns and kRows rows (128 KiB) stays in the second-level cache while B passes by.
constexpr int32_t kInner = 64;
constexpr int32_t kRows = 256;
// Width of the diagonal blocks of the triangular solves, whose own work is not done by tiles.
constexpr int32_t kTriangle = 32;

int32_t smaller(int32_t a, int32_t b) {
  return a < b ? a : b;
}

void tile_4x4(int32_t k, const Real* __restrict a, int64_t lda, const Real* __restrict b, int64_t ldb,
              Real* __restrict c, int64_t ldc) {
  Real s0[kTile] = {}, s1[kTile] = {}, s2[kTile] = {}, s3[kTile] = {};
  const Real *b0 = b, *b1 = b + ldb, *b2 = b + 2 * ldb, *b3 = b + 3 * ldb;
  for (int32_t p = 0; p < k; ++p, a += lda) {
    const Real f0 = b0[p], f1 = b1[p], f2 = b2[p], f3 = b3[p];
    for (int32_t i = 0; i < kTile; ++i) {
      s0[i] += a[i] * f0;
      s1[i] += a[i] * f1;
      s2[i] += a[i] * f2;
      s3[i] += a[i] * f3;
    }
  }
  for (int32_t i = 0; i < kTile; ++i) {
    c[i] -= s0[i];
    c[i + ldc] -= s1[i];
    c[i + 2 * ldc] -= s2[i];
    c[i + 3 * ldc] -= s3[i];
  }
}

void tile_4x1(int32_t k, const Real* __restrict a, int64_t lda, const Real* __restrict b,
              Real* __restrict c) {
  Real s[kTile] = {};
  for (int32_t p = 0; p < k; ++p, a += lda) {
    const Real f = b[p];
    for (int32_t i = 0; i < kTile; ++i) s[i] += a[i] * f;
  }
  for (int32_t i = 0; i < kTile; ++i) c[i] -= s[i];
}

void single(int32_t k, const Real* a, int64_t lda, const Real* b, Real* c) {
  Real s = 0;
  for (int32_t p = 0; p < k; ++p) s += a[p * lda] * b[p];
  *c -= s;
}

// The product for one cached piece of A: m <= kRows, k <= kInner.
void gemm_piece(int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                Real* c, int64_t ldc) {
  const int32_t m4 = m - m % kTile, n4 = n - n % kTile;
  for (int32_t j = 0; j < n4; j += kTile) {
    for (int32_t i = 0; i < m4; i += kTile) tile_4x4(k, a + i, lda, b + j * ldb, ldb, c + i + j * ldc, ldc);
  }
  for (int32_t j = n4; j < n; ++j) {
    for (int32_t i = 0; i < m4; i += kTile) tile_4x1(k, a + i, lda, b + j * ldb, c + i + j * ldc);
  }
  for (int32_t j = 0; j < n; ++j) {
    for (int32_t i = m4; i < m; ++i) single(k, a + i, lda, b + j * ldb, c + i + j * ldc);
  }
}

void plain_product(int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                   Real* c, int64_t ldc) {
  for (int32_t p = 0; p < k; p += kInner) {
    for (int32_t i = 0; i < m; i += kRows) {
      gemm_piece(smaller(kRows, m - i), n, smaller(kInner, k - p), a + i + p * lda, lda, b + p, ldb, c + i,
                 ldc);
    }
  }
}

void plain_update(int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x, int64_t ldx) {
  for (int32_t d = 0; d < w; d += kTriangle) {
    const int32_t end = smaller(d + kTriangle, w);
    for (int32_t j = 0; j < n; ++j) {
      Real* column = x + j * ldx;
      for (int32_t p = d; p < end; ++p) {
        const Real f = column[p];
        const Real* left = l + p * ldl;
        for (int32_t i = p + 1; i < end; ++i) column[i] -= left[i] * f;
      }
    }
    plain_product(w + m - end, n, end - d, l + end + d * ldl, ldl, x + d, ldx, x + end, ldx);
  }
}

void plain_upper(int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* b, int64_t ldb) {
  for (int32_t end = n; end > 0;) {
    const int32_t d = (end - 1) / kTriangle * kTriangle;
    for (int32_t j = 0; j < nrhs; ++j) {
      Real* x = b + j * ldb;
      for (int32_t p = end - 1; p >= d; --p) {
        const Real* column = u + p * ldu;
        x[p] = column[p] == 0 ? Real(0) : x[p] / column[p];
        const Real f = x[p];
        for (int32_t i = d; i < p; ++i) x[i] -= column[i] * f;
      }
    }
    plain_product(d, nrhs, end - d, u + d * ldu, ldu, b + d, ldb, b, ldb);
    end = d;
  }
}

// Packing pays when enough columns share it.
bool packs(const Engine& engine, int32_t n, int32_t k) {
  return !kSmallCode && n >= 4 && k >= 4 && can_pack(engine);
}

} // namespace

void gemm_minus(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda,
                const Real* b, int64_t ldb, Real* c, int64_t ldc) {
  if (packs(engine, n, k))
    packed_product(engine, m, n, k, a, lda, b, ldb, c, ldc);
  else
    plain_product(m, n, k, a, lda, b, ldb, c, ldc);
}

void update_by(const Engine& engine, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x,
               int64_t ldx) {
  if (packs(engine, n, w))
    packed_update(engine, w, m, n, l, ldl, x, ldx);
  else
    plain_update(w, m, n, l, ldl, x, ldx);
}

void trsm_lower_unit(const Engine& engine, int32_t n, int32_t nrhs, const Real* l, int64_t ldl, Real* b,
                     int64_t ldb) {
  update_by(engine, n, 0, nrhs, l, ldl, b, ldb);
}

void trsm_upper(const Engine& engine, int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* b,
                int64_t ldb) {
  if (packs(engine, nrhs, n))
    packed_upper(engine, n, nrhs, u, ldu, b, ldb);
  else
    plain_upper(n, nrhs, u, ldu, b, ldb);
}

Real largest(const Engine& engine, int32_t n, const Real* x) {
  if (!kSmallCode && engine.kernel) return engine.kernel->largest(n, x);
  Real most = 0;
  for (int32_t i = 0; i < n; ++i) {
    const Real size = x[i] < 0 ? -x[i] : x[i];
    most = size > most ? size : most;
  }
  return most;
}

bool all_finite(int32_t n, const Real* x) {
  bool finite = true;
  for (int32_t i = 0; i < n; ++i) finite &= isfinite(x[i]) != 0;
  return finite;
}

} // namespace c2d
