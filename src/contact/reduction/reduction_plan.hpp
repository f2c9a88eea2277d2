#pragma once
// Which bodies keep their equations in the reduction (METHOD 10).
#include "model/model.hpp"

namespace c2d {

// Of two bodies that meet, one at most keeps its equations, for its displacements are those of the other and the pairs'
// motions. The others' surfaces are solved for: costs the more, and digits where a body is slender and floats, since it bends
// under its own tractions by many times what it gives way locally. So those that float keep their equations first, then those
// that are by far more slender, then soft ones. Of a slender body that cannot keep them the displacements become unknowns
// themselves, and its equations further rows. Fills Body::keeps_equations, Body::first_border and head->border.
void plan_reduction(const Model& m);

} // namespace c2d
