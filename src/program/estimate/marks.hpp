// Selects the elements of a mesh to be bisected.
#pragma once

#include "post/stated.hpp"
#include "program/estimate/compare.hpp"
#include "program/sketch/refine.hpp"

namespace estimate {

// Contact edges and stick borders at the turns of the loads, as places on side 2.
std::vector<sketch::Spot> edges_of(const Trial& trial);

// Elements with shares above those of a mesh of equal shares with the distance `pressure` and the energy difference `energy`;
// the element with the largest share always. Outside contacts an element at the end of a curve whose share is far above that of
// the next one lies beside a singular point, and is graded toward it.
sketch::Levels marks(const sketch::Mesh& mesh, const Distance& distance, double pressure, double energy);

// Does a number belong to one place: a contact edge, a stick border, a peak pressure, a stress?
bool is_place(const app::Stated& s);

// Also marks the elements at the places of numbers not yet met, and their neighbours.
void mark_places(const sketch::Sketch& sketch, const Trial& trial, const std::vector<app::Stated>& stated, sketch::Mesh& mesh,
                 sketch::Levels& levels);

} // namespace estimate
