// The shape functions of an element with n nodes at equal distances, at eta from -1 to 1.
#pragma once

#include <cstdint>

namespace estimate {

struct Functions {
  double value[4];
  Functions(int32_t n, double eta) {
    for (int32_t i = 0; i < n; ++i) {
      value[i] = 1;
      const double own = n == 1 ? 0 : -1 + 2.0 * i / (n - 1);
      for (int32_t k = 0; k < n; ++k)
        if (const double other = n == 1 ? 1 : -1 + 2.0 * k / (n - 1); k != i && n > 1)
          value[i] *= (eta - other) / (own - other);
    }
  }
};

} // namespace estimate
