// Points of two surfaces that face each other (METHOD 8.5).
//
// Two points p1 and p2 face each other if p2 - p1 is parallel to the mixed normal n = m n_1 - (1 - m) n_2, METHOD (8.3), with
// normals that are continuous along each side. With the signed distance ahead = (p2 - p1) x n this is the scalar equation
// ahead(eta) = 0 on one element. Phases of a search: order the elements from the one with the nearest middle; exclude those
// that are farther away than the best point so far; on the others test for a change of sign between the ends and solve by
// regula falsi; of several solutions keep the nearest.
#include "memory/math.hpp"
#include "model/facing.hpp"

#include "memory/hostile.hpp"
#include "model/geometry.hpp"

namespace c2d {
namespace facing {

namespace {

// Distance by which p2 lies ahead, in the direction of travel of side 0, of the line through p1 along the mixed normal; times
// |n|.
double ahead(double part, const Place& p1, const Place& p2) {
  const double n[2] = {part * p1.n[0] - (1 - part) * p2.n[0], part * p1.n[1] - (1 - part) * p2.n[1]};
  return (p2.point.y - p1.point.y) * n[0] - (p2.point.x - p1.point.x) * n[1];
}

} // namespace

double Search::operator()(double eta) const {
  const Place there = place_at(m, z, side, surface, FacePoint{element, place, eta});
  return side == 0 ? ahead(z.normal_part, there, from) : ahead(z.normal_part, from, there);
}

Search search_in(const Model& m, const Zone& z, const Place& from, int side, int32_t place) {
  const int32_t element = zone_element(m, z, side, place);
  return Search{m, z, from, side, element, place, surface_element(m, z.body[side], element)};
}

// Illinois variant of regula falsi (Dowell and Jarratt, BIT 11, 1971): bracketing like bisection, superlinear, and without
// derivatives, which the smooth surface does not provide.
double zero_between(double a, double b, double fa, double fb, const Search& f) {
  const double none = 1e-16 * fmax(fabs(fa), fabs(fb));
  double at = a;
  for (int i = 0; i < 100 && fb != fa;
       ++i) { // about ten steps suffice, except on discontinuous surfaces, which are refused later
    at = b - fb * (b - a) / (fb - fa);
    const double value = f(at);
    if (fabs(value) <= none || fabs(b - a) <= 4e-16) break;
    if ((value > 0) == (fb > 0)) {
      b = at, fb = value, fa *= 0.5;
    } else {
      a = b, fa = fb, b = at, fb = value;
    }
  }
  return at;
}

} // namespace facing

using namespace facing;

namespace {

// A facing point within kSnap of a node or an element end is moved onto it: so the pair uses the nodal value, and round-off
// does not decide between two elements.
double snapped(const Model& m, double eta) {
  for (int end = -1; end <= 1; end += 2)
    if (fabs(eta - end) <= kSnap) return end;
  const int f = m.head->function_nodes;
  for (int l = 0; l < f; ++l)
    if (fabs(eta - node_eta(f, l)) <= kSnap) return node_eta(f, l);
  return eta;
}

// The point of one element of side 0 that p2 faces. The ends are tested with a tolerance, so that a point that faces the joint
// of two elements is found on at least one of them.
bool face_in_element(const Model& m, const Zone& z, int32_t place, const Place& p2, FacePoint& out) {
  out = point_at(m, z, 0, place, -1);
  const Search off = search_in(m, z, p2, 0, place);
  const double tolerance = kSnap * element_length(m, z.body[0], out.element);
  const double start = off(-1);
  if (start < -tolerance) return false;
  if (start <= tolerance) return true;
  out.eta = 1;
  const double end = off(1);
  if (end > tolerance) return false;
  if (end >= -tolerance) return true;
  out.eta = snapped(m, zero_between(-1.0, 1.0, start, end, off));
  return true;
}

// The point of side 0 that p2 faces, the nearest of all elements.
bool face_place(const Model& m, const Zone& z, const Place& p2, FacePoint& out) {
  double nearest = -1;
  const int32_t count = zone_elements(z, 0), from = nearest_place(m, z, 0, p2.point);
  for (int32_t k = 0; k < count; ++k) {
    const int32_t place = (from + k) % count;
    FacePoint found;
    if (nearest >= 0 && is_beyond(m, z.body[0], zone_element(m, z, 0, place), p2.point, nearest)) continue;
    if (!face_in_element(m, z, place, p2, found)) continue;
    const SurfacePoint p = surface_point(m, z.body[0], found.element, found.eta);
    const double x = p2.point.x - p.x, y = p2.point.y - p.y, distance = x * x + y * y;
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    out = found;
  }
  return nearest >= 0;
}

} // namespace

bool face_point(const Model& m, const Zone& z, const FacePoint& at2, FacePoint& out) {
  return face_place(m, z, place_at(m, z, 1, at2), out);
}

namespace {

// The point of one element of side 1 that faces p1.
bool faced_in_element(const Model& m, const Zone& z, int32_t place, const Place& p1, FacePoint& out) {
  const int32_t other = zone_element(m, z, 1, place);
  const Search off = search_in(m, z, p1, 1, place);
  const double start = off(-1), end = off(1);
  const Closeness close = closeness(m, z.body[1], other, start, end);
  out = FacePoint{other, place, close.start ? -1.0 : 1.0};
  if (close.start || close.end) return true;
  if ((start > 0) == (end > 0)) return false;
  out.eta = zero_between(-1.0, 1.0, start, end, off);
  return true;
}

// Position of the k-th pair along side 0, in elements.
double position_of_pair(const Model& m, const Zone& z, int32_t k) {
  const Pair& pair = m.pair[z.first_pair + k];
  ZonePlace faced;
  const bool in_zone = find_contact_element(m, z.body[0], pair.element, &faced);
  return C2D_NEVER(!in_zone) ? 0.0 : position(z, FacePoint{pair.element, faced.place, pair.eta}); // what a pair's node faces is
}

// 1: the first node of side 1 is in no pair of the zone (pair_of_end).
int32_t nodes_before_pairs(const Model& m, const Zone& z) {
  const int local = z.element_step[1] > 0 ? 0 : m.head->function_nodes - 1;
  return functional_node(m, z.body[1], z.first_element[1], local) == z.first_node[1] ? 0 : 1;
}

// The element of side 1 that a point of side 0 faces, by bisection over the pairs: their positions along side 0 increase along
// the zone. It replaces a search over all elements when the pairs are known. On a ring positions are counted from the first
// pair.
int32_t place_between_pairs(const Model& m, const Zone& z, const FacePoint& at) {
  const bool ring = is_ring(m, z, 0);
  const double start = ring ? position_of_pair(m, z, 0) : 0.0, all = zone_elements(z, 0);
  const auto ahead = [&](double where) { return where < start ? where - start + all : where - start; };
  const double sought = ahead(position(z, at));
  int32_t low = 0, high = z.pairs; // the point lies after pair `low` and before pair `high`
  while (high - low > 1) {
    const int32_t middle = low + (high - low) / 2;
    (ahead(position_of_pair(m, z, middle)) <= sought ? low : high) = middle;
  }
  const int32_t place = (low + nodes_before_pairs(m, z)) / (m.head->function_nodes - 1);
  return place < z.elements ? place : z.elements - 1;
}

} // namespace

bool facing_point_by_pairs(const Model& m, const Zone& z, const FacePoint& at, FacePoint& out) {
  if (!kSmallCode && m.head->function_nodes > 1) { // with constant functions pairs lie in the middle of elements, not at ends
    const int32_t place = place_between_pairs(m, z, at);
    if (faced_in_element(m, z, place, place_at(m, z, 0, at), out)) return true;
  }
  return facing_point(m, z, at, out);
}

bool facing_point(const Model& m, const Zone& z, const FacePoint& at, FacePoint& out) {
  const Place p1 = place_at(m, z, 0, at);
  double nearest = -1;
  const int32_t count = zone_elements(z, 1), from = nearest_place(m, z, 1, p1.point);
  for (int32_t k = 0; k < count; ++k) {
    const int32_t place = (from + k) % count, other = zone_element(m, z, 1, place);
    if (nearest >= 0 && is_beyond(m, z.body[1], other, p1.point, nearest)) continue;
    FacePoint found;
    if (!faced_in_element(m, z, place, p1, found)) continue;
    const SurfacePoint q = surface_point(m, z.body[1], other, found.eta);
    const double x = q.x - p1.point.x, y = q.y - p1.point.y, distance = x * x + y * y;
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    out = found;
  }
  return nearest >= 0;
}

int32_t node_at(const Model& m, int b, const FacePoint& at) {
  const int f = m.head->function_nodes;
  for (int l = 0; l < f; ++l)
    if (at.eta == node_eta(f, l)) return functional_node(m, b, at.element, l);
  return -1;
}

} // namespace c2d
