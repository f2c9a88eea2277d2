// The thesis's own stepping on the tableau: an increment is applied at once, statuses are corrected by Table 4 until
// they agree with the values at its end. A pair that closes or turns back sticks where it was when the increment began.

#include "contact/asleep.hpp"
#include "contact/let_go.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

struct Verdict {
  int32_t status, sign;
};

// Table 4: what a pair's values at the end of the increment say about its assumed status.
Verdict table4(const Follower& f, int32_t i, const PathScales& s) {
  const Pair& pair = f.t->pair[i];
  const PairState now = pair_state(*f.t, i, f.y);
  const bool slides = pair.law.is_smooth(), adheres = !pair.law.has_bound();
  if (pair.status == C2D_OPEN) {
    if (now.wn > 0.0) return {C2D_OPEN, 0};
    return slides ? Verdict{C2D_SLIP, 1} : Verdict{C2D_STICK, 0};
  }
  if (now.p < -1e-12 * s.p) return {C2D_OPEN, 0};
  if (!pair.tangential || slides || adheres) return {pair.status, pair.sign};
  if (pair.status == C2D_STICK) {
    if (fabs(now.q) <= pair.law.bound(now.p) + 1e-12 * s.p) return {C2D_STICK, 0};
    return {C2D_SLIP, now.q > 0.0 ? 1 : -1};
  }
  const double slip = now.wt - pair.increment_from;
  if (pair.sign * slip <= 1e-12 * s.w) return {C2D_SLIP, pair.sign};
  return {C2D_STICK, 0};
}

void save(Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i) f.t->pair[i].increment_from = static_cast<Real>(pair_state(*f.t, i, f.y).wt);
  keep_pairs(f);
}

c2d_status restore(Follower& f) {
  for (int32_t k = 0; k < f.t->cases; ++k) f.load[k] = f.origin[k];
  return restore_pairs(f);
}

// The books of slip by what a pair was before the increment and is after it; what its trial states were is forgotten.
// A pair that was open and slides at the end: how it moved while open is no slip, and an increment does not tell the
// two apart, so its slip begins at the end.
void settle_books(Follower& f) {
  refresh(f);
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    pair.slip_done = pair.saved_slip_done;
    const bool slides = pair.status == C2D_SLIP;
    if (pair.saved_status == C2D_SLIP && !slides) pair.slip_done += pair.increment_from - pair.saved_slip_from;
    if (!slides) continue;
    pair.slip_from = pair.saved_status == C2D_SLIP    ? pair.saved_slip_from
                     : pair.saved_status == C2D_STICK ? pair.increment_from
                                                      : static_cast<Real>(pair_state(*f.t, i, f.y).wt);
  }
}

// One round: judge all pairs on the same values, then change. -1: a change had no pivot.
int32_t correct(Follower& f) {
  const PathScales s = path_scales(f);
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Verdict v = table4(f, i, s);
    PairMarks& mark = f.t->pair[i].mark;
    mark.changes = v.status != f.t->pair[i].status; // (none slips the other way at once)
    mark.status = static_cast<uint8_t>(v.status) & 3;
    mark.slip = static_cast<uint8_t>(v.sign + 1) & 3;
  }
  int32_t changes = 0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const PairMarks mark = f.t->pair[i].mark;
    if (!mark.changes) continue;
    if (!apply_change(f, i, mark.status, mark.slip - 1, f.t->pair[i].increment_from)) return -1;
    ++changes;
  }
  return changes;
}

} // namespace

c2d_status follow_increment(Follower& f, const double* target, int32_t iteration_limit, c2d_outcome* outcome) {
  *outcome = C2D_REACHED;
  if (is_let_go(*f.t)) return follow_events(f, target, outcome);
  end_guide(f);
  refresh(f);
  save(f);
  for (int32_t k = 0; k < f.t->cases; ++k) {
    f.origin[k] = f.load[k];
    f.direction[k] = target[k] - f.load[k];
    f.load[k] = target[k];
  }
  for (int32_t round = 1; round <= iteration_limit; ++round) {
    c2d_status status = f.watch.tick(f.watch.context);
    if (!kSmallCode && status == C2D_OK) status = wake_all(f); // the tableau may be a new one
    if (status != C2D_OK) return status;
    refresh(f);
    f.stats.iterations = round;
    const int32_t changes = correct(f);
    if (changes == 0) {
      settle_books(f);
      return C2D_OK;
    }
    if (changes < 0) break;
    ++f.stats.events;
    status = f.watch.changed(f.watch.context, f.load[0]);
    if (status != C2D_OK) return status;
  }
  ++f.stats.unconverged;
  const c2d_status status = restore(f);
  return status == C2D_OK ? follow_events(f, target, outcome) : status;
}

} // namespace c2d
