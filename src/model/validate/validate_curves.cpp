// Given curves: do they fit the boundary points, and is every element in one curve at most?
#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

namespace {

constexpr double kOff = 1e-3; // of the element length: a point farther away does not lie on the curve

// Distance of (x, y) from an arc, or from the line through both ends of its range.
double distance_off(const Curve& c, const double from[2], const double to[2], double x, double y) {
  if (c.kind == C2D_CURVE_ARC)
    return fabs(sqrt((x - c.centre[0]) * (x - c.centre[0]) + (y - c.centre[1]) * (y - c.centre[1])) - c.radius);
  const double dx = to[0] - from[0], dy = to[1] - from[1], size = sqrt(dx * dx + dy * dy);
  x -= from[0], y -= from[1];
  return size > 0 ? fabs(dx * y - dy * x) / size : sqrt(x * x + y * y);
}

void check_points(const Model& m, int32_t curve, Reporter& reporter) {
  const Curve& c = m.curve[curve];
  const int b = c.body, last = body_of(m, b).element_nodes - 1;
  const double* const from = m.xy[b] + 2 * geometry_node(m, b, c.first, 0);
  const double* const to = m.xy[b] + 2 * geometry_node(m, b, c.last, last);
  for (int32_t e = c.first; e <= c.last; ++e) {
    double x[kElementNodes], y[kElementNodes];
    element_coordinates(m, b, e, x, y);
    const double most = kOff * element_length(m, b, e);
    for (int k = 0; k <= last; ++k) {
      const double off = distance_off(c, from, to, x[k], y[k]);
      if (off <= most) continue;
      Where where = at_point(m, b, geometry_node(m, b, e, k));
      where.element = e + 1;
      if (c.line > 0) where.line = c.line;
      return report(reporter, where, c.kind == C2D_CURVE_ARC ? "arc" : "line", " of elements ", c.first + 1, " to ", c.last + 1,
                    " of body ", body_named(m, b), ": point ", geometry_node(m, b, e, k) + 1, " is ", off,
                    " away from it, expected at most ",
                    most); // one message per curve
    }
  }
}

void check_ranges(const Model& m, int32_t curve, Reporter& reporter) {
  const Curve& c = m.curve[curve];
  for (int32_t i = 0; i < curve; ++i) {
    const Curve& other = m.curve[i];
    const int32_t first = other.first > c.first ? other.first : c.first;
    if (other.body != c.body || first > other.last || first > c.last) continue;
    Where where = at_element(m, c.body, first);
    if (c.line > 0) where.line = c.line;
    report(reporter, where, "element ", first + 1, " of body ", body_named(m, c.body), " is in curves ", i + 1, " and ",
           curve + 1, ", expected it in one curve only");
  }
}

} // namespace

bool validate_curves(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int32_t i = 0; i < m.head->curves; ++i) {
    if (m.curve[i].kind != C2D_CURVE_SPLINE) check_points(m, i, reporter);
    check_ranges(m, i, reporter);
  }
  return reporter.faults == before;
}

} // namespace c2d
