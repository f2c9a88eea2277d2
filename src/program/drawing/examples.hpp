// Example statements for the bodies of a drawing, with their names.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

// Statements of contacts, supports and loads for bodies and curves whose names are those of a sketch.
std::vector<std::string> examples_for(const std::vector<Body>& bodies);

} // namespace drawing
