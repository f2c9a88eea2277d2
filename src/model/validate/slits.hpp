#pragma once
// Slits in one body that are narrower than the elements beside them. The equations of two nodes across a slit differ by what
// the slit's faces move apart, and those of linear functions mostly by the kinks of that motion at the nodes: its kinks are
// suppressed, and the body is too stiff. Functions with a node within the element lose nothing.
#include "model/model.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

// Warning: C2D_WARN_SLIT, one per body, for the element longest compared with the width; linear functions only. Faces that
// are in contact, or may be (one zone of the body with itself), make no slit. Needs zones and lines of symmetry.
void warn_slits(const Model& m, Reporter& reporter);

} // namespace c2d
