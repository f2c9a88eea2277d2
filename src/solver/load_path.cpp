#include "solver/load_path.hpp"

#include <string.h>

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "solver/energy/energy.hpp"
#include "solver/judge.hpp"

namespace c2d {

C2D_USES(BodyForcePart);
C2D_USES(EnergyPart);
C2D_USES(SearchPart);
C2D_USES(WarningPart);

void note_open_pairs(Session& session) {
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    Pair& pair = session.model.pair[i];
    if (pair.status == C2D_OPEN) pair.slip_before = pair.slip_done;
  }
}

namespace {

c2d_status tick(void* context) {
  Session& session = *static_cast<Session*>(context);
  c2d_solver* s = session.solver;
  tell_progress(s, C2D_PHASE_CONTACT, 0, session.follower.stats.events, 0);
  return session.may_stop && asked_to_stop(s) ? C2D_ERR_CANCELLED : C2D_OK;
}

// A status changed: judge what that came to, after every so many exchanges, and show it to c2d_run's callback, if it asked for
// that. Within an increment of deck stepping statuses do not agree with the values yet.
c2d_status changed(void* context, double) {
  Session& session = *static_cast<Session*>(context);
  constexpr int64_t kBetweenLooks = 16; // exchanges between pairs that stand well leave nothing to see
  const c2d_options& options = session.solver->options;
  if (options.stepping == C2D_STEPPING_EVENTS) note_open_pairs(session); // others are still on trial
  const bool shown = session.step && options.every_change;
  const Agree with = options.stepping == C2D_STEPPING_EVENTS ? Agree::rates : Agree::nothing;
  // What is shown must not change the path: where no look is due, a state beyond the limits is passed over.
  const bool due =
      session.solver->careful != 0 || session.tableau.exchanges - session.solver->judged_exchanges >= kBetweenLooks;
  const c2d_status status = due ? judge(session, with) : c2d_status{C2D_OK};
  if (status != C2D_OK || !shown || (!due && !may_be_shown(session, with))) return status;
  return session.show_change(session);
}

void moving(void* context, double part) {
  Session& session = *static_cast<Session*>(context);
  if (session.solver->keeps_energy) kEnergyPart.add_segment(session, part);
}

c2d_status jumping(void* context, bool done) {
  Session& session = *static_cast<Session*>(context);
  // Where nothing catches what jumps, the path ends at the load of the event, however it is divided.
  const bool event = !done && session.follower.bound.pair >= 0;
  const c2d_status status = event ? judge(session, Agree::values) : c2d_status{C2D_OK};
  if (status != C2D_OK || !session.solver->keeps_energy) return status;
  if (done)
    kEnergyPart.release(session);
  else
    kEnergyPart.before_jump(session);
  return status;
}

} // namespace

PathWatch path_watch(Session& session) { return PathWatch{&session, tick, changed, moving, jumping}; }

namespace {

// Most of a tableau on demand is never written: where memory is handed out page by page, what is zero stays without a page.
void clear_unless_zero(char* from, char* end) {
  constexpr int64_t kPart = 4096;
  for (char *part = from, *next; part < end; part = next) {
    next = end - part < kPart ? end : part + kPart;
    const char* at = part;
    while (at < next && *at == 0) ++at;
    if (at < next) memset(part, 0, static_cast<size_t>(next - part));
  }
}

// What the caller had in this memory before is not to reach a tape with a state of the path (solver/save.cpp).
void clear_between(const Session& session, void* from, void* end) {
  char *const first = static_cast<char*>(from), *const last = static_cast<char*>(end);
  if (!kHostile && !kWatched && is_on_demand(session.model)) return clear_unless_zero(first, last);
  if (!kHostile) memset(first, 0, static_cast<size_t>(last - first));
}

// All but what mean motions are found from, where that is known: all paths of a preparation have it in common.
void clear_path(Session& session) {
  const PathArea& area = session.area;
  void *from = area.buffer, *const end = area.motion + model_sizes(session.model).widest;
  if (session.solver->mean_motions != 0) clear_between(session, from, area.mean_motion), from = area.u[0];
  clear_between(session, from, end);
}

} // namespace

