#pragma once
// What every call of the C interface does on entry and exit.
#include "solver/solver.hpp"

namespace c2d {

constexpr uint32_t state_bit(int32_t state) { return 1u << state; }
constexpr uint32_t kStarted = state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);
// Legal to go on? Otherwise the reason is the status, and what c2d_last_error tells.
c2d_status enter(c2d_solver* solver, uint32_t legal_states);
// Refuses an argument of a call that is legal always, also inside a callback: there nothing is told.
c2d_status refuse_always(c2d_solver* solver, const char* text);
// Forget the model and every result; state: empty. For the deck reader and failed model calls.
void clear_model(c2d_solver* solver);
// Does the port have all functions of a block store? If not, that is the call's error.
bool has_store(c2d_solver* solver);
// Fill the caller's c2d_error of a call that has no solver to ask; `why` may be null. The text is `what`, null:
// c2d_message(status), and `end`.
void explain(c2d_error* why, c2d_status status, uint64_t bytes_needed, const char* what = nullptr, const char* end = nullptr);
// Copy a struct of ours into the caller's of possibly another size, whose struct_size is kept; and back.
bool copy_out(const void* ours, size_t our_size, void* theirs);
bool copy_in(const void* theirs, void* ours, size_t our_size);

} // namespace c2d
