// Statuses that agree with the rates: the complementarity problem within one load (METHOD 13).

#include "contact/asleep.hpp"
#include "contact/let_go.hpp"
#include "contact/path.hpp"
#include "contact/rates/rate_cells.hpp"
#include "contact/rates/search.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(SearchPart);

namespace {

double larger(double a, double b) { return a > b ? a : b; }

struct Violation {
  double size; // 0: none
  int32_t status, sign;
};

// A pair in contact whose pressure is zero: it may stay only if its pressure grows. `held`: whatever opens.
Violation judge_unloaded(const Pair& pair, bool held, const PairState& rate, const PathScales& s) {
  const double none = no_rate(pair, s).force;
  if (rate.p < -none) return {-rate.p / s.dp, C2D_OPEN, 0};
  if (held && pair.status == C2D_SLIP && rate.p <= none && fabs(rate.wt) > no_rate(pair, s).motion)
    return {fabs(rate.wt) / s.dw, C2D_OPEN, 0};
  if (pair.status == C2D_STICK && pair.tangential && pair.law.has_bound()) {
    const double excess = pair.law.excess(larger(rate.p, 0.0), rate.q);
    if (excess > none) return {excess / s.dp, C2D_SLIP, rate.q > 0.0 ? 1 : -1};
  }
  return {0.0, 0, 0};
}

Violation judge_sticking(const Pair& pair, int32_t sign, const PairState& rate, const PathScales& s) {
  if (!pair.tangential || !pair.law.has_bound()) return {0.0, 0, 0};
  const double excess = pair.law.excess(rate.p, rate.q, sign);
  if (excess > no_rate(pair, s).force) return {excess / s.dp, C2D_SLIP, sign};
  return {0.0, 0, 0};
}

// Friction on body 2 opposes its motion relative to body 1: sign * dw_t <= 0.
Violation judge_slipping(const Pair& pair, const PairState& rate, const PathScales& s) {
  if (!pair.tangential || pair.law.is_smooth()) return {0.0, 0, 0};
  const double back = pair.sign * rate.wt;
  if (back > no_rate(pair, s).motion) return {back / s.dw, C2D_STICK, 0};
  return {0.0, 0, 0};
}

// Is friction at its bound? The pair of the event that brought the path here is there, whatever the last digits say.
bool is_at_bound(const Follower& f, int32_t i, const PairState& now, const PathScales& s) { // one that is not unloaded
  const Pair& pair = f.t->pair[i];
  if (i == f.bound.pair) return true;
  return pair.law.margin(now.p, now.q) <= kValueTolerance * pair.law.scale() * s.p;
}

// Of friction at its bound.
int32_t sign_at_bound(const Follower& f, int32_t i, const PairState& now) {
  if (i == f.bound.pair) return f.bound.sign;
  return now.q > 0.0 ? 1 : -1;
}

// A pair that closes sticks. In a large tableau, where each exchange counts, it slips at once if its friction would be beyond
// its bound, all others being as they are: the sign of its friction, or 0.
int32_t slips_at_once(const Tableau& t, const Pair& pair, const PairState& rate, const PathScales& s) {
  if (!delays(t) || !pair.tangential || !pair.law.has_bound()) return 0;
  const int32_t a = pair.dof, b = a + 1;
  const double aa = own_entry(t, a), bb = own_entry(t, b), ab = cross_entry(t, a, b), ba = cross_entry(t, b, a);
  const double det = aa * bb - ab * ba;
  const double p = (ab * rate.wt - bb * rate.wn) / det, q = (ba * rate.wn - aa * rate.wt) / det;
  return p > 0.0 && pair.law.excess(p, q) > no_rate(pair, s).force ? (q > 0.0 ? 1 : -1) : 0;
}

// Of most pairs the values alone say that their rates do not matter.
Violation judge(const Follower& f, int32_t i, const PathScales& s) {
  const Pair& pair = f.t->pair[i];
  if (is_asleep(*f.t, i)) return {0.0, 0, 0};
  const PairState now = pair_state(*f.t, i, f.y);
  const bool unloaded = is_unloaded(f, i, now, s), sticks = pair.status == C2D_STICK;
  if (!unloaded && (pair.status == C2D_OPEN || (sticks && !is_at_bound(f, i, now, s)))) return {0.0, 0, 0};
  const PairState rate = pair_rates(*f.t, i, f.dy);
  if (pair.status == C2D_OPEN) {
    if (rate.wn >= -no_rate(pair, s).motion) return {0.0, 0, 0};
    const int32_t sign = pair.law.is_smooth() ? 1 : slips_at_once(*f.t, pair, rate, s);
    return {-rate.wn / s.dw, sign != 0 ? C2D_SLIP : C2D_STICK, sign};
  }
  if (unloaded) {
    const Violation v = judge_unloaded(pair, f.t->free_motions == 0, rate, s);
    if (v.size > 0.0 || sticks) return v;
  }
  return sticks ? judge_sticking(pair, sign_at_bound(f, i, now), rate, s) : judge_slipping(pair, rate, s);
}

} // namespace

