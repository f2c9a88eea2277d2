// Body forces by calls.
#include "bie/body_force.hpp"
#include "bie/panel.hpp"
#include "interface/refuse.hpp"
#include "memory/parts.hpp"
#include "model/validate_finding.hpp"
#include "solver/energy_adjoint.hpp"
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
  if (status != C2D_OK) return status;
  if (!in_range(load_case, 1, s->sizes.load_cases))
    return refuse_number(s, C2D_ERR_ARGUMENT, "load case", load_case, 1, s->sizes.load_cases);
  if (!force || (!axis && rho_omega2 != 0.0)) return refuse(s, C2D_ERR_ARGUMENT, "no body force or axis of rotation given");
  const double numbers[5] = {force[0], force[1], rho_omega2, axis ? axis[0] : 0.0, axis ? axis[1] : 0.0};
  for (double number : numbers)
    if (!is_usable(number)) return refuse_value(s, "a number of the body force", number, "a finite number");
  array_of<BodyForce>(s, kBodyForces)[2 * static_cast<int64_t>(load_case - 1) + body - 1] =
      BodyForce{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
  s->model.body_forces |= 1 << (body - 1);
  return loaded(s);
}
