// A loop of curves as one path: nearest point, and distance between two paths.
#pragma once

#include "program/drawing/drawing.hpp"

namespace drawing {

class Course {
public:
  explicit Course(const std::vector<Curve>& curves);
  struct Nearest {
    double distance;
    bool is_left; // is the point on the left of the course?
    Point along;  // unit tangent there
  };
  Nearest nearest(Point p) const;
  double area() const; // above 0: counter-clockwise
  // Points on it between the corners, `count` or some more.
  std::vector<Point> samples(size_t count) const;
  // How far points of this course are from another at most.
  double farthest(const Course& other) const;

private:
  struct Chord {
    Point a, b;
    size_t shape;
    double u, width; // of the shape
  };
  std::vector<sketch::ShapePtr> shapes_;
  std::vector<Chord> chords_;
};

} // namespace drawing