bool anything_offends(const Follower& f, const PathScales& s) {
  for (int32_t i = 0; i < f.t->pairs; ++i)
    if (judge(f, i, s).size > 0.0) return true;
  return false;
}

namespace {

// What a pair adds to the fingerprint of all statuses and signs, by which a set that was there before is noticed: the number of
// the pair and its code, mixed.
uint64_t mark_of(const Tableau& t, int32_t i) {
  const int32_t code = t.pair[i].status == C2D_SLIP ? 3 + t.pair[i].sign : t.pair[i].status;
  constexpr uint64_t kOdd = 0x9e3779b97f4a7c15u;
  const uint64_t x = static_cast<uint64_t>(8 * i + code + 1) * kOdd;
  return (x ^ (x >> 32)) * kOdd;
}

enum class Round : int32_t { quiet, changed, stuck };

// Those that offended when a round began and have not been changed, all among the pairs first ... last.
struct Offenders {
  int32_t first, last, left;
};

Offenders find_offenders(const Follower& f, const PathScales& s) {
  Offenders found{0, -1, 0};
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const bool offends = judge(f, i, s).size > 0.0;
    f.t->pair[i].mark.offends = offends;
    if (!offends) continue;
    if (found.left++ == 0) found.first = i;
    found.last = i;
  }
  return found;
}

// The worst of them, and all that are as bad but for round-off, so that the order of the pairs decides nothing: marks them.
// Their violation, 0: there are none.
double mark_worst(const Follower& f, const PathScales& s, const Offenders& those) {
  constexpr double kAsBad = 1.0 - 1e-6;
  const Tableau& t = *f.t;
  double worst = 0.0;
  for (int32_t i = those.first; i <= those.last; ++i)
    if (t.pair[i].mark.offends) worst = larger(worst, judge(f, i, s).size);
  for (int32_t i = those.first; i <= those.last && worst > 0.0; ++i) {
    PairMarks& mark = t.pair[i].mark;
    if (!mark.offends) continue;
    const Violation v = judge(f, i, s);
    mark.changes = v.size >= kAsBad * worst;
    mark.status = static_cast<uint8_t>(v.status) & 3;
    mark.slip = static_cast<uint8_t>(v.sign + 1) & 3;
  }
  return worst;
}

// Change every offender that is not mended by the changes before it. `statuses`: the fingerprint, less that of the first round.
Round change_all(Follower& f, const PathScales& s, uint64_t& statuses) {
  Tableau& t = *f.t;
  Offenders those = find_offenders(f, s);
  bool changed = false;
  while (those.left > 0 && mark_worst(f, s, those) > 0.0) {
    changed = true;
    for (int32_t i = those.first; i <= those.last; ++i) {
      PairMarks& mark = t.pair[i].mark;
      if (!mark.offends || !mark.changes) continue;
      mark.offends = 0;
      --those.left;
      const uint64_t before = mark_of(t, i);
      if (!apply_change(f, i, mark.status, mark.slip - 1, pair_state(t, i, f.y).wt)) return Round::stuck;
      statuses += mark_of(t, i) - before;
    }
  }
  return changed ? Round::changed : Round::quiet;
}

