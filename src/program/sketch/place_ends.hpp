// Element ends at given places of the boundary: where a contact ends or slip begins.
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

// The nearest curve of the body, of those at whose nodes contact conditions hold if that is asked for: null if there is none;
// the length along it, and how many elements the body has before it.
struct Located {
  MeshedCurve* curve = nullptr;
  double length = 0;
  size_t first = 0;
};
Located locate(const Sketch& sketch, const Spot& spot, bool in_contact, Mesh& mesh);

// The length along a curve where it is nearest to a point.
double nearest_length(const MeshedCurve& curve, Point p);

// On sides at whose nodes contact conditions hold, the element end nearest to a place moves there; ends of curves stay.
// An end that has moved to one place does not move to the next.
void place_ends(const Sketch& sketch, const std::vector<Spot>& spots, Mesh& mesh);

} // namespace sketch
