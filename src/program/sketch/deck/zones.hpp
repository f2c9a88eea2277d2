// Which elements of a mesh may touch, or are bonded: the zones of the deck.
#pragma once

#include "program/sketch/mesh.hpp"

namespace sketch {

// Elements one behind the other along an outline, from 1; round the end of a closed one where last < first.
struct Stretch {
  int first, last, count;
};

// Pairs of a matching zone are of nodes: element by element both sides coincide, the first of side 2 with the last of side 1.
struct Zone {
  const Contact* contact;
  Stretch one, two; // contact conditions hold at the nodes of the second
  bool matching = false;
  bool whole[2] = {true, true};    // does side 2 begin, end where that of the contact does?
  bool leaves[2] = {false, false}; // of a matching zone: is the node where side 2 begins, ends, in the pair of a neighbour?
};

// The elements of a side, as stretches without a gap.
std::vector<Stretch> stretches_of(const Mesh& mesh, const Side& side);

// Matching ones first.
std::vector<Zone> zones_of(const Sketch& sketch, const Mesh& mesh);

} // namespace sketch