// Rounds of changes as long as they make new sets of statuses: what most events need. y and dy are those of the tableau, before
// and after. True: nothing offends any more.
bool change_in_rounds(Follower& f, const PathScales& s) {
  constexpr int32_t kRounds = 12;
  uint64_t seen[kRounds], statuses = 0;
  for (int32_t round = 0; round < kRounds; ++round) {
    seen[round] = statuses;
    for (int32_t k = 0; k < round; ++k)
      if (seen[k] == seen[round]) return false;
    const Round made = change_all(f, round == 0 ? s : decision_scales(f), statuses);
    if (made != Round::changed) return made == Round::quiet;
  }
  return false;
}

} // namespace

PathScales path_scales(const Follower& f) {
  PathScales s{0.0, f.gap_scale, 0.0, 0.0};
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const PairState now = pair_state(*f.t, i, f.y), rate = pair_rates(*f.t, i, f.dy);
    s.p = larger(s.p, larger(fabs(now.p), fabs(now.q)));
    const double gap = f.t->pair[i].gap / f.t->length_unit; // far from touching it says nothing about what moves
    s.w = larger(s.w, larger(fabs(now.wn - gap), fabs(now.wt)));
    s.dp = larger(s.dp, larger(fabs(rate.p), fabs(rate.q)));
    s.dw = larger(s.dw, larger(fabs(rate.wn), fabs(rate.wt)));
  }
  return s;
}

NoRate no_rate(const Pair& pair, const PathScales& s) {
  return {kRateTolerance * s.dp + s.mixed * pair.stiffness[0] * s.dw,
          kRateTolerance * s.dw + (pair.stiffness[0] > 0.0 ? kMixedNoise * s.dp / pair.stiffness[0] : 0.0)};
}

namespace {

PathScales judged_by(Follower& f, PathScales s) {
  s.p = f.pressure_scale = larger(s.p, f.pressure_scale);
  s.w = f.gap_scale = larger(s.w, f.gap_scale);
  if (f.idle) { // no pressure counts
    s.p *= 2.0 / kValueTolerance;
    s.mixed = kRateTolerance;
  }
  return s;
}

} // namespace

PathScales decision_scales(Follower& f) {
  const PathScales s = path_scales(f);
  keep(f.kept, s);
  return judged_by(f, s);
}

PathScales same_scales(Follower& f) {
  PathScales s;
  return recall(f.kept, s) ? judged_by(f, s) : decision_scales(f);
}

void refresh(Follower& f) {
  forget(f.kept);
  combine(*f.t, f.load, true, f.y);
  combine(*f.t, f.direction, false, f.dy);
  if (f.t->guided == 0) return;
  const Tableau& t = *f.t;
  const Pair& pair = t.pair[t.guided - 1];
  const int32_t slot = pair.dof + 1;
  add_column_to(t, column_of(t, t.guided - 1, 1), f.guide, f.dy);
  f.y[slot] = pair.offset; // read as of a slipping pair
  f.dy[slot] = static_cast<Real>(f.guide);
}

void end_guide(Follower& f) {
  if (f.t->guided == 0) return;
  Pair& pair = f.t->pair[f.t->guided - 1];
  pair.slip_done += pair.offset - pair.slip_from;
  pair.status = C2D_STICK;
  pair.sign = 0;
  f.t->guided = 0;
  refresh(f);
}

// ---- pairs in doubt -----------------------------------------------------------------------------------------------

bool is_in_doubt(const Follower& f, int32_t i, const PathScales& s, Doubt& d) {
  const Pair& pair = f.t->pair[i];
  const PairState now = pair_state(*f.t, i, f.y);
  const bool unloaded = is_unloaded(f, i, now, s);
  d = Doubt{};
  d.pair = i;
  d.dof = pair.dof;
  d.slots = 1 + pair.tangential;
  d.law = pair.law;
  if (i >= f.t->pairs || is_asleep(*f.t, i)) return false; // tied; far from touching
  d.kind = !pair.tangential || pair.law.is_smooth() ? DoubtKind::normal
           : pair.law.has_bound()                   ? DoubtKind::apex
                                                    : DoubtKind::adhesive;
  if (pair.status == C2D_OPEN || unloaded) {
    d.cell = pair.status == C2D_OPEN ? Cell::open : closed_cell(d);
    if (d.kind == DoubtKind::apex && pair.status == C2D_SLIP) d.cell = pair.sign > 0 ? Cell::slip_plus : Cell::slip_minus;
    return unloaded;
  }
  if (d.kind != DoubtKind::apex) return false;
  d.kind = DoubtKind::cone;
  d.sign = pair.status == C2D_SLIP ? pair.sign : sign_at_bound(f, i, now);
  d.cell = pair.status == C2D_STICK ? Cell::stick : (d.sign > 0 ? Cell::slip_plus : Cell::slip_minus);
  return pair.status == C2D_SLIP || is_at_bound(f, i, now, s);
}

