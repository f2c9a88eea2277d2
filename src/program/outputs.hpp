// All outputs of a run: opened before the work, published together after it.
#pragma once

#include "program/figure_folder.hpp"
#include "program/options.hpp"
#include "program/output_file.hpp"

#include <string>

namespace app {

struct Outputs {
  std::array<OutputFile, kOutputs> files; // by Output
  FigureFolder figures;

  OutputFile& file(Output output) { return files[static_cast<size_t>(output)]; }
  bool has(Output output) const { return files[static_cast<size_t>(output)].is_open(); }
  std::string& text(Output output) { return file(output).text; } // append here

  // Opens those that are asked for; the listing goes to standard output by default, unless another output
  // does.
  bool open(const Options& options, std::string& error);
  // Writes what has gathered.
  bool flush(std::string& error);
  // Completes all files, then names them all. On failure no file has appeared.
  bool publish(std::string& error);
};

// Two outputs with one file, or an output that is the deck: says which. Empty: no such thing.
std::string find_clash(const Options& options);

} // namespace app
