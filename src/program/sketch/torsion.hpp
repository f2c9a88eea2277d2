// Load cases round the axis of bodies of revolution: taken out of the load cases in the plane of the section, and checked.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Moves the cases with loads round the axis, and their part of the history, to sketch.torsion. Faults: loads of both kinds in
// one case, a history in which they do not come last, a body that nothing keeps from turning.
std::vector<Fault> take_torsion(Sketch& sketch);

double friction_round(const Interface& interface);

} // namespace sketch
