// Points and vectors of the plane.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace app {

struct Point {
  double x = 0, y = 0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double f, Point a) { return {f * a.x, f * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Point turned_left(Point a) { return {-a.y, a.x}; }
inline double length(Point a) { return std::hypot(a.x, a.y); }
inline double distance(Point a, Point b) { return length(b - a); }
// Width and height of the box around points, at least one.
inline Point extent_of(const std::vector<Point>& points) {
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return high - low;
}
// Of the circle through the points, which do not lie on a line.
inline Point circle_centre(Point a, Point b, Point c) {
  const Point p = b - a, q = c - a;
  const double pp = dot(p, p), qq = dot(q, q);
  return a + (1 / (2 * cross(p, q))) * Point{pp * q.y - qq * p.y, qq * p.x - pp * q.x};
}

} // namespace app
