// Statuses by following an artificial load (in the spirit of Lemke's method for complementarity problems). Pairs in
// doubt all stick, and an extra rate presses them so much that this is right: z times the extra column of the tableau.
// Then z goes down to zero, from one change of status to the next, each made by the pair whose rate leaves its
// conditions first. Exchanges of one pair at a time that run in circles elsewhere cannot do so here.
#include <math.h>

#include "contact/path.hpp"

namespace c2d {

namespace {

struct Line { // a + z b, to stay >= 0 as z goes down
  double a, b;
};

struct Change {
  double z;
  int32_t pair, status, sign;
};

// Unlike numbers for every pair, so that no two changes fall together.
double weight(int32_t pair) {
  const double turned = 0.6180339887498949 * (pair + 1);
  return 1.0 + 0.25 * (turned - floor(turned));
}

// All pairs in doubt stick where they are (or slide, without friction); the artificial rate holds them there.
bool press_together(Follower& f) {
  Tableau& t = *f.t;
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    if (!pair.weak || pair.status == C2D_STICK) continue;
    const double at = pair_state(t, i, f.y).wt;
    const int32_t weak = pair.weak;
    const bool slides = pair.mu == 0.0;
    // The friction of a slipping pair at the cone's edge is remembered as the sign of the artificial rate.
    pair.weak = weak == 1 ? (pair.sign > 0 ? 3 : 4) : weak;
    if (!apply_change(f, i, slides ? C2D_SLIP : C2D_STICK, slides ? 1 : 0, at)) return false;
  }
  Real* extra = artificial_rate(t);
  for (int32_t i = 0; i < t.m; ++i) extra[i] = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    if (pair.weak == 1) pair.weak = pair_state(t, i, f.y).q > 0.0 ? 3 : 4;
    if (pair.weak == 2) extra[pair.dof] = static_cast<Real>(weight(i));
    if (pair.weak >= 3) extra[pair.dof + 1] = static_cast<Real>(pair.weak == 3 ? -weight(i) : weight(i));
  }
  return true;
}

// A condition is met where z = -a/b; keep the one with the largest z below `z`.
void meet(Change& next, double z, const Line& line, int32_t pair, int32_t status, int32_t sign) {
  const double size = fabs(line.a) + fabs(z * line.b);
  if (!(line.b * z > 1e-13 * size)) return; // does not shrink as z goes down
  double at = -line.a / line.b;
  if (at > z) at = z;
  if (at > next.z) next = Change{at, pair, status, sign};
}

void meet_pair(const Follower& f, int32_t i, double z, Change& next) {
  const Tableau& t = *f.t;
  const Pair& pair = t.pair[i];
  const PairState a = pair_rates(t, i, f.dy), b = pair_rates(t, i, artificial_rate(t));
  const bool unloaded = pair.weak == 2, slides = pair.mu == 0.0;
  if (pair.status == C2D_OPEN) {
    meet(next, z, Line{a.wn, b.wn}, i, slides ? C2D_SLIP : C2D_STICK, slides ? 1 : 0);
    return;
  }
  if (unloaded) meet(next, z, Line{a.p, b.p}, i, C2D_OPEN, 0);
  if (!pair.tangential || slides || pair.mu > 1e300) return;
  if (pair.status == C2D_SLIP) {
    meet(next, z, Line{-pair.sign * a.wt, -pair.sign * b.wt}, i, C2D_STICK, 0);
    return;
  }
  for (int32_t sign = -1; sign <= 1; sign += 2) {
    if (!unloaded && sign != (pair.weak == 3 ? 1 : -1)) continue; // at one edge of the cone, far from the other
    meet(next, z, Line{pair.mu * a.p - sign * a.q, pair.mu * b.p - sign * b.q}, i, C2D_SLIP, sign);
  }
}

// The least z at which every pair in doubt may stick.
double first_z(const Follower& f) {
  double z = 0.0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    if (!f.t->pair[i].weak) continue;
    Change need{0.0, -1, 0, 0};
    meet_pair(f, i, 1e30, need);
    if (need.z > z) z = need.z;
  }
  return 2.0 * z;
}

bool make_change(Follower& f, const Change& c, double z) {
  Tableau& t = *f.t;
  const double at = pair_state(t, c.pair, f.y).wt;
  if (apply_change(f, c.pair, c.status, c.sign, at)) return true;
  if (c.status != C2D_SLIP) return false;
  const Real* extra = artificial_rate(t);
  for (int32_t i = 0; i < t.m; ++i) f.dy[i] += static_cast<Real>(z) * extra[i]; // refreshed after the change
  const bool done = release_with_partner(f, c.pair, c.sign, at, f.dy);
  refresh(f);
  return done;
}

} // namespace

bool settle_by_homotopy(Follower& f) {
  Tableau& t = *f.t;
  bool found = false;
  if (press_together(f)) {
    refresh(f);
    double z = first_z(f);
    for (int32_t change = 0; change < 100 + 20 * t.pairs; ++change) {
      Change next{0.0, -1, 0, 0};
      for (int32_t i = 0; i < t.pairs; ++i)
        if (t.pair[i].weak) meet_pair(f, i, z, next);
      found = next.pair < 0; // nothing leaves its conditions any more: z = 0
      if (found || !make_change(f, next, next.z)) break;
      z = next.z;
    }
  }
  Real* extra = artificial_rate(t);
  for (int32_t i = 0; i < t.m; ++i) extra[i] = 0;
  return found;
}

} // namespace c2d
