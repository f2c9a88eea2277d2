// `contact2d run DECK`.
#pragma once

#include "program/options.hpp"

namespace app {

// Solves the deck and writes the outputs. Returns the exit status.
int run_deck(const Options& options);

} // namespace app
