// Warning for free zones whose side 0 is meshed too coarsely for side 1 (sides count from 0 here, from 1 in messages).
//
// Cause. Displacements of side 0 are linear on its elements and have a kink at every node; the finer side 1 follows it. A kink
// of slope d in the surface of a half plane under contact changes the pressure at distance x by E*/(2 pi) d ln(L/x), from the
// surface displacement of a half plane under line loads (Johnson, Contact Mechanics, 1985, chapter 2).
// Phases: group the closed pairs by the element of side 0 that they face; compute the slope of the displacement of side 0 on
// each element from its first and last pair; from the kink between neighbouring elements estimate the error of the pressure;
// report the largest if it exceeds 5 % of the highest pressure. On a line of symmetry the image is the neighbour.
#include "results/warnings/facing_meshes.hpp"

#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/pair_frame.hpp"

namespace c2d {

namespace {

constexpr double kMost = 0.05; // of the highest pressure: a smaller error is not reported

// Closed pairs first ... last that face one element of side 0 and cover the fraction `part` of it.
struct Faced {
  int32_t first, last;
  double part, slope[2]; // of side 0's displacement along the element, in global components
};

// Displacement of the point of a pair on side 0, in the length unit.
void displacement_on_side0(const Session& session, int32_t i, double u[2]) {
  const Pair& pair = session.model.pair[i];
  const Real* own = session.area.u[0] + pair.dof;
  to_global(pair, own[0], pair.tangential != 0 ? own[1] : 0.0, u);
}

bool is_closed(const Session& session, int32_t i) { return session.model.pair[i].status != C2D_OPEN; }

// The pairs from i on that face the same element, with the slope between the first and the last of them.
Faced faced_from(const Session& session, const Zone& z, int32_t i) {
  const Model& m = session.model;
  Faced out{i, i, 0.0, {0.0, 0.0}};
  const int32_t end = z.first_pair + z.pairs;
  while (out.last + 1 < end && m.pair[out.last + 1].element == m.pair[i].element && is_closed(session, out.last + 1))
    ++out.last;
  double u[2], v[2];
  displacement_on_side0(session, out.first, u);
  displacement_on_side0(session, out.last, v);
  out.part = 0.5 * fabs(m.pair[out.last].eta - m.pair[i].eta);
  const double length = out.part * element_length(m, z.body[0], m.pair[i].element) / m.head->length_unit;
  for (int c = 0; c < 2 && out.last > i; ++c) out.slope[c] = (v[c] - u[c]) / length;
  return out;
}

// Error of the pressure due to the kink between two elements of side 0. L is the length of an element of side 0 and x that of
// an element of side 1, so L/x is the number of intervals between pairs on the shorter stretch. Fewer than two intervals have
// no logarithm worth reporting, and on less than 0.4 of an element the slope is not known well enough.
double added_by_kink(const Model& m, const Zone& z, const Faced& a, const Faced& b) {
  constexpr double kWhole = 0.4; // of an element
  const int32_t fewer = a.last - a.first < b.last - b.first ? a.last - a.first : b.last - b.first;
  if (fewer < 2 || a.part < kWhole || b.part < kWhole) return 0.0;
  const Pair& pair = m.pair[b.first];
  const double kink = (b.slope[0] - a.slope[0]) * pair.nx + (b.slope[1] - a.slope[1]) * pair.ny;
  const int body = z.body[1]; // only side 1 deforms to follow the kink: side 0 is fixed by its own nodes
  const double compliance = (1.0 - strain_poisson_ratio(m, body)) / (2.0 * shear_modulus(m, body));
  return fabs(kink) * log(fewer) / (2.0 * kPi * compliance);
}

// The image of a stretch across a line of symmetry: the slope of the normal displacement changes its sign.
Faced image_of(const Model& m, const Faced& a) {
  const Pair& pair = m.pair[m.pair[a.first].tangential == 0 ? a.first : a.last];
  const double across = a.slope[0] * pair.nx + a.slope[1] * pair.ny;
  Faced out = a;
  out.slope[0] -= 2.0 * across * pair.nx;
  out.slope[1] -= 2.0 * across * pair.ny;
  return out;
}

double highest_pressure(const Session& session, const Zone& z) {
  double most = 0.0;
  for (int32_t i = z.first_pair; i < z.first_pair + z.pairs; ++i)
    most = fmax(most, pair_state(*session.follower.t, i, session.follower.y).p);
  return most * session.model.head->stress_unit;
}

} // namespace

bool tell_facing_meshes(const Session& session, Text& out, int32_t* zone, int32_t* pair) {
  const Model& m = session.model;
  double worst = kMost;
  for (int32_t i = 0; i < m.head->zones && m.head->function_nodes == 2; ++i) {
    const Zone& z = m.zone[i];
    if (z.is_free == 0 || z.is_tied != 0 || is_rigid(m, z.body[0]) || is_rigid(m, z.body[1])) continue;
    const double highest = highest_pressure(session, z);
    Faced before{0, 0, 0.0, {0.0, 0.0}};
    for (int32_t k = z.first_pair; k < z.first_pair + z.pairs && highest > 0.0; ++k) {
      if (!is_closed(session, k)) continue;
      const Faced now = faced_from(session, z, k);
      double added = before.last + 1 == now.first ? added_by_kink(m, z, before, now) / highest : 0.0;
      if (m.pair[now.first].tangential == 0 || m.pair[now.last].tangential == 0)
        added = fmax(added, added_by_kink(m, z, image_of(m, now), now) / highest);
      if (added > worst) worst = added, *zone = i, *pair = k;
      before = now;
      k = now.last;
    }
  }
  if (worst <= kMost) return false;
  put(out, "the elements of side 1 are too long for those of side 2: where two of them meet the pressure is uncertain by ");
  put(out, 100.0 * worst, 2);
  put(out, " % of the highest; refine side 1 there");
  return true;
}

} // namespace c2d
