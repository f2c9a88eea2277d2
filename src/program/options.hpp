// The command line.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace app {

enum class Command { kRun, kCheck, kSketch, kMesh, kConvert, kMake, kResume, kVersion, kHelp };
enum class Progress { kAutomatic, kAlways, kNever };

// Outputs that are single files. Each is named here and in kOutputTable (options.cpp), nowhere else.
enum class Output { kListing, kCsv, kBoundary, kInterior, kJson, kReport, kVtk, kTrace, kBodies, kSummary };
struct OutputName {
  const char* option;
  const char* help;
};
constexpr size_t kOutputs = 10;
extern const std::array<OutputName, kOutputs> kOutputTable; // in the order of Output

struct Options {
  Command command = Command::kHelp;
  std::string deck;
  std::string deck_name;                                  // what the reports call it, if not `deck`
  std::string folder;                                     // of resume
  std::vector<std::pair<std::string, std::string>> given; // options of run as they were given, with their values
  std::vector<std::string> words;                         // of make: the family and its settings, or --list
  std::vector<std::string> settings;                      // name=value of --set, for the parameters of a sketch
  std::array<std::string, kOutputs> files;                // by Output; empty: not asked for; "-": standard output
  std::string points;                                     // CSV that is read; "-": standard input
  std::string figures;                                    // folder; empty: not asked for
  std::string store;                                      // empty: chosen by size; "memory"; "file:DIR"
  std::string convert_to, output; // of convert: empty (the other form), "fixed", "free"; FILE, of mesh and sketch too
  std::string conditions;         // of sketch: the file of --with
  double join = 0;                // of sketch: ends this far apart are one; 0: 1e-6 of the drawing's size
  uint64_t memory = 0;            // workspace bytes; 0: chosen by size
  int32_t threads = 1;
  int32_t stepping = 0, quadrature = 0, symmetry = 0; // C2D_STEPPING_, C2D_QUADRATURE_, C2D_SYMMETRY_
  Progress progress = Progress::kAutomatic;
  bool keep = false;
  bool estimate = false; // of run: solve the halved deck, too
  bool halve = false;    // of mesh
  bool resume = false;   // take the factorisation from the tapes if it is there

  const std::string& file(Output which) const { return files[static_cast<size_t>(which)]; }
};

// Reads the arguments. On failure says why in `error`.
bool read_options(int argc, const char* const* argv, Options& options, std::string& error);

// "65536", "64K", "16M", "1G", "2T" (powers of 1024, either case, an added B or iB is understood) as bytes.
bool read_size(const std::string& text, uint64_t& bytes);

// Is there a listing? Standard output has it unless something else goes there.
bool has_listing(const Options& options);

// What --help prints.
std::string help_text();

} // namespace app
