#pragma once
// Rigid-body motions that no prescribed displacement prevents, found before anything is assembled (METHOD 7.3).
#include "memory/text.hpp"
#include "model/model.hpp"

namespace c2d {

// Fills Body::free_motions, free_motion and centre (middle of the body's bounding box) of body b. A motion is
// (ux, uy, w * length_unit): translation of the centre and rotation w, counter-clockwise. The prescribed
// components are rows acting on it; motions orthogonal to all rows are free. Rows within 1e-8 of the span of the others
// are dependent. Needs set_units.
void find_free_motions(const Model& m, int b);

// Appends "along y", "along (0.6, 0.8)" or "rotation about (x, y)"; motion as in Body::free_motion of body b.
void put_motion(Text& text, const Model& m, int b, const double motion[3]);

} // namespace c2d
