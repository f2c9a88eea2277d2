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

// Where pairs rub (Pair::law), but the contact system on the tape is that without friction, it is made anew with it; nothing
// stops that. Uses the phase area. Errors: the block store's.
c2d_status allow_friction(c2d_solver* solver);
// A saved state has been taken up: the contact system on the tape becomes that which it was made with. *again: the phase area
// is lost. Errors: the block store's.
c2d_status match_saved(c2d_solver* solver, bool* again);

} // namespace c2d
