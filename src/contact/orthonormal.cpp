#include "contact/orthonormal.hpp"

#include <math.h>

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

void divide(int32_t n, Real* v, double by) {
  for (int32_t i = 0; i < n; ++i) v[i] = static_cast<Real>(static_cast<double>(v[i]) / by);
}

} // namespace

bool orthonormalise(int32_t n, int32_t count, Real* x, int32_t rows, Real* y) {
  constexpr double kNoDirection = sizeof(Real) == 8 ? 1e-12 : 1e-5;
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

} // namespace c2d
