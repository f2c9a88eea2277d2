#include "contact/rates/search.hpp"

#include "contact/rates/limit_analysis.hpp"
#include "contact/rates/rate_cells.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

// All pairs in doubt, as they stand.
void gather_doubts(Follower& f, RateProblem& r) {
  apply_list(*f.t); // many entries of the tableau are looked at
  const PathScales s = decision_scales(f);
  r = rate_problem_in(f.rate_area, f.t->n);
  r.t = f.t;
  r.direction = f.direction;
  r.rates = f.dy;
  r.holds_body = f.t->free_motions > 0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Doubt& d = r.doubt[r.count];
    if (!is_in_doubt(f, i, s, d)) {
      r.holds_body = r.holds_body && f.t->pair[i].status == C2D_OPEN;
      continue;
    }
    d.row = r.size;
    r.size += d.slots;
    ++r.count;
  }
}

void keep_motion_before(const Follower& f, RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    const PairState rate = pair_rates(*f.t, d.pair, f.dy);
    r.before[d.row] = static_cast<Real>(f.goes_on ? rate.wn : 0.0);
    if (d.slots == 2) r.before[d.row + 1] = static_cast<Real>(f.goes_on ? rate.wt : 0.0);
  }
}

// Friction too small, or pairs too far from each other, to make rates that are not unique. Sufficient, not necessary: of
// slipping pairs alone, when their compliance, per force instead of per pressure, is positive definite. (Not inlined: its
// matrix would stand below what try_all calls.)
[[gnu::noinline]] bool is_surely_unique(const RateProblem& r) {
  constexpr int32_t kMost = 8;
  if (r.count == 0) return true;
  if (r.count > kMost) return false;
  const Tableau& t = *r.t;
  double a[kMost][kMost];
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    if (d.kind != DoubtKind::cone || t.pair[d.pair].status != C2D_SLIP) return false;
    for (int32_t j = 0; j <= i; ++j) {
      const Doubt& e = r.doubt[j];
      const double there = t.t[static_cast<int64_t>(column_of(t, e.pair, 1)) * t.m + d.dof + 1] / t.pair[e.pair].length;
      const double back = t.t[static_cast<int64_t>(column_of(t, d.pair, 1)) * t.m + e.dof + 1] / t.pair[d.pair].length;
      a[i][j] = 0.5 * d.sign * e.sign * (there + back);
    }
  }
  for (int32_t j = 0; j < r.count; ++j) { // Cholesky's factors exist
    const double own = a[j][j];
    for (int32_t k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
    if (!(a[j][j] > 1e-6 * own)) return false;
    a[j][j] = sqrt(a[j][j]);
    for (int32_t i = j + 1; i < r.count; ++i) {
      for (int32_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= a[j][j];
    }
  }
  return true;
}

// Give the pairs the statuses of their cells; by building the tableau anew where exchanges have no pivot on the way.
c2d_status take_cells(Follower& f, const RateProblem& r) {
  bool exchanged = true;
  for (int32_t i = 0; i < r.count && exchanged; ++i) {
    const Doubt& d = r.doubt[i];
    const double at = pair_state(*f.t, d.pair, f.y).wt;
    exchanged = apply_change(f, d.pair, cell_status(d, d.cell), cell_sign(d, d.cell), at);
  }
  if (exchanged) return C2D_OK;
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    set_status(f, d.pair, cell_status(d, d.cell), cell_sign(d, d.cell));
  }
  return rebuild(f);
}

// So many sets of cells are tried one by one, of so many pairs all are divided into so many parts at most; and into so many
// parts where nothing else has found rates.
constexpr int64_t kFewSets = 256;
constexpr int32_t kFewPairs = 16, kFewParts = 1000, kMostParts = 20000;

void note_solutions(Follower& f, int32_t found, bool partial) {
  if (found <= f.solutions) return;
  f.solutions = found;
  f.more_solutions = partial;
  f.range = false;
  f.solutions_load = f.load[0];
}

// The statuses and books are those kept, the tableau is fresh, and they and it are so again where no rates are found.
c2d_status take_found(Follower& f, const RateProblem& r, bool check, Settled* result) {
  const c2d_status status = take_cells(f, r);
  if (status != C2D_OK && status != C2D_ERR_SINGULAR) return status;
  refresh(f);
  if (status == C2D_OK && is_held(f) && (!check || !anything_offends(f, decision_scales(f)))) return C2D_OK;
  *result = Settled::undecided;
  return restore_pairs(f);
}

