// The outcome of a run with responses, written to --results and --row.
#pragma once

#include "program/options.hpp"
#include "report/inputs.hpp"

#include <string>
#include <vector>

namespace app {

struct Answer {
  int exit = 0;
  std::vector<double> values; // of the responses; undefined after a failure
  std::string reason;         // why it failed
  Inputs inputs;              // no files: it failed before they were read
};

// Writes --results and appends to --row, with the inputs of both beside regular files. False with an error text.
bool write_answer(const Options& options, const Answer& answer, std::string& error);

// "ok", or "FAIL" and the reason.
std::string outcome_of(const Answer& answer);

// Appends a row to a CSV file, as one write, under a lock; a new file gets the heading before it, one with another heading is
// refused. Beside a regular file the inputs of its rows are kept. False with an error text.
bool append_row(const std::string& file, const std::string& heading, const std::string& row, const Inputs& inputs,
                std::string& error);

} // namespace app
