#include "program/sketch/shapes/region.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kNearBoundary = 0.01; // of the size: nearer to the boundary, the polygon is too coarse for the inside test

// The polygon of an outline. An open outline is closed along the lines of symmetry, through their intersection if it needs
// both.
std::vector<Point> closed_polygon(const Sketch& s, const Outline& outline) {
  std::vector<Point> out = polygon_of(outline);
  if (!outline.open || !s.symmetry[0] || !s.symmetry[1]) return out;
  const double near = kJoint * size_of(out);
  const Point corner{*s.symmetry[0], *s.symmetry[1]}, first = out.front() - corner, last = out.back() - corner;
  const bool along_x = std::fabs(first.y) <= near && std::fabs(last.y) <= near;
  const bool along_y = std::fabs(first.x) <= near && std::fabs(last.x) <= near;
  if (!along_x && !along_y) out.push_back(corner);
  return out;
}

} // namespace

Region::Region(const Sketch& sketch, const Body& body) : low_{HUGE_VAL, HUGE_VAL}, high_{-HUGE_VAL, -HUGE_VAL} {
  bool is_open = false;
  for (const Outline& outline : body.outlines) {
    is_open = is_open || outline.open;
    polygons_.push_back(closed_polygon(sketch, outline));
    for (const Point& p : polygons_.back()) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    for (const Curve& curve : outline.curves) {
      const int n = 48 + 2 * curve.shape->pieces();
      for (int k = 0; k < n; ++k) {
        const double first = static_cast<double>(k) / n, last = static_cast<double>(k + 1) / n;
        chords_.push_back({curve.shape->at(first), curve.shape->at(last), &curve, first, last});
      }
    }
  }
  size_ = std::max(high_.x - low_.x, high_.y - low_.y);
  for (size_t axis = 0; axis < 2 && is_open; ++axis) line_[axis] = sketch.symmetry[axis];
}

// Moves a point on a line of symmetry slightly into the half-plane of the body, for the inside test.
Point Region::beside_lines(Point p) const {
  const double near = kJoint * size_;
  if (line_[0] && std::fabs(p.x - *line_[0]) <= near) p.x = *line_[0] + (low_.x + high_.x > 2 * *line_[0] ? near : -near);
  if (line_[1] && std::fabs(p.y - *line_[1]) <= near) p.y = *line_[1] + (low_.y + high_.y > 2 * *line_[1] ? near : -near);
  return p;
}

double Region::depth(Point p) const {
  double least = HUGE_VAL, u = 0;
  const Chord* nearest = nullptr;
  for (const Chord& chord : chords_) {
    const Point d = chord.b - chord.a;
    const double t = std::clamp(dot(p - chord.a, d) / dot(d, d), 0.0, 1.0);
    const double away = length(p - (chord.a + t * d));
    if (away < least) least = away, nearest = &chord, u = chord.first + t * (chord.last - chord.first);
  }
  bool inside = false;
  for (const std::vector<Point>& polygon : polygons_) inside ^= holds(polygon, beside_lines(p));
  const Shape& shape = *nearest->curve->shape;
  for (int step = 0; step < 20; ++step) { // Newton's method on the distance
    const Shape::Local l = shape.local(u);
    const double slope = dot(l.d, l.d) + dot(l.at - p, l.dd);
    if (!(slope > 0)) break;
    u = std::clamp(u - dot(l.at - p, l.d) / slope, 0.0, 1.0);
  }
  const Point off = p - shape.at(u);
  const double away = std::min(length(off), least + kNearBoundary * size_);
  if (away < kNearBoundary * size_ && u > 0 && u < 1)
    inside = dot(off, turned_left(shape.tangent(u))) > 0; // material on the left
  return inside ? away : -away;
}

bool Region::is_apart(const Region& other) const {
  return high_.x < other.low_.x || other.high_.x < low_.x || high_.y < other.low_.y || other.high_.y < low_.y;
}

bool Region::may_contain(Point p) const { return p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y; }

std::vector<Point> Region::points() const {
  std::vector<Point> out;
  for (const Chord& chord : chords_) out.push_back(chord.a);
  return out;
}

double Region::boundary() const {
  double sum = 0;
  for (const Chord& chord : chords_) sum += length(chord.b - chord.a);
  return sum;
}

double Region::area() const {
  double sum = 0;
  for (const std::vector<Point>& polygon : polygons_) sum += area_of(polygon);
  return sum;
}

} // namespace sketch
