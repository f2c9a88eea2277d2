// Ring kernels and their integrals over elements (METHOD 21) against Kelvin's kernels in space, integrated round the axis.
#include "bie/integrals/integrals_detail.hpp"
#include "bie/rings/ring_kernels.hpp"
#include "bie/rings/ring_stress.hpp"
#include "effort.hpp"
#include "gauss_points.hpp"
#include "model/shape.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>

using namespace c2d;

namespace {

using Long = long double;
constexpr Long kTurn = 6.28318530717958647692528676655900577L;

struct Kernels {
  Long u[2][2], t[2][2];
};

// The kernels in space, METHOD (21.1), of a ring point at the angle f, times 2 G / k for U and 1 / k for T.
void add_kelvin(Long big, Long a, Long z, Long nr, Long nz, Long nu, Long f, Long weight, Kernels& sum) {
  const Long half = sinl(f / 2), rise = 2 * half * half, r = big + a;
  const Long d[3] = {a - r * rise, r * sinl(f), z};
  const Long rho = sqrtl(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const Long source[2][3] = {{1, 0, 0}, {0, 0, 1}}, ring[2][3] = {{1 - rise, sinl(f), 0}, {0, 0, 1}};
  const Long n[3] = {nr * ring[0][0], nr * ring[0][1], nz};
  const auto dot = [](const Long* p, const Long* q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Long same = dot(source[i], ring[j]), di = dot(d, source[i]), dj = dot(d, ring[j]), dn = dot(d, n) / rho;
      sum.u[i][j] += weight * ((3 - 4 * nu) * same + di * dj / (rho * rho)) / (2 * rho);
      sum.t[i][j] -= weight *
                     (dn * ((1 - 2 * nu) * same + 3 * di * dj / (rho * rho)) -
                      (1 - 2 * nu) * (di * dot(n, ring[j]) - dj * dot(n, source[i])) / rho) /
                     (2 * rho * rho);
    }
}

// Round the axis: Gauss rules on panels that grow away from the nearest point, both halves at once where the entry is even.
Kernels round_the_axis(Long big, Long a, Long z, Long nr, Long nz, Long nu) {
  Kernels sum = {};
  const Long r = big + a, near = r * big > 0 ? hypotl(a, z) / sqrtl(r * big) : 1;
  for (Long from = 0, size = fminl(near, kTurn / 16); from < kTurn / 2;) {
    const Long to = fminl(from + size, kTurn / 2);
    for (int i = 0; i < 18; ++i) {
      const GaussPoint p = test::reference_gauss_point(18, i);
      add_kelvin(big, a, z, nr, nz, nu, (from + to) / 2 + (to - from) / 2 * p.x, (to - from) * p.w, sum);
    }
    from = to;
    size = fminl(2 * size, kTurn / 16);
  }
  return sum;
}

double error_of(const double got[2][2], const Long expected[2][2]) {
  Long scale = 0, worst = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      scale = fmaxl(scale, fabsl(expected[i][j]));
      worst = fmaxl(worst, fabsl(got[i][j] - expected[i][j]));
    }
  return static_cast<double>(worst / scale);
}

double kernel_error(const RingPlace& at, const double n[2], double nu) {
  const Kernels expected = round_the_axis(at.radius, at.a, at.z, n[0], n[1], nu);
  const RingMaterial material = {3 - 4 * nu, 1 - 2 * nu};
  double u[2][2], t[2][2];
  ring_displacement(at, ring_moments(at), material, u);
  ring_traction(at, ring_moments(at), material, n, t);
  return std::max(error_of(u, expected.u), error_of(t, expected.t));
}

} // namespace

TEST_CASE("ring kernels: Kelvin's kernels integrated round the axis") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double angle = 6.28 * unit(random), n[2] = {std::cos(angle), std::sin(angle)};
    const double nu = k % 5 == 0 ? 0.5 : 0.5 * unit(random), radius = 0.02 + 2 * unit(random);
    RingPlace at = {radius, 2 * unit(random) - radius, std::pow(10.0, 4 * unit(random) - 3) * (unit(random) - 0.5)};
    if (k % 3 == 0) at.a = radius * std::pow(10.0, -4 * unit(random)) * (unit(random) - 0.5); // near the source
    if (k % 7 == 0) at.a = -radius;                                                           // a point of the axis
    worst = std::max(worst, kernel_error(at, n, nu));
  }
  CHECK(worst < 1e-12);
  // A source on the axis, where only the force along it acts; and both sides of the change of method.
  worst = 0.0;
  for (double z : {0.3, 1.0, 20.0}) {
    const double n[2] = {0.6, 0.8};
    worst = std::max(worst, kernel_error({0.0, 1.0, z}, n, 0.3));
    for (double m : {0.399, 0.401}) worst = std::max(worst, kernel_error({1.0, 0.0, std::sqrt(4 / m - 4)}, n, 0.3));
  }
  CHECK(worst < 1e-13);
}

