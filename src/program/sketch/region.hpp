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
  double size() const { return size_; }     // the larger side of the box around it
  bool may_hold(Point p) const;             // is it in the box?
  bool is_apart(const Region& other) const; // do the boxes lie apart?
  std::vector<Point> points() const;        // of the boundary, on the curves
  double area() const;                      // of the polygons
  double boundary() const;                  // length of the curves

private:
  struct Chord { // of a curve, between two values of u
    Point a, b;
    const Curve* curve;
    double first, last;
  };
  Point beside_lines(Point p) const;

  double size_ = 0;
  Point low_, high_;              // of the box
  std::optional<double> line_[2]; // of symmetry, x = and y =, where the body begins or ends on one
  std::vector<Chord> chords_;
  std::vector<std::vector<Point>> polygons_;
};

} // namespace sketch
