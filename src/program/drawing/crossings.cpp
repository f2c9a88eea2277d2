#include "program/drawing/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace drawing {
namespace {

struct Piece { // of a curve, in its box
  size_t curve;
  double u, width;
  Point low, high;
};

class Finder {
public:
  Finder(const std::vector<Curve>& curves, double tolerance) : curves_(curves), tolerance_(tolerance) {}
  std::vector<Crossing> find();

private:
  void cut(size_t curve);
  void meet(const Piece& p, const Piece& q);
  bool is_at_end(size_t curve, Point at) const;

  const std::vector<Curve>& curves_;
  double tolerance_;
  std::vector<sketch::ShapePtr> shapes_;
  std::vector<Piece> pieces_;
  std::vector<Crossing> found_;
};

void Finder::cut(size_t curve) {
  std::vector<Point> points;
  append_polygon(points, curves_[curve]);
  const double width = 1.0 / static_cast<double>(points.size());
  points.push_back(curves_[curve].end);
  shapes_.push_back(shape_of(curves_[curve]));
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Point a = points[i], b = points[i + 1];
    const double u = static_cast<double>(i) * width;
    const Point middle = shapes_.back()->at(u + width / 2);
    const double bow = 1.5 * sketch::length(middle - 0.5 * (a + b));
    const Piece piece{curve,
                      u,
                      width,
                      {std::min(a.x, b.x) - bow, std::min(a.y, b.y) - bow},
                      {std::max(a.x, b.x) + bow, std::max(a.y, b.y) + bow}};
    if (std::isfinite(piece.low.x + piece.low.y + piece.high.x + piece.high.y)) pieces_.push_back(piece);
  }
}

bool Finder::is_at_end(size_t curve, Point at) const {
  const Curve& c = curves_[curve];
  return !c.whole && std::min(sketch::length(at - c.begin), sketch::length(at - c.end)) <= tolerance_;
}

// Newton's method for the point where two pieces meet.
void Finder::meet(const Piece& p, const Piece& q) {
  constexpr double kTouch = 0.01; // the sine of the angle between curves that touch
  double u = p.u + p.width / 2, v = q.u + q.width / 2;
  sketch::Shape::Local a{}, b{};
  for (int i = 0; i < 12; ++i) {
    a = shapes_[p.curve]->local(u), b = shapes_[q.curve]->local(v);
    const double det = sketch::cross(a.d, b.d);
    if (!(std::fabs(det) > kTouch * sketch::length(a.d) * sketch::length(b.d))) return;
    const double du = sketch::cross(b.at - a.at, b.d) / det, dv = sketch::cross(b.at - a.at, a.d) / det;
    u += du, v += dv;
    if (std::fabs(u - p.u - p.width / 2) > 2 * p.width || std::fabs(v - q.u - q.width / 2) > 2 * q.width) return;
  }
  const auto is_on = [](const Piece& piece, double at) {
    return at >= piece.u - 1e-9 * piece.width && at <= piece.u + piece.width * (1 + 1e-9);
  };
  if (!is_on(p, u) || !is_on(q, v) || sketch::length(a.at - b.at) > tolerance_) return;
  if (is_at_end(p.curve, a.at) || is_at_end(q.curve, a.at)) return;
  if (p.curve == q.curve && std::fabs(u - v) < p.width / 2) return;
  for (const Crossing& c : found_)
    if (c.first == std::min(p.curve, q.curve) && c.second == std::max(p.curve, q.curve) &&
        sketch::length(c.at - a.at) <= tolerance_)
      return;
  found_.push_back({std::min(p.curve, q.curve), std::max(p.curve, q.curve), a.at});
}

std::vector<Crossing> Finder::find() {
  for (size_t i = 0; i < curves_.size(); ++i) cut(i);
  std::sort(pieces_.begin(), pieces_.end(), [](const Piece& p, const Piece& q) {
    return p.low.x != q.low.x ? p.low.x < q.low.x : p.curve != q.curve ? p.curve < q.curve : p.u < q.u;
  });
  for (size_t i = 0; i < pieces_.size(); ++i)
    for (size_t j = i + 1; j < pieces_.size() && pieces_[j].low.x <= pieces_[i].high.x; ++j) {
      const Piece &p = pieces_[i], &q = pieces_[j];
      if (p.low.y > q.high.y || q.low.y > p.high.y) continue;
      if (p.curve == q.curve && curves_[p.curve].kind != Curve::kSpline) continue;
      meet(p, q);
    }
  std::sort(found_.begin(), found_.end(), [](const Crossing& c, const Crossing& d) {
    return std::tie(c.first, c.second, c.at.x, c.at.y) < std::tie(d.first, d.second, d.at.x, d.at.y);
  });
  return std::move(found_);
}

} // namespace

std::vector<Crossing> crossings_of(const std::vector<Curve>& curves, double tolerance) {
  return Finder(curves, tolerance).find();
}

} // namespace drawing
