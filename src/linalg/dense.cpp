// Dense products and triangular solves (METHOD 7.1): C -= A B, C -= A B^T, X := L^-1 X, B := U^-1 B.
//
// Three forms of each, of one result up to rounding:
// 1. Plain: portable loops over 4 x 4 tiles, for boards and as the reference.
// 2. Thin: one right-hand side, bound by memory. The kernel of the instruction set runs over whole columns of A.
// 3. Packed: many columns. Both factors are copied into slices without gaps (packed.cpp), and columns of C are shared by the
//    threads.
// All triangular solves are blocked: triangles of kTriangle, and everything beside them is a product. So nearly all operations
// run at the speed of the product.
// Literature: Golub and Van Loan, Matrix Computations, section 1.5 and 3.1; Goto and van de Geijn, ACM Trans. Math. Software
// 34 (2008) (tiles, packing, caches).
#include "linalg/dense.hpp"
#include "linalg/packed.hpp"
#include "memory/math.hpp"

namespace c2d {
namespace {

// A tile of C stays in registers during the inner loop: 4 x 4 numbers are 16 registers at worst and 8 with the shortest
// vectors in use. Loops over a tile have constant length, so that compilers turn them into vector instructions.
constexpr int32_t kTile = 4;
// A piece of A with kInner columns and kRows rows (128 KiB) stays in the second-level cache while B passes.
constexpr int32_t kInner = 64;
constexpr int32_t kRows = 256;
// Width of the diagonal blocks of the triangular solves, whose own operations do not use tiles.
constexpr int32_t kTriangle = 32;

int32_t smaller(int32_t a, int32_t b) { return a < b ? a : b; }

// One tile: each number of A and B that is loaded serves four products.
void tile_4x4(int32_t k, const Real* __restrict a, int64_t lda, const Real* __restrict b, int64_t ldb, Real* __restrict c,
              int64_t ldc) {
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

void tile_4x1(int32_t k, const Real* __restrict a, int64_t lda, const Real* __restrict b, Real* __restrict c) {
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
void gemm_piece(int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb, Real* c, int64_t ldc) {
  // Whole tiles first; the edges with narrower loops.
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

void plain_product(int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb, Real* c,
                   int64_t ldc) {
  for (int32_t p = 0; p < k; p += kInner) {
    for (int32_t i = 0; i < m; i += kRows) {
      gemm_piece(smaller(kRows, m - i), n, smaller(kInner, k - p), a + i + p * lda, lda, b + p, ldb, c + i, ldc);
    }
  }
}

// X := (L_1^-1 X_1, X_2 - L_2 L_1^-1 X_1): forward substitution in the triangle, then its columns are subtracted from all rows
// below.
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

// Backward substitution, from the last triangle upwards. A zero diagonal gives a zero, not a trap: the caller knows from the
// pivot statistics that the column is not usable.
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

// Packing costs one copy of each factor, so it pays only if several columns share it.
bool packs(const Engine& engine, int32_t n, int32_t k) { return !kSmallCode && n >= 4 && k >= 4 && can_pack(engine); }

// One column: a few columns of A at a time, so that x is loaded and stored once for all of them.
void thin_product(const Kernel& kernel, int32_t m, int32_t k, const Real* a, int64_t lda, const Real* b, Real* c) {
  for (int32_t p = 0; p < k; p += kTriangle) kernel.column(m, smaller(kTriangle, k - p), a + p * lda, lda, b + p, c);
}

// The same for a solve: triangles of kTriangle, and what is beyond them by whole columns of L or U.
void thin_update(const Kernel& kernel, int32_t w, int32_t m, const Real* l, int64_t ldl, Real* x) {
  for (int32_t d = 0; d < w; d += kTriangle) {
    const int32_t end = smaller(d + kTriangle, w);
    for (int32_t p = d; p < end; ++p) {
      const Real* left = l + p * ldl;
      for (int32_t i = p + 1; i < end; ++i) x[i] -= left[i] * x[p];
    }
    kernel.column(w + m - end, end - d, l + end + d * ldl, ldl, x + d, x + end);
  }
}

void thin_upper(const Kernel& kernel, int32_t n, const Real* u, int64_t ldu, Real* x) {
  for (int32_t end = n; end > 0;) {
    const int32_t d = (end - 1) / kTriangle * kTriangle;
    for (int32_t p = end - 1; p >= d; --p) {
      const Real* column = u + p * ldu;
      x[p] = column[p] == 0 ? Real(0) : x[p] / column[p];
      for (int32_t i = d; i < p; ++i) x[i] -= column[i] * x[p];
    }
    kernel.column(d, end - d, u + d * ldu, ldu, x + d, x);
    end = d;
  }
}

// Columns of X or C are cut between the workers: whole slices for any kernel, wide enough to justify packing A again in each.
constexpr int32_t kLeastCut = 32;

struct Columns {
  void (*work)(const Columns& all, const Engine& engine, int32_t first, int32_t count);
  int32_t n, m, k, parts;
  const Real *a, *b;
  int64_t lda, ldb;
  Real* c;
  int64_t ldc;
};

void take_columns(void* argument, const Engine& engine, int32_t item) {
  const Columns& all = *static_cast<const Columns*>(argument);
  const Piece piece = piece_of(all.n, all.parts, item);
  all.work(all, engine, piece.first, piece.count);
}

void cut_columns(const Engine& engine, Columns all) {
  all.parts = parts_of(engine);
  run_items(engine, pieces_of(all.n, all.parts), take_columns, &all);
}

} // namespace

// Width of the next piece: `parts` pieces take two thirds of the columns that are left. So pieces shrink geometrically, and
// all workers finish at about the same time.
static int32_t piece_width(int32_t left, int32_t parts) {
  if (parts <= 1) return left;
  const int32_t even = (left / 3 * 2 / parts + 7) / 8 * 8, most = even > kWidth ? kWidth : even;
  const int32_t width = most < kLeastCut ? kLeastCut : most;
  return left - width < kLeastCut ? left : width;
}

int32_t pieces_of(int32_t columns, int32_t parts) {
  int32_t pieces = 0;
  for (int32_t left = columns; left > 0; ++pieces) left -= piece_width(left, parts);
  return pieces;
}

Piece piece_of(int32_t columns, int32_t parts, int32_t item) {
  // Pieces are numbered from both ends, because run_items() hands them out from both ends.
  const int32_t pieces = pieces_of(columns, parts), last = pieces - 1 - item;
  const int32_t turn = item <= last ? 2 * item : 2 * last + 1; // from either end alternately
  int32_t first = 0, end = columns;
  for (int32_t i = 0; i < turn; ++i) {
    const int32_t width = piece_width(end - first, parts);
    i % 2 == 0 ? first += width : end -= width;
  }
  const int32_t width = piece_width(end - first, parts);
  return {turn % 2 == 0 ? first : end - width, width};
}

void gemm_minus(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                Real* c, int64_t ldc) {
  if (!packs(engine, n, k)) {
    if (kSmallCode || !engine.kernel) return plain_product(m, n, k, a, lda, b, ldb, c, ldc);
    for (int32_t j = 0; j < n; ++j) thin_product(*engine.kernel, m, k, a, lda, b + j * ldb, c + j * ldc);
    return;
  }
  cut_columns(engine, {[](const Columns& all, const Engine& own, int32_t j, int32_t count) {
                         packed_product(own, all.m, count, all.k, all.a, all.lda, all.b + j * all.ldb, all.ldb,
                                        all.c + j * all.ldc, all.ldc);
                       },
                       n, m, k, 1, a, b, lda, ldb, c, ldc});
}

void outer_minus(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                 Real* c, int64_t ldc) {
  if (!packs(engine, n, k)) {
    // B^T has its columns as rows: the factors are copied, since the kernels expect them one behind the other.
    Real factor[kTriangle];
    for (int32_t j = 0; j < n; ++j)
      for (int32_t d = 0; d < k; d += kTriangle) {
        const int32_t some = smaller(kTriangle, k - d);
        for (int32_t p = 0; p < some; ++p) factor[p] = b[j + (d + p) * ldb];
        gemm_minus(engine, m, 1, some, a + d * lda, lda, factor, some, c + j * ldc, ldc);
      }
    return;
  }
  cut_columns(engine, {[](const Columns& all, const Engine& own, int32_t j, int32_t count) {
                         packed_outer(own, all.m, count, all.k, all.a, all.lda, all.b + j, all.ldb, all.c + j * all.ldc,
                                      all.ldc);
                       },
                       n, m, k, 1, a, b, lda, ldb, c, ldc});
}

void update_by(const Engine& engine, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x, int64_t ldx) {
  if (packs(engine, n, w)) {
    cut_columns(engine, {[](const Columns& all, const Engine& own, int32_t j, int32_t count) {
                           packed_update(own, all.k, all.m, count, all.a, all.lda, all.c + j * all.ldc, all.ldc);
                         },
                         n, m, w, 1, l, nullptr, ldl, 0, x, ldx});
  } else if (!kSmallCode && engine.kernel) {
    for (int32_t j = 0; j < n; ++j) thin_update(*engine.kernel, w, m, l, ldl, x + j * ldx);
  } else {
    plain_update(w, m, n, l, ldl, x, ldx);
  }
}

void trsm_upper(const Engine& engine, int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* b, int64_t ldb) {
  if (packs(engine, nrhs, n)) {
    cut_columns(engine, {[](const Columns& all, const Engine& own, int32_t j, int32_t count) {
                           packed_upper(own, all.k, count, all.a, all.lda, all.c + j * all.ldc, all.ldc);
                         },
                         nrhs, 0, n, 1, u, nullptr, ldu, 0, b, ldb});
  } else if (!kSmallCode && engine.kernel) {
    for (int32_t j = 0; j < nrhs; ++j) thin_upper(*engine.kernel, n, u, ldu, b + j * ldb);
  } else {
    plain_upper(n, nrhs, u, ldu, b, ldb);
  }
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
  // No early exit: without a branch the loop becomes a vector loop, and the answer is nearly always yes.
  bool finite = true;
  for (int32_t i = 0; i < n; ++i) finite &= isfinite(x[i]) != 0;
  return finite;
}

} // namespace c2d
