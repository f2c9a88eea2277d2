// ASCII DXF, of releases 12 to 2018.
#pragma once

#include "program/drawing/drawing.hpp"

#include <string_view>

namespace drawing {

bool is_dxf(std::string_view text); // or looks as if it were

// Lines, arcs, circles, polylines, ellipses and splines of the model that are to be seen, each with its layer. The notes count
// what was read, left out (and why) and repaired. Throws a Fault where the file as a whole cannot be read.
Drawing read_dxf(std::string_view text);

} // namespace drawing
