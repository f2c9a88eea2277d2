// From curves one after the other to a closed outline: joints, fillets, chamfers.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// Lengths below this share of an outline's size are nothing.
constexpr double kJoint = 1e-6;

// Puts an arc between the last curve of `curves` and `next`, both of which become shorter. Throws a Fault at `at`.
Curve fillet(Curve& before, Curve& next, const std::string& name, double radius, Place at);
// The same with a line that cuts `cut` off both.
Curve chamfer(Curve& before, Curve& next, const std::string& name, double cut, Place at);

// The corners of a polygon that follows an outline, a few on every curve.
std::vector<Point> polygon_of(const Outline& outline);
double area_of(const std::vector<Point>& polygon); // above 0: counter-clockwise
bool holds(const std::vector<Point>& polygon, Point p);
double size_of(const std::vector<Point>& polygon); // the larger side of the box around it

// What is wrong with the shapes of a sketch: outlines that are open, clockwise or cross, bodies that overlap.
std::vector<Fault> faults_of_shapes(const Sketch& sketch);

} // namespace sketch
