// Phases:
//   1. link: nodes of pairs have one angle, but for slip. A pair on the axis, or one that would close a ring of pairs or join
//      two given angles, carries no traction.
//   2. number: unknown angles, tractions where the angle is given, tractions of pairs, and a uniform angle of each body's
//      equations that absorbs the error of collocation, so that torques balance to round-off.
//   3. assemble: an equation per node, the balance of torques per body. Right-hand sides: load cases, slip of each pair.
//   4. reduce: elimination; tractions of the pairs that may slip as functions of load factors and slips.
#include "post/torsion/twist_system.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kOnAxis = 1e-12;  // of the largest radius
constexpr double kNoPivot = 1e-12; // of the largest entry of its row

// Solves in place; false: singular. Rows are scaled to their largest entry, pivots are the largest of their column.
bool solve_dense(TwistMatrix& a, TwistMatrix& b) {
  const size_t n = a.rows;
  for (size_t i = 0; i < n; ++i) {
    double largest = 0;
    for (size_t c = 0; c < n; ++c) largest = std::max(largest, std::fabs(a.row(i)[c]));
    if (!(largest > 0)) return false;
    const double scale = std::ldexp(1.0, -std::ilogb(largest));
    for (size_t c = 0; c < n; ++c) a.row(i)[c] *= scale;
    for (size_t c = 0; c < b.columns; ++c) b.row(i)[c] *= scale;
  }
  for (size_t k = 0; k < n; ++k) {
    size_t best = k;
    for (size_t i = k + 1; i < n; ++i)
      if (std::fabs(a.row(i)[k]) > std::fabs(a.row(best)[k])) best = i;
    if (!(std::fabs(a.row(best)[k]) > kNoPivot)) return false;
    if (best != k)
      std::swap_ranges(a.row(k), a.row(k) + n, a.row(best)), std::swap_ranges(b.row(k), b.row(k) + b.columns, b.row(best));
    const double* top = a.row(k);
    const double* right = b.row(k);
    for (size_t i = k + 1; i < n; ++i) {
      double* row = a.row(i);
      const double factor = row[k] / top[k];
      if (factor == 0) continue;
      for (size_t c = k + 1; c < n; ++c) row[c] -= factor * top[c];
      double* own = b.row(i);
      for (size_t c = 0; c < b.columns; ++c) own[c] -= factor * right[c];
    }
  }
  for (size_t k = n; k-- > 0;) {
    double* own = b.row(k);
    for (size_t c = 0; c < b.columns; ++c) own[c] /= a.row(k)[k];
    for (size_t i = 0; i < k; ++i) {
      const double factor = a.row(i)[k];
      double* row = b.row(i);
      for (size_t c = 0; c < b.columns && factor != 0; ++c) row[c] -= factor * own[c];
    }
  }
  return true;
}

} // namespace

TwistSystem::TwistSystem(const TwistModel& model) : model_(model) {
  size_t count = 0;
  for (const TwistBody& body : model.bodies) first_.push_back(count), count += body.nodes;
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    equations_.push_back(twist_equations(model.bodies[b], model.rigid[b] == 0));
  }
  link();
  number();
  assemble();
  reduce();
}

void TwistSystem::link() {
  double largest = 0;
  size_t count = 0;
  for (const TwistEquations& q : equations_) {
    count += q.at.size();
    for (const Point& p : q.at) largest = std::max(largest, p.x);
  }
  root_.resize(count), offset_.resize(count), known_.resize(count);
  for (size_t i = 0; i < count; ++i) root_[i] = i;
  for (size_t b = 0; b < model_.bodies.size(); ++b)
    for (size_t i = 0; i < model_.bodies[b].nodes; ++i) known_[global(b, i)] = model_.angle[b][i];
  linked_.assign(model_.pairs.size(), 0);
  for (size_t k = 0; k < model_.pairs.size(); ++k) {
    const TwistPair& pair = model_.pairs[k];
    const size_t own = global(pair.body[1], pair.node[1]), other = global(pair.body[0], pair.node[0]);
    if (std::max(equations_[pair.body[1]].at[pair.node[1]].x, equations_[pair.body[0]].at[pair.node[0]].x) <= kOnAxis * largest)
      continue;
    const size_t a = root_[own], b = root_[other];
    if (a == b || (!known_[a].empty() && !known_[b].empty())) continue;
    linked_[k] = 1;
    // angle of own = angle of other + slip of k. The root with a given angle stays one.
    const bool keeps_own = !known_[a].empty();
    const size_t kept = keeps_own ? a : b, joins = keeps_own ? b : a;
    std::vector<Offset> way; // angle of root `joins` less that of root `kept`
    const std::vector<Offset>&of_own = offset_[own], &of_other = offset_[other];
    const double sign = keeps_own ? -1 : 1;
    way.push_back({k, sign});
    for (const Offset& o : of_other) way.push_back({o.pair, sign * o.sign});
    for (const Offset& o : of_own) way.push_back({o.pair, -sign * o.sign});
    for (size_t i = 0; i < count; ++i) {
      if (root_[i] != joins) continue;
      root_[i] = kept;
      offset_[i].insert(offset_[i].end(), way.begin(), way.end());
    }
  }
}

