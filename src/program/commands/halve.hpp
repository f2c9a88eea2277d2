// contact2d mesh --halve: a deck with every element cut in two.
#pragma once

#include "program/options.hpp"

namespace app {

// Reads options.deck, a deck or a sketch, and writes its halved deck to options.output. Returns the exit status.
int halve_deck(const Options& options);

} // namespace app