namespace {

// Displacement at the source of a ring that carries the traction t and the displacement u.
struct Carried {
  double n[2], t[2], u[2], nu;

  void at(Long big, Long a, Long z, Long out[2]) const {
    const Kernels k = round_the_axis(big, a, z, n[0], n[1], nu);
    for (int i = 0; i < 2; ++i) out[i] = k.u[i][0] * t[0] + k.u[i][1] * t[1] - k.t[i][0] * u[0] - k.t[i][1] * u[1];
  }
};

// Strains there by central differences of the fourth order, and the stress by Hooke's law.
RingStress differenced(const Carried& ring, const RingPlace& at) {
  const Long h = 2e-4L * hypotl(at.a, at.z);
  const auto moved = [&](int i, Long side, Long out[2]) {
    ring.at(at.radius + (i == 0 ? side : 0), at.a - (i == 0 ? side : 0), at.z - (i == 1 ? side : 0), out);
  };
  Long slope[2][2], here[2];
  ring.at(at.radius, at.a, at.z, here);
  for (int i = 0; i < 2; ++i) {
    Long far[2][2], near[2][2];
    moved(i, 2 * h, far[0]), moved(i, -2 * h, far[1]), moved(i, h, near[0]), moved(i, -h, near[1]);
    for (int c = 0; c < 2; ++c) slope[c][i] = (8 * (near[0][c] - near[1][c]) - (far[0][c] - far[1][c])) / (12 * h);
  }
  const Long hoop = here[0] / at.radius, nu = ring.nu, mean = nu / (1 - 2 * nu) * (slope[0][0] + slope[1][1] + hoop);
  return {static_cast<double>(slope[0][0] + mean), static_cast<double>(slope[1][1] + mean),
          static_cast<double>((slope[0][1] + slope[1][0]) / 2), static_cast<double>(hoop + mean)};
}

} // namespace

TEST_CASE("ring kernels: stress is Hooke's law for the differences of Kelvin's solution integrated round the axis") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int k = 0; k < 60; ++k) {
    const double angle = 6.28 * unit(random), radius = 0.1 + 2 * unit(random);
    const Carried ring = {{std::cos(angle), std::sin(angle)},
                          {unit(random) - 0.5, unit(random) - 0.5},
                          {unit(random) - 0.5, unit(random) - 0.5},
                          0.49 * unit(random)};
    RingPlace at = {radius, (2 * unit(random) - 1) * radius, 3 * (unit(random) - 0.5)};
    if (k % 3 == 0) at.a *= 1e-2, at.z *= 1e-2; // near the source
    if (k % 5 == 0) at.a = -radius;             // on the axis
    const RingStress expected = differenced(ring, at), got = ring_stress(at, ring_moments(at), ring.nu, ring.n, ring.t, ring.u);
    const double size = std::fabs(expected.rr) + std::fabs(expected.zz) + std::fabs(expected.rz) + std::fabs(expected.round);
    worst = std::max({worst, std::fabs(got.rr - expected.rr) / size, std::fabs(got.zz - expected.zz) / size,
                      std::fabs(got.rz - expected.rz) / size, std::fabs(got.round - expected.round) / size});
  }
  CHECK(worst < 1e-10);
}

