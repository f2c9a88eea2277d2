// Stress states of one material point at the corners of a load cycle: between two of them every stress is linear in the load.
#pragma once

#include <vector>

namespace app {

struct StressState {
  double xx = 0, yy = 0, xy = 0, zz = 0;
};
inline StressState operator+(const StressState& a, const StressState& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy, a.zz + b.zz};
}
inline StressState operator*(double f, const StressState& a) { return {f * a.xx, f * a.yy, f * a.xy, f * a.zz}; }
using StressCycle = std::vector<StressState>;

} // namespace app
