#pragma once
// The first loading of a model with few pairs that all touch without load: every set of statuses is tried on equations of
// its own (elastic.hpp). Everything is proportional to the load there.
#include "generator.hpp"

#include <string>
#include <vector>

namespace random_decks {

struct Solution {
  std::vector<int> status;    // per pair: C2D_OPEN, C2D_STICK, C2D_SLIP; slip with the sign of friction
  std::vector<double> forces; // tn, tt per pair at load 1
  double margin;              // least slack of the inequalities, of the largest of their kind
  double pivot;               // smallest over largest
};

struct Trial {
  bool done = false;           // the model is of the kind
  std::vector<Solution> found; // distinct ones
  double no_force = 0;         // 1e-6 of it is none in any of them
  int32_t clear() const;       // those beyond doubt
};

// `frames`: a row of the library's results for this model, of which only frames and nodes are used.
Trial try_statuses(const Model& model, const problem::Step& frames);

// Empty, or what the library says against the trial.
std::string against_trial(const Model& model, const Trial& trial, const problem::Result& deck, bool warned);

// Largest residual of the equations of both bodies, over the largest term, at least a thousandth of what the largest
// displacement makes. Passed over are bodies with holes, and one to which a contact passes that is no polynomial there.
double elastic_residual(const Model& model, const problem::Step& row);

} // namespace random_decks
