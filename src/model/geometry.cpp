// Plane geometry of boundary elements and regions: points, lengths, areas, intersections, winding numbers.
//
// Curved elements are approximated by kChords chords for lengths, distances, intersections and winding numbers; positions,
// normals and areas use the polynomials. Predicates (side of a line, crossing of chords) carry a tolerance of the rounding of
// the coordinates, so that touching boundaries are recognised whatever the last digits of the input.
#include "model/geometry.hpp"
#include "memory/math.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

// Local coordinate at which chord i of an element begins.
double chord_eta(int i, int chords) { return -1 + 2.0 * i / chords; }

// Position of curve_point() without the derivative, with identical bits: lengths and chords must agree with it.
void curve_position(int nodes, const double* x, const double* y, double eta, double out[2]) {
  double part[kElementNodes];
  shape(nodes, eta, part);
  out[0] = out[1] = 0;
  for (int i = 0; i < nodes; ++i) out[0] += part[i] * x[i], out[1] += part[i] * y[i];
}

} // namespace

CurvePoint curve_point(int nodes, const double* x, const double* y, double eta) {
  CurvePoint p = {0, 0, 0, 0};
  double part[kElementNodes]; // shared by values and derivatives, to save stack in deep searches for facing points
  shape(nodes, eta, part);
  for (int i = 0; i < nodes; ++i) p.x += part[i] * x[i], p.y += part[i] * y[i];
  shape_derivative(nodes, eta, part);
  for (int i = 0; i < nodes; ++i) p.dx += part[i] * x[i], p.dy += part[i] * y[i];
  return p;
}

CurvePoint curve_point(const Model& m, int b, int32_t element, double eta) {
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  return curve_point(body_of(m, b).element_nodes, x, y, eta);
}

Element element_of(const Model& m, int b, int32_t element) {
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  return make_element(body_of(m, b).element_nodes, x, y);
}

void outward_normal(const Model& m, int b, int32_t element, double eta, double n[2]) {
  const CurvePoint p = curve_point(m, b, element, eta);
  const double size = sqrt(p.dx * p.dx + p.dy * p.dy);
  n[0] = size > 0 ? p.dy / size : 0;
  n[1] = size > 0 ? -p.dx / size : 0;
}

// Length as the sum of the chords. It serves as a scale for tolerances and for warnings; integrals use the Jacobian.
double element_length(const Model& m, int b, int32_t element) {
  const int nodes = body_of(m, b).element_nodes, chords = nodes == 2 ? 1 : kChords;
  double x[kElementNodes], y[kElementNodes], sum = 0;
  element_coordinates(m, b, element, x, y);
  double from[2] = {x[0], y[0]};
  for (int i = 1; i < chords; ++i) {
    double p[2];
    curve_position(nodes, x, y, chord_eta(i, chords), p);
    const double dx = p[0] - from[0], dy = p[1] - from[1];
    sum += sqrt(dx * dx + dy * dy);
    from[0] = p[0], from[1] = p[1];
  }
  const double dx = x[nodes - 1] - from[0], dy = y[nodes - 1] - from[1];
  sum += sqrt(dx * dx + dy * dy);
  return sum;
}

int closing_way(const Model& m, int b, int32_t region, double x[3], double y[3]) {
  const Region& r = m.region[b][region];
  if (!r.open) return 0;
  const double* end = m.xy[b] + 2 * geometry_node(m, b, r.last, body_of(m, b).element_nodes - 1);
  const double* start = m.xy[b] + 2 * geometry_node(m, b, r.first, 0);
  const ModelHeader& head = *m.head;
  int count = 0;
  x[count] = end[0], y[count++] = end[1];
  if ((lines_through(head, end[0], end[1]) & lines_through(head, start[0], start[1])) == 0 && head.symmetry == 3)
    x[count] = head.line_at[0], y[count++] = head.line_at[1];
  x[count] = start[0], y[count++] = start[1];
  return count;
}

