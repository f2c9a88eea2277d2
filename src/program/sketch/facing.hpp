// Finds the parts of two chains of curves that face each other, from the shapes alone.
#pragma once

#include "program/sketch/shapes/chain.hpp"

namespace sketch {

// A point of the first chain and the facing point of the second.
struct FacingPoints {
  double length[2] = {0, 0}; // along the outlines, beyond the total length of a closed one at its start; increasing on chain 0
  Point at;                  // on the first
  Point normal[2];
  double gap = 0; // below 0: an overlap
};

// Consecutive pairs of facing points: parts of two chains that may touch.
struct FacingRun {
  const Chain* chain[2];
  std::vector<FacingPoints> points;
  bool ring = false;   // the whole of a closed chain
  double weight = 0.5; // m of METHOD 8.3 by which it was found
  double low(size_t side) const { return side == 0 ? points.front().length[0] : points.back().length[1]; }
  double high(size_t side) const { return side == 0 ? points.back().length[0] : points.front().length[1]; }
  double length(size_t side) const { return high(side) - low(side); }
};

struct FacingLimits {
  double overlap = 0;                          // the largest overlap that still counts as touching
  double clear = 0;                            // gaps below this are not checked for curves in between
  std::vector<std::pair<Point, Point>> others; // chords of all other curves
};

// Points a and b face each other if b - a is parallel to m n_a - (1 - m) n_b (METHOD 8.3), each is the nearest point facing
// the other, and no other curve lies between them. The weight m follows from the mean curvatures of the two parts.
std::vector<FacingRun> facing_runs(const Chain& a, const Chain& b, const FacingLimits& limits);

// Finds a run anew within its ends until its weight m agrees with its mean curvatures. False: there is no such part; the
// surfaces are then farther apart than their radii of curvature, where the points that face each other depend on m.
bool agree_with_curvatures(FacingRun& run, const FacingLimits& limits);

// The smallest angle in degrees between a normal of one chain and the reversed normal of the other, corners excluded.
double least_inclination(const Chain& a, const Chain& b);

} // namespace sketch
