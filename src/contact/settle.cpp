// Statuses that agree with the rates: the complementarity problem within one load (design: starts (b) and (c)).
#include <math.h>

#include "contact/path.hpp"

namespace c2d {

namespace {

// Round-off of values after some thousand exchanges stays below 1e-12 of their scale; rates are differences of them.
constexpr double kValueTolerance = 1e-11;
constexpr double kRateTolerance = 1e-9;

double larger(double a, double b) { return a > b ? a : b; }

struct Violation {
  double size; // 0: none
  int32_t status, sign;
};

bool is_finite_friction(const Pair& pair) { return pair.mu <= 1e300; }

// A pair in contact whose pressure is zero: it may stay only if its pressure grows.
Violation judge_unloaded(const Pair& pair, const PairState& rate, const PathScales& s) {
  if (s.dp > 0.0 && rate.p < -kRateTolerance * s.dp) return {-rate.p / s.dp, C2D_OPEN, 0};
  if (pair.status == C2D_STICK && pair.tangential && is_finite_friction(pair)) {
    const double excess = fabs(rate.q) - pair.mu * larger(rate.p, 0.0);
    if (s.dp > 0.0 && excess > kRateTolerance * s.dp) return {excess / s.dp, C2D_SLIP, rate.q > 0.0 ? 1 : -1};
  }
  return {0.0, 0, 0};
}

Violation judge_sticking(const Pair& pair, const PairState& now, const PairState& rate, const PathScales& s) {
  if (!pair.tangential || !is_finite_friction(pair)) return {0.0, 0, 0};
  if (pair.mu * now.p - fabs(now.q) > kValueTolerance * (1.0 + pair.mu) * s.p) return {0.0, 0, 0};
  const int32_t sign = now.q > 0.0 ? 1 : -1;
  const double excess = sign * rate.q - pair.mu * rate.p;
  if (s.dp > 0.0 && excess > kRateTolerance * s.dp) return {excess / s.dp, C2D_SLIP, sign};
  return {0.0, 0, 0};
}

// Friction on body 2 opposes its motion relative to body 1: sign * dw_t <= 0.
Violation judge_slipping(const Pair& pair, const PairState& rate, const PathScales& s) {
  if (!pair.tangential || pair.mu == 0.0) return {0.0, 0, 0};
  const double back = pair.sign * rate.wt;
  if (s.dw > 0.0 && back > kRateTolerance * s.dw) return {back / s.dw, C2D_STICK, 0};
  return {0.0, 0, 0};
}

Violation judge(const Follower& f, int32_t i, const PathScales& s) {
  const Pair& pair = f.t->pair[i];
  const PairState now = pair_state(*f.t, i, f.y), rate = pair_rates(*f.t, i, f.dy);
  if (pair.status == C2D_OPEN) {
    if (now.wn > kValueTolerance * s.w || s.dw <= 0.0 || rate.wn >= -kRateTolerance * s.dw) return {0.0, 0, 0};
    const bool slides = pair.mu == 0.0;
    return {-rate.wn / s.dw, slides ? C2D_SLIP : C2D_STICK, slides ? 1 : 0};
  }
  if (now.p <= kValueTolerance * s.p) {
    const Violation v = judge_unloaded(pair, rate, s);
    if (v.size > 0.0 || pair.status == C2D_STICK) return v;
  }
  return pair.status == C2D_STICK ? judge_sticking(pair, now, rate, s) : judge_slipping(pair, rate, s);
}

// A fingerprint of all statuses and signs, to notice a set that was there before.
uint64_t fingerprint(const Tableau& t) {
  uint64_t hash = 1469598103934665603u;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const int32_t code = t.pair[i].status == C2D_SLIP ? 3 + t.pair[i].sign : t.pair[i].status;
    hash = (hash ^ static_cast<uint64_t>(code + 1)) * 1099511628211u;
  }
  return hash;
}

constexpr int kSeen = 32;
struct Memory { // of the last sets of statuses
  uint64_t seen[kSeen];
  int count;
  bool knows(uint64_t hash) const {
    for (int i = 0; i < kSeen && i < count; ++i)
      if (seen[i] == hash) return true;
    return false;
  }
  void add(uint64_t hash) { seen[count++ % kSeen] = hash; }
};

struct Round {
  int32_t offenders, changed;
  int32_t stuck_status; // what a change that had no pivot wanted
};

bool apply(Follower& f, int32_t i, const Violation& v) {
  const PairState now = pair_state(*f.t, i, f.y);
  if (apply_change(f, i, v.status, v.sign, now.wt)) return true;
  refresh(f);
  return v.status == C2D_SLIP && release_with_partner(f, i, v.sign, now.wt, f.dy);
}

// Change every offender, judged on the rates as they stand before.
Round change_all(Follower& f, const PathScales& s) {
  Round round{0, 0, C2D_STICK};
  Tableau& t = *f.t;
  for (int32_t i = 0; i < t.pairs; ++i) t.pair[i].weak = judge(f, i, s).size > 0.0;
  // Values and rates are read before the first exchange of the round changes their meaning.
  for (int32_t i = 0; i < t.pairs; ++i) {
    if (!t.pair[i].weak) continue;
    ++round.offenders;
    refresh(f);
    const Violation v = judge(f, i, s);
    if (v.size <= 0.0) continue; // mended by the changes before it
    if (apply(f, i, v)) {
      ++round.changed;
    } else {
      round.stuck_status = v.status;
      f.last_pair = i;
    }
  }
  return round;
}

// Change only the largest offender that can be changed; `lowest`: the first one.
Round change_one(Follower& f, const PathScales& s, bool lowest) {
  Round round{0, 0, C2D_STICK};
  Tableau& t = *f.t;
  for (int32_t i = 0; i < t.pairs; ++i) t.pair[i].weak = 0;
  for (;;) {
    int32_t best = -1;
    Violation worst{0.0, 0, 0};
    for (int32_t i = 0; i < t.pairs; ++i) {
      if (t.pair[i].weak) continue;
      const Violation v = judge(f, i, s);
      if (v.size <= 0.0) continue;
      ++round.offenders;
      if (best < 0 || (!lowest && v.size > worst.size * (1.0 + 1e-6))) {
        best = i;
        worst = v;
      }
    }
    if (best < 0) return round;
    if (apply(f, best, worst)) {
      ++round.changed;
      return round;
    }
    t.pair[best].weak = 1; // cannot be changed: try the next
    round.stuck_status = worst.status;
    f.last_pair = best;
  }
}

c2d_outcome stuck_outcome(int32_t wanted) {
  if (wanted == C2D_OPEN) return C2D_FREE_MOTION;
  if (wanted == C2D_SLIP) return C2D_GROSS_SLIDING;
  return C2D_NO_ADMISSIBLE_CHANGE;
}

} // namespace

