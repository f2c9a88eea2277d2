// Errors and warnings on their way out, and the caller's other functions.
#include <string.h>

#include "memory/text.hpp"
#include "solver/solver.hpp"

namespace c2d {

c2d_error blank_error() {
  c2d_error e;
  memset(&e, 0, sizeof e);
  e.struct_size = static_cast<uint32_t>(sizeof e);
  return e;
}

void report_fault(c2d_solver* s, const c2d_error& entry) {
  if (entry.severity == C2D_FAULT && !s->has_fault) {
    if (s->state != C2D_STATE_BROKEN) s->error = entry; // what broke the solver is not lost to what follows from it
    s->has_fault = 1;
  }
  if (entry.severity == C2D_WARNING) ++s->warnings;
  if (!s->port.log) return;
  s->busy = 1;
  s->port.log(s->port.context, &entry);
  s->busy = 0;
}

c2d_status fail_with(c2d_solver* s, c2d_error& e, c2d_status status, const char* text) {
  if (status == C2D_ERR_CANCELLED) set_cancelled(s, 0); // what comes from now on is for the next call
  e.status = status;
  e.severity = C2D_FAULT;
  Text out = text_in(e.text);
  put(out, text);
  report_fault(s, e);
  return status;
}

c2d_status fail(c2d_solver* s, c2d_status status, const char* text) {
  c2d_error e = blank_error();
  e.line = s->model.line;
  e.column = s->model.column;
  e.column_end = s->model.column_end;
  return fail_with(s, e, status, text);
}

c2d_status fail_store(c2d_solver* s, c2d_status status) {
  c2d_error e = blank_error();
  const c2d_error& told = s->tapes.error;
  const bool by_tape = told.status == status;
  if (by_tape) {
    e.tape = told.tape;
    e.block = told.block;
    e.host_code = told.host_code;
  }
  fail_with(s, e, status, by_tape ? told.text : status_text(status));
  s->state = C2D_STATE_BROKEN;
  return status;
}

bool is_store_error(c2d_status status) { return status >= C2D_ERR_STORE_OPEN && status < C2D_ERR_MISMATCH; }

bool asked_to_stop(c2d_solver* s) {
  if (s->port.cancel) {
    s->busy = 1;
    if (s->port.cancel(s->port.context) != 0) set_cancelled(s, 1);
    s->busy = 0;
  }
  return is_cancelled(s);
}

double clock_now(c2d_solver* s) {
  if (!s->port.clock) return 0.0;
  s->busy = 1;
  const double now = s->port.clock(s->port.context);
  s->busy = 0;
  return now;
}

void tell_progress(c2d_solver* s, int32_t phase, int32_t body, int64_t done, int64_t total) {
  if (!s->port.progress) return;
  c2d_progress now;
  memset(&now, 0, sizeof now);
  now.struct_size = static_cast<uint32_t>(sizeof now);
  now.phase = phase;
  now.body = body;
  now.done = done;
  now.total = total;
  now.load = s->state == C2D_STATE_RUNNING ? array_of<double>(s, kLoads)[0] : 0.0;
  now.target = s->state == C2D_STATE_RUNNING ? array_of<double>(s, kLoads)[s->sizes.load_cases] : 0.0;
  s->busy = 1;
  s->port.progress(s->port.context, &now);
  s->busy = 0;
}

} // namespace c2d
