// Recognises curves in a sequence of points.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

// Straight runs become lines, points that lie on one circle to round-off an arc, if neighbours are at most 52 degrees apart,
// other smooth runs splines; corners are where the way turns by more than 40 degrees. `closed`: it goes back to the first
// point, which stands there once.
std::vector<Curve> curves_of(const std::vector<Point>& points, bool closed, double size);

} // namespace drawing
