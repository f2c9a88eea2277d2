// Stresses that a sketch wants: inside, and along curves; at the end of the history, over all of it, over its last cycle.
#pragma once

#include "program/estimate/error.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// What trials are to bring for the stresses that are wanted.
void ask(const sketch::Sketch& sketch, Demand& demand);

// Their values of one mesh, without errors, in an order that is the same on every mesh; those of a cycle are missing at its end
// where the history ended early.
std::vector<app::Stated> wanted_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial);

} // namespace estimate
