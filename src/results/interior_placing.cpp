#include "results/interior_placing.hpp"

#include <math.h>

#include "bie/body_force.hpp"
#include "bie/boundary_stress.hpp"
#include "bie/kernels.hpp"
#include "memory/parts.hpp"
#include "results/interior.hpp"
#include "solver/particular.hpp"

namespace c2d {

C2D_USES(BodyForcePart);

namespace {

constexpr double kOnBoundary = 1e-9; // of the element's length
constexpr double kNearNode = 0.1;    // of the shorter element that meets there
constexpr double kNearStep = 0.5;    // the same where displacement itself is in steps, constant elements

double length_of(double x, double y) { return sqrt(x * x + y * y); }

// Where a point is that is not yet placed: p.u, as long as there are no sums.
void look_closely(const Integrator& in, int b, int32_t element, PointState& p) {
  const Nearest near = nearest_point(in.element, p.u[0], p.u[1]);
  if (near.distance < p.distance) {
    p.distance = near.distance;
    p.element = element;
    p.eta = near.eta;
  }
  if (near.distance <= 2.0 * kOnBoundary * in.radius) p.place = place_of(b, C2D_POINT_BOUNDARY);
}

bool may_be_nearest(const Integrator& in, const PointState& p) {
  const double x = p.u[0] - in.element.c[0][0], y = p.u[1] - in.element.c[0][1];
  if (kSmallCode) return length_of(x, y) - in.radius <= p.distance;
  const double reach = p.distance + in.radius;
  return x * x + y * y <= reach * reach;
}

void add_winding(const Integrator& in, const Points& points, PointState& p) {
  for (int image = 0; image <= points.head->symmetry && p.place == kUnplaced; ++image)
    if (is_image(*points.head, image))
      p.reference[0] += winding(in, points.seen(image, 0, p.u[0]), points.seen(image, 1, p.u[1]));
}

// How often the chord crosses the ray from P along x, upwards less downwards: over a closed boundary that is the winding
// number as well. Curves near P may pass it on the other side than their chords.
bool add_crossings(const Integrator& in, const Points& points) {
  if (kSmallCode || points.head->symmetry != 0 || in.degenerate) return false;
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double x0 = e.x[0], y0 = e.y[0], x1 = e.x[last], y1 = e.y[last];
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    const double y = p.u[1];
    if (p.place != kUnplaced) continue;
    const bool crosses = (y0 <= y) != (y1 <= y);
    if (!crosses && e.straight) continue;
    const double ax = x0 - p.u[0], ay = y0 - y, bx = x1 - p.u[0], by = y1 - y, side = ax * by - ay * bx;
    if (crosses && (side > 0.0) == (y0 <= y)) p.reference[0] += y0 <= y ? 1.0 : -1.0;
    const double mx = 0.5 * (ax + bx), my = 0.5 * (ay + by);
    if (!e.straight && mx * mx + my * my <= 4.0 * in.radius * in.radius)
      p.reference[0] += winding(in, p.u[0], y) - atan2(side, ax * bx + ay * by) / (2.0 * kPi);
  }
  return true;
}

// Of the ends of the element with the nearest boundary point.
bool is_near_node(const Model& m, int b, const PointState& p, double x, double y) {
  const int32_t element = static_cast<int32_t>(p.element);
  const Element e = element_of(m, b, element);
  const double unit = m.head->length_unit;
  const int last = e.nodes - 1;
  const double first_distance = length_of(unit * x - e.x[0], unit * y - e.y[0]),
               last_distance = length_of(unit * x - e.x[last], unit * y - e.y[last]);
  const bool first = first_distance <= last_distance;
  const Element other = element_of(m, b, region_neighbour(m, b, element, first ? -1 : 1).element);
  const double length = 2.0 * (e.half_length < other.half_length ? e.half_length : other.half_length);
  return (first ? first_distance : last_distance) < (m.head->function_nodes == 1 ? kNearStep : kNearNode) * length;
}

void place_inside(const Session& session, int b, double x, double y, PointState& p) {
  const Model& m = session.model;
  const int32_t element = static_cast<int32_t>(p.element);
  const double unit = m.head->length_unit, eta = p.eta;
  const BoundaryState s = boundary_state(session, b, element, eta);
  double known[2] = {0.0, 0.0};
  if (has_body_force(m, b)) kBodyForcePart.interpolated_particular(session, b, element, eta, known);
  for (int c = 0; c < 2; ++c) p.reference[c] = (s.u[c] - known[c]) / unit;
  p.place = place_of(b, C2D_POINT_INSIDE);
  if (is_near_node(m, b, p, x, y)) p.place = place_of(b, C2D_POINT_NEAR_NODE);
  p.eta = x;
  p.distance = y;
}

} // namespace

void begin_placing(const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place != kUnplaced) continue;
    p = PointState{};
    p.u[0] = points.x(i);
    p.u[1] = points.y(i);
    p.distance = 1e300;
  }
}

// A point of the element as an upper bound of the distance from the boundary, squared: most elements need no closer
// look then.
void look_from_afar(const Element& e, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place != kUnplaced) continue;
    const double x = p.u[0] - e.c[0][0], y = p.u[1] - e.c[0][1], square = x * x + y * y;
    if (square < p.distance) p.distance = square;
  }
}

// The bound must be undercut, also by a point to which it belongs.
constexpr double kRounding = 1e-14; // of the coordinates, in the length unit
void leave_afar(const Points& points) {
  for (int32_t i = 0; i < points.count; ++i)
    if (points.state(i).place == kUnplaced)
      points.state(i).distance = (1.0 + 1e-12) * sqrt(points.state(i).distance) + kRounding;
}

// Nearest boundary point and winding number of the points not yet placed, from one element.
void look_at_element(const Integrator& in, int b, int32_t element, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place == kUnplaced && may_be_nearest(in, p)) look_closely(in, b, element, p);
  }
  if (add_crossings(in, points)) return;
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place == kUnplaced) add_winding(in, points, p);
  }
}

void end_placing(const Session& session, int b, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    PointState& p = points.state(i);
    if (p.place != kUnplaced) continue;
    const double x = p.u[0], y = p.u[1];
    p.u[0] = p.u[1] = 0.0;
    if (p.reference[0] > 0.5) place_inside(session, b, x, y, p);
  }
}

} // namespace c2d
