#include "contact/slip_path.hpp"

#include "memory/math.hpp"
#include "model/slip_gap.hpp"

namespace c2d {

namespace {

constexpr double kNone = 1e-13; // of the length unit: round-off of coordinates

} // namespace

void aim_gaps(Follower& f, double rest) {
  const Tableau& t = *f.t;
  for (int32_t i = 0; i < t.pairs; ++i) {
    SlipGap& gap = t.slip[i];
    if (gap.follows == 0) continue;
    const double slip = pair_state(t, i, f.y).wt + rest * pair_rates(t, i, f.dy).wt;
    const double to = slip_gap(*f.model, i, slip * t.length_unit) / t.length_unit;
    gap.rate = fabs(to) <= kNone && gap.now == 0.0 ? 0.0 : (to - gap.now) / rest;
  }
  find_slip_rates(t);
  refresh(f);
}

} // namespace c2d
