// From the text of a drawing to bodies with outlines.
#pragma once

#include "program/drawing/drawing.hpp"

#include <string_view>

namespace drawing {

// DXF or MSH, by what it begins with. Ends that are not further apart than `join` are one; 0: kJoin of the drawing's size.
// `notes` lists the entities left out, also if no outline is closed. Throws a Fault.
Drawing read_drawing(std::string_view text, double join, std::vector<std::string>& notes);

} // namespace drawing
