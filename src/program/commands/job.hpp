// The job of a run, stored in one file in the folder of its store, so that `resume` can continue after a crash: all inputs.
#pragma once

#include "post/mesh_loop.hpp"
#include "program/files/named_text.hpp"
#include "program/options.hpp"
#include "report/inputs.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

enum class JobForm {
  kDeck,
  kMade,  // a deck generated from a sketch
  kSketch // a sketch whose mesh is not complete yet
};

struct Job {
  JobForm form = JobForm::kDeck;
  std::string begun;                 // local time
  std::string deck_name, deck;       // name in messages; text
  std::vector<std::string> settings; // of a sketch,
  std::vector<NamedText> files;      // and what it names
  bool has_points = false;           // --points,
  std::string points;                // its text
  uint64_t workspace = 0;            // bytes used; for a sketch the requested bytes
  std::vector<std::string> words;    // of the command line: options whose values need no file, names of outputs made absolute
  Inputs inputs;                     // for the outputs
  MeshLoop meshes;                   // how the deck's mesh was found, with stated errors
};

// The command-line words of those options that the job itself does not contain.
std::vector<std::string> words_of(const Options& options);

// Those that can change a digit of a result: not outputs, threads and stores.
std::vector<std::string> words_that_change_digits(const Options& options);

// What a run reads: its deck with the parameters, and `points`, the text of --points. A resumed run has the inputs of the run
// that began.
Inputs inputs_of(const Options& options, const Inputs& of_deck, const std::string& points);

// Identifies a job.
std::string id_of(const Job& job);

// Stores the job in the folder of a store, replacing any other job. False with an error text on failure.
bool keep_job(const std::string& store_folder, const Job& job, std::string& error);

// The job in the store of options.folder, and options as they were, for run_deck; what the command line says of progress stays.
// 0, or the program's exit status with an error text: there is none, or none that is whole.
int find_job(Options& options, std::string& error);

// Is this job still stored? Call it with the folder locked.
bool is_kept(const std::string& store_folder, const Job& job);

// Removes saved states of the path and solved meshes. Missing files are no failure, in both functions.
bool remove_way(const std::string& store_folder, std::string& error);
bool remove_job(const std::string& store_folder, std::string& error);

} // namespace app
