#include "memory/math.hpp"
#include "results/interior/interior.hpp"

#include "interface/model/refuse.hpp"

using namespace c2d;

namespace {

// Not inlined: on a small stack the frame of the checks must not add to those of the integrals.
[[gnu::noinline]] c2d_status check_points(c2d_solver* s, int32_t body, int32_t count, const double* xy, int64_t xy_stride,
                                          double* out, int64_t out_stride) {
  if (!in_range(body, 0, s->model.bodies)) return refuse_number(s, C2D_ERR_ARGUMENT, "body number", body, 0, s->model.bodies);
  if (count < 0) return refuse_number(s, C2D_ERR_ARGUMENT, "count", count, 0, INT32_MAX);
  c2d_status status = check_array(s, "xy", xy, "xy_stride", xy_stride, 2, count);
  if (status == C2D_OK) status = check_array(s, "out", out, "out_stride", out_stride, C2D_POINT_FIELDS, count);
  for (int32_t i = 0; i < count && status == C2D_OK; ++i)
    for (int c = 0; c < 2 && status == C2D_OK; ++c)
      if (!isfinite(xy[i * xy_stride + c]))
        status = refuse_value(s, "a coordinate in xy", xy[i * xy_stride + c], "a finite number");
  return status;
}

} // namespace

extern "C" c2d_status c2d_interior(c2d_solver* s, int32_t body, int32_t count, const double* xy, int64_t xy_stride, double* out,
                                   int64_t out_stride) {
  const InsideStep inside(s);
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status == C2D_OK) status = check_points(s, body, count, xy, xy_stride, out, out_stride);
  if (status != C2D_OK || count == 0) return status;
  if (asked_to_stop(s)) return fail(s, C2D_ERR_CANCELLED, status_text(C2D_ERR_CANCELLED));
  Session session;
  open_session(s, session);
  return evaluate_points(session, body, PointsAsked{count, xy, xy_stride, out, out_stride});
}
