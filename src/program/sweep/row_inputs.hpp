// The file of inputs beside the rows of --row, which many runs append to.
#pragma once

#include "report/inputs.hpp"

#include <string>

namespace app {

// The text of the file after row number `row` is added, from 1. `there` is the text before, empty before the first row. A line
// "row = 7" means that what follows applies from the seventh row on; before it, and where there is none, the rows have the
// files, options and build in common. Parameters are those that these rows have in common.
std::string inputs_of_rows(const std::string& there, const Inputs& inputs, size_t row);

} // namespace app
