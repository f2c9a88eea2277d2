// Checks the supports, loads and requests of a sketch against each other.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Errors: contradicting statements, loads without effect, points outside the material, and unsupported bodies.
std::vector<Fault> faults_of_actions(const Sketch& sketch);

} // namespace sketch
