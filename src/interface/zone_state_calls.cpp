#include "results/zone_state.hpp"

#include <string.h>

#include "interface/entry.hpp"
#include "memory/hostile.hpp"
#include "results/approach.hpp"
#include "solver/energy/energy.hpp"

using namespace c2d;

extern "C" c2d_status c2d_get_zone_state(c2d_solver* s, int32_t zone, c2d_zone_state* out) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (s->busy && s->busy != kInStepCallback) return C2D_ERR_BUSY;
  if (s->busy) {                                             // in a step callback: nothing may change, not even the last error
    if (s->state != C2D_STATE_RUNNING) return C2D_ERR_STATE; // the store failed during the callback
    if (zone < 1 || zone > s->model.zones) return C2D_ERR_ARGUMENT;
  } else {
    const c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
    if (status != C2D_OK) return status;
    if (zone < 1 || zone > s->model.zones) return fail(s, C2D_ERR_ARGUMENT, "there is no such contact zone");
  }
  if (!is_begun(out)) return check_begun(s, "c2d_zone_state", out);
  c2d_zone_state ours;
  memset(&ours, 0, sizeof ours);
  Session session;
  open_session(s, session);
  const Zone& z = session.model.zone[zone - 1];
  if (s->blocked || s->floating) {
    (z.is_tied != 0 ? ours.stick : ours.open) = z.pairs;
  } else {
    refresh(session.follower);
    fill_zone_state(session, z, ours);
    const InsideStep inside(s);
    const c2d_status status = s->busy ? c2d_status{C2D_OK} : find_approach(session, z, ours);
    if (status != C2D_OK) return fail_store(s, status);
  }
  if (s->keeps_energy) ours.dissipated = rubbed(s)[zone - 1];
  copy_out(&ours, sizeof ours, out);
  return C2D_OK;
}
