// Bodies that several families share. Half bodies lie at x >= 0 with the line of symmetry x = 0 as their last
// side; contact zones begin at x = 0 and have their nodes at the distances `zone`.
#pragma once

#include "program/families/mesh.hpp"

#include <string>

namespace families {

// A half plane below y = 0 as a block of half width and depth `size` on smooth rollers (half body), or
// clamped at its foot (whole body, zone from -w to w). `foot` is the condition there.
struct BlockMesh {
  std::vector<double> zone; // distances from the axis
  double size;
  double ratio; // growth of the elements away from the zone
};
// Sides: 0 foot, 1 right, 2 surface outside the zone, 3 zone, 4 axis.
Outline half_block(const BlockMesh& mesh);
// Sides: 0 foot, 1 right, 2 surface, 3 zone, 4 surface, 5 left.
Outline whole_block(const BlockMesh& mesh);

// Nodes of a zone under a cylinder, from its axis: so many elements of about a size, of equal angles, and then others.
struct ZoneRun {
  double size;
  int elements;
};
std::vector<double> cylinder_zone(double radius, const std::vector<ZoneRun>& runs);

// The lower half of a cylinder of radius `radius` that touches y = 0, with a flat top at its centre; the
// zone's nodes lie above those of a block. Arcs are about (0, radius). `top`: the condition of the flat top.
// Sides of the half body: 0 zone, 1 arc outside, 2 top, 3 axis.
Outline half_cylinder(const std::vector<double>& zone, double radius, double ratio, const Condition& top);

// The lower half circle of such a cylinder, from left to right, for a whole body that the caller closes.
// Sides: 0 arc, 1 zone, from -w to w, 2 arc.
Outline whole_cylinder_arcs(const std::vector<double>& zone, double radius, double ratio);

double first_size(const std::vector<double>& s);
double last_size(const std::vector<double>& s);
// -s.back() ... s.back(), as distances from the left end.
std::vector<double> mirrored(const std::vector<double>& s);

// "%.6g" of a number, for headings.
std::string show(double value);

} // namespace families
