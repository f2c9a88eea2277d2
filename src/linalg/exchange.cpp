#include "linalg/exchange.hpp"
#include "memory/hostile.hpp"
#include <limits>

namespace c2d {
namespace {

void plain_add(int32_t n, Real factor, const Real* __restrict x, Real* __restrict y) {
  for (int32_t i = 0; i < n; ++i) y[i] += factor * x[i];
}

} // namespace

bool exchange(int32_t rows, int32_t cols, Real* t, int64_t ld, int32_t r, int32_t c, const Kernel* kernel) {
  C2D_ASSERT(r >= 0 && r < rows && c >= 0 && c < cols && ld >= rows);
  Real* pivot_column = t + c * ld;
  const Real pivot = pivot_column[r];
  if ((pivot < 0 ? -pivot : pivot) < std::numeric_limits<Real>::min()) return false;
  const auto add = !kSmallCode && kernel ? kernel->add : plain_add;
  for (int32_t j = 0; j < cols; ++j) {
    Real* column = t + j * ld;
    if (j == c || column[r] == 0) continue;
    const Real entry = -column[r] / pivot;
    add(rows, entry, pivot_column, column);
    column[r] = entry;
  }
  for (int32_t i = 0; i < rows; ++i) pivot_column[i] /= pivot;
  pivot_column[r] = 1 / pivot;
  return true;
}

void row_add(int32_t cols, Real* t, int64_t ld, int32_t target, int32_t source, Real factor) {
  for (int32_t j = 0; j < cols; ++j) t[target + j * ld] += factor * t[source + j * ld];
}

void column_add(int32_t rows, Real* t, int64_t ld, int32_t target, int32_t source, Real factor) {
  Real* to = t + target * ld;
  const Real* from = t + source * ld;
  for (int32_t i = 0; i < rows; ++i) to[i] += factor * from[i];
}

} // namespace c2d
