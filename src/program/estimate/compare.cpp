#include "program/estimate/compare.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kBetween = 0.1; // the weight of states between turns of the loads

// The shape functions of an element with n nodes at equal distances, at eta.
struct Functions {
  double value[4];
  Functions(int32_t n, double eta) {
    for (int32_t i = 0; i < n; ++i) {
      value[i] = 1;
      const double own = n == 1 ? 0 : -1 + 2.0 * i / (n - 1);
      for (int32_t k = 0; k < n; ++k)
        if (const double other = n == 1 ? 1 : -1 + 2.0 * k / (n - 1); k != i && n > 1)
          value[i] *= (eta - other) / (own - other);
    }
  }
};

constexpr double kGauss[3] = {-0.7745966692414834, 0, 0.7745966692414834};
constexpr double kWeight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};

// Values of two states at one point of a body's boundary.
struct Pair {
  double difference[2] = {0, 0}; // |t - t'|, |u - u'|
  double traction = 0;           // |t'|
};

class Comparer {
public:
  Comparer(const Trial& coarse, const Trial& fine, const Overlaps& overlaps);
  Distance run();

private:
  void add(size_t state);
  Pair at(size_t body, const Overlap& o, double eta, size_t state) const;
  void find_zones();
  bool holds_edge(size_t body, const Overlap& o, size_t state) const;

  const Trial &coarse_, &fine_;
  const Overlaps& overlaps_;
  std::vector<std::vector<std::vector<int32_t>>> zones_; // of each body and coarse element
  std::vector<double> largest_;                          // of each zone: of the integral of |t'|
  double work_ = 0;
  std::vector<std::vector<std::vector<double>>> pressure_, energy_; // per state, body and element
  std::vector<std::vector<double>> zone_norm_, zone_difference_;    // per zone and state
};

Comparer::Comparer(const Trial& coarse, const Trial& fine, const Overlaps& overlaps)
    : coarse_(coarse), fine_(fine), overlaps_(overlaps), largest_(coarse.zones.size(), 0.0) {
  find_zones();
}

void Comparer::find_zones() {
  zones_.resize(coarse_.lengths.size());
  for (size_t b = 0; b < zones_.size(); ++b) zones_[b].resize(coarse_.lengths[b].size());
  for (size_t z = 0; z < coarse_.zones.size(); ++z) {
    if (coarse_.tied[z] != 0) continue;
    for (const Side& side : coarse_.zones[z]) {
      auto& of_body = zones_[static_cast<size_t>(side.body)];
      const auto n = static_cast<int32_t>(of_body.size());
      for (int32_t e = side.first;; e = (e + 1) % n) {
        of_body[static_cast<size_t>(e)].push_back(static_cast<int32_t>(z));
        if (e == side.last) break;
      }
    }
  }
}

// Do the ends of an element, of one mesh or the other, differ in status?
bool Comparer::holds_edge(size_t body, const Overlap& o, size_t state) const {
  const std::vector<double>&p = coarse_.states[state].ends[body][kStatus], &q = fine_.states[state].ends[body][kStatus];
  const auto c = static_cast<size_t>(o.coarse * coarse_.nodes), f = static_cast<size_t>(o.fine * fine_.nodes);
  for (size_t i = 1; i < static_cast<size_t>(coarse_.nodes); ++i)
    if (p[c + i] != p[c] || q[f + i] != q[f]) return true;
  return false;
}

Pair Comparer::at(size_t body, const Overlap& o, double eta, size_t state) const {
  const auto place = [&](double from, double to) { return from + (to - from) * (1 + eta) / 2; };
  const Functions c(coarse_.nodes, place(o.from, o.to)), f(fine_.nodes, place(o.fine_from, o.fine_to));
  const auto& p = coarse_.states[state].ends[body];
  const auto& q = fine_.states[state].ends[body];
  double a[4] = {}, b[4] = {};
  for (size_t k = 0; k < 4; ++k) {
    for (int32_t i = 0; i < coarse_.nodes; ++i) a[k] += c.value[i] * p[k][static_cast<size_t>(o.coarse * coarse_.nodes + i)];
    for (int32_t i = 0; i < fine_.nodes; ++i) b[k] += f.value[i] * q[k][static_cast<size_t>(o.fine * fine_.nodes + i)];
  }
  Pair out;
  out.difference[0] = std::hypot(a[kTx] - b[kTx], a[kTy] - b[kTy]);
  out.difference[1] = std::hypot(a[kUx] - b[kUx], a[kUy] - b[kUy]);
  out.traction = std::hypot(b[kTx], b[kTy]);
  return out;
}

