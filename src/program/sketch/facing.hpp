// Which parts of two chains of curves face each other, from the shapes alone.
#pragma once

#include "program/sketch/chain.hpp"

namespace sketch {

// A point of one chain and the one of the other that faces it.
struct FacingPoints {
  double length[2] = {0, 0}; // along the outlines, beyond their ends where a closed one is passed; rising on the first chain
  Point at;                  // on the first
  Point normal[2];
  double gap = 0; // below 0: an overlap
};

// A run of them: parts of two chains that may touch.
struct FacingRun {
  const Chain* chain[2];
  std::vector<FacingPoints> points;
  bool ring = false; // all round a closed chain
  double low(size_t side) const { return side == 0 ? points.front().length[0] : points.back().length[1]; }
  double high(size_t side) const { return side == 0 ? points.back().length[0] : points.front().length[1]; }
  double length(size_t side) const { return high(side) - low(side); }
};

struct FacingLimits {
  double overlap = 0;                          // that still counts as touching
  double clear = 0;                            // gaps below are not asked for what lies between
  std::vector<std::pair<Point, Point>> others; // chords of all other curves
};

// Points a and b face each other where b - a is parallel to m n_a - (1 - m) n_b (METHOD 8.3), with m from how much the runs
// themselves turn; where each is the nearest of all that face the other, and nothing lies between.
std::vector<FacingRun> facing_runs(const Chain& a, const Chain& b, const FacingLimits& limits);

// The least angle in degrees between one chain's normals and the opposite of the other's, corners aside.
double least_inclination(const Chain& a, const Chain& b);

} // namespace sketch
