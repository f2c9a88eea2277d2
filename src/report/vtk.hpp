// The boundary at the last load as a legacy VTK file (ASCII, unstructured grid), for ParaView.
#pragma once

#include "report/scene.hpp"

#include <string>

namespace app {

// A point per element end, a cell per element: a vertex (constant), a line, a quadratic edge or a cubic line. With lines
// of symmetry by images the whole boundary: the model's elements, without those on the lines, then its images; cell data
// `image` tells them apart, 0 the model, 1, 2, 3 its images (two lines: beyond x, beyond y, beyond both).
// Point data: displacement and traction vectors, stress tensor, status of the pair (-1: none, as on body 1 of a zone whose
// meshes do not match); cell data:
// body, element. `interior` (x, y and C2D_POINT_FIELDS numbers per point, with its body) follows as vertices
// with status -1 and element 0.
struct InteriorPoint {
  int32_t body;
  double x, y;
  double values[C2D_POINT_FIELDS];
};
c2d_status append_vtk(std::string& out, const Scene& scene, const std::vector<InteriorPoint>& interior);

} // namespace app
