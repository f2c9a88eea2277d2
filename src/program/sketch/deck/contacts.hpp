// Where the sides of contacts and ties can face and touch: outlines are cut there before anything is meshed.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Finds the contacts of all interfaces and cuts the outlines where they end. Faults where nothing of two sides faces.
std::vector<Fault> cut_contacts(Sketch& sketch);

} // namespace sketch
