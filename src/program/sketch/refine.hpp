// Meshes made finer: elements bisected on the true curves, both sides of a contact alike.
#pragma once

#include "program/sketch/place_ends.hpp"

namespace sketch {

// Of every body, per element in the order of the deck, how often it is to be bisected.
using Levels = std::vector<std::vector<int>>;

// Neighbours become at most three times as long; what faces an element of side 2 is as long as it. Then ends go to `spots`.
Mesh refined(const Sketch& sketch, const Mesh& mesh, const Levels& levels, const std::vector<Spot>& spots = {});
// Every element in two.
Mesh halved(const Sketch& sketch, const Mesh& mesh);

// Element ends of side 0 of a contact where those of side 1 face it, as far as they do.
void align(size_t contact, Mesh& mesh);

int elements_of(const Mesh& mesh); // of all bodies

} // namespace sketch
