// The zones of the deck: elements of a mesh in contact or tied.
#pragma once

#include "program/sketch/mesh.hpp"

namespace sketch {

// Consecutive elements along an outline, from 1. If last < first, they pass the end of a closed outline.
struct Stretch {
  int first, last, count;
};

// A matching zone has pairs of nodes: the elements of both sides coincide, the first of side 2 with the last of side 1.
struct Zone {
  const Contact* contact;
  Stretch one, two; // contact conditions are imposed at the nodes of the second
  bool matching = false;
  bool whole[2] = {true, true};    // does side 2 begin, end at the ends of the contact?
  bool leaves[2] = {false, false}; // of a matching zone: does the first, last node of side 2 belong to a neighbouring zone?
};

// The elements of a side as stretches without gaps.
std::vector<Stretch> stretches_of(const Mesh& mesh, const Side& side);

// Matching zones first.
std::vector<Zone> zones_of(const Sketch& sketch, const Mesh& mesh);

} // namespace sketch
