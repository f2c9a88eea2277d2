// Matrix products and triangular solves with packed factors (METHOD 7.1).
//
// Loops, from the outside in, as in Goto and van de Geijn, ACM Trans. Math. Software 34 (2008):
// 1. Columns of B, up to kWidth, packed once: slices of as many columns as a tile has. They stay in the second-level cache.
// 2. Inner index, up to kDepth: bounds both packed factors.
// 3. Bands of rows of A, packed just before use: they stay near while all slices of B pass.
// 4. Tiles of C in registers (Kernel::tile).
// Packing makes every access of the inner loop contiguous, so the leading dimension does not matter.
// Triangular solves use the same loops: a triangle of kTriangle is solved in the packed slices, and the rows below it are a
// product.
#include "linalg/packed.hpp"

namespace c2d {
namespace {

// Triangles are solved in pieces of this width; the rows below each piece are left to the tiles.
constexpr int32_t kTriangle = 32;

int32_t smaller(int32_t a, int32_t b) { return a < b ? a : b; }

int32_t whole(int32_t n, int32_t step) { return (n + step - 1) / step * step; }

// Division of an engine's scratch memory: `depth` steps of the inner index, `slices` of a tile's rows of A, `width` columns of
// B.
struct Packing {
  const Kernel& kernel;
  Real *left, *right;
  int32_t depth, slices, width;
};

// The depth comes first, because the order of summation, hence the bits, depends on it. A quarter of the rest goes to A.
Packing packing(const Engine& engine, int32_t k, int32_t n) {
  const Kernel& kernel = *engine.kernel;
  const int64_t for_depth = engine.numbers / (kernel.rows + kernel.cols);
  const int32_t depth = smaller(smaller(k, kDepth), for_depth > kDepth ? kDepth : static_cast<int32_t>(for_depth));
  const int64_t each = engine.numbers / depth; // numbers per step of the inner index
  const int32_t band = kBand / kernel.rows;
  const int64_t some = each / 4 / kernel.rows;
  const int32_t slices = some < 1 ? 1 : (some > band ? band : static_cast<int32_t>(some));
  const int64_t rest = each - static_cast<int64_t>(slices) * kernel.rows;
  const int64_t most = static_cast<int64_t>(kDepth) * kWidth / depth; // a shallower slice may be wider
  const int32_t width = static_cast<int32_t>(rest > most ? most : rest) / kernel.cols * kernel.cols;
  const int32_t wide = smaller(width, whole(n, kernel.cols));
  const int64_t left = static_cast<int64_t>(depth) * slices * kernel.rows, used = left + static_cast<int64_t>(depth) * wide;
  if (engine.used && used > *engine.used) *engine.used = used;
  return {kernel, engine.scratch, engine.scratch + left, depth, slices, wide};
}

// Copies A (m x k, m <= rows of a tile) without gaps, with zeros below it: an incomplete tile then uses the same kernel.
void pack_left(const Packing& p, int32_t m, int32_t k, const Real* a, int64_t lda, Real* to) {
  if (m == p.kernel.rows) return p.kernel.pack(k, a, lda, to);
  for (int32_t j = 0; j < k; ++j, a += lda) {
    for (int32_t i = 0; i < m; ++i) to[i] = a[i];
    for (int32_t i = m; i < p.kernel.rows; ++i) to[i] = 0;
    to += p.kernel.rows;
  }
}

// What is packed on the right: slices of as many columns as a tile has, each row by row, `stride` numbers for each column.
struct Right {
  Real* slices;
  int64_t stride;
  Real* slice(int32_t j) const { return slices + j * stride; }
};

// B (k x n) to slices; zeros to the right of it.
void pack_right(const Packing& p, int32_t n, int32_t k, const Real* b, int64_t ldb, const Right& right) {
  const int32_t cols = p.kernel.cols;
  for (int32_t j = 0; j < n; j += cols) {
    const int32_t some = smaller(cols, n - j);
    Real* to = right.slice(j);
    if (some == cols) {
      p.kernel.to_rows(k, b + j * ldb, ldb, to);
      continue;
    }
    for (int32_t i = 0; i < k; ++i) {
      for (int32_t c = 0; c < cols; ++c) to[static_cast<int64_t>(i) * cols + c] = c < some ? b[i + (j + c) * ldb] : Real(0);
    }
  }
}

// The same for B^T (n x k). Each column is read in short pieces, so the next ones are prefetched.
void pack_transposed(const Packing& p, int32_t n, int32_t k, const Real* b, int64_t ldb, const Right& right) {
  const int32_t cols = p.kernel.cols;
  for (int32_t j = 0; j < n; j += cols) {
    const int32_t some = smaller(cols, n - j);
    Real* to = right.slice(j);
    for (int32_t i = 0; i < k; ++i, to += cols) {
      C2D_FETCH(b + j + 2 * cols + i * ldb, 0, 2);
      for (int32_t c = 0; c < some; ++c) to[c] = b[j + c + i * ldb];
      for (int32_t c = some; c < cols; ++c) to[c] = 0;
    }
  }
}

void unpack_right(const Packing& p, int32_t n, int32_t k, const Right& right, Real* b, int64_t ldb) {
  const int32_t cols = p.kernel.cols;
  for (int32_t j = 0; j < n; j += cols) {
    const int32_t some = smaller(cols, n - j);
    const Real* from = right.slice(j);
    if (some == cols) {
      p.kernel.from_rows(k, from, b + j * ldb, ldb);
      continue;
    }
    for (int32_t c = 0; c < some; ++c) {
      for (int32_t i = 0; i < k; ++i) b[i + (j + c) * ldb] = from[static_cast<int64_t>(i) * cols + c];
    }
  }
}

// A tile of m x n that is smaller than the kernel's: computed in a buffer, and only its part is added to C.
void edge(const Packing& p, int32_t m, int32_t n, int32_t k, const Real* left, const Real* right, Real* c, int64_t ldc) {
  Real buffer[kMostTileNumbers] = {};
  p.kernel.tile(k, left, p.kernel.rows, right, buffer, p.kernel.rows);
  for (int32_t j = 0; j < n; ++j) {
    for (int32_t i = 0; i < m; ++i) c[i + j * ldc] += buffer[i + j * p.kernel.rows];
  }
}

// Prefetches a column of the band that is packed next.
void ask_for(int32_t m, const Real* column) {
  for (int32_t i = 0; i < m; i += 64 / static_cast<int32_t>(sizeof(Real))) C2D_FETCH(column + i, 0, 2);
}

// C (m x n) -= A (m x k) times the packed right factor, for a few slices of A at a time: each column of C is accessed in
// longer pieces, and each slice of B serves all slices of A while it is in the cache.
void product(const Packing& p, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Right& right, Real* c,
             int64_t ldc) {
  const int32_t rows = p.kernel.rows, cols = p.kernel.cols, band = rows * p.slices;
  // For few columns packing costs more than it saves.
  const bool packed = n > 2 * cols || n % cols != 0;
  for (int32_t top = 0; top < m; top += band) {
    const int32_t end = smaller(top + band, m);
    for (int32_t i = top; i < end; i += rows) {
      if (packed || end - i < rows) pack_left(p, smaller(rows, end - i), k, a + i, lda, p.left + (i - top) * k);
    }
    const int32_t next = packed ? smaller(band, m - end) : 0;
    int32_t asked = 0;
    for (int32_t j = 0; j < n; j += cols) {
      // The next band of A is prefetched evenly while this one is used: its packing then does not wait for memory.
      for (const int64_t until = static_cast<int64_t>(j + cols) * k / n; asked < until && asked < k && next > 0; ++asked)
        ask_for(next, a + end + asked * lda);
      for (int32_t i = top; i < end; i += rows) {
        const Real* left = p.left + (i - top) * k;
        Real* at = c + i + j * ldc;
        if (end - i < rows || n - j < cols)
          edge(p, smaller(rows, end - i), smaller(cols, n - j), k, left, right.slice(j), at, ldc);
        else
          p.kernel.tile(k, packed ? left : a + i, packed ? rows : lda, right.slice(j), at, ldc);
      }
    }
  }
}

// X (w + m x n) for at most `depth` columns of L: solve a triangle in the packed slices, unpack it, and subtract its product
// from the rest of these w rows. The packed result then updates the m rows below in one product.
void update_once(const Packing& p, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x, int64_t ldx) {
  const int32_t cols = p.kernel.cols;
  for (int32_t d = 0; d < w; d += kTriangle) {
    const int32_t deep = smaller(kTriangle, w - d), below = d + deep;
    const Right part = {p.right + static_cast<int64_t>(d) * cols, w};
    pack_right(p, n, deep, x + d, ldx, part);
    for (int32_t j = 0; j < n; j += cols) p.kernel.solve(deep, l + d + d * ldl, ldl, part.slice(j));
    unpack_right(p, n, deep, part, x + d, ldx);
    product(p, w - below, n, deep, l + below + d * ldl, ldl, part, x + below, ldx);
  }
  product(p, m, n, w, l + w, ldl, {p.right, w}, x + w, ldx);
}

// X (w x n) := U^-1 X in the same way, from the last triangle upwards.
void upper_once(const Packing& p, int32_t w, int32_t n, const Real* u, int64_t ldu, Real* x, int64_t ldx) {
  const int32_t cols = p.kernel.cols;
  for (int32_t end = w; end > 0;) {
    const int32_t d = (end - 1) / kTriangle * kTriangle, deep = end - d;
    const Right part = {p.right + static_cast<int64_t>(d) * cols, w};
    pack_right(p, n, deep, x + d, ldx, part);
    for (int32_t j = 0; j < n; j += cols) p.kernel.solve_upper(deep, u + d + d * ldu, ldu, part.slice(j));
    unpack_right(p, n, deep, part, x + d, ldx);
    product(p, d, n, deep, u + d * ldu, ldu, part, x, ldx);
    end = d;
  }
}

} // namespace

bool can_pack(const Engine& engine) {
  return engine.kernel != nullptr && engine.numbers >= engine.kernel->rows + engine.kernel->cols;
}

void packed_product(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b,
                    int64_t ldb, Real* c, int64_t ldc) {
  const Packing p = packing(engine, k, n);
  for (int32_t j = 0; j < n; j += p.width) {
    const int32_t wide = smaller(p.width, n - j);
    for (int32_t d = 0; d < k; d += p.depth) {
      const int32_t deep = smaller(p.depth, k - d);
      const Right right = {p.right, deep};
      pack_right(p, wide, deep, b + d + j * ldb, ldb, right);
      product(p, m, wide, deep, a + d * lda, lda, right, c + j * ldc, ldc);
    }
  }
}

void packed_outer(const Engine& engine, int32_t m, int32_t n, int32_t k, const Real* a, int64_t lda, const Real* b, int64_t ldb,
                  Real* c, int64_t ldc) {
  const Packing p = packing(engine, k, n);
  for (int32_t j = 0; j < n; j += p.width) {
    const int32_t wide = smaller(p.width, n - j);
    for (int32_t d = 0; d < k; d += p.depth) {
      const int32_t deep = smaller(p.depth, k - d);
      const Right right = {p.right, deep};
      pack_transposed(p, wide, deep, b + j + d * ldb, ldb, right);
      product(p, m, wide, deep, a + d * lda, lda, right, c + j * ldc, ldc);
    }
  }
}

void packed_update(const Engine& engine, int32_t w, int32_t m, int32_t n, const Real* l, int64_t ldl, Real* x, int64_t ldx) {
  const Packing p = packing(engine, w, n);
  for (int32_t j = 0; j < n; j += p.width) {
    const int32_t wide = smaller(p.width, n - j);
    for (int32_t d = 0; d < w; d += p.depth) {
      const int32_t deep = smaller(p.depth, w - d);
      update_once(p, deep, w + m - d - deep, wide, l + d + d * ldl, ldl, x + d + j * ldx, ldx);
    }
  }
}

void packed_upper(const Engine& engine, int32_t n, int32_t nrhs, const Real* u, int64_t ldu, Real* x, int64_t ldx) {
  const Packing p = packing(engine, n, nrhs);
  for (int32_t j = 0; j < nrhs; j += p.width) {
    const int32_t wide = smaller(p.width, nrhs - j);
    for (int32_t end = n; end > 0;) {
      const int32_t deep = smaller(p.depth, end), d = end - deep;
      upper_once(p, deep, wide, u + d + d * ldu, ldu, x + d + j * ldx, ldx);
      product(p, d, wide, deep, u + d * ldu, ldu, {p.right, deep}, x + j * ldx, ldx);
      end = d;
    }
  }
}

} // namespace c2d
