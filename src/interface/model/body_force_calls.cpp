// c2d_set_body_force.
#include "bie/body_force.hpp"
#include "bie/panel.hpp"
#include "interface/model/refuse.hpp"
#include "memory/parts.hpp"
#include "model/validate/validate_finding.hpp"
#include "solver/energy/energy_adjoint.hpp"
#include "solver/particular.hpp"

const c2d::BodyForcePart c2d::kBodyForcePart = {true,
                                                c2d_set_body_force,
                                                check_body_force,
                                                body_force_resultant,
                                                add_body_force_columns,
                                                add_body_force,
                                                take_particular,
                                                add_particular_at_load,
                                                particular_at_end,
                                                interpolated_particular,
                                                add_particular_at};

using namespace c2d;

extern "C" c2d_status c2d_set_body_force(c2d_solver* s, int32_t body, int32_t load_case, const double force[2],
                                         double rho_omega2, const double axis[2]) {
  c2d_status status = enter_loads(s);
  if (status == C2D_OK) status = check_body_number(s, body);
  if (status == C2D_OK) status = check_load_case(s, load_case);
  if (status == C2D_OK) status = check_pointers(s, {{"force", force}});
  if (status == C2D_OK && rho_omega2 != 0.0) status = check_pointers(s, {{"axis", axis}});
  if (status != C2D_OK) return status;
  const double x0 = axis ? axis[0] : 0.0, y0 = axis ? axis[1] : 0.0;
  status = check_numbers(
      s, {{"force[0]", force[0]}, {"force[1]", force[1]}, {"rho_omega2", rho_omega2}, {"axis[0]", x0}, {"axis[1]", y0}});
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  m.body_force[body - 1][load_case - 1] = BodyForce{force[0], force[1], rho_omega2, x0, y0};
  m.body[body - 1].has_force = 1;
  return loaded(s);
}