// Rates where rounds of changes find none.
c2d_status search_rates(Follower& f, bool on_tableau, bool drawn, Settled* result) {
  RateProblem r;
  gather_doubts(f, r);
  r.on_tableau = on_tableau;
  for (int32_t i = 0; i < f.t->pairs && on_tableau; ++i) f.t->pair[i].offset = 0.0; // of no account for rates
  c2d_status found = C2D_OK;
  *result = follow_cells(r, drawn, f.watch.tick, f.watch.context, &found);
  const c2d_status status = on_tableau ? restore_pairs(f) : c2d_status{C2D_OK};
  if (status != C2D_OK || found != C2D_OK) return status != C2D_OK ? status : found;
  return *result == Settled::solved ? take_found(f, r, on_tableau, result) : status;
}

// Of few pairs by systems, of many on the tableau first, which is faster but knows no cells that leave a motion free.
c2d_status search(Follower& f, bool drawn, Settled* result) {
  constexpr int32_t kFew = 40, kMost = 250;
  RateProblem r;
  gather_doubts(f, r);
  const int32_t doubts = r.count;
  c2d_status status = C2D_OK;
  *result = Settled::undecided;
  if (doubts > kFew) status = search_rates(f, true, drawn, result);
  if (status == C2D_OK && *result == Settled::undecided && doubts <= kMost) status = search_rates(f, false, drawn, result);
  return status;
}

c2d_status search_branches(Follower& f, Settled* result) {
  RateProblem r;
  gather_doubts(f, r);
  c2d_status status = C2D_OK;
  int32_t found = 0;
  keep_motion_before(f, r);
  *result = branch_cells(r, false, kMostParts, &found, f.watch.tick, f.watch.context, &status);
  return status == C2D_OK && *result == Settled::solved ? take_found(f, r, false, result) : status;
}

} // namespace

c2d_status try_all(Follower& f, bool offends, int32_t* found) {
  RateProblem r;
  gather_doubts(f, r);
  *found = -1;
  if (r.count > kFewPairs) return C2D_OK;
  if (!offends && is_surely_unique(r)) return C2D_OK;
  keep_motion_before(f, r);
  c2d_status status = C2D_OK;
  if (count_cells(r) <= kFewSets)
    try_all_cells(r, found);
  else if (branch_cells(r, true, kFewParts, found, f.watch.tick, f.watch.context, &status) == Settled::undecided)
    *found = -1;
  if (status != C2D_OK) return status;
  note_solutions(f, *found, r.partial);
  if (*found < 1 || (*found == 1 && !offends)) return C2D_OK;
  status = take_cells(f, r);
  if (status == C2D_OK && is_held(f)) return status;
  if (status != C2D_OK && status != C2D_ERR_SINGULAR) return status;
  *found = status == C2D_OK ? 0 : -1; // a motion that the last digits hold is none of a solution
  return restore_pairs(f);
}

c2d_status decide(Follower& f, bool all_tried, c2d_outcome* outcome) {
  *outcome = C2D_REACHED;
  Settled result = Settled::undecided;
  c2d_status status = all_tried ? c2d_status{C2D_OK} : search(f, false, &result);
  if (status != C2D_OK || result == Settled::solved) return status;
  status = limit_analysis(f, all_tried, outcome);
  if (status != C2D_OK || *outcome != C2D_UNDECIDED) return status;
  status = search_branches(f, &result);
  if (status == C2D_OK && result == Settled::undecided) status = search(f, true, &result);
  if (status != C2D_OK || result == Settled::undecided) return status;
  *outcome = C2D_REACHED;
  return result == Settled::solved ? status : limit_analysis(f, true, outcome);
}

