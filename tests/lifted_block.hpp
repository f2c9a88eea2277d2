// A block that is pressed onto another, lifted from it and put back: models of tests of what contact lets go.
#pragma once

#include "contact2d.h"
#include "dice.hpp"
#include "paths.hpp"
#include "problem.hpp"
#include "shell.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace lifted {

using namespace problem;

// A block on a wider one that is held below, with `gap` between them. Case 1 moves the block's top down by 0.01 and leaves
// it free sideways; case 2 pulls its right side by 10.
inline Problem block(int32_t elements, double mu, double gap = 0.0) {
  Problem p;
  p.bodies.resize(2);
  add_polygon(p.bodies[0], {{0, -2, 3}, {5, -2, 2}, {5, 0, 2}, {4, 0, elements}, {0, 0, 2}});
  add_polygon(p.bodies[1], {{0, gap, elements}, {4, gap, 2}, {4, gap + 2, 3}, {0, gap + 2, 2}});
  set_ends(p, 1, [](double, double y, double, double ny, End& end) {
    if (y < -1.99) end.codes[2] = end.codes[3] = 0;
    if (ny < -0.5) end.codes[0] = end.codes[1] = 1;
  });
  p.bodies[0].second_case = p.bodies[0].ends;
  set_ends(p, 2, [&](double, double y, double, double ny, End& end) {
    if (y > gap + 1.99) end.codes[3] = 0, end.values[3] = -0.01;
    if (ny > 0.5) end.codes[1] = 1;
  });
  p.bodies[1].second_case = p.bodies[1].ends;
  for (End& end : p.bodies[1].second_case) end.values[3] = 0;
  for (int32_t e = elements + 1; e <= elements + 2; ++e)
    for (int32_t l = 1; l <= 2; ++l) p.bodies[1].second_case[static_cast<size_t>((e - 1) * 2 + l - 1)].values[0] = 10;
  problem::Zone zone = problem::Zone();
  zone.pairs = elements + 1, zone.elements = elements;
  zone.first_element[0] = 8, zone.last_element[0] = 7 + elements, zone.first_node[0] = 8, zone.last_node[0] = 8 + elements;
  zone.first_element[1] = elements, zone.last_element[1] = 1, zone.first_node[1] = elements + 1, zone.last_node[1] = 1;
  p.zones = {zone};
  p.friction = {mu};
  return p;
}

// Both seats alike by h sin(k x), the upper one rounder by d (x - 1.3)^2, the upper block pressed slantwise.
inline Problem waved(Problem p, double h, double k, double d, double slant) {
  for (size_t b = 0; b < 2; ++b)
    for (size_t i = 0; i + 1 < p.bodies[b].xy.size(); i += 2) {
      const double x = p.bodies[b].xy[i];
      double& y = p.bodies[b].xy[i + 1];
      if (std::fabs(y) > 0.01 || x > 4.001) continue;
      y += h * std::sin(k * x) + (b == 1 ? d * (x - 1.3) * (x - 1.3) : 0.0);
    }
  Body& upper = p.bodies[1];
  for (size_t i = 0; i < upper.ends.size(); ++i) {
    const size_t node = (i / 2 + i % 2) % (upper.xy.size() / 2);
    upper.ends[i].values[3] *= 1 + slant * (upper.xy[2 * node] - 2) / 2;
  }
  return p;
}

// Pressed, sheared, lifted, pressed again: much of it with pairs that slide while they hardly carry anything.
inline Problem drawn(uint64_t seed) {
  random_decks::Dice dice(seed * 7919);
  const int32_t elements = dice.whole(1, 7);
  const double mu = dice.between(0.05, 1.5), gap = dice.chance(0.2) ? dice.between(0.0005, 0.003) : 0.0;
  Problem p = block(elements, mu, gap);
  for (Body& body : p.bodies) body.youngs_modulus = dice.power(2, 4);
  const double h = dice.chance(0.5) ? 0 : dice.between(-0.2, 0.3), k = dice.between(0.5, 1.5);
  const double d = dice.chance(0.5) ? 0 : dice.power(-4, -2);
  p = waved(p, h, k, d, dice.chance(0.5) ? 0 : dice.between(-0.3, 0.3));
  const Path sheared{1, dice.between(0.3, 1), dice.chance(0.5) ? dice.between(0, 0.02) : 0};
  const double lifted = -dice.between(0.2, 1), again = dice.between(0.2, 1);
  return with_paths(p, {{1, 1, 0}, sheared, {1, 0.1, 0}, {1, lifted, 0}, {1, again, 0}, {1, dice.chance(0.5) ? 0.0 : -0.5, 0}});
}

inline double sideways(const Step& s, int pair) { return s.at(pair, C2D_UT2) - s.at(pair, C2D_UT1); }
inline double mean_sideways(const Step& s) {
  double sum = 0;
  for (int i = 0; i < s.pairs(); ++i) sum += sideways(s, i) / s.pairs();
  return sum;
}
inline bool no_force(const Step& s) {
  for (int i = 0; i < s.pairs(); ++i)
    if (s.at(i, C2D_TN) != 0 || s.at(i, C2D_TT) != 0 || static_cast<int>(s.at(i, C2D_STATUS)) != C2D_OPEN) return false;
  return true;
}
inline double tight() { return sizeof(double) == 8 ? 1e-9 : 1e-3; }

inline const c2d_error* told(const Result& r) {
  for (const c2d_error& e : r.told)
    if (e.status == C2D_WARN_UNDEFINED_PLACE) return &e;
  return nullptr;
}
inline std::string hard(const std::string& name) {
  return test::read_file(paths::root() + "/tests/data/hard/" + name + ".dat");
}

} // namespace lifted