// Exchanges on the way may have had better pivots than the statuses they led to: a pair that gives way much more than it
// would alone moves as nothing holds it.
bool is_held(const Follower& f) {
  const Tableau& t = *f.t;
  if (is_let_go(t)) return false;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    if (is_asleep(t, i)) continue;
    const int last = last_slot(t, pair); // without friction what does not hold along holds across at no pair
    for (int slot = pair.status == C2D_OPEN ? 0 : 1; slot <= last && pair.status != C2D_STICK; ++slot)
      if (fabs(static_cast<double>(own_entry(t, pair.dof + slot))) * pair.stiffness[slot] > 1.0 / kRegular) return false;
  }
  return true;
}

namespace {

// Before anything else: in a small model, and where nothing is loaded yet or the path turns. Elsewhere the state before says
// which of several solutions goes on, and rounds of changes find it.
bool wants_all(const Follower& f) { return f.t->pairs <= 6 || !f.goes_on; }

c2d_status settle_at(Follower& f, c2d_outcome* outcome) {
  *outcome = C2D_REACHED;
  c2d_status status = f.watch.tick(f.watch.context);
  if (status != C2D_OK) return status;
  bool let_go = is_let_go(*f.t);
  const bool was_let_go = let_go, was_idle = f.idle;
  PathScales s = decision_scales(f);
  if (!kSmallCode) status = rest_far(f);
  if (!kSmallCode && status == C2D_OK) status = wake_touching(f, s);
  if (status != C2D_OK) return status;
  status = kSearchPart.note_idle(f, s);
  if (let_go) status = kSearchPart.hold_again(f, &let_go, outcome); // (of which note_idle asks nothing)
  if (status != C2D_OK || let_go || *outcome != C2D_REACHED) return status;
  if (was_let_go || f.idle != was_idle) s = decision_scales(f);
  const bool first = wants_all(f);
  // Behind an event something offends as a rule, and rounds find out.
  const bool offends = (f.bound.pair >= 0 && !first) || anything_offends(f, s);
  const bool loose = offends || kSearchPart.slides_without_force(f);
  if (!loose && !first) return C2D_OK;
  keep_pairs(f);
  if (loose) status = kSearchPart.try_let_go(f, &let_go);
  if (status != C2D_OK || let_go) return status;
  int32_t found = -1;
  if (first) status = kSearchPart.try_all(f, offends, &found);
  if (status != C2D_OK || found > 0 || !offends) return status;
  if (found < 0) {
    if (change_in_rounds(f, s) && is_held(f)) return C2D_OK;
    status = restore_pairs(f);
    if (status == C2D_OK && !first) status = kSearchPart.try_all(f, true, &found);
    if (status != C2D_OK || found > 0) return status;
  }
  *outcome = C2D_UNDECIDED;
  return kSearchPart.decide(f, found == 0, outcome);
}

} // namespace

c2d_status settle(Follower& f, c2d_outcome* outcome) {
  constexpr int kRounds = 4;
  end_guide(f);
  c2d_status status = kSearchPart.rest_again(f, false);
  for (int i = 0; i < kRounds && status == C2D_OK; ++i) {
    const int64_t changes = f.stats.changes;
    status = settle_at(f, outcome);
    if (f.t->resting == 0 || f.stats.changes == changes || status != C2D_OK || *outcome != C2D_REACHED) break;
    status = kSearchPart.rest_again(f, true);
  }
  f.bound.pair = -1;
  if (status == C2D_OK && *outcome == C2D_REACHED) kSearchPart.place_in_range(f);
  return status;
}

} // namespace c2d
