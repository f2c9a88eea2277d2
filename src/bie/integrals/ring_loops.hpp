#pragma once
// The kernels of rings (METHOD 21.1), one source or one point per lane: part of batch_loops.hpp, included nowhere else.
//
// All K(n,k) follow from A = K(3,1) and B = K(3,2) by METHOD (21.13), where nothing cancels at any m from 0 to 1. With x = 1 -
// m,
//   s^3 A = P1(x) - ln(x) Q1(x),   s^3 B = P2(x) - x ln(x) Q2(x),
// polynomials of degrees 11 and 10 found in 50 digits from 23 points, squares of Chebyshev points of 0 < x <= 1. They are exact
// to 1e-16. tests/test_ring_batch.cpp compares them with the arithmetic-geometric mean and with sums round the axis.
#include "bie/integrals/vector_loops.hpp"

namespace c2d {
namespace {

constexpr double kRingP1[] = {3.090354888959133,    0.31776616691430837, 0.11040599290500142,  0.055295728874751933,
                              0.035150204616587584, 0.06108400015864638, 0.29849499741767399,  0.84663283272512579,
                              0.99521965486081332,  0.42401834083197071, 0.048428842754529036, 0.00033365616104487594};
constexpr double kRingQ1[] = {3.9999999999999996,  2.9999999999770544,  2.8124999663082657,  2.7343666730404137,
                              2.6910759636195398,  2.6505062219879867,  2.4996265403428102,  1.9370945568028264,
                              0.94293578421363244, 0.20883178048918505, 0.013023927291720486};
constexpr double kRingP2[] = {16.0,
                              10.728935333051435,
                              10.366753480223334,
                              10.274319802692302,
                              10.227187958067312,
                              9.881834044631395,
                              6.2718737766106036,
                              -8.5104938644688115,
                              -27.334751099690788,
                              -22.453239219720462,
                              -5.7251022912070999,
                              -0.30253995941983802};
constexpr double kRingQ2[] = {-11.999999999993099, -22.49999996283503,  -32.812479484272586,  -43.063821875593455,
                              -53.189382150223089, -61.829770038621795, -61.86441803230413,   -43.028125609095852,
                              -15.77141457733741,  -2.196511006734879,  -0.062897648113190263};

// The same address, unknown to the compiler: it would copy every coefficient to the stack, as a vector, in front of each loop
// over points.
INLINE const double* at_each_point(const double* p, const void* point) {
  __asm__("" : "+r"(p) : "r"(point));
  return p;
}

// Even and odd powers apart: two short chains in the place of a long one.
template <int N> INLINE Doubles polynomial(const double (&coefficients)[N], const void* point, Doubles x, Doubles x2) {
  const double* p = at_each_point(coefficients, point);
  Doubles last = all(p[N - 1]), before = all(p[N - 2]);
#pragma GCC unroll 6
  for (int i = N - 3; i > 0; i -= 2) {
    last = last * x2 + p[i];
    before = before * x2 + p[i - 1];
  }
  if (N % 2 == 0) return last * x + before;
  return (last * x2 + p[0]) + before * x;
}

// 1/sqrt(x) for x > 0 and normal: half the exponent, then Newton's method, which squares the relative error of 0.035.
INLINE Doubles over_root(Doubles x) {
  constexpr uint64_t kHalfOfBiases = 0x5fe6eb50c7b537a9;
  Doubles y = (Doubles)(kHalfOfBiases - ((Unsigned)x >> 1));
  const Doubles half = 0.5 * x;
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) y = y + y * (0.5 - half * y * y);
  return y;
}

// A ring of radius `big` + `a` a height z above sources at radius `big`, see RingPlace.
struct RingLane {
  Doubles a, z, r, big, nx, ny;
};

struct LaneMoments {
  Doubles k10, difference; // K(1,0) and K(1,0) - K(1,1)
  Doubles k30, k31, k32, k50, k51, k52, ck53;
};

struct LaneDistances {
  Doubles b, c, near, far, over; // 1/b, 1/s^2, 1/s
};
INLINE LaneDistances lane_distances(const RingLane& at) {
  const Doubles b = at.a * at.a + at.z * at.z, c = 2.0 * (at.r * at.big), over = over_root(b + 2.0 * c);
  return {b, c, 1.0 / b, over * over, over};
}

INLINE LaneMoments lane_moments(const LaneDistances& d, Doubles k31, Doubles k32) {
  const Doubles b = d.b, c = d.c, far = d.far, sum = b + c;
  const Doubles ratio = c * d.near * k32;
  LaneMoments k;
  k.k31 = k31, k.k32 = k32;
  k.k30 = k31 + 0.5 * ratio;
  k.k51 = (k31 + (1.0 / 3.0) * ratio) * far;
  k.k52 = (2.0 * k31 - (1.0 / 3.0) * k32) * far;
  k.ck53 = k32 - b * k.k52;
  k.k50 = (sum * k31 + ((0.5 * c) * k32 + ((2.0 / 3.0) * c) * ratio)) * (d.near * far);
  k.k10 = sum * k31 + (0.5 * c) * k32;
  k.difference = c * (k31 - 0.5 * k32);
  return k;
}

// Of the kernels themselves, ln(x) with x times `stretch`: their logarithm split off (integrals_panels.hpp).
INLINE LaneMoments whole_moments(const RingLane& at, Doubles stretch, const void* point) {
  const LaneDistances d = lane_distances(at);
  const Doubles x = d.b * d.far, x2 = x * x, scale = d.far * d.over, log = logarithm(x * stretch);
  return lane_moments(d, scale * (polynomial(kRingP1, point, x, x2) - log * polynomial(kRingQ1, point, x, x2)),
                      scale * (polynomial(kRingP2, point, x, x2) - log * (x * polynomial(kRingQ2, point, x, x2))));
}

// Of the factor of ln(1/x).
INLINE LaneMoments factor_moments(const RingLane& at, const void* point) {
  const LaneDistances d = lane_distances(at);
  const Doubles x = d.b * d.far, x2 = x * x, scale = d.far * d.over;
  return lane_moments(d, scale * polynomial(kRingQ1, point, x, x2), scale * (x * polynomial(kRingQ2, point, x, x2)));
}

// 2 U_ij/k, METHOD (21.2).
INLINE void lane_displacement(const RingLane& at, const LaneMoments& k, double kappa, Doubles u[2][2]) {
  const Doubles a_k30 = at.a * k.k30;
  u[0][0] = kappa * k.difference + at.a * (a_k30 - at.a * k.k31) - (at.r * at.big) * k.k32;
  u[0][1] = at.z * (a_k30 - at.r * k.k31);
  u[1][0] = at.z * (a_k30 + at.big * k.k31);
  u[1][1] = kappa * k.k10 + (at.z * at.z) * k.k30;
}

// -2 T_ij/k, METHOD (21.3).
INLINE void lane_traction(const RingLane& at, const LaneMoments& k, double t1, Doubles t[2][2]) {
  const Doubles a = at.a, z = at.z, r = at.r, big = at.big, d0 = at.nx * a + at.ny * z, d1 = at.nx * big;
  const Doubles p50 = d0 * k.k50 + d1 * k.k51, p51 = d0 * k.k51 + d1 * k.k52;
  const Doubles p30 = d0 * k.k30 + d1 * k.k31, p31 = d0 * k.k31 + d1 * k.k32;
  const Doubles half_c_p52 = (r * big) * (d0 * k.k52) + (0.5 * d1) * k.ck53;
  const Doubles a30 = a * k.k30, zn = z * at.nx;
  t[0][0] = t1 * ((p30 - p31) + d1 * (2.0 * k.k31 - k.k32)) + 3.0 * ((a * a) * (p50 - p51) - half_c_p52);
  t[0][1] = 3.0 * z * (a * p50 - r * p51) - t1 * (at.ny * (a30 - r * k.k31) - zn * (k.k30 - k.k31));
  t[1][0] = 3.0 * z * (a * p50 + big * p51) - t1 * (zn * k.k30 - at.ny * (a30 + big * k.k31));
  t[1][1] = t1 * p30 + 3.0 * (z * z) * p50;
}

// ---- one source per lane, points one after the other
// ----------------------------------------------------------------------------------------------

struct RingSources {
  Doubles x, dx, dz;
  INLINE RingLane at(const RingPoint& p) const {
    const Doubles none = all(0.0);
    return {dx + p.x, dz + p.z, none + p.r, x, none + p.nx, none + p.ny};
  }
};
INLINE RingSources ring_sources(const BatchRing& e, const double* xy) {
  const Doubles v = load(xy), w = load(xy + kDoubles), x = evens(v, w);
  return {x, e.x - x, e.z - odds(v, w)};
}

template <int F> INLINE void add_shaped(const double* weight, const Doubles value[2][2], Doubles sum[F][2][2]) {
#pragma GCC unroll 4
  for (int l = 0; l < F; ++l)
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) sum[l][i / 2][i % 2] += weight[l] * value[i / 2][i % 2];
}

