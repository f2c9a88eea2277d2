// The element ends of a mesh, for pictures.
#pragma once

#include "post/mesh_loop.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

std::vector<app::MeshCurve> curves_of(const sketch::Mesh& mesh);

} // namespace estimate
