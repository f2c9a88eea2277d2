// Torsion of the bodies of a sketch on one mesh, on the pressures of the last state of its history.
#pragma once

#include "post/mesh_loop.hpp"
#include "post/torsion/twist_system.hpp"
#include "program/estimate/trial.hpp"
#include "program/sketch/refine.hpp"

#include <memory>

namespace estimate {

struct Twisted {
  app::TorsionTable table;
  std::vector<app::Stated> numbers; // without errors, in the same order on every mesh
  // For the comparison with another mesh.
  std::shared_ptr<const void> kept; // what the model refers to
  app::TwistModel model;
  double unit = 1; // of length in the model
  app::TwistField field;
  std::vector<std::vector<const sketch::Curve*>> curves; // per body and element
};

// No results: table.why.
Twisted twist(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial);

// Also marks the elements of `mesh`, that of `coarse`, whose tractions or angles differ most on the finer mesh.
void mark_torsion(const sketch::Sketch& sketch, const Twisted& coarse, const Twisted& fine, const sketch::Mesh& mesh,
                  sketch::Levels& levels);

} // namespace estimate
