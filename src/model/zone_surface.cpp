// The surface of a side of a free zone with continuous normals (METHOD 8.5).
//
// At a kink the two normals are replaced by their mean, and the correction fades linearly towards the other ends of both
// elements. With continuous normals every point of one side faces a point of the other: discontinuous ones would leave wedges
// without facing points at convex kinks and double facing at concave ones.
#include "memory/math.hpp"
#include "model/facing.hpp"

#include "memory/hostile.hpp"
#include "model/symmetry.hpp"

namespace c2d {
namespace facing {

namespace {

void add_normal(const Model& m, int b, int32_t element, double eta, double n[2]) {
  const SurfacePoint p = surface_point(m, b, element, eta);
  n[0] += p.nx;
  n[1] += p.ny;
}

void normalise(double n[2]) {
  const double size = sqrt(n[0] * n[0] + n[1] * n[1]);
  if (size > 0) n[0] /= size, n[1] /= size;
}

// Lines of symmetry through an end of an element.
int32_t lines_at_end(const Model& m, int b, int32_t element, int end) {
  const int32_t point = geometry_node(m, b, element, end < 0 ? 0 : body_of(m, b).element_nodes - 1);
  return lines_through(*m.head, m.xy[b][2 * point], m.xy[b][2 * point + 1]);
}

} // namespace

bool is_ring(const Model& m, const Zone& z, int side) {
  const Region& r = m.region[z.body[side]][z.region[side]];
  return !r.open && zone_elements(z, side) == r.last - r.first + 1;
}

int32_t place_beside(const Model& m, const Zone& z, int side, int32_t place, int end) {
  const int32_t count = zone_elements(z, side), next = place + end * z.element_step[side];
  if (is_ring(m, z, side)) return (next + count) % count;
  return next < count ? next : -1;
}

namespace {

// Averages the normal at an end of an element with that of its neighbour. On a line of symmetry the neighbour is the image, and
// the mean has no component across the line.
void add_neighbour(const Model& m, const Zone& z, int side, const FacePoint& at, int end, double n[2]) {
  const int b = z.body[side];
  const int32_t next = place_beside(m, z, side, at.place, end);
  if (next >= 0) {
    add_normal(m, b, zone_element(m, z, side, next), -end, n);
  } else {
    const int32_t lines = lines_at_end(m, b, at.element, end);
    for (int c = 0; c < 2; ++c)
      if ((lines >> c & 1) != 0 && fabs(n[1 - c]) > kSnap) n[c] = 0;
  }
  normalise(n);
}

} // namespace

Place place_at(const Model& m, const Zone& z, int side, const SurfaceElement& surface, const FacePoint& at) {
  Place out;
  out.point = surface_point(surface, at.eta);
  double* n = out.n;
  n[0] = out.point.nx;
  n[1] = out.point.ny;
  for (int end = -1; end <= 1; end += 2) { // the correction at a kink fades towards the other end
    const double part = 0.5 * (1 + end * at.eta);
    if (part == 0) continue;
    const SurfacePoint own = surface_point(surface, end);
    double kink[2] = {own.nx, own.ny};
    add_neighbour(m, z, side, at, end, kink);
    n[0] += part * (kink[0] - own.nx);
    n[1] += part * (kink[1] - own.ny);
  }
  normalise(n);
  return out;
}
Place place_at(const Model& m, const Zone& z, int side, const FacePoint& at) {
  return place_at(m, z, side, surface_element(m, z.body[side], at.element), at);
}

} // namespace facing

using namespace facing;

SurfacePoint normal_in_zone(const Model& m, const Zone& z, int side, const FacePoint& at, double n[2]) {
  const Place place = place_at(m, z, side, at);
  n[0] = place.n[0], n[1] = place.n[1];
  return place.point;
}

void facing_direction(const Model& m, const Zone& z, const FacePoint& at1, const FacePoint& at2, double n[2]) {
  const Place p1 = place_at(m, z, 0, at1), p2 = place_at(m, z, 1, at2);
  const double part = z.normal_part;
  for (int c = 0; c < 2; ++c) n[c] = part * p1.n[c] - (1 - part) * p2.n[c];
  normalise(n);
}

int32_t element_beside_pair(const Model& m, const Pair& pair) {
  const Zone& z = m.zone[pair.zone];
  ZonePlace at;
  if (fabs(pair.eta) != 1.0) return -1;
  const bool in_zone = find_contact_element(m, z.body[0], pair.element, &at);
  if (C2D_NEVER(!in_zone)) return -1; // the element of a pair is always in its zone
  const int32_t beside = place_beside(m, z, 0, at.place, pair.eta > 0 ? 1 : -1);
  return beside < 0 ? -1 : zone_element(m, z, 0, beside);
}

} // namespace c2d
