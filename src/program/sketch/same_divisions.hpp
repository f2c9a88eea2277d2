// The mesh of a sketch on the same sketch with other values of its parameters.
#pragma once

#include "program/sketch/mesh.hpp"
#include "program/sketch/place_ends.hpp"

#include <map>

namespace sketch {

// A place on a curve of a mesh: the index of the curve among all of the mesh, and the fraction of its length.
struct MeshPlace {
  size_t curve = 0;
  double part = 0;
};
// The place of a spot on a side with contact conditions at its nodes.
MeshPlace place_on(const Sketch& sketch, const Spot& spot, const Mesh& mesh);

// Fractions of a curve, rising from 0 to 1, and where they move: elements between two of them are stretched in proportion.
struct Stretching {
  std::vector<double> from{0, 1}, to{0, 1};
  double at(double part) const;
};
using Stretchings = std::map<size_t, Stretching>; // by the index of the curve in the mesh

// Divides the curves of `changed` as `mesh` divides those of `sketch`: the same elements, with the same fractions of the length
// of each curve, or where these move. Element ends that lie opposite ends of the other side of a contact stay opposite. The
// mesh refers to `changed`. Throws a Fault if the sketches differ in more than numbers: bodies, curves, facing parts, load
// cases.
Mesh same_divisions(const Sketch& sketch, const Mesh& mesh, const Sketch& changed, const Stretchings& stretchings = {});

} // namespace sketch
