#pragma once
// A cylinder on a block, pressed and sheared in cycles: for tests of cycles of loads.
#include "many_bodies.hpp"

#include <cmath>

namespace cyclic {

constexpr double kA = 0.1, kMu = 0.3; // half width of the contact at P

// Ratio of a geometric series of `n` elements from `first` on that fill `length`.
inline double growth_of(double first, double length, int n) {
  double low = 1, high = 4;
  for (int i = 0; i < 100; ++i) {
    const double g = (low + high) / 2;
    double sum = 0, element = first;
    for (int k = 0; k < n; ++k) sum += element *= g;
    (sum < length ? low : high) = g;
  }
  return low;
}

// A cylinder, rigid or of the same material as the block, on a block of E* = 1 and nu = 2/7 with n elements on a. Load case 1
// presses them together by P, load case 2 pulls by P along the surface.
inline many::Model cylinder(int n, bool like = false) {
  many::Model m;
  m.cases = 2;
  m.friction = kMu;
  m.cycle_states = 30;
  const double nu = 2.0 / 7, e = 1 - nu * nu, half = 1.4 * kA, width = 10 * kA;
  const int contact = static_cast<int>(std::lround(2 * half / kA * n)), side = 10;
  const double g = growth_of(kA / n, width - half, side);
  const many::Body block = many::polygon({{-width, -2 * width, 5},
                                          {width, -2 * width, 6},
                                          {width, 0, side, 1 / g},
                                          {half, 0, contact},
                                          {-half, 0, side, g},
                                          {-width, 0, 6}},
                                         like ? 2 * e : e, nu);
  many::Body upper = many::polygon({{-width, 0, side, 1 / g},
                                    {-half, 0, contact},
                                    {half, 0, side, g},
                                    {width, 0, 6},
                                    {width, 2 * width, 5},
                                    {-width, 2 * width, 6}},
                                   like ? 2 * e : e, nu);
  for (size_t i = 0; i < upper.xy.size(); i += 2)
    if (upper.xy[i + 1] == 0) upper.xy[i + 1] = std::fmin(upper.xy[i] * upper.xy[i] / 2, 0.05 + std::fabs(upper.xy[i]) / 50);
  upper.rigid = like ? 0 : 1;
  const int32_t lower = m.add(block), top = m.add(upper);
  m.join(C2D_ZONE_MATCHING, lower, 4, top, 2);
  if (like) m.set(top, 5, many::end_of(many::kHeld));
  many::Platen& platen = m.move(lower, 1);
  platen.is_free[2] = 0;
  platen.load[1] = platen.second_load[0] = std::acos(-1.0) / 400;
  platen.point[1] = -2 * width;
  return m;
}

} // namespace cyclic
