#pragma once
// Saved states (store/FORMAT.md). A crash in the middle of saving leaves the state saved before.
#include "solver/solver.hpp"

namespace c2d {

constexpr uint64_t kPieceBytes = 512; // data of a block: small enough to be put together on the stack
// Blocks of tape CONTROL with two states of `image_bytes` each: the run's count, two records, the pieces.
constexpr uint64_t save_pieces(uint64_t image_bytes) { return (image_bytes + kPieceBytes - 1) / kPieceBytes; }
constexpr uint64_t save_blocks(uint64_t image_bytes) { return 3 + 2 * save_pieces(image_bytes); }

// The port has a block store. Errors are told and recorded; a store error breaks the solver.
c2d_status save_state(c2d_solver* solver);
// The newest saved state of this model takes the place of what the solver holds; on errors of the state that is
// unchanged.
c2d_status restore_state(c2d_solver* solver);

} // namespace c2d
