// c2d_save and c2d_restore: the state of the path on tape CONTROL.
#include "interface/entry.hpp"
#include "memory/parts.hpp"
#include "solver/prepare.hpp"
#include "solver/save.hpp"

namespace c2d {
C2D_MEETS(EnergyPart, c2d_get_summary); // a saved state may contain energies
C2D_MEETS(WarningPart, c2d_link_warnings);
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_save(c2d_solver* s) {
  const InsideStep inside(s);
  const c2d_status status = enter(s, kStarted);
  if (status != C2D_OK) return status;
  return save_state(s); // a prepared solver has a store
}

extern "C" c2d_status c2d_restore(c2d_solver* s) {
  c2d_status status = enter(s, state_bit(C2D_STATE_MODEL) | kStarted | state_bit(C2D_STATE_BROKEN));
  if (status != C2D_OK) return status;
  if (!has_store(s)) return C2D_ERR_ARGUMENT;
  status = restore_state(s);
  if (status != C2D_OK) return status;
  const int32_t warnings = s->warnings; // counted already, but reported in another process
  if (!s->blocked) kWarningPart.warn_condition(s);
  s->warnings = warnings;
  return C2D_OK;
}
