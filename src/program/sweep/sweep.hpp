// `contact2d sweep TABLE DECK`: a run for every row of a table, in one process.
#pragma once

#include "program/options.hpp"

namespace app {

// Returns the exit status: 0 if all rows were run, also if some failed; the rows have the reasons.
int sweep_table(const Options& options);

} // namespace app
