#include "results/warnings/indicator.hpp"

#include "interface/model/refuse.hpp"

using namespace c2d;

extern "C" c2d_status c2d_indicators(c2d_solver* s, int32_t body, int32_t first, int32_t count, double* out, int64_t stride) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status == C2D_OK) status = check_ranges(s, {{"body number", body, 1, s->model.bodies}});
  if (status != C2D_OK) return status;
  const int64_t elements = body_numbered(s, body).elements;
  status = check_ranges(s, {{"first", first, 1, elements + 1}});
  if (status == C2D_OK) status = check_ranges(s, {{"count", count, 0, elements + 1 - first}});
  if (status == C2D_OK) status = check_array(s, "out", out, "stride", stride, C2D_OFF_FIELDS, count);
  if (status != C2D_OK || count == 0) return status;
  if (asked_to_stop(s)) return fail(s, C2D_ERR_CANCELLED, status_text(C2D_ERR_CANCELLED));
  Session session;
  open_session(s, session);
  return fill_indicators(session, body - 1, first - 1, count, out, stride);
}
