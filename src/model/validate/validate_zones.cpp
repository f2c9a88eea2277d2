// Contact zones: valid references, and sides that face each other.
//
// Phases: bodies and regions exist; free zones are fitted (model/free_zones.cpp) and pairs numbered; matching zones list the
// nodes of their elements in corresponding order; no element or node is in two zones; elements face each other.
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "model/geometry.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

namespace {

void report_side(const Model& m, int32_t zone, int side, const char* found, int32_t number, const char* expected,
                 Reporter& reporter) {
  const int b = m.zone[zone].body[side];
  ZoneFinding f(m, zone);
  f.entry.body = b + 1;
  say(f, ", body ", body_named(m, b), ": ", found, number, expected);
  report(reporter, f);
}

// Two existing bodies, different (except in self-contact) and not both rigid.
void check_bodies(const Model& m, int32_t zone, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  const int32_t before = reporter.faults;
  for (const int32_t b : z.body)
    if (b < 0 || b >= m.head->bodies)
      report_zone(reporter, m, zone, ": there is no body ", b + 1, ", expected 1 to ", m.head->bodies);
  if (reporter.faults != before) return;
  if (z.body[0] == z.body[1] && z.is_self == 0)
    report_zone(reporter, m, zone, ": both sides are on body ", body_named(m, z.body[0]),
                ", expected two different bodies, or self-contact (C2D_ZONE_SELF; in a deck a minus before the second body)");
  else if (is_rigid(m, z.body[0]) && is_rigid(m, z.body[1]))
    report_zone(reporter, m, zone, ": bodies ", body_named(m, z.body[0]), " and ", body_named(m, z.body[1]),
                " are both rigid, expected one at most");
}

int32_t nodes_per_element(const Model& m) { return m.head->function_nodes == 1 ? 1 : m.head->function_nodes - 1; }

// Nodes a curve of so many elements has, both ends included; a constant element has one.
int32_t nodes_along(const Model& m, int32_t elements) {
  return m.head->function_nodes == 1 ? elements : elements * nodes_per_element(m) + 1;
}

// Direction of a side along its boundary, from the node or element numbers, whichever has more than one; 0: undefined.
int32_t direction(const Zone& z, int side) {
  if (z.pairs > 1) return z.node_step[side];
  return z.elements > 1 ? z.element_step[side] : 0;
}

void check_region(const Model& m, int32_t zone, int side, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  const int b = z.body[side];
  const Region& r = m.region[b][z.region[side]];
  const int32_t elements = r.last - r.first + 1;
  int32_t first_node, last_node;
  nodes_of_region(m, b, z.region[side], &first_node, &last_node);
  const int32_t count = zone_elements(z, side);
  if (count > elements) report_side(m, zone, side, "elements: ", count, ", more than its region has", reporter);
  if (z.is_free != 0) return; // the range of side 1 and its nodes are fitted later
  if (z.first_node[side] < first_node || z.first_node[side] > last_node)
    report_side(m, zone, side, "first node ", z.first_node[side] + 1, " is not in the region of its elements", reporter);
  if (z.pairs > last_node - first_node + 1)
    report_side(m, zone, side, "nodes: ", z.pairs, ", more than its region has", reporter);
  const int32_t end_element = z.first_element[side] + z.element_step[side] * (z.elements - 1);
  const int32_t end_node = z.first_node[side] + z.node_step[side] * (z.pairs - 1);
  if (r.open && (end_element < r.first || end_element > r.last || end_node < first_node || end_node > last_node))
    report_side(m, zone, side, "elements or nodes go beyond the end of their open region, from element ",
                z.first_element[side] + 1, "", reporter);
  if (z.pairs > 1 && z.elements > 1 && z.node_step[side] != z.element_step[side])
    report_side(m, zone, side, "elements and nodes run in opposite directions from element ", z.first_element[side] + 1,
                ", expected the same direction", reporter);
}

// Position of the first listed node along the elements of the zone, from 0; -1 if it is not one of their nodes.
int32_t place_of_first_node(const Model& m, const Zone& z, int side) {
  const int b = z.body[side];
  const Region& r = m.region[b][z.region[side]];
  const int32_t nodes = (r.last - r.first + 1) * nodes_per_element(m);
  int32_t place;
  if (direction(z, side) >= 0)
    place = z.first_node[side] - functional_node(m, b, z.first_element[side], 0);
  else if (m.head->function_nodes == 1)
    place = z.first_element[side] - z.first_node[side];
  else
    place = functional_node(m, b, z.first_element[side], 0) + nodes_per_element(m) - z.first_node[side];
  if (r.open) return place >= 0 && place < nodes_along(m, z.elements) ? place : -1;
  place = ((place % nodes) + nodes) % nodes;
  return place < nodes_along(m, z.elements) ? place : -1;
}

void check_nodes(const Model& m, int32_t zone, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  const int32_t along = nodes_along(m, z.elements);
  int32_t place[2];
  for (int side = 0; side < 2; ++side) {
    place[side] = place_of_first_node(m, z, side);
    if (place[side] < 0)
      report_side(m, zone, side, "node ", z.first_node[side] + 1, " is not a node of the zone's elements", reporter);
    else if (place[side] + z.pairs > along)
      report_side(m, zone, side, "node ", zone_node(m, z, side, z.pairs - 1) + 1, " is not a node of the zone's elements",
                  reporter);
  }
  if (place[0] < 0 || place[1] < 0) return;
  if (direction(z, 0) != 0 && place[0] != place[1])
    report_zone(reporter, m, zone, ": the first pair is node ", place[0] + 1, " along the elements of body ",
                body_named(m, z.body[0]), " and node ", place[1] + 1, " along those of body ", body_named(m, z.body[1]),
                ", expected the same place");
}

int32_t zone_of_pair(const Model& m, int32_t pair) {
  int32_t zone = 0;
  while (pair < m.zone[zone].first_pair || pair >= m.zone[zone].first_pair + m.zone[zone].pairs) ++zone;
  return zone;
}

// Elements in two zones, or nodes in two pairs. An element determines its traction once, so it can belong to one zone only.
void check_overlap(const Model& m, int32_t zone, int side, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  const int b = z.body[side];
  int32_t count = 0, first = 0, other = 0;
  for (int32_t k = 0; k < zone_elements(z, side); ++k) {
    ZonePlace found;
    const int32_t element = zone_element(m, z, side, k);
    const bool in_zone = find_contact_element(m, b, element, &found);
    if (C2D_NEVER(!in_zone)) continue;                      // elements of a zone are always found
    if (found.zone == zone && found.side == side) continue; // the search returns the first zone of the element
    if (count++ > 0) continue;
    first = element;
    other = found.zone;
  }
  if (count > 0) {
    Finding f(in_zone(m, zone, b, first));
    const bool both = other == zone; // self-contact: on both sides of one zone
    say(f, "element ", first + 1, " of body ", body_named(m, b), both ? " is on both sides of zone " : " is in zones ",
        zone_named(m, other));
    if (!both) say(f, " and ", zone_named(m, zone));
    if (count > 1) say(f, ", the first of ", count, both ? " elements on both" : " elements in two zones");
    say(f, both ? ", expected on one only" : ", expected in one only");
    return report(reporter, f);
  }
  for (int32_t k = 0; k < z.pairs && (z.is_free == 0 || side == 1); ++k) {
    const int32_t node = zone_node(m, z, side, k), pair = pair_of_node(m, b, node).pair;
    if (pair == z.first_pair + k) continue;
    const int32_t before = zone_of_pair(m, pair);
    Finding f(Where{z.line, b + 1, zone + 1, z.first_pair + k + 1, 0, node + 1});
    say(f, "node ", node + 1, " of body ", body_named(m, b), " is in pairs ", pair + 1, " and ", z.first_pair + k + 1, " of ");
    say(f, before == zone ? "zone " : "zones ", zone_named(m, before));
    if (before != zone) say(f, " and ", zone_named(m, zone));
    say(f, ", expected in one pair only");
    report(reporter, f);
  }
}

void check_lengths(const Model& m, int32_t zone, int side, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  const int b = z.body[side];
  for (int32_t k = 0; k < zone_elements(z, side); ++k) {
    const int32_t element = zone_element(m, z, side, k);
    if (is_zero_length(m, b, element))
      report_side(m, zone, side, "element ", element + 1, " has zero length, expected none in a contact zone", reporter);
  }
  for (int32_t k = 0; k < z.pairs && (z.is_free == 0 || side == 1); ++k) {
    const int32_t node = zone_node(m, z, side, k);
    if (twin_node(m, b, node) >= 0)
      report_side(m, zone, side, "node ", node + 1, " is a double node, expected none in a contact zone", reporter);
  }
}

// Mean outward normal of an element: its chord turned by -90 degrees.
void average_normal(const Model& m, int b, int32_t element, double n[2]) {
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  const int last = body_of(m, b).element_nodes - 1;
  const double dx = x[last] - x[0], dy = y[last] - y[0], size = sqrt(dx * dx + dy * dy);
  n[0] = size > 0 ? dy / size : 0;
  n[1] = size > 0 ? -dx / size : 0;
}

void facing_normals(const Model& m, const Zone& z, int32_t k, double n[2][2]) {
  for (int side = 0; side < 2; ++side) average_normal(m, z.body[side], zone_element(m, z, side, k), n[side]);
}

// `sound`: the bodies have no faults. Facing elements have opposing normals: their scalar product must be below -1/2.
void check_facing(const Model& m, int32_t zone, bool sound, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  if (direction(z, 0) != 0 && direction(z, 0) == direction(z, 1)) {
    return report_zone(reporter, m, zone,
                       ": numbers increase in the same direction on both sides, expected increasing numbers "
                       "on one side and decreasing ones on the other");
  }
  if (!sound) return; // with a body of wrong orientation no element would face the other side
  int32_t count = 0, worst = 0;
  double least = 0.0;
  for (int32_t k = 0; k < z.elements; ++k) {
    double n[2][2];
    facing_normals(m, z, k, n);
    const double turned = 0.5 + n[0][0] * n[1][0] + n[0][1] * n[1][1];
    if (turned < 0.0) continue;
    if (count++ > 0 && turned <= least) continue;
    worst = k;
    least = turned;
  }
  if (count == 0) return;
  double n[2][2];
  facing_normals(m, z, worst, n);
  const int32_t e1 = zone_element(m, z, 0, worst), e2 = zone_element(m, z, 1, worst);
  Finding f(in_zone(m, zone, z.body[0], e1));
  say(f, "zone ", zone_named(m, zone), ": element ", e1 + 1, " of body ", body_named(m, z.body[0]), " with normal (", n[0][0],
      ", ", n[0][1], ") and element ", e2 + 1, " of body ", body_named(m, z.body[1]), " with normal (", n[1][0], ", ", n[1][1],
      ") do not face each other");
  if (count > 1) say(f, ", the worst of ", count);
  report(reporter, f);
}

// Pairs of tied zones are numbered last: their status never changes, and the tableau needs no columns for them (METHOD 10.6).
void number_pairs(const Model& m) {
  int32_t pairs = 0;
  for (int32_t tied = 0; tied < 2; ++tied) {
    for (int32_t i = 0; i < m.head->zones; ++i) {
      if (m.zone[i].is_tied != tied) continue;
      m.zone[i].first_pair = pairs;
      pairs += m.zone[i].pairs;
    }
    if (tied == 0) m.head->path_pairs = pairs;
  }
  m.head->pairs = pairs;
}

// Is the node in a pair of another zone, which keeps it? Matching zones keep theirs, then ties, because their end may be the
// tip of a crack, then the first zone.
bool is_kept_by_another(const Model& m, int32_t zone, int32_t node) {
  const Zone& z = m.zone[zone];
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const Zone& other = m.zone[i];
    const bool keeps = other.is_free == 0 || (other.is_tied != z.is_tied ? other.is_tied != 0 : i < zone);
    if (i == zone || !keeps || other.body[1] != z.body[1]) continue;
    if (zone_node(m, other, 1, 0) == node || zone_node(m, other, 1, other.pairs - 1) == node) return true;
  }
  return false;
}

