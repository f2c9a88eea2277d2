// Which elements of a mesh may touch, or are bonded: the zones of the deck.
#pragma once

#include "program/sketch/mesh.hpp"

namespace sketch {

// Elements one behind the other along an outline, from 1; round the end of a closed one where last < first.
struct Stretch {
  int first, last, count;
};

struct Zone {
  const Interface* interface;
  Stretch one, two; // contact conditions hold at the nodes of the second
};

// The elements of a side, as stretches without a gap.
std::vector<Stretch> stretches_of(const Mesh& mesh, const Side& side);

// Throws a Fault where the sides of an interface do not face each other anywhere.
std::vector<Zone> zones_of(const Sketch& sketch, const Mesh& mesh);

} // namespace sketch
