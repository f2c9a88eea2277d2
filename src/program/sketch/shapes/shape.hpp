// Shapes of boundary curves: points and derivatives by a parameter u from 0 to 1, and lengths along the curve.
#pragma once

#include "post/point.hpp"
#include "program/sketch/read/expression.hpp"

#include <memory>
#include <vector>

namespace sketch {

using app::cross, app::distance, app::dot, app::length, app::turned_left;
using app::Point;
double angle_between(Point a, Point b); // from a to b, in radians, above 0 to the left

enum class Form { kLine, kArc, kSmooth }; // its type on a *CURVE card

class Shape {
public:
  struct Local {
    Point at, d, dd; // the point and its derivatives by u
  };
  virtual ~Shape() = default;
  virtual Local local(double u) const = 0;
  virtual Form form() const { return Form::kSmooth; }
  virtual int pieces() const { return 1; } // number of smooth pieces; sampling increases with it

  Point at(double u) const { return local(u).at; }
  Point tangent(double u) const;    // unit vector in the direction of increasing u
  double curvature(double u) const; // above 0: turns left
};
using ShapePtr = std::shared_ptr<const Shape>;

ShapePtr line(Point from, Point to);
// An arc about `centre` from the angle `from` through `sweep`, both in degrees; positive: counter-clockwise.
ShapePtr arc(Point centre, double radius, double from, double sweep);
// An ellipse with semi-axes a and b, a rotated by `tilt` degrees; eccentric angles in degrees.
ShapePtr ellipse(Point centre, double a, double b, double tilt, double from, double sweep);
// x and y as formulas of one variable between two values.
ShapePtr formula(Expression x, Expression y, double first, double last);
// A cubic spline through points with chord-length parameter: natural ends, or periodic if `closed`.
ShapePtr spline(const std::vector<Point>& points, bool closed);

// An affine map for copies: shift, rotation and reflection. A reflection moves the material to the other side of a curve, so
// reflected curves are reversed.
struct Motion {
  double a = 1, b = 0, c = 0, d = 1; // x' = a x + b y + x0, y' = c x + d y + y0
  double x0 = 0, y0 = 0;
  Point operator()(Point p) const { return {a * p.x + b * p.y + x0, c * p.x + d * p.y + y0}; }
  bool mirrors() const { return a * d - b * c < 0; }
};
ShapePtr moved(ShapePtr shape, const Motion& motion);
// Another shape from u = first to u = last; reversed if first > last.
ShapePtr part(ShapePtr shape, double first, double last);

// Lengths along a shape, from a table; accurate to about 1e-10 of the total length.
class Measure {
public:
  explicit Measure(ShapePtr shape);
  double length() const { return sums_.back(); }
  double u_at(double length) const;
  double length_to(double u) const;

private:
  double piece(double from, double to) const;
  ShapePtr shape_;
  int steps_;
  std::vector<double> sums_; // length up to each of equal steps of u
};

} // namespace sketch
