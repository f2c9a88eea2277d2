// Points of a body's drawn outline beside a point of contact: the outward normal and the displacement there.
#pragma once

#include "report/drawn/scene.hpp"

namespace app {

struct SurfacePoint {
  Point normal; // outward, of length 1; 0 where the body has no outline
  Point moved;  // displacement
};

// The point nearest to `p` on the elements of a side; of a side without elements, on the whole outline.
SurfacePoint surface_at(const BodyScene& body, const c2d_side& side, Point p);

} // namespace app
