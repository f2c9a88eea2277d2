// The result of mesh refinement as a text, stored beside the deck of its mesh.
#pragma once

#include "post/mesh_loop.hpp"

#include <string>

namespace estimate {

// Numbers keep all bits.
std::string text_of(app::MeshLoop loop);
// Reads the text; false if it is not such a text or incomplete: `out` is then undefined.
bool read_meshes(const std::string& text, app::MeshLoop& out);

} // namespace estimate
