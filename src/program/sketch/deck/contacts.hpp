// Facing parts of contacts and ties. Outlines are divided at their ends before meshing.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Finds the contacts of all interfaces and divides the outlines at their ends. Errors: two sides without facing parts.
std::vector<Fault> cut_contacts(Sketch& sketch);

} // namespace sketch
