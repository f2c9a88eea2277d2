#include "model/free_zones.hpp"

#include "model/geometry.hpp"
#include "model/surface.hpp"
#include "model/symmetry.hpp"
#include "model/validate_finding.hpp"

#include <math.h>

namespace c2d {

namespace {

constexpr double kSnap = 1e-9; // local coordinates nearer to a node are the node's

bool is_ring(const Model& m, const Zone& z, int side) {
  const Region& r = m.region[z.body[side]][z.region[side]];
  return !r.open && zone_elements(z, side) == r.last - r.first + 1;
}

void add_normal(const Model& m, int b, int32_t element, double eta, double n[2]) {
  const SurfacePoint p = surface_point(m, b, element, eta);
  n[0] += p.nx;
  n[1] += p.ny;
}

void normalise(double n[2]) {
  const double size = sqrt(n[0] * n[0] + n[1] * n[1]);
  if (size > 0) n[0] /= size, n[1] /= size;
}

// Lines of symmetry through that point.
int32_t lines_at_end(const Model& m, int b, int32_t element, int end) {
  const int32_t point = geometry_node(m, b, element, end < 0 ? 0 : body_of(m, b).element_nodes - 1);
  return lines_through(*m.head, m.xy[b][2 * point], m.xy[b][2 * point + 1]);
}

// The place of the element that meets the one at a place at its start (-1) or end (1), -1: none in the zone.
int32_t place_beside(const Model& m, const Zone& z, int side, int32_t place, int end) {
  const int32_t count = zone_elements(z, side), next = place + end * z.element_step[side];
  if (is_ring(m, z, side)) return (next + count) % count;
  return next < count ? next : -1;
}

// Adds to the normal at the start or end of an element its neighbour's, which on a line of symmetry is its own image.
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

FacePoint point_at(const Model& m, const Zone& z, int side, int32_t place, double eta) {
  return FacePoint{zone_element(m, z, side, place), place, eta};
}

// Unit normal of a side's surface at a point, continuous along the zone; returns the point.
SurfacePoint zone_normal(const Model& m, const Zone& z, int side, const SurfaceElement& surface, const FacePoint& at,
                         double n[2]) {
  const SurfacePoint here = surface_point(surface, at.eta);
  n[0] = here.nx;
  n[1] = here.ny;
  for (int end = -1; end <= 1; end += 2) { // what a kink's mean normal adds fades towards the other end
    const double part = 0.5 * (1 + end * at.eta);
    if (part == 0) continue;
    const SurfacePoint own = surface_point(surface, end);
    double kink[2] = {own.nx, own.ny};
    add_neighbour(m, z, side, at, end, kink);
    n[0] += part * (kink[0] - own.nx);
    n[1] += part * (kink[1] - own.ny);
  }
  normalise(n);
  return here;
}

// A point of a surface and the normal there.
struct Place {
  SurfacePoint point;
  double n[2];
};
Place place_at(const Model& m, const Zone& z, int side, const SurfaceElement& surface, const FacePoint& at) {
  Place out;
  out.point = zone_normal(m, z, side, surface, at, out.n);
  return out;
}
Place place_at(const Model& m, const Zone& z, int side, const FacePoint& at) {
  return place_at(m, z, side, surface_element(m, z.body[side], at.element), at);
}

// How far p2 lies ahead, in side 0's direction of travel, of the line through p1 along which points face each other.
double ahead(double part, const Place& p1, const Place& p2) {
  const double n[2] = {part * p1.n[0] - (1 - part) * p2.n[0], part * p1.n[1] - (1 - part) * p2.n[1]};
  return (p2.point.y - p1.point.y) * n[0] - (p2.point.x - p1.point.x) * n[1];
}

// What an element of a side has opposite a place of the other.
struct Search {
  const Model& m;
  const Zone& z;
  const Place& from;
  int side;
  int32_t element, place;
  SurfaceElement surface;

