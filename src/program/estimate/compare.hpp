// Distance of the solutions on two meshes of one model, in total and by element.
#pragma once

#include "program/estimate/trial.hpp"

namespace estimate {

// A part of the boundary inside one element of each mesh, by local coordinates from -1 to 1 on both.
struct Overlap {
  int32_t coarse, fine; // from 0
  double from, to;      // on the coarse element
  double fine_from, fine_to;
};
using Overlaps = std::vector<std::vector<Overlap>>; // of every body

// Overlaps of a mesh with the mesh of bisected elements.
Overlaps overlaps_of_halves(const Trial& coarse);

// Contribution of a coarse element to the distance, the largest of all states (METHOD 16.5).
struct Share {
  double pressure = 0; // in contacts without a tie: integral of |t' - I t'| over that of |t'| in the zone, METHOD (16.6)
  double energy = 0;   // energy norm of the same difference over the largest work of the states
  bool edge = false;   // it contains a contact edge or a stick border at a turn of the loads
  int touch = 0;       // -1, 1: on the coarse mesh only its first, last end touches at such a turn
};
struct Distance {
  std::vector<std::vector<Share>> shares; // per body and coarse element
  std::vector<double> pressure;           // per zone: relative L1 distance, largest of all turns
  double energy = 0;                      // largest sum of the shares of one state
  std::vector<double> own;                // part of `pressure` caused by the elements of the zone; refinement there reduces it
};
Distance distance(const Trial& coarse, const Trial& fine, const Overlaps& overlaps);

} // namespace estimate
