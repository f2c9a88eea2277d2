// Positions of the new boundary points of bisected elements. Phases: place the points on a given curve, on a circle through
// adjacent points, on the surface of METHOD 8.1, or on the element; match both sides of matching zones (match_points.cpp).
#include "program/estimate/mesh/cut_body.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kCorner = 0.66; // angle between chords, in radians, of a corner of the body, METHOD 8.1
// Times a chord: points this close to a circle lie on it, as with the seven digits of the fixed form.
constexpr double kOnCircle = 1e-6;
constexpr double kStraight = 1e-9; // angle between chords, in radians, that counts as zero

struct Circle {
  Point centre;
  double radius; // 0: none
};

double turn(Point a, Point b, Point c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
}

Circle circle_through(Point a, Point b, Point c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y, cross = 2 * (ux * vy - uy * vx);
  if (cross == 0) return {a, 0};
  const double u = ux * ux + uy * uy, v = vx * vx + vy * vy;
  const Point from{(vy * u - uy * v) / cross, (ux * v - vx * u) / cross};
  return {{a.x + from.x, a.y + from.y}, std::hypot(from.x, from.y)};
}

Point moved_to(const Circle& circle, Point p) {
  const double from = distance(circle.centre, p);
  if (from == 0) return p;
  const double part = circle.radius / from;
  return {circle.centre.x + part * (p.x - circle.centre.x), circle.centre.y + part * (p.y - circle.centre.y)};
}

// The circle through four successive boundary points without a corner; radius 0: they do not lie on one.
Circle circle_of(const Point p[4]) {
  const double one = turn(p[0], p[1], p[2]), other = turn(p[1], p[2], p[3]);
  const double longest = std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[3])});
  if (one * other <= 0 || std::min(std::fabs(one), std::fabs(other)) < kStraight) return {p[0], 0};
  if (std::max(std::fabs(one), std::fabs(other)) > kCorner) return {p[0], 0};
  const Circle through = circle_through(p[0], p[1], p[3]);
  const bool fits = std::fabs(distance(through.centre, p[2]) - through.radius) <= kOnCircle * longest;
  return {through.centre, fits ? through.radius : 0};
}

// The boundary points of a region in order, and the given curve of each chord between two of them.
struct Row {
  std::vector<Point> points;
  std::vector<int32_t> curve; // of the chord that starts at a point
  bool open;
  // This number of points from `first` on, if they exist and share one curve or have none.
  bool take(int32_t first, int32_t wanted, Point* out) const {
    const int32_t count = static_cast<int32_t>(points.size()), chords = static_cast<int32_t>(curve.size());
    int32_t same = 0;
    for (int32_t i = 0; i < wanted; ++i) {
      int32_t at = first + i;
      if (open && (at < 0 || at >= count)) return false;
      at = (at % count + count) % count;
      out[i] = points[CutBody::at(at)];
      if (i == wanted - 1) break;
      if (at >= chords) return false;
      if (i > 0 && curve[CutBody::at(at)] != same) return false;
      same = curve[CutBody::at(at)];
    }
    return true;
  }
};

Row row_of(const CutBody& body, int32_t region) {
  const CutRegion& own = body.regions[CutBody::at(region)];
  Row row{{}, {}, own.open};
  for (int32_t e = own.first; e <= own.last; ++e) {
    const std::vector<Point> p = body.points_of(region, e);
    for (size_t k = 0; k + 1 < p.size(); ++k) {
      row.points.push_back(p[k]);
      row.curve.push_back(body.curve[CutBody::at(e)]);
    }
    if (own.open && e == own.last) row.points.push_back(p.back());
  }
  return row;
}

// Evidence of a fifth point next to four points on a circle.
enum class Beside { nothing, fits, is_straight, turns_more };
// The last point is tested with its two neighbours; `own`: the angle between chords of the four points.
Beside beside(const Circle& circle, const Point p[3], double own) {
  const double angle = turn(p[0], p[1], p[2]);
  if (std::fabs(angle) < kStraight) return Beside::is_straight;
  if (std::fabs(angle) > kCorner || angle * own <= 0) return Beside::nothing; // the curve ends there
  if (std::fabs(distance(circle.centre, p[2]) - circle.radius) <= kOnCircle * distance(p[1], p[2])) return Beside::fits;
  return std::fabs(angle) > (1 + kOnCircle) * std::fabs(own) ? Beside::turns_more : Beside::nothing;
}

