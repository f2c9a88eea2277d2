#pragma once
// Geometry of one boundary element.
#include "model/shape.hpp"

namespace c2d {

// x(eta) = sum_k c[k] eta^k through 2 to 4 equally numbered nodes, eta = -1 at the first, +1 at the last.
// The boundary runs counter-clockwise: material on the left.
struct Element {
  int nodes;
  double x[kElementNodes], y[kElementNodes]; // nodes, in order along the boundary
  bool straight;                             // constant Jacobian: linear, or collinear and equally spaced within round-off
  double c[kElementNodes][2];                // polynomial coefficients; c[2] = c[3] = 0 if straight
  double half_length;                        // half the distance between first and last node; 0 for a double node
};

// A point of an element: position, derivative by eta, J = |dx/deta|, unit outward normal (dy,-dx)/J.
struct Point {
  double x, y, dx, dy, jacobian, nx, ny;
};

// Element through `nodes` (2..4) points. Coinciding points (a double node) are legal.
Element make_element(int nodes, const double* x, const double* y);

// Point at eta in [-1,1]. Where the Jacobian vanishes the normal is (0,0).
Point element_point(const Element& element, double eta);

// The point of an element nearest to (x, y).
struct Nearest {
  double eta, distance;
};
Nearest nearest_point(const Element& element, double x, double y);

} // namespace c2d
