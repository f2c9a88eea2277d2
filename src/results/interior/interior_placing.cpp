// Locates points: inside a body, on its boundary, or outside.
//
// A point is inside if the boundary winds around it once (holes run clockwise and contribute -1). Phases:
//   1. begin_placing: start values. look_from_afar: the middle points of all elements give an upper bound of the distance to
//   the
//      boundary; it costs little and spares most elements the next step.
//   2. look_at_element: the nearest point of each element that may undercut the bound (Newton iteration, model/element.cpp),
//   and
//      its share of the winding number. Without lines of symmetry the share is the crossing number of the chord with a ray
//      (point in polygon: Hormann and Agathos, Comput. Geom. 20, 2001). A curved element near the point may pass it on the
//      other side than its chord: then the exact angle minus that of the chord is added.
//   3. end_placing: points with winding number 1 become inside points with the displacement of the nearest boundary point.
// With lines of symmetry boundaries are open curves: crossing numbers are not closed, and angles over all images are added.
#include "results/interior/interior_placing.hpp"

#include "bie/body_force.hpp"
#include "bie/boundary_stress.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "results/interior/interior.hpp"
#include "solver/particular.hpp"

namespace c2d {

C2D_USES(BodyForcePart);

namespace {

constexpr double kOnBoundary = 1e-9; // of the length of the element: closer points are boundary points
constexpr double kNearNode = 0.1;    // of the shorter element at the node: within this distance a point is flagged
constexpr double kNearStep = 0.5;    // the same for constant elements, whose displacement itself jumps at element ends

// Visits the points without a place. Consecutive rows need no index list, which is the inner loop of large calls.
template <class Visit> void for_unplaced(const Points& points, Visit visit) {
  if (kSmallCode || !points.chosen) {
    double* row = points.out;
    for (int32_t i = 0; i < points.count; ++i, row += points.out_stride) {
      PointSearch& p = *reinterpret_cast<PointSearch*>(row);
      if (p.place == kUnplaced) visit(p);
    }
    return;
  }
  for (int32_t i = 0; i < points.count; ++i)
    if (points.place(i) == kUnplaced) visit(points.search(i));
}

double length_of(double x, double y) { return sqrt(x * x + y * y); }

void look_closely(const Integrator& in, int b, int32_t element, PointSearch& p) {
  const Nearest near = nearest_point(in.element, p.x, p.y);
  if (near.distance < p.distance) {
    p.distance = near.distance;
    p.element = element;
    p.eta = near.eta;
  }
  if (near.distance <= 2.0 * kOnBoundary * in.radius) p.place = place_of(b, C2D_POINT_BOUNDARY);
}

// Can the element, inside its circle of radius R about its middle, come closer than the best distance so far? Compared by
// squares, to avoid a square root per point and element; small code uses the shorter form.
bool may_be_nearest(const Integrator& in, const PointSearch& p) {
  const double x = p.x - in.element.c[0][0], y = p.y - in.element.c[0][1];
  if (kSmallCode) return length_of(x, y) - in.radius <= p.distance;
  const double reach = p.distance + in.radius;
  return x * x + y * y <= reach * reach;
}

void add_winding(const Integrator& in, int32_t lines, const Points& points, PointSearch& p) {
  for (int image = 0; image <= lines; ++image)
    if (is_image(lines, image)) p.windings += winding(in, points.seen(image, 0, p.x), points.seen(image, 1, p.y));
}

// Signed crossings of the chord from a to b (relative to P) with the ray from P along x: +1 upwards, -1 downwards. Over a
// closed boundary their sum is the winding number, like the sum of angles / (2 pi), without evaluating an arctangent.
double crossings(Complex a, Complex b) {
  const bool up = a.im <= 0.0;
  if (up == (b.im <= 0.0) || (a.re * b.im - a.im * b.re > 0.0) != up) return 0.0;
  return up ? 1.0 : -1.0;
}
double angle_of_chord(Complex a, Complex b) { return atan2(a.re * b.im - a.im * b.re, dot(a, b)) / (2.0 * kPi); }

// Adds the crossings of an element, corrected by the exact angle if a curved element is near. False: angles are needed.
bool add_crossings(const Integrator& in, int32_t lines, const Points& points) {
  if (kSmallCode || lines != 0) return false;
  const Element& e = in.element;
  const int last = e.nodes - 1;
  for_unplaced(points, [&](PointSearch& p) {
    const Complex a = {e.x[0] - p.x, e.y[0] - p.y}, b = {e.x[last] - p.x, e.y[last] - p.y};
    p.windings += crossings(a, b);
    const Complex middle = 0.5 * (a + b);
    if (!e.straight && dot(middle, middle) <= 4.0 * in.radius * in.radius)
      p.windings += winding(in, p.x, p.y) - angle_of_chord(a, b);
  });
  return true;
}

// Is the point close to a node, where the tractions of the discrete solution jump? Only the ends of the element with the
// nearest boundary point can be that close.
bool is_near_node(const Model& m, int b, const PointSearch& p) {
  const int32_t element = static_cast<int32_t>(p.element);
  const Element e = element_of(m, b, element);
  const double unit = m.head->length_unit;
  const int last = e.nodes - 1;
  const double first_distance = length_of(unit * p.x - e.x[0], unit * p.y - e.y[0]),
               last_distance = length_of(unit * p.x - e.x[last], unit * p.y - e.y[last]);
  const bool first = first_distance <= last_distance;
  const Element other = element_of(m, b, region_neighbour(m, b, element, first ? -1 : 1).element);
  const double length = 2.0 * (e.half_length < other.half_length ? e.half_length : other.half_length);
  return (first ? first_distance : last_distance) < (m.head->function_nodes == 1 ? kNearStep : kNearNode) * length;
}

void place_inside(const Session& session, int b, const PointSearch& p, PointSums& out) {
  const Model& m = session.model;
  const int32_t element = static_cast<int32_t>(p.element);
  const BoundaryState s = boundary_state(session, b, element, p.eta);
  double known[2] = {0.0, 0.0};
  if (has_body_force(m, b)) kBodyForcePart.interpolated_particular(session, b, element, p.eta, known);
  out = PointSums{};
  out.x = p.x;
  out.y = p.y;
  for (int c = 0; c < 2; ++c) out.reference[c] = (s.u[c] - known[c]) / m.head->length_unit;
  reference_motion(m, b, element, p.eta, p.x, p.y, out.reference);
  out.place = place_of(b, is_near_node(m, b, p) ? C2D_POINT_NEAR_NODE : C2D_POINT_INSIDE);
}

} // namespace

void begin_placing(const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    PointSearch& p = points.search(i);
    if (p.place != kUnplaced) continue;
    p = PointSearch{};
    p.x = points.x(i);
    p.y = points.y(i);
    p.distance = 1e300;
  }
}

