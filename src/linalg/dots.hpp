#pragma once
// Products of one vector with several. Each sum is added from the first number to the last, whatever the others are.
#include "memory/config.hpp" // Real
#include <stdint.h>

namespace c2d {

// sum[k] = a . b[k], n numbers each.
template <class Sum> void dots(int32_t n, const Real* a, int32_t count, const Real* const* b, Sum* sum) {
  constexpr int32_t kAtOnce = 4; // an addition waits for the last one of its own sum only
  int32_t done = 0;
  for (; !kSmallCode && done + kAtOnce <= count; done += kAtOnce) {
    Sum s[kAtOnce] = {};
    const Real *const b0 = b[done], *const b1 = b[done + 1], *const b2 = b[done + 2], *const b3 = b[done + 3];
    for (int32_t i = 0; i < n; ++i) {
      const Sum factor = a[i];
      s[0] += factor * b0[i];
      s[1] += factor * b1[i];
      s[2] += factor * b2[i];
      s[3] += factor * b3[i];
    }
    for (int32_t k = 0; k < kAtOnce; ++k) sum[done + k] = s[k];
  }
  for (; done < count; ++done) {
    Sum s = 0;
    for (int32_t i = 0; i < n; ++i) s += static_cast<Sum>(a[i]) * b[done][i];
    sum[done] = s;
  }
}

} // namespace c2d
