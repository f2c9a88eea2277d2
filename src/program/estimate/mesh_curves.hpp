// The element ends of a mesh, for pictures.
#pragma once

#include "program/sketch/mesh.hpp"
#include "report/stated.hpp"

namespace estimate {

std::vector<app::MeshCurve> curves_of(const sketch::Mesh& mesh);

} // namespace estimate
