// Coulomb friction round the axis on given pressures: stick and slip of every pair along a path of load factors (METHOD 21.10).
// Tractions are tau = load * factors + stiffness * slip with |tau| <= limit. As the limits do not change, the state of a path
// is piecewise linear, and its rates solve a linear complementarity problem with one solution.
#pragma once

#include "post/torsion/twist_body.hpp"

#include <functional>

namespace app {

struct SlipProblem {
  TwistMatrix stiffness, load; // a row per pair; columns: pairs, load cases
  std::vector<double> limit;   // above 0; infinite: the pair never slips
};

struct SlipState {
  std::vector<double> factors;
  std::vector<double> slip, traction; // of each pair
  std::vector<int> status;            // 0: sticks; 1, -1: slips, the sign of its traction
};

class SlipPath {
public:
  explicit SlipPath(const SlipProblem& problem);
  // Follows the straight path from the present factors to `target`; `at_event` is called at every change of status. False: the
  // path ends before, because a body turns through: slip without more load. `state` is then the last one reached.
  bool go_to(const std::vector<double>& target, const std::function<void(const SlipState&)>& at_event);
  const SlipState& state() const { return state_; }
  double residual() const; // of the tractions, relative to the largest

private:
  bool find_rates(const std::vector<double>& direction);
  bool exchange(size_t pair);
  void refresh();
  double rate(size_t pair, const std::vector<double>& direction) const;
  bool is_at_limit(size_t pair) const;

  const SlipProblem& problem_;
  SlipState state_;
  TwistMatrix table_;       // rates of what is not given, a row per pair; columns: pairs, load cases
  std::vector<char> slips_; // per pair: its slip depends on the others; else its traction
  std::vector<double> scale_;
};

} // namespace app
