#pragma once
// Common entry and exit of all calls of the C interface.
#include "memory/structs.hpp"
#include "solver/solver.hpp"

namespace c2d {

constexpr uint32_t state_bit(int32_t state) { return 1u << state; }
constexpr uint32_t kComplete = state_bit(C2D_STATE_MODEL) | state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);
constexpr uint32_t kStarted = state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);
// Is the call legal? If not, the status and c2d_last_error give the reason.
c2d_status enter(c2d_solver* solver, uint32_t legal_states);
// While c2d_run shows its callback the end of an increment or of the path, the state is complete and its position known: a
// running solver may be saved there and queried for results. Transfers of these calls are not counted, so that a resumed run
// has the same counts as an uninterrupted one. Not in small code.
class InsideStep {
public:
  explicit InsideStep(c2d_solver* s)
      : solver_(!kSmallCode && s && s->magic == kSolverMagic && s->busy == kInStepCallback && s->run_step != 0 ? s : nullptr) {
    if (!solver_) return;
    solver_->busy = 0;
    for (int32_t tape = 0; tape < C2D_TAPES; ++tape)
      reads_[tape] = solver_->tapes.reads[tape], bytes_read_[tape] = solver_->tapes.bytes_read[tape];
  }
  ~InsideStep() {
    if (!solver_) return;
    solver_->busy = kInStepCallback;
    for (int32_t tape = 0; tape < C2D_TAPES; ++tape)
      solver_->tapes.reads[tape] = reads_[tape], solver_->tapes.bytes_read[tape] = bytes_read_[tape];
  }
  InsideStep(const InsideStep&) = delete;
  InsideStep& operator=(const InsideStep&) = delete;

private:
  c2d_solver* const solver_;
  uint64_t reads_[C2D_TAPES], bytes_read_[C2D_TAPES];
};
// Calls number bodies from 1.
inline Body& body_numbered(c2d_solver* solver, int32_t body) { return array_of<Body>(solver, kBodies)[body - 1]; }
// Discards the model and all results; state: empty. For the deck reader and failed model calls.
void clear_model(c2d_solver* solver);
// Does the port have a block store? If not, records the error.
bool has_store(c2d_solver* solver);
// Fills the caller's c2d_error for calls without a solver; `why` may be null. The text is `what`, null:
// c2d_message(status), followed by `end`.
void explain(c2d_error* why, c2d_status status, uint64_t bytes_needed, const char* what = nullptr, const char* end = nullptr);
// Copies the caller's port, zeros for none; false with the reason if it is invalid.
bool take_port(const c2d_port* port, c2d_port& ours, Text& fault);
// Refuses the caller's struct `name` if it is null or was not initialised with C2D_INIT. In a callback no error is recorded.
c2d_status check_begun(c2d_solver* solver, const char* name, const void* theirs);
// Copies it in and out, or refuses it.
template <class T> c2d_status take(c2d_solver* solver, const char* name, const T* theirs, T& ours) {
  const c2d_status status = check_begun(solver, name, theirs);
  if (status == C2D_OK) copy_in(theirs, &ours, sizeof ours);
  return status;
}
template <class T> c2d_status give(c2d_solver* solver, const char* name, const T& ours, T* theirs) {
  const c2d_status status = check_begun(solver, name, theirs);
  if (status == C2D_OK) copy_out(&ours, sizeof ours, theirs);
  return status;
}

} // namespace c2d
