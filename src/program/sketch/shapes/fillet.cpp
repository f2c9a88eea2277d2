#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

struct Meeting {
  double u, v;
  bool found;
};

// The intersection, nearest to the common corner, of `before` and `next` after both are offset to the left: a grid search, then
// Newton's method.
Meeting meet(const Shape& before, const Shape& next, double offset) {
  const auto place = [offset](const Shape& s, double u) { return s.at(u) + offset * turned_left(s.tangent(u)); };
  constexpr int n = 200;
  std::vector<Point> a, b;
  for (int i = 0; i <= n; ++i) {
    a.push_back(place(before, 1 - static_cast<double>(i) / n));
    b.push_back(place(next, static_cast<double>(i) / n));
  }
  Meeting out{1, 0, false};
  double best = HUGE_VAL;
  for (size_t i = 0; i <= n; ++i)
    for (size_t j = 0; j <= n; ++j)
      if (length(a[i] - b[j]) < best) {
        best = length(a[i] - b[j]);
        out.u = 1 - static_cast<double>(i) / n, out.v = static_cast<double>(j) / n;
      }
  for (int step = 0; step < 50; ++step) {
    const Point r = place(before, out.u) - place(next, out.v);
    const Point p = (1 - offset * before.curvature(out.u)) * before.local(out.u).d;
    const Point q = (1 - offset * next.curvature(out.v)) * next.local(out.v).d;
    const double det = cross(p, q);
    if (det == 0 || !std::isfinite(det)) return out;
    const double du = -cross(r, q) / det, dv = -cross(r, p) / det;
    out.u = std::clamp(out.u + du, 0.0, 1.0), out.v = std::clamp(out.v + dv, 0.0, 1.0);
    if (std::fabs(du) + std::fabs(dv) < 1e-15) break;
  }
  const double scale = std::fabs(offset) + length(before.local(0.5).d) + length(next.local(0.5).d);
  out.found = length(place(before, out.u) - place(next, out.v)) < 1e-9 * scale && out.u > 0 && out.v < 1;
  return out;
}

} // namespace

Curve fillet(Curve& before, Curve& next, const std::string& name, double radius, Place at) {
  const double turn = cross(before.shape->tangent(1), next.shape->tangent(0));
  if (std::fabs(turn) < 1e-6) throw Fault{at, "the two curves join smoothly, expected a corner for the fillet"};
  const double offset = turn > 0 ? radius : -radius;
  const Meeting m = meet(*before.shape, *next.shape, offset);
  if (!m.found) throw Fault{at, "a fillet of radius " + show(radius) + " does not fit between the two curves"};
  const Point first = before.shape->at(m.u), centre = first + offset * turned_left(before.shape->tangent(m.u));
  const Point last = next.shape->at(m.v);
  const Point p = first - centre, q = last - centre;
  const double degree = 180 / std::acos(-1.0);
  Curve out{name, arc(centre, radius, std::atan2(p.y, p.x) * degree, std::atan2(cross(p, q), dot(p, q)) * degree), at};
  before.shape = part(before.shape, 0, m.u);
  next.shape = part(next.shape, m.v, 1);
  return out;
}

Curve chamfer(Curve& before, Curve& next, const std::string& name, double cut, Place at) {
  const Measure a(before.shape), b(next.shape);
  if (cut >= a.length() || cut >= b.length())
    throw Fault{at, "a chamfer of " + show(cut) + " does not fit: the two curves have the lengths " + rounded(a.length()) +
                        " and " + rounded(b.length())};
  before.shape = part(before.shape, 0, a.u_at(a.length() - cut));
  next.shape = part(next.shape, b.u_at(cut), 1);
  return {name, line(before.shape->at(1), next.shape->at(0)), at};
}

} // namespace sketch
