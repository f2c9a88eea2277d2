// Stresses along the surface of a body on one mesh: at the nodes, and at edges of slipping contacts. There the stress has a
// peak that nodal values do not resolve.
#pragma once

#include "post/fatigue/states.hpp"
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

// The stresses of one place of the surface over the last cycle, at a node or at an edge of a slipping contact.
struct SurfaceCycle {
  sketch::Point at, along;                    // the place; the unit vector along the surface, with the material on the left
  const sketch::MeshedCurve* curve = nullptr; // containing it
  double length = 0, element = 0;             // along this curve; the length of its element
  app::StressCycle cycle, other;              // `other`: with stresses larger by their doubt; empty: without a doubt
  int way = 0;
};
// All of these curves, those at edges last.
std::vector<SurfaceCycle> surface_cycles(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side,
                                         double poisson_ratio);

// A pair on the curves: the largest friction, the range of slip while it touches, and the largest stress along the surface,
// over the last cycle.
struct RubbedPlace {
  sketch::Point at;
  const sketch::MeshedCurve* curve;
  double length, element; // as in SurfaceCycle
  double friction, slip, along;
};
std::vector<RubbedPlace> rubbed_places(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side);

// The same of the stress out of the plane, at the nodes.
Hoop find_zz(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, size_t first);
Hoop find_hoop(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, size_t first);

} // namespace estimate