namespace {

// Would nothing hold this sticking pair if it slipped, with this sign of its friction?
bool holds_alone(const Tableau& t, const Pair& pair, int32_t sign) {
  const double along = own_entry(t, pair.dof + 1), across = cross_entry(t, pair.dof, pair.dof + 1);
  return fabs(along - pair.law.slope(sign) * across) <= kRegular * pair.stiffness[1];
}

// Does this pair alone hold a motion, with friction that is at its bound and stays there? Then it may slide as well, along a
// motion that no force opposes, until another pair sticks instead: this state is one end of a range. The sign of its friction;
// 0: no.
int32_t ends_a_range(Follower& f, int32_t i) {
  const Tableau& t = *f.t;
  const Pair& pair = t.pair[i];
  if (pair.status != C2D_STICK || !pair.tangential || !pair.law.has_bound()) return 0;
  if (!holds_alone(t, pair, 1) && !holds_alone(t, pair, -1)) return 0; // so it is nearly always
  const PathScales s = decision_scales(f);
  Doubt d;
  if (!is_in_doubt(f, i, s, d)) return 0;
  const PairState rate = pair_rates(t, i, f.dy);
  const double none = no_rate(pair, s).force;
  const int32_t sign = d.kind == DoubtKind::cone ? d.sign : rate.q > 0.0 ? 1 : -1;
  const bool pressed = d.kind == DoubtKind::cone || rate.p > none;
  const bool stays = pressed && fabs(pair.law.excess(rate.p, rate.q, sign)) <= none;
  return stays && holds_alone(t, pair, sign) ? sign : 0;
}

// The places of a body in a range: all rates plus x times `motion`, that of the pair at its end; none, if that has a force.
struct Range {
  const Follower& f;
  int32_t pair;
  const Real* motion;

  PairState moved(int32_t i) const {
    PairState v = pair_rates(*f.t, i, motion);
    if (i == pair) v.wt = 1.0, v.p = v.q = 0.0;
    return v;
  }
  bool has_force() const {
    for (int32_t i = 0; i < f.t->pairs; ++i) {
      const PairState v = moved(i);
      if (fmax(fabs(v.p), fabs(v.q)) > kRegular * f.t->pair[i].stiffness[0]) return true;
    }
    return false;
  }
  // Where the pairs move least, as of a body that is let go.
  double least() const {
    double rates = 0.0, size = 0.0;
    for (int32_t i = 0; i < f.t->pairs; ++i) {
      const PairState v = moved(i), rate = pair_rates(*f.t, i, f.dy);
      rates += f.t->pair[i].length * (v.wn * rate.wn + v.wt * rate.wt);
      size += f.t->pair[i].length * (v.wn * v.wn + v.wt * v.wt);
    }
    return -rates / size;
  }
  // As far as `x`, or to where a slipping pair would turn back (*other), or one without a gap close.
  double reach(double x, const PathScales& s, int32_t* other) const {
    for (int32_t i = 0; i < f.t->pairs; ++i) {
      const Pair& p = f.t->pair[i];
      const PairState v = moved(i), rate = pair_rates(*f.t, i, f.dy);
      Doubt d;
      const bool slips = p.status == C2D_SLIP && p.tangential && !p.law.is_smooth();
      if (!slips && (p.status != C2D_OPEN || !is_in_doubt(f, i, s, d))) continue;
      const double room = slips ? -p.sign * rate.wt : rate.wn, closing = slips ? p.sign * v.wt : -v.wn;
      if (x * closing <= room || x * closing <= 0.0) continue;
      x = fmax(room, 0.0) / closing;
      *other = slips ? i : -1;
    }
    return x;
  }
};

void guide(Follower& f, int32_t i, int32_t sign, double rate) {
  Pair& pair = f.t->pair[i];
  pair.status = C2D_SLIP;
  pair.sign = static_cast<int8_t>(sign);
  pair.slip_from = pair.offset;
  f.t->guided = i + 1;
  f.guide = rate;
  refresh(f);
}

} // namespace

void place_in_range(Follower& f) {
  if (f.t->free_motions == 0) return; // supports hold the bodies
  int32_t end = 0, sign = 0;
  while (end < f.t->pairs && (sign = ends_a_range(f, end)) == 0) ++end;
  if (sign == 0) return;
  note_solutions(f, 2, true);
  f.range = f.range || f.solutions_load == f.load[0];
  apply_list(*f.t);
  const Range range{f, end, f.t->t + static_cast<int64_t>(column_of(*f.t, end, 1)) * f.t->m};
  if (range.has_force()) return;
  const PathScales s = decision_scales(f);
  const double none = no_rate(f.t->pair[end], s).motion, least = range.least();
  if (sign * least >= -none) return;
  int32_t other = -1;
  const double x = range.reach(least, s, &other);
  if (sign * x >= -none) return;
  if (other < 0) return guide(f, end, sign, x);
  const int32_t back = f.t->pair[other].sign;
  if (!apply_change(f, other, C2D_STICK, 0, pair_state(*f.t, other, f.y).wt)) return;
  if (!apply_change(f, end, C2D_SLIP, sign, 0.0)) apply_change(f, other, C2D_SLIP, back, 0.0);
}

} // namespace c2d
