#include "program/drawing/formats/nurbs.hpp"

#include "program/drawing/chain.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {
namespace {

constexpr size_t kMostPoints = 1000; // of one spline

// The direction in which the curve leaves an end of the span from `knots[k]` to `knots[k + 1]`: towards the first control
// point of its Bezier form that lies elsewhere, also where handles are retracted.
Point direction(const Nurbs& n, size_t k, bool from_end) {
  const size_t p = static_cast<size_t>(n.degree);
  double at[16];
  std::fill(at, at + p, n.knots[from_end ? k + 1 : k]);
  const Point start = n.polar(k, at);
  const double nothing = 1e-9 * sketch::size_of(n.points);
  for (size_t i = 0; i < p; ++i) {
    at[i] = n.knots[from_end ? k : k + 1];
    const Point d = n.polar(k, at) - start;
    if (const double l = sketch::length(d); l > nothing) return (1 / l) * d;
  }
  return {};
}

bool turns(Point backwards, Point onwards) { return sketch::dot(backwards, onwards) > -std::cos(1e-3); }

// Spans between different knots, by their first ones; those in which the curve stands still only if there are no others.
std::vector<size_t> spans_of(const Nurbs& n) {
  std::vector<size_t> out, moving;
  for (size_t k = static_cast<size_t>(n.degree); k < n.points.size(); ++k) {
    if (!(n.knots[k + 1] > n.knots[k])) continue;
    out.push_back(k);
    if (sketch::length(direction(n, k, false)) > 0) moving.push_back(k);
  }
  return moving.empty() ? out : moving;
}

// Where the curve is split: its ends, and knots where it has a corner.
std::vector<double> corners_of(const Nurbs& n, const std::vector<size_t>& spans) {
  std::vector<double> out{n.knots[spans.front()]};
  for (size_t i = 1; i < spans.size(); ++i)
    if (turns(direction(n, spans[i - 1], true), direction(n, spans[i], false))) out.push_back(n.knots[spans[i]]);
  out.push_back(n.knots[spans.back() + 1]);
  return out;
}

bool is_straight(const std::vector<Point>& points) {
  const Point d = points.back() - points.front();
  const double l = sketch::length(d);
  double before = -1e-9 * l;
  for (const Point& p : points) {
    const double along = sketch::dot(p - points.front(), d) / (l > 0 ? l : 1);
    if (std::fabs(sketch::cross(d, p - points.front())) > 1e-9 * l * l || along < before) return false;
    before = along;
  }
  return l > 0;
}

// How far p is from a shape, near u.
double distance(const sketch::Shape& shape, double u, Point p) {
  for (int i = 0; i < 4; ++i) {
    const sketch::Shape::Local q = shape.local(u);
    const double speed = sketch::dot(q.d, q.d);
    if (!(speed > 0)) break;
    u = std::clamp(u + sketch::dot(p - q.at, q.d) / speed, 0.0, 1.0);
  }
  return sketch::length(shape.at(u) - p);
}

struct Follow { // the parameters at the points of a spline that follows a curve
  const Nurbs& n;
  std::vector<double> t;
  bool closed;

  std::vector<Point> points() const {
    std::vector<Point> out;
    for (const double at : t) out.push_back(n.at(at));
    if (closed) out.pop_back();
    return out;
  }
  // Of each piece the largest distance.
  std::vector<double> distances() const;
};

std::vector<double> Follow::distances() const {
  const std::vector<Point> p = points();
  const sketch::ShapePtr shape = sketch::spline(p, closed);
  std::vector<double> sums{0};
  for (size_t i = 1; i < t.size(); ++i) sums.push_back(sums.back() + sketch::length(n.at(t[i]) - n.at(t[i - 1])));
  std::vector<double> out;
  for (size_t i = 1; i < t.size(); ++i) {
    double most = 0;
    for (const double f : {0.2, 0.5, 0.8}) {
      const double u = ((1 - f) * sums[i - 1] + f * sums[i]) / sums.back();
      most = std::max(most, distance(*shape, u, n.at((1 - f) * t[i - 1] + f * t[i])));
    }
    out.push_back(most);
  }
  return out;
}

// Halves pieces that are too inaccurate.
bool refine(Follow& follow, double tolerance, double& doubt) {
  const std::vector<double> far = follow.distances();
  doubt = *std::max_element(far.begin(), far.end());
  if (doubt <= tolerance || follow.t.size() >= kMostPoints) return false;
  std::vector<double> t{follow.t.front()};
  for (size_t i = 0; i < far.size(); ++i) {
    const double a = follow.t[i], b = follow.t[i + 1], m = 0.5 * (a + b);
    const Point p = follow.n.at(a), q = follow.n.at(m), r = follow.n.at(b);
    const bool apart = sketch::length(q - p) > 0 && sketch::length(r - q) > 0;
    if (far[i] > tolerance && apart && t.size() < kMostPoints) t.push_back(m);
    t.push_back(b);
  }
  const bool changed = t.size() > follow.t.size();
  follow.t = std::move(t);
  return changed;
}

// Circles are often drawn as rational splines.
bool follows_circle(const Nurbs& n, double first, double last, bool closed, Curve& arc) {
  constexpr int kSamples = 48;
  std::vector<Point> points;
  for (int i = 0; i < kSamples + (closed ? 0 : 1); ++i) points.push_back(n.at(first + (last - first) * i / kSamples));
  const std::vector<Curve> curves = curves_of(points, closed, sketch::size_of(points));
  if (curves.size() != 1 || curves[0].kind != Curve::kArc) return false;
  arc = curves[0];
  return true;
}

Curve follow(const Nurbs& n, double first, double last, bool closed, double tolerance) {
  Follow f{n, {}, closed};
  f.t = {first};
  for (const double knot : n.knots) // two pieces at least between different knots
    if (knot > f.t.back() && knot <= last && f.t.size() < kMostPoints) {
      f.t.push_back(0.5 * (f.t.back() + knot));
      f.t.push_back(knot);
    }
  if (f.t.back() < last) f.t.push_back(last);
  // Points of a spline are apart: a curve may stand still where control points lie on each other.
  std::vector<double> apart{first};
  for (size_t i = 1; i < f.t.size(); ++i)
    if (sketch::length(n.at(f.t[i]) - n.at(apart.back())) > 0) apart.push_back(f.t[i]);
  if (apart.back() != last) apart.back() = last;
  f.t = apart;
  std::vector<Point> points = f.points();
  if (points.size() < (closed ? 3u : 2u)) return straight(n.at(first), n.at(last));
  if (!closed && is_straight(points)) return straight(points.front(), points.back());
  if (Curve arc; follows_circle(n, first, last, closed, arc)) return arc;
  double doubt = 0;
  while (refine(f, tolerance, doubt)) {
  }
  Curve out = smooth(f.points(), closed);
  out.doubt = doubt;
  return out;
}

} // namespace