c2d_status begin_path(Session& session) {
  c2d_solver* s = session.solver;
  const ModelHeader& head = s->model;
  clear_path(session);
  for (int32_t k = 0; k < 4 * head.load_cases; ++k) array_of<double>(s, kLoads)[k] = 0.0;
  s->outcome = C2D_REACHED;
  s->last_pair = session.follower.last_pair = -1; // none yet
  s->outcome_body = s->back_substituted = s->table_is_current = s->floating = 0;
  s->warned = 0;
  session.tableau.guided = session.tableau.may_rest = session.tableau.resting = 0;
  if (s->keeps_energy) kEnergyPart.begin_energy(s);
  s->peak_pressure = 0.0;
  s->gap_scale = session.follower.gap_scale = 0.0;
  s->unsound = 0;
  session.follower.solutions = 0;
  session.follower.more_solutions = session.follower.range = false;
  s->pressure_scale = session.follower.pressure_scale = 0.0;
  session.may_stop = false; // half of a state would be none
  if (s->blocked || head.contact == 0) return C2D_OK;
  note_free_body(session);
  c2d_status status = load_flexibility(session);
  if (status == C2D_OK) status = start_path(session.follower, &s->floating);
  if (status == C2D_OK) begin_judging(session);
  return status;
}

namespace {

bool all_zero(const double* numbers, int32_t count) {
  for (int32_t i = 0; i < count; ++i)
    if (numbers[i] != 0.0) return false;
  return true;
}

// Resultant of a load case on a body: force and moment about its centre; sum of magnitudes. Part of an element's tractions.
void add_tractions(const Model& m, int b, int32_t element, const EndResultant* weight, int32_t load_case, double out[4]) {
  const double unit = m.head->length_unit, cx = m.body[b].centre[0] / unit, cy = m.body[b].centre[1] / unit;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t end = element * m.head->function_nodes + l;
    const double t[2] = {given_traction(m, b, end, 0, load_case), given_traction(m, b, end, 1, load_case)};
    if (t[0] == 0.0 && t[1] == 0.0) continue; // most cases load other ends
    const EndResultant& w = weight[l];
    out[0] += w.w * unit * t[0];
    out[1] += w.w * unit * t[1];
    out[2] += unit * ((w.wx - cx * w.w) * t[1] - (w.wy - cy * w.w) * t[0]);
    out[3] += w.w * unit * (fabs(t[0]) + fabs(t[1]));
  }
}

void add_point_load(const Model& m, int b, const PointLoad& p, double out[4]) {
  const double unit = m.head->length_unit;
  out[0] += p.fx;
  out[1] += p.fy;
  out[2] += (p.x - m.body[b].centre[0]) / unit * p.fy - (p.y - m.body[b].centre[1]) / unit * p.fx;
  out[3] += fabs(p.fx) + fabs(p.fy);
}

// What acts on a rigid body, and body forces.
void add_whole_body(const Model& m, int b, int32_t load_case, double out[4]) {
  const Body& body = m.body[b];
  const double unit = m.head->length_unit;
  if (is_rigid(m, b)) {
    const double* load = m.rigid_motion[b][load_case].load;
    for (int i = 0; i < 3; ++i) out[i] += (body.free_rigidly >> i & 1) == 0 ? 0.0 : load[i] / (i < 2 ? 1.0 : unit);
    out[3] += fabs(out[0]) + fabs(out[1]) + fabs(out[2]);
    return;
  }
  if (!has_body_force(m, b)) return;
  double force[3] = {0.0, 0.0, 0.0};
  kBodyForcePart.body_force_resultant(m, b, load_case, body.centre[0], body.centre[1], force);
  for (int i = 0; i < 2; ++i) out[i] += force[i];
  out[2] += force[2] / unit;
  out[3] += fabs(force[0]) + fabs(force[1]);
}

// Of load cases first ... last - 1, four numbers each.
void find_resultants(const Model& m, int b, int32_t first, int32_t last, double* out) {
  const auto of_case = [&](int32_t k) { return out + 4 * static_cast<int64_t>(k - first); };
  for (int32_t k = first; k < last; ++k)
    for (int i = 0; i < 4; ++i) of_case(k)[i] = 0.0;
  for (int32_t element = 0; element < m.body[b].elements && !is_rigid(m, b); ++element) {
    if (!is_integrated(m, b, element)) continue;
    EndResultant weight[kElementNodes];
    end_resultants(m, b, element, Measure::own_length, weight);
    for (int32_t k = first; k < last; ++k) add_tractions(m, b, element, weight, k, of_case(k));
  }
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& p = m.point_load[i];
    if (p.body == b && p.load_case >= first && p.load_case < last) add_point_load(m, b, p, of_case(p.load_case));
  }
  for (int32_t k = first; k < last; ++k) add_whole_body(m, b, k, of_case(k));
}

// Work of loads on a motion of the free body; zero if it is no more than round-off.
double work_on(const Session& session, const double* loads, const double motion[3]) {
  double size = 0.0;
  const double work = load_work(session, session.free_body.body, loads, motion, &size);
  return fabs(work) > 1e-10 * size ? work : 0.0;
}

