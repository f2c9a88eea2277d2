// In space the source is at (R, 0, 0), a point of the ring at (r cos f, r sin f, Z). With u = 1 - cos f, a = r - R and d from
// the source to that point:
//   e_R.e_r = 1 - u,   d.e_R = a - r u,   d.e_r = a + R u,   d.n = D0 + n_r R u,   D0 = n_r a + n_z Z.
// So every entry is a sum of K(n,k), METHOD (21.2) and (21.3).
#include "bie/rings/ring_kernels.hpp"

namespace c2d {

void ring_displacement(const RingPlace& at, const RingMoments& k, const RingMaterial& material, double u[2][2]) {
  const double a = at.a, z = at.z, big = at.radius, r = big + a;
  const double a_k3 = a * k.n3[0];
  u[0][0] = 0.5 * (material.kappa * (k.n1[0] - k.n1[1]) + a * (a_k3 - a * k.n3[1]) - r * big * k.n3[2]);
  u[0][1] = 0.5 * z * (a_k3 - r * k.n3[1]);
  u[1][0] = 0.5 * z * (a_k3 + big * k.n3[1]);
  u[1][1] = 0.5 * (material.kappa * k.n1[0] + z * z * k.n3[0]);
}

void ring_traction(const RingPlace& at, const RingMoments& k, const RingMaterial& material, const double n[2], double t[2][2]) {
  const double a = at.a, z = at.z, big = at.radius, r = big + a, t1 = material.t1;
  const double d0 = n[0] * a + n[1] * z, d1 = n[0] * big;
  // (d.n) times 1, u, u^2 over rho^5, and times 1, u over rho^3
  double over5[3], over3[2];
  for (int i = 0; i < 3; ++i) over5[i] = d0 * k.n5[i] + d1 * k.n5[i + 1];
  for (int i = 0; i < 2; ++i) over3[i] = d0 * k.n3[i] + d1 * k.n3[i + 1];
  t[0][0] = -0.5 * (t1 * (over3[0] - over3[1]) + 3.0 * (a * a * (over5[0] - over5[1]) - r * big * over5[2]) +
                    t1 * d1 * (2.0 * k.n3[1] - k.n3[2]));
  t[0][1] = -0.5 * (3.0 * z * (a * over5[0] - r * over5[1]) -
                    t1 * (n[1] * (a * k.n3[0] - r * k.n3[1]) - z * n[0] * (k.n3[0] - k.n3[1])));
  t[1][0] =
      -0.5 * (3.0 * z * (a * over5[0] + big * over5[1]) - t1 * (z * n[0] * k.n3[0] - n[1] * (a * k.n3[0] + big * k.n3[1])));
  t[1][1] = -0.5 * (t1 * over3[0] + 3.0 * z * z * over5[0]);
}

void ring_trace(const RingPlace& at, const RingMoments& k, const double n[2], double u[2], double t[2]) {
  const double a = at.a, z = at.z, big = at.radius;
  const double d0 = n[0] * a + n[1] * z, d1 = n[0] * big;
  double over5[3];
  for (int i = 0; i < 3; ++i) over5[i] = d0 * k.n5[i] + d1 * k.n5[i + 1];
  t[0] = a * k.n3[0] + big * k.n3[1];
  t[1] = z * k.n3[0];
  u[0] = 3.0 * (a * over5[0] + big * over5[1]) - n[0] * k.n3[0];
  u[1] = 3.0 * z * over5[0] - n[1] * k.n3[0];
}

} // namespace c2d
