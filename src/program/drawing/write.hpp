// The sketch of a drawing.
#pragma once

#include "program/drawing/conditions.hpp"
#include "program/drawing/drawing.hpp"

namespace drawing {

// `name` is that of the file of the drawing. Names that a sketch cannot have are changed, which the notes tell. Throws a Fault
// if a material is that of no body.
std::string sketch_of(Drawing drawing, const std::string& name, const Conditions& conditions);

} // namespace drawing
