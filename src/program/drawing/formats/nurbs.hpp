// B-splines with weights, as drawings have them, and points through which a spline of a sketch follows them.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

struct Nurbs {
  int degree = 3;
  std::vector<double> knots;   // as many as points + degree + 1, none below the one before it
  std::vector<Point> points;   // control points
  std::vector<double> weights; // above 0; none: all alike
  bool closed = false;

  // Its fault; empty: none.
  std::string fault() const;
  Point at(double t) const; // t between knots[degree] and knots[points.size()]
  // The polar form of the span that begins at knots[k], of `degree` arguments: at(t) where all of them are t, the control
  // points of the span's Bezier form where they are its ends.
  Point polar(size_t k, const double* t) const;
};

// What a spline of a sketch through these points is as a B-spline.
Nurbs nurbs_through(const std::vector<Point>& points, bool whole);

// One curve for every smooth part of it: lines where it is straight, else splines that keep within `tolerance` of it if
// 1000 points are enough; Curve::doubt is the largest distance.
std::vector<Curve> curves_of(const Nurbs& nurbs, double tolerance);

} // namespace drawing
