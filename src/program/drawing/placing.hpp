// Placement of a block: scaled along its own axes, mirrored, rotated, shifted.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

using sketch::Motion;

// The point `base` goes to `at`; scales are along the axes before the turn by `angle` degrees, below 0 they mirror.
Motion placing(Point base, Point at, double scale_x, double scale_y, double angle);
Motion after(const Motion& second, const Motion& first);

// Lines, arcs and ellipses exactly: an arc whose scales differ becomes an ellipse. Splines through their points that are moved.
Curve placed(Curve curve, const Motion& motion);

} // namespace drawing
