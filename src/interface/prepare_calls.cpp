#include "solver/prepare.hpp"

#include "interface/entry.hpp"

using namespace c2d;

extern "C" c2d_status c2d_prepare(c2d_solver* s) {
  const c2d_status status = enter(s, state_bit(C2D_STATE_MODEL));
  if (status != C2D_OK) return status;
  if (!has_store(s)) return C2D_ERR_ARGUMENT;
  return asked_to_stop(s) ? fail(s, C2D_ERR_CANCELLED, status_text(C2D_ERR_CANCELLED)) : prepare(s);
}
