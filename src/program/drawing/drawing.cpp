#include "program/drawing/drawing.hpp"

#include "program/drawing/text.hpp"
#include "program/sketch/shapes/outline.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {
namespace {

int corners_on(const Curve& curve) {
  if (curve.kind == Curve::kLine) return 1;
  return curve.kind == Curve::kSpline ? 4 * static_cast<int>(curve.points.size()) : 48;
}

} // namespace

Curve straight(Point begin, Point end) {
  Curve c;
  c.begin = begin, c.end = end;
  return c;
}

Curve elliptic(Point centre, double a, double b, double tilt, double from, double sweep) {
  Curve c;
  c.kind = Curve::kEllipse;
  c.centre = centre, c.a = a, c.b = b, c.tilt = tilt, c.from = from;
  c.whole = std::fabs(sweep) >= 360 * (1 - 1e-9);
  c.sweep = c.whole ? 360 : sweep;
  const sketch::ShapePtr shape = shape_of(c);
  c.begin = shape->at(0), c.end = c.whole ? c.begin : shape->at(1);
  return c;
}

Curve circular(Point centre, double radius, double from, double sweep) {
  Curve c = elliptic(centre, radius, radius, 0, from, sweep);
  c.kind = Curve::kArc;
  return c;
}

Curve smooth(std::vector<Point> points, bool whole) {
  Curve c;
  c.kind = Curve::kSpline;
  c.whole = whole;
  c.begin = points.front(), c.end = whole ? points.front() : points.back();
  c.points = std::move(points);
  return c;
}

sketch::ShapePtr shape_of(const Curve& c) {
  switch (c.kind) {
  case Curve::kLine: return sketch::line(c.begin, c.end);
  case Curve::kSpline: return sketch::spline(c.points, c.whole);
  case Curve::kArc:
  case Curve::kEllipse: break;
  }
  return sketch::ellipse(c.centre, c.a, c.b, c.tilt, c.from, c.sweep);
}

Curve reversed(const Curve& curve) {
  Curve c = curve;
  std::swap(c.begin, c.end);
  c.from += c.sweep;
  c.sweep = -c.sweep;
  std::reverse(c.points.begin(), c.points.end());
  return c;
}

void move_ends(Curve& c, Point begin, Point end) {
  if (c.whole) return;
  const double moved = std::max(sketch::length(c.begin - begin), sketch::length(c.end - end));
  c.begin = begin, c.end = end;
  if (c.kind == Curve::kEllipse && moved > 1e-7 * std::min(c.a, c.b)) { // an ellipse through other ends has no simple form
    const sketch::ShapePtr shape = shape_of(c);
    Curve through = c;
    through.kind = Curve::kSpline;
    through.doubt = moved;
    constexpr int kPieces = 64;
    for (int i = 0; i <= kPieces; ++i) through.points.push_back(shape->at(static_cast<double>(i) / kPieces));
    c = std::move(through);
  }
  if (c.kind == Curve::kSpline) c.points.front() = begin, c.points.back() = end;
}

std::vector<Curve> halves(const Curve& c) {
  Curve first = c, second = c;
  if (c.kind == Curve::kSpline) {
    const sketch::ShapePtr shape = shape_of(c);
    size_t middle = c.points.size() / 2;
    if (c.points.size() < 4) { // two halves of one point more
      first.points = {c.begin, shape->at(0.25), shape->at(0.5)};
      second.points = {shape->at(0.5), shape->at(0.75), c.end};
    } else {
      first.points.assign(c.points.begin(), c.points.begin() + static_cast<ptrdiff_t>(middle) + 1);
      second.points.assign(c.points.begin() + static_cast<ptrdiff_t>(middle), c.points.end());
    }
    first.end = second.begin = second.points.front();
    return {first, second};
  }
  first.end = second.begin = c.kind == Curve::kLine ? 0.5 * (c.begin + c.end) : shape_of(c)->at(0.5);
  first.sweep = second.sweep = c.sweep / 2;
  second.from += c.sweep / 2;
  return {first, second};
}

void append_polygon(std::vector<Point>& out, const Curve& curve) {
  const int n = corners_on(curve);
  if (n == 1) {
    out.push_back(curve.begin);
    return;
  }
  const sketch::ShapePtr shape = shape_of(curve);
  for (int i = 0; i < n; ++i) out.push_back(shape->at(static_cast<double>(i) / n));
}

std::string text_of(double value) { return app::rounded(value == 0 ? 0 : value); }

std::string text_of(Point p) { return "(" + text_of(p.x) + ", " + text_of(p.y) + ")"; }

std::string text_of(const Curve& c) {
  const char* const kinds[] = {"line", "arc", "ellipse", "spline"};
  std::string text = c.whole && c.kind == Curve::kArc ? "circle" : kinds[c.kind];
  if (!c.name.empty()) text += " of " + shown(c.name);
  return text + (c.line > 0 ? " in line " + std::to_string(c.line) : std::string());
}

double size_of(const std::vector<Curve>& curves) {
  std::vector<Point> points;
  for (const Curve& curve : curves) {
    append_polygon(points, curve);
    points.push_back(curve.end);
  }
  return points.empty() ? 0 : sketch::size_of(points);
}

} // namespace drawing
