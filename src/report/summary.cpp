#include "report/summary.hpp"

namespace app {

c2d_status get_summary(c2d_solver* solver, Summary& out) {
  c2d_status status = c2d_get_summary(solver, &out);
  if (status != C2D_OK) return status;
  out.body.list().assign(static_cast<size_t>(out.bodies), C2D_INIT(c2d_body_result));
  for (int32_t b = 1; b <= out.bodies && status == C2D_OK; ++b)
    status = c2d_get_body_result(solver, b, &out.body.list()[static_cast<size_t>(b) - 1]);
  return status;
}

} // namespace app
