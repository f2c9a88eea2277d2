#pragma once
// What every result must satisfy, whatever the solver did to find it.
#include "generator.hpp"

#include <string>
#include <vector>

namespace random_decks {

struct Runs {
  problem::Result changes; // of c2d_run, with every change of status
  problem::Result rows;    // the recorded loads once more, with the boundaries at each; empty for press fits
};

// Sizes of what there is, over the whole path: differences are judged by them.
struct Sizes {
  double traction = 0, displacement = 0, force = 0, length = 0, energy = 0;
};
Sizes sizes_of(const problem::Problem& p, const Runs& runs);

// How far results may miss: that which the condition of the elimination leaves of sixteen digits, at least 1e-8.
double tolerance_of(const problem::Result& result);

// A line per law that is broken.
std::vector<std::string> broken_laws(const Model& model, const Runs& runs);

} // namespace random_decks
