// The mesh of a sketch and the deck generated from it.
#pragma once

#include "program/sketch/sketch.hpp"

#include <utility>

namespace sketch {

struct MeshedCurve {
  const Curve* curve;
  Measure measure;
  std::vector<double> ends; // of the elements: lengths from the start of the curve, including 0 and its total length
  std::vector<std::pair<double, double>> far; // ranges of length that the other side never comes near
  bool given = false;                         // are the elements given by a statement, or copied from the facing side?
  size_t elements() const { return ends.size() - 1; }
};
struct MeshedOutline {
  bool open = false;
  std::vector<MeshedCurve> curves;
  size_t elements() const;
};
// The meshed outlines of every body, open ones first. The mesh refers to the sketch.
struct Mesh {
  std::vector<std::vector<MeshedOutline>> bodies;
  bool given = false; // by statements `elements`: the deck then has no exact curves for elastic bodies
};

// Are contact conditions imposed at the nodes of a curve?
bool holds_pairs(const Sketch& sketch, const Curve& curve);

// Element sizes follow curvature and decrease towards corners, in thin walls and in narrow gaps. Sizes are proportional to
// 1 / `fineness`.
constexpr double kWithoutSearch = 2; // fineness of a mesh without refinement
Mesh first_mesh(const Sketch& sketch, double fineness);
// The mesh without refinement: curves are divided by statements `elements`, all others as in the first mesh.
Mesh given_mesh(const Sketch& sketch);

// The deck in free form. Throws a Fault if statements of the sketch contradict each other.
std::string deck_of(const Sketch& sketch, const Mesh& mesh);

} // namespace sketch