template <int F>
INLINE void integrate_rings_of(const BatchRing& e, const RingPoint* points, int count, const double* xy, BatchBlocks& out) {
  for (int at = 0; at < 2 * kBatch; at += 2 * kDoubles) {
    const RingSources sources = ring_sources(e, xy + at);
    Doubles h[F][2][2], g[F][2][2];
    for (int l = 0; l < F; ++l)
      for (int i = 0; i < 4; ++i) h[l][i / 2][i % 2] = g[l][i / 2][i % 2] = all(0.0);
    for (int n = 0; n < count; ++n) {
      const RingPoint& p = points[n];
      const RingLane lane = sources.at(p);
      const LaneMoments k = whole_moments(lane, all(1.0), &p);
      Doubles u[2][2], t[2][2];
      lane_displacement(lane, k, e.kappa, u);
      lane_traction(lane, k, e.t1, t);
      add_shaped<F>(p.h, t, h);
      add_shaped<F>(p.g, u, g);
    }
    const Room room = {&out.h[0][0][at]};
    for (int l = 0; l < F; ++l)
      for (int j = 0; j < 2; ++j) {
        room.scatter(0, l, j, h[l][0][j], h[l][1][j]);
        room.scatter(1, l, j, g[l][0][j], g[l][1][j]);
      }
  }
}

