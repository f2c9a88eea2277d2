// The boundary and the inside at the last load as a legacy VTK file (ASCII, unstructured grid), for ParaView.
#pragma once

#include "report/drawn/scene.hpp"
#include "report/interior.hpp"

#include <string>

namespace app {

// A point per element end, a cell per element: a vertex (constant), a line, a quadratic edge or a cubic line. With lines
// of symmetry by images the whole boundary: the model's elements, without those on the lines, then its images; cell data
// `image` distinguishes them, 0 the model, 1, 2, 3 its images (two lines: beyond x, beyond y, beyond both).
// Point data: displacement and traction vectors, stress tensor, von Mises stress, status of the pair (-1: none, as on
// side 1 of a zone whose meshes do not match); cell data: body, element. The points of `interior` that do not lie
// outside follow with status -1, element 0 and image 0: grids as quadrilaterals where all four corners are there,
// everything else as vertices.
c2d_status append_vtk(std::string& out, const Scene& scene, const Interior& interior);

} // namespace app