// Does a support hold the node of side 1 at the first or last pair of a free zone? In one direction it is symmetry if it holds
// the node that this one faces as well.
bool is_held(const Model& m, const Zone& z, int32_t k) {
  const int32_t f = m.head->function_nodes, node = zone_node(m, z, 1, k), place = k == 0 ? 0 : z.elements - 1;
  const bool held[2] = {displacement_known(m, z.body[1], node, 0), displacement_known(m, z.body[1], node, 1)};
  if (held[0] == held[1]) return held[0];
  const double eta = (k == 0) == (z.element_step[1] > 0) ? -1.0 : 1.0;
  FacePoint at;
  if (!kFreeZonePart.face_point(m, z, FacePoint{zone_element(m, z, 1, place), place, eta}, at)) return true;
  for (int l = 0; l < f; ++l)
    if (at.eta == node_eta(f, l) &&
        displacement_known(m, z.body[0], functional_node(m, z.body[0], at.element, l), held[0] ? 0 : 1))
      return false;
  return true;
}

// A free zone gives up an end node that is in another zone, or held by a support (pair_of_end). One pair is left.
void give_up_end_nodes(const Model& m, int32_t zone) {
  Zone& z = m.zone[zone];
  if (z.is_free == 0 || m.head->function_nodes == 1) return;
  const auto gives_up = [&](int32_t k) { return is_held(m, z, k) || is_kept_by_another(m, zone, zone_node(m, z, 1, k)); };
  const bool first = gives_up(0), last = gives_up(z.pairs - 1);
  if (last && z.pairs > 1) --z.pairs;
  if (!first || z.pairs < 2) return;
  z.first_node[1] = zone_node(m, z, 1, 1);
  --z.pairs;
}

