// From one event to the next: a pair touches, lifts, or starts to slip (design: tableau and events).
#include <math.h>

#include "contact/path.hpp"

namespace c2d {

namespace {

// The last pair of a body lifts at zero load exactly: a path that ends there is not cut short by round-off.
constexpr double kAllButThere = 1.0 - 1e-12;

struct Event {
  double step; // part of the piece of path, from where we stand
  int32_t pair, status, sign;
};

void keep_earlier(Event& best, double step, int32_t pair, int32_t status, int32_t sign) {
  if (step < 0.0) step = 0.0;
  if (step < best.step) best = Event{step, pair, status, sign};
}

// Where `margin` >= 0 with this rate reaches zero; nothing if it does not shrink within the rest of the piece.
void meet(Event& best, double margin, double rate, int32_t pair, int32_t status, int32_t sign) {
  if (rate < 0.0 && margin < -rate * best.step) keep_earlier(best, margin / -rate, pair, status, sign);
}

void meet_pair(const Follower& f, int32_t i, Event& best) {
  const Pair& pair = f.t->pair[i];
  const PairState now = pair_state(*f.t, i, f.y), rate = pair_rates(*f.t, i, f.dy);
  if (pair.status == C2D_OPEN) {
    const bool slides = pair.mu == 0.0;
    meet(best, now.wn, rate.wn, i, slides ? C2D_SLIP : C2D_STICK, slides ? 1 : 0);
    return;
  }
  meet(best, now.p, rate.p, i, C2D_OPEN, 0);
  if (pair.status != C2D_STICK || !pair.tangential || pair.mu > 1e300) return;
  for (int32_t sign = -1; sign <= 1; sign += 2)
    meet(best, pair.mu * now.p - sign * now.q, pair.mu * rate.p - sign * rate.q, i, C2D_SLIP, sign);
}

// Round-off must not let a rate that is zero but for its last digits make an event.
void silence_round_off(Follower& f, const PathScales& s) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    const bool open = pair.status == C2D_OPEN;
    Real& normal = f.dy[pair.dof];
    if (fabs(static_cast<double>(normal)) < 1e-13 * (open ? s.dw : s.dp)) normal = 0;
  }
}

Event nearest_event(Follower& f, double rest) {
  silence_round_off(f, path_scales(f));
  Event best{rest, -1, 0, 0};
  for (int32_t i = 0; i < f.t->pairs; ++i) meet_pair(f, i, best);
  return best;
}

void move(Follower& f, double part) {
  for (int32_t k = 0; k < f.t->cases; ++k) f.load[k] = f.origin[k] + part * f.direction[k];
}

c2d_outcome failed_outcome(int32_t status) {
  if (status == C2D_OPEN) return C2D_FREE_MOTION;
  return status == C2D_SLIP ? C2D_GROSS_SLIDING : C2D_NO_ADMISSIBLE_CHANGE;
}

c2d_status tell_change(const Follower& f) {
  return f.watch.changed ? f.watch.changed(f.watch.context, f.load[0]) : c2d_status{C2D_OK};
}

} // namespace

bool apply_change(Follower& f, int32_t index, int32_t status, int32_t sign, double at) {
  Pair& pair = f.t->pair[index];
  const bool slipped = pair.status == C2D_SLIP;
  const double from = pair_state(*f.t, index, f.y).wt;
  if (!change_status(*f.t, index, status, sign, at)) return false;
  if (slipped) pair.slip_done += (status == C2D_STICK ? at : from) - pair.slip_from;
  if (status == C2D_SLIP) pair.slip_from = from;
  ++f.stats.changes;
  f.last_pair = index;
  refresh(f);
  return true;
}

