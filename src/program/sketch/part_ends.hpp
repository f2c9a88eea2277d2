// The reason why a facing part ends where it does. It is reported if the contact reaches that end.
#pragma once

#include "program/sketch/facing.hpp"

namespace sketch {

// For the first or the last point of the run. Empty at a corner or a line of symmetry, where the surface itself ends.
std::string end_of_part(const Sketch& sketch, const FacingRun& run, bool last);

} // namespace sketch
