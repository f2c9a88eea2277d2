// Where the material of a body is, and how deep a point lies in it.
#pragma once

#include "program/sketch/outline.hpp"

namespace sketch {

class Region {
public:
  // Open outlines are closed along the lines of symmetry.
  Region(const Sketch& sketch, const Body& body);
  // The distance of a point to the boundary; below 0 outside.
  double depth(Point p) const;
  double size() const { return size_; }        // the larger side of the box around it
  bool may_hold(Point p, double beyond) const; // in the box, or no farther beyond it
  std::vector<Point> points() const;           // of the boundary, on the curves
  double area() const;                         // of the polygons

private:
  struct Chord { // of a curve, between two values of u
    Point a, b;
    const Curve* curve;
    double first, last;
  };
  double size_ = 0;
  Point low_, high_;
  std::vector<Chord> chords_;
  std::vector<std::vector<Point>> polygons_;
};

} // namespace sketch
