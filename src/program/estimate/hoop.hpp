// Stresses along the surface of a body on one mesh: at the nodes, and at edges of slipping contacts. There the stress has a
// peak that nodal values do not resolve.
#pragma once

#include "program/estimate/trial.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// A stress along the surface and its place. `way`: number of elements behind an edge that it was extrapolated from, 0: at a
// node or between nodes. `doubt`: its uncertainty, from the change with fewer elements or from the unresolved part between
// nodes.
struct Along {
  double value = 0, doubt = 0;
  sketch::Point at = {};
  int way = 0;
};

// The largest and the smallest stress along curves from the state `first` on, and the largest range at one place.
struct Hoop {
  Along high, low, widest;
  bool any = false; // false: the curves have no elements, or there is no such state
};
// The pressure on a body at the end, at the place of its curves nearest to a point; `largest`: the largest on all curves.
struct PressureAt {
  double value = 0, largest = 0;
  sketch::Point at = {};
};
PressureAt find_pressure(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, sketch::Point near);

Hoop find_hoop(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, size_t first);

} // namespace estimate
