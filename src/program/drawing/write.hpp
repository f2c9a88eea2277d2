// The sketch of a drawing.
#pragma once

#include "program/drawing/conditions.hpp"
#include "program/drawing/drawing.hpp"

namespace drawing {

// `name`: the file of the drawing. `notes`: those of the drawing and the changes for the sketch, such as invalid names; they
// form the head of the sketch. Throws a Fault if a material belongs to no body.
std::string sketch_of(Drawing drawing, const std::string& name, const Conditions& conditions,
                      std::vector<std::string>* notes = nullptr);

} // namespace drawing
