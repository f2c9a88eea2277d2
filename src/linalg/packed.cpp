#include "linalg/packed.hpp"

namespace c2d {
namespace {

// A slice of A (rows of a tile x kDepth) stays in the first-level cache, a packed right factor of kDepth x
// kWidth (512 KiB) in the second-level cache.
constexpr int32_t kDepth = 128;
constexpr int32_t kWidth = 512;

int32_t smaller(int32_t a, int32_t b) {
  return a < b ? a : b;
}

int32_t whole(int32_t n, int32_t step) {
  return (n + step - 1) / step * step;
}

// How an engine's scratch is divided: `depth` steps of the inner index and `width` columns at a time.
struct Packing {
  const Kernel& kernel;
  Real *left, *right;
  int32_t depth, width;
};

Packing packing(const Engine& engine, int32_t k, int32_t n) {
  const Kernel& kernel = *engine.kernel;
  const int64_t for_depth = engine.numbers / (kernel.rows + kernel.cols);
  const int32_t depth =
      smaller(smaller(k, kDepth), for_depth > kDepth ? kDepth : static_cast<int32_t>(for_depth));
  const int64_t for_width = engine.numbers / (depth > 0 ? depth : 1) - kernel.rows;
  const int32_t width =
      for_width > kWidth ? kWidth : static_cast<int32_t>(for_width) / kernel.cols * kernel.cols;
  const int32_t wide = smaller(width, whole(n, kernel.cols));
  const int64_t used = static_cast<int64_t>(depth) * (kernel.rows + wide);
  if (engine.used && used > *engine.used) *engine.used = used;
  return {kernel, engine.scratch, engine.scratch + static_cast<int64_t>(depth) * kernel.rows, depth, wide};
}

// A (m x k, m <= rows of a tile) without gaps, zeros below it.
void pack_left(const Packing& p, int32_t m, int32_t k, const Real* a, int64_t lda) {
  if (m == p.kernel.rows) return p.kernel.pack(k, a, lda, p.left);
  Real* to = p.left;
  for (int32_t j = 0; j < k; ++j, a += lda) {
    for (int32_t i = 0; i < m; ++i) to[i] = a[i];
    for (int32_t i = m; i < p.kernel.rows; ++i) to[i] = 0;
    to += p.kernel.rows;
  }
}

// B (k x n) in slices of a tile's columns, each row by row; zeros to the right of it.
void pack_right(const Packing& p, int32_t n, int32_t k, const Real* b, int64_t ldb) {
  const int32_t cols = p.kernel.cols;
  for (int32_t j = 0; j < whole(n, cols); ++j) {
    Real* to = p.right + static_cast<int64_t>(j / cols * cols) * k + j % cols;
    const Real* column = b + j * ldb;
    for (int32_t i = 0; i < k; ++i) to[static_cast<int64_t>(i) * cols] = j < n ? column[i] : Real(0);
  }
}

void unpack_right(const Packing& p, int32_t n, int32_t k, Real* b, int64_t ldb) {
  const int32_t cols = p.kernel.cols;
  for (int32_t j = 0; j < n; ++j) {
    const Real* from = p.right + static_cast<int64_t>(j / cols * cols) * k + j % cols;
    Real* column = b + j * ldb;
    for (int32_t i = 0; i < k; ++i) column[i] = from[static_cast<int64_t>(i) * cols];
  }
}

// A tile of m x n that may be smaller than the kernel's.
void edge(const Packing& p, int32_t m, int32_t n, int32_t k, const Real* right, Real* c, int64_t ldc) {
  Real buffer[kMostTileNumbers] = {};
  p.kernel.tile(k, p.left, p.kernel.rows, right, buffer, p.kernel.rows);
  for (int32_t j = 0; j < n; ++j) {
    for (int32_t i = 0; i < m; ++i) c[i + j * ldc] += buffer[i + j * p.kernel.rows];
  }
}

// C (m x n) -= A (m x k) times what is packed on the right.
void product(const Packing& p, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, Real* c,
             int64_t ldc) {
  const int32_t rows = p.kernel.rows, cols = p.kernel.cols;
  for (int32_t i = 0; i < m; i += rows) {
    const int32_t high = smaller(rows, m - i);
    // For few columns packing costs more than it saves.
    const bool packed = n > 2 * cols || high < rows || n % cols != 0;
    if (packed) pack_left(p, high, k, a + i, lda);
    for (int32_t j = 0; j < n; j += cols) {
      const Real* right = p.right + static_cast<int64_t>(j) * k;
      Real* at = c + i + j * ldc;
      if (high < rows || n - j < cols)
        edge(p, high, smaller(cols, n - j), k, right, at, ldc);
      else
        p.kernel.tile(k, packed ? p.left : a + i, packed ? rows : lda, right, at, ldc);
    }
  }
}

} // namespace

int64_t engine_numbers(const Kernel* kernel, int32_t k, int32_t n) {
  const int32_t depth = smaller(k, kDepth), width = smaller(whole(n, kernel->cols), kWidth);
  return static_cast<int64_t>(depth) * (kernel->rows + width);
}

bool can_pack(const Engine& engine) {
  return engine.kernel != nullptr && engine.numbers >= engine.kernel->rows + engine.kernel->cols;
}

void packed_product(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda,
                    const Real* b, int64_t ldb, Real* c, int64_t ldc) {
  const Packing p = packing(engine, k, n);
  for (int32_t j = 0; j < n; j += p.width) {
    const int32_t wide = smaller(p.width, n - j);
    for (int32_t d = 0; d < k; d += p.depth) {
      const int32_t deep = smaller(p.depth, k - d);
      pack_right(p, wide, deep, b + d + j * ldb, ldb);
      product(p, m, wide, deep, a + d * lda, lda, c + j * ldc, ldc);
    }
  }
}

void packed_update(const Engine& engine, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x,
                   int64_t ldx) {
  const Packing p = packing(engine, w, n);
  for (int32_t j = 0; j < n; j += p.width) {
    const int32_t wide = smaller(p.width, n - j);
    for (int32_t d = 0; d < w; d += p.depth) {
      const int32_t deep = smaller(p.depth, w - d), below = d + deep;
      Real* top = x + d + j * ldx;
      pack_right(p, wide, deep, top, ldx);
      for (int32_t s = 0; s < wide; s += p.kernel.cols)
        p.kernel.solve(deep, l + d + d * ldl, ldl, p.right + static_cast<int64_t>(s) * deep);
      unpack_right(p, wide, deep, top, ldx);
      product(p, w + m - below, wide, deep, l + below + d * ldl, ldl, x + below + j * ldx, ldx);
    }
  }
}

void packed_upper(const Engine& engine, int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* x,
                  int64_t ldx) {
  const Packing p = packing(engine, n, nrhs);
  for (int32_t j = 0; j < nrhs; j += p.width) {
    const int32_t wide = smaller(p.width, nrhs - j);
    for (int32_t end = n; end > 0;) {
      const int32_t deep = smaller(p.depth, end), d = end - deep;
      pack_right(p, wide, deep, x + d + j * ldx, ldx);
      for (int32_t s = 0; s < wide; s += p.kernel.cols)
        p.kernel.solve_upper(deep, u + d + d * ldu, ldu, p.right + static_cast<int64_t>(s) * deep);
      unpack_right(p, wide, deep, x + d + j * ldx, ldx);
      product(p, d, wide, deep, u + d * ldu, ldu, x + j * ldx, ldx);
      end = d;
    }
  }
}

} // namespace c2d
