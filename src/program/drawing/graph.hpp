// Curves as edges between joints, and the faces between them.
#pragma once

#include "program/drawing/drawing.hpp"

#include <array>

namespace drawing {

// Of curve i the half edge 2i runs along it, 2i + 1 backwards.
struct Graph {
  std::vector<Curve> curves; // none is whole; their ends are at joints
  std::vector<std::array<size_t, 2>> ends;
  std::vector<Point> joints;
  std::vector<double> moved; // how far each end was from its joint

  size_t start(size_t half) const { return ends[half / 2][half % 2]; }
  size_t stop(size_t half) const { return ends[half / 2][1 - half % 2]; }
  void keep(const std::vector<bool>& kept); // only these curves
};

// Joins ends that are nearer than `tolerance`. Where lines meet other curves they give way.
Graph graph_of(std::vector<Curve> curves, double tolerance);

// How many ends of curves are at each joint.
std::vector<int> degrees(const Graph& graph);

// Every half edge belongs to one cycle, with a face on its left.
std::vector<std::vector<size_t>> faces_of(const Graph& graph);

// The joints that are connected, by a number each.
std::vector<size_t> parts_of(const Graph& graph);

} // namespace drawing
