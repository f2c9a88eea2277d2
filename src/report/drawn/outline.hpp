// The curves that bound a body, whole: of a symmetric model with its images.
#pragma once

#include "report/drawn/scene.hpp"

namespace app {

// Fills curves, corners and normals; `nodes` are the geometry nodes of the body, out.displacement its results
// or empty.
c2d_status trace_outline(c2d_solver* solver, const Summary& summary, int32_t body, const std::vector<Point>& nodes,
                         BodyScene& out);

} // namespace app