void Comparer::add(size_t state) {
  std::vector<double> norm(coarse_.zones.size(), 0), off(coarse_.zones.size(), 0);
  std::vector<std::vector<double>> pressure, energy;
  for (size_t b = 0; b < overlaps_.size(); ++b) {
    pressure.push_back(std::vector<double>(coarse_.lengths[b].size(), 0.0));
    energy.push_back(pressure.back());
    for (const Overlap& o : overlaps_[b]) {
      const auto e = static_cast<size_t>(o.coarse);
      const double half = coarse_.lengths[b][e] * (o.to - o.from) / 4;
      for (int g = 0; g < 3; ++g) {
        const Pair p = at(b, o, kGauss[g], state);
        const double w = half * kWeight[g];
        if (!zones_[b][e].empty()) pressure[b][e] += w * p.difference[0];
        energy[b][e] += w * p.difference[0] * p.difference[1];
        for (const int32_t z : zones_[b][e]) {
          norm[static_cast<size_t>(z)] += w * p.traction;
          off[static_cast<size_t>(z)] += w * p.difference[0];
        }
      }
    }
  }
  for (size_t z = 0; z < norm.size(); ++z) {
    largest_[z] = std::max(largest_[z], norm[z]);
    zone_norm_[z].push_back(norm[z]);
    zone_difference_[z].push_back(off[z]);
  }
  work_ = std::max({work_, std::fabs(fine_.states[state].work), std::fabs(fine_.states[state].elastic)});
  pressure_.push_back(std::move(pressure));
  energy_.push_back(std::move(energy));
}

Distance Comparer::run() {
  Distance out;
  zone_norm_.resize(coarse_.zones.size());
  zone_difference_.resize(coarse_.zones.size());
  const size_t common = std::min(coarse_.states.size(), fine_.states.size());
  for (size_t state = 0; state < common; ++state) add(state);
  for (const auto& lengths : coarse_.lengths) out.shares.push_back(std::vector<Share>(lengths.size()));
  for (size_t state = 0; state < common; ++state) {
    const double weight = fine_.states[state].turn || state + 1 == common ? 1 : kBetween;
    double sum = 0;
    for (size_t b = 0; b < overlaps_.size() && weight == 1; ++b)
      for (const Overlap& o : overlaps_[b])
        if (!zones_[b][static_cast<size_t>(o.coarse)].empty() && holds_edge(b, o, state))
          out.shares[b][static_cast<size_t>(o.coarse)].edge = true;
    for (size_t b = 0; b < out.shares.size(); ++b)
      for (size_t e = 0; e < out.shares[b].size(); ++e) {
        Share& share = out.shares[b][e];
        double largest = 0;
        for (const int32_t z : zones_[b][e]) largest = std::max(largest, largest_[static_cast<size_t>(z)]);
        if (largest > 0) share.pressure = std::max(share.pressure, weight * pressure_[state][b][e] / largest);
        if (work_ > 0) share.energy = std::max(share.energy, weight * energy_[state][b][e] / work_);
        sum += energy_[state][b][e];
      }
    if (work_ > 0) out.energy = std::max(out.energy, weight * sum / work_);
  }
  for (size_t z = 0; z < largest_.size(); ++z) {
    out.pressure.push_back(0);
    out.states.push_back({});
    for (size_t state = 0; state < common; ++state) {
      const double relative = largest_[z] > 0 ? zone_difference_[z][state] / largest_[z] : 0;
      out.states[z].push_back(relative);
      if (fine_.states[state].turn || state + 1 == common) out.pressure[z] = std::max(out.pressure[z], relative);
    }
  }
  return out;
}

} // namespace

Overlaps overlaps_of_halves(const Trial& coarse) {
  Overlaps out;
  for (const auto& lengths : coarse.lengths) {
    out.push_back({});
    for (int32_t e = 0; e < static_cast<int32_t>(lengths.size()); ++e)
      for (int32_t half = 0; half < 2; ++half) out.back().push_back({e, 2 * e + half, -1.0 + half, 0.0 + half, -1, 1});
  }
  return out;
}

Distance distance(const Trial& coarse, const Trial& fine, const Overlaps& overlaps) {
  return Comparer(coarse, fine, overlaps).run();
}

} // namespace estimate
