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
// Of a load path that repeats its cycle until it is steady, the recorded cycle; else as above.
Cycle find_cycle(const CoefficientRecord& coefficient);

// The recorded steps; those of a recorded cycle come after the state at which it begins, which stands in the place of the step
// before them.
std::vector<const StepRecord*> steps_of_loop(const CoefficientRecord& coefficient);
// The recorded cycle alone, with the state at which it begins; empty without one.
std::vector<const StepRecord*> steps_of_cycle(const CoefficientRecord& coefficient);

} // namespace app
