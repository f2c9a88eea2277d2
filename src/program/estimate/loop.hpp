// Refines the mesh of a sketch until the stated error of every requested number is below its tolerance.
#pragma once

#include "post/mesh_loop.hpp"
#include "program/estimate/trial.hpp"
#include "program/estimate/trial_keeper.hpp"
#include "program/sketch/mesh.hpp"

#include <functional>

namespace estimate {

struct Adapted {
  sketch::Sketch sketch; // referenced by the mesh; with the selected order of functions
  sketch::Mesh mesh;
  std::string deck; // of the mesh
  Trial trial;      // its solution, kept if parameters have tolerances
  app::MeshLoop loop;
  c2d_status status = C2D_OK; // failure on the first mesh: there is no result
  std::string why;
};

// Solves the whole history on each mesh (METHOD 16.5). `demand` has the requests of the sketch (estimate::ask). `report` is
// called for every solved mesh. Meshes stored in `keeper` are not solved again; null: no storage. Throws sketch::Fault.
Adapted adapt(const sketch::Sketch& sketch, const Demand& demand, const std::function<void(const app::MeshRound&)>& report,
              TrialKeeper* keeper = nullptr);

// Errors of the numbers of a deck, from a second solution with every element bisected. `solver` has the model of the deck.
// `stopped` of the result gives the reason if there are none.
app::MeshLoop estimate_deck(c2d_solver* solver, const std::string& deck, const Demand& demand);

} // namespace estimate