double region_area(const Model& m, int b, int32_t region) {
  // Half the integral of x dy - y dx; three Gauss points are exact up to the fifth degree, that of cubic elements.
  constexpr double kPoint[3] = {-0.77459666924148338, 0, 0.77459666924148338};
  constexpr double kWeight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  const Region& r = m.region[b][region];
  // Relative to a point of the curve: with the global origin far away, large terms would cancel.
  const CurvePoint origin = curve_point(m, b, r.first, -1);
  double sum = 0;
  for (int32_t e = r.first; e <= r.last; ++e) {
    for (int i = 0; i < 3; ++i) {
      const CurvePoint p = curve_point(m, b, e, kPoint[i]);
      sum += 0.5 * kWeight[i] * ((p.x - origin.x) * p.dy - (p.y - origin.y) * p.dx);
    }
  }
  double x[3], y[3];
  const int corners = closing_way(m, b, region, x, y);
  for (int i = 0; i + 1 < corners; ++i)
    sum += 0.5 * ((x[i] - origin.x) * (y[i + 1] - y[i]) - (y[i] - origin.y) * (x[i + 1] - x[i]));
  return sum;
}

void chords_of(const Model& m, int b, int32_t element, Chords& out) {
  const int nodes = body_of(m, b).element_nodes;
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  out.count = nodes == 2 ? 1 : kChords;
  for (int i = 0; i <= out.count; ++i) {
    double p[2];
    curve_position(nodes, x, y, chord_eta(i, out.count), p);
    out.x[i] = p[0];
    out.y[i] = p[1];
  }
  // Ends exactly at the boundary points, so that neighbours meet without round-off.
  out.x[0] = x[0], out.y[0] = y[0];
  out.x[out.count] = x[nodes - 1], out.y[out.count] = y[nodes - 1];
}

namespace {
void include(Box& box, double x, double y) {
  box.x_min = fmin(box.x_min, x);
  box.x_max = fmax(box.x_max, x);
  box.y_min = fmin(box.y_min, y);
  box.y_max = fmax(box.y_max, y);
}
} // namespace

Box box_around(const Model& m, int b, int32_t element) {
  const int nodes = body_of(m, b).element_nodes;
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  Box box = {x[0], x[0], y[0], y[0]};
  for (int i = 1; i < nodes; ++i) include(box, x[i], y[i]);
  if (nodes == 2) return box;
  // The sum of the magnitudes of the Lagrange functions (the Lebesgue constant) is 1.25 for quadratic and 1.64 for cubic
  // elements with equally spaced nodes. The curve leaves the box of its nodes by at most half of the excess over 1.
  const double dx = 0.33 * (box.x_max - box.x_min), dy = 0.33 * (box.y_max - box.y_min);
  return Box{box.x_min - dx, box.x_max + dx, box.y_min - dy, box.y_max + dy};
}

Box box_of_body(const Model& m, int b) {
  const double* xy = m.xy[b];
  Box box = {xy[0], xy[0], xy[1], xy[1]};
  for (int32_t i = 1; i < body_of(m, b).geometry_nodes; ++i) include(box, xy[2 * i], xy[2 * i + 1]);
  return box;
}

double coincidence_of(const Model& m, int b) {
  const Box box = box_of_body(m, b);
  const double size = fmax(box.x_max - box.x_min, box.y_max - box.y_min);
  const double most = fmax(fmax(fabs(box.x_min), fabs(box.x_max)), fmax(fabs(box.y_min), fabs(box.y_max)));
  return kCoincident * size + 1e-15 * most;
}

bool boxes_meet(const Box& a, const Box& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

namespace {

// Orientation test: 1: c lies to the left of the line from a to b, -1: to the right, 0: on it.
int side(const double a[2], const double b[2], const double c[2]) {
  const double turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return (turn > 0) - (turn < 0);
}

// Tolerance of the orientation test: points on a common line differ from it by the rounding of their coordinates.
double rounding_of(const double a[2], const double b[2], const double c[2]) {
  double most = 0;
  for (int i = 0; i < 2; ++i) most = fmax(most, fmax(fabs(a[i]), fmax(fabs(b[i]), fabs(c[i]))));
  return 4e-15 * most;
}

// Orientation with this tolerance; *touches: c lies on the chord between a and b, ends included.
int side_of_chord(const double a[2], const double b[2], const double c[2], bool* touches) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], length = sqrt(dx * dx + dy * dy);
  const double breadth = rounding_of(a, b, c);
  const double turn = dx * (c[1] - a[1]) - dy * (c[0] - a[0]), along = dx * (c[0] - a[0]) + dy * (c[1] - a[1]);
  if (fabs(turn) > breadth * length) return turn > 0 ? 1 : -1;
  if (along >= -breadth * length && along <= (length + breadth) * length) *touches = true;
  return 0;
}

} // namespace