TEST_CASE("ring kernels: the trace of the stress is (1 + nu)/(1 - 2 nu) times the divergence of the displacement") {
  const double nu = 0.3, n[2] = {0.6, -0.8}, h = 1e-5;
  const RingMaterial material = {3 - 4 * nu, 1 - 2 * nu};
  for (const RingPlace at : {RingPlace{0.7, 0.4, -0.3}, RingPlace{2.0, 0.1, 0.2}, RingPlace{0.05, 1.0, 0.3}}) {
    double divergence[2][2] = {}, u[2][2], t[2][2];
    ring_displacement(at, ring_moments(at), material, u);
    ring_traction(at, ring_moments(at), material, n, t);
    for (int j = 0; j < 2; ++j) divergence[0][j] = u[0][j] / at.radius, divergence[1][j] = t[0][j] / at.radius;
    for (int i = 0; i < 2; ++i)
      for (double side : {h, -h}) { // the source moves along i
        const RingPlace moved =
            i == 0 ? RingPlace{at.radius + side, at.a - side, at.z} : RingPlace{at.radius, at.a, at.z - side};
        ring_displacement(moved, ring_moments(moved), material, u);
        ring_traction(moved, ring_moments(moved), material, n, t);
        for (int j = 0; j < 2; ++j) divergence[0][j] += u[i][j] / (2 * side), divergence[1][j] += t[i][j] / (2 * side);
      }
    double of_u[2], of_t[2];
    ring_trace(at, ring_moments(at), n, of_u, of_t);
    for (int j = 0; j < 2; ++j) {
      CHECK(of_t[j] == doctest::Approx(divergence[0][j] / (1 - 2 * nu)).epsilon(1e-6));
      CHECK(of_u[j] == doctest::Approx(-divergence[1][j] / (1 - 2 * nu)).epsilon(1e-6));
    }
  }
}

TEST_CASE("ring kernels: the logarithm near the source") {
  // K - L ln(1/b) is analytic, so it is the same to second order on a small circle about the source.
  for (double angle : {0.3, 1.9, 4.0}) {
    double rest[2];
    for (int i = 0; i < 2; ++i) {
      const double d = i == 0 ? 1e-5 : 2e-5;
      const RingPlace at = {0.7, d * std::cos(angle), d * std::sin(angle)};
      rest[i] = ring_moments(at).n1[0] - ring_logarithms(at).n1[0] * -2 * std::log(d);
    }
    CHECK(std::fabs(rest[0] - rest[1]) < 1e-4);
    const RingPlace at = {0.7, 0.0, 1e-9};
    CHECK(ring_logarithms(at).n1[0] == doctest::Approx(1 / 0.7).epsilon(1e-12)); // the plane kernel over R
  }
}

namespace {

// Blocks by panels of 18 points that are halved until they are short compared with their distance from the source, with the
// ring kernels tested above. A source on the element: panels shrink to 1e-17 of it.
struct Reference {
  const Integrator& in;
  double radius;
  Expansion x;
  int singular;
  Blocks sum;
  double scale[2];

