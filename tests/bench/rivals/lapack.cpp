// dgetrf and dgetrs of libraries that are named when it starts, the last of which has them: OpenBLAS alone,
// or a BLAS and then the LAPACK that uses it.
#include "serve.hpp"

#include <dlfcn.h>

namespace {
typedef void (*Factor)(const int* m, const int* n, double* a, const int* lda, int* pivots, int* info);
typedef void (*Back)(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda, const int* pivots,
                     double* b, const int* ldb, int* info, size_t length);
} // namespace

int main(int argc, char** argv) {
  void* library = nullptr;
  for (int i = 1; i < argc; ++i) library = dlopen(argv[i], RTLD_NOW | RTLD_GLOBAL);
  if (!library) return 2;
  const Factor factor = reinterpret_cast<Factor>(dlsym(library, "dgetrf_"));
  const Back back = reinterpret_cast<Back>(dlsym(library, "dgetrs_"));
  if (!factor || !back) return 2;
  std::vector<int> pivots;
  return rival::serve(
      [&](int n, double* a, double* x) {
        const int one = 1;
        int info = 0;
        pivots.resize(static_cast<size_t>(n));
        factor(&n, &n, a, &n, pivots.data(), &info);
        back("N", &n, &one, a, &n, pivots.data(), x, &n, &info, 1);
      },
      [] { return 0.0; });
}
