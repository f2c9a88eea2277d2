// Mesh refinement: elements are bisected on the exact curves, on both sides of a contact.
#pragma once

#include "program/sketch/place_ends.hpp"

namespace sketch {

// How an element is refined: bisected `level` times into equal parts, or, with `toward` -1 or 1, each time only the part at its
// first or last end, beside a singular point.
struct Bisection {
  int level = 0;
  int toward = 0;
};
// Of every element, per body in the order of the deck.
using Levels = std::vector<std::vector<Bisection>>;

// Refines elements by `levels`, then limits the ratio of neighbouring lengths to 3, moves element ends to `spots`, and aligns
// the first side of each contact with the second.
Mesh refined(const Sketch& sketch, const Mesh& mesh, const Levels& levels, const std::vector<Spot>& spots = {});
// Bisects every element.
Mesh halved(const Sketch& sketch, const Mesh& mesh);

// Moves the element ends of side 0 of a contact opposite those of side 1, within the facing part.
void align(size_t contact, Mesh& mesh);

int elements_of(const Mesh& mesh); // of all bodies

} // namespace sketch
