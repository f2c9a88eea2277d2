// Rings for eight sources at once, and panels with a point per lane, by every instruction set of this machine, against the same
// one by one, which test_rings.cpp compares with brute force round the axis. Floating-point traps are on wherever the loops
// run.
#include "bie/integrals/batch.hpp"
#include "bie/integrals/integrals_detail.hpp"
#include "bie/rings/ring_elements.hpp"
#include "bie/rings/ring_kernels.hpp"
#include "model/shape.hpp"

#include <doctest/doctest.h>

#include <fenv.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>
#include <vector>

using namespace c2d;

namespace {

struct Traps {
  Traps() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  }
  ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

std::vector<const BatchKernel*> kernels() {
  std::vector<const BatchKernel*> out;
  for (int32_t set = 1; set <= static_cast<int32_t>(best_instructions()); ++set)
    if (const BatchKernel* kernel = batch_for(static_cast<Instructions>(set))) out.push_back(kernel);
  return out;
}

Integrator ring_element(const std::vector<double>& x, const std::vector<double>& y, int functions, double nu) {
  Integrator in;
  prepare(in, make_element(static_cast<int>(x.size()), x.data(), y.data()), functions, nu, Quadrature::accurate);
  set_axis(in, 1.0);
  return in;
}

// One point with the normal (0.6, -0.8), weights 1 for the first function alone.
struct OnePoint {
  double a, z, big, nu;
};

double kernel_difference(const BatchKernel& kernel, const OnePoint& at) {
  const double n[2] = {0.6, -0.8};
  const RingPlace place = {at.big, at.a, at.z};
  double u[2][2], t[2][2];
  ring_displacement(place, ring_moments(place), {3 - 4 * at.nu, 1 - 2 * at.nu}, u);
  ring_traction(place, ring_moments(place), {3 - 4 * at.nu, 1 - 2 * at.nu}, n, t);
  const BatchRing element = {at.big, 0.0, 3 - 4 * at.nu, 1 - 2 * at.nu, 1};
  const RingPoint point = {at.a, 0.0, at.big + at.a, n[0], n[1], -0.5, {-0.5}, {0.5}};
  double xy[2 * kBatch];
  for (int s = 0; s < kBatch; ++s) xy[2 * s] = at.big, xy[2 * s + 1] = -at.z;
  BatchBlocks out;
  {
    const Traps traps;
    kernel.rings(element, &point, 1, xy, out);
  }
  double scale[2] = {}, worst = 0.0;
  for (int i = 0; i < 4; ++i) {
    scale[0] = std::max(scale[0], std::fabs(t[i / 2][i % 2]));
    scale[1] = std::max(scale[1], std::fabs(u[i / 2][i % 2]));
  }
  for (int s = 0; s < kBatch; ++s)
    for (int i = at.big > 0.0 ? 0 : 2; i < 4; ++i) { // on the axis the force along it alone
      worst = std::max(worst, std::fabs(out.h[0][i % 2][2 * s + i / 2] - t[i / 2][i % 2]) / scale[0]);
      worst = std::max(worst, std::fabs(out.g[0][i % 2][2 * s + i / 2] - u[i / 2][i % 2]) / scale[1]);
    }
  return worst;
}

} // namespace

TEST_CASE("ring batches: kernels of eight sources are those of one") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const BatchKernel* kernel : kernels()) {
    double worst = 0.0;
    for (int k = 0; k < 2000; ++k) {
      OnePoint at = {0.0, 0.0, 0.02 + 2 * unit(random), k % 5 == 0 ? 0.5 : 0.5 * unit(random)};
      at.a = 2 * unit(random) - at.big;
      at.z = std::pow(10.0, 4 * unit(random) - 3) * (unit(random) - 0.5);
      if (k % 7 == 0) at.a = -at.big;                // a point of the axis
      if (k % 11 == 0) at.a += at.big, at.big = 0.0; // a source there
      worst = std::max(worst, kernel_difference(*kernel, at));
    }
    CHECK(worst < 1e-13);
  }
}

namespace {

double block_difference(const Blocks& got, const Blocks& expected, int functions) {
  double worst = 0.0;
  for (int kind = 0; kind < 2; ++kind) {
    const auto& a = kind == 0 ? got.h : got.g;
    const auto& b = kind == 0 ? expected.h : expected.g;
    double scale = 0.0, most = 0.0;
    for (int l = 0; l < functions; ++l)
      for (int i = 0; i < 4; ++i) {
        scale = std::max(scale, std::fabs(b[l][i / 2][i % 2]));
        most = std::max(most, std::fabs(a[l][i / 2][i % 2] - b[l][i / 2][i % 2]));
      }
    worst = std::max(worst, most / scale);
  }
  return worst;
}

// Elements: straight across, along and oblique to the axis, curved, on the axis, far from it.
std::vector<Integrator> some_elements() {
  std::vector<Integrator> out;
  out.push_back(ring_element({1.0, 1.3}, {0.2, 0.5}, 2, 0.3));
  out.push_back(ring_element({0.5, 0.5}, {0.0, 0.4}, 2, 0.5));
  out.push_back(ring_element({0.0, 0.2}, {1.0, 1.0}, 2, 0.2));
  out.push_back(ring_element({1.0, 1.2, 1.3}, {0.0, 0.05, 0.2}, 3, 0.3));
  out.push_back(ring_element({0.3, 0.2, 0.1, 0.0}, {0.0, 0.15, 0.2, 0.22}, 4, -0.3));
  out.push_back(ring_element({1e4, 1e4 + 0.5}, {0.1, 0.9}, 3, 0.3));
  return out;
}

} // namespace

TEST_CASE("ring batches: panels with a point per lane, near the element and on it") {
  for (const BatchKernel* kernel : kernels())
    for (const Integrator& in : some_elements()) {
      double worst = 0.0, worst_sum = 0.0;
      const Expansion x = expand(in, 0.0, 0.0, 0.0, false);
      for (int k = 0; k < 20; ++k) {
        const int singular = k < in.functions ? k : -1;
        const double eta = singular >= 0 ? node_eta(in.functions, singular) : -0.9 + 0.11 * k;
        const Sample s = sample(in, x, eta);
        const double off = singular >= 0 ? 0.0 : std::pow(10.0, -0.4 * k), size = std::hypot(s.nx, s.ny);
        const double sx = s.rx + off * s.nx / size, sy = s.ry + off * s.ny / size;
        if (sx < 0.0 || (singular >= 0 && in.element.c[0][0] > 1e3)) continue;
        Blocks got = {}, expected = {};
        integrate_rings(in, sx, sy, singular, true, true, expected);
        double sum[2][2], expected_sum[2][2], scale = 0.0;
        ring_sum(in, sx, sy, singular, expected_sum);
        {
          const Traps traps;
          integrate_ring_panels(in, *kernel, sx, sy, singular, true, true, got);
          ring_panel_sum(in, *kernel, sx, sy, singular, sum);
        }
        worst = std::max(worst, block_difference(got, expected, in.functions));
        for (int i = 0; i < 4; ++i) scale = std::max(scale, std::fabs(expected_sum[i / 2][i % 2]));
        for (int i = 0; i < 4; ++i)
          worst_sum = std::max(worst_sum, std::fabs(sum[i / 2][i % 2] - expected_sum[i / 2][i % 2]) / scale);
      }
      CHECK(worst < 1e-12);
      CHECK(worst_sum < 1e-12);
    }
}
