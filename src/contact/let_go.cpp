#include "contact/let_go.hpp"

#include "contact/rates/limit_analysis.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {

bool is_let_go(const Tableau& t) {
  if (t.free_motions == 0) return false;
  for (int32_t i = 0; i < t.pairs; ++i)
    if (t.pair[i].status != C2D_OPEN) return false;
  return true;
}

namespace {

Real* column(const Tableau& t, int32_t j) { return t.t + static_cast<int64_t>(t.m) * j; }

// Sums over the pairs' gaps and tangential motions, each with the length of its elements: the same for equivalent models.
template <class Term> double sum_over_pairs(const Tableau& t, Term term) {
  double sum = 0.0;
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int slot = 0; slot <= t.pair[i].tangential; ++slot) sum += t.pair[i].length * term(t.pair[i], slot);
  return sum;
}

// The least motion of all pairs that a column allows under the free motions, METHOD (13.3): normal equations.
struct LeastMotion {
  const Real* motion[kFreeMotions];
  double factor[kFreeMotions][kFreeMotions];
  int32_t count;

  bool prepare(const Tableau& t) {
    for (int32_t j = 0; j < count; ++j)
      for (int32_t k = 0; k <= j; ++k) {
        double sum = sum_over_pairs(
            t, [&](const Pair& p, int slot) { return static_cast<double>(motion[j][p.dof + slot]) * motion[k][p.dof + slot]; });
        const double own = sum;
        for (int32_t i = 0; i < k; ++i) sum -= factor[j][i] * factor[k][i];
        if (j == k && C2D_NEVER(!(sum > 1e-12 * own))) return false; // each moves a slot that no other does
        factor[j][k] = j == k ? sqrt(sum) : sum / factor[k][k];
      }
    return true;
  }
  void solve(double x[kFreeMotions]) const {
    for (int32_t j = 0; j < count; ++j) {
      for (int32_t i = 0; i < j; ++i) x[j] -= factor[j][i] * x[i];
      x[j] /= factor[j][j];
    }
    for (int32_t j = count - 1; j >= 0; --j) {
      for (int32_t i = j + 1; i < count; ++i) x[j] -= factor[i][j] * x[i];
      x[j] /= factor[j][j];
    }
  }
  // What of the free motions brings `values` nearest to the place to keep, or to zero.
  void add_to(const Tableau& t, Real* values, bool to_place) const {
    double x[kFreeMotions];
    for (int32_t j = 0; j < count; ++j)
      x[j] = -sum_over_pairs(t, [&](const Pair& p, int slot) {
        const double from = to_place ? place_of(p, slot) : 0.0;
        return motion[j][p.dof + slot] * (values[p.dof + slot] - from);
      });
    solve(x);
    for (int32_t j = 0; j < count; ++j)
      for (int32_t i = 0; i < t.m; ++i) values[i] += static_cast<Real>(x[j] * motion[j][i]);
  }
};

} // namespace

bool place_body(const Tableau& t, const int32_t* left, int32_t count) {
  LeastMotion least{};
  least.count = count;
  for (int32_t k = 0; k < count; ++k) {
    Real* const motion = slot_column(t, left[k]);
    for (int32_t j = 0; j < count; ++j) motion[left[j]] = static_cast<Real>(j == k ? 1 : 0);
    least.motion[k] = motion;
  }
  const bool apart = least.prepare(t);
  if (C2D_NEVER(!apart)) return false; // (there)
  for (int32_t j = t.n; j < tableau_columns(t); ++j) least.add_to(t, column(t, j), j == t.n);
  return true;
}

// ---- resting along a motion --------------------------------------------------------------------------------------------

namespace {

// visit(pair, slot, factor): the slots whose motions are basic, with the lengths of their elements times what they move along a
// free motion, which stands in a column. One pair alone, if that is given.
template <class Visit> void for_moved(const Tableau& t, const Pair* alone, const Real* motion, Visit visit) {
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int slot = 0; slot <= t.pair[i].tangential; ++slot) {
      const Pair& pair = t.pair[i];
      const bool moves = slot == 0 ? pair.status == C2D_OPEN : pair.status != C2D_STICK;
      if (!moves || (pair.mark.exchanged >> slot & 1) == 0 || (alone && (alone != &pair || slot == 1))) continue;
      visit(pair, slot, pair.length * static_cast<double>(motion[pair.dof + slot]));
    }
}

// The pair that leans on the other body and moves most along its normal. Null: they move less than round-off of what the motion
// moves anywhere, along the surface or across it.
const Pair* leaning_most(const Tableau& t, const Real* motion) {
  const Pair* found = nullptr;
  double most = 0.0, all = 0.0;
  for_moved(t, nullptr, motion, [&](const Pair& pair, int slot, double) {
    const double size = fabs(static_cast<double>(motion[pair.dof + slot]));
    all = fmax(all, size);
    if (slot == 0 && leans(pair) && size > most) most = size, found = &pair;
  });
  return most > kRateTolerance * all ? found : nullptr;
}

