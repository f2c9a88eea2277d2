// The outputs of a run that are single files: a row each of one table.
#pragma once

#include <contact2d.h>

#include <array>
#include <cstdint>
#include <string>

namespace app {

// Rows of the table.
enum class Output { kListing, kCsv, kBoundary, kInterior, kJson, kReport, kVtk, kTrace, kBodies, kSummary, kStresses, kRanges };
constexpr size_t kOutputs = 12;

struct RunResults;  // program/outputs/results.hpp
struct StepResults; // same file

// What a run keeps for an output, beyond the last state of every coefficient of friction.
enum OutputNeeds : uint32_t {
  kNeedsChanges = 1,  // steps of all changes of status
  kNeedsSums = 2,     // zones, bodies and key numbers of every step;
  kNeedsLastSums = 4, // of the last one alone
  kNeedsTables = 8,   // the listing has tables of them
  kNeedsCorners = 16, // where stress is singular
  kNeedsPlaces = 32,  // stresses on the boundary and at points, at every recorded step
  kNeedsScene = 64,   // the model and the last state as in a picture;
  kNeedsPictures = 128,
  kNeedsTimes = 256,  // of the whole run: it ends after the outputs without this
  kInputsBeside = 512 // the inputs go into a file beside it
};

struct OutputRow {
  const char* option;
  const char* file; // in the folder of --out; null: not there, as it may be long
  uint32_t needs;   // OutputNeeds
  // Append to `out`; null: nothing. When the model is complete; at every step of c2d_run; after the last. A status that is not
  // C2D_OK ends the run.
  c2d_status (*begin)(RunResults& run, std::string& out);
  void (*step)(RunResults& run, const StepResults& now, std::string& out);
  c2d_status (*end)(RunResults& run, std::string& out);
};
extern const std::array<OutputRow, kOutputs> kOutputTable;

} // namespace app
