// Reversals and cycles of the loads of a run.
#pragma once

#include "report/record.hpp"

namespace app {

struct Cycle {
  std::vector<size_t> turns; // steps at which the loads reverse
  size_t first = 0,
         last = 0; // of the last complete cycle: equal loads, with one reversal in between; first = last: there is none
  bool any() const { return first != last; }
};
Cycle find_cycle(const std::vector<StepRecord>& steps);

} // namespace app
