#include "program/drawing/placing.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {
namespace {

double degrees(Point p) { return std::atan2(p.y, p.x) * 180 / kHalfTurn; }

Point turned(const Motion& m, Point d) { return m(d) - m({}); }

// The axes of an ellipse from two conjugate half diameters, p cos t + q sin t.
void place_ellipse(Curve& c, const Motion& motion) {
  const double tilt = c.tilt * kHalfTurn / 180;
  Point p = turned(motion, {c.a * std::cos(tilt), c.a * std::sin(tilt)});
  Point q = turned(motion, {-c.b * std::sin(tilt), c.b * std::cos(tilt)});
  const double pp = sketch::dot(p, p), qq = sketch::dot(q, q), pq = sketch::dot(p, q), round = 1e-12 * (pp + qq);
  const bool is_upright = std::fabs(pq) <= round; // p and q are the axes
  const double turn = is_upright ? 0 : 0.5 * std::atan2(2 * pq, pp - qq);
  const Point a = std::cos(turn) * p + std::sin(turn) * q, b = std::cos(turn) * q - std::sin(turn) * p;
  const double side = sketch::cross(a, b) < 0 ? -1 : 1;
  c.centre = motion(c.centre);
  c.a = sketch::length(a), c.b = sketch::length(b);
  c.from = side * (c.from - turn * 180 / kHalfTurn);
  if (!c.whole) c.sweep *= side;
  c.tilt = degrees(a);
  c.kind = std::fabs(c.a - c.b) <= 1e-9 * c.a ? Curve::kArc : Curve::kEllipse;
  if (c.kind == Curve::kArc) c.b = c.a, c.from += c.tilt, c.tilt = 0; // an arc has no axis
}

} // namespace

Motion placing(Point base, Point at, double scale_x, double scale_y, double angle) {
  const double t = angle * kHalfTurn / 180, c = std::cos(t), s = std::sin(t);
  const Motion turn{c * scale_x, -s * scale_y, s * scale_x, c * scale_y, 0, 0};
  const Point moved = at - turn(base);
  return {turn.a, turn.b, turn.c, turn.d, moved.x, moved.y};
}

Motion after(const Motion& second, const Motion& first) {
  const Point origin = second(first({}));
  return {second.a * first.a + second.b * first.c,
          second.a * first.b + second.b * first.d,
          second.c * first.a + second.d * first.c,
          second.c * first.b + second.d * first.d,
          origin.x,
          origin.y};
}

Curve placed(Curve c, const Motion& motion) {
  if (c.kind == Curve::kArc || c.kind == Curve::kEllipse) place_ellipse(c, motion);
  c.begin = motion(c.begin), c.end = motion(c.end);
  for (Point& p : c.points) p = motion(p);
  c.doubt *= std::max(sketch::length(turned(motion, {1, 0})), sketch::length(turned(motion, {0, 1})));
  return c;
}

} // namespace drawing
