// Load cases whose loads move: each of their positions is a load case, and one fades into the next.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

bool has_moving_loads(const Sketch& sketch);

// The sketch with a load case for each position. A piece of the history in which loads move is one piece and one increment
// from each position to the next.
Sketch with_positions(const Sketch& sketch);

// The same moving loads with twice as many positions.
Sketch with_twice_the_positions(Sketch sketch);

// Gives the moving loads of a sketch as many positions as those of another, drawn by the same statements.
void take_positions(Sketch& to, const Sketch& from);

// Errors of the statements of moving cases: what cannot move, leaves its curves or its body, or never moves.
std::vector<Fault> faults_of_moving_loads(const Sketch& sketch);

} // namespace sketch
