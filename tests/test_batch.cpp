// Integrals for eight sources at once, by every instruction set of this machine, against the same one by one,
// which test_integrals.cpp compares with brute force; their logarithm and arctangent against the C library in
// extended precision. Floating-point traps are on wherever the batch runs.
#include "bie/integrals/batch.hpp"

#include <doctest/doctest.h>

#include <fenv.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace c2d;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Traps on for the length of a scope: what must not raise anything ends the program if it does.
struct Traps {
  Traps() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  }
  ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

struct Set {
  std::string name;
  const BatchKernel* kernel;
};

std::vector<Set> sets() {
  std::vector<Set> out;
  for (int32_t set = 1; set <= static_cast<int32_t>(best_instructions()); ++set)
    if (const BatchKernel* kernel = batch_for(static_cast<Instructions>(set)))
      out.push_back({"set " + std::to_string(set), kernel});
  return out;
}

// |a - b| in units of the last place of b.
double ulps(double a, long double b) {
  const double near = static_cast<double>(b), step = std::nextafter(std::fabs(near), 1e308) - std::fabs(near);
  return static_cast<double>(fabsl(a - b) / step);
}

Element line(int nodes, double x0, double y0, double x1, double y1) {
  double x[4], y[4];
  for (int k = 0; k < nodes; ++k) {
    const double s = static_cast<double>(k) / (nodes - 1);
    x[k] = x0 + s * (x1 - x0);
    y[k] = y0 + s * (y1 - y0);
  }
  return make_element(nodes, x, y);
}

// Largest difference, relative to the largest entry of the block one by one.
double compare(const double batch[4][2][2 * kBatch], const double block[4][2][2], int functions, int s, double scale) {
  double worst = 0;
  for (int l = 0; l < functions; ++l)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) worst = std::fmax(worst, std::fabs(batch[l][j][2 * s + i] - block[l][i][j]) / scale);
  return worst;
}

double largest(const double block[4][2][2], int functions) {
  double most = 0;
  for (int n = 0; n < 4 * functions; ++n) most = std::fmax(most, std::fabs(block[n / 4][n / 2 % 2][n % 2]));
  return most;
}

struct Worst {
  double h, g, rigid;
};

// Eight sources at xy, none at a functional node.
void compare_sources(const BatchKernel& kernel, const Integrator& in, const double* xy, Worst& worst) {
  BatchBlocks out;
  double sum[4 * kBatch];
  {
    Traps traps;
    const BatchElement e = batch_element(in);
    kernel.integrate(e, xy, true, true, out);
    kernel.rigid(e, xy, sum);
  }
  for (int s = 0; s < kBatch; ++s) {
    Blocks one;
    double one_sum[2][2];
    const double x = xy[2 * s], y = xy[2 * s + 1];
    integrate(in, x, y, -1, true, true, one);
    rigid_sum(in, x, y, -1, one_sum);
    // Entries of h are of the size k * length / distance, also where they cancel: nu = 0.5, on the element's
    // line.
    const Element& e = in.element;
    const double away = std::hypot(x - 0.5 * (e.x[0] + e.x[e.nodes - 1]), y - 0.5 * (e.y[0] + e.y[e.nodes - 1]));
    const double size = std::fmax(largest(one.h, in.functions), in.k * e.half_length / (away + e.half_length));
    worst.h = std::fmax(worst.h, compare(out.h, one.h, in.functions, s, size));
    worst.g = std::fmax(worst.g, compare(out.g, one.g, in.functions, s, largest(one.g, in.functions)));
    for (int i = 0; i < 4; ++i) worst.rigid = std::fmax(worst.rigid, std::fabs(sum[4 * s + i] - one_sum[i / 2][i % 2]) / size);
  }
}

} // namespace

TEST_CASE("batch: logarithm to an ulp over the whole range") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Set& set : sets()) {
    double worst = 0;
    for (int n = 0; n < 40000; ++n) {
      double x[kBatch], out[kBatch];
      for (double& v : x) {
        const double u = unit(random);
        v = n % 4 == 0   ? std::exp(1400 * u - 700)                     // everything
            : n % 4 == 1 ? 1 + (u - 0.5) * std::exp(-0.01 * (n % 3600)) // about 1
            : n % 4 == 2 ? 0.5 + u
                         : std::ldexp(1, static_cast<int>(2000 * u) - 1000) * (1 + 4e-16 * (n % 9 - 4)); // powers of 2
      }
      {
        Traps traps;
        set.kernel->logarithm(x, out);
      }
      for (int s = 0; s < kBatch; ++s) {
        if (x[s] == 1.0)
          CHECK(out[s] == 0.0);
        else
          worst = std::fmax(worst, ulps(out[s], logl(x[s])));
      }
    }
    INFO(set.name << ": " << worst << " ulp");
    CHECK(worst < 1.0);
  }
}

