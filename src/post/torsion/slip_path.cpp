// A tableau with a row and a column per pair: the row of a pair that sticks gives the rate of its traction, that of one that
// slips the rate of its slip. A change of status exchanges both. Phases of a step:
//   1. find_rates: of the pairs at their limits choose those that slip, by principal pivoting. The matrix is positive definite,
//      so the choice is unique, and taking the first pair of the wrong sign ends (Murty, 1974).
//   2. Go on to the nearest load at which a pair that sticks reaches its limit.
#include "post/torsion/slip_path.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kAtLimit = 1e-12;    // of the limit
constexpr double kNoRate = 1e-11;     // of the largest rate of a traction: its sign is round-off
constexpr double kNoStiffness = 1e-9; // of a pair alone: what is left of it when a body turns through
constexpr int kExchangesToRefresh = 400;

} // namespace

SlipPath::SlipPath(const SlipProblem& problem)
    : problem_(problem), table_(0, 0), slips_(problem.limit.size(), 0), scale_(problem.limit.size(), 0) {
  const size_t n = problem.limit.size();
  state_.factors.assign(problem.load.columns, 0);
  state_.slip.assign(n, 0), state_.traction.assign(n, 0), state_.status.assign(n, 0);
  refresh();
  for (size_t i = 0; i < n; ++i) scale_[i] = std::fabs(problem.stiffness.row(i)[i]);
}

// The tableau from the beginning, for the same pairs.
void SlipPath::refresh() {
  const size_t n = problem_.limit.size(), cases = problem_.load.columns;
  const std::vector<char> slips = slips_;
  table_ = TwistMatrix(n, n + cases);
  for (size_t i = 0; i < n; ++i) {
    std::copy_n(problem_.stiffness.row(i), n, table_.row(i));
    std::copy_n(problem_.load.row(i), cases, table_.row(i) + n);
    slips_[i] = 0;
  }
  for (size_t i = 0; i < n; ++i)
    if (slips[i] != 0 && !exchange(i)) slips_[i] = 0;
}

// Exchanges traction and slip of a pair. False: it has no stiffness left, a body turns through.
bool SlipPath::exchange(size_t pair) {
  const size_t n = problem_.limit.size(), columns = table_.columns;
  double* own = table_.row(pair);
  const double pivot = own[pair];
  if (slips_[pair] == 0 && !(pivot > kNoStiffness * scale_[pair])) return false;
  for (size_t c = 0; c < columns; ++c) own[c] = c == pair ? 1 / pivot : -own[c] / pivot;
  for (size_t i = 0; i < n; ++i) {
    if (i == pair) continue;
    double* row = table_.row(i);
    const double factor = row[pair];
    row[pair] = 0;
    if (factor == 0) continue;
    for (size_t c = 0; c < columns; ++c) row[c] += factor * own[c];
  }
  slips_[pair] = slips_[pair] == 0;
  return true;
}

double SlipPath::rate(size_t pair, const std::vector<double>& direction) const {
  const double* load = table_.row(pair) + problem_.limit.size();
  double sum = 0;
  for (size_t c = 0; c < direction.size(); ++c) sum += load[c] * direction[c];
  return sum;
}

bool SlipPath::is_at_limit(size_t pair) const {
  return std::fabs(state_.traction[pair]) >= (1 - kAtLimit) * problem_.limit[pair];
}

// A pair at its limit with the traction of sign q slips with q dw <= 0, or sticks with q dtau <= 0.
bool SlipPath::find_rates(const std::vector<double>& direction) {
  const size_t n = problem_.limit.size();
  double largest = 0;
  for (size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (size_t c = 0; c < direction.size(); ++c) sum += problem_.load.row(i)[c] * direction[c];
    largest = std::max(largest, std::fabs(sum));
  }
  const size_t most = 20 * n + 100;
  for (size_t step = 0; step < most; ++step) {
    size_t worst = n;
    double most_wrong = 0;
    for (size_t i = 0; i < n; ++i) {
      if (slips_[i] == 0 && !is_at_limit(i)) continue;
      const double q = state_.traction[i] > 0 ? 1 : -1;
      const double wrong = q * rate(i, direction) / (slips_[i] != 0 ? largest / scale_[i] : largest);
      if (!(wrong > kNoRate) || !(wrong > most_wrong)) continue;
      worst = i, most_wrong = wrong;
      if (step > 2 * n) break; // the first in order from here on
    }
    if (worst == n) return true;
    if (!exchange(worst)) return false;
  }
  return true;
}

bool SlipPath::go_to(const std::vector<double>& target, const std::function<void(const SlipState&)>& at_event) {
  const size_t n = problem_.limit.size();
  const std::vector<double> from = state_.factors;
  std::vector<double> direction(target.size());
  for (size_t c = 0; c < target.size(); ++c) direction[c] = target[c] - from[c];
  double done = 0;
  for (int events = 0;; ++events) {
    if (events % kExchangesToRefresh == kExchangesToRefresh - 1) refresh();
    const bool goes_on = find_rates(direction);
    for (size_t i = 0; i < n; ++i) state_.status[i] = slips_[i] == 0 ? 0 : state_.traction[i] > 0 ? 1 : -1;
    if (events > 0) at_event(state_);
    if (!goes_on) return false;
    if (done >= 1) return true;
    double step = 1 - done;
    size_t next = n;
    std::vector<double> rates(n);
    for (size_t i = 0; i < n; ++i) {
      rates[i] = rate(i, direction);
      if (slips_[i] != 0 || rates[i] == 0 || (is_at_limit(i) && rates[i] * state_.traction[i] > 0)) continue;
      const double room = (rates[i] > 0 ? problem_.limit[i] : -problem_.limit[i]) - state_.traction[i];
      if (room / rates[i] < step) step = std::max(0.0, room / rates[i]), next = i;
    }
    for (size_t i = 0; i < n; ++i) (slips_[i] != 0 ? state_.slip : state_.traction)[i] += step * rates[i];
    if (next < n) state_.traction[next] = std::copysign(problem_.limit[next], state_.traction[next]);
    done = next < n ? done + step : 1;
    for (size_t c = 0; c < target.size(); ++c) state_.factors[c] = next < n ? from[c] + done * direction[c] : target[c];
    if (next == n) return true;
  }
}

double SlipPath::residual() const {
  const size_t n = problem_.limit.size();
  double worst = 0, largest = 0;
  for (size_t i = 0; i < n; ++i) {
    double sum = -state_.traction[i];
    for (size_t c = 0; c < state_.factors.size(); ++c) sum += problem_.load.row(i)[c] * state_.factors[c];
    for (size_t j = 0; j < n; ++j) sum += problem_.stiffness.row(i)[j] * state_.slip[j];
    worst = std::max(worst, std::fabs(sum));
    largest = std::max(largest, std::fabs(state_.traction[i]));
  }
  return largest > 0 ? worst / largest : worst;
}

} // namespace app