std::string Nurbs::fault() const {
  if (degree < 1 || degree > 15) return "degree " + std::to_string(degree) + ", expected 1 to 15";
  const size_t p = static_cast<size_t>(degree);
  if (points.size() <= p)
    return std::to_string(points.size()) + " control points, expected more than its degree " + std::to_string(degree);
  if (knots.size() != points.size() + p + 1)
    return std::to_string(knots.size()) + " knots, expected " + std::to_string(points.size() + p + 1) +
           ": control points + degree + 1";
  if (!std::is_sorted(knots.begin(), knots.end())) return "decreasing knots";
  if (!(knots[p] < knots[points.size()])) return "knots that span no interval";
  if (!weights.empty() && weights.size() != points.size())
    return std::to_string(weights.size()) + " weights, expected one per control point";
  for (const double w : weights)
    if (!(w > 0)) return "weight " + text_of(w) + ", expected a value above 0";
  return "";
}

Point Nurbs::at(double t) const {
  const size_t p = static_cast<size_t>(degree), n = points.size();
  t = std::clamp(t, knots[p], knots[n]);
  size_t k = static_cast<size_t>(std::upper_bound(knots.begin() + degree, knots.begin() + static_cast<ptrdiff_t>(n), t) -
                                 knots.begin()) -
             1;
  while (k > p && knots[k + 1] == knots[k]) --k; // t is the last knot
  double all[16];
  std::fill(all, all + p, t);
  return polar(k, all);
}

// De Boor's scheme on points times weights.
Point Nurbs::polar(size_t k, const double* t) const {
  const size_t p = static_cast<size_t>(degree);
  double x[16], y[16], w[16];
  for (size_t i = 0; i <= p; ++i) {
    const size_t j = k - p + i;
    w[i] = weights.empty() ? 1 : weights[j];
    x[i] = w[i] * points[j].x, y[i] = w[i] * points[j].y;
  }
  for (size_t r = 1; r <= p; ++r)
    for (size_t i = p; i >= r; --i) {
      const double low = knots[k - p + i], high = knots[k + 1 + i - r];
      const double f = high > low ? (t[r - 1] - low) / (high - low) : 0;
      x[i] = (1 - f) * x[i - 1] + f * x[i];
      y[i] = (1 - f) * y[i - 1] + f * y[i];
      w[i] = (1 - f) * w[i - 1] + f * w[i];
    }
  return {x[p] / w[p], y[p] / w[p]};
}

Nurbs nurbs_through(const std::vector<Point>& points, bool whole) {
  const sketch::ShapePtr shape = sketch::spline(points, whole);
  std::vector<Point> p = points;
  if (whole) p.push_back(points.front());
  std::vector<double> u{0};
  for (size_t i = 1; i < p.size(); ++i) u.push_back(u.back() + sketch::length(p[i] - p[i - 1]));
  Nurbs n;
  n.points = {p[0]};
  n.knots.assign(4, 0);
  for (size_t i = 1; i < p.size(); ++i) { // Bezier pieces, by the derivatives at their ends
    const double from = u[i - 1] / u.back(), to = u[i] / u.back();
    n.points.push_back(p[i - 1] + ((to - from) / 3) * shape->local(from).d);
    n.points.push_back(p[i] - ((to - from) / 3) * shape->local(to).d);
    n.points.push_back(p[i]);
    n.knots.insert(n.knots.end(), i + 1 < p.size() ? 3 : 4, to);
  }
  return n;
}

std::vector<Curve> curves_of(const Nurbs& n, double tolerance) {
  const std::vector<size_t> spans = spans_of(n);
  const std::vector<double> corners = corners_of(n, spans);
  std::vector<Curve> out;
  const Point gap = n.at(corners.back()) - n.at(corners.front());
  // A closed one without a corner is one curve that is whole.
  const bool whole = corners.size() == 2 && sketch::length(gap) <= 1e-9 * sketch::size_of(n.points) &&
                     !turns(direction(n, spans.back(), true), direction(n, spans.front(), false));
  for (size_t i = 1; i < corners.size(); ++i) out.push_back(follow(n, corners[i - 1], corners[i], whole, tolerance));
  return out;
}

} // namespace drawing
