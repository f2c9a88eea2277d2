// contact2d convert: a deck in the other form.
#pragma once

#include "program/options.hpp"

namespace app {

// Reads options.deck and writes it to options.output in the form asked for (options.convert_to; empty: the
// other one). Every number is read back as the same double, or nothing is written. Returns the exit status.
int convert_deck(const Options& options);

} // namespace app
