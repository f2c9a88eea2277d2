// The cubic spline through points: curvature is continuous, and zero at the ends of an open one.
#include "program/sketch/shapes/shape.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

class Spline final : public Shape {
public:
  Spline(const std::vector<Point>& points, bool closed);
  Local local(double u) const override;
  int pieces() const override { return static_cast<int>(points_.size()); }

private:
  std::vector<double> at_;    // of each point, from 0 to 1
  std::vector<Point> points_; // a closed spline repeats the first point at the end
  std::vector<Point> bend_;   // second derivatives there
};

// Rows  below[i] x[i-1] + on[i] x[i] + above[i] x[i+1] = r[i].
std::vector<Point> solve_three_diagonals(std::vector<double> below, std::vector<double> on, std::vector<double> above,
                                         std::vector<Point> r) {
  const size_t n = on.size();
  for (size_t i = 1; i < n; ++i) {
    const double f = below[i] / on[i - 1];
    on[i] -= f * above[i - 1];
    r[i] = r[i] - f * r[i - 1];
  }
  for (size_t i = n; i-- > 0;) r[i] = (1 / on[i]) * (i + 1 < n ? r[i] - above[i] * r[i + 1] : r[i]);
  return r;
}

Spline::Spline(const std::vector<Point>& points, bool closed) : points_(points) {
  if (closed) points_.push_back(points.front());
  at_.assign(1, 0);
  for (size_t i = 1; i < points_.size(); ++i) at_.push_back(at_.back() + length(points_[i] - points_[i - 1]));
  const double whole = at_.back();
  for (double& s : at_) s /= whole;
  const size_t n = points_.size();
  std::vector<double> below(n, 0), on(n, 1), above(n, 0);
  std::vector<Point> r(n);
  for (size_t i = 1; i + 1 < n; ++i) {
    const double h = at_[i] - at_[i - 1], k = at_[i + 1] - at_[i];
    below[i] = h / 6, on[i] = (h + k) / 3, above[i] = k / 6;
    r[i] = (1 / k) * (points_[i + 1] - points_[i]) - (1 / h) * (points_[i] - points_[i - 1]);
  }
  if (!closed) {
    bend_ = solve_three_diagonals(below, on, above, r);
    return;
  }
  // x0 is the second derivative at the joint. All others are p + q x0; the equation at the joint determines x0.
  std::vector<Point> unit(n);
  unit.front() = unit.back() = {1, 1};
  const std::vector<Point> p = solve_three_diagonals(below, on, above, r), q = solve_three_diagonals(below, on, above, unit);
  const double h = 1 - at_[n - 2], k = at_[1];
  const Point right = (1 / k) * (points_[1] - points_[0]) - (1 / h) * (points_[n - 1] - points_[n - 2]);
  const double own = (h + k) / 3 + k / 6 * q[1].x + h / 6 * q[n - 2].x;
  const Point x0 = (1 / own) * (right - (k / 6) * p[1] - (h / 6) * p[n - 2]);
  for (size_t i = 0; i < n; ++i) bend_.push_back({p[i].x + q[i].x * x0.x, p[i].y + q[i].y * x0.y});
}

Shape::Local Spline::local(double u) const {
  const auto above = std::upper_bound(at_.begin() + 1, at_.end() - 1, u);
  const size_t i = static_cast<size_t>(above - at_.begin());
  const double h = at_[i] - at_[i - 1], b = (u - at_[i - 1]) / h, a = 1 - b;
  const Point &p = points_[i - 1], &q = points_[i], &m = bend_[i - 1], &k = bend_[i];
  Local out;
  out.at = u == 1 ? points_.back() : a * p + b * q + (h * h / 6) * ((a * a * a - a) * m + (b * b * b - b) * k);
  out.d = (1 / h) * (q - p) + (h / 6) * ((3 * b * b - 1) * k - (3 * a * a - 1) * m);
  out.dd = a * m + b * k;
  return out;
}

} // namespace

ShapePtr spline(const std::vector<Point>& points, bool closed) { return std::make_shared<Spline>(points, closed); }

} // namespace sketch
