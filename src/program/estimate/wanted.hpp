// Stresses requested by a sketch: inside and along curves; at the end of the history, over all of it, or over its last cycle.
#pragma once

#include "program/estimate/error.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// The requests to solutions for these stresses.
void ask(const sketch::Sketch& sketch, Demand& demand);

// Their values on one mesh, without errors, in the same order on every mesh. Values of a cycle are missing at the end of the
// list if the history ended early.
std::vector<app::Stated> wanted_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial);

// The requested tolerance of a number of a contact or a body; NaN: it is not requested.
double tolerance_of(const sketch::Sketch& sketch, const app::Stated& number, const Trial& trial);

} // namespace estimate
