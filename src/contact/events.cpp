// From one event to the next: a pair touches, lifts, or starts to slip (METHOD 12).

#include "contact/asleep.hpp"
#include "contact/path.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(CurvePart);

namespace {

// The last pair of a body lifts at zero load exactly: a path that ends there is not cut short by round-off. That of the load at
// which it lifts is as large as that of the pressures, which is judged by the largest of the path so far.
constexpr double kAllButThere = 1.0 - 1e-12;
constexpr double kNearlyThere = 1.0 - 1e-6;
constexpr double kAnyProgress = 1e-12; // less of a piece is round-off

void keep_earlier(Event& best, double step, int32_t pair, int32_t status, int32_t sign) {
  if (step < 0.0) step = 0.0;
  if (step < best.step) best = Event{step, pair, status, sign};
}

// Values that are zero but for round-off, now and at the end of the piece, and rates that do not count; the rest of the piece.
struct Sizes {
  double value, end, rate, rest;
};

// Where `margin` >= 0 with this rate reaches zero; nothing if it does not shrink within the rest of the piece, at whose end
// round-off below zero is zero, or if it is zero already and settle() has found the rate to be none.
void meet(Event& best, double margin, double rate, const Sizes& none, int32_t pair, int32_t status, int32_t sign) {
  if (!(rate < 0.0) || margin >= -rate * best.step || margin + rate * none.rest >= -none.end) return;
  if (margin <= none.value && -rate <= none.rate) return;
  keep_earlier(best, margin / -rate, pair, status, sign);
}

void meet_pair(const Follower& f, int32_t i, const PathScales& s, double rest, Event& best) {
  const Pair& pair = f.t->pair[i];
  const PairState now = pair_state(*f.t, i, f.y), rate = pair_rates(*f.t, i, f.dy);
  const NoRate none = no_rate(pair, s);
  const double gap = kValueTolerance * s.w;
  const Sizes force{kValueTolerance * s.p, kValueTolerance * f.pressure_scale, none.force, rest};
  const Sizes motion{gap, gap, none.motion, rest};
  if (pair.status == C2D_OPEN) {
    const bool slides = pair.law.is_smooth();
    meet(best, now.wn, rate.wn, motion, i, slides ? C2D_SLIP : C2D_STICK, slides ? 1 : 0);
    return;
  }
  // Without any force now, and with none to come: its margins are round-off.
  if (f.idle && fmax(fabs(rate.p), fabs(rate.q)) <= none.force) return;
  meet(best, now.p, rate.p, force, i, C2D_OPEN, 0);
  if (pair.status != C2D_STICK || !pair.tangential || !pair.law.has_bound()) return;
  for (int32_t sign = -1; sign <= 1; sign += 2)
    meet(best, pair.law.margin(now.p, now.q, sign), pair.law.margin(rate.p, rate.q, sign), force, i, C2D_SLIP, sign);
}

// Round-off must not let a rate that is zero but for its last digits make an event.
void silence_round_off(Follower& f, const Pair& pair, const PathScales& s) {
  Real& normal = f.dy[pair.dof];
  if (fabs(static_cast<double>(normal)) < 1e-13 * (pair.status == C2D_OPEN ? s.dw : s.dp)) normal = 0;
}

Event nearest_event(Follower& f, double rest) {
  const PathScales s = same_scales(f);
  Event best{rest, -1, 0, 0};
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    silence_round_off(f, f.t->pair[i], s);
    meet_pair(f, i, s, rest, best);
  }
  return best;
}

void move(Follower& f, double part) {
  for (int32_t k = 0; k < f.t->cases; ++k) {
    f.load[k] = f.origin[k] + part * f.direction[k];
    if (fabs(f.load[k]) < 1e-14 * fabs(f.origin[k])) f.load[k] = 0.0; // a crossing, not its round-off
  }
}

// The guided pair slides, and the body with it.
void slide_guided(Follower& f, double step) {
  Tableau& t = *f.t;
  if (t.guided == 0) return;
  Pair& pair = t.pair[t.guided - 1];
  const Real by = static_cast<Real>(step * f.guide);
  pair.offset += by;
  add_column_to(t, column_of(t, t.guided - 1, 1), by, constants(t));
}

// Gaps that follow slip have moved on, and what they move.
void move_gaps(const Tableau& t, double step) {
  if (!follows_slip(t)) return;
  for (int32_t i = 0; i < t.pairs; ++i) t.slip[i].now += step * t.slip[i].rate;
  for (int32_t i = 0; i < t.m; ++i) constants(t)[i] += static_cast<Real>(step) * slip_rates(t)[i];
}

// Does the path go on in the direction of the piece before it, from a load that is not zero?
bool goes_straight_on(const Follower& f, const double* target) {
  double both = 0.0, old = 0.0, now = 0.0, load = 0.0;
  for (int32_t k = 0; k < f.t->cases; ++k) {
    const double step = target[k] - f.load[k];
    both += step * f.direction[k];
    old += f.direction[k] * f.direction[k];
    now += step * step;
    load += f.load[k] * f.load[k];
  }
  return load > 0.0 && both > 0.0 && both * both >= (1.0 - 1e-12) * old * now;
}

