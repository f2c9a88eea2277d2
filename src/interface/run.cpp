// c2d_run: the load path of the model.
#include <string.h>

#include "interface/advance.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "results/back.hpp"
#include "results/table.hpp"
#include "solver/energy/energy.hpp"

namespace c2d {

C2D_BRINGS(c2d_get_summary); // energies
C2D_BRINGS(c2d_link_search);
C2D_MEETS(WarningPart, c2d_link_warnings);
C2D_USES(CyclePart);

namespace {

// Fills the argument of a step callback with the current state; the caller sets outcome and changes. The table is filled.
c2d_step describe_step(const Session& session, int32_t kind) {
  c2d_solver* s = session.solver;
  c2d_step now = session.now;
  now.kind = kind;
  now.load = session.follower.load[0];
  now.iterations = session.follower.stats.iterations;
  now.table = array_of<double>(s, kPairTable);
  now.cases = s->model.load_cases;
  now.loads = session.follower.load;
  now.work_by_case = kEnergyPart.work_by_case(s);
  now.work = s->work;
  now.dissipated = s->dissipated;
  now.elastic = s->elastic;
  now.energy_defect = s->energy_defect;
  return now;
}

// Calls the step callback, which may save.
c2d_status call_back(Session& session, const c2d_step& now) {
  c2d_solver* s = session.solver;
  s->busy = kInStepCallback;
  const int32_t code = session.step(session.step_context, &now);
  s->busy = 0;
  if (!kSmallCode) s->back_substituted = 0; // a state saved in the callback is restored without back substitution
  if (code == 0) return s->state == C2D_STATE_BROKEN ? s->error.status : c2d_status{C2D_OK};
  c2d_error e = blank_error();
  e.host_code = code;
  return fail_with(s, e, C2D_ERR_CALLBACK, status_text(C2D_ERR_CALLBACK));
}

c2d_status show_change(Session& session) {
  const c2d_status status = fill_table(session);
  if (status != C2D_OK) return status;
  if (session.solver->options.stepping == C2D_STEPPING_EVENTS) close_balance(session);
  return call_back(session, describe_step(session, C2D_STEP_CHANGE));
}

c2d_status show_step(Session& session, int32_t kind) {
  c2d_solver* s = session.solver;
  c2d_status status = fill_table(session);
  if (status != C2D_OK || !session.step) return status;
  c2d_step now = describe_step(session, kind);
  now.outcome = s->outcome;
  now.changes = static_cast<int32_t>(session.follower.stats.changes - session.now.changes);
  close_session(session); // so that c2d_get_summary in the callback is current
  session.now.changes = static_cast<int32_t>(session.follower.stats.changes);
  if (!kSmallCode) s->run_step = now.step;
  status = call_back(session, now);
  if (!kSmallCode) s->run_step = 0;
  return status;
}

// Factor of a case at the end of path segment p; p = -1: at the start.
double path_load(const Model& m, int32_t p, int32_t load_case) {
  return p < 0 ? 0.0 : m.path_load[static_cast<int64_t>(p) * m.head->load_cases + load_case];
}

// The segment that ends at the largest load, where the check for coarse contact is most meaningful; of equal ones the first.
int32_t largest_load(const Model& m) {
  int32_t best = 0;
  double most = -1.0;
  for (int32_t p = 0; p < m.head->paths; ++p) {
    double size = 0.0;
    for (int32_t k = 0; k < m.head->load_cases; ++k) size += fabs(path_load(m, p, k));
    if (size > most) best = p;
    if (size > most) most = size;
  }
  return best;
}

// Interference comes first: its load case rises from 0 to 1 and stays there.
c2d_status close_overlaps(Session& session) {
  c2d_solver* s = session.solver;
  double* target = array_of<double>(s, kLoads) + s->model.load_cases;
  for (int32_t k = 0; k < s->model.load_cases; ++k) target[k] = k + 1 == s->model.interference ? 1.0 : 0.0;
  const c2d_status status = advance(session, target, Moment::between);
  if (status != C2D_OK || s->outcome == C2D_REACHED) return status;
  session.now.step = 1;
  return show_step(session, C2D_STEP_STOPPED);
}

// The cycle that begins with segment p is repeated until it is steady; its steps are recorded after that.
c2d_status repeat_cycle(Session& session, int32_t p) {
  --session.now.step; // of the last step before
  const c2d_status status = kCyclePart.repeat(session, p, show_step);
  ++session.now.step;
  if (status != C2D_OK || session.solver->outcome == C2D_REACHED) return status;
  return show_step(session, C2D_STEP_STOPPED);
}

// The whole path for the current coefficients of friction, or its remainder after step `shown`.
c2d_status run_cards(Session& session, int32_t shown) {
  c2d_solver* s = session.solver;
  double* target = array_of<double>(s, kLoads) + s->model.load_cases;
  const int32_t peak = largest_load(session.model);
  session.now.step = 0;
  if (shown == 0 && s->model.interference != 0) {
    const c2d_status status = close_overlaps(session);
    if (status != C2D_OK || s->outcome != C2D_REACHED) return status;
  }
  for (int32_t p = 0; p < s->model.paths; ++p) {
    const Path& path = session.model.path[p];
    for (int32_t i = 1; i <= path.increments; ++i) {
      const bool ends = i == path.increments;
      const Moment moment = ends && p == peak ? Moment::peak : ends && p + 1 == s->model.paths ? Moment::end : Moment::between;
      if (++session.now.step == shown && !kSmallCode && moment == Moment::peak) kWarningPart.warn_facing_meshes(session);
      if (session.now.step <= shown) continue;
      if (!kSmallCode && i == 1 && path.cycle > 0) {
        const c2d_status repeated = repeat_cycle(session, p);
        if (repeated != C2D_OK || s->outcome != C2D_REACHED) return repeated;
      }
      for (int32_t k = 0; k < s->model.load_cases; ++k) {
        const double from = path_load(session.model, p - 1, k), to = path_load(session.model, p, k);
        target[k] = i == path.increments ? to : from + (to - from) * i / static_cast<double>(path.increments);
        if (fabs(target[k]) < 1e-15 * (fabs(from) + fabs(to))) target[k] = 0.0; // exactly zero, without round-off
      }
      if (s->model.interference != 0) target[s->model.interference - 1] = 1.0;
      c2d_status status = advance(session, target, moment);
      if (status != C2D_OK) return status;
      const bool reached = s->outcome == C2D_REACHED;
      status = show_step(session, reached ? C2D_STEP_RECORDED : C2D_STEP_STOPPED);
      if (status != C2D_OK || !reached) return status;
      if (moment == Moment::peak) kWarningPart.warn_facing_meshes(session);
    }
  }
  return C2D_OK;
}

c2d_status run_coefficient(Session& session, int32_t index, int32_t from, c2d_outcome* worst) {
  c2d_solver* s = session.solver;
  if (!kSmallCode) s->run_outcome = *worst;
  for (int32_t i = 0; i < s->model.path_pairs; ++i)
    session.model.pair[i].law.mu = coefficient_of_zone(s, session.model.pair[i].zone, index);
  const double mu = coefficient_of_zone(s, 0, index);
  s->mu = mu;
  s->coefficient = index + 1;
  c2d_status status = from == 0 ? begin(session) : c2d_status{C2D_OK};
  if (status != C2D_OK) return status;
  if (!kSmallCode) kCyclePart.begin_run(session, from);
  session.now.mu = mu;
  session.now.coefficient = index + 1;
  session.now.changes = static_cast<int32_t>(session.follower.stats.changes);
  if (from == 0 || s->outcome == C2D_REACHED) status = run_cards(session, from);
  if (s->outcome != C2D_REACHED && *worst == C2D_REACHED) *worst = s->outcome;
  return status;
}

} // namespace
} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_run(c2d_solver* s, c2d_step_fn step, void* context) {
  c2d_status status = enter(s, kStarted);
  if (status != C2D_OK) return status;
  if (s->model.paths == 0)
    return fail(s, C2D_ERR_ARGUMENT, "the model has no load path to run: c2d_add_path gives one, c2d_advance needs none");
  if (s->model.zones > 0 && s->model.coefficients == 0)
    return fail(s, C2D_ERR_ARGUMENT, "the model has contact but no coefficient of friction to run: c2d_add_friction gives one");
  // Position in the run at which the restored state was saved.
  int32_t from = !kSmallCode && s->state == C2D_STATE_RUNNING && s->run_step > 0 ? s->run_step : 0;
  const int32_t first = from > 0 ? s->coefficient - 1 : 0;
  c2d_outcome worst = from > 0 ? s->run_outcome : c2d_outcome{C2D_REACHED};
  s->run_step = 0;
  Session session;
  open_session(s, session);
  session.step = step;
  session.step_context = context;
  session.show_change = show_change;
  memset(&session.now, 0, sizeof session.now);
  session.now.struct_size = static_cast<uint32_t>(sizeof session.now);
  session.now.pairs = s->model.pairs;
  session.now.cases = s->model.load_cases;
  session.now.stride = C2D_PAIR_FIELDS;
  // Without contact there is no friction: one run serves all coefficients.
  const int32_t runs = s->model.contact == 0 ? 1 : s->model.coefficients;
  for (int32_t i = first; i < runs && status == C2D_OK; ++i, from = 0) status = run_coefficient(session, i, from, &worst);
  if (status == C2D_OK) status = back_substitute_all(session);
  if (status == C2D_OK && !s->blocked && !s->floating && worst == C2D_REACHED) warn_strains(session);
  status = finish(session, status);
  s->outcome = worst;
  return status;
}
