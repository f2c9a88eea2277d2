// c2d_begin, c2d_advance and c2d_next_event.
#include "interface/advance.hpp"

#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/validate/validate.hpp"
#include "solver/judge.hpp"
#include "solver/load_path.hpp"
#include "solver/prepare.hpp"

namespace c2d {

C2D_USES(CompressedPart);
C2D_MEETS(SearchPart, c2d_link_search);
C2D_MEETS(WarningPart, c2d_link_warnings);

c2d_status finish(Session& session, c2d_status status) {
  c2d_solver* s = session.solver;
  close_session(session);
  if (status == C2D_OK) return C2D_OK; // a cancel that arrives too late stops the next call
  if (is_store_error(status)) return fail_store(s, status);
  if (!kSmallCode && status == C2D_ERR_MEMORY) return kCompressedPart.tell_touching(s);
  return status == C2D_ERR_CALLBACK ? status : fail(s, status, status_text(status)); // the callback's fault is recorded
}

c2d_status begin(Session& session) {
  c2d_solver* s = session.solver;
  const double start = kSmallCode ? 0.0 : clock_now(s); // not in small code
  s->state = C2D_STATE_RUNNING;
  c2d_status status = kSmallCode ? c2d_status{C2D_OK} : allow_friction(s);
  if (status == C2D_OK) status = begin_path(session);
  if (!kSmallCode && status == C2D_ERR_MEMORY)
    s->state = C2D_STATE_PREPARED; // lazy columns: no tableau exists to continue with
  if (!kSmallCode) s->seconds[C2D_PHASE_CONTACT] += clock_now(s) - start;
  return status;
}

c2d_status advance(Session& session, const double* target, Moment moment) {
  if (asked_to_stop(session.solver)) return C2D_ERR_CANCELLED; // also on paths without events
  session.may_stop = true;
  const c2d_status status = advance_path(session, target);
  kWarningPart.warn_not_unique(session);
  if (status == C2D_OK) kWarningPart.warn_contact(session, moment);
  return status;
}

namespace {

// One finite factor per load case.
c2d_status check_factors(c2d_solver* s, const char* name, const double* factors, int32_t cases) {
  if (cases != s->model.load_cases)
    return refuse_number(s, C2D_ERR_ARGUMENT, "cases", cases, s->model.load_cases, s->model.load_cases);
  const c2d_status status = check_array(s, name, factors, "stride", 1, 1, cases);
  for (int32_t k = 0; k < cases && status == C2D_OK; ++k)
    if (!is_usable(factors[k])) return refuse_value(s, name, factors[k], "a finite number");
  return status;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_begin(c2d_solver* s, const double* mu, int32_t zones) {
  c2d_status status = enter(s, kStarted);
  if (status != C2D_OK) return status;
  if (zones < 0 || (s->model.zones > 0 && zones != 1 && zones != s->model.zones))
    return refuse_number(s, C2D_ERR_ARGUMENT, "zones, 1 or as many as there are,", zones, 1, s->model.zones);
  if (zones > 0 && !mu) return fail(s, C2D_ERR_ARGUMENT, "mu is null, expected a coefficient of friction, or one per zone");
  for (int32_t i = 0; i < zones; ++i)
    if (!is_coefficient(mu[i])) return refuse_value(s, "mu", mu[i], "zero or more");
  Session session;
  open_session(s, session);
  for (int32_t i = 0; i < s->model.path_pairs; ++i) {
    Pair& pair = session.model.pair[i];
    pair.law.mu = mu[zones == 1 ? 0 : pair.zone];
  }
  s->mu = zones > 0 ? mu[0] : 0.0;
  s->coefficient = s->run_step = 0;
  return finish(session, begin(session));
}

extern "C" c2d_status c2d_advance(c2d_solver* s, const double* load, int32_t cases, c2d_outcome* outcome) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  status = check_factors(s, "load", load, cases);
  if (status == C2D_OK && !outcome) status = fail(s, C2D_ERR_ARGUMENT, "outcome is null");
  if (status != C2D_OK) return status;
  s->run_step = 0; // the position of c2d_run is no longer valid
  Session session;
  open_session(s, session);
  status = finish(session, advance(session, load, Moment::end));
  if (status == C2D_OK) *outcome = s->outcome;
  return status;
}

extern "C" c2d_status c2d_next_event(c2d_solver* s, const double* direction, int32_t cases, double* step) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  status = check_factors(s, "direction", direction, cases);
  if (status == C2D_OK && !step) status = fail(s, C2D_ERR_ARGUMENT, "step is null");
  if (status != C2D_OK) return status;
  s->run_step = 0;
  if (s->model.contact == 0 || s->blocked || s->floating || s->unsound) {
    *step = s->model.contact == 0 && !s->blocked ? HUGE_VAL : 0.0;
    return C2D_OK;
  }
  Session session;
  open_session(s, session);
  for (int32_t k = 0; k < cases; ++k) session.follower.direction[k] = direction[k];
  c2d_outcome outcome = C2D_REACHED;
  constexpr double kReach = 1e30; // beyond any load, and products with it do not overflow
  double part = 0.0;
  const double start = kSmallCode ? 0.0 : clock_now(s);
  status = find_event(session.follower, kReach, &part, &outcome);
  if (status == C2D_ERR_SINGULAR) { // no admissible rates in this direction: the path cannot continue
    status = return_to_good(session);
    part = 0.0;
  }
  if (!kSmallCode) s->seconds[C2D_PHASE_CONTACT] += clock_now(s) - start;
  s->back_substituted = s->table_is_current = 0;
  status = finish(session, s->unsound ? c2d_status{C2D_OK} : status);
  if (status == C2D_OK) *step = part;
  return status;
}
