#pragma once
// What every call of the C interface does on entry and exit.
#include "memory/structs.hpp"
#include "solver/solver.hpp"

namespace c2d {

constexpr uint32_t state_bit(int32_t state) { return 1u << state; }
constexpr uint32_t kComplete = state_bit(C2D_STATE_MODEL) | state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);
constexpr uint32_t kStarted = state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);
// Legal to go on? Otherwise the reason is the status, and what c2d_last_error tells.
c2d_status enter(c2d_solver* solver, uint32_t legal_states);
// While the callback of c2d_run is shown the end of an increment or of the path, the state stands, and c2d_run knows its place:
// a running solver may be saved there, and asked for results; what that reads is not counted, so that a run that is resumed
// counts as one that was not ended. (Boards have no room for it.)
class InsideStep {
public:
  explicit InsideStep(c2d_solver* s)
      : solver_(!kSmallCode && s && s->magic == kSolverMagic && s->busy == kInStepCallback && s->run_step > 0 ? s : nullptr) {
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
// Bodies are counted from 1 in calls.
inline Body& body_numbered(c2d_solver* solver, int32_t body) { return array_of<Body>(solver, kBodies)[body - 1]; }
// Forget the model and every result; state: empty. For the deck reader and failed model calls.
void clear_model(c2d_solver* solver);
// Does the port have a block store? If not, that is the call's error.
bool has_store(c2d_solver* solver);
// Fill the caller's c2d_error of a call that has no solver to ask; `why` may be null. The text is `what`, null:
// c2d_message(status), and `end`.
void explain(c2d_error* why, c2d_status status, uint64_t bytes_needed, const char* what = nullptr, const char* end = nullptr);
// A copy of the caller's port, zero for none; false if it cannot be one, with the reason.
bool take_port(const c2d_port* port, c2d_port& ours, Text& fault);
// Refuses the caller's struct `name` if it is null or not begun with C2D_INIT. Inside a callback nothing is told.
c2d_status check_begun(c2d_solver* solver, const char* name, const void* theirs);
// Copy it in and out, or refuse it.
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