  Reference(const Integrator& element, double sx, double sy, int own, double near)
      : in(element), radius(sx), singular(own), sum(), scale() {
    x = expand(in, own >= 0 ? node_eta(in.functions, own) : near, sx, sy, own >= 0);
    if (own < 0 && std::fabs(near) == 1.0) { // exactly, from the coordinates of the end
      const int end = near > 0.0 ? in.element.nodes - 1 : 0;
      x.delta[0] = in.element.x[end] - sx, x.delta[1] = in.element.y[end] - sy;
    }
    if (x.origin < 1.0) side(1.0, 1.0 - x.origin);
    if (x.origin > -1.0) side(-1.0, 1.0 + x.origin);
    for (int l = 0; l < in.functions; ++l)
      for (int i = 0; i < 4; ++i) {
        if (l != own) scale[0] = std::max(scale[0], std::fabs(sum.h[l][i / 2][i % 2]));
        scale[1] = std::max(scale[1], std::fabs(sum.g[l][i / 2][i % 2]));
      }
  }
  double reach(double tau) const {
    const Sample s = sample(in, x, tau);
    return std::hypot(s.rx, s.ry);
  }
  void side(double sign, double end) {
    double to = end;
    for (int panel = 0; panel < 130; ++panel, to *= 0.7) interval(sign * to * 0.7, sign * to, 0);
    if (singular < 0) interval(0.0, sign * to, 0);
  }
  void interval(double from, double to, int depth) {
    const double length = reach(to) - reach(from);
    if (depth < 8 && (std::fabs(to - from) > 0.15 || std::fabs(length) > 0.5 * std::min(reach(to), reach(from)))) {
      interval(from, 0.5 * (from + to), depth + 1);
      return interval(0.5 * (from + to), to, depth + 1);
    }
    for (int i = 0; i < 18; ++i) {
      const GaussPoint p = test::reference_gauss_point(18, i);
      point(0.5 * (from + to) + 0.5 * (to - from) * p.x, 0.5 * std::fabs(to - from) * p.w);
    }
  }
  void point(double tau, double weight) {
    const Sample s = sample(in, x, tau);
    const RingPlace at = {radius, s.rx, s.ry};
    const double n[2] = {s.nx, s.ny};
    double u[2][2], t[2][2];
    ring_displacement(at, ring_moments(at), {in.kappa, in.t1}, u);
    ring_traction(at, ring_moments(at), {in.kappa, in.t1}, n, t);
    for (int l = 0; l < in.functions; ++l)
      for (int i = 0; i < 4; ++i) {
        if (l != singular) sum.h[l][i / 2][i % 2] += in.k * weight * s.shape[l] * (radius + s.rx) * t[i / 2][i % 2];
        sum.g[l][i / 2][i % 2] += in.k * weight * s.shape[l] * s.jacobian * (radius + s.rx) * u[i / 2][i % 2];
      }
  }
  double error(const Blocks& got) const {
    double worst = 0.0;
    for (int l = 0; l < in.functions; ++l)
      for (int i = 0; i < 4; ++i) {
        if (l != singular) worst = std::max(worst, std::fabs(got.h[l][i / 2][i % 2] - sum.h[l][i / 2][i % 2]) / scale[0]);
        worst = std::max(worst, std::fabs(got.g[l][i / 2][i % 2] - sum.g[l][i / 2][i % 2]) / scale[1]);
      }
    return worst;
  }
};

Integrator ring_element(int nodes, const double* x, const double* y, int functions, double nu) {
  Integrator in;
  prepare(in, make_element(nodes, x, y), functions, nu, Quadrature::accurate);
  set_axis(in, 1.0);
  return in;
}

double block_error(const Integrator& in, double sx, double sy, int singular, double near) {
  Blocks got;
  integrate(in, sx, sy, singular, true, true, got);
  return Reference(in, sx, sy, singular, near).error(got);
}

} // namespace

TEST_CASE("ring elements: blocks at any distance, at nodes, on the axis, at large radii") {
  double worst[4] = {};
  for (double radius : {0.0, 1e-3, 0.5, 30.0, 1e4}) {
    if (!test::in_full() && (radius == 0.5 || radius == 30.0)) continue;
    // Straight and curved, along r and along z; the first begins on the axis where radius is 0.
    const double along[3] = {radius, radius + 0.5, radius + 1.0}, flat[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 0.2, 1.0};
    const double away[3] = {radius + 1.0, radius + 1.1, radius + 1.0};
    for (int functions = test::effort(4, 2); functions <= 4; ++functions) {
      const Integrator elements[] = {ring_element(3, along, flat, functions, 0.3), ring_element(3, along, up, functions, 0.5),
                                     ring_element(3, away, up, functions, 0.0)};
      for (const Integrator& in : elements) {
        for (int l = 0; l < functions; ++l) {
          const Point p = element_point(in.element, node_eta(functions, l));
          worst[0] = std::max(worst[0], block_error(in, p.x, p.y, l, 0.0));
        }
        for (double d = 1e-9; d < 50.0; d *= test::effort(250.0, 11.0))
          for (double eta : {-1.0, 0.3, 1.0}) {
            const Point p = element_point(in.element, eta);
            if (p.x + d * p.nx < 0.0 || (d < 1e-4 && radius > 100.0)) continue; // (coordinates of 1e4 have 12 decimals)
            worst[d < 1e-4 ? 1 : 2] =
                std::max(worst[d < 1e-4 ? 1 : 2], block_error(in, p.x + d * p.nx, p.y + d * p.ny, -1, eta));
          }
        for (double z : {-2.0, 1e-3, 0.7, 5.0})
          if (radius < 1.0) worst[3] = std::max(worst[3], block_error(in, 0.0, z, -1, 0.0));
      }
    }
  }
  CHECK(worst[0] < 1e-12);
  CHECK(worst[1] < 1e-12); // (the coordinates of the source have digits of their own)
  CHECK(worst[2] < 1e-12);
  CHECK(worst[3] < 1e-12);
}
