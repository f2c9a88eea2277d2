// Messages about a mesh that the program made from a sketch, in words of the drawing.
#pragma once

#include "post/zone_line.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

// Does a warning of the library speak of the mesh that was made, and not of the model? Stated errors tell what that matters.
bool is_about_mesh(const c2d_error& warning);

// Does a warning say that contact reaches the end of a zone where surfaces end, or where another zone goes on?
bool is_at_natural_end(const c2d_error& warning, const std::string& deck);

// The deck without what it says of ends that the loop over meshes cut off: for one whose contact stays away from them.
std::string without_cut_ends(std::string deck);

// Elements, nodes and pairs of the text become curves of bodies, which the deck lists beside its numbers.
std::string in_words_of_drawing(const std::string& text, const std::string& deck);

// Marks the zones whose sides a made deck has in another order than the statement of the sketch.
void mark_turned(const std::string& deck, std::vector<ZoneLine>& lines);

} // namespace app
