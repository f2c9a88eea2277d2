#include "contact/reduction/orthonormal.hpp"

#include "linalg/dense.hpp"
#include "memory/math.hpp"

namespace c2d {

double product(const Real* a, const Real* b, int32_t n) {
  double sum = 0.0;
  for (int32_t i = 0; i < n; ++i) sum += static_cast<double>(a[i]) * b[i];
  return sum;
}

void subtract(int32_t n, Real* from, double part, const Real* what) {
  for (int32_t i = 0; i < n; ++i) from[i] -= static_cast<Real>(part * static_cast<double>(what[i]));
}

namespace {

constexpr double kNoDirection = sizeof(Real) == 8 ? 1e-12 : 1e-5;

void divide(int32_t n, Real* v, double by) {
  for (int32_t i = 0; i < n; ++i) v[i] = static_cast<Real>(static_cast<double>(v[i]) / by);
}

} // namespace

bool orthonormalise(int32_t n, int32_t count, Real* x, int32_t rows, Real* y) {
  bool sound = true;
  for (int64_t j = 0; j < count; ++j) {
    Real* v = x + j * n;
    const double before = sqrt(product(v, v, n));
    for (int pass = 0; pass < 2; ++pass) {
      for (int64_t k = 0; k < j; ++k) {
        const double part = product(x + k * n, v, n);
        subtract(n, v, part, x + k * n);
        if (y) subtract(rows, y + j * rows, part, y + k * rows);
      }
      const double size = sqrt(product(v, v, n));
      if (!(size > kNoDirection * before)) sound = false;
      if (size > 0.0) divide(n, v, size);
      if (size > 0.0 && y) divide(rows, y + j * rows, size);
    }
  }
  return sound;
}

namespace {

// Vectors that are made orthogonal to all before them at once: with kAtOnce (n + 2 count) <= n n numbers of scratch.
constexpr int32_t kAtOnce = 16;
bool has_blocks(int32_t n, int32_t count) { return !kSmallCode && count > kAtOnce && n >= 3 * kAtOnce; }

void transpose(int32_t rows, int32_t columns, Real factor, const Real* x, Real* out) {
  for (int64_t j = 0; j < columns; ++j)
    for (int64_t i = 0; i < rows; ++i) out[i * columns + j] = factor * x[j * rows + i];
}

struct Vectors {
  const Engine& engine;
  int32_t n, rows;
  Real *x, *y, *scratch;
};

// x[first ... first + count) made orthogonal to those before them, once. False if nothing is left of one.
bool project(const Vectors& v, int32_t first, int32_t count) {
  Real *x = v.x + static_cast<int64_t>(first) * v.n, *across = v.scratch, *parts = across + static_cast<int64_t>(count) * v.n;
  Real* parts_across = parts + static_cast<int64_t>(count) * first;
  double before[kAtOnce];
  for (int32_t j = 0; j < count; ++j) before[j] = product(x + int64_t{j} * v.n, x + int64_t{j} * v.n, v.n);
  transpose(v.n, count, Real(-1), x, across);
  for (int64_t i = 0; i < int64_t{count} * first; ++i) parts_across[i] = 0;
  gemm_minus(v.engine, count, first, v.n, across, count, v.x, v.n, parts_across, count);
  transpose(count, first, Real(1), parts_across, parts);
  gemm_minus(v.engine, v.n, count, first, v.x, v.n, parts, first, x, v.n);
  if (v.y) gemm_minus(v.engine, v.rows, count, first, v.y, v.rows, parts, first, v.y + int64_t{first} * v.rows, v.rows);
  bool sound = true;
  for (int32_t j = 0; j < count; ++j)
    sound &= product(x + int64_t{j} * v.n, x + int64_t{j} * v.n, v.n) > kNoDirection * kNoDirection * before[j];
  return sound;
}

} // namespace

bool orthonormalise(const Engine& engine, int32_t n, int32_t count, Real* x, int32_t rows, Real* y, Real* scratch) {
  if (!has_blocks(n, count)) return orthonormalise(n, count, x, rows, y);
  const Vectors v = {engine, n, rows, x, y, scratch};
  bool sound = true;
  for (int32_t first = 0; first < count; first += kAtOnce) {
    const int32_t most = count - first, own = most < kAtOnce ? most : kAtOnce;
    for (int pass = 0; pass < (first > 0 ? 2 : 1); ++pass) {
      if (first > 0) sound &= project(v, first, own);
      sound &= orthonormalise(n, own, x + int64_t{first} * n, rows, y ? y + int64_t{first} * rows : nullptr);
    }
  }
  return sound;
}

} // namespace c2d
