// `contact2d check DECK`.
#pragma once

#include "program/options.hpp"

namespace app {

// Reads and validates the deck and prints its sizes and the memory it needs. Returns the exit status.
int check_deck(const Options& options);

} // namespace app
