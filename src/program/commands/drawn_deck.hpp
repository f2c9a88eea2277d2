// Sketches given in place of decks: reports their errors with line and column, and replaces the sketch by its deck.
#pragma once

#include "post/mesh_loop.hpp"
#include "program/estimate/trial_keeper.hpp"
#include "program/files/deck_file.hpp"
#include "program/files/named_text.hpp"
#include "program/files/store_choice.hpp"
#include "program/options.hpp"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace app {

// How a sketch becomes a deck.
struct Drawing {
  const std::vector<std::string>& settings; // parameters, such as "mu=0.3"
  bool adapts = true;                       // false: use the first mesh
  uint64_t memory = 0;                      // workspace of the runs of mesh refinement; 0: chosen by size
  bool shows = false;                       // print a line on standard error for every mesh
  bool ends_in_results = false;             // after a signal, use the best mesh so far, if any
  // Called with the files named by the sketch, before any work: returns an error message, or an empty string.
  std::function<std::string(const std::vector<std::string>& read)> find_clash = {};
  // Contents of the files named by the sketch, in place of those on disk; null: read from disk.
  const std::vector<NamedText>* files = nullptr;
  // Called before mesh refinement with the files of the sketch: returns an exit status, 0 to continue. `keeper` stores solved
  // meshes; null: none are stored.
  std::function<int(const std::vector<NamedText>& files)> before_search = {};
  estimate::TrialKeeper* keeper = nullptr;
  // Filled with the decks of the coarsest and the finest mesh that a search for 1 % is expected to end with. Null: not asked
  // for.
  std::vector<std::string>* expected = nullptr;
  StoreChoice* store = nullptr; // for the tapes of the meshes (estimate::Demand)
  bool tolerances = false;      // find derivatives by parameters with tolerances
};

// If the text of `deck` is a sketch, replaces it by the deck of the sketch and records the mesh refinement in `loop`. Prints
// errors. Returns the exit status of the program, 0 to continue.
int take_sketch(DeckFile& deck, const Drawing& drawing, MeshLoop& loop);

// The parameters of a deck or a sketch that --set may name.
std::set<std::string> parameters_of(const DeckFile& deck);

// Values of its parameters with these settings ("mu=0.3"), as a run would use them; empty if they cannot be read.
std::vector<std::pair<std::string, std::string>> parameters_used(const DeckFile& deck,
                                                                 const std::vector<std::string>& settings);

// The command mesh: writes the deck of a sketch. Returns the exit status.
int write_mesh(const Options& options);

} // namespace app
