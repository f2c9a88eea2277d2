// A rigid body 1 by calls.
#include "contact/reduction.hpp"
#include "interface/refuse.hpp"
#include "memory/optional.hpp"
#include "model/validate_finding.hpp"
#include "results/rigid.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {
C2D_BRINGS(check_rigid);
C2D_BRINGS(move_rigidly);
C2D_BRINGS(fill_rigid);
C2D_BRINGS(add_rigid_motion);
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_set_rigid(c2d_solver* s, int32_t load_case, double ux, double uy, double rotation, double x0,
                                    double y0) {
  const c2d_status status = enter_loads(s);
  if (status != C2D_OK) return status;
  if (s->sizes.bodies < 2) return refuse(s, C2D_ERR_ARGUMENT, "a rigid body 1 needs a second one that is not");
  if (!in_range(load_case, 0, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 0, s->sizes.load_cases);
  if (s->state == C2D_STATE_MODEL && (s->model.rigid == 0 || load_case == 0))
    return refuse(s, C2D_ERR_STATE, "body 1 is made rigid before the model is complete");
  const double numbers[5] = {ux, uy, rotation, x0, y0};
  for (double number : numbers)
    if (!is_usable(number)) return refuse_value(s, "a number of the rigid motion", number, "a finite number");
  s->model.rigid = 1;
  if (load_case > 0) array_of<RigidMotion>(s, kRigidMotions)[load_case - 1] = RigidMotion{ux, uy, rotation, x0, y0};
  return loaded(s);
}
