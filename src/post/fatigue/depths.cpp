// Integrals over depths by Gauss's rule. A stress below an edge of contact changes as the root of the depth: the depth is taken
// as the square of the variable.
#include "post/fatigue/depths.hpp"

#include <cmath>

namespace app {
namespace {

constexpr int kDepths = 24;

// Places and weights of Gauss's rule from 0 to 1: the zeros of the Legendre polynomial by Newton's steps.
std::vector<DepthWeight> unit_rule() {
  const double pi = std::acos(-1.0);
  std::vector<DepthWeight> out;
  for (int i = kDepths; i-- > 0;) {
    double x = std::cos(pi * (i + 0.75) / (kDepths + 0.5)), slope = 1;
    for (int step = 0; step < 8; ++step) {
      double before = 1, now = x;
      for (int k = 2; k <= kDepths; ++k) {
        const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now, now = next;
      }
      slope = kDepths * (x * now - before) / (x * x - 1);
      x -= now / slope;
    }
    out.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return out;
}

} // namespace

std::vector<DepthWeight> mean_over_depth(double length) {
  std::vector<DepthWeight> out = unit_rule();
  for (DepthWeight& d : out) d.weight *= 2 * d.depth, d.depth *= length * d.depth;
  return out;
}

// K = 2 / sqrt(pi a) times the integral of s(x) (1 + F(x/a)) / sqrt(1 - (x/a)^2) over the crack (Hartranft and Sih 1973; Tada,
// Paris and Irwin, The Stress Analysis of Cracks Handbook). With x = a sin t the root vanishes.
std::vector<DepthWeight> edge_crack(double length) {
  const double pi = std::acos(-1.0);
  std::vector<DepthWeight> out = unit_rule();
  for (DepthWeight& d : out) {
    const double part = std::sin(pi / 2 * d.depth * d.depth), square = part * part;
    const double f = (1 - square) * (0.2945 + square * (-0.3912 + square * (0.7685 + square * (-0.9942 + square * 0.5094))));
    d.weight *= 2 * std::sqrt(length / pi) * (1 + f) * pi * d.depth;
    d.depth = length * part;
  }
  return out;
}

} // namespace app
