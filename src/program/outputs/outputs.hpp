// All outputs of a run: opened before the work, published together after it.
#pragma once

#include "program/files/figure_folder.hpp"
#include "program/files/output_file.hpp"
#include "program/options.hpp"
#include "program/outputs/output_row.hpp"

#include <string>
#include <vector>

namespace app {

struct Outputs {
  FigureFolder out;                        // that of --out; it is made before, and goes after, what is in it
  std::array<OutputFile, kOutputs> files;  // by Output
  std::array<OutputFile, kOutputs> inputs; // beside the tables: NAME.inputs
  FigureFolder figures;
  bool shows_end_alone = false; // only the summary of the listing: terminal, without --listing

  OutputFile& file(Output output) { return files[static_cast<size_t>(output)]; }
  uint32_t needs() const; // OutputNeeds of all

  // Opens the requested outputs; the listing goes to standard output by default, unless another output
  // does.
  bool open(const Options& options, bool has_points, std::string& error);
  // What each writes when the model is complete, at a step of c2d_run, and after the last (OutputRow). Statuses are those of
  // the first that failed: C2D_ERR_CALLBACK with an error text for a file.
  c2d_status begin(RunResults& run);
  void step(RunResults& run, const StepResults& now);
  c2d_status end(RunResults& run, std::string& error);
  // Writes what has gathered.
  bool flush(std::string& error);
  // As publish_all, and keeps the folders.
  bool publish(std::string& error);
};

// Reports two outputs with one file, an output that is also an input, or a file in a folder of the run itself. Empty: no
// conflict. `also_read`: files that the deck names.
std::string find_clash(const Options& options, const std::vector<std::string>& also_read = {});

} // namespace app
