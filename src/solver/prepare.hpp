#pragma once
// Assemble, eliminate, reduce.
#include "solver/solver.hpp"

namespace c2d {

// The model in state `model` becomes `prepared`; where only loads have changed and factors are kept, they go through those.
// Errors are recorded and returned; a store error breaks the solver.
c2d_status prepare(c2d_solver* solver);

// What the model alone decides of its preparation: how bodies are held, and which keep their equations. Uses the phase area.
void plan_bodies(c2d_solver* solver, const Model& model);
// Blocks of each tape but CONTROL, and bytes of data of the largest, as the bodies' plans cut them; their first blocks are set.
struct TapeShapes {
  uint64_t blocks[C2D_TAPES], data[C2D_TAPES];
};
TapeShapes shape_tapes(c2d_solver* solver, const Model& model);

} // namespace c2d
