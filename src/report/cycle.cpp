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

namespace {

bool records_cycle(const CoefficientRecord& c) {
  return !c.cycle_start.empty() && c.outcome == C2D_REACHED && c.steps.size() > 1 &&
         c.steps.back().step > c.cycle_start[0].step && c.steps.front().step <= c.cycle_start[0].step;
}

// The last step before the recorded cycle.
size_t before_cycle(const CoefficientRecord& c) {
  size_t out = 0;
  while (c.steps[out + 1].step <= c.cycle_start[0].step) ++out;
  return out;
}

} // namespace

Cycle find_cycle(const CoefficientRecord& c) {
  Cycle out = find_cycle(c.steps);
  if (records_cycle(c)) out.first = before_cycle(c), out.last = c.steps.size() - 1;
  return out;
}

std::vector<const StepRecord*> steps_of_loop(const CoefficientRecord& c) {
  std::vector<const StepRecord*> out;
  for (const StepRecord& step : c.steps) out.push_back(&step);
  if (records_cycle(c)) out[before_cycle(c)] = &c.cycle_start[0];
  return out;
}

std::vector<const StepRecord*> steps_of_cycle(const CoefficientRecord& c) {
  if (!records_cycle(c)) return {};
  std::vector<const StepRecord*> out = steps_of_loop(c);
  out.erase(out.begin(), out.begin() + static_cast<ptrdiff_t>(before_cycle(c)));
  return out;
}

} // namespace app
