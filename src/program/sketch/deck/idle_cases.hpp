// Load cases that load nothing, as with a parameter of 0 in a sweep.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Does a load case apply any load or move anything?
bool acts(const Sketch& sketch, size_t load_case);

// The sketch without the load cases that do not; what they hold is held by the first that is left.
Sketch without_idle_cases(Sketch sketch);

} // namespace sketch
