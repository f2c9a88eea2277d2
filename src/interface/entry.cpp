// What every call does first and last.
#include "interface/entry.hpp"

#include <string.h>

#include "memory/text.hpp"
#include "solver/port.hpp"

namespace c2d {

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

c2d_status refuse_always(c2d_solver* s, const char* text) {
  return s->busy ? c2d_status{C2D_ERR_ARGUMENT} : fail(s, C2D_ERR_ARGUMENT, text);
}

bool has_store(c2d_solver* s) {
  const c2d_port& p = s->port;
  if (p.open && p.read && p.write && p.sync && p.close) return true;
  fail(s, C2D_ERR_ARGUMENT, "the port has no block store (open, read, write, sync, close)");
  return false;
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_last_error(c2d_solver* s, c2d_error* out) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (out && copy_out(&s->error, sizeof s->error, out)) return C2D_OK;
  s->has_fault = 1; // the fault that was asked for stays the one kept
  return refuse_always(s, "c2d_last_error: the c2d_error is null or not begun with C2D_INIT");
}

extern "C" int32_t c2d_get_state(const c2d_solver* s) { return s && s->magic == kSolverMagic ? s->state : -1; }

extern "C" c2d_status c2d_cancel(c2d_solver* s) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  s->cancelled = 1;
  return C2D_OK;
}
