// How a deformed shape is drawn: displacements and gaps times one factor, the largest of 1, 2, 5, 10, ... at which bodies that
// touch are drawn touching, and none is drawn over another.
#pragma once

#include "report/drawn/axes.hpp"
#include "report/pictures/gap_lift.hpp"

#include <functional>
#include <vector>

namespace app {

class Deformation {
public:
  Deformation() = default;
  Deformation(const GapLift* lift, double factor, Point reference) : lift_(lift), factor_(factor), reference_(reference) {}
  double factor() const { return factor_; }
  // A point of a body with its displacement, and the same relative to a motion that all bodies share.
  Point place(size_t body, Point at, Point displacement) const;
  Outlines outline(const BodyScene& shape, size_t body) const;
  // Part of a point's drawn displacement that no displacement of the body explains: initial gaps, magnified.
  Point lifted(size_t body, Point at) const;

private:
  const GapLift* lift_ = nullptr; // null: initial gaps are drawn to scale
  double factor_ = 1.0;
  Point reference_; // displacement that is not drawn
};

// Shows a deformation; a view that does not depend on it is given as such.
using ViewOf = std::function<Chart(const Deformation&)>;

// The largest factor up to `wanted`. `reference`: see above.
Deformation choose_deformation(const Scene& scene, const GapLift& lift, double wanted, Point reference, const ViewOf& view);

// The largest of ... 1, 2, 5, 10 ... up to `wanted`.
double round_below(double wanted);
// Such a number, at least 1: displacements of this size are drawn as a `share` of the size of the picture.
double wanted_factor(double size, double displacement, double share);

// How deep, in pixels, one set of closed curves reaches into another, as far as that is within the box.
double depth_of_overlap(const Outlines& a, const Outlines& b, const Box& box);

// "to scale", "displacements and gaps x 20".
std::string scale_text(const Deformation& deformation);

} // namespace app
