// contact2d make: writes the deck of a family of problems.
#pragma once

#include "program/options.hpp"

namespace app {

// Returns the program's exit status.
int make_deck(const Options& options);

} // namespace app
