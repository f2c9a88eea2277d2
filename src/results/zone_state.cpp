// Current state of a contact zone: resultants, numbers of pairs by status, largest tractions.
//
// Force and moment on side 1 (sides count from 0): F = int tau ds, M = int x cross tau ds about the origin, with the exact
// integrals of the shape functions along the side to whose length tau refers (side 0; in free zones side 1). The forces of all
// zones of a body, with the sign of its side, therefore add up to its contact resultant (results/body_state.cpp).
#include "results/zone_state.hpp"
#include "bie/columns.hpp"
#include "memory/math.hpp"
#include "model/pair_frame.hpp"

namespace c2d {

namespace {

constexpr double kNear = 0.01; // relative distance from another status that counts as near

struct Largest {
  double p, gap;
};

double larger(double a, double b) { return a > b ? a : b; }

// Adds force and moment on side 1 from one element of the side to whose length tau refers.
void add_element_force(const Session& session, int b, int32_t element, c2d_zone_state& out) {
  const Model& m = session.model;
  const Follower& f = session.follower;
  EndResultant weight[kElementNodes];
  end_resultants(m, b, element, Measure::own_length, weight);
  const double unit = m.head->length_unit * m.head->stress_unit;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t i = pair_of_end(m, b, element, l).pair;
    if (i < 0) continue;
    const Pair& pair = m.pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    double t[2];
    to_global(pair, now.p, now.q, t);
    for (int c = 0; c < 2; ++c) out.force[c] += unit * weight[l].w * t[c];
    out.moment += unit * m.head->length_unit * (weight[l].wx * t[1] - weight[l].wy * t[0]);
  }
}

// Is the pair close to another status? Open: nearly closed; closed: nearly without pressure, or sticking near the friction
// limit. Infinite friction has no limit.
bool is_near(const Pair& pair, const PairState& now, const Largest& largest) {
  if (pair.status == C2D_OPEN) return now.wn <= kNear * largest.gap;
  if (now.p <= kNear * largest.p) return true;
  if (pair.status != C2D_STICK || !pair.tangential || !pair.law.has_bound()) return false;
  return fabs(now.q) >= (1.0 - kNear) * pair.law.bound(now.p);
}

} // namespace

void fill_zone_state(const Session& session, const Zone& zone, c2d_zone_state& out) {
  const Model& m = session.model;
  const Follower& f = session.follower;
  Largest largest{0.0, 0.0};
  double friction = 0.0;
  for (int32_t i = zone.first_pair; i < zone.first_pair + zone.pairs; ++i) {
    const Pair& pair = m.pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    largest.p = larger(largest.p, now.p);
    largest.gap = larger(largest.gap, now.wn);
    friction = larger(friction, fabs(now.q));
    if (pair.status != C2D_OPEN) out.length += pair.weight * m.head->length_unit;
    if (pair.status == C2D_OPEN)
      ++out.open;
    else if (pair.tangential ? pair.status == C2D_STICK
                             : !pair.law.is_smooth()) // on an axis of symmetry: stick if there is friction
      ++out.stick;
    else
      ++out.slip;
  }
  for (int32_t i = zone.first_pair; i < zone.first_pair + zone.pairs && zone.is_tied == 0; ++i)
    out.near_change += is_near(m.pair[i], pair_state(*f.t, i, f.y), largest);
  out.largest_pressure = largest.p * m.head->stress_unit;
  out.largest_friction = friction * m.head->stress_unit;
  const int side = zone.is_free != 0 ? 1 : 0;
  for (int32_t place = 0; place < zone.elements; ++place)
    add_element_force(session, zone.body[side], zone_element(m, zone, side, place), out);
  if (is_axisymmetric(m)) out.moment = 0.0; // those of opposite half sections cancel
}

} // namespace c2d