// A flat between two arcs also fits a circle if adjacent chords have equal lengths and angles. So a chord without a turn
// belongs to no arc, nor do chords that turn less than their neighbours.
bool is_arc(const Row& row, int32_t first, const Point p[4], const Circle& circle) {
  Point five[5];
  Beside before = Beside::nothing, after = Beside::nothing;
  if (row.take(first - 1, 5, five)) {
    const Point back[3] = {p[1], p[0], five[0]};
    before = beside(circle, back, -turn(p[0], p[1], p[2]));
  }
  if (row.take(first, 5, five)) after = beside(circle, five + 2, turn(p[1], p[2], p[3]));
  if (before == Beside::is_straight || after == Beside::is_straight) return false;
  if (before == Beside::fits || after == Beside::fits) return true;
  return before != Beside::turns_more && after != Beside::turns_more;
}

// The circle of an element with this number of chords, confirmed by at least one adjacent point; `chord` is its first.
Circle circle_around(const Row& row, int32_t chord, int32_t chords) {
  for (const int32_t before : {1, 0, 2}) {
    Point p[4];
    if (before + chords > 3 || !row.take(chord - before, 4, p)) continue;
    if (const Circle found = circle_of(p); found.radius > 0 && is_arc(row, chord - before, p, found)) return found;
  }
  return {{0, 0}, 0};
}

// The polynomial through equally spaced points, eta from -1 to 1.
Point on_element(const std::vector<Point>& p, double eta) {
  const size_t n = p.size();
  Point out{0, 0};
  for (size_t i = 0; i < n; ++i) {
    double shape = 1;
    const double own = -1 + 2.0 * static_cast<double>(i) / static_cast<double>(n - 1);
    for (size_t k = 0; k < n; ++k)
      if (k != i) {
        const double other = -1 + 2.0 * static_cast<double>(k) / static_cast<double>(n - 1);
        shape *= (eta - other) / (own - other);
      }
    out = {out.x + shape * p[i].x, out.y + shape * p[i].y};
  }
  return out;
}

struct NewPoint {
  Point at;
  bool sure;
};
// The new point between point i and the next one of an element; `chord` is the first chord of the element.
NewPoint new_point(const CutBody& body, const Row& row, int32_t element, int32_t chord, const c2d_curve* given,
                   const std::vector<Point>& p, int32_t i) {
  const int32_t chords = body.element_nodes - 1;
  const Point a = p[CutBody::at(i)], b = p[CutBody::at(i + 1)], middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  if (given != nullptr && given->kind == C2D_CURVE_ARC)
    return {moved_to({{given->centre[0], given->centre[1]}, given->radius}, middle), true};
  const Point own = chords == 1 ? middle : on_element(p, -1 + (2.0 * i + 1) / chords);
  if (given != nullptr && given->kind == C2D_CURVE_LINE) return {own, true};
  if (const Circle circle = circle_around(row, chord, chords); circle.radius > 0) return {moved_to(circle, middle), true};
  const bool smooth = chords == 1 && (given != nullptr || body.in_contact[CutBody::at(element)]);
  return {smooth ? body.surface[CutBody::at(element)] : own, false};
}

} // namespace

CutPoints cut_points(const CutBody& body, const std::vector<c2d_curve>& curves) {
  CutPoints out;
  const auto add = [&](const NewPoint& p) { out.points.push_back(p.at), out.sure.push_back(p.sure); };
  const int32_t chords = body.element_nodes - 1;
  for (int32_t r = 0; r < static_cast<int32_t>(body.regions.size()); ++r) {
    const CutRegion& region = body.regions[CutBody::at(r)];
    const Row row = row_of(body, r);
    for (int32_t e = region.first; e <= region.last; ++e) {
      const std::vector<Point> p = body.points_of(r, e);
      const int32_t given = body.curve[CutBody::at(e)];
      const c2d_curve* const curve = given < 0 ? nullptr : &curves[CutBody::at(given)];
      for (int32_t i = 0; i < chords; ++i) {
        add({p[CutBody::at(i)], true});
        if (body.child_count(e) == 1) continue;
        add(new_point(body, row, e, (e - region.first) * chords, curve, p, i));
      }
    }
    if (region.open) add({row.points.back(), true});
  }
  return out;
}

} // namespace estimate
