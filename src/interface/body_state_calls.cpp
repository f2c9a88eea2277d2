// State of a body at the load reached.
#include <string.h>

#include "interface/entry.hpp"
#include "memory/hostile.hpp"
#include "memory/parts.hpp"
#include "results/body_state.hpp"
#include "results/table.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

// Load on the free motions of a rigid body: force, and moment about the origin.
void add_rigid_load(const Session& session, int b, double out[3]) {
  const Body& body = session.model.body[b];
  double load[3] = {0.0, 0.0, 0.0};
  for (int32_t k = 0; k < session.model.head->load_cases; ++k)
    for (int i = 0; i < 3; ++i)
      if ((body.free_rigidly >> i & 1) != 0) load[i] += session.follower.load[k] * session.model.rigid_motion[b][k].load[i];
  for (int i = 0; i < 3; ++i) out[i] = load[i];
  if ((body.free_rigidly & 4) != 0) out[2] += body.centre[0] * load[1] - body.centre[1] * load[0];
}

c2d_status fill_body_state(Session& session, int b, c2d_body_state& out) {
  c2d_solver* s = session.solver;
  const Body& body = session.model.body[b];
  out.is_rigid = is_rigid(session.model, b) ? 1 : 0;
  for (int c = 0; c < 2; ++c) out.point[c] = out.is_rigid != 0 ? body.centre[c] : 0.0;
  if (s->blocked || s->floating || s->model.contact == 0) return C2D_OK;
  refresh(session.follower);
  const c2d_status status = s->table_is_current ? c2d_status{C2D_OK} : fill_table(session);
  if (status != C2D_OK) return status;
  const bool known = !kSmallCode && s->back_substituted != 0 && s->keeps_energy != 0; // from the balance of forces
  if (known)
    memcpy(out.contact, results_of(s, b).contact_force, sizeof out.contact);
  else if (body.contact > 0)
    contact_resultant(session, b, out.contact);
  if (out.is_rigid == 0) return C2D_OK;
  kRigidPart.rigid_motion_now(session, b, out.motion);
  add_rigid_load(session, b, out.load);
  return C2D_OK;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_get_body_state(c2d_solver* s, int32_t body, c2d_body_state* out) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (s->busy && s->busy != kInStepCallback) return C2D_ERR_BUSY;
  const bool inside = s->busy != 0; // in a step callback: nothing may change, not even the last error
  if (inside && s->state != C2D_STATE_RUNNING) return C2D_ERR_STATE; // the store failed during the callback
  C2D_ASSERT(!inside || s->table_is_current != 0);
  c2d_status status = inside ? c2d_status{C2D_OK} : enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  if (body < 1 || body > s->model.bodies)
    return inside ? c2d_status{C2D_ERR_ARGUMENT} : fail(s, C2D_ERR_ARGUMENT, "there is no such body");
  if (!is_begun(out)) return inside ? c2d_status{C2D_ERR_ARGUMENT} : check_begun(s, "c2d_body_state", out);
  c2d_body_state ours;
  memset(&ours, 0, sizeof ours);
  Session session;
  open_session(s, session);
  status = fill_body_state(session, body - 1, ours);
  if (status != C2D_OK) return fail_store(s, status); // in a step callback the table is filled already
  copy_out(&ours, sizeof ours, out);
  return C2D_OK;
}