bool release_with_partner(Follower& f, int32_t k, int32_t sign, double at, const Real* rates) {
  const Tableau& t = *f.t;
  const Pair& last = t.pair[k];
  if (last.status != C2D_STICK || !last.tangential) return false;
  // dw_t of every slipping pair per unit of slip of this one, which goes against its friction.
  const Real* column = t.t + static_cast<int64_t>(last.dof + 1) * t.m;
  int32_t partner = -1;
  double nearest = 0.0;
  for (int32_t j = 0; j < t.pairs; ++j) {
    const Pair& pair = t.pair[j];
    if (pair.status != C2D_SLIP || !pair.tangential || pair.mu == 0.0) continue;
    const double back = -sign * pair.sign * static_cast<double>(column[pair.dof + 1]);
    if (back <= 1e-9) continue;
    const double reach = -pair.sign * pair_rates(t, j, rates).wt / back;
    if (partner >= 0 && reach >= nearest) continue;
    partner = j;
    nearest = reach;
  }
  if (partner < 0) return false;
  const int32_t old = t.pair[partner].sign;
  const double from = pair_state(t, partner, f.y).wt;
  if (!apply_change(f, partner, C2D_STICK, 0, from)) return false;
  if (apply_change(f, k, C2D_SLIP, sign, at)) return true;
  apply_change(f, partner, C2D_SLIP, old, from);
  return false;
}

void keep_pairs(Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    pair.saved_status = pair.status;
    pair.saved_sign = pair.sign;
    pair.saved_offset = pair.offset;
    pair.saved_slip_done = pair.slip_done;
    pair.saved_slip_from = pair.slip_from;
  }
}

c2d_status restore_pairs(Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    pair.status = pair.saved_status;
    pair.sign = pair.saved_sign;
    pair.offset = pair.saved_offset;
    pair.slip_done = pair.saved_slip_done;
    pair.slip_from = pair.saved_slip_from;
  }
  const int32_t last_pair = f.last_pair;
  const c2d_status status = build_tableau(*f.t, *f.tape, &f.last_pair);
  f.last_pair = last_pair;
  refresh(f);
  return status;
}

double slip_sum(const Follower& f, int32_t index) {
  const Pair& pair = f.t->pair[index];
  if (!pair.tangential || pair.status != C2D_SLIP) return pair.slip_done;
  return pair.slip_done + pair_state(*f.t, index, f.y).wt - pair.slip_from;
}

c2d_status find_event(Follower& f, double reach, double* part, c2d_outcome* outcome) {
  *part = 0.0;
  const c2d_status status = settle(f, outcome);
  if (status != C2D_OK || *outcome != C2D_REACHED) return status;
  const Event event = nearest_event(f, reach);
  *part = event.pair < 0 ? HUGE_VAL : event.step;
  if (event.pair >= 0) f.last_pair = event.pair;
  return C2D_OK;
}

c2d_status follow_events(Follower& f, const double* target, c2d_outcome* outcome) {
  for (int32_t k = 0; k < f.t->cases; ++k) {
    f.origin[k] = f.load[k];
    f.direction[k] = target[k] - f.load[k];
  }
  double part = 0.0;
  int64_t told = f.stats.changes;
  int32_t standing = 0; // events in a row without any progress
  for (;;) {
    c2d_status status = settle(f, outcome);
    if (status != C2D_OK) return status;
    if (*outcome != C2D_REACHED) {
      if (part < kAllButThere) return C2D_OK;
      break;
    }
    if (f.stats.changes != told) status = tell_change(f); // what the event and all that followed from it came to
    if (status != C2D_OK) return status;
    told = f.stats.changes;
    const Event event = nearest_event(f, 1.0 - part);
    if (f.watch.moving) f.watch.moving(f.watch.context, event.step);
    if (event.pair < 0) break;
    standing = part + event.step > part ? 0 : standing + 1; // steps below round-off lead nowhere, however many
    if (standing > 20 + 8 * f.t->pairs) {
      *outcome = C2D_ENDLESS_EXCHANGE;
      if (part < kAllButThere) return C2D_OK;
      break;
    }
    part += event.step;
    move(f, part);
    refresh(f);
    ++f.stats.events;
    const double at = pair_state(*f.t, event.pair, f.y).wt;
    f.last_pair = event.pair;
    if (!apply_change(f, event.pair, event.status, event.sign, at) &&
        !(event.status == C2D_SLIP && release_with_partner(f, event.pair, event.sign, at, f.dy))) {
      *outcome = failed_outcome(event.status);
      if (part < kAllButThere) return C2D_OK;
      break;
    }
  }
  *outcome = C2D_REACHED;
  for (int32_t k = 0; k < f.t->cases; ++k) f.load[k] = target[k];
  refresh(f);
  return C2D_OK;
}

} // namespace c2d
