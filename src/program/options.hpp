// The command line.
#pragma once

#include "program/outputs/output_row.hpp"
#include "program/sweep/responses.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace app {

enum class Command { kRun, kCheck, kSketch, kMesh, kResume, kSweep, kConvert, kMake, kCompletion, kHelp, kVersion };
enum class Progress { kAutomatic, kAlways, kNever };

struct Job; // program/commands/job.hpp

struct Options {
  Command command = Command::kHelp;
  std::string deck;
  std::vector<std::string> more_decks;                    // of check
  std::string topic;                                      // of help: a command; empty: all. Of completion: the shell
  std::string folder;                                     // of resume
  std::vector<std::pair<std::string, std::string>> given; // options of run as they were given, with their values
  std::vector<std::string> words;                         // of make: the family and its settings, or --list
  std::vector<std::string> settings;                      // name=value of --set, for parameters
  std::string params;                                     // file of --params
  std::vector<Response> responses;                        // of --response
  std::string results, row;                               // where they go; empty: nowhere
  std::string table;                                      // of sweep
  std::array<std::string, kOutputs> files;                // by Output; empty: not asked for; "-": standard output
  std::string points;                                     // CSV that is read; "-": standard input
  std::string figures;                                    // folder; empty: not asked for
  std::string out;                                        // folder of --out, whose names stand in the others by now
  bool interior_if_any = false;                           // that output, if there are points
  std::string store;                                      // empty: chosen by size; "memory"; "file:DIR"
  std::string convert_to, output; // of convert: empty (the other form), "fixed", "free"; FILE, of mesh and sketch too
  std::string conditions;         // of sketch: the file of --with
  double join = 0;                // of sketch: ends this far apart are one; 0: 1e-6 of the drawing's size
  uint64_t memory = 0;            // workspace bytes; 0: chosen by size
  int32_t threads = 0;            // 0: not said
  int32_t stepping = 0, quadrature = 0, symmetry = 0; // C2D_STEPPING_, C2D_QUADRATURE_, C2D_SYMMETRY_
  int32_t elimination = C2D_ELIMINATION_BY_SIZE;      // C2D_ELIMINATION_
  int32_t touching = -1;                              // of c2d_limits; below 0: chosen by size
  Progress progress = Progress::kAutomatic;
  bool keep = false;
  bool quiet = false;
  double save_every = 2;                   // seconds between states of the path that are saved
  bool resume = false;                     // of sweep
  std::shared_ptr<const std::string> text; // of the deck, for a row of a sweep; null: it is read, and signals stop its solver
  bool estimate = false;                   // of run: solve the halved deck, too
  bool halve = false;                      // of mesh
  std::shared_ptr<const Job> job;          // of resume: what the run was; the factorisation is on the tapes if it came so far

  const std::string& file(Output which) const { return files[static_cast<size_t>(which)]; }
};

// Reads the arguments. On failure says why in `error`.
bool read_options(int argc, const char* const* argv, Options& options, std::string& error);

// "65536", "64K", "16M", "1G", "2T" (powers of 1024, either case, an added B or iB is understood) as bytes.
bool read_size(const std::string& text, uint64_t& bytes);

// Is there a listing? Standard output has it unless something else goes there, or --quiet or --out is given.
bool has_listing(const Options& options);

} // namespace app
