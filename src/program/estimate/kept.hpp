// What a loop over meshes found, as a text that is kept beside the deck it made.
#pragma once

#include "post/stated.hpp"

#include <string>

namespace estimate {

// Every number to its last bit.
std::string text_of(app::MeshLoop loop);
// What the text was made of; false if it is no such text, or not a whole one: then `out` has no meaning.
bool read_meshes(const std::string& text, app::MeshLoop& out);

} // namespace estimate
