// Elimination as it was written in 1987: row i is taken out of every row below it, one after another. The
// rows are those of the transposed matrix, because they are contiguous there; rows are exchanged for the
// largest pivot.
#include "serve.hpp"

#ifdef RIVAL_FORTRAN
extern "C" void rows_(const int* n, double* a, double* x);
#else
namespace {
void rows_(const int* size, double* a, double* x) {
  const size_t n = static_cast<size_t>(*size);
  for (size_t i = 0; i < n; ++i) {
    size_t best = i;
    for (size_t j = i + 1; j < n; ++j)
      if (std::fabs(a[i + j * n]) > std::fabs(a[i + best * n])) best = j;
    if (best != i) {
      for (size_t k = 0; k < n; ++k) std::swap(a[k + i * n], a[k + best * n]);
      std::swap(x[i], x[best]);
    }
    for (size_t j = i + 1; j < n; ++j) {
      const double factor = -a[i + j * n] / a[i + i * n];
      for (size_t k = i + 1; k < n; ++k) a[k + j * n] += factor * a[k + i * n];
      x[j] += factor * x[i];
    }
  }
  for (size_t i = n; i-- > 0;) {
    for (size_t k = i + 1; k < n; ++k) x[i] -= a[k + i * n] * x[k];
    x[i] /= a[i + i * n];
  }
}
} // namespace
#endif

int main() {
  return rival::serve([](int n, double* a, double* x) { rows_(&n, a, x); }, [] { return 0.0; });
}
