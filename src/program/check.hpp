// `contact2d check DECK`.
#pragma once

#include "program/options.hpp"

namespace c2d {

// Reads and validates the deck and prints its sizes and the memory it needs. Returns the exit status.
int check_deck(const Options& options);

} // namespace c2d
