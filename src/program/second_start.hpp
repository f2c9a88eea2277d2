// The cycles of a load path followed once more, from a start without friction, for comparison.
#pragma once

#include "program/estimate/trial.hpp"
#include "report/record.hpp"

#include <string>

namespace app {

// Gives each coefficient that has reached its last load the end of the other start. `digits`: to which the cycles are steady.
// `demand`: the limits of the run.
void compare_starts(const std::string& deck, int32_t digits, const estimate::Demand& demand, RunRecord& record);

// The deck with `frictionless` in place of `compare` on its card `cycle`.
std::string with_other_start(const std::string& deck);

} // namespace app
