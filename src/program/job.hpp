// What a run keeps in the folder of its store so that `resume` can go on after a crash: all that it was asked for, in one file.
#pragma once

#include "post/stated.hpp"
#include "program/named_text.hpp"
#include "program/options.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

enum class JobForm {
  kDeck,
  kMade,  // a deck that was made of a sketch
  kSketch // whose mesh is not found yet
};

struct Job {
  JobForm form = JobForm::kDeck;
  std::string begun;                 // local time
  std::string deck_name, deck;       // as messages call it; its text
  std::vector<std::string> settings; // of a sketch,
  std::vector<NamedText> files;      // and what it names
  bool has_points = false;           // --points,
  std::string points;                // its text
  uint64_t workspace = 0;            // bytes that were taken; of a sketch those asked for
  std::vector<std::string> words;    // of the command line: options whose values need no file, names of outputs made absolute
  MeshLoop meshes;                   // how the deck's mesh was found, with stated errors
};

// The words that say again what `options` say, of what does not stand in the job itself.
std::vector<std::string> words_of(const Options& options);

// Tells a job from others.
std::string id_of(const Job& job);

// Into the folder of a store, safely, in place of any other job. False with an error text on failure.
bool keep_job(const std::string& store_folder, const Job& job, std::string& error);

// The job in the store of options.folder, and options as they were, for run_deck; what the command line says of progress stays.
// 0, or the program's exit status with an error text: there is none, or none that is whole.
int find_job(Options& options, std::string& error);

// Is it still this one? Asked when the folder is locked.
bool is_kept(const std::string& store_folder, const Job& job);

// What a run has kept of its way: states of the path, meshes that were solved. None there is no failure, in both.
bool remove_way(const std::string& store_folder, std::string& error);
bool remove_job(const std::string& store_folder, std::string& error);

} // namespace app
