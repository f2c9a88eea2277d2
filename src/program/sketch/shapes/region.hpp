// The region of a body: inside test and distance of a point to the boundary.
#pragma once

#include "program/sketch/shapes/outline.hpp"

namespace sketch {

class Region {
public:
  // Open outlines are closed along the lines of symmetry.
  Region(const Sketch& sketch, const Body& body);
  // The distance of a point to the boundary; negative outside.
  double depth(Point p) const;
  double size() const { return size_; }     // the larger side of its bounding box
  bool may_contain(Point p) const;          // is it in the bounding box?
  bool is_apart(const Region& other) const; // are the bounding boxes disjoint?
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
  Point low_, high_;              // of the bounding box
  std::optional<double> line_[2]; // of symmetry, x = and y =, if an outline ends on one
  std::vector<Chord> chords_;
  std::vector<std::vector<Point>> polygons_;
};

} // namespace sketch
