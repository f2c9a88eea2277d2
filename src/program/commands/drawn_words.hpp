// Messages about a mesh that the program made from a sketch, in words of the drawing.
#pragma once

#include "post/zone_line.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

// Does a warning of the library concern the generated mesh and not the model? Stated errors show its effect.
bool is_about_mesh(const c2d_error& warning);

// Does a warning report contact at the end of a zone where the surfaces end or another zone continues?
bool is_at_natural_end(const c2d_error& warning, const std::string& deck);

// The deck without its notes on zone ends cut by mesh refinement, for a solution whose contact stays away from them.
std::string without_cut_ends(std::string deck);

// Replaces elements, nodes and pairs in the text by curves of bodies, from the list in the deck.
std::string in_words_of_drawing(const std::string& text, const std::string& deck);

// Marks the zones whose sides have another order in the generated deck than in the sketch, and the fixed points of lengths
// along the second sides of their statements.
void take_statements(const std::string& deck, std::vector<ZoneLine>& lines);

} // namespace app
