// All outputs of a run: opened before the work, published together after it.
#pragma once

#include "program/files/figure_folder.hpp"
#include "program/files/output_file.hpp"
#include "program/options.hpp"

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
  bool has(Output output) const { return files[static_cast<size_t>(output)].is_open(); }
  std::string& text(Output output) { return file(output).text; } // append here

  // Opens the requested outputs; the listing goes to standard output by default, unless another output
  // does.
  bool open(const Options& options, bool has_points, std::string& error);
  // For the file beside every table.
  void write_inputs(const std::string& all);
  // Writes what has gathered.
  bool flush(std::string& error);
  // As publish_all, and keeps the folders.
  bool publish(std::string& error);
};

// Reports two outputs with one file, an output that is also an input, or a file in a folder of the run itself. Empty: no
// conflict. `also_read`: files that the deck names.
std::string find_clash(const Options& options, const std::vector<std::string>& also_read = {});

} // namespace app
