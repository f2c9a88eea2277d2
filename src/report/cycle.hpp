// Where the loads of a run go to and fro.
#pragma once

#include "report/record.hpp"

namespace app {

struct Cycle {
  std::vector<size_t> turns; // steps at which the loads turn back
  size_t first = 0,
         last = 0; // of the last whole cycle: the loads are the same there, and turn once in between; alike: there is none
  bool any() const { return first != last; }
};
Cycle find_cycle(const std::vector<StepRecord>& steps);

} // namespace app