c2d_status take_off(Session& session, const double* target, c2d_outcome* outcome) {
  c2d_solver* s = session.solver;
  Follower& f = session.follower;
  for (int32_t k = 0; k < f.t->cases; ++k) f.direction[k] = target[k] - f.load[k];
  *outcome = C2D_FREE_MOTION;
  const c2d_status status = kSearchPart.seat(f, s->floating, outcome);
  if (status == C2D_OK && *outcome == C2D_REACHED) s->floating = 0;
  return status;
}

c2d_status follow(Session& session, const double* target, c2d_outcome* outcome) {
  c2d_solver* s = session.solver;
  Follower& f = session.follower;
  if (s->options.stepping != C2D_STEPPING_DECK) return follow_events(f, target, outcome);
  refresh(f);
  if (s->keeps_energy) kEnergyPart.before_jump(session);
  const int32_t by_events = f.stats.unconverged;
  const c2d_status status = follow_increment(f, target, s->model.iteration_limit, outcome);
  if (status == C2D_OK && f.stats.unconverged == by_events && s->keeps_energy) kEnergyPart.after_jump(session);
  return status;
}

} // namespace

double load_work(const Session& session, int b, const double* direction, const double motion[3], double* size) {
  double work = 0.0;
  *size = 0.0;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k) {
    if (direction[k] == 0.0) continue; // of many cases a segment of a path moves two
    double force[4];
    find_resultants(session.model, b, k, k + 1, force);
    for (int i = 0; i < 3; ++i) work += direction[k] * force[i] * motion[i];
    *size += fabs(direction[k]) * force[3];
  }
  return work;
}

void find_load_work(const Session& session, int b) {
  const Model& m = session.model;
  const Body& body = m.body[b];
  find_resultants(m, b, 0, m.head->load_cases, m.load_work[b]);
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    double* const out = m.load_work[b] + 4 * static_cast<int64_t>(k);
    double work[3] = {0.0, 0.0, 0.0};
    for (int32_t j = 0; j < body.free_motions; ++j)
      for (int i = 0; i < 3; ++i) work[j] += out[i] * body.free_motion[j][i];
    for (int i = 0; i < 3; ++i) out[i] = work[i];
  }
}