Pair& pair_of_slot(const Tableau& t, int32_t dof) {
  int32_t i = 0;
  while (dof > t.pair[i].dof + t.pair[i].tangential) ++i;
  return t.pair[i];
}

} // namespace

bool may_rest(const Tableau& t, const int32_t* left, int32_t count) {
  for (int32_t k = 0; k < t.cases; ++k) {
    if (t.load[k] == 0.0 && t.direction[k] == 0.0) continue;
    const Real* const rates = column(t, t.n + 1 + k);
    double most = 0.0; // of forces, or what motions would make of them
    for (int32_t i = 0; i < t.pairs; ++i)
      for (int slot = 0; slot <= t.pair[i].tangential; ++slot) {
        const bool moved = (t.pair[i].mark.exchanged >> slot & 1) != 0;
        const double size = fabs(static_cast<double>(rates[t.pair[i].dof + slot]));
        most = fmax(most, moved ? size * t.pair[i].stiffness[slot] : size);
      }
    for (int32_t j = 0; j < count; ++j)
      if (fabs(static_cast<double>(rates[left[j]])) > kRateTolerance * most) return false;
  }
  return true;
}

bool rest_along(const Tableau& t, int32_t slot, Real* response) {
  Real* const motion = slot_column(t, slot);
  Pair& own = pair_of_slot(t, slot);
  const int which = slot - own.dof;
  const Pair* const alone = which == 0 && leans(own) ? &own : leaning_most(t, motion);
  const double weight = alone && alone != &own ? 0.0 : own.length;
  double against = 0.0, size = weight;
  for (int32_t i = 0; i < t.m; ++i) response[i] = 0;
  const auto push = [&](int32_t at, double factor) {
    if (at == slot) against += factor;
    const Pair& there = pair_of_slot(t, at);
    if (at == slot || (there.mark.exchanged >> (at - there.dof) & 1) == 0) return;
    if (has_normal_columns(t) && at != there.dof) return; // that is no force which a pair could have
    const Real* const pushed = slot_column(t, at);
    for (int32_t i = 0; i < t.m; ++i) response[i] += static_cast<Real>(factor) * pushed[i];
  };
  push(own.place[which], weight);
  for_moved(t, alone, motion, [&](const Pair& pair, int s, double factor) {
    size += factor * motion[pair.dof + s];
    push(pair.place[s], factor);
  });
  against -= response[slot];
  if (C2D_NEVER(!(fabs(against) > 0.0))) return false; // it would be no motion that nothing holds
  const auto keep_place_in = [&](Real* values, double base, bool to_place) {
    double x = -weight * (base - (to_place ? place_of(own, which) : 0.0));
    for_moved(t, alone, motion, [&](const Pair& pair, int s, double factor) {
      x -= factor * (values[pair.dof + s] - (to_place ? place_of(pair, s) : 0.0));
    });
    x /= size;
    for (int32_t i = 0; i < t.m; ++i)
      if (i != slot) values[i] += static_cast<Real>(x) * motion[i];
    values[slot] = static_cast<Real>(base + x);
  };
  for (int32_t j = 0; j < tableau_columns(t); ++j) {
    Real* const values = column(t, j);
    if (values == motion || (j >= used_columns(t) && j < t.n)) continue;
    const bool at_rest = j >= t.n; // no force there, but the gap
    const Real force = at_rest ? Real(0) : static_cast<Real>(values[slot] / against);
    for (int32_t i = 0; i < t.m && force != 0; ++i) values[i] += force * response[i];
    keep_place_in(values, at_rest ? static_cast<double>(values[slot]) : 0.0, j == t.n);
  }
  for (int32_t i = 0; i < t.m; ++i) response[i] = static_cast<Real>(-response[i] / against);
  keep_place_in(response, 0.0, false);
  for (int32_t i = 0; i < t.m; ++i) motion[i] = response[i];
  own.mark.exchanged = static_cast<uint8_t>(own.mark.exchanged | 1 << which) & 3;
  return true;
}

// ---- letting go and holding again ---------------------------------------------------------------------------------

namespace {

double larger(double a, double b) { return a > b ? a : b; }

double largest_motion(const Follower& f) {
  double most = 0.0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const PairState now = pair_state(*f.t, i, f.y);
    most = larger(most, larger(fabs(now.wn - gap_of(*f.t, f.t->pair[i])), fabs(now.wt)));
  }
  return most;
}

// Is there no force in any pair but the round-off of such a motion?
bool is_without_force(const Follower& f, double motion) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    if (pair.status == C2D_OPEN) continue;
    const PairState now = pair_state(*f.t, i, f.y);
    if (larger(fabs(now.p), fabs(now.q)) > kValueTolerance * f.pressure_scale + kRateTolerance * pair.stiffness[0] * motion)
      return false;
  }
  return true;
}

// Is this pair open without a gap?
bool touches(const Follower& f, int32_t i, const PathScales& s) {
  Doubt d;
  return f.t->pair[i].status == C2D_OPEN && is_in_doubt(f, i, s, d);
}

