// Common entry and exit of all calls.
#include "interface/entry.hpp"

#include <string.h>

#include "memory/characters.hpp"
#include "memory/structs.hpp"
#include "solver/port.hpp"

namespace c2d {

namespace {

// A set of port functions that must be all present or all null. `names` is a list of strings with zero bytes.
bool is_whole(const bool* is_there, int32_t count, const char* names, Text& fault) {
  int32_t there = 0;
  for (int32_t i = 0; i < count; ++i) there += is_there[i] ? 1 : 0;
  if (there == 0 || there == count) return true;
  const char* name = names;
  for (int32_t i = 0; is_there[i]; ++i) name += text_length(name) + 1;
  put_all(fault, "c2d_port.", name, " is null, expected all of");
  for (int32_t i = 0; i < count; ++i, names += text_length(names) + 1) put_all(fault, i == 0 ? " " : ", ", names);
  put(fault, ", or none");
  return false;
}

} // namespace

c2d_status check_begun(c2d_solver* s, const char* name, const void* theirs) {
  if (is_begun(theirs)) return C2D_OK;
  c2d_error e = blank_error();
  char what[96];
  Text text = text_in(what);
  put_not_begun(text, name, theirs);
  return s->busy ? c2d_status{C2D_ERR_ARGUMENT} : fail_with(s, e, C2D_ERR_ARGUMENT, what);
}

bool take_port(const c2d_port* port, c2d_port& ours, Text& fault) {
  memset(&ours, 0, sizeof ours);
  if (!port) return true;
  if (!is_begun(port)) {
    put_not_begun(fault, "c2d_port", port);
    return false;
  }
  copy_in(port, &ours, sizeof ours);
  const bool store[] = {ours.open != nullptr, ours.read != nullptr, ours.write != nullptr, ours.sync != nullptr,
                        ours.close != nullptr};
  const bool ahead[] = {ours.start_read != nullptr, ours.start_write != nullptr, ours.wait != nullptr};
  if (!is_whole(store, 5, "open\0read\0write\0sync\0close", fault) ||
      !is_whole(ahead, 3, "start_read\0start_write\0wait", fault))
    return false;
  if (ours.threads < 0)
    put_all(fault, "c2d_port.threads is ", ours.threads, ", expected 0 or more");
  else if (ours.threads > 1 && !ours.parallel_for)
    put_all(fault, "c2d_port.parallel_for is null, but threads is ", ours.threads);
  else
    return true;
  return false;
}

c2d_status enter(c2d_solver* s, uint32_t legal_states) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (s->busy) return C2D_ERR_BUSY;
  connect_port(s);
  s->has_fault = 0;
  if ((legal_states & state_bit(s->state)) == 0) {
    static const char* const names[] = {"empty", "building", "model", "prepared", "running", "broken"};
    c2d_error e = blank_error();
    char what[48];
    Text text = text_in(what);
    put_all(text, "this call is not legal in state '", names[s->state], "'");
    return fail_with(s, e, C2D_ERR_STATE, what);
  }
  return C2D_OK;
}

bool has_store(c2d_solver* s) {
  if (s->port.open) return true;
  fail(s, C2D_ERR_ARGUMENT, "c2d_port.open is null: this call needs a block store (open, read, write, sync, close)");
  return false;
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_last_error(c2d_solver* s, c2d_error* out) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (!s->busy) s->has_fault = 1; // keep the first fault
  return give(s, "c2d_error", s->error, out);
}

extern "C" int32_t c2d_get_state(const c2d_solver* s) { return s && s->magic == kSolverMagic ? s->state : -1; }

extern "C" c2d_status c2d_cancel(c2d_solver* s) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  set_cancelled(s, 1);
  return C2D_OK;
}
