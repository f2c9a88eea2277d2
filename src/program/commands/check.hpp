// `contact2d check DECK ...`.
#pragma once

#include "program/options.hpp"

namespace app {

// Reads and validates decks, one after another, and prints their sizes and the memory they need. Returns the exit status, of
// several decks the first that is not 0.
int check_decks(const Options& options);

} // namespace app
