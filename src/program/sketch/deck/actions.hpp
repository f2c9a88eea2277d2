// What is wrong with the statements of a sketch that act on its bodies, seen together.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Two statements that give the same, loads that no history applies, wanted points outside, and bodies that nothing holds.
std::vector<Fault> faults_of_actions(const Sketch& sketch);

} // namespace sketch
