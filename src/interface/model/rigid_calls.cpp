// c2d_set_rigid and c2d_set_rigid_load.
#include "contact/reduction/reduction.hpp"
#include "interface/model/refuse.hpp"
#include "memory/parts.hpp"
#include "model/validate/validate_finding.hpp"
#include "results/rigid.hpp"
#include "solver/energy/energy_adjoint.hpp"

const c2d::RigidPart c2d::kRigidPart = {true,        c2d_set_rigid,          c2d_set_rigid_load, c2d_add_platen,
                                        check_rigid, check_rigid_zones,      reduce_rigid,       add_rigid_motion,
                                        fill_rigid,  rigid_displacement_now, rigid_motion_now};

using namespace c2d;

extern "C" c2d_status c2d_set_rigid(c2d_solver* s, int32_t body, int32_t load_case, const double motion[3],
                                    const double axis[2]) {
  c2d_status status = enter_loads(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status != C2D_OK) return status;
  if (s->sizes.bodies < 2)
    return refuse(s, C2D_ERR_ARGUMENT, "a model of one body cannot have a rigid body, expected a second, deformable body");
  if (!in_range(load_case, 0, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 0, s->sizes.load_cases);
  const Model m = model_of(s);
  if (s->state == C2D_STATE_MODEL && (!is_rigid(m, body - 1) || load_case == 0))
    return refuse(s, C2D_ERR_STATE, "a body can be made rigid only before c2d_complete");
  if (load_case > 0) {
    status = check_pointers(s, {{"motion", motion}, {"axis", axis}});
    if (status == C2D_OK)
      status = check_numbers(s, {{"motion[0]", motion[0]},
                                 {"motion[1]", motion[1]},
                                 {"motion[2]", motion[2]},
                                 {"axis[0]", axis[0]},
                                 {"axis[1]", axis[1]}});
    if (status != C2D_OK) return status;
    RigidMotion& given = m.rigid_motion[body - 1][load_case - 1];
    given = RigidMotion{motion[0], motion[1], motion[2], axis[0], axis[1], {given.load[0], given.load[1], given.load[2]}};
  }
  m.body[body - 1].rigid = 1;
  return loaded(s);
}

extern "C" c2d_status c2d_set_rigid_load(c2d_solver* s, int32_t body, int32_t load_case, const int32_t is_free[3],
                                         const double load[3], const double point[2]) {
  c2d_status status = enter_loads(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status == C2D_OK && !in_range(load_case, 0, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 0, s->sizes.load_cases);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  Body& own = m.body[body - 1];
  if (s->state == C2D_STATE_MODEL && (own.free_rigidly == 0 || load_case == 0))
    return refuse(s, C2D_ERR_STATE, "free motions of a rigid body can be set only before c2d_complete");
  if (load_case == 0) {
    status = check_pointers(s, {{"is_free", is_free}, {"point", point}});
    if (status == C2D_OK) status = check_numbers(s, {{"point[0]", point[0]}, {"point[1]", point[1]}});
    if (status != C2D_OK) return status;
    own.free_rigidly = static_cast<int8_t>((is_free[0] != 0 ? 1 : 0) + (is_free[1] != 0 ? 2 : 0) + (is_free[2] != 0 ? 4 : 0));
    for (int c = 0; c < 2; ++c) own.centre[c] = point[c];
    own.rigid = 1;
    return loaded(s);
  }
  status = check_pointers(s, {{"load", load}});
  if (status == C2D_OK) status = check_numbers(s, {{"load[0]", load[0]}, {"load[1]", load[1]}, {"load[2]", load[2]}});
  if (status != C2D_OK) return status;
  for (int i = 0; i < 3; ++i) m.rigid_motion[body - 1][load_case - 1].load[i] = load[i];
  return loaded(s);
}
