#pragma once
// Stress inside bodies of revolution: the derivatives of the ring kernels at the source (METHOD 21.7). Divided by k of METHOD
// (2.2) and in units of 2G, as the kernels themselves.
#include "bie/rings/ring_kernels.hpp"

namespace c2d {

struct RingStress {
  double rr, zz, rz, round; // round the axis
};

// Stress at the source of D t - S u of one ring with the traction t, the displacement u and the outward normal n.
RingStress ring_stress(const RingPlace& at, const RingMoments& k, double nu, const double n[2], const double t[2],
                       const double u[2]);

} // namespace c2d
