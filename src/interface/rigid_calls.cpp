// A rigid body 1 by calls.
#include "contact/reduction.hpp"
#include "interface/refuse.hpp"
#include "memory/parts.hpp"
#include "model/validate_finding.hpp"
#include "results/rigid.hpp"
#include "solver/energy_adjoint.hpp"

const c2d::RigidPart c2d::kRigidPart = {true,       c2d_set_rigid,         check_rigid, move_rigidly, add_rigid_motion,
                                        fill_rigid, rigid_displacement_now};

using namespace c2d;

extern "C" c2d_status c2d_set_rigid(c2d_solver* s, int32_t body, int32_t load_case, const double motion[3],
                                    const double axis[2]) {
  c2d_status status = enter_loads(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  if (s->sizes.bodies < 2) return refuse(s, C2D_ERR_ARGUMENT, "a rigid body 1 needs a second one that is not");
  if (body != 1) return refuse(s, C2D_ERR_ARGUMENT, "only body 1 can be rigid yet: exchange the numbers of the bodies");
  if (!in_range(load_case, 0, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 0, s->sizes.load_cases);
  if (s->state == C2D_STATE_MODEL && (s->model.rigid == 0 || load_case == 0))
    return refuse(s, C2D_ERR_STATE, "body 1 is made rigid before the model is complete");
  if (load_case > 0) {
    status = check_pointers(s, {{"motion", motion}, {"axis", axis}});
    if (status == C2D_OK)
      status = check_numbers(s, {{"motion[0]", motion[0]},
                                 {"motion[1]", motion[1]},
                                 {"motion[2]", motion[2]},
                                 {"axis[0]", axis[0]},
                                 {"axis[1]", axis[1]}});
    if (status != C2D_OK) return status;
    array_of<RigidMotion>(s, kRigidMotions)[load_case - 1] = RigidMotion{motion[0], motion[1], motion[2], axis[0], axis[1]};
  }
  s->model.rigid = 1;
  return loaded(s);
}
