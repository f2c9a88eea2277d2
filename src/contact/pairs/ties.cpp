#include "contact/pairs/ties.hpp"

#include "contact/pairs/facing_pairs.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

namespace {

// Tied pairs have no gap and no overlap, and stick at any coefficient of friction; the surfaces must be meant to coincide.
void bond_pairs(const Model& m, int32_t zone, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  constexpr double kMost = 0.1; // of an element
  int32_t worst = -1;
  for (int32_t k = z.first_pair; k < z.first_pair + z.pairs; ++k) {
    Pair& p = m.pair[k];
    const double off = fmax(p.gap, p.overlap);
    if (off > kMost * p.length && (worst < 0 || off > fmax(m.pair[worst].gap, m.pair[worst].overlap))) worst = k;
  }
  if (worst >= 0) {
    Finding f(at_pair(m, worst));
    say_pair(f, m, worst);
    say(f, ": the surfaces of the tied zone ", zone_named(m, zone), " are ", fmax(m.pair[worst].gap, m.pair[worst].overlap),
        " apart, expected surfaces that coincide within a tenth of an element, ", m.pair[worst].length, " long");
    report(reporter, f);
  }
  for (int32_t k = z.first_pair; k < z.first_pair + z.pairs; ++k) {
    m.pair[k].gap = m.pair[k].overlap = 0.0;
    m.pair[k].law = kFullAdhesion;
  }
}

bool has_unlike_materials(const Model& m, const Zone& z) {
  const Body &a = m.body[z.body[0]], &b = m.body[z.body[1]];
  return a.rigid != b.rigid || a.youngs_modulus != b.youngs_modulus || a.poisson_ratio != b.poisson_ratio;
}

// Does the boundary go on there outside of ties between the same two bodies? Not where it is held, as on a meshed line of
// symmetry.
bool ends_at(const Model& m, const Zone& z, const Pair& pair) {
  const int b = z.body[1];
  int32_t ends[2];
  const int count = ends_at_node(m, b, pair.node[1], ends);
  if (displacement_known(m, b, pair.node[1], 0) || displacement_known(m, b, pair.node[1], 1)) return false;
  for (int i = 0; i < count; ++i) {
    ZonePlace at;
    if (!find_contact_element(m, b, ends[i] / m.head->function_nodes, &at)) return true;
    const Zone& other = m.zone[at.zone];
    if (other.is_tied == 0 || other.body[0] + other.body[1] != z.body[0] + z.body[1]) return true;
  }
  return false;
}

void warn_ends(const Model& m, int32_t zone, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  if (!has_unlike_materials(m, z)) return;
  const int32_t at[2] = {z.first_pair, z.first_pair + z.pairs - 1};
  const bool ends[2] = {ends_at(m, z, m.pair[at[0]]), z.pairs > 1 && ends_at(m, z, m.pair[at[1]])};
  if (!ends[0] && !ends[1]) return;
  Finding f(C2D_WARN_TIE_END, at_pair(m, at[ends[0] ? 0 : 1]));
  say(f, "the tied zone ", zone_named(m, zone), " joins unlike materials, bodies ", body_named(m, z.body[0]), " and ",
      body_named(m, z.body[1]), ", and ends at ");
  for (int i = 0; i < 2; ++i) {
    if (!ends[i]) continue;
    double x, y;
    pair_position(m, m.pair[at[i]], 1, &x, &y);
    say(f, i == 1 && ends[0] ? " and (" : "(", x, ", ", y, ")");
  }
  say(f, ": stresses there are singular, and grow as elements get shorter; trust them from a few elements away");
  report(reporter, f);
}

// The pair of the node that a pair of a free zone faces, if it is tied and in this zone or an earlier one; -1: there is none.
int32_t next_in_ring(const Model& m, int32_t zone, const Pair& p) {
  const int32_t node = p.node[0] < 0 ? kFreeZonePart.faced_node(m, p) : -1;
  const PairSide next = node < 0 ? PairSide{-1, 0} : pair_of_node(m, body_on(m, p, 0), node);
  for (int32_t i = 0; i <= zone && next.side == 1; ++i) {
    const Zone& z = m.zone[i];
    if (z.is_tied != 0 && next.pair >= z.first_pair && next.pair < z.first_pair + z.pairs) return next.pair;
  }
  return -1;
}

// Nodes at one place, each tied to the next and the last to the first: the last tie says again what the others do, and their
// forces would be anything. (Rings whose nodes do not follow each other have a node in two pairs.)
void check_ring(const Model& m, int32_t zone, int32_t pair, Reporter& reporter) {
  int32_t at = pair, length = 0;
  do at = next_in_ring(m, zone, m.pair[at]);
  while (at >= 0 && at != pair && !C2D_NEVER(++length > m.head->zones)); // (no two face one node: what has no end comes back)
  if (at != pair) return;
  double x, y;
  pair_position(m, m.pair[pair], 1, &x, &y);
  Finding f(at_pair(m, pair));
  say_pair(f, m, pair);
  say(f, ": ties close a ring at (", x, ", ", y, "), of zones ", zone_named(m, zone));
  while ((at = next_in_ring(m, zone, m.pair[at])) != pair) say(f, ", ", zone_named(m, m.pair[at].zone));
  say(f, ": the last of them has nothing left to hold there, expected one that ends before that point");
  report(reporter, f);
}

} // namespace

void close_tie(const Model& m, int32_t zone, Reporter& reporter) {
  bond_pairs(m, zone, reporter);
  warn_ends(m, zone, reporter);
  for (int32_t k = 0; k < m.zone[zone].pairs; ++k) check_ring(m, zone, m.zone[zone].first_pair + k, reporter);
}

} // namespace c2d