// ---- friction without bound ---------------------------------------------------------------------------------------------

// A pair whose friction has no bound sticks as long as it has pressure, and lets go of all its friction where that ends: the
// state jumps.
bool may_jump(const Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i)
    if (f.t->pair[i].tangential && !f.t->pair[i].law.has_bound()) return true;
  return false;
}

// How far a pair's values are beyond its conditions, of the largest; 0: they are not.
double beyond(const Follower& f, int32_t i, const PathScales& s) {
  const PairState now = pair_state(*f.t, i, f.y);
  const bool open = f.t->pair[i].status == C2D_OPEN;
  const double size = open ? -now.wn : -now.p, scale = open ? s.w : s.p;
  return size > 10.0 * kValueTolerance * scale ? size / scale : 0.0;
}

// What a jump has brought together touches where it has come to, what it has torn lifts, the worst pair first. False: nothing
// of that kind, or no end of it.
bool land(Follower& f) {
  for (int32_t changes = 0; changes < 8 + 4 * f.t->pairs; ++changes) {
    const PathScales s = decision_scales(f);
    int32_t worst = -1;
    double most = 0.0;
    for (int32_t i = 0; i < f.t->pairs; ++i) {
      const double size = beyond(f, i, s);
      if (size > (1.0 + 1e-6) * most) worst = i, most = size;
    }
    if (worst < 0) return changes > 0;
    end_guide(f);
    const Pair& pair = f.t->pair[worst];
    int32_t to = C2D_OPEN;
    if (pair.status == C2D_OPEN) to = pair.law.is_smooth() ? C2D_SLIP : C2D_STICK;
    if (!apply_change(f, worst, to, to == C2D_SLIP ? 1 : 0, pair_state(*f.t, worst, f.y).wt)) return changes > 0;
  }
  return false;
}

// Statuses that agree with the rates, and behind a jump with the values, too.
c2d_status settle_all(Follower& f, bool jumps, c2d_outcome* outcome) {
  constexpr int kRounds = 8;
  const bool told = jumps && f.watch.jumping;
  c2d_status status = told ? f.watch.jumping(f.watch.context, false) : c2d_status{C2D_OK};
  if (status == C2D_OK) status = settle(f, outcome);
  for (int i = 0; i < kRounds && jumps && status == C2D_OK && *outcome == C2D_REACHED && land(f); ++i)
    status = settle(f, outcome);
  if (told && status == C2D_OK) status = f.watch.jumping(f.watch.context, true);
  return status;
}

c2d_status tell_change(const Follower& f) {
  return f.watch.changed ? f.watch.changed(f.watch.context, f.load[0]) : c2d_status{C2D_OK};
}

} // namespace

void hold_gaps(const Tableau& t) {
  if (!follows_slip(t)) return;
  for (int32_t i = 0; i < t.pairs; ++i) t.slip[i].rate = 0.0;
  for (int32_t i = 0; i < t.m; ++i) slip_rates(t)[i] = 0;
}

bool apply_change(Follower& f, int32_t index, int32_t status, int32_t sign, double at) {
  Pair& pair = f.t->pair[index];
  const bool slipped = pair.status == C2D_SLIP;
  const double from = pair_state(*f.t, index, f.y).wt;
  if (!change_status(*f.t, index, status, sign, at)) return false;
  if (slipped) pair.slip_done += static_cast<Real>((status == C2D_STICK ? at : from) - pair.slip_from);
  if (status == C2D_SLIP) pair.slip_from = static_cast<Real>(from);
  ++f.stats.changes;
  f.last_pair = index;
  refresh(f);
  return true;
}

void set_status(Follower& f, int32_t index, int32_t status, int32_t sign) {
  Pair& pair = f.t->pair[index];
  if (pair.status == status && pair.sign == sign) return;
  const double from = pair_state(*f.t, index, f.y).wt;
  if (pair.status == C2D_SLIP) pair.slip_done += static_cast<Real>(from - pair.slip_from);
  if (status == C2D_SLIP) pair.slip_from = static_cast<Real>(from);
  if (status == C2D_STICK) pair.offset = static_cast<Real>(from);
  pair.status = static_cast<int8_t>(status);
  pair.sign = static_cast<int8_t>(sign);
  ++f.stats.changes;
  f.last_pair = index;
  forget(f.kept);
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
  return rebuild(f);
}

c2d_status rebuild(Follower& f) {
  int32_t culprit;
  const c2d_status status = build_tableau(*f.t, *f.tape, &culprit);
  refresh(f);
  if (kSmallCode || status != C2D_OK || !some_sleep(*f.t)) return status;
  PathScales s = path_scales(f);
  s.w = fmax(s.w, f.gap_scale);
  return wake_touching(f, s);
}

