// The table of a sweep: a heading that names parameters, and a row of values for each run.
#pragma once

#include "program/messages.hpp"

#include <set>
#include <string>
#include <vector>

namespace app {

struct SweepTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows; // as many values as there are names
};

// Reads a CSV file whose columns are among `parameters`; blank lines count for nothing. Every fault is reported with its place
// to `messages`; false after any, and if there is no row.
bool read_table(const DeckFile& file, const std::set<std::string>& parameters, Messages& messages, SweepTable& table);

} // namespace app
