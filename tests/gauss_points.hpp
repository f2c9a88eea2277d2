#pragma once
// Gauss-Legendre points of any order as a reference, by Newton's method in extended precision.
#include "quadrature/gauss.hpp"

#include <cmath>
#include <map>
#include <vector>

namespace test {

inline std::vector<c2d::GaussPoint> make_gauss_points(int n) {
  std::vector<c2d::GaussPoint> points(static_cast<size_t>(n));
  const long double pi = std::acos(-1.0L);
  for (int i = 0; i < n; ++i) {
    long double x = -std::cos(pi * (i + 0.75L) / (n + 0.5L)), slope = 1;
    for (int turn = 0; turn < 100; ++turn) {
      long double before = 1, value = x;
      for (int k = 2; k <= n; ++k) {
        const long double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      const long double step = value / slope;
      x -= step;
      if (std::fabs(step) < 1e-19L) break;
    }
    points[static_cast<size_t>(i)] = {static_cast<double>(x), static_cast<double>(2 / ((1 - x * x) * slope * slope))};
  }
  return points;
}

// Point i = 0 ... n-1 from left to right.
inline c2d::GaussPoint reference_gauss_point(int n, int i) {
  static std::map<int, std::vector<c2d::GaussPoint>> rules;
  std::vector<c2d::GaussPoint>& rule = rules[n];
  if (rule.empty()) rule = make_gauss_points(n);
  return rule[static_cast<size_t>(i)];
}

} // namespace test
