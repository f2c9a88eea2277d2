#pragma once
// Integrals round the axis that every ring kernel consists of (METHOD 21.1). A source at (R, 0) and a field ring of radius r, a
// height Z above it, are rho apart at the angle f:
//   rho^2 = b + c u,   u = 1 - cos f,   b = (r - R)^2 + Z^2,   c = 2 r R,
//   K(n,k) = int_0^2pi u^k / rho^n df.
// With u in place of cos f nothing cancels as the ring approaches the source.

namespace c2d {

// Where a ring is seen from a source. `a` = r - R and `z` come from local coordinates, so that they are exact near the source.
struct RingPlace {
  double radius, a, z; // R, r - R, Z
};

struct RingMoments {
  double n1[2], n3[3], n5[4]; // K(1,k), K(3,k), K(5,k)
};

// R >= 0, r >= 0, not both points the same.
RingMoments ring_moments(const RingPlace& at);

// K(7,k) besides, from the others.
void ring_moments_7(const RingPlace& at, const RingMoments& k, double n7[5]);

// Factor L of the logarithm near the source: K(n,k) = L(n,k) ln(1/(a^2 + Z^2)) + an analytic function of a and Z. For r > 0,
// R > 0.
RingMoments ring_logarithms(const RingPlace& at);

} // namespace c2d
