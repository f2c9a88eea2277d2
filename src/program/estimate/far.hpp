// Elements of side 2 that never come near the other side: they are left out of the contact, and pairs are made where it is.
#pragma once

#include "program/estimate/trial.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// Marks them in a mesh that was solved, and those of finer meshes made of it. A body that nothing touched is left as it is.
// False: there are none.
bool mark_far(const sketch::Sketch& sketch, const Trial& trial, sketch::Mesh& mesh);

// Did an element touch beside those that are left out? Then they may not be.
bool is_cut_off(const Trial& trial, const sketch::Mesh& mesh);

} // namespace estimate
