// Load cases without loads, for example with a parameter of 0 in a sweep.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Does a load case apply any load or move anything?
bool acts(const Sketch& sketch, size_t load_case);

// The sketch without such load cases. Their supports move to the first remaining case.
Sketch without_idle_cases(Sketch sketch);

} // namespace sketch
