#include "report/history.hpp"

#include <cmath>

namespace app {
namespace {

// The energies of a step, for a header that has them and for one that does not.
template <class Step>
auto append_energy(std::vector<EnergyPoint>& out, const Step& s, int)
    -> decltype(s.work + s.dissipated + s.elastic + s.energy_defect, void()) {
  out.push_back({s.load, s.work, s.dissipated, s.elastic, s.energy_defect});
}
template <class Step> void append_energy(std::vector<EnergyPoint>&, const Step&, long) {}

bool is_kept(int32_t step, int32_t steps) {
  for (int32_t quarter = 1; quarter <= 3; ++quarter)
    if (step < steps && step == (static_cast<int64_t>(steps) * quarter + 2) / 4) return true;
  return false;
}

} // namespace

void History::note(const c2d_step& step) {
  const size_t index = step.coefficient > 0 ? static_cast<size_t>(step.coefficient) - 1 : 0;
  if (coefficients_.size() <= index) coefficients_.resize(index + 1);
  CoefficientHistory& c = coefficients_[index];
  c.mu = step.mu;
  PathPoint now;
  now.step = step.step;
  now.kind = step.kind;
  now.load = step.load;
  now.events = (c.points.empty() ? 0 : c.points.back().events) + (step.kind == C2D_STEP_CHANGE ? 1 : 0);
  const size_t pairs = static_cast<size_t>(step.pairs);
  const bool keep_status = status_bytes_ + pairs <= kMostStatusBytes;
  if (keep_status) now.status.resize(pairs);
  for (size_t p = 0; p < pairs; ++p) {
    const double* row = step.table + static_cast<int64_t>(p) * step.stride;
    const int status = static_cast<int>(row[C2D_STATUS]);
    if (status >= 0 && status < 3) ++now.count[status];
    if (p == 0 || row[C2D_TN] > now.peak) now.peak = row[C2D_TN];
    if (keep_status) now.status[p] = static_cast<char>(status);
  }
  if (keep_status) status_bytes_ += pairs;
  c.points.push_back(now);
  if (step.kind == C2D_STEP_CHANGE) return;
  append_energy(c.energy, step, 0);
  if (step.kind != C2D_STEP_RECORDED || !is_kept(step.step, steps_)) return;
  Snapshot kept;
  kept.step = step.step;
  kept.load = step.load;
  for (size_t p = 0; p < pairs; ++p) {
    const double* row = step.table + static_cast<int64_t>(p) * step.stride;
    kept.table.insert(kept.table.end(), row, row + C2D_PAIR_FIELDS);
  }
  c.earlier.push_back(kept);
}

} // namespace app
