// The last cycle of a load history.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// The piece of the history, from 1, at whose end the last cycle begins: the last earlier piece that ended with the final load
// factors, to 1e-9 of the largest factor, with other factors in between. 0: there is no cycle; the unloaded initial state does
// not start one.
int cycle_start(const Sketch& sketch);

} // namespace sketch
