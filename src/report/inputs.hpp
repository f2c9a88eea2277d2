// What a run was made from, for its outputs: files, parameters, options, version and build.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace app {

struct InputFile {
  std::string name, sha256;
};

struct Inputs {
  std::vector<InputFile> files;                                // the deck or sketch first
  std::vector<std::pair<std::string, std::string>> parameters; // with the values used
  std::vector<std::string> options;                            // that can change a digit, as words
};

// The compiler and the kind of machine of this program.
std::string build_text();

// A number with as many digits as it takes to read the same bits.
std::string exact_number(double value);

// Key and value of each input: version, build, file, sha256 (of the file before), parameter, option.
std::vector<std::pair<std::string, std::string>> rows_of(const Inputs& inputs);

// A line each, for a file beside a table: the table's name with this ending.
constexpr char kInputsEnding[] = ".inputs";
std::string inputs_text(const Inputs& inputs);

void append_inputs(std::string& listing, const Inputs& inputs);

} // namespace app
