#include "spence.hpp"

#include "../family_runs.hpp"

#include <algorithm>
#include <cmath>

namespace random_decks {

namespace {

constexpr double kPi = 3.14159265358979323846;

// Ends of elements on [0, 1], smaller and smaller towards both ends.
std::vector<double> graded_ends() {
  constexpr double kGrowth = 0.09, kLargest = 0.008;
  std::vector<double> half; // distances from an end
  for (double d = 0.5; d > 1e-7; d -= std::min(kGrowth * d, kLargest)) half.push_back(d);
  std::vector<double> ends = {0};
  for (size_t i = half.size(); i-- > 1;)
    if (half[i] > 1e-4) ends.push_back(half[i]);
  for (double d : half) ends.push_back(1 - d);
  ends.push_back(1);
  return ends;
}

double x_log(double x) { return x == 0 ? 0 : x * std::log(std::fabs(x)); }

class HalfPlane {
public:
  HalfPlane() : ends_(graded_ends()), n_(ends_.size() - 1) {}
  size_t elements() const { return n_; }
  double end(size_t k) const { return ends_[k]; }
  // Does the state with k sticking elements overstep the cone at the last of them?
  bool oversteps(double mu, double beta, size_t k) const;

private:
  double middle(size_t i) const { return 0.5 * (ends_[i] + ends_[i + 1]); }
  // Of ln|x - s| over element j, with its mirror image added or taken off.
  double potential(double x, size_t j, double sign) const {
    const double a = ends_[j], b = ends_[j + 1];
    return x_log(x - a) - x_log(x - b) - (b - a) + sign * (x_log(x + b) - x_log(x + a) - (b - a));
  }
  // Of element j's constant from 0 to x.
  double covered(double x, size_t j) const { return std::max(0.0, std::min(x, ends_[j + 1]) - ends_[j]); }

  const std::vector<double> ends_;
  const size_t n_;
};

// Rows of n + k equations and a right-hand side, by partial pivoting.
std::vector<double> solve_rows(std::vector<std::vector<double>>& a) {
  const size_t n = a.size();
  for (size_t k = 0; k < n; ++k) {
    size_t row = k;
    for (size_t i = k + 1; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[row][k])) row = i;
    std::swap(a[k], a[row]);
    for (size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (size_t j = k; j <= n && factor != 0; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::vector<double> x(n);
  for (size_t k = n; k-- > 0;) {
    double sum = a[k][n];
    for (size_t j = k + 1; j < n; ++j) sum -= a[k][j] * x[j];
    x[k] = sum / a[k][k];
  }
  return x;
}

// u_z is the same everywhere, u_x that of the middle on the first k elements, q = mu p on the others (outward friction);
// unknown are p, and q on the first k. Displacements in units of 2 (1 - nu^2) / E.
bool HalfPlane::oversteps(double mu, double beta, size_t k) const {
  const size_t size = n_ + k;
  std::vector<std::vector<double>> a(size, std::vector<double>(size + 1, 0));
  const auto add = [&](std::vector<double>& row, double x, double sign, bool normal) {
    for (size_t j = 0; j < n_; ++j) {
      const double by_p = normal ? -potential(x, j, 1) / kPi : -beta * covered(x, j);
      const double by_q = normal ? beta * covered(x, j) : -potential(x, j, -1) / kPi;
      row[j] += sign * (by_p + (j < k ? 0 : mu * by_q));
      if (j < k) row[n_ + j] += sign * by_q;
    }
  };
  for (size_t i = 0; i + 1 < n_; ++i) add(a[i], middle(i + 1), 1, true), add(a[i], middle(i), -1, true);
  for (size_t j = 0; j < n_; ++j) a[n_ - 1][j] = 2 * (ends_[j + 1] - ends_[j]);
  a[n_ - 1][size] = 1;
  for (size_t i = 0; i < k; ++i) add(a[n_ + i], middle(i), 1, false);
  for (std::vector<double>& row : a) {
    double largest = 0;
    for (double value : row) largest = std::max(largest, std::fabs(value));
    for (double& value : row) value /= largest;
  }
  const std::vector<double> x = solve_rows(a);
  return x[n_ + k - 1] > mu * x[k - 1];
}

} // namespace

double spence_border(double mu, double nu) {
  const HalfPlane plane;
  const double beta = (1 - 2 * nu) / (2 * (1 - nu));
  size_t low = 0, high = plane.elements();
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    (plane.oversteps(mu, beta, middle) ? high : low) = middle;
  }
  return low == 0 ? 0 : plane.end(low);
}

bool Punch::border_within_a_node() const { return solved && border >= node_below - 1e-12 && border <= node_above + 1e-12; }

Punch solve_punch(double mu, double nu) {
  Punch out = {mu, nu};
  const families_test::Solution s =
      families_test::solve("punch", {families_test::setting("mu", mu), families_test::setting("nu", nu)});
  out.message = s.error;
  out.solved = s.error.empty() && !s.steps.empty();
  if (!out.solved) return out;
  const std::vector<families_test::Row>& rows = s.last();
  size_t last = 0;
  for (size_t i = 0; i < rows.size(); ++i)
    if (rows[i].status == C2D_STICK) last = i;
  const size_t next = std::min(last + 1, rows.size() - 1);
  out.sticks = rows[last].x, out.slips = rows[next].x;
  out.node_below = last > 0 ? rows[last - 1].x : 0;
  out.node_above = rows[std::min(next + 1, rows.size() - 1)].x;
  return out;
}

std::vector<Punch> all_punches() {
  std::vector<Punch> all;
  for (double nu : {0.0, 0.1, 0.2, 0.3, 0.35, 0.4, 0.45})
    for (double mu : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.0}) all.push_back({mu, nu});
  return all;
}

} // namespace random_decks
