// contact2d sketch: converts a drawing to a sketch.
#pragma once

#include "program/options.hpp"

namespace app {

// Reads the drawing options.deck and writes its sketch to options.output, with the statements of options.conditions where they
// are given. Returns the exit status.
int sketch_drawing(const Options& options);

} // namespace app