// Fits free zones to the facing parts and numbers the pairs of all zones again.
bool fit_zones(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int32_t i = 0; i < m.head->zones; ++i) {
    m.zone[i].normal_part = find_normal_part(m, m.zone[i]);
    if (m.zone[i].is_free != 0) {
      check_lengths(m, i, 0, reporter);
      if (reporter.faults != before) return false; // a zero-length element has no normal
      kFreeZonePart.fit_free_zone(m, i, reporter);
    }
  }
  for (int32_t i = 0; i < m.head->zones && reporter.faults == before; ++i) give_up_end_nodes(m, i);
  number_pairs(m);
  return reporter.faults == before;
}

} // namespace

bool validate_zones(const Model& m, bool sound, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int32_t i = 0; i < m.head->zones; ++i) check_bodies(m, i, reporter);
  if (reporter.faults != before) return false;
  for (int32_t i = 0; i < m.head->zones; ++i)
    for (int side = 0; side < 2; ++side) check_region(m, i, side, reporter);
  if (reporter.faults != before) return false; // the following checks use the references of the zones
  if (!fit_zones(m, reporter)) return false;
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const bool platen = is_platen(m, m.zone[i].body[0]); // side 0 has no mesh of its own: both sides coincide
    if (m.zone[i].is_free == 0) {
      check_nodes(m, i, reporter);
      if (!platen) check_facing(m, i, sound, reporter);
    }
    for (int side = platen ? 1 : 0; side < 2; ++side) {
      check_overlap(m, i, side, reporter);
      check_lengths(m, i, side, reporter);
    }
  }
  return reporter.faults == before;
}

} // namespace c2d
