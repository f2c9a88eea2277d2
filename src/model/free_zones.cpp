// Fits free contact zones: the range of side 1 is reduced to the elements that face side 0 over their whole length.
//
// Every functional node of side 1 becomes a pair and needs a facing point on side 0. An element that faces side 0 only in part
// would have nodes without one. Phases: test all nodes and both ends of every element of side 1; require one run of consecutive
// elements whose facing points advance monotonically and whose normals oppose those of side 0; keep that run; warn about an
// element at its ends that faces side 0 in part, because contact is not computed there; mark ends of side 0 that nothing faces.
#include "model/free_zones.hpp"

#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "model/facing.hpp"
#include "model/geometry.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

using namespace facing;

namespace {

enum class Cover { none, whole, averted };

// Does an element of side 1 face side 0 with all its nodes and both ends? Averted: it has facing points, but
// the outward normals differ by less than 120 degrees, or the points run in the wrong order.
Cover cover(const Model& m, const Zone& z, int32_t place2) {
  double before = 0, eta2;
  FacePoint at;
  for (int32_t stop = 0; own_cut(m, z, stop, &eta2); ++stop) {
    const FacePoint at2 = point_at(m, z, 1, place2, eta2);
    if (!face_point(m, z, at2, at)) return Cover::none;
    const Place p1 = place_at(m, z, 0, at), p2 = place_at(m, z, 1, at2);
    double now = position(z, at);
    if (is_ring(m, z, 0) && stop > 0 && now < before - 0.5 * zone_elements(z, 0)) now += zone_elements(z, 0);
    if (p1.n[0] * p2.n[0] + p1.n[1] * p2.n[1] > -0.5 || (stop > 0 && now <= before + kSnap)) return Cover::averted;
    before = now;
  }
  return Cover::whole;
}

// The element of side 1 opposite the start (-1) or end (+1) of side 0 in the order of the zone, if more than `part` of it
// faces side 0; else -1.
int32_t element_faced_in_part(const Model& m, const Zone& z, int way, double part) {
  const FacePoint end = point_at(m, z, 0, way < 0 ? 0 : zone_elements(z, 0) - 1, way * z.element_step[0]);
  FacePoint faced;
  if (!facing_point(m, z, end, faced)) return -1;
  const Place p1 = place_at(m, z, 0, end), p2 = place_at(m, z, 1, faced);
  const double size = 0.5 * (1 + way * z.element_step[1] * faced.eta);
  return size > part && p1.n[0] * p2.n[0] + p1.n[1] * p2.n[1] < 0 ? faced.element : -1;
}

// Warns about the elements next to the kept range that face side 0 in part: the contact ends before the end of side 0 there.
void warn_left_out(const Model& m, int32_t zone, int32_t first, int32_t count, Reporter& reporter) {
  constexpr double kPart = 1e-3; // of an element: a smaller part is round-off of the facing point
  const Zone& z = m.zone[zone];
  int32_t left_out[2] = {-1, -1};
  if (is_ring(m, z, 0)) return;
  for (int i = 0; i < 2; ++i) {
    left_out[i] = element_faced_in_part(m, z, 2 * i - 1, kPart);
    for (int32_t k = 0; k < count; ++k)
      if (zone_element(m, z, 1, first + k) == left_out[i]) left_out[i] = -1;
  }
  if (left_out[0] == left_out[1]) left_out[1] = -1;
  for (const int32_t element : left_out) {
    if (element < 0) continue;
    warn(reporter, C2D_WARN_LEFT_OUT, in_zone(m, zone, z.body[1], element), "zone ", zone_named(m, zone), ": element ",
         element + 1, " of body ", body_named(m, z.body[1]), " faces body ", body_named(m, z.body[0]),
         " over part of its length only and is excluded from the zone: no contact is computed on it");
  }
}

// Sets the range of side 1, its nodes and the number of pairs.
void keep_elements(const Model& m, Zone& z, int32_t first, int32_t count) {
  const int32_t f = m.head->function_nodes;
  z.first_element[1] = zone_element(m, z, 1, first);
  z.elements = count;
  z.node_step[1] = z.element_step[1];
  z.first_node[1] = functional_node(m, z.body[1], z.first_element[1], z.element_step[1] > 0 ? 0 : f - 1);
  z.pairs = f == 1 ? count : count * (f - 1) + (is_ring(m, z, 1) ? 0 : 1);
}

} // namespace

void facing::mark_unfaced_ends(const Model& m, int32_t zone) {
  const Zone& z = m.zone[zone];
  const int b = z.body[0], f = m.head->function_nodes;
  for (int32_t place = 0; place < zone_elements(z, 0); ++place) {
    ZonePlace found;
    const int32_t element = zone_element(m, z, 0, place);
    const bool in_zone = find_contact_element(m, b, element, &found);
    if (C2D_NEVER(!in_zone)) continue; // elements of a zone are always found
    if (found.zone != zone) continue;
    for (int l = 0; l < f; ++l) {
      FacePoint faced;
      uint8_t& code = m.end_code[b][element * f + l];
      const bool faces = facing_point(m, z, FacePoint{element, found.place, node_eta(f, l)}, faced);
      code = static_cast<uint8_t>(faces ? code & ~kFacesNothing : code | kFacesNothing);
    }
  }
}

bool fit_free_zone(const Model& m, int32_t zone, Reporter& reporter) {
  Zone& z = m.zone[zone];
  const NamedBody one = body_named(m, z.body[0]), two = body_named(m, z.body[1]);
  int32_t first = -1, count = 0;
  for (int32_t place = 0; place < z.elements; ++place) {
    const int32_t element = zone_element(m, z, 1, place);
    const Cover found = cover(m, z, place);
    if (found == Cover::none) continue;
    if (found == Cover::averted) {
      report(reporter, in_zone(m, zone, z.body[1], element), "zone ", zone_named(m, zone), ": element ", element + 1,
             " of body ", two, " does not face the elements of body ", one);
      return false;
    }
    if (first >= 0 && place != first + count) {
      report_zone(reporter, m, zone, ": the elements of body ", two, " that face body ", one,
                  " form several ranges, expected one range of consecutive elements");
      return false;
    }
    if (first < 0) first = place;
    ++count;
  }
  if (first < 0) {
    report_zone(reporter, m, zone, ": no element of body ", two, " faces body ", one,
                " over its whole length, expected ranges of elements that face each other");
    return false;
  }
  warn_left_out(m, zone, first, count, reporter);
  keep_elements(m, z, first, count);
  mark_unfaced_ends(m, zone);
  return true;
}

void faced_position(const Model& m, const Pair& pair, double* x, double* y) {
  const FacePoint at{pair.element, 0, pair.eta};
  const int b = body_on(m, pair, 0);
  const int32_t node = node_at(m, b, at);
  if (node >= 0) return node_position(m, b, node, x, y);
  const CurvePoint p = curve_point(m, b, pair.element, pair.eta);
  *x = p.x;
  *y = p.y;
}

} // namespace c2d
