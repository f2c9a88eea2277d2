// Where a block of a drawing is put: turned, scaled, perhaps mirrored.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

// p goes to `at` + scale * turn by `angle` of (p - base), which is mirrored across its x axis before if `mirrors`.
struct Placing {
  Point base, at;
  double scale = 1, angle = 0; // degrees
  bool mirrors = false;
  Point operator()(Point p) const;
};

Curve placed(Curve curve, const Placing& placing);

} // namespace drawing
