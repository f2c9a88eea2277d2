#pragma once
// Kernels of axisymmetric elasticity: those of Kelvin in space, integrated round the axis (METHOD (21.2), (21.3)). Divided by k
// of METHOD (2.2), and U in units of 2G, so that they go with the plane kernels. Components: 0 along r, 1 along z.
#include "bie/rings/ring_moments.hpp"

namespace c2d {

struct RingMaterial {
  double kappa, t1; // 3 - 4 nu, 1 - 2 nu
};

// U_ij: i of the force at the source, j at the ring.
void ring_displacement(const RingPlace& at, const RingMoments& k, const RingMaterial& material, double u[2][2]);
// T_ij with the outward normal n, of unit length or times a Jacobian.
void ring_traction(const RingPlace& at, const RingMoments& k, const RingMaterial& material, const double n[2], double t[2][2]);
// Trace of the stress at the source of the field int U t - int T u, divided by (1 + nu) k (METHOD (21.7)): the factors of u
// and t at the ring.
void ring_trace(const RingPlace& at, const RingMoments& k, const double n[2], double u[2], double t[2]);

} // namespace c2d