bool closes(Follower& f) {
  const PathScales s = decision_scales(f);
  for (int32_t i = 0; i < f.t->pairs; ++i)
    if (touches(f, i, s) && pair_rates(*f.t, i, f.dy).wn < -no_rate(f.t->pair[i], s).motion) return true;
  return false;
}

} // namespace

c2d_status note_idle(Follower& f, const PathScales& s) {
  bool balanced = false, rates = false;
  c2d_status status = C2D_OK;
  // No motion is larger than twice the scale of gaps; most often the first closed pair has more force than that makes.
  const bool none = f.t->free_motions > 0 && is_without_force(f, 2.0 * s.w) && is_without_force(f, largest_motion(f));
  if (none && !is_let_go(*f.t)) status = loads_balance(f, &balanced, &rates);
  f.idle = balanced;
  return status;
}

bool slides_without_force(Follower& f) {
  if (!f.idle) return false;
  const PathScales s = decision_scales(f);
  bool slides = false;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    if (pair.status == C2D_OPEN) continue;
    if (fabs(pair_rates(*f.t, i, f.dy).p) > kRateTolerance * pair.stiffness[0] * s.dw) return false;
    slides = slides || pair.status == C2D_SLIP;
  }
  return slides;
}

void keep_open_places(Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    if (f.t->pair[i].status != C2D_OPEN) continue;
    const PairState now = pair_state(*f.t, i, f.y);
    keep_place(f.t->pair[i], now.wn, now.wt);
  }
}

void leave_place(Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const PairState now = pair_state(*f.t, i, f.y);
    set_status(f, i, C2D_OPEN, 0);
    keep_place(f.t->pair[i], now.wn, now.wt);
  }
}

c2d_status try_let_go(Follower& f, bool* done) {
  *done = false;
  if (!f.idle) return C2D_OK;
  bool balanced = false, rates = false;
  c2d_status status = loads_balance(f, &balanced, &rates);
  if (status != C2D_OK || !rates) return status;
  const int64_t changes = f.stats.changes;
  const int32_t last_pair = f.last_pair;
  leave_place(f);
  status = rebuild(f);
  if (status != C2D_OK && status != C2D_ERR_SINGULAR) return status;
  *done = status == C2D_OK && !closes(f);
  if (*done) return C2D_OK;
  f.stats.changes = changes;
  f.last_pair = last_pair;
  return restore_pairs(f);
}

namespace {

// All pairs that touch, closed; false: there are none.
bool close_touching(Follower& f) {
  const PathScales s = decision_scales(f);
  bool any = false;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    if (!touches(f, i, s)) continue;
    const bool slides = f.t->pair[i].law.is_smooth();
    set_status(f, i, slides ? C2D_SLIP : C2D_STICK, slides ? 1 : 0);
    any = true;
  }
  return any;
}

} // namespace

namespace {

// The open pair that touches, if it is the only one; else -1.
int32_t only_touching(Follower& f) {
  const PathScales s = decision_scales(f);
  int32_t found = -1;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    if (!touches(f, i, s)) continue;
    if (found >= 0) return -1;
    found = i;
  }
  return found;
}

} // namespace

c2d_status rest_again(Follower& f, bool changed) {
  if (f.t->resting == 0 || !(changed || closes(f))) return C2D_OK;
  keep_open_places(f);
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    if (pair.status != C2D_SLIP) continue;
    const PairState now = pair_state(*f.t, i, f.y);
    pair.slip_done += static_cast<Real>(now.wt - pair.slip_from);
    pair.slip_from = static_cast<Real>(now.wt);
  }
  keep_pairs(f);
  const int32_t resting = f.t->resting, only = only_touching(f);
  if (closes(f)) close_touching(f);
  c2d_status status = rebuild(f);
  if (status == C2D_ERR_SINGULAR) status = restore_pairs(f);
  if (status != C2D_OK || only < 0 || f.t->resting == resting) return status;
  // This pair alone cannot press: nothing would push back along the motion that it ends.
  status = restore_pairs(f);
  lean(f.t->pair[only]);
  return status == C2D_OK ? rebuild(f) : status;
}

c2d_status hold_again(Follower& f, bool* quiet, c2d_outcome* outcome) {
  bool balanced = false;
  c2d_status status = loads_balance(f, &balanced, quiet);
  if (status != C2D_OK) return status;
  *quiet = *quiet && !closes(f);
  if (*quiet) return C2D_OK;
  keep_pairs(f);
  *outcome = C2D_FREE_MOTION;
  if (!close_touching(f)) return C2D_OK;
  keep_open_places(f); // (a tableau that is singular leaves nothing of them)
  status = rebuild(f);
  if (status == C2D_ERR_SINGULAR) { // the pairs that touch leave motions free: no fault where no load drives them
    f.t->may_rest = 1;
    status = rebuild(f);
  }
  if (status == C2D_ERR_SINGULAR) {
    f.t->may_rest = 0;
    return restore_pairs(f);
  }
  if (status != C2D_OK) return status;
  *outcome = C2D_REACHED;
  f.idle = true; // what touches has no force yet
  return status;
}

} // namespace c2d
