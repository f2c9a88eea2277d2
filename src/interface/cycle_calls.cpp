// c2d_cycle, and the results of cycles.
#include <string.h>

#include "contact2d_cycle.h"
#include "interface/advance.hpp"
#include "interface/cycles.hpp"
#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

C2D_BRINGS(c2d_get_summary); // energies
C2D_BRINGS(c2d_link_search);

namespace {

// ---- what is asked ---------------------------------------------------------------------------------------------------------

const double* corner_of(const c2d_cycle_request& r, int32_t i) { return r.load + static_cast<int64_t>(i) * r.cases; }

c2d_status check_corners(c2d_solver* s, const c2d_cycle_request& r) {
  const int64_t count = static_cast<int64_t>(r.corners) * r.cases;
  for (int64_t i = 0; i < count; ++i)
    if (!is_usable(r.load[i])) return refuse_value(s, "load", r.load[i], "a finite number");
  bool moves = false;
  for (int32_t i = 1; i < r.corners; ++i) moves = moves || !are_alike(corner_of(r, i), corner_of(r, 0), r.cases);
  if (!moves) return fail(s, C2D_ERR_ARGUMENT, "all corners of the cycle are the same load, expected two different ones");
  if (!are_alike(array_of<double>(s, kLoads), corner_of(r, r.corners - 1), r.cases))
    return fail(s, C2D_ERR_ARGUMENT, "the cycle does not close: its last corner is not the load reached");
  return C2D_OK;
}

// Apart, as call_back is: their arrays and errors are no part of the stack under a cycle.
[[gnu::noinline]] c2d_status check_request(c2d_solver* s, const c2d_cycle_request& r) {
  if (s->sizes.cycle_states == 0)
    return fail(s, C2D_ERR_ARGUMENT, "c2d_limits.cycle_states is 0: there is no room for the states of cycles");
  if (r.cases != s->model.load_cases)
    return refuse_number(s, C2D_ERR_ARGUMENT, "cases", r.cases, s->model.load_cases, s->model.load_cases);
  const Ranged ranges[] = {{"corners", r.corners, 2, INT32_MAX},
                           {"limit", r.limit, 0, INT32_MAX},
                           {"mode", r.mode, C2D_CYCLES_EXACT, C2D_CYCLES_FAST}};
  c2d_status status = check_ranges(s, ranges);
  if (status == C2D_OK && !(r.tolerance >= 0.0 && r.tolerance <= 1.0))
    return refuse_value(s, "tolerance", r.tolerance, "0 to 1");
  const Pointed pointers[] = {{"load", r.load}};
  if (status == C2D_OK) status = check_pointers(s, pointers);
  return status == C2D_OK ? check_corners(s, r) : status;
}

uint64_t hash_of(const c2d_cycle_request& r) {
  uint64_t hash = checksum(static_cast<uint64_t>(r.corners), r.load,
                           static_cast<uint64_t>(r.corners) * static_cast<uint64_t>(r.cases) * sizeof(double));
  hash = checksum(hash, &r.tolerance, sizeof r.tolerance);
  const int32_t numbers[2] = {r.mode, r.cases};
  return checksum(hash, numbers, sizeof numbers);
}

// Is what a state that was restored knows of cycles that of this request? (A stranger's may be anything.)
bool may_continue(c2d_solver* s, const c2d_cycle_request& r) {
  const CycleHead& head = *cycle_record(s).head;
  return head.request == hash_of(r) && in_range(head.directions, 0, s->sizes.cycle_states);
}

// ---- the cycles ------------------------------------------------------------------------------------------------------------

[[gnu::noinline]] c2d_status call_back(Session& session, c2d_cycle_fn each, void* context, const c2d_cycle_state& now) {
  c2d_solver* s = session.solver;
  if (!each) return C2D_OK;
  close_session(session); // so that results and c2d_save in the callback are current
  s->run_step = -now.cycles;
  s->busy = kInStepCallback;
  const int32_t code = each(context, &now);
  s->busy = 0;
  s->run_step = 0;
  s->back_substituted = 0; // a state saved in the callback is restored without back substitution
  if (code == 0) return s->state == C2D_STATE_BROKEN ? s->error.status : c2d_status{C2D_OK};
  c2d_error e = blank_error();
  e.host_code = code;
  return fail_with(s, e, C2D_ERR_CALLBACK, status_text(C2D_ERR_CALLBACK));
}

c2d_status follow_cycles(Session& session, const c2d_cycle_request& r, c2d_cycle_fn each, void* context, c2d_cycle_state& now) {
  const CyclePlan plan = {r.load, r.corners, r.cases, 0, CycleRule{r.tolerance, r.mode}};
  c2d_status status = C2D_OK;
  describe_cycles(session.solver, now);
  while (status == C2D_OK && goes_on(session, r.limit)) {
    status = follow_cycle(session, plan);
    if (status != C2D_OK) return status;
    describe_cycles(session.solver, now);
    status = call_back(session, each, context, now);
  }
  return status;
}

c2d_status check_results(c2d_solver* s) {
  if (s->sizes.cycle_states == 0 || cycle_record(s).head->cycles == 0)
    return fail(s, C2D_ERR_ARGUMENT, "no cycle has been followed: c2d_cycle follows them, and c2d_run after c2d_repeat_paths");
  return C2D_OK;
}

double value_of(const CyclePair& pair, int32_t field, double unit) {
  switch (field) {
  case C2D_CYCLE_RANGE: return unit * pair.range;
  case C2D_CYCLE_WALK: return unit * pair.walk;
  case C2D_CYCLE_STUCK: return pair.stuck;
  default: return pair.touched;
  }
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_cycle(c2d_solver* s, const c2d_cycle_request* request, c2d_cycle_fn each, void* context,
                                c2d_cycle_state* out) {
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status != C2D_OK) return status;
  c2d_cycle_request r;
  status = take(s, "request", request, r);
  if (status == C2D_OK) status = check_begun(s, "out", out);
  if (status == C2D_OK) status = check_request(s, r);
  if (status != C2D_OK) return status;
  if (r.limit == 0) r.limit = kCyclesByDefault;
  if (r.tolerance == 0.0) r.tolerance = kChangeByDefault;
  const bool continues = s->run_step < 0 && may_continue(s, r);
  s->run_step = 0;
  Session session;
  open_session(s, session);
  if (!continues) start_cycles(session);
  cycle_record(s).head->request = hash_of(r);
  s->outcome = C2D_REACHED;
  c2d_cycle_state now;
  status = finish(session, follow_cycles(session, r, each, context, now));
  return status == C2D_OK ? give(s, "out", now, out) : status;
}

extern "C" c2d_status c2d_get_cycle(c2d_solver* s, int32_t field, int32_t first, int32_t count, double* out, int64_t stride) {
  const InsideStep inside(s);
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status == C2D_OK) status = check_results(s);
  if (status != C2D_OK) return status;
  const int64_t pairs = s->model.pairs;
  const Ranged ranges[] = {
      {"field", field, C2D_CYCLE_RANGE, C2D_CYCLE_TOUCHED}, {"first", first, 1, pairs}, {"count", count, 0, pairs - first + 1}};
  status = check_ranges(s, ranges);
  if (status == C2D_OK && count > 0) status = check_array(s, "out", out, "stride", stride, 1, count);
  if (status != C2D_OK) return status;
  const CyclePair* pair = cycle_record(s).pair;
  for (int32_t i = 0; i < count; ++i) {
    const int32_t at = first - 1 + i;
    out[i * stride] = at < s->model.path_pairs ? value_of(pair[at], field, s->model.length_unit) : 0.0;
  }
  return C2D_OK;
}