namespace {

bool is_motion(c2d_outcome outcome) {
  return outcome == C2D_FREE_MOTION || outcome == C2D_GROSS_SLIDING || outcome == C2D_TIPPING;
}
bool is_motion(const double motion[3]) { return motion[0] != 0.0 || motion[1] != 0.0 || motion[2] != 0.0; }

// The name of an outcome and the motion that begins, of a body that the contact has to hold. Where nothing is pressed any
// more nothing slides, and where it does not turn, it does not tip over.
void name_motion(Session& session, c2d_outcome outcome) {
  c2d_solver* s = session.solver;
  const bool unloaded = s->peak_pressure > 0.0 && path_scales(session.follower).p <= kNoPressure * s->peak_pressure;
  if (outcome == C2D_GROSS_SLIDING && unloaded) outcome = C2D_FREE_MOTION;
  s->outcome = outcome;
  const int32_t moving = session.free_body.body >= 0 ? session.free_body.body : session.follower.moving;
  s->outcome_body = s->blocked ? s->blocked : moving + 1;
  if (!s->keeps_energy) return;
  kEnergyPart.find_outcome_motion(session, outcome);
  if (outcome == C2D_TIPPING && is_motion(s->outcome_motion) && s->outcome_motion[2] == 0.0)
    s->outcome = unloaded ? C2D_FREE_MOTION : C2D_GROSS_SLIDING;
}

// That there are no rates, although forces could balance those of the loads, is told as the motion of a body that the contact
// has to hold, if its pairs allow one.
void name_outcome(Session& session, c2d_outcome outcome) {
  c2d_solver* s = session.solver;
  s->outcome = outcome;
  if (is_motion(outcome)) name_motion(session, outcome);
  if (outcome != C2D_NO_ADMISSIBLE_CHANGE) return;
  name_motion(session, C2D_GROSS_SLIDING);
  if (is_motion(s->outcome_motion)) return;
  s->outcome = outcome;
  s->outcome_body = 0;
}

// Do these loads do work on a motion in which the body slides freely? Those reached so far do not.
bool slides_away(const Session& session, const double* target) {
  return session.free_body.slides > 0 && work_on(session, target, session.free_body.slide) != 0.0;
}

// To `target`, or as far as the path leads, and judged there.
c2d_status go(Session& session, const double* target, c2d_outcome* outcome) {
  c2d_solver* s = session.solver;
  Follower& f = session.follower;
  if (slides_away(session, target)) {
    *outcome = C2D_FREE_MOTION;
    for (int32_t k = 0; k < f.t->cases; ++k) f.direction[k] = target[k] - f.load[k];
    if (!s->floating) refresh(f);
    return C2D_OK;
  }
  const int32_t cases = s->model.load_cases;
  const bool from_zero = all_zero(f.load, cases);
  *outcome = C2D_REACHED;
  c2d_status status = C2D_OK;
  if (s->floating) status = take_off(session, target, outcome);
  if (status == C2D_OK && *outcome == C2D_REACHED) status = follow(session, target, outcome);
  // What touches at zero load does not hold them: nothing is loaded yet, so the bodies may move on to other pairs once.
  // (Where there is a load, forces balance it that show the way to more of it.)
  if (status == C2D_OK && is_motion(*outcome) && from_zero && !C2D_NEVER(!all_zero(f.load, cases))) {
    const c2d_outcome from_here = *outcome;
    status = take_off(session, target, outcome);
    if (status == C2D_OK && *outcome == C2D_REACHED)
      status = follow(session, target, outcome);
    else
      *outcome = from_here;
  }
  if (status != C2D_OK) return status;
  const bool by_rates = *outcome == C2D_REACHED && s->options.stepping == C2D_STEPPING_EVENTS;
  return judge(session, by_rates ? Agree::rates : Agree::values);
}

bool is_lost(c2d_status status) { return status == kUnsound || status == C2D_ERR_SINGULAR; }

// A tableau that is not new may have found nothing admissible where there is something: jumps under friction without bound are
// rounds of changes, and what decides between two of them may be round-off.
bool may_find_more(const Session& session, c2d_outcome outcome) {
  return outcome == C2D_NO_ADMISSIBLE_CHANGE && session.tableau.exchanges != session.solver->built_exchanges;
}

// What the limits do not admit is tried once more from the last good state, with a new tableau after every change; then
// the path ends there.
c2d_status go_soundly(Session& session, const double* target, c2d_outcome* outcome) {
  c2d_solver* s = session.solver;
  c2d_status status = go(session, target, outcome);
  if (is_lost(status) || (status == C2D_OK && may_find_more(session, *outcome))) {
    s->careful = 1;
    status = return_to_good(session);
    if (status == C2D_OK) status = go(session, target, outcome);
    s->careful = 0;
  }
  if (!is_lost(status)) return status;
  if (status == C2D_ERR_SINGULAR) s->breach = C2D_BREACH_SINGULAR;
  *outcome = C2D_BEYOND_LIMITS;
  status = s->unsound ? c2d_status{C2D_OK} : return_to_good(session);
  kWarningPart.warn_breach(s);
  return is_lost(status) ? c2d_status{C2D_OK} : status;
}

} // namespace

c2d_status advance_path(Session& session, const double* target) {
  c2d_solver* s = session.solver;
  Follower& f = session.follower;
  s->back_substituted = s->table_is_current = 0;
  f.moving = -1; // what a piece of the path before found is not of this one
  const int32_t cases = s->model.load_cases;
  if (s->blocked || s->unsound) {
    for (int32_t k = 0; k < s->model.load_cases && s->blocked; ++k) f.direction[k] = target[k] - f.load[k];
    name_outcome(session, s->blocked ? C2D_FREE_MOTION : C2D_BEYOND_LIMITS);
    return C2D_OK;
  }
  c2d_outcome outcome = C2D_REACHED;
  if (s->keeps_energy) kEnergyPart.note_turn(session, target);
  if (s->model.contact == 0 || (s->floating && all_zero(target, cases))) {
    for (int32_t k = 0; k < cases; ++k) f.direction[k] = target[k] - f.load[k];
    if (!s->floating && s->keeps_energy) kEnergyPart.add_segment(session, 1.0);
    for (int32_t k = 0; k < cases; ++k) f.load[k] = target[k];
    if (!s->floating && s->keeps_energy) kEnergyPart.close_balance(session);
    s->outcome = outcome;
    return C2D_OK;
  }
  const double start = clock_now(s);
  for (int32_t k = 0; k < cases; ++k) array_of<double>(s, kLoads)[cases + k] = target[k];
  const c2d_status status = go_soundly(session, target, &outcome);
  if (status == C2D_OK && !s->floating) {
    if (!s->unsound) refresh(f);
    if (s->keeps_energy) kEnergyPart.close_balance(session);
  }
  s->peak_pressure = fmax(s->peak_pressure, path_scales(session.follower).p);
  s->seconds[C2D_PHASE_CONTACT] += clock_now(s) - start;
  name_outcome(session, outcome);
  return status;
}

} // namespace c2d
