#pragma once
// Adding the integrals of an element to columns of a panel.
#include "bie/integrals/integrals.hpp"
#include "memory/config.hpp"
#include "memory/hostile.hpp"

#include <stdint.h>

namespace c2d {

// Where the integrals of one element go, found once for all sources: column[2 s + i] += factor * block[i]. `block` is the
// place of the component's integral for i = 0; the one for i = 1 is two doubles behind it.
struct Deposit {
  const double* block;
  Real* column;
  double factor;
};
constexpr int kMostDeposits =
    kElementNodes * 2 * 6; // by node and component: h and g, at most two contact columns, or one, each
struct Deposits {
  Deposit list[kMostDeposits];
  int count;

  void add(const double* block, Real* column, double factor) {
    C2D_ASSERT(count < kMostDeposits);
    if (column && factor != 0.0) list[count++] = Deposit{block, column, factor};
  }
  void scatter(int32_t source) const {
    for (int n = 0; n < count; ++n) {
      const Deposit& d = list[n];
      Real* to = d.column + 2 * source;
      to[0] += static_cast<Real>(d.factor * d.block[0]);
      to[1] += static_cast<Real>(d.factor * d.block[2]);
    }
  }
};

} // namespace c2d
