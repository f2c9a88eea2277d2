#include "report/cycle.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

bool goes_back(const std::vector<StepRecord>& steps, size_t i) {
  double product = 0;
  for (size_t k = 0; k < steps[i].loads.size(); ++k)
    product += (steps[i].loads[k] - steps[i - 1].loads[k]) * (steps[i + 1].loads[k] - steps[i].loads[k]);
  return product < 0;
}

} // namespace

// It ends at the last reversal, or end, with the same loads as two reversals earlier.
Cycle find_cycle(const std::vector<StepRecord>& steps) {
  Cycle out;
  for (size_t i = 1; i + 1 < steps.size(); ++i)
    if (goes_back(steps, i)) out.turns.push_back(i);
  if (steps.empty()) return out;
  std::vector<size_t> ends = out.turns;
  ends.push_back(steps.size() - 1); // a reversal has a step after it
  for (size_t i = ends.size(); i-- > 2;) {
    double apart = 0, size = 0;
    for (size_t k = 0; k < steps[ends[i]].loads.size(); ++k) {
      apart = std::max(apart, std::fabs(steps[ends[i]].loads[k] - steps[ends[i - 2]].loads[k]));
      size = std::max(size, std::fabs(steps[ends[i]].loads[k]));
    }
    if (apart > 1e-9 * size) continue;
    out.first = ends[i - 2], out.last = ends[i];
    break;
  }
  return out;
}

} // namespace app