  // How far side 1's point lies ahead, for a point of the element. (Not inlined, like what follows: they go deep.)
  [[gnu::noinline]] double operator()(double eta) const {
    const Place there = place_at(m, z, side, surface, FacePoint{element, place, eta});
    return side == 0 ? ahead(z.normal_part, there, from) : ahead(z.normal_part, from, there);
  }
};
Search search_in(const Model& m, const Zone& z, const Place& from, int side, int32_t place) {
  const int32_t element = zone_element(m, z, side, place);
  return Search{m, z, from, side, element, place, surface_element(m, z.body[side], element)};
}

// Zero of f between a and b, where it has the values fa and fb of unlike sign: false position, with the value
// at an end that stays halved (Illinois), exact for a linear f. A value within the last digit of those at the ends is zero:
// halved a hundred times, they would become as small, and the zero wander off.
double zero_between(double a, double b, double fa, double fb, const Search& f) {
  const double none = 1e-16 * fmax(fabs(fa), fabs(fb));
  double at = a;
  for (int i = 0; i < 100; ++i) {
    const double size = fb - fa;
    if (size == 0) break;
    at = b - fb * (b - a) / size;
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

double snapped(const Model& m, double eta) {
  for (int end = -1; end <= 1; end += 2)
    if (fabs(eta - end) <= kSnap) return end;
  const int f = m.head->function_nodes;
  for (int l = 0; l < f; ++l)
    if (fabs(eta - node_eta(f, l)) <= kSnap) return node_eta(f, l);
  return eta;
}

// Of an element: where curve_point() is in its middle.
void middle_of(int nodes, const double* x, const double* y, double out[2]) {
  static constexpr double kPart[3][kElementNodes] = {{0.5, 0.5}, {0, 1, 0}, {-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16}};
  out[0] = out[1] = 0;
  for (int i = 0; i < nodes; ++i) out[0] += kPart[nodes - 2][i] * x[i], out[1] += kPart[nodes - 2][i] * y[i];
}

// Of an element: no less than element_length(), at a small part of its price. Of every chord from node to node, its length
// times the integral of the magnitude of what it adds to the derivative by eta, which is 1.25 with three nodes and up to 2.01
// with four.
double length_at_most(int nodes, const double* x, const double* y) {
  double sum = 0;
  for (int i = 1; i < nodes; ++i) {
    const double dx = x[i] - x[i - 1], dy = y[i] - y[i - 1];
    sum += sqrt(dx * dx + dy * dy);
  }
  return (nodes == 3 ? 1.26 : nodes == 4 ? 2.02 : 1) * sum;
}

// Is every point of a surface over an element farther off than the root of `square`? The surface stays within
// half the element's length of it. (Not inlined, like nearest_place: what looks for a facing point goes deep.)
[[gnu::noinline]] bool is_beyond(const Model& m, int b, int32_t element, const SurfacePoint& from, double square) {
  const int nodes = body_of(m, b).element_nodes;
  double px[kElementNodes], py[kElementNodes], middle[2];
  element_coordinates(m, b, element, px, py);
  middle_of(nodes, px, py, middle);
  const double x = middle[0] - from.x, y = middle[1] - from.y, off = sqrt(x * x + y * y);
  double far = off - 1.5 * length_at_most(nodes, px, py);
  if (far > 0 && far * far > square) return true;
  far = off - 1.5 * element_length(m, b, element);
  return far > 0 && far * far > square;
}

// Are values at the ends of an element within a part of its length of zero? Most are not within one of a bound of it.
struct Closeness {
  bool start, end;
};
[[gnu::noinline]] Closeness closeness(const Model& m, int b, int32_t element, double start, double end) {
  const int nodes = body_of(m, b).element_nodes;
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  const double most = kSnap * length_at_most(nodes, x, y);
  if (fabs(start) > most && fabs(end) > most) return Closeness{false, false};
  const double tolerance = kSnap * element_length(m, b, element);
  return Closeness{fabs(start) <= tolerance, fabs(end) <= tolerance};
}

// The element of a side whose middle is nearest: what faces a point is most likely on it, and all that is farther off than
// that need not be looked at.
[[gnu::noinline]] int32_t nearest_place(const Model& m, const Zone& z, int side, const SurfacePoint& from) {
  int32_t best = 0;
  double least = -1;
  for (int32_t place = 0; place < zone_elements(z, side); ++place) {
    double px[kElementNodes], py[kElementNodes], p[2];
    element_coordinates(m, z.body[side], zone_element(m, z, side, place), px, py);
    middle_of(body_of(m, z.body[side]).element_nodes, px, py, p);
    const double x = p[0] - from.x, y = p[1] - from.y, square = x * x + y * y;
    if (least < 0 || square < least) least = square, best = place;
  }
  return best;
}

// The point of one element that faces p2.
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

SurfacePoint normal_in_zone(const Model& m, const Zone& z, int side, const FacePoint& at, double n[2]) {
  return zone_normal(m, z, side, surface_element(m, z.body[side], at.element), at, n);
}

bool face_point(const Model& m, const Zone& z, const FacePoint& at2, FacePoint& out) {
  return face_place(m, z, place_at(m, z, 1, at2), out);
}

bool facing_point(const Model& m, const Zone& z, const FacePoint& at, FacePoint& out) {
  const Place p1 = place_at(m, z, 0, at);
  double nearest = -1;
  const int32_t count = zone_elements(z, 1), from = nearest_place(m, z, 1, p1.point);
  for (int32_t k = 0; k < count; ++k) {
    const int32_t place = (from + k) % count, other = zone_element(m, z, 1, place);
    if (nearest >= 0 && is_beyond(m, z.body[1], other, p1.point, nearest)) continue;
    const Search off = search_in(m, z, p1, 1, place);
    const double start = off(-1), end = off(1);
    const Closeness close = closeness(m, z.body[1], other, start, end);
    double where;
    if (close.start)
      where = -1;
    else if (close.end)
      where = 1;
    else if ((start > 0) == (end > 0))
      continue;
    else
      where = zero_between(-1.0, 1.0, start, end, off);
    const SurfacePoint q = surface_point(off.surface, where);
    const double x = q.x - p1.point.x, y = q.y - p1.point.y, distance = x * x + y * y;
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    out = FacePoint{other, place, where};
  }
  return nearest >= 0;
}

void facing_direction(const Model& m, const Zone& z, const FacePoint& at1, const FacePoint& at2, double n[2]) {
  const Place p1 = place_at(m, z, 0, at1), p2 = place_at(m, z, 1, at2);
  const double part = z.normal_part;
  for (int c = 0; c < 2; ++c) n[c] = part * p1.n[c] - (1 - part) * p2.n[c];
  normalise(n);
}

int32_t node_at(const Model& m, int b, const FacePoint& at) {
  const int f = m.head->function_nodes;
  for (int l = 0; l < f; ++l)
    if (at.eta == node_eta(f, l)) return functional_node(m, b, at.element, l);
  return -1;
}

int32_t element_beside_pair(const Model& m, const Pair& pair) {
  const Zone& z = m.zone[pair.zone];
  ZonePlace at;
  if (fabs(pair.eta) != 1.0 || !find_contact_element(m, z.body[0], pair.element, &at)) return -1;
  const int32_t beside = place_beside(m, z, 0, at.place, pair.eta > 0 ? 1 : -1);
  return beside < 0 ? -1 : zone_element(m, z, 0, beside);
}

// ---- pieces
// -----------------------------------------------------------------------------------------------------

namespace {

// In the order of the zone, one unit per element.
double position(const Zone& z, const FacePoint& p) { return p.place + 0.5 * (1 + z.element_step[0] * p.eta); }

// The `stop`-th place at which an element of side 1 is cut for its own nodes, from 0; false beyond its end.
bool own_cut(const Model& m, const Zone& z, int32_t stop, double* eta) {
  const int f = m.head->function_nodes, cuts = f < 2 ? 3 : f;
  if (stop >= cuts) return false;
  const double at = node_eta(cuts, stop);
  *eta = z.element_step[1] > 0 ? at : -at;
  return true;
}

bool face_own_cut(const Model& m, const Zone& z, const FacePoint& at2, FacePoint& out) {
  const int f = m.head->function_nodes;
  for (int l = 0; l < f && f > 1; ++l) { // a pair's node: its point has been found
    const int32_t pair = at2.eta == node_eta(f, l) ? pair_of_end(m, z.body[1], at2.element, l).pair : -1;
    if (pair < 0) continue;
    ZonePlace faced;
    out.element = m.pair[pair].element;
    out.eta = m.pair[pair].eta;
    if (!find_contact_element(m, z.body[0], out.element, &faced)) return false;
    out.place = faced.place;
    return true;
  }
  return face_point(m, z, at2, out);
}

// The next node or end of side 0 behind `now` within its element, in the order of the zone.
double next_cut(const Model& m, const Zone& z, double eta) {
  const int f = m.head->function_nodes, step = z.element_step[0];
  double next = step;
  for (int l = 0; l < f; ++l) {
    const double node = node_eta(f, l);
    if (step * (node - eta) > kSnap && step * (node - next) < 0) next = node;
  }
  return next;
}

// Where between two points of an element of side 1 lies what a point of side 0 faces? (Not inlined: the search for the next
// target would stand on its frame.)
[[gnu::noinline]] double face_within(const PieceWalk& w, const FacePoint& at1) {
  const Model& m = *w.m;
  const Zone& z = *w.z;
  const Place p1 = place_at(m, z, 0, at1);
  const Search off = search_in(m, z, p1, 1, w.place2);
  return zero_between(w.eta2, w.target_eta2, off(w.eta2), off(w.target_eta2), off);
}

} // namespace

PieceWalk start_pieces(const Model& m, const Zone& z, int32_t place2) {
  PieceWalk walk{&m, &z, zone_element(m, z, 1, place2), place2, 1, {}, {}, 0, 0};
  own_cut(m, z, 0, &walk.eta2);
  if (!face_own_cut(m, z, FacePoint{walk.element2, place2, walk.eta2}, walk.now)) walk.stop = INT32_MAX - 1;
  walk.target = walk.now;
  walk.target_eta2 = walk.eta2;
  return walk;
}

bool next_piece(PieceWalk& w, FacingPiece& out) {
  const Model& m = *w.m;
  const Zone& z = *w.z;
  const int32_t count = zone_elements(z, 0);
  if (w.eta2 == w.target_eta2) { // on to the next node of its own
    if (!own_cut(m, z, w.stop, &w.target_eta2) || !face_own_cut(m, z, FacePoint{w.element2, w.place2, w.target_eta2}, w.target))
      return false;
    ++w.stop;
  }
  if (z.element_step[0] * w.now.eta >= 1 - kSnap) { // on to the next element of side 0
    w.now = point_at(m, z, 0, w.now.place + 1 < count ? w.now.place + 1 : 0, -z.element_step[0]);
  }
  double goal = position(z, w.target);
  if (goal < position(z, w.now) - 0.5 * count) goal += count; // round a ring
  FacePoint cut = w.now;
  cut.eta = next_cut(m, z, w.now.eta);
  const double beyond = position(z, cut) - goal;
  out.element1 = w.now.element;
  out.eta1[0] = w.now.eta;
  out.eta2[0] = w.eta2;
  if (beyond > kSnap)
    w.now.eta = w.target.eta;
  else
    w.now.eta = cut.eta;
  w.eta2 = beyond >= -kSnap ? w.target_eta2 : face_within(w, cut);
  out.eta1[1] = w.now.eta;
  out.eta2[1] = w.eta2;
  return true;
}

// ---- fitting
// ----------------------------------------------------------------------------------------------------

namespace {

enum class Cover { none, whole, averted };

// Does an element of side 1 face side 0 with all its nodes and both ends?
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

// Elements at the ends of what is kept that face side 0 in part: the contact ends short of side 0's elements there.
void warn_left_out(const Model& m, int32_t zone, int32_t first, int32_t count, Reporter& reporter) {
  constexpr double kPart = 1e-3; // of an element: less is rounding
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
         element + 1, " of body ", body_named(m, z.body[1]), " faces the elements of body ", body_named(m, z.body[0]),
         " in part only and is left out: nothing touches there");
  }
}

void keep_elements(const Model& m, Zone& z, int32_t first, int32_t count) {
  const int32_t f = m.head->function_nodes;
  z.first_element[1] = zone_element(m, z, 1, first);
  z.elements = count;
  z.node_step[1] = z.element_step[1];
  z.first_node[1] = functional_node(m, z.body[1], z.first_element[1], z.element_step[1] > 0 ? 0 : f - 1);
  z.pairs = f == 1 ? count : count * (f - 1) + (is_ring(m, z, 1) ? 0 : 1);
}

// Ends of side 0 that nothing faces, in the zone as it is kept. Every state's tractions ask for it.
void mark_unfaced_ends(const Model& m, int32_t zone) {
  const Zone& z = m.zone[zone];
  const int b = z.body[0], f = m.head->function_nodes;
  for (int32_t place = 0; place < zone_elements(z, 0); ++place) {
    ZonePlace found;
    const int32_t element = zone_element(m, z, 0, place);
    if (!find_contact_element(m, b, element, &found) || found.zone != zone || found.side != 0) continue;
    for (int l = 0; l < f; ++l) {
      FacePoint faced;
      uint8_t& code = m.end_code[b][element * f + l];
      const bool faces = facing_point(m, z, FacePoint{element, found.place, node_eta(f, l)}, faced);
      code = static_cast<uint8_t>(faces ? code & ~kFacesNothing : code | kFacesNothing);
    }
  }
}

} // namespace

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
      report_zone(reporter, m, zone, ": body ", one, " faces elements of body ", two,
                  " in several places, expected one run of elements");
      return false;
    }
    if (first < 0) first = place;
    ++count;
  }
  if (first < 0) {
    report_zone(reporter, m, zone, ": body ", two, " does not face body ", one,
                ", none of its elements does from end to end, expected ranges that face each other");
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
