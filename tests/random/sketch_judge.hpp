#pragma once
// A sketch taken through the loop over meshes, and what it states held against a mesh four times finer, order one higher.
#include "post/mesh_loop.hpp"

#include <string>
#include <vector>

namespace random_sketches {

struct Limits {
  int elements = 300;
  double seconds = 10; // of the loop; 0: none
  int of_truth = 700;  // elements: the mesh is halved as often as it stays below them, at most twice
};

struct Compared {
  app::Stated stated;
  double truth = 0;      // the value on the other mesh
  double off = 0;        // how far it is from there; of places by position
  bool is_wrong() const; // the true error is above the stated one, and not nothing at all
  double ratio() const { return stated.error / off; }
};

struct Judged {
  std::string fault;                        // the sketch, or the deck made of it, was not taken: neither may happen
  std::string failure;                      // of the first mesh: told to the user, with no result
  std::string ended;                        // why the history ended early
  std::string stopped;                      // why the loop did; empty: all tolerances are met
  std::string silent;                       // a tolerance is not met and nothing is said
  std::string no_truth;                     // why the other mesh has no result
  int rounds = 0, elements = 0, halved = 0; // halved: how often, for the truth
  double seconds = 0, seconds_of_truth = 0;
  double energy = 0; // distance of the energy of the last two meshes
  int order = 1;     // of functions
  std::vector<Compared> numbers;
};

Judged judge(const std::string& text, const Limits& limits);

} // namespace random_sketches
