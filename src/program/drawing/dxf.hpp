// ASCII DXF, of releases 12 to 2018.
#pragma once

#include "program/drawing/drawing.hpp"

#include <string_view>

namespace drawing {

bool is_dxf(std::string_view text); // or looks as if it were

// Lines, arcs, circles, polylines, ellipses and splines of the model, each with its layer; what is passed over is counted in
// the notes. Throws a Fault.
Drawing read_dxf(std::string_view text);

} // namespace drawing
