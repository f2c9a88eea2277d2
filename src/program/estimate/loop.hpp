// From a sketch to a mesh on which every number that is wanted has its stated error below its tolerance.
#pragma once

#include "post/stated.hpp"
#include "program/estimate/trial.hpp"
#include "program/estimate/trial_keeper.hpp"
#include "program/sketch/mesh.hpp"

#include <functional>

namespace estimate {

struct Adapted {
  sketch::Sketch sketch; // that the mesh refers to, with the order of functions that was chosen
  sketch::Mesh mesh;
  std::string deck; // of the mesh
  app::MeshLoop loop;
  c2d_status status = C2D_OK; // a failure of the first meshes: there is no result
  std::string why;
};

// Follows the whole history on each mesh (METHOD 16.5). `demand` has what the sketch wants (estimate::ask). `told` hears of
// every mesh that was solved. Meshes that `keeper` has are not solved again; null: none is kept. Throws sketch::Fault.
Adapted adapt(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& told,
              TrialKeeper* keeper = nullptr);

// The model of a deck, which a solver holds, beside the one with every element in two: errors of the deck's own numbers.
// `loop.stopped` says why there are none.
app::MeshLoop estimate_deck(c2d_solver* solver, const std::string& deck, const Demand& demand);

} // namespace estimate
