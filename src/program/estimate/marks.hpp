// Which elements of a mesh are to be bisected.
#pragma once

#include "post/stated.hpp"
#include "program/estimate/compare.hpp"
#include "program/sketch/refine.hpp"

namespace estimate {

// Where contact ends and slip begins at the turns of the loads, as places of side 2.
std::vector<sketch::Spot> edges_of(const Trial& trial);

// Elements whose shares are above those of a mesh whose distance and energy are `pressure` and `energy` with shares alike; the
// largest in any case.
sketch::Levels marks(const Distance& distance, double pressure, double energy);

// Does a number hang on one place: an edge of contact, a border of stick, the peak of a pressure, a stress?
bool is_place(const app::Stated& s);

// Beside that the elements at the places of numbers that are not met, and their neighbours.
void mark_places(const sketch::Sketch& sketch, const Trial& trial, const std::vector<app::Stated>& stated, sketch::Mesh& mesh,
                 sketch::Levels& levels);

} // namespace estimate
