// Stresses along the surface of a body on one mesh: at the nodes, and at edges of contacts that slip, where they have their
// peaks and elements say too little of them.
#pragma once

#include "program/estimate/trial.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// A stress along the surface, and where it is. `way`: from how many elements behind an edge it was found, 0: at a node or
// between nodes. `doubt`: what it changes with fewer of them; between nodes, what elements do not follow.
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
// The pressure on a body at the place of its curves that is nearest to a point, at the end; `largest`: on all of them.
struct PressureAt {
  double value = 0, largest = 0;
  sketch::Point at = {};
};
PressureAt find_pressure(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, sketch::Point near);

Hoop find_hoop(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, size_t first);

} // namespace estimate