void integrate_ring_batch(const BatchRing& e, const RingPoint* points, int count, const double* xy, BatchBlocks& out) {
  switch (e.functions) {
  case 1: return integrate_rings_of<1>(e, points, count, xy, out);
  case 2: return integrate_rings_of<2>(e, points, count, xy, out);
  case 3: return integrate_rings_of<3>(e, points, count, xy, out);
  default: return integrate_rings_of<4>(e, points, count, xy, out);
  }
}

// What the motion (r, -2 (z - z_P)) has as U t* - T (u* - u_P), times 2.
INLINE void lane_motion(const RingLane& at, const Doubles u[2][2], const Doubles t[2][2], Doubles motion[2]) {
  for (int i = 0; i < 2; ++i)
    motion[i] = (u[i][0] * at.nx - 2.0 * (u[i][1] * at.ny)) + (at.a * t[i][0] - 2.0 * (at.z * t[i][1]));
}

void ring_rigid(const BatchRing& e, const RingPoint* points, int count, const double* xy, double* sum) {
  for (int at = 0; at < 2 * kBatch; at += 2 * kDoubles) {
    const RingSources sources = ring_sources(e, xy + at);
    Doubles h[2][2] = {}, motion[2] = {};
    for (int n = 0; n < count; ++n) {
      const RingPoint& p = points[n];
      const RingLane lane = sources.at(p);
      const LaneMoments k = whole_moments(lane, all(1.0), &p);
      Doubles u[2][2], t[2][2], of[2];
      lane_displacement(lane, k, e.kappa, u);
      lane_traction(lane, k, e.t1, t);
      lane_motion(lane, u, t, of);
      for (int i = 0; i < 4; ++i) h[i / 2][i % 2] += p.own * t[i / 2][i % 2];
      for (int i = 0; i < 2; ++i) motion[i] += p.own * of[i];
    }
    const Bits off = sources.x > 0.0;
    const Doubles turned = off ? 1.0 / (off ? sources.x : all(1.0)) : all(0.0); // (lanes) none on the axis
    for (int s = 0; s < kDoubles; ++s)
      for (int i = 0; i < 2; ++i) {
        const int source = s % 2 * (kDoubles / 2) + s / 2; // evens() takes them in this order
        double* to = sum + 2 * at + 4 * source + 2 * i;
        to[0] = h[i][0][s] + motion[i][s] * turned[s];
        to[1] = h[i][1][s];
      }
  }
}

// ---- one point per lane
// ---------------------------------------------------------------------------------------------------

void ring_panel(const BatchRing& e, double radius, const RingPanel& p, bool logarithms, RingSums& sums) {
  for (int at = 0; at < kBatch; at += kDoubles) {
    const Doubles a = load(p.a + at), big = all(radius);
    const RingLane lane = {a, load(p.z + at), big + a, big, load(p.nx + at), load(p.ny + at)};
    const LaneMoments k = logarithms ? factor_moments(lane, &p) : whole_moments(lane, load(p.stretch + at), &p);
    Doubles u[2][2], t[2][2], of[2];
    lane_displacement(lane, k, e.kappa, u);
    lane_traction(lane, k, e.t1, t);
    lane_motion(lane, u, t, of);
    for (int i = 0; i < 2; ++i) {
      double* to = &sums.motion[i][at];
      save(to, load(to) + load(p.own + at) * of[i]);
    }
    for (int l = 0; l < e.functions; ++l)
      for (int i = 0; i < 4; ++i) {
        double *h = &sums.h[l][i][at], *g = &sums.g[l][i][at];
        save(h, load(h) + load(&p.h[l][at]) * t[i / 2][i % 2]);
        save(g, load(g) + load(&p.g[l][at]) * u[i / 2][i % 2]);
      }
  }
}

} // namespace
} // namespace c2d