PathScales path_scales(const Follower& f) {
  PathScales s{0.0, f.gap_scale, 0.0, 0.0};
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const PairState now = pair_state(*f.t, i, f.y), rate = pair_rates(*f.t, i, f.dy);
    s.p = larger(s.p, larger(fabs(now.p), fabs(now.q)));
    s.w = larger(s.w, larger(fabs(now.wn), fabs(now.wt)));
    s.dp = larger(s.dp, larger(fabs(rate.p), fabs(rate.q)));
    s.dw = larger(s.dw, larger(fabs(rate.wn), fabs(rate.wt)));
  }
  return s;
}

void refresh(Follower& f) {
  combine(*f.t, f.load, true, f.y);
  combine(*f.t, f.direction, false, f.dy);
}

namespace {

// Change offenders, all at once while that makes new sets, then one at a time.
c2d_status settle_by_rounds(Follower& f, c2d_outcome* outcome) {
  *outcome = C2D_REACHED;
  Memory memory{};
  memory.add(fingerprint(*f.t));
  const int32_t patience = 60 + 8 * f.t->pairs;
  bool one_at_a_time = false;
  for (int32_t round = 0; round < patience; ++round) {
    const c2d_status status = f.watch.tick(f.watch.context);
    if (status != C2D_OK) return status;
    refresh(f);
    const PathScales scales = path_scales(f);
    const Round done = one_at_a_time ? change_one(f, scales, round > patience / 2) : change_all(f, scales);
    if (done.offenders == 0) return C2D_OK;
    if (done.changed == 0) {
      *outcome = stuck_outcome(done.stuck_status);
      return C2D_OK;
    }
    const uint64_t hash = fingerprint(*f.t);
    if (memory.knows(hash)) one_at_a_time = true;
    memory.add(hash);
  }
  *outcome = C2D_ENDLESS_EXCHANGE;
  return C2D_OK;
}

// Pairs whose status the rates may decide: on the border of what their status demands.
void mark_weak(Follower& f) {
  const PathScales s = path_scales(f);
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    const bool unloaded = pair.status == C2D_OPEN ? now.wn <= kValueTolerance * s.w : now.p <= kValueTolerance * s.p;
    const bool at_cone = pair.status == C2D_STICK && pair.tangential && is_finite_friction(pair) &&
                         pair.mu * now.p - fabs(now.q) <= kValueTolerance * (1.0 + pair.mu) * s.p;
    const bool slides = pair.status == C2D_SLIP && pair.tangential && pair.mu > 0.0;
    pair.weak = unloaded || at_cone || slides ? (unloaded ? 2 : 1) : 0;
  }
}

bool nothing_offends(Follower& f) {
  refresh(f);
  const PathScales scales = path_scales(f);
  for (int32_t i = 0; i < f.t->pairs; ++i)
    if (judge(f, i, scales).size > 0.0) return false;
  return true;
}

} // namespace

c2d_status settle(Follower& f, c2d_outcome* outcome) {
  keep_pairs(f);
  c2d_status status = settle_by_rounds(f, outcome);
  if (status != C2D_OK || *outcome == C2D_REACHED) return status;
  const int32_t last_pair = f.last_pair;
  status = restore_pairs(f);
  if (status != C2D_OK) return status;
  mark_weak(f);
  if (settle_by_homotopy(f) && nothing_offends(f)) {
    *outcome = C2D_REACHED;
    return C2D_OK;
  }
  f.last_pair = last_pair;
  return restore_pairs(f);
}

} // namespace c2d
