// Positions of bodies in a magnified deformed shape, such that gaps are magnified like displacements: closed
// pairs touch, open pairs stand apart, and initial overlaps of a press fit do not appear as gaps.
#pragma once

#include "report/drawn/scene.hpp"

#include <vector>

namespace app {

// Initial normal gaps of the pairs, and of the sides beside a zone, between a body and those that were placed before it, as
// vectors that move the body; a field over the plane that takes their values at the pairs and is smooth elsewhere; of a rigid
// body their mean.
class GapLift {
public:
  GapLift() = default;
  // Of the last state of the last coefficient.
  explicit GapLift(const Scene& scene);
  double largest() const { return largest_; }
  // Displacement of a point of a body per unit of magnification beyond 1.
  Point at(size_t body, Point p) const;

private:
  struct Source {
    Point at, by;
  };
  static std::vector<Source> beside(const Scene& scene, const ZoneScene& zone);
  static void move_as_rigid(std::vector<Source>& sources);
  void place(const Scene& scene, const std::vector<Source>& pairs);
  std::vector<std::vector<Source>> of_;     // per body
  std::vector<std::vector<Source>> beside_; // per zone
  double largest_ = 0.0;
};

} // namespace app
