#include "program/drawing/course.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {
namespace {

double distance_to_chord(Point a, Point b, Point p) {
  const Point d = b - a;
  const double l = sketch::dot(d, d), along = l > 0 ? std::clamp(sketch::dot(p - a, d) / l, 0.0, 1.0) : 0;
  return sketch::length(p - (a + along * d));
}

} // namespace

Course::Course(const std::vector<Curve>& curves) {
  for (const Curve& curve : curves) {
    std::vector<Point> points;
    append_polygon(points, curve);
    const double width = 1.0 / static_cast<double>(points.size());
    points.push_back(curve.end);
    for (size_t i = 0; i + 1 < points.size(); ++i)
      chords_.push_back({points[i], points[i + 1], shapes_.size(), static_cast<double>(i) * width, width});
    shapes_.push_back(shape_of(curve));
  }
}

Course::Nearest Course::nearest(Point p) const {
  double least = HUGE_VAL;
  const Chord* chord = &chords_.front();
  for (const Chord& c : chords_)
    if (const double d = distance_to_chord(c.a, c.b, p); d < least) least = d, chord = &c;
  const sketch::Shape& shape = *shapes_[chord->shape];
  double u = chord->u + chord->width / 2;
  sketch::Shape::Local on = shape.local(u);
  for (int i = 0; i < 8; ++i) { // to the foot of the perpendicular
    const double speed = sketch::dot(on.d, on.d);
    if (!(speed > 0)) break;
    u = std::clamp(u + sketch::dot(p - on.at, on.d) / speed, 0.0, 1.0);
    on = shape.local(u);
  }
  return {sketch::length(p - on.at), sketch::cross(on.d, p - on.at) > 0, shape.tangent(u)};
}

double Course::area() const {
  double sum = 0;
  const Point origin = chords_.front().a;
  for (const Chord& chord : chords_)
    for (const double g : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) { // Gauss's rule
      const sketch::Shape::Local p = shapes_[chord.shape]->local(chord.u + (0.5 + 0.5 * g) * chord.width);
      sum += (g == 0 ? 4.0 : 2.5) / 9 * sketch::cross(p.at - origin, p.d) / 2 * chord.width;
    }
  return sum;
}

std::vector<Point> Course::samples(size_t count) const {
  std::vector<Point> out;
  const size_t step = std::max<size_t>(1, chords_.size() / count);
  for (size_t i = 0; i < chords_.size(); i += step)
    out.push_back(shapes_[chords_[i].shape]->at(chords_[i].u + chords_[i].width / 2));
  return out;
}

double Course::farthest(const Course& other) const {
  double most = 0;
  for (const Point& p : samples(48)) most = std::max(most, other.nearest(p).distance);
  for (const Chord& chord : chords_) // corners
    if (chord.u == 0) most = std::max(most, other.nearest(chord.a).distance);
  return most;
}

} // namespace drawing
