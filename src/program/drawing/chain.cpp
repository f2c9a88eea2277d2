#include "program/drawing/chain.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {
namespace {

constexpr double kCorner = 40;        // degrees
constexpr double kArcStep = 52;       // degrees: meshes have seven elements to a circle at least
constexpr size_t kArcPoints = 5;      // with fewer an arc is a guess
constexpr size_t kStraightPoints = 4; // within a run that is not straight as a whole: three may be so by symmetry

double turn(Point a, Point b, Point c) {
  return std::fabs(std::atan2(sketch::cross(b - a, c - b), sketch::dot(b - a, c - b))) * 180 / kHalfTurn;
}

// Do points first to last lie on a line, one behind the other?
bool is_straight(const std::vector<Point>& p, size_t first, size_t last, double tolerance) {
  const Point d = p[last] - p[first];
  const double l = sketch::length(d);
  for (size_t i = first + 1; i < last; ++i) {
    if (std::fabs(sketch::cross(d, p[i] - p[first])) > tolerance * l) return false;
    if (sketch::dot(d, p[i] - p[i - 1]) <= 0) return false;
  }
  return l > 0;
}

bool circle_through(Point a, Point b, Point c, Point& centre) {
  const Point p = b - a, q = c - a;
  const double area = sketch::cross(p, q);
  if (std::fabs(area) <= 1e-9 * sketch::length(p) * sketch::length(q)) return false;
  centre = app::circle_centre(a, b, c);
  return true;
}

// An arc through all of the points, or through points of a whole circle.
bool is_arc(const std::vector<Point>& p, bool closed, double tolerance, Curve& out) {
  const size_t n = p.size();
  if (n < (closed ? kArcPoints : 3)) return false;
  Point centre;
  if (!circle_through(p[0], p[closed ? n / 3 : n / 2], p[closed ? 2 * n / 3 : n - 1], centre)) return false;
  const double radius = sketch::length(p[0] - centre);
  double sweep = 0;
  for (size_t i = 0; i < n; ++i) {
    if (std::fabs(sketch::length(p[i] - centre) - radius) > tolerance) return false;
    if (i + 1 == n && !closed) break;
    const Point a = p[i] - centre, b = p[(i + 1) % n] - centre;
    const double step = std::atan2(sketch::cross(a, b), sketch::dot(a, b)) * 180 / kHalfTurn;
    if (std::fabs(step) > kArcStep || (i > 0 && (step > 0) != (sweep > 0))) return false;
    sweep += step;
  }
  if (std::fabs(sweep) > 360 * (1 + 1e-6) || closed != (std::fabs(sweep) > 360 * (1 - 1e-6))) return false;
  const Point arm = p[0] - centre;
  out = circular(centre, radius, std::atan2(arm.y, arm.x) * 180 / kHalfTurn, sweep);
  move_ends(out, p.front(), p.back());
  out.guessed = n < kArcPoints;
  return true;
}

void add_smooth(std::vector<Curve>& out, std::vector<Point> p, double tolerance) {
  Curve arc;
  if (p.size() == 2 || is_straight(p, 0, p.size() - 1, tolerance))
    out.push_back(straight(p.front(), p.back()));
  else if (is_arc(p, false, tolerance, arc))
    out.push_back(arc);
  else
    out.push_back(smooth(std::move(p), false));
}

// A run without corners.
void add_run(std::vector<Curve>& out, const std::vector<Point>& p, double tolerance) {
  Curve arc;
  if (p.size() == 2 || is_straight(p, 0, p.size() - 1, tolerance) || is_arc(p, false, tolerance, arc))
    return add_smooth(out, p, tolerance);
  size_t done = 0; // the point up to which curves are there
  const auto part = [&](size_t first, size_t last) {
    return std::vector<Point>(p.begin() + static_cast<ptrdiff_t>(first), p.begin() + static_cast<ptrdiff_t>(last) + 1);
  };
  for (size_t i = 0; i + kStraightPoints <= p.size();) {
    size_t last = i + kStraightPoints - 1;
    if (!is_straight(p, i, last, tolerance)) {
      ++i;
      continue;
    }
    while (last + 1 < p.size() && is_straight(p, i, last + 1, tolerance)) ++last;
    if (i > done) add_smooth(out, part(done, i), tolerance);
    out.push_back(straight(p[i], p[last]));
    i = done = last;
  }
  if (done + 1 < p.size()) add_smooth(out, part(done, p.size() - 1), tolerance);
}

} // namespace

std::vector<Curve> curves_of(const std::vector<Point>& points, bool closed, double size) {
  const double tolerance = kRound * size;
  std::vector<Curve> out;
  std::vector<Point> p = points;
  const size_t n = p.size();
  if (n < 2) return out;
  if (Curve arc; is_arc(p, closed, tolerance, arc)) return {arc};
  if (closed) {
    const auto is_corner = [&](size_t i) { return turn(p[(i + n - 1) % n], p[i], p[(i + 1) % n]) > kCorner; };
    size_t corner = 0;
    while (corner < n && !is_corner(corner)) ++corner;
    if (corner == n) return {smooth(p, true)};
    std::rotate(p.begin(), p.begin() + static_cast<ptrdiff_t>(corner), p.end());
    p.push_back(p.front());
  }
  std::vector<Point> run{p[0]};
  for (size_t i = 1; i < p.size(); ++i) {
    run.push_back(p[i]);
    if (i + 1 < p.size() && turn(p[i - 1], p[i], p[i + 1]) <= kCorner) continue;
    add_run(out, run, tolerance);
    run.assign(1, p[i]);
  }
  return out;
}

} // namespace drawing
