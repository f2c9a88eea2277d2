// Outlines from consecutive curves: joints, fillets, chamfers, checks.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Lengths below this fraction of the size of an outline count as zero.
constexpr double kJoint = 1e-6;

// Inserts an arc between two curves and shortens both. Throws a Fault at `at` if it does not fit.
Curve fillet(Curve& before, Curve& next, const std::string& name, double radius, Place at);
// Inserts a line and shortens both curves by `cut`.
Curve chamfer(Curve& before, Curve& next, const std::string& name, double cut, Place at);

// The corners of a polygon that approximates an outline.
std::vector<Point> polygon_of(const Outline& outline);
double area_of(const std::vector<Point>& polygon);      // above 0: counter-clockwise
bool holds(const std::vector<Point>& polygon, Point p); // is the point inside?
double size_of(const std::vector<Point>& polygon);      // the larger side of the bounding box

// Errors of the shapes of a sketch: open, clockwise or crossing outlines, and bodies that overlap.
std::vector<Fault> faults_of_shapes(const Sketch& sketch);

} // namespace sketch
