// Begin and advance.
#include "interface/advance.hpp"

#include <math.h>

#include "model/validate.hpp"
#include "solver/load_path.hpp"

namespace c2d {

c2d_status finish(Session& session, c2d_status status) {
  c2d_solver* s = session.solver;
  close_session(session);
  if (status == C2D_OK) {
    s->cancelled = 0; // a cancel that came too late must not stop the next call
    return C2D_OK;
  }
  if (is_store_error(status)) return fail_store(s, status);
  s->cancelled = 0;
  return status == C2D_ERR_CALLBACK ? status : fail(s, status, status_text(status)); // what the callback said is told
}

c2d_status begin(Session& session) {
  session.solver->state = C2D_STATE_RUNNING;
  return begin_path(session);
}

c2d_status advance(Session& session, const double* target, Moment moment) {
  const c2d_status status = advance_path(session, target);
  if (status == C2D_OK) warn_contact(session, moment);
  return status;
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_begin(c2d_solver* s, const double* mu, int32_t zones) {
  c2d_status status = enter(s, kStarted);
  if (status != C2D_OK) return status;
  if (zones < 0 || (zones > 0 && !mu) || (s->model.zones > 0 && zones != 1 && zones != s->model.zones))
    return fail(s, C2D_ERR_ARGUMENT, "give one coefficient of friction, or one per contact zone");
  for (int32_t i = 0; i < zones; ++i)
    if (!is_coefficient(mu[i])) return fail(s, C2D_ERR_ARGUMENT, "a coefficient of friction is not zero or more");
  Session session;
  open_session(s, session);
  for (int32_t i = 0; i < s->model.pairs; ++i) {
    Pair& pair = session.model.pair[i];
    pair.mu = mu[zones == 1 ? 0 : pair.zone];
  }
  s->mu = zones > 0 ? mu[0] : 0.0;
  s->coefficient = 0;
  return finish(session, begin(session));
}

extern "C" c2d_status c2d_advance(c2d_solver* s, const double* load, int32_t cases, c2d_outcome* outcome) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  if (!load || !outcome || cases != s->model.load_cases)
    return fail(s, C2D_ERR_ARGUMENT, "give a load factor for every load case, and room for the outcome");
  for (int32_t k = 0; k < cases; ++k)
    if (!is_usable(load[k])) return fail(s, C2D_ERR_ARGUMENT, "a load factor is not a usable number");
  Session session;
  open_session(s, session);
  status = finish(session, advance(session, load, Moment::end));
  *outcome = s->outcome;
  return status;
}

extern "C" c2d_status c2d_next_event(c2d_solver* s, const double* direction, int32_t cases, double* step) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  if (!direction || !step || cases != s->model.load_cases)
    return fail(s, C2D_ERR_ARGUMENT, "give a direction for every load case, and room for the step");
  for (int32_t k = 0; k < cases; ++k)
    if (!is_usable(direction[k])) return fail(s, C2D_ERR_ARGUMENT, "a number of the direction is not usable");
  *step = s->model.contact == 0 && !s->blocked ? HUGE_VAL : 0.0;
  if (s->model.contact == 0 || s->blocked || s->floating) return C2D_OK;
  Session session;
  open_session(s, session);
  for (int32_t k = 0; k < cases; ++k) session.follower.direction[k] = direction[k];
  c2d_outcome outcome = C2D_REACHED;
  constexpr double kReach = 1e30; // further than any load, and no product with it overflows
  status = find_event(session.follower, kReach, step, &outcome);
  s->back_substituted = s->table_is_current = 0;
  return finish(session, status);
}