void TwistSystem::number() {
  const size_t count = root_.size();
  angle_at_.assign(count, -1), held_at_.assign(count, -1);
  pair_at_.assign(model_.pairs.size(), -1), slip_at_ = pair_at_;
  twist_at_.assign(model_.bodies.size(), -1);
  const auto next = [this] { return static_cast<int64_t>(unknowns_++); };
  double largest = 0;
  for (const TwistEquations& q : equations_)
    for (const Point& p : q.at) largest = std::max(largest, p.x);
  for (size_t b = 0; b < model_.bodies.size(); ++b) {
    const TwistBody& body = model_.bodies[b];
    for (size_t i = 0; i < body.nodes; ++i) {
      const size_t g = global(b, i), root = root_[g];
      if (known_[root].empty() && angle_at_[root] < 0) angle_at_[root] = next();
    }
    if (model_.rigid[b] != 0) continue;
    twist_at_[b] = next();
    for (size_t e = 0; e < model_.ends[b].size(); ++e) {
      const size_t node = body.elements[e / (body.order + 1)].node[e % (body.order + 1)], g = global(b, node);
      if (model_.ends[b][e].kind == TwistEnd::kHeld && held_at_[g] < 0 && equations_[b].at[node].x > kOnAxis * largest)
        held_at_[g] = next();
    }
  }
  for (size_t k = 0; k < model_.pairs.size(); ++k) {
    if (linked_[k] == 0) continue;
    pair_at_[k] = next();
    if (std::isfinite(model_.pairs[k].limit)) slip_at_[k] = static_cast<int64_t>(may_slip_.size()), may_slip_.push_back(k);
  }
}

void TwistSystem::add_node(double* row, double* right, size_t body, size_t node, double factor) const {
  const size_t g = global(body, node), root = root_[g];
  if (angle_at_[root] >= 0) row[angle_at_[root]] += factor;
  for (size_t c = 0; c < known_[root].size(); ++c) right[c] -= factor * known_[root][c];
  for (const Offset& o : offset_[g])
    if (slip_at_[o.pair] >= 0) right[model_.cases + static_cast<size_t>(slip_at_[o.pair])] -= factor * o.sign;
}

void TwistSystem::add_end(double* row, double* right, size_t body, size_t end, double factor) const {
  const TwistBody& own = model_.bodies[body];
  const TwistEnd& e = model_.ends[body][end];
  if (e.kind == TwistEnd::kPair && pair_at_[e.pair] >= 0) {
    const TwistPair& pair = model_.pairs[e.pair];
    const size_t node = own.elements[end / (own.order + 1)].node[end % (own.order + 1)];
    row[pair_at_[e.pair]] += pair.body[1] == body && pair.node[1] == node ? factor : -factor;
  }
  if (e.kind == TwistEnd::kHeld) {
    const size_t g = global(body, own.elements[end / (own.order + 1)].node[end % (own.order + 1)]);
    if (held_at_[g] >= 0) row[held_at_[g]] += factor;
  }
  for (size_t c = 0; c < e.traction.size(); ++c) right[c] -= factor * e.traction[c];
}

