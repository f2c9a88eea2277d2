// Cycles followed from the load reached, and what they came to (METHOD 23).
#include "interface/cycles.hpp"

#include <string.h>

#include "interface/advance.hpp"
#include "memory/math.hpp"

namespace c2d {
namespace {

int32_t result_of(const CycleHead& head, const c2d_cycle_state& now, double unit) {
  if (now.outcome != C2D_REACHED) return C2D_CYCLE_STOPPED;
  if (head.steady == 0) return C2D_CYCLE_NOT_STEADY;
  if (fabs(now.walk) > unit * fmax(least_slip(head), 1e-6 * now.slip_range / unit)) return C2D_CYCLE_RATCHETS;
  return now.slip_range > unit * least_slip(head) ? C2D_CYCLE_SLIPS : C2D_CYCLE_SHAKES_DOWN;
}

} // namespace

void describe_cycles(c2d_solver* s, c2d_cycle_state& out) {
  const CycleRecord record = cycle_record(s);
  const CycleHead& head = *record.head;
  const double unit = s->model.length_unit;
  memset(&out, 0, sizeof out);
  out.struct_size = static_cast<uint32_t>(sizeof out);
  out.outcome = s->outcome;
  out.cycles = head.cycles;
  out.extrapolations = head.extrapolations;
  out.repeated = head.repeated;
  out.change = head.change;
  out.dissipated = s->keeps_energy ? head.dissipated : 0.0;
  for (int32_t i = 0; i < s->model.path_pairs; ++i) {
    const CyclePair& pair = record.pair[i];
    out.stuck += pair.stuck;
    out.slipped += pair.touched != 0 && pair.range > least_slip(head) ? 1 : 0;
    if (unit * pair.range > out.slip_range) out.slip_range = unit * pair.range, out.range_pair = i + 1;
    const bool walks = pair.touched != 0 && unit * fabs(pair.walk) > fabs(out.walk);
    if (walks) out.walk = unit * pair.walk, out.walk_pair = i + 1;
  }
  out.result = result_of(head, out, unit);
}

bool are_alike(const double* a, const double* b, int32_t cases) {
  constexpr double kRoundOff = 1e-12; // of the load factors
  double apart = 0.0, size = 0.0;
  for (int32_t k = 0; k < cases; ++k) {
    apart = fmax(apart, fabs(a[k] - b[k]));
    size = fmax(size, fmax(fabs(a[k]), fabs(b[k])));
  }
  return apart <= kRoundOff * size;
}

c2d_status follow_cycle(Session& session, const CyclePlan& plan) {
  c2d_solver* s = session.solver;
  double* const target = array_of<double>(s, kLoads) + plan.cases;
  begin_cycle(session);
  for (int32_t i = 0; i < plan.corners; ++i) {
    for (int32_t k = 0; k < plan.cases; ++k) target[k] = plan.load[static_cast<int64_t>(i) * plan.cases + k];
    if (plan.closing_case != 0) target[plan.closing_case - 1] = 1.0;
    const c2d_status status = advance(session, target, Moment::between);
    if (status != C2D_OK || s->outcome != C2D_REACHED) return status;
    note_corner(session);
  }
  return end_cycle(session, plan.rule);
}

bool goes_on(const Session& session, int32_t limit) {
  const CycleHead& head = *cycle_record(session.solver).head;
  return head.steady == 0 && head.cycles < limit && session.solver->outcome == C2D_REACHED;
}

} // namespace c2d
