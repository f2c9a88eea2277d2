// The loops of one instruction set. One source file per set includes this one; it defines C2D_VECTOR_BYTES, C2D_TILE_VECTORS
// and C2D_TILE_COLUMNS and is compiled with that set's flags. Nothing in here may be visible to another file: a function merged
// by the linker would bring instructions to machines that lack them.
//
// A tile of C is C2D_TILE_VECTORS vectors high and C2D_TILE_COLUMNS wide and fills most registers. k steps cost k (vectors +
// columns) loads for k vectors columns multiplications and additions, fused where the set allows it.
#include "linalg/kernel.hpp"

namespace c2d {
namespace {

constexpr int32_t kLanes = C2D_VECTOR_BYTES / static_cast<int32_t>(sizeof(Real));
constexpr int32_t kVectors = C2D_TILE_VECTORS;
constexpr int32_t kCols = C2D_TILE_COLUMNS;
static_assert(kLanes * kVectors * kCols <= kMostTileNumbers, "a tile fits into the buffer for edges");

typedef Real Vector __attribute__((vector_size(C2D_VECTOR_BYTES)));
typedef Real Row __attribute__((vector_size(kCols * sizeof(Real)))); // one row of a packed right factor

// Vectors at any address of a number. Members of packed structs, because clang takes a reference to a type of lower alignment
// for one to the aligned type.
struct __attribute__((packed, may_alias)) LooseVector {
  Vector v;
};
struct __attribute__((packed, may_alias)) LooseRow {
  Row v;
};
inline const LooseVector* vector_at(const Real* x) { return reinterpret_cast<const LooseVector*>(x); }
inline LooseVector* vector_at(Real* x) { return reinterpret_cast<LooseVector*>(x); }
inline const LooseRow* row_at(const Real* x) { return reinterpret_cast<const LooseRow*>(x); }
inline LooseRow* row_at(Real* x) { return reinterpret_cast<LooseRow*>(x); }

// Prefetches the tile of C while its products are summed. Always inline: gcc finds that a function with nothing but prefetches
// has no effect, and drops its calls.
__attribute__((always_inline)) inline void ask_for(Real* c, int64_t ldc) {
  for (int32_t j = 0; j < kCols; ++j) {
#pragma GCC unroll 8
    for (int32_t i = 0; i < kVectors; i += 64 / C2D_VECTOR_BYTES) __builtin_prefetch(c + i * kLanes + j * ldc, 1);
  }
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define C2D_SHUFFLES
#endif
#endif
#if defined(C2D_SHUFFLES) && C2D_VECTOR_BYTES == 16 && C2D_TWO_IN_16_BYTES
static_assert(kLanes == 2, "C2D_REAL=float needs C2D_REAL_BYTES=4");
// Two numbers to a vector: a column times two numbers of a row at once gives the sums of entries (0, 0) and (1, 1) of a
// square, the reversed column those of (1, 0) and (0, 1). One exchange for each vector of A costs less than one
// broadcast for each number of B: 0.80 of the peak in place of 0.67. The sums are the same.
void tile(int32_t k, const Real* a, int64_t lda, const Real* b, Real* c, int64_t ldc) {
  Vector along[kCols / 2][kVectors] = {}, across[kCols / 2][kVectors] = {};
  ask_for(c, ldc);
  for (int32_t p = 0; p < k; ++p) {
#pragma GCC unroll 8
    for (int32_t i = 0; i < kVectors; ++i) {
      const Vector column = vector_at(a + i * kLanes)->v, turned = __builtin_shufflevector(column, column, 1, 0);
#pragma GCC unroll 8
      for (int32_t j = 0; j < kCols / 2; ++j) {
        along[j][i] += column * vector_at(b + 2 * j)->v;
        across[j][i] += turned * vector_at(b + 2 * j)->v;
      }
    }
    a += lda;
    b += kCols;
  }
#pragma GCC unroll 8
  for (int32_t j = 0; j < kCols / 2; ++j) {
#pragma GCC unroll 8
    for (int32_t i = 0; i < kVectors; ++i) {
      Real* at = c + i * kLanes + 2 * j * ldc;
      vector_at(at)->v -= __builtin_shufflevector(along[j][i], across[j][i], 0, 2);
      vector_at(at + ldc)->v -= __builtin_shufflevector(across[j][i], along[j][i], 1, 3);
    }
  }
}
#else
void tile(int32_t k, const Real* a, int64_t lda, const Real* b, Real* c, int64_t ldc) {
  Vector sum[kCols][kVectors] = {};
  ask_for(c, ldc);
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
#endif

// kSolved rows stay in registers: first all rows above are subtracted, then they are solved among themselves and stored once.
constexpr int32_t kSolved = C2D_VECTOR_BYTES == 16 ? 4 : 8;

void solve(int32_t n, const Real* l, int64_t ldl, Real* b) {
  int32_t i = 0;
  for (; i + kSolved <= n; i += kSolved) {
    Real* rows = b + static_cast<int64_t>(i) * kCols;
    Row y[kSolved];
#pragma GCC unroll 8
    for (int32_t r = 0; r < kSolved; ++r) y[r] = row_at(rows + r * kCols)->v;
    const Real* left = l + i;
    for (int32_t p = 0; p < i; ++p, left += ldl) {
      const Row x = row_at(b + static_cast<int64_t>(p) * kCols)->v;
#pragma GCC unroll 8
      for (int32_t r = 0; r < kSolved; ++r) y[r] -= x * left[r];
    }
#pragma GCC unroll 8
    for (int32_t p = 0; p < kSolved; ++p, left += ldl) {
#pragma GCC unroll 8
      for (int32_t r = p + 1; r < kSolved; ++r) y[r] -= y[p] * left[r];
    }
#pragma GCC unroll 8
    for (int32_t r = 0; r < kSolved; ++r) row_at(rows + r * kCols)->v = y[r];
  }
  for (; i < n; ++i) {
    LooseRow* row = row_at(b + static_cast<int64_t>(i) * kCols);
    Row y = row->v;
    for (int32_t p = 0; p < i; ++p) y -= row_at(b + static_cast<int64_t>(p) * kCols)->v * l[i + p * ldl];
    row->v = y;
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

inline Vector size_of(Vector x) { return x < 0 ? -x : x; } // (lanes)

inline Real most_of(const Vector& sizes) {
  Real most[kLanes];
  for (int32_t v = 0; v < kLanes; ++v) most[v] = sizes[v];
#pragma GCC unroll 4
  for (int32_t half = kLanes / 2; half > 0; half /= 2) {
#pragma GCC unroll 8
    for (int32_t v = 0; v < half; ++v) most[v] = most[v] > most[v + half] ? most[v] : most[v + half];
  }
  return most[0];
}

// The largest entry so far in each lane, and its place.
typedef decltype(Vector{} < Vector{}) Places;
struct Largest {
  Vector most = {};
  Places place = {};
  void meet(const Vector& x, const Places& at) {
    const Vector size = size_of(x);
    const Places more = size > most;
    most = more ? size : most; // (lanes)
    place = more ? at : place; // (lanes)
  }
  int32_t first() const {
    const Real whole = most_of(most);
    if (whole == 0) return -1;
    int32_t found = INT32_MAX;
    for (int32_t v = 0; v < kLanes; ++v) {
      if (most[v] == whole && place[v] < found) found = static_cast<int32_t>(place[v]);
    }
    return found;
  }
};

// kGroup vectors of x stay in registers while the columns of L pass: enough that additions need not wait for one another.
constexpr int32_t kGroup = 8;

template <int32_t vectors> inline void take_out(int32_t k, const Real* l, int64_t ldl, const Real* u, Vector* y) {
  for (int32_t p = 0; p < k; ++p, l += ldl) {
#pragma GCC unroll 8
    for (int32_t v = 0; v < vectors; ++v) y[v] -= vector_at(l + v * kLanes)->v * u[p];
  }
}

int32_t short_column(int32_t m, int32_t k, const Real* l, int64_t ldl, const Real* u, Real* x) {
  Real most = 0;
  int32_t row = -1;
  for (int32_t i = 0; i < m; ++i) {
    for (int32_t p = 0; p < k; ++p) x[i] -= l[i + p * ldl] * u[p];
    const Real size = x[i] < 0 ? -x[i] : x[i];
    row = size > most ? i : row;
    most = size > most ? size : most;
  }
  return row;
}

// The vectors in the middle are aligned. The first and the last vector may overlap with them, so these two are computed
// beforehand from the same numbers and stored afterwards.
int32_t column(int32_t m, int32_t k, const Real* l, int64_t ldl, const Real* u, Real* x) {
  if (m < kLanes) return short_column(m, k, l, ldl, u, x);
  if (k == 0) l = x; // never read, and may be null
  const int32_t past = static_cast<int32_t>(reinterpret_cast<uintptr_t>(x) % C2D_VECTOR_BYTES / sizeof(Real));
  const int32_t last = m - kLanes;
  Places lanes = {};
  for (int32_t v = 0; v < kLanes; ++v) lanes[v] = v;
  Vector head = vector_at(x)->v, tail = vector_at(x + last)->v;
  take_out<1>(k, l, ldl, u, &head);
  take_out<1>(k, l + last, ldl, u, &tail);
  Largest largest;
  largest.meet(head, lanes);
  int32_t i = past > 0 ? kLanes - past : 0;
  for (; i + kGroup * kLanes <= m; i += kGroup * kLanes) {
    Vector y[kGroup];
#pragma GCC unroll 8
    for (int32_t v = 0; v < kGroup; ++v) y[v] = vector_at(x + i + v * kLanes)->v;
    take_out<kGroup>(k, l + i, ldl, u, y);
#pragma GCC unroll 8
    for (int32_t v = 0; v < kGroup; ++v) {
      vector_at(x + i + v * kLanes)->v = y[v];
      largest.meet(y[v], lanes + (i + v * kLanes));
    }
  }
  for (; i + kLanes <= m; i += kLanes) {
    Vector y = vector_at(x + i)->v;
    take_out<1>(k, l + i, ldl, u, &y);
    vector_at(x + i)->v = y;
    largest.meet(y, lanes + i);
  }
  largest.meet(tail, lanes + last);
  vector_at(x)->v = head;
  vector_at(x + last)->v = tail;
  return largest.first();
}

void scale(int32_t n, Real factor, Real* x) {
  int32_t i = 0;
  for (; i + kLanes <= n; i += kLanes) vector_at(x + i)->v = vector_at(x + i)->v * factor;
  for (; i < n; ++i) x[i] *= factor;
}

void add(int32_t n, Real factor, const Real* x, Real* y) {
  int32_t i = 0;
  for (; i + 2 * kLanes <= n; i += 2 * kLanes) {
#pragma GCC unroll 2
    for (int32_t v = 0; v < 2; ++v) vector_at(y + i + v * kLanes)->v += factor * vector_at(x + i + v * kLanes)->v;
  }
  for (; i < n; ++i) y[i] += factor * x[i];
}

void add_two(int32_t n, Real f, const Real* x, Real g, const Real* z, Real* y) {
  int32_t i = 0;
  for (; i + 2 * kLanes <= n; i += 2 * kLanes) {
#pragma GCC unroll 2
    for (int32_t v = i; v < i + 2 * kLanes; v += kLanes)
      vector_at(y + v)->v = vector_at(y + v)->v + f * vector_at(x + v)->v + g * vector_at(z + v)->v;
  }
  for (; i < n; ++i) y[i] = y[i] + f * x[i] + g * z[i];
}

// The last vector may overlap with the one before it.
Real largest_entry(int32_t n, const Real* x) {
  if (n < kLanes) {
    Real most = 0;
    for (int32_t i = 0; i < n; ++i) most = x[i] > most ? x[i] : (-x[i] > most ? -x[i] : most);
    return most;
  }
  Vector most_each[2] = {size_of(vector_at(x + n - kLanes)->v), {}};
  for (int32_t i = 0; i + kLanes <= n; i += 2 * kLanes) {
    const Vector size = size_of(vector_at(x + i)->v);
    most_each[0] = size > most_each[0] ? size : most_each[0]; // (lanes)
    if (i + 2 * kLanes > n) break;
    const Vector next = size_of(vector_at(x + i + kLanes)->v);
    most_each[1] = next > most_each[1] ? next : most_each[1]; // (lanes)
  }
  return most_of(most_each[0] > most_each[1] ? most_each[0] : most_each[1]); // (lanes)
}

// The rows below, which the next slice needs, are prefetched.
void pack(int32_t k, const Real* a, int64_t lda, Real* to) {
  for (int32_t p = 0; p < k; ++p, a += lda, to += kVectors * kLanes) {
#pragma GCC unroll 8
    for (int32_t v = 0; v < kVectors; ++v) {
      __builtin_prefetch(a + (kVectors + v) * kLanes, 0, 2);
      vector_at(to + v * kLanes)->v = vector_at(a + v * kLanes)->v;
    }
  }
}

// Transposes a square of kCols rows in registers: the first half of its rows is interleaved with the second half, log2(kCols)
// times.
#ifdef C2D_SHUFFLES
inline void transpose(Row* x) {
  Row y[kCols];
#pragma GCC unroll 8
  for (int32_t half = 1; half < kCols; half *= 2) {
#pragma GCC unroll 8
    for (int32_t i = 0; i < kCols / 2; ++i) {
#if C2D_TILE_COLUMNS == 8
      y[2 * i] = __builtin_shufflevector(x[i], x[i + 4], 0, 8, 1, 9, 2, 10, 3, 11);
      y[2 * i + 1] = __builtin_shufflevector(x[i], x[i + 4], 4, 12, 5, 13, 6, 14, 7, 15);
#else
      y[2 * i] = __builtin_shufflevector(x[i], x[i + 2], 0, 4, 1, 5);
      y[2 * i + 1] = __builtin_shufflevector(x[i], x[i + 2], 2, 6, 3, 7);
#endif
    }
#pragma GCC unroll 8
    for (int32_t i = 0; i < kCols; ++i) x[i] = y[i];
  }
}
#endif

// Transposes as many whole squares as there are, from columns `across` apart with numbers `along` apart. Returns how many of
// the k numbers that were. A compiler without shuffles leaves all of them to the caller.
#ifdef C2D_SHUFFLES
inline int32_t turn_squares(int32_t k, const Real* from, int64_t across, Real* to, int64_t to_across, int64_t along,
                            int64_t to_along) {
  int32_t i = 0;
  for (; i + kCols <= k; i += kCols) {
    Row x[kCols];
#pragma GCC unroll 8
    for (int32_t j = 0; j < kCols; ++j) x[j] = row_at(from + i * along + j * across)->v;
    transpose(x);
#pragma GCC unroll 8
    for (int32_t j = 0; j < kCols; ++j) row_at(to + i * to_along + j * to_across)->v = x[j];
  }
  return i;
}
#else
inline int32_t turn_squares(int32_t, const Real*, int64_t, Real*, int64_t, int64_t, int64_t) { return 0; }
#endif

void to_rows(int32_t k, const Real* b, int64_t ldb, Real* to) {
  int32_t i = turn_squares(k, b, ldb, to, kCols, 1, kCols);
  for (; i < k; ++i) {
    for (int32_t j = 0; j < kCols; ++j) to[static_cast<int64_t>(i) * kCols + j] = b[i + j * ldb];
  }
}

void from_rows(int32_t k, const Real* from, Real* b, int64_t ldb) {
  int32_t i = turn_squares(k, from, kCols, b, ldb, kCols, 1);
  for (; i < k; ++i) {
    for (int32_t j = 0; j < kCols; ++j) b[i + j * ldb] = from[static_cast<int64_t>(i) * kCols + j];
  }
}

constexpr Kernel kLoops = {kVectors * kLanes, kCols, tile,    solve,     solve_upper, column, scale,
                           largest_entry,     pack,  to_rows, from_rows, add,         add_two};

} // namespace
} // namespace c2d