bool chords_cross(const double p0[2], const double p1[2], const double q0[2], const double q1[2]) {
  bool touches = false;
  const int a = side_of_chord(q0, q1, p0, &touches), b = side_of_chord(q0, q1, p1, &touches),
            c = side_of_chord(p0, p1, q0, &touches), d = side_of_chord(p0, p1, q1, &touches);
  return touches || (a * b < 0 && c * d < 0);
}

double distance_to_element(const Model& m, int b, int32_t element, double x, double y) {
  Chords c;
  chords_of(m, b, element, c);
  double nearest = -1;
  for (int i = 0; i < c.count; ++i) {
    const double ex = c.x[i + 1] - c.x[i], ey = c.y[i + 1] - c.y[i], size = ex * ex + ey * ey;
    double place = size > 0 ? ((x - c.x[i]) * ex + (y - c.y[i]) * ey) / size : 0;
    place = place < 0 ? 0 : place > 1 ? 1 : place;
    const double dx = x - c.x[i] - place * ex, dy = y - c.y[i] - place * ey;
    const double distance = sqrt(dx * dx + dy * dy);
    if (nearest < 0 || distance < nearest) nearest = distance;
  }
  return nearest;
}

namespace {

// Signed crossing of a chord with the horizontal ray to the right of the point: upwards 1, downwards -1. The half-open
// comparison counts a vertex on the ray once (Hormann and Agathos, Comput. Geom. 20, 2001).
int passes(const double p[2], const double q[2], const double point[2]) {
  if (p[1] <= point[1] && q[1] > point[1] && side(p, q, point) > 0) return 1;
  return p[1] > point[1] && q[1] <= point[1] && side(p, q, point) < 0 ? -1 : 0;
}

} // namespace

int winding_number(const Model& m, int b, int32_t region, double x, double y) {
  const double point[2] = {x, y};
  const Region& r = m.region[b][region];
  int number = 0;
  Chords c;
  for (int32_t e = r.first; e <= r.last; ++e) {
    chords_of(m, b, e, c);
    for (int i = 0; i < c.count; ++i) {
      const double p[2] = {c.x[i], c.y[i]}, q[2] = {c.x[i + 1], c.y[i + 1]};
      number += passes(p, q, point);
    }
  }
  double wx[3], wy[3];
  const int corners = closing_way(m, b, region, wx, wy);
  for (int i = 0; i + 1 < corners; ++i) {
    const double p[2] = {wx[i], wy[i]}, q[2] = {wx[i + 1], wy[i + 1]};
    number += passes(p, q, point);
  }
  return number;
}

namespace {

// The next (step 1) or previous (-1) element of the region; -1 at the end of an open region.
int32_t next_in_region(const Model& m, int b, int32_t element, int32_t step) {
  const Region& r = m.region[b][region_of_element(m, b, element)];
  const int32_t next = element + step;
  if (next >= r.first && next <= r.last) return next;
  return r.open != 0 ? -1 : step > 0 ? r.first : r.last;
}

struct Turn {
  double angle, length; // signed angle between two elements in radians; sum of their lengths
};

Turn turn_at(const Model& m, int b, int32_t before, int32_t after) {
  if (before < 0 || after < 0) return Turn{0.0, 0.0};
  double n1[2], n2[2];
  outward_normal(m, b, before, 1, n1);
  outward_normal(m, b, after, -1, n2);
  return Turn{atan2(n1[0] * n2[1] - n1[1] * n2[0], n1[0] * n2[0] + n1[1] * n2[1]),
              element_length(m, b, before) + element_length(m, b, after)};
}

bool is_corner(const Turn& turn) { return fabs(turn.angle) > 0.66; } // 38 degrees

// Do two turns belong to one arc? Angle over length is its curvature; a factor of 1.5 allows for unequal division of the arc.
bool turn_alike(const Turn& a, const Turn& b) {
  const double one = a.angle * b.length, other = b.angle * a.length;
  return !is_corner(b) && one * other > 0.0 && fabs(one) < 1.5 * fabs(other) && fabs(other) < 1.5 * fabs(one);
}

} // namespace

bool is_joint_of_arc(const Model& m, int b, int32_t before, int32_t after) {
  const Turn here = turn_at(m, b, before, after);
  if (is_corner(here)) return false;
  return turn_alike(here, turn_at(m, b, next_in_region(m, b, before, -1), before)) ||
         turn_alike(here, turn_at(m, b, after, next_in_region(m, b, after, 1)));
}

double angle_between(const double a[2], const double b[2]) {
  return fabs(atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
}

} // namespace c2d