void TwistSystem::assemble() {
  const size_t columns = model_.cases + may_slip_.size();
  matrix_ = TwistMatrix(unknowns_, unknowns_), right_ = TwistMatrix(unknowns_, columns);
  size_t row = 0;
  for (size_t b = 0; b < model_.bodies.size(); ++b) {
    if (model_.rigid[b] != 0) continue;
    const TwistBody& body = model_.bodies[b];
    const TwistEquations& q = equations_[b];
    for (size_t i = 0; i < body.nodes; ++i) {
      // A given angle on the axis: there is no traction that its equation could determine.
      const size_t g = global(b, i);
      if (!model_.angle[b][i].empty() && held_at_[g] < 0) continue;
      if (row == unknowns_) return void(singular_ = true);
      double *at = matrix_.row(row), *right = right_.row(row);
      for (size_t k = 0; k < body.nodes; ++k) add_node(at, right, b, k, q.phi.row(i)[k]);
      for (size_t e = 0; e < q.torque.size(); ++e) add_end(at, right, b, e, -q.tau.row(i)[e] / body.modulus);
      at[twist_at_[b]] += 1;
      ++row;
    }
    if (row == unknowns_) return void(singular_ = true);
    for (size_t e = 0; e < q.torque.size(); ++e) add_end(matrix_.row(row), right_.row(row), b, e, q.torque[e]);
    ++row;
  }
  singular_ = row != unknowns_;
}

void TwistSystem::reduce() {
  singular_ = singular_ || !solve_dense(matrix_, right_);
  if (singular_) return;
  matrix_ = TwistMatrix(0, 0);
  const size_t n = may_slip_.size();
  problem_ = {TwistMatrix(n, n), TwistMatrix(n, model_.cases), {}};
  for (size_t i = 0; i < n; ++i) {
    const double* from = right_.row(static_cast<size_t>(pair_at_[may_slip_[i]]));
    std::copy_n(from, model_.cases, problem_.load.row(i));
    std::copy_n(from + model_.cases, n, problem_.stiffness.row(i));
    problem_.limit.push_back(model_.pairs[may_slip_[i]].limit);
  }
}

TwistField TwistSystem::field(const SlipState& state) const {
  const auto of = [&](int64_t unknown) {
    if (unknown < 0) return 0.0;
    const double* row = right_.row(static_cast<size_t>(unknown));
    double sum = 0;
    for (size_t c = 0; c < model_.cases; ++c) sum += row[c] * state.factors[c];
    for (size_t k = 0; k < state.slip.size(); ++k) sum += row[model_.cases + k] * state.slip[k];
    return sum;
  };
  const auto given = [&](const std::vector<double>& values) {
    double sum = 0;
    for (size_t c = 0; c < values.size(); ++c) sum += values[c] * state.factors[c];
    return sum;
  };
  TwistField out;
  for (size_t k = 0; k < model_.pairs.size(); ++k)
    out.pair.push_back(slip_at_[k] >= 0 ? state.traction[static_cast<size_t>(slip_at_[k])] : of(pair_at_[k]));
  for (size_t b = 0; b < model_.bodies.size(); ++b) {
    const TwistBody& body = model_.bodies[b];
    out.angle.emplace_back(), out.traction.emplace_back();
    for (size_t i = 0; i < body.nodes; ++i) {
      const size_t g = global(b, i);
      double angle = angle_at_[root_[g]] >= 0 ? of(angle_at_[root_[g]]) : given(known_[root_[g]]);
      for (const Offset& o : offset_[g])
        if (slip_at_[o.pair] >= 0) angle += o.sign * state.slip[static_cast<size_t>(slip_at_[o.pair])];
      out.angle.back().push_back(angle);
    }
    for (size_t e = 0; e < model_.ends[b].size(); ++e) {
      const size_t node = body.elements[e / (body.order + 1)].node[e % (body.order + 1)];
      const TwistEnd& end = model_.ends[b][e];
      double tau = given(end.traction);
      if (end.kind == TwistEnd::kHeld) tau = of(held_at_[global(b, node)]);
      if (end.kind == TwistEnd::kPair) {
        const TwistPair& pair = model_.pairs[end.pair];
        tau = pair.body[1] == b && pair.node[1] == node ? out.pair[end.pair] : -out.pair[end.pair];
      }
      out.traction.back().push_back(tau);
    }
  }
  return out;
}

} // namespace app
