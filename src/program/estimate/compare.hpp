// Two meshes of one model: how far their states are apart, element by element.
#pragma once

#include "program/estimate/trial.hpp"

namespace estimate {

// A stretch of boundary that lies in one element of either mesh: between local coordinates -1 ... 1 of both.
struct Overlap {
  int32_t coarse, fine; // from 0
  double from, to;      // on the coarse element
  double fine_from, fine_to;
};
using Overlaps = std::vector<std::vector<Overlap>>; // of every body

// Of a mesh and the one with every element in two.
Overlaps overlaps_of_halves(const Trial& coarse);

// What an element of the coarse mesh adds to the distance, the largest of all states (METHOD 16.5).
struct Share {
  double pressure = 0; // integral of what it cannot follow of |t'|, if it is part of a contact that is no tie, over the zone's
  double energy = 0;   // of what the element cannot follow of the finer mesh, over the largest work of the states
  bool edge = false;   // a contact edge or a stick border lies in it at a turn of the loads
};
struct Distance {
  std::vector<std::vector<Share>> shares; // per body and coarse element
  std::vector<double> pressure;           // of each zone: relative, L1, the largest of the turns
  double energy = 0;                      // sum of the shares of the state where it is largest
  std::vector<double> own;                // of `pressure` what a zone's elements cannot follow: finer ones there mend it
};
Distance distance(const Trial& coarse, const Trial& fine, const Overlaps& overlaps);

} // namespace estimate
