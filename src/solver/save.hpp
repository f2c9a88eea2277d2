#pragma once
// Saved states (store/FORMAT.md). A crash in the middle of saving leaves the state saved before.
#include "solver/solver.hpp"

namespace c2d {

// The port has a block store. Errors are told and recorded; a store error breaks the solver.
c2d_status save_state(c2d_solver* solver);
// The newest saved state of this model takes the place of what the solver holds; on errors of the state that is
// unchanged.
c2d_status restore_state(c2d_solver* solver);

} // namespace c2d
