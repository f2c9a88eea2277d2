// What every call does first and last: states, errors, the caller's functions.
#include "solver/solver.hpp"

#include <string.h>

#include "memory/text.hpp"

namespace c2d {

c2d_error blank_error() {
  c2d_error e;
  memset(&e, 0, sizeof e);
  e.struct_size = static_cast<uint32_t>(sizeof e);
  return e;
}

bool copy_out(const void* ours, size_t our_size, void* theirs) {
  uint32_t size;
  memcpy(&size, theirs, sizeof size);
  if (size < sizeof size) return false;
  const size_t bytes = size < our_size ? size : our_size;
  memcpy(static_cast<char*>(theirs) + sizeof size, static_cast<const char*>(ours) + sizeof size, bytes - sizeof size);
  return true;
}

bool copy_in(const void* theirs, void* ours, size_t our_size) {
  uint32_t size;
  memcpy(&size, theirs, sizeof size);
  if (size < sizeof size) return false;
  memset(ours, 0, our_size);
  memcpy(ours, theirs, size < our_size ? size : our_size);
  const uint32_t our_mark = static_cast<uint32_t>(our_size);
  memcpy(ours, &our_mark, sizeof our_mark);
  return true;
}

void report_fault(c2d_solver* s, const c2d_error& entry) {
  if (entry.severity == C2D_FAULT && !s->has_fault) {
    s->error = entry;
    s->has_fault = 1;
  }
  if (entry.severity == C2D_WARNING) ++s->warnings;
  if (!s->port.log) return;
  s->busy = 1;
  s->port.log(s->port.context, &entry);
  s->busy = 0;
}

c2d_status fail(c2d_solver* s, c2d_status status, const char* text) {
  c2d_error e = blank_error();
  e.status = status;
  e.severity = C2D_FAULT;
  e.line = s->model.line;
  e.column = s->model.column;
  e.column_end = s->model.column_end;
  Text out = text_in(e.text);
  put(out, text);
  s->error = e;
  s->has_fault = 1;
  return status;
}

c2d_status fail_store(c2d_solver* s, c2d_status status) {
  s->error = s->tapes.error;
  s->error.struct_size = static_cast<uint32_t>(sizeof s->error);
  s->error.severity = C2D_FAULT;
  if (s->error.status != status) { // no tape said it
    s->error = blank_error();
    s->error.status = status;
    s->error.severity = C2D_FAULT;
    Text text = text_in(s->error.text);
    put(text, c2d_message(status));
  }
  s->has_fault = 1;
  s->state = C2D_STATE_BROKEN;
  return status;
}

c2d_status enter(c2d_solver* s, uint32_t legal_states) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (s->busy) return C2D_ERR_BUSY;
  s->tapes.port = &s->port;
  s->tapes.busy = &s->busy;
  s->has_fault = 0;
  if ((legal_states & state_bit(s->state)) == 0) {
    static const char* const names[] = {"empty", "building", "model", "prepared", "running", "broken"};
    c2d_error e = blank_error();
    e.status = C2D_ERR_STATE;
    e.severity = C2D_FAULT;
    Text text = text_in(e.text);
    put_all(text, "this call is not legal in state '", names[s->state], "'");
    s->error = e;
    s->has_fault = 1;
    return C2D_ERR_STATE;
  }
  return C2D_OK;
}

bool asked_to_stop(c2d_solver* s) {
  if (s->port.cancel) {
    s->busy = 1;
    if (s->port.cancel(s->port.context) != 0) s->cancelled = 1;
    s->busy = 0;
  }
  return s->cancelled != 0;
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

Model model_of(c2d_solver* s) {
  Model m;
  m.head = &s->model;
  for (int b = 0; b < 2; ++b) {
    m.xy[b] = array_of<double>(s, kXy + b);
    m.node_line[b] = array_of<int32_t>(s, kNodeLine + b);
    m.end_traction[b] = array_of<double>(s, kEndTraction + b);
    m.node_disp[b] = array_of<double>(s, kNodeDisp + b);
    m.end_code[b] = array_of<uint8_t>(s, kEndCode + b);
    m.end_line[b] = array_of<int32_t>(s, kEndLine + b);
    m.node_column[b] = array_of<int32_t>(s, kNodeColumn + b);
    m.region[b] = array_of<Region>(s, kRegions + b);
  }
  m.zone = array_of<Zone>(s, kZones);
  m.pair = array_of<Pair>(s, kPairs);
  m.point_load = array_of<PointLoad>(s, kPointLoads);
  m.curve = array_of<Curve>(s, kCurves);
  m.friction = array_of<double>(s, kFriction);
  m.path = array_of<Path>(s, kPaths);
  m.rigid_motion = array_of<RigidMotion>(s, kRigidMotions);
  m.body_force = array_of<BodyForce>(s, kBodyForces);
  m.path_load = array_of<double>(s, kPathLoads);
  return m;
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_last_error(c2d_solver* s, c2d_error* out) {
  if (!s || s->magic != kSolverMagic || !out) return C2D_ERR_ARGUMENT;
  return copy_out(&s->error, sizeof s->error, out) ? C2D_OK : C2D_ERR_ARGUMENT;
}

extern "C" int32_t c2d_get_state(const c2d_solver* s) { return s && s->magic == kSolverMagic ? s->state : -1; }

extern "C" c2d_status c2d_cancel(c2d_solver* s) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  s->cancelled = 1;
  return C2D_OK;
}