TEST_CASE("batch: arctangent to an ulp or so in all quadrants") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Set& set : sets()) {
    double worst = 0;
    for (int n = 0; n < 40000; ++n) {
      double x[kBatch], y[kBatch], out[kBatch];
      for (int s = 0; s < kBatch; ++s) {
        const double angle = 2 * kPi * unit(random), r = std::exp(200 * unit(random) - 100);
        const double stretch = n % 2 ? std::exp(-80 * unit(random)) : 1; // close to an axis
        x[s] = r * std::cos(angle) * (n % 4 == 1 ? stretch : 1);
        y[s] = r * std::sin(angle) * (n % 4 == 3 ? stretch : 1);
      }
      {
        Traps traps;
        set.kernel->angle(y, x, out);
      }
      for (int s = 0; s < kBatch; ++s) worst = std::fmax(worst, ulps(out[s], atan2l(y[s], x[s])));
    }
    INFO(set.name << ": " << worst << " ulp");
    CHECK(worst < 2); // sum, difference and quotient of the reduction, and the last sum: half an ulp each
  }
}

TEST_CASE("batch: arctangent on the axes, the diagonals, and where both are zero") {
  for (const Set& set : sets()) {
    INFO(set.name);
    const double x[kBatch] = {1, -1, 0, 0, 1, -1, 0, 1e-200}, y[kBatch] = {0, 0, 1, -1, 1, -1, 0, 0};
    const double known[kBatch] = {0, kPi, kPi / 2, -kPi / 2, kPi / 4, -3 * kPi / 4, 0, 0};
    double out[kBatch];
    Traps traps;
    set.kernel->angle(y, x, out);
    for (int s = 0; s < kBatch; ++s) CHECK(std::fabs(out[s] - known[s]) <= 5e-16 * std::fabs(known[s]));
  }
}

TEST_CASE("batch: blocks of straight elements are those of one source at a time, near, far and mixed") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Set& set : sets())
    for (int functions = 1; functions <= 4; ++functions) {
      Worst worst{};
      for (int n = 0; n < 3000; ++n) {
        const double size = std::exp(8 * unit(random) - 6), turn = n % 5 == 0 ? 0.5 * kPi * (n % 4) : 7 * unit(random);
        const double x0 = 4 * unit(random) - 2, y0 = 4 * unit(random) - 2;
        const double x1 = x0 + size * std::cos(turn), y1 = y0 + size * std::sin(turn);
        const double nu[] = {0.3, 0.5, 0.0, -0.9};
        Integrator in;
        prepare(in, line(functions < 2 ? 2 : functions, x0, y0, x1, y1), functions, nu[n % 4], Quadrature::accurate);
        REQUIRE(is_batched(in, true));
        double xy[2 * kBatch];
        for (int s = 0; s < kBatch; ++s) {
          // Up to 6 lengths away, beyond, and both in one batch; close to an end; on the element's line.
          const bool near = n % 3 == 0 || (n % 3 == 1 && s % 2);
          const double away = size * (near ? std::exp(6 * unit(random) - 4) : std::exp(8 * unit(random) + 1.5));
          const double angle = n % 7 == 0 ? turn : 7 * unit(random), sign = n % 14 == 0 ? -1 : 1;
          const bool first = sign < 0 || (n % 7 != 0 && s % 3 == 0);
          xy[2 * s] = (first ? x0 : x1) + sign * away * std::cos(angle);
          xy[2 * s + 1] = (first ? y0 : y1) + sign * away * std::sin(angle);
        }
        compare_sources(*set.kernel, in, xy, worst);
      }
      INFO(set.name << ", functions " << functions << ": h " << worst.h << ", g " << worst.g << ", rigid " << worst.rigid);
      CHECK(worst.h < 2e-13); // of the largest entry; 1e-12 is what assembly promises
      CHECK(worst.g < 2e-13);
      CHECK(worst.rigid < 2e-13);
    }
}

TEST_CASE("batch: sources on the element give finite numbers and raise nothing") {
  for (const Set& set : sets())
    for (int functions = 1; functions <= 4; ++functions) {
      const int nodes = functions < 2 ? 2 : functions;
      Integrator in;
      prepare(in, line(nodes, 0.1, 0.2, 0.1 + 1.2, 0.2 + 0.7), functions, 0.3, Quadrature::accurate);
      double xy[2 * kBatch];
      for (int s = 0; s < kBatch; ++s) {
        const double t = s < nodes ? static_cast<double>(s) / (nodes - 1) : 0.125 * s;
        xy[2 * s] = s < nodes ? in.element.x[s] : 0.1 + 1.2 * t;
        xy[2 * s + 1] = s < nodes ? in.element.y[s] : 0.2 + 0.7 * t;
      }
      BatchBlocks out;
      double sum[4 * kBatch];
      {
        Traps traps;
        set.kernel->integrate(batch_element(in), xy, true, true, out);
        set.kernel->rigid(batch_element(in), xy, sum);
      }
      for (int l = 0; l < functions; ++l)
        for (int n = 0; n < 4 * kBatch; ++n)
          CHECK(std::isfinite(out.h[l][n / (2 * kBatch)][n % (2 * kBatch)] + out.g[l][n / (2 * kBatch)][n % (2 * kBatch)]));
      for (const double value : sum) CHECK(std::isfinite(value));
    }
}

