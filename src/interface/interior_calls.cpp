#include "results/interior.hpp"

#include "interface/entry.hpp"

using namespace c2d;

extern "C" c2d_status c2d_interior(c2d_solver* s, int32_t body, int32_t count, const double* xy, int64_t xy_stride, double* out,
                                   int64_t out_stride) {
  const c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  if (body < 0 || body > s->model.bodies) return fail(s, C2D_ERR_ARGUMENT, "there is no such body");
  if (count < 0 || (count > 0 && (!xy || !out))) return fail(s, C2D_ERR_ARGUMENT, "no points, or no room for the answer");
  if (count > 1 && (xy_stride < 2 || out_stride < C2D_POINT_FIELDS))
    return fail(s, C2D_ERR_ARGUMENT, "strides too small: rows would overlap");
  if (count == 0) return C2D_OK;
  s->cancelled = 0;
  Session session;
  open_session(s, session);
  return evaluate_points(session, body, PointsAsked{count, xy, xy_stride, out, out_stride});
}
