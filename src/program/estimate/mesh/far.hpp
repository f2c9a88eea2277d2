// Elements of side 2 that never approach the other side. They are left out of the zone, so that all pairs are near the contact.
#pragma once

#include "program/estimate/trial.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// Marks them in a solved mesh, and so in finer meshes made from it. A side without any touching pair is not changed. False:
// there are none.
bool mark_far(const sketch::Sketch& sketch, const Trial& trial, sketch::Mesh& mesh);

// Did an element touch next to those left out? Then contact may extend into them.
bool is_cut_off(const Trial& trial, const sketch::Mesh& mesh);

} // namespace estimate
