// Overlap of the bodies between the nodes of side 1 of a free zone (sides count from 0 here, from 1 in messages).
//
// Contact conditions are enforced at the functional nodes of side 1 only (node-to-surface collocation). A boundary point of
// side 0 between two such nodes can penetrate side 1 unnoticed, as in any one-pass node-to-segment method (Wriggers,
// Computational Contact Mechanics, chapter on discretisation). Phases:
//   1. For each pair: its position along side 0 and the change of its gap since the undeformed state.
//   2. For each boundary point of side 0 between two successive pairs: its initial distance from the chord of side 1, plus the
//      linearly interpolated change of gap; negative means penetration.
//   3. Correct for the curvature of side 1 (bulge over the chord), subtract the uncertainty of the surface, keep the deepest.
// Only penetration above 5 % of the largest closure of gaps is reported: less does not affect the pressure.
#include "results/interior/between_nodes.hpp"

#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/surface.hpp"
#include "model/unknowns.hpp"

namespace c2d {

namespace {

constexpr double kMatters = 0.05;   // of the largest closure of a gap: less is not reported
constexpr double kTolerance = 1e-5; // of the distance of two nodes: less is round-off of their positions
constexpr double kAtANode = 1e-6;   // of an element: a point this close faces a node, where the gap is enforced

struct Overlap {
  double size = 0.0, closed = 0.0, x = 0.0, y = 0.0;
  int32_t zone = -1, pair = -1;
};

// A pair: its position along side 0 in elements, its node on side 1, and the change of its gap since the undeformed state.
struct Place {
  double along, x, y, change;
};

Place place_of(const Session& session, const Zone& z, int32_t i) {
  const Model& m = session.model;
  const Pair& pair = m.pair[i];
  ZonePlace on{0, 0, 0};
  find_contact_element(m, z.body[0], pair.element, &on);
  Place out{on.place + 0.5 * (1 + z.element_step[0] * pair.eta), 0.0, 0.0, 0.0};
  node_position(m, z.body[1], pair.node[1], &out.x, &out.y);
  const double gap = pair_state(*session.follower.t, i, session.follower.y).wn * m.head->length_unit;
  out.change = gap - (pair.gap - pair.overlap);
  return out;
}

// Two pairs that follow each other, in the order of side 0.
struct Gap {
  int32_t first, second;
  Place a, b;
  double part(double along) const { return (along - a.along) / (b.along - a.along); }
};

// Height of the surface of side 1 above the chord between the two nodes at the fraction `part`. Both nodes lie on one element;
// if they do not, side 1 has a corner between them and the chord is used. *doubt: uncertainty of the surface (METHOD 8.6).
double bulge(const Model& m, const Zone& z, const Gap& gap, double part, const double n[2], double* doubt) {
  const int b = z.body[1], f = m.head->function_nodes;
  int32_t from[2], to[2];
  const int count = ends_at_node(m, b, m.pair[gap.first].node[1], from),
            others = ends_at_node(m, b, m.pair[gap.second].node[1], to);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < others; ++k) {
      if (from[i] / f != to[k] / f) continue;
      const SurfaceElement surface = surface_element(m, b, from[i] / f);
      const double eta_a = node_eta(f, from[i] % f), eta_b = node_eta(f, to[k] % f);
      const SurfacePoint p = surface_point(surface, eta_a), q = surface_point(surface, eta_b),
                         s = surface_point(surface, eta_a + part * (eta_b - eta_a));
      *doubt = surface.doubt;
      return (s.x - p.x - part * (q.x - p.x)) * n[0] + (s.y - p.y - part * (q.y - p.y)) * n[1];
    }
  return 0.0;
}

// Depth of a boundary point of side 0 inside the other body; negative: outside. The point is projected onto the chord along the
// interpolated normal. The bulge is evaluated only if the chord alone shows penetration: it costs a surface construction.
double depth_at(const Session& session, const Zone& z, const Gap& gap, double along, const double p[2], double least) {
  const Model& m = session.model;
  const Pair &one = m.pair[gap.first], &two = m.pair[gap.second];
  const double part = gap.part(along), dx = gap.b.x - gap.a.x, dy = gap.b.y - gap.a.y;
  const double n[2] = {one.nx + part * (two.nx - one.nx), one.ny + part * (two.ny - one.ny)}, size = hypot(n[0], n[1]);
  const double across = dx * n[1] - dy * n[0], cx = p[0] - gap.a.x, cy = p[1] - gap.a.y;
  if (size == 0.0 || across == 0.0) return 0.0;
  const double at = (cx * n[1] - cy * n[0]) / across; // fraction along the chord where the normal through the point meets it
  const double open = ((at * dx - cx) * n[0] + (at * dy - cy) * n[1]) / size;
  const double change = gap.a.change + part * (gap.b.change - gap.a.change);
  const double depth = -open - change;
  if (depth <= least) return depth;
  const double unit[2] = {n[0] / size, n[1] / size};
  double doubt = 0.0;
  const double out = bulge(m, z, gap, at, unit, &doubt);
  return depth - out - doubt;
}

// The boundary points of side 0 between two pairs.
void look_between(const Session& session, int32_t zone, const Gap& gap, double closed, Overlap& worst) {
  const Model& m = session.model;
  const Zone& z = m.zone[zone];
  const int b = z.body[0], chords = m.body[b].element_nodes - 1, step = z.element_step[0];
  const double chord = hypot(gap.b.x - gap.a.x, gap.b.y - gap.a.y);
  const double least = fmax(kMatters * closed, kTolerance * chord);
  const int32_t last = static_cast<int32_t>(gap.b.along * chords);
  for (int32_t i = static_cast<int32_t>(gap.a.along * chords); i <= last; ++i) {
    const double along = static_cast<double>(i) / chords;
    if (along < gap.a.along + kAtANode || along > gap.b.along - kAtANode) continue;
    const int32_t place = i / chords, node = i % chords, element = zone_element(m, z, 0, place);
    const double* p = m.xy[b] + 2 * geometry_node(m, b, element, step > 0 ? node : chords - node);
    const double depth = depth_at(session, z, gap, along, p, least);
    if (depth <= fmax(least, worst.size)) continue;
    worst = Overlap{depth, closed, p[0], p[1], zone, gap.first};
  }
}

double compliance(const Model& m, int b) {
  return is_rigid(m, b) ? 0.0 : (1.0 - strain_poisson_ratio(m, b)) / (2.0 * shear_modulus(m, b));
}

// Scale of the deformation: the largest closure of a gap. Conforming surfaces have no gaps to close; there the pressure times
// the compliance 1/E* of both bodies times the length of a pair estimates the local indentation (Johnson, Contact Mechanics,
// chapter 2).
double closed_in(const Session& session, const Zone& z) {
  const Model& m = session.model;
  double closed = 0.0, pressure = 0.0, length = 0.0;
  for (int32_t i = z.first_pair; i < z.first_pair + z.pairs; ++i) {
    const PairState now = pair_state(*session.follower.t, i, session.follower.y);
    closed = fmax(closed, m.pair[i].gap - now.wn * m.head->length_unit);
    pressure = fmax(pressure, now.p * m.head->stress_unit);
    length = fmax(length, length_at(m, m.pair[i]));
  }
  return fmax(closed, pressure * (compliance(m, z.body[0]) + compliance(m, z.body[1])) * length);
}

void look_in_zone(const Session& session, int32_t zone, Overlap& worst) {
  const Zone& z = session.model.zone[zone];
  const double closed = closed_in(session, z);
  Place before = place_of(session, z, z.first_pair);
  for (int32_t k = 1; k < z.pairs; ++k) {
    const Place now = place_of(session, z, z.first_pair + k);
    const bool forward = now.along > before.along;
    const Gap gap = forward ? Gap{z.first_pair + k - 1, z.first_pair + k, before, now}
                            : Gap{z.first_pair + k, z.first_pair + k - 1, now, before};
    // Neighbouring pairs lie close together on side 0; a jump of half the zone is the closing of a ring.
    const double elements = gap.b.along - gap.a.along;
    if (elements > 0.0 && 2 * elements < zone_elements(z, 0)) look_between(session, zone, gap, closed, worst);
    before = now;
  }
}

} // namespace

bool tell_between_nodes(const Session& session, Text& out, int32_t* zone, int32_t* pair) {
  const Model& m = session.model;
  Overlap worst;
  for (int32_t i = 0; i < m.head->zones && m.head->function_nodes > 1; ++i)
    if (m.zone[i].is_free != 0 && m.zone[i].is_tied == 0) look_in_zone(session, i, worst);
  if (worst.zone < 0) return false;
  *zone = worst.zone;
  *pair = worst.pair;
  put_all(out, "between the nodes of side 2 the bodies overlap by ");
  put(out, worst.size, 3);
  put_all(out, " at (", worst.x, ", ", worst.y, ")");
  if (worst.closed > 0.0) {
    put(out, ", while the loads close gaps by at most ");
    put(out, worst.closed, 3);
  }
  put(out, ": contact conditions are enforced at the nodes of side 2 only; refine side 2 there");
  return true;
}

} // namespace c2d