extern "C" c2d_status c2d_get_cycle_zone(c2d_solver* s, int32_t zone, c2d_cycle_zone* out) {
  const InsideStep inside(s);
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status == C2D_OK) status = check_results(s);
  if (status != C2D_OK) return status;
  const Ranged ranges[] = {{"zone", zone, 1, s->model.zones}};
  status = check_ranges(s, ranges);
  if (status == C2D_OK) status = check_begun(s, "out", out);
  if (status != C2D_OK) return status;
  const CycleRecord record = cycle_record(s);
  const Model m = model_of(s);
  const double least = least_slip(*record.head), unit = s->model.length_unit;
  c2d_cycle_zone now{};
  double weight = 0.0;
  for (int32_t i = 0; i < s->model.path_pairs; ++i) {
    const CyclePair& pair = record.pair[i];
    if (m.pair[i].zone != zone - 1 || pair.touched == 0) continue;
    ++now.touched;
    now.stuck += pair.stuck;
    now.slipped += pair.range > least ? 1 : 0;
    now.slip_range = fmax(now.slip_range, unit * pair.range);
    now.walk += unit * m.pair[i].weight * pair.walk;
    weight += m.pair[i].weight;
  }
  if (weight > 0.0) now.walk /= weight;
  return give(s, "out", now, out);
}

extern "C" c2d_status c2d_get_cycle_state(c2d_solver* s, c2d_cycle_state* out) {
  const InsideStep inside(s);
  c2d_status status = enter(s, state_bit(C2D_STATE_RUNNING));
  if (status == C2D_OK) status = check_results(s);
  if (status == C2D_OK) status = check_begun(s, "out", out);
  if (status != C2D_OK) return status;
  c2d_cycle_state now;
  describe_cycles(s, now);
  return give(s, "out", now, out);
}
