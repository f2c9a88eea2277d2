#include "gauss_points.hpp"

#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

using namespace c2d;

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr int kOrders[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20};

} // namespace

TEST_CASE("Gauss-Legendre rules integrate every even power they must, with positive weights inside [-1,1]") {
  for (const int n : kOrders) {
    const GaussRule rule = gauss_legendre(n);
    REQUIRE(rule.n == n);
    for (int k = 0; k <= 2 * n - 1; ++k) {
      long double sum = 0;
      for (int i = 0; i < n; ++i) {
        const GaussPoint p = gauss_point(rule, i);
        sum += p.w * powl(p.x, k);
      }
      const double exact = k % 2 == 0 ? 2.0 / (k + 1) : 0.0;
      // Rounding the points moves x^k by k eps x^k at most, each weight by eps/2.
      CHECK(std::fabs(static_cast<double>(sum) - exact) <= 2 * kEps);
    }
    for (int i = 0; i < n; ++i) {
      const GaussPoint p = gauss_point(rule, i), q = gauss_point(rule, n - 1 - i);
      CHECK(p.w > 0.0);
      CHECK(std::fabs(p.x) < 1.0);
      CHECK(p.x == -q.x);
      CHECK(p.w == q.w);
      if (i > 0) CHECK(p.x > gauss_point(rule, i - 1).x);
      const GaussPoint r = test::reference_gauss_point(n, i);
      CHECK(std::fabs(p.x - r.x) <= kEps);
      CHECK(std::fabs(p.w - r.w) <= 4 * kEps);
    }
    // Degree 2n is not integrated exactly: the rule is not a longer one by mistake.
    if (n <= 12) {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += gauss_point(rule, i).w * std::pow(gauss_point(rule, i).x, 2 * n);
      CHECK(std::fabs(sum - 2.0 / (2 * n + 1)) > 1e-9);
    }
  }
  for (const int n : {-1, 0, 7, 9, 11, 13, 19, 21, 24, 32}) CHECK(gauss_legendre(n).n == 0);
}

TEST_CASE("logarithmic rules integrate x^k ln(1/x) = 1/(k+1)^2") {
  for (const int n : {2, 4, 10, 16}) {
    const LogRule rule = log_gauss(n);
    REQUIRE(rule.n == n);
    for (int k = 0; k <= 2 * n - 1; ++k) {
      long double sum = 0;
      for (int i = 0; i < n; ++i) sum += rule.w[i] * powl(rule.x[i], k);
      CHECK(std::fabs(static_cast<double>(sum) * (k + 1) * (k + 1) - 1.0) <= 2 * (k + 2) * kEps);
    }
    for (int i = 0; i < n; ++i) {
      CHECK(rule.w[i] > 0.0);
      CHECK(rule.x[i] > (i > 0 ? rule.x[i - 1] : 0.0));
      CHECK(rule.x[i] < 1.0);
    }
  }
  CHECK(log_gauss(3).n == 0);
}

TEST_CASE("a pole of order two just outside the prescribed ellipse is integrated to the tolerance") {
  for (const int n : {3, 4, 6, 8, 12, 16, 20}) {
    for (const int degree : {0, 1, 2}) {
      const double z = gauss_semi_axis(n, degree, 1e-10);
      double sum = 0, scale = 0; // x^degree/(z-x)^2, reference: 32 points
      for (int i = 0; i < n; ++i) {
        const GaussPoint p = gauss_point(gauss_legendre(n), i);
        sum += p.w * std::pow(p.x, degree) / ((z - p.x) * (z - p.x));
      }
      double exact = 0;
      for (int i = 0; i < 32; ++i) {
        const GaussPoint p = test::reference_gauss_point(32, i);
        exact += p.w * std::pow(p.x, degree) / ((z - p.x) * (z - p.x));
        scale += p.w / ((z - p.x) * (z - p.x));
      }
      CHECK(std::fabs(sum - exact) <= 1e-10 * scale);
    }
  }
  CHECK(gauss_semi_axis(1, 1, 1e-10) == 0.0);
  CHECK(gauss_semi_axis(20, 1, 1e-13) < gauss_semi_axis(10, 1, 1e-13));
}

TEST_CASE("shape functions are Lagrange polynomials on equally spaced nodes") {
  for (int nodes = 1; nodes <= 4; ++nodes) {
    double N[4], dN[4], up[4], down[4];
    for (int m = 0; m < nodes; ++m) {
      shape(nodes, node_eta(nodes, m), N);
      for (int l = 0; l < nodes; ++l) CHECK(std::fabs(N[l] - (l == m ? 1.0 : 0.0)) <= 4 * kEps);
    }
    CHECK(node_eta(nodes, 0) == (nodes == 1 ? 0.0 : -1.0));
    for (const double eta : {-0.9, -0.3, 0.0, 0.41, 1.0}) {
      shape(nodes, eta, N);
      shape_derivative(nodes, eta, dN);
      const double step = 1e-5;
      shape(nodes, eta + step, up);
      shape(nodes, eta - step, down);
      double sum = 0, slope = 0;
      for (int l = 0; l < nodes; ++l) {
        // Central difference: error step^2/6 times the third derivative (at most 6 * 27/16).
        CHECK(std::fabs((up[l] - down[l]) / (2 * step) - dN[l]) < 1e-9);
        const double* c = shape_coefficients(nodes, l);
        double value = 0;
        for (int k = nodes - 1; k >= 0; --k) value = value * eta + c[k];
        CHECK(std::fabs(value - N[l]) <= 8 * kEps);
        sum += N[l];
        slope += dN[l];
      }
      CHECK(std::fabs(sum - 1.0) <= 4 * kEps);
      CHECK(std::fabs(slope) <= 32 * kEps);
    }
  }
}
