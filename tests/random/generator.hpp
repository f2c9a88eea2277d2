#pragma once
// A random model: what bodies, how they meet, how they are held, how they are loaded. The seed tells all of it.
#include "../problem.hpp"

#include <cstdint>
#include <string>

namespace random_decks {

struct Model {
  problem::Problem problem;
  std::string title;          // kind and seed
  bool same_surfaces = false; // both bodies have the same points in contact: they may be exchanged
  bool any_angle = false;     // no condition holds a single component
  bool symmetric = false;     // about x = 0; so are the loads of case 1
  bool proportional = false;  // everything touches without load, and the first load card is of one case
};

Model generate(uint64_t seed);
// Few pairs, all of which touch at zero load, friction up to 3: every set of statuses can be tried.
Model generate_few_pairs(uint64_t seed);
// Bodies that are pressed together, moved along each other, lifted off and put back, in two load cases; in some directions only
// contact holds them.
Model generate_lifted(uint64_t seed);
// Symmetric bodies that are pressed together along their axis, then often pushed to and fro by a second load case.
Model generate_symmetric(uint64_t seed);

} // namespace random_decks
