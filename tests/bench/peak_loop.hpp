// The most that the processor does with one instruction set: independent multiplications and additions, in
// registers all. Included by one file per set, which defines PEAK_BYTES (of a vector), PEAK_SUMS and
// PEAK_NAME and is compiled with the flags of the kernel it belongs to.
#include <cstdint>

namespace bench {

namespace {
typedef double Vector __attribute__((vector_size(PEAK_BYTES)));
}

// `rounds` times 2 * PEAK_SUMS * lanes operations; returns their number. The sums go to *keep, so that they
// are wanted.
double PEAK_NAME(int64_t rounds, double* keep) {
  constexpr int kLanes = PEAK_BYTES / 8;
  Vector sum[PEAK_SUMS], factor, term;
  for (int v = 0; v < kLanes; ++v) factor[v] = 0.5 + 1e-9 * *keep, term[v] = 0.25;
  for (Vector& s : sum) s = term;
  for (int64_t r = 0; r < rounds; ++r) {
#pragma GCC unroll 16
    for (int i = 0; i < PEAK_SUMS; ++i) sum[i] = sum[i] * factor + term;
  }
  Vector all = {};
  for (const Vector& s : sum) all += s;
  for (int v = 0; v < kLanes; ++v) *keep += all[v];
  return 2.0 * PEAK_SUMS * kLanes * static_cast<double>(rounds);
}

} // namespace bench
