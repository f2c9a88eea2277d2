// The last cycle of a load history.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// The piece of the history, from 1, at whose end the last cycle begins: the last piece that ended with the load factors of
// the history's end, to 1e-9 of the largest, with other factors in between. 0: there is no cycle; the beginning, at which
// nothing has been loaded yet, is not the start of one.
int cycle_start(const Sketch& sketch);

} // namespace sketch
