// Moves element ends to given places of the boundary, such as edges of contact and stick.
#pragma once

#include "program/sketch/mesh.hpp"
#include "program/sketch/sketch.hpp"

#include <vector>

namespace sketch {

// A place on the boundary of a body, from 0.
struct Spot {
  int body;
  Point at;
};

// The nearest curve of the body (with `in_contact`: of its curves with contact conditions at their nodes), null if there is
// none; the length along it, and the number of elements of the body before it.
struct Located {
  MeshedCurve* curve = nullptr;
  double length = 0;
  size_t first = 0;
};
Located locate(const Sketch& sketch, const Spot& spot, bool in_contact, Mesh& mesh);

// The length along a curve where it is nearest to a point.
double nearest_length(const MeshedCurve& curve, Point p);

// On sides with contact conditions at their nodes, the element end nearest to a place moves there. Ends of curves stay, and an
// end moves only once.
void place_ends(const Sketch& sketch, const std::vector<Spot>& spots, Mesh& mesh);

} // namespace sketch