double slip_sum(const Follower& f, int32_t index) {
  const Pair& pair = f.t->pair[index];
  if (!pair.tangential || pair.status != C2D_SLIP) return pair.slip_done;
  return pair.slip_done + pair_state(*f.t, index, f.y).wt - pair.slip_from;
}

c2d_status find_event(Follower& f, double reach, double* part, c2d_outcome* outcome) {
  *part = 0.0;
  hold_gaps(*f.t);
  refresh(f);
  const c2d_status status = settle(f, outcome);
  if (status != C2D_OK || *outcome != C2D_REACHED) return status;
  const Event event = nearest_event(f, reach);
  *part = event.pair < 0 ? HUGE_VAL : event.step;
  if (event.pair >= 0) f.last_pair = event.pair;
  return C2D_OK;
}

// The path ends here, unless what is left of the piece is round-off: hardly any of it, or no pressure on the way to no load.
static bool is_short(const Follower& f, double part) {
  if (part >= kAllButThere) return false;
  bool to_zero = true;
  for (int32_t k = 0; k < f.t->cases; ++k) to_zero = to_zero && f.origin[k] + f.direction[k] == 0.0;
  const double round_off = kRateTolerance * f.pressure_scale + kMixedNoise * f.t->stiffness * f.gap_scale;
  return (part < kNearlyThere && !to_zero) || path_scales(f).p > round_off;
}

// Bodies rest along motions on which the loads so far do no work. Do those of this piece?
static c2d_status rebuild_for(Follower& f, const double* target, c2d_outcome* outcome) {
  c2d_status status = rebuild(f);
  if (status != C2D_ERR_SINGULAR) return status;
  *outcome = C2D_FREE_MOTION;
  for (int32_t k = 0; k < f.t->cases; ++k) f.direction[k] = 0.0;
  status = rebuild(f);
  for (int32_t k = 0; k < f.t->cases; ++k) f.direction[k] = target[k] - f.load[k];
  return status;
}

// Where gaps follow slip they are aimed at ends of so many parts of a piece at least: they go there along chords.
constexpr double kLegs = 4.0;
static double goal_from(const Follower& f, double part) {
  return follows_slip(*f.t) ? fmin(1.0, (floor(kLegs * part + 1e-6) + 1.0) / kLegs) : 1.0;
}

// Statuses that agree with the rates, and with what slip at these rates adds to the gaps up to the goal.
static c2d_status settle_to(Follower& f, bool jumps, double rest, c2d_outcome* outcome) {
  c2d_status status = settle_all(f, jumps, outcome);
  if (!follows_slip(*f.t) || status != C2D_OK || *outcome != C2D_REACHED) return status;
  f.goes_on = true;
  kCurvePart.aim_gaps(f, rest);
  return settle_all(f, jumps, outcome);
}

c2d_status follow_events(Follower& f, const double* target, c2d_outcome* outcome) {
  *outcome = C2D_REACHED;
  f.goes_on = goes_straight_on(f, target);
  for (int32_t k = 0; k < f.t->cases; ++k) {
    f.origin[k] = f.load[k];
    f.direction[k] = target[k] - f.load[k];
  }
  c2d_status begun = C2D_OK;
  if (f.t->resting > 0) begun = rebuild_for(f, target, outcome);
  if (begun != C2D_OK || *outcome != C2D_REACHED) return begun;
  hold_gaps(*f.t);
  refresh(f);
  double part = 0.0, before = 0.0;
  int64_t told = f.stats.changes;
  int32_t standing = 0; // events in a row that together come nowhere, however many
  const bool jumps = may_jump(f);
  for (;;) {
    const double goal = goal_from(f, part);
    c2d_status status = settle_to(f, jumps, goal - part, outcome);
    if (status != C2D_OK || (*outcome != C2D_REACHED && is_short(f, part))) return status;
    if (*outcome != C2D_REACHED) break;
    f.goes_on = true;
    if (f.stats.changes != told) status = tell_change(f); // what the event and all that followed from it came to
    if (status != C2D_OK) return status;
    told = f.stats.changes;
    const Event event = nearest_event(f, goal - part);
    if (f.watch.moving) f.watch.moving(f.watch.context, event.step);
    slide_guided(f, event.step);
    move_gaps(*f.t, event.step);
    if (event.pair < 0 && goal == 1.0) break;
    standing = part + event.step > before + kAnyProgress ? 0 : standing + 1;
    if (standing == 0) before = part + event.step;
    if (standing > 20 + 8 * f.t->pairs) {
      *outcome = C2D_NO_PROGRESS;
      if (is_short(f, part)) return C2D_OK;
      break;
    }
    part += event.step;
    move(f, part);
    refresh(f);
    if (event.pair < 0) continue; // the goal, not the end
    ++f.stats.events;
    f.last_pair = event.pair;
    f.bound = event;
  }
  *outcome = C2D_REACHED;
  for (int32_t k = 0; k < f.t->cases; ++k) f.load[k] = target[k];
  refresh(f);
  return C2D_OK;
}

} // namespace c2d