TEST_CASE("batch: a block not wanted is not touched, a wanted one does not depend on the other") {
  for (const Set& set : sets()) {
    Integrator in;
    prepare(in, line(3, 0, 0, 1, 0.5), 3, 0.25, Quadrature::accurate);
    double xy[2 * kBatch];
    for (int s = 0; s < kBatch; ++s) xy[2 * s] = -2.0 * s, xy[2 * s + 1] = 1 + 0.5 * s;
    BatchBlocks both{}, h{}, g{};
    const BatchElement e = batch_element(in);
    set.kernel->integrate(e, xy, true, true, both);
    set.kernel->integrate(e, xy, true, false, h);
    set.kernel->integrate(e, xy, false, true, g);
    for (int l = 0; l < 3; ++l)
      for (int j = 0; j < 2; ++j)
        for (int n = 0; n < 2 * kBatch; ++n) {
          CHECK(h.h[l][j][n] == both.h[l][j][n]);
          CHECK(g.g[l][j][n] == both.g[l][j][n]);
          CHECK(h.g[l][j][n] == 0.0);
          CHECK(g.h[l][j][n] == 0.0);
        }
    Real column[2 * kBatch];
    for (const int count : {kBatch, 3}) {
      for (int n = 0; n < 2 * kBatch; ++n) column[n] = static_cast<Real>(n);
      Blocks blocks;
      Deposits deposits;
      deposits.count = 0;
      deposits.add(&blocks.h[2][0][1], column, 2);
      deposits.add(&blocks.g[1][0][0], column, 0.5);
      set.kernel->scatter(BatchRun{e, &deposits, &blocks, true, true, {1, -1}, nullptr}, 0, count, both);
      for (int n = 0; n < 2 * kBatch; ++n) {
        const double added = (n % 2 ? -1 : 1) * (2 * both.h[2][1][n] + 0.5 * both.g[1][0][n]);
        const double tolerance = 4.0 * std::numeric_limits<Real>::epsilon() * (n + 1);
        CHECK(std::fabs(static_cast<double>(column[n]) - (n + (n < 2 * count ? added : 0))) <= tolerance);
      }
    }
  }
}

TEST_CASE("batch: displacement and stress at far points are those of one point at a time") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Set& set : sets())
    for (int functions = 1; functions <= 3; ++functions)
      for (const bool displaced : {true, false}) {
        double worst_u = 0, worst_s = 0;
        int near_lanes = 0;
        for (int n = 0; n < 2000; ++n) {
          const double size = std::exp(8 * unit(random) - 6), turn = 7 * unit(random);
          const double x0 = 4 * unit(random) - 2, y0 = 4 * unit(random) - 2;
          FieldElement e;
          prepare(e.in, line(functions < 2 ? 2 : functions, x0, y0, x0 + size * std::cos(turn), y0 + size * std::sin(turn)),
                  functions, n % 2 ? 0.3 : 0.5, Quadrature::accurate);
          Complex t[4], u[4];
          for (int l = 0; l < 4; ++l) {
            t[l] = {2 * unit(random) - 1, 2 * unit(random) - 1};
            u[l] = {2 * unit(random) - 1, 2 * unit(random) - 1};
          }
          prepare_field(t, displaced ? u : nullptr, e);
          BatchFieldElement batch;
          REQUIRE(batch_field_element(e, batch));
          BatchPoints at;
          for (int s = 0; s < kBatch; ++s) {
            const double away = size * std::exp(8 * unit(random) + (n % 3 == 0 ? -1 : 1.5)), angle = 7 * unit(random);
            at.x[s] = x0 + away * std::cos(angle), at.y[s] = y0 + away * std::sin(angle);
            at.reference_x[s] = unit(random), at.reference_y[s] = unit(random);
          }
          BatchField out;
          {
            Traps traps;
            set.kernel->field(batch, at, out);
          }
          for (int s = 0; s < kBatch; ++s) {
            if (out.near[s] != 0.0) {
              CHECK(out.some_near);
              ++near_lanes;
              continue;
            }
            PointField one = {};
            add_field(e, {at.reference_x[s], at.reference_y[s]}, at.x[s], at.y[s], one);
            // Sizes of the terms: tractions ~ 1 on the length, displacements ~ 1 on the angle; one power of the
            // distance less in the stress.
            const double away = std::hypot(at.x[s] - x0, at.y[s] - y0), part = displaced ? size / away : 0.0;
            const double most_u = std::fmax(size, part) * e.in.k, most_s = (size + part) / away * e.in.k;
            worst_u = std::fmax(worst_u, std::hypot(out.ux[s] - one.u.re, out.uy[s] - one.u.im) / most_u);
            worst_s =
                std::fmax(worst_s, std::hypot(out.trace[s] - one.trace, std::hypot(out.deviator_re[s] - one.deviator.re,
                                                                                   out.deviator_im[s] - one.deviator.im)) /
                                       most_s);
          }
        }
        INFO(set.name << ", functions " << functions << ": u " << worst_u << ", stress " << worst_s);
        CHECK(worst_u < 2e-13); // of the size of the terms; 1e-10 is what interior points promise
        CHECK(worst_s < 2e-13);
        CHECK(near_lanes > 100);
      }
}
