#include "solver/new_loads.hpp"

#include "interface/entry.hpp"
#include "memory/optional.hpp"

namespace c2d {
C2D_BRINGS(eliminate_new_loads);
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_change_loads(c2d_solver* s) {
  const c2d_status status = enter(s, kStarted);
  if (status != C2D_OK) return status;
  s->loads_changed = 1;
  s->state = C2D_STATE_MODEL;
  return C2D_OK;
}
