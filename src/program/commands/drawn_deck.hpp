// A sketch where a deck may stand: its faults told at their places, its deck put in its place.
#pragma once

#include "post/stated.hpp"
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
  const std::vector<std::string>& settings; // "mu=0.3", for its parameters
  bool adapts = true;                       // no: the first mesh will do
  uint64_t memory = 0;                      // workspace of the runs that find the mesh; 0: chosen by size
  bool shows = false;                       // a line on standard error for every mesh
  bool ends_in_results = false; // a signal ends the search for a mesh: the best one so far is taken, if there is one
  // Told the files that the sketch names before any work: says what is wrong with them; empty: nothing.
  std::function<std::string(const std::vector<std::string>& read)> find_clash = {};
  // Files that it names, in place of those that are there now; null: these.
  const std::vector<NamedText>* files = nullptr;
  // Before the search for a mesh, with the sketch's files: an exit status, 0 to go on. And where meshes that are solved are
  // kept; null: nowhere.
  std::function<int(const std::vector<NamedText>& files)> before_search = {};
  estimate::TrialKeeper* keeper = nullptr;
  StoreChoice* store = nullptr; // for the tapes of the meshes (estimate::Demand)
};

// If the text of `deck` is a sketch it is replaced by the sketch's own deck, and `loop` tells how its mesh was found. Prints
// what is wrong and returns the program's exit status, 0 to go on.
int take_sketch(DeckFile& deck, const Drawing& drawing, MeshLoop& loop);

// What --set may name: parameters of a deck or a sketch.
std::set<std::string> parameters_of(const DeckFile& deck);

// The command mesh: writes the deck of a sketch. Returns the exit status.
int write_mesh(const Options& options);

} // namespace app
