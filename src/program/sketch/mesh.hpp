// Elements on the curves of a sketch, and the deck made of them.
#pragma once

#include "program/sketch/sketch.hpp"

#include <utility>

namespace sketch {

struct MeshedCurve {
  const Curve* curve;
  Measure measure;
  std::vector<double> ends; // of the elements: lengths from the curve's begin, 0 and its whole length included
  std::vector<std::pair<double, double>> far; // lengths between which nothing of a side 2 comes near the other side
  bool given = false;                         // are the elements those of a statement, or of what faces them?
  size_t elements() const { return ends.size() - 1; }
};
struct MeshedOutline {
  bool open = false;
  std::vector<MeshedCurve> curves;
  size_t elements() const;
};
// Of every body its outlines, open ones first. It refers to the sketch.
struct Mesh {
  std::vector<std::vector<MeshedOutline>> bodies;
  bool given = false; // by statements `elements`: the deck has its elements without the true curves
};

// Do contact conditions hold at the nodes of a curve?
bool holds_pairs(const Sketch& sketch, const Curve& curve);

// Elements that follow curvature, and become smaller towards corners, in thin walls and narrow gaps. `fineness`: 1; 2 has
// elements of half the size.
constexpr double kWithoutSearch = 2; // fineness of a mesh that no tolerance asks for
Mesh first_mesh(const Sketch& sketch, double fineness);
// The mesh that is taken without a search: as the statements `elements` divide the curves; others as the first mesh does.
Mesh given_mesh(const Sketch& sketch);

// The deck, in the free form. Throws a Fault where the statements of a sketch do not go together.
std::string deck_of(const Sketch& sketch, const Mesh& mesh);

} // namespace sketch
