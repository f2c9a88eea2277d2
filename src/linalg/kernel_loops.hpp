// The loops of one instruction set: included by one source file per set, which defines C2D_VECTOR_BYTES,
// C2D_TILE_VECTORS and C2D_TILE_COLUMNS and is compiled with that set's flags. Nothing in here may be seen by
// another file: a function shared by the linker would carry instructions into machines that lack them.
//
// A tile of C is C2D_TILE_VECTORS vectors high and C2D_TILE_COLUMNS wide and fills most registers: with k
// steps it costs k (vectors + columns) loads for k vectors columns multiplications and additions. Additions
// are fused where the set can.
#include "linalg/kernel.hpp"

namespace c2d {
namespace {

constexpr int32_t kLanes = C2D_VECTOR_BYTES / static_cast<int32_t>(sizeof(Real));
constexpr int32_t kVectors = C2D_TILE_VECTORS;
constexpr int32_t kCols = C2D_TILE_COLUMNS;
static_assert(kLanes * kVectors * kCols <= kMostTileNumbers, "a tile fits into the buffer for edges");

typedef Real Vector __attribute__((vector_size(C2D_VECTOR_BYTES)));
typedef Real Row __attribute__((vector_size(kCols * sizeof(Real)))); // one row of a packed right factor

// In memory they may lie anywhere a number may. Members of packed structs, because a reference to a type of lower
// alignment is taken by clang for one to the aligned type.
struct __attribute__((packed, may_alias)) LooseVector {
  Vector v;
};
struct __attribute__((packed, may_alias)) LooseRow {
  Row v;
};
inline const LooseVector* vector_at(const Real* x) {
  return reinterpret_cast<const LooseVector*>(x);
}
inline LooseVector* vector_at(Real* x) {
  return reinterpret_cast<LooseVector*>(x);
}
inline const LooseRow* row_at(const Real* x) {
  return reinterpret_cast<const LooseRow*>(x);
}
inline LooseRow* row_at(Real* x) {
  return reinterpret_cast<LooseRow*>(x);
}

void tile(int32_t k, const Real* a, int64_t lda, const Real* b, Real* c, int64_t ldc) {
  Vector sum[kCols][kVectors] = {};
  for (int32_t j = 0; j < kCols; ++j) __builtin_prefetch(c + j * ldc, 1);
  for (int32_t p = 0; p < k; ++p) {
    Vector column[kVectors];
#pragma GCC unroll 8
    for (int32_t i = 0; i < kVectors; ++i) column[i] = vector_at(a + i * kLanes)->v;
#pragma GCC unroll 8
    for (int32_t j = 0; j < kCols; ++j) {
#pragma GCC unroll 8
      for (int32_t i = 0; i < kVectors; ++i) sum[j][i] += column[i] * b[j];
    }
    a += lda;
    b += kCols;
  }
#pragma GCC unroll 8
  for (int32_t j = 0; j < kCols; ++j) {
#pragma GCC unroll 8
    for (int32_t i = 0; i < kVectors; ++i) vector_at(c + i * kLanes + j * ldc)->v -= sum[j][i];
  }
}

// Four rows are finished at a time and taken out of all rows below in one pass.
void solve(int32_t n, const Real* l, int64_t ldl, Real* b) {
  int32_t p = 0;
  for (; p + 4 <= n; p += 4) {
    const Real *l0 = l + p * ldl, *l1 = l0 + ldl, *l2 = l1 + ldl, *l3 = l2 + ldl;
    Real* x = b + static_cast<int64_t>(p) * kCols;
    const Row x0 = row_at(x)->v;
    const Row x1 = row_at(x + kCols)->v - x0 * l0[p + 1];
    const Row x2 = row_at(x + 2 * kCols)->v - x0 * l0[p + 2] - x1 * l1[p + 2];
    const Row x3 = row_at(x + 3 * kCols)->v - x0 * l0[p + 3] - x1 * l1[p + 3] - x2 * l2[p + 3];
    row_at(x + kCols)->v = x1;
    row_at(x + 2 * kCols)->v = x2;
    row_at(x + 3 * kCols)->v = x3;
    for (int32_t i = p + 4; i < n; ++i) {
      LooseRow* y = row_at(b + static_cast<int64_t>(i) * kCols);
      y->v = y->v - x0 * l0[i] - x1 * l1[i] - x2 * l2[i] - x3 * l3[i];
    }
  }
  for (; p < n; ++p) {
    const Row x = row_at(b + static_cast<int64_t>(p) * kCols)->v;
    for (int32_t i = p + 1; i < n; ++i) row_at(b + static_cast<int64_t>(i) * kCols)->v -= x * l[i + p * ldl];
  }
}

// The same from the last row up, for U with its diagonal.
void solve_upper(int32_t n, const Real* u, int64_t ldu, Real* b) {
  for (int32_t p = n - 1; p >= 0; --p) {
    const Real* at = u + p * ldu;
    LooseRow* row = row_at(b + static_cast<int64_t>(p) * kCols);
    Row x = {};
    if (at[p] != 0) x = row->v / at[p];
    row->v = x;
    for (int32_t i = 0; i < p; ++i) row_at(b + static_cast<int64_t>(i) * kCols)->v -= x * at[i];
  }
}

// kGroup vectors of x stay in registers while the columns of L pass by.
constexpr int32_t kGroup = 4;

inline Vector size_of(Vector x) {
  return x < 0 ? -x : x;
}

inline Real most_of(const Vector& sizes) {
  Real most = 0;
  for (int32_t v = 0; v < kLanes; ++v) most = sizes[v] > most ? sizes[v] : most;
  return most;
}

int32_t column(int32_t m, int32_t k, const Real* l, int64_t ldl, const Real* u, Real* x) {
  Vector most_each = {};
  int32_t i = 0;
  for (; i + kGroup * kLanes <= m; i += kGroup * kLanes) {
    Vector y[kGroup];
#pragma GCC unroll 4
    for (int32_t v = 0; v < kGroup; ++v) y[v] = vector_at(x + i + v * kLanes)->v;
    const Real* at = l + i;
    for (int32_t p = 0; p < k; ++p, at += ldl) {
#pragma GCC unroll 4
      for (int32_t v = 0; v < kGroup; ++v) y[v] -= vector_at(at + v * kLanes)->v * u[p];
    }
#pragma GCC unroll 4
    for (int32_t v = 0; v < kGroup; ++v) {
      vector_at(x + i + v * kLanes)->v = y[v];
      const Vector size = size_of(y[v]);
      most_each = size > most_each ? size : most_each;
    }
  }
  Real most = most_of(most_each);
  for (; i < m; ++i) {
    Real y = x[i];
    for (int32_t p = 0; p < k; ++p) y -= l[i + p * ldl] * u[p];
    x[i] = y;
    const Real size = y < 0 ? -y : y;
    most = size > most ? size : most;
  }
  if (most == 0) return -1;
  for (i = 0; i < m && x[i] != most && -x[i] != most;) ++i;
  return i;
}

void divide(int32_t n, Real pivot, Real* x) {
  int32_t i = 0;
  for (; i + kLanes <= n; i += kLanes) vector_at(x + i)->v = vector_at(x + i)->v / pivot;
  for (; i < n; ++i) x[i] /= pivot;
}

Real largest_entry(int32_t n, const Real* x) {
  Vector most_each[2] = {};
  int32_t i = 0;
  for (; i + 2 * kLanes <= n; i += 2 * kLanes) {
#pragma GCC unroll 2
    for (int32_t v = 0; v < 2; ++v) {
      const Vector size = size_of(vector_at(x + i + v * kLanes)->v);
      most_each[v] = size > most_each[v] ? size : most_each[v];
    }
  }
  Real most = most_of(most_each[0] > most_each[1] ? most_each[0] : most_each[1]);
  for (; i < n; ++i) {
    const Real size = x[i] < 0 ? -x[i] : x[i];
    most = size > most ? size : most;
  }
  return most;
}

void pack(int32_t k, const Real* a, int64_t lda, Real* to) {
  for (int32_t p = 0; p < k; ++p, a += lda, to += kVectors * kLanes) {
    __builtin_prefetch(a + 4 * lda);
#pragma GCC unroll 8
    for (int32_t v = 0; v < kVectors; ++v) vector_at(to + v * kLanes)->v = vector_at(a + v * kLanes)->v;
  }
}

constexpr Kernel kLoops = {kVectors * kLanes, kCols, tile, solve, solve_upper, column, divide,
                           largest_entry,     pack};

} // namespace
} // namespace c2d
