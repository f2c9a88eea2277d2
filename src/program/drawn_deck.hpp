// A sketch where a deck may stand: its faults told at their places, its deck put in its place.
#pragma once

#include "program/deck_file.hpp"
#include "program/options.hpp"

namespace app {

// If the text of `deck` is a sketch it is replaced by the sketch's own deck, for the parameters `settings` ("mu=0.3").
// Prints what is wrong and returns the program's exit status, 0 to go on.
int take_sketch(DeckFile& deck, const std::vector<std::string>& settings);

// The command mesh: writes the deck of a sketch. Returns the exit status.
int write_mesh(const Options& options);

} // namespace app
