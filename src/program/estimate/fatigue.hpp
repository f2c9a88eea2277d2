// Fatigue parameters requested by a sketch, from the stresses of the last cycle on one mesh.
#pragma once

#include "post/mesh_loop.hpp"
#include "program/estimate/trial.hpp"
#include "program/sketch/mesh.hpp"

namespace estimate {

// The requests to solutions for these parameters, but for the places below a surface, which depend on the mesh: ask_below().
// They lie below the place of the largest value along the curves; the sketch and the mesh are referred to.
void ask_for_cycle(const sketch::Sketch& sketch, CycleDemand& demand);
void ask_below(const sketch::Sketch& sketch, const sketch::Mesh& mesh, CycleDemand& demand);

// The parameters requested along curves, at all of their nodes, for pictures.
std::vector<app::FatigueLine> fatigue_lines(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial);

// What smaller values of stresses and displacements are: round-off.
struct LeastSizes {
  double stress, motion;
};

// The values of all requests, in their order; none if the history ended before the cycle did. Throws a sketch::Fault if a place
// below a surface is outside the body.
class FatigueValues {
public:
  FatigueValues(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial)
      : sketch_(sketch), mesh_(mesh), trial_(trial) {}
  // Call it for all requests of fatigue parameters in their order.
  void add(const sketch::Want& want, const LeastSizes& least, double tolerance, std::vector<app::Stated>& out);

private:
  const sketch::Sketch& sketch_;
  const sketch::Mesh& mesh_;
  const Trial& trial_;
  size_t points_ = 0, below_ = 0; // used so far
};

} // namespace estimate