// Squared distance to the middle of the element as an upper bound of the distance to the boundary.
void look_from_afar(const Element& e, const Points& points) {
  for_unplaced(points, [&](PointSearch& p) {
    const double x = p.x - e.c[0][0], y = p.y - e.c[0][1], square = x * x + y * y;
    if (square < p.distance) p.distance = square;
  });
}

// Increases the bound a little, so that in the next phase the middle point that set it also undercuts it.
void leave_afar(const Points& points) {
  for_unplaced(points, [](PointSearch& p) { p.distance = (1.0 + 1e-12) * sqrt(p.distance) + kRounding; });
}

// Updates nearest boundary point and winding number of the points without a place, for one element.
void look_at_element(const Integrator& in, int b, int32_t element, const Points& points) {
  for_unplaced(points, [&](PointSearch& p) {
    if (may_be_nearest(in, p)) look_closely(in, b, element, p);
  });
  if (add_crossings(in, points.lines(b), points)) return;
  for_unplaced(points, [&](PointSearch& p) { add_winding(in, points.lines(b), points, p); });
}

void place_by_element(const Session& session, int b, int32_t element, const Points& points) {
  Integrator in;
  make_integrator(session.model, b, element, Quadrature::accurate, Measure::section, in);
  look_at_element(in, b, element, points);
}

void reference_motion(const Model& m, int b, int32_t element, double eta, double x, double y, double u[2]) {
  if (!is_axisymmetric(m)) return;
  const Point q = element_point(element_of(m, b, element), eta);
  const double stretch = q.x > 0.0 ? u[0] / (q.x / m.head->length_unit) : 0.0;
  u[0] = stretch * x;
  u[1] -= 2.0 * stretch * (y - q.y / m.head->length_unit);
}

double chord_winding(const Chain& chain, bool by_angle, Complex at) {
  const Complex a = chain.from - at, b = chain.to - at;
  return by_angle ? angle_of_chord(a, b) : crossings(a, b);
}

void end_placing(const Session& session, int b, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    const PointSearch found = points.search(i);
    if (found.place == kUnplaced && found.windings > 0.5) place_inside(session, b, found, points.sums(i));
  }
}

} // namespace c2d
