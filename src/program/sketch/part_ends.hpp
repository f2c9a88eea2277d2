// Why parts that face each other end where they do, for a contact that reaches it.
#pragma once

#include "program/sketch/facing.hpp"

namespace sketch {

// At the first or the last of the run's points. Empty: at a corner or a line of symmetry, where contact itself ends.
std::string end_of_part(const Sketch& sketch, const FacingRun& run, bool last);

} // namespace sketch
