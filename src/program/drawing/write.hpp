// The sketch of a drawing.
#pragma once

#include "program/drawing/conditions.hpp"
#include "program/drawing/drawing.hpp"

namespace drawing {

// `name` is that of the file of the drawing. `notes`: those of the drawing, and what was changed to write it, such as names
// that a sketch cannot have; they stand at the head of the sketch. Throws a Fault if a material is that of no body.
std::string sketch_of(Drawing drawing, const std::string& name, const Conditions& conditions,
                      std::vector<std::string>* notes = nullptr);

} // namespace drawing
