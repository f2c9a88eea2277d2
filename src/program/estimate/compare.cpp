// The distance of two meshes of one model and the share of each coarse element in it, METHOD (16.6). Phases:
//   1. For every state and element, interpolate both solutions at Gauss points of the overlaps of elements.
//   2. Integrate |t - t'| and |t'| over contacts, and the part of u' and t' that the coarse element cannot represent.
//   3. Take the largest value of all states; states between turns of the loads have the weight kBetween.
#include "program/estimate/compare.hpp"

#include "program/estimate/mesh/functions.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kBetween = 0.1; // weight of states between turns of the loads

constexpr double kGauss[3] = {-0.7745966692414834, 0, 0.7745966692414834};
constexpr double kWeight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};

// Displacements and tractions (the first four fields) at a point.
using Values = std::array<double, kStatus>;

// The finer state at the nodes of a coarse element.
using Nodal = std::array<Values, 4>;

double length_of(const Values& a, const Values& b, size_t first) {
  return std::hypot(a[first] - b[first], a[first + 1] - b[first + 1]);
}

// Integrals of one state, per body and element and per zone.
struct Sums {
  std::vector<std::vector<double>> pressure, energy;
  std::vector<double> norm, off, own;
};

class Comparer {
public:
  Comparer(const Trial& coarse, const Trial& fine, const Overlaps& overlaps);
  Distance run();

private:
  void add(size_t state);
  void add_overlap(size_t body, const Overlap& o, const Nodal& nodes, size_t state, Sums& sums);
  Values coarse_at(size_t body, int32_t element, double eta, size_t state) const;
  Values fine_at(size_t body, const Overlap& o, double eta, size_t state) const;
  Nodal nodal(size_t body, const Overlap* first, const Overlap* last, size_t state) const;
  void find_zones();
  bool holds_edge(size_t body, const Overlap& o, size_t state) const;
  int touching_end(size_t body, size_t element, size_t state) const;

  const Trial &coarse_, &fine_;
  const Overlaps& overlaps_;
  std::vector<std::vector<std::vector<int32_t>>> zones_; // of each body and coarse element
  std::vector<double> largest_;                          // per zone: largest integral of |t'|
  double work_ = 0;
  std::vector<std::vector<std::vector<double>>> pressure_, energy_; // per state, body and element
  std::vector<std::vector<std::array<double, 2>>> zone_difference_; // per zone and state: total, and part of its own elements
};

// Forces of contacts below this are the round-off of the motions.
constexpr double kOfRoundOff = 1e-10;
double least_force(const Trial& trial) {
  double out = 0;
  for (const State& state : trial.states)
    for (size_t b = 0; b < state.ends.size(); ++b)
      for (const Field f : {kUx, kUy})
        for (const double u : state.ends[b][f]) out = std::max(out, kOfRoundOff * trial.stiffness[b] * std::fabs(u));
  return out;
}

Comparer::Comparer(const Trial& coarse, const Trial& fine, const Overlaps& overlaps)
    : coarse_(coarse), fine_(fine), overlaps_(overlaps), largest_(coarse.zones.size(), least_force(fine)) {
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

// Do the two ends of an element differ in contact status on either mesh?
bool Comparer::holds_edge(size_t body, const Overlap& o, size_t state) const {
  const std::vector<double>&p = coarse_.states[state].ends[body][kStatus], &q = fine_.states[state].ends[body][kStatus];
  const auto c = static_cast<size_t>(o.coarse * coarse_.nodes), f = static_cast<size_t>(o.fine * fine_.nodes);
  for (size_t i = 1; i < static_cast<size_t>(coarse_.nodes); ++i)
    if (p[c + i] != p[c] || q[f + i] != q[f]) return true;
  return false;
}

// Of a coarse element: -1, 1: only its first, last end touches, or 0.
int Comparer::touching_end(size_t body, size_t element, size_t state) const {
  const auto nodes = static_cast<size_t>(coarse_.nodes);
  const double* status = coarse_.states[state].ends[body][kStatus].data() + element * nodes;
  return static_cast<int>(status[nodes - 1] > 0) - static_cast<int>(status[0] > 0);
}

Values values_at(const std::array<std::vector<double>, kFields>& ends, int32_t element, int32_t nodes, double eta) {
  const Functions f(nodes, eta);
  Values out{};
  for (size_t k = 0; k < out.size(); ++k)
    for (int32_t i = 0; i < nodes; ++i) out[k] += f.value[i] * ends[k][static_cast<size_t>(element * nodes + i)];
  return out;
}

Values Comparer::coarse_at(size_t body, int32_t element, double eta, size_t state) const {
  return values_at(coarse_.states[state].ends[body], element, coarse_.nodes, eta);
}

// `eta` on the coarse element.
Values Comparer::fine_at(size_t body, const Overlap& o, double eta, size_t state) const {
  const double f = o.fine_from + (o.fine_to - o.fine_from) * (eta - o.from) / (o.to - o.from);
  return values_at(fine_.states[state].ends[body], o.fine, fine_.nodes, f);
}

Nodal Comparer::nodal(size_t body, const Overlap* first, const Overlap* last, size_t state) const {
  Nodal out{};
  for (int32_t i = 0; i < coarse_.nodes; ++i) {
    const double eta = coarse_.nodes == 1 ? 0 : -1 + 2.0 * i / (coarse_.nodes - 1);
    const Overlap* o = first;
    while (o + 1 < last && eta > o->to) ++o;
    out[static_cast<size_t>(i)] = fine_at(body, *o, eta, state);
  }
  return out;
}

void Comparer::add_overlap(size_t b, const Overlap& o, const Nodal& nodes, size_t state, Sums& sums) {
  const auto e = static_cast<size_t>(o.coarse);
  const double length = coarse_.lengths[b][e], half = length * (o.to - o.from) / 4, stiffness = coarse_.stiffness[b];
  for (int g = 0; g < 3; ++g) {
    const double eta = o.from + (o.to - o.from) * (1 + kGauss[g]) / 2, w = half * kWeight[g];
    const Values coarse = coarse_at(b, o.coarse, eta, state), fine = fine_at(b, o, eta, state);
    const Functions f(coarse_.nodes, eta);
    Values follows{};
    for (int32_t i = 0; i < coarse_.nodes; ++i)
      for (size_t k = 0; k < follows.size(); ++k) follows[k] += f.value[i] * nodes[static_cast<size_t>(i)][k];
    const double u = length_of(fine, follows, kUx), t = length_of(fine, follows, kTx);
    sums.energy[b][e] += w * (stiffness * u * u / length + length * t * t / stiffness);
    const double off = length_of(coarse, fine, kTx);
    if (!zones_[b][e].empty()) sums.pressure[b][e] += w * t;
    for (const int32_t z : zones_[b][e]) {
      sums.norm[static_cast<size_t>(z)] += w * std::hypot(fine[kTx], fine[kTy]);
      sums.off[static_cast<size_t>(z)] += w * off;
      sums.own[static_cast<size_t>(z)] += w * t;
    }
  }
}

void Comparer::add(size_t state) {
  Sums sums;
  sums.norm.assign(coarse_.zones.size(), 0), sums.off = sums.own = sums.norm;
  for (const auto& lengths : coarse_.lengths) sums.pressure.push_back(std::vector<double>(lengths.size(), 0.0));
  sums.energy = sums.pressure;
  for (size_t b = 0; b < overlaps_.size(); ++b) {
    const Overlap *const end = overlaps_[b].data() + overlaps_[b].size(), *first = overlaps_[b].data();
    while (first != end) {
      const Overlap* last = first;
      while (last != end && last->coarse == first->coarse) ++last;
      const Nodal nodes = nodal(b, first, last, state);
      for (; first != last; ++first) add_overlap(b, *first, nodes, state, sums);
    }
  }
  for (size_t z = 0; z < sums.norm.size(); ++z) {
    largest_[z] = std::max(largest_[z], sums.norm[z]);
    zone_difference_[z].push_back({sums.off[z], sums.own[z]});
  }
  work_ = std::max({work_, std::fabs(fine_.states[state].work), std::fabs(fine_.states[state].elastic)});
  pressure_.push_back(std::move(sums.pressure));
  energy_.push_back(std::move(sums.energy));
}

Distance Comparer::run() {
  Distance out;
  zone_difference_.resize(coarse_.zones.size());
  const size_t common = std::min(coarse_.states.size(), fine_.states.size());
  for (size_t state = 0; state < common; ++state) add(state);
  for (const auto& lengths : coarse_.lengths) out.shares.push_back(std::vector<Share>(lengths.size()));
  for (size_t state = 0; state < common; ++state) {
    const double weight = fine_.states[state].turn || state + 1 == common ? 1 : kBetween;
    double sum = 0;
    for (size_t b = 0; b < overlaps_.size() && weight == 1; ++b)
      for (const Overlap& o : overlaps_[b]) {
        const auto e = static_cast<size_t>(o.coarse);
        if (zones_[b][e].empty() || !holds_edge(b, o, state)) continue;
        out.shares[b][e].edge = true;
        out.shares[b][e].touch = touching_end(b, e, state);
      }
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
    out.pressure.push_back(0), out.own.push_back(0);
    for (size_t state = 0; state < common; ++state) {
      if (largest_[z] == 0 || (!fine_.states[state].turn && state + 1 != common)) continue;
      out.pressure[z] = std::max(out.pressure[z], zone_difference_[z][state][0] / largest_[z]);
      out.own[z] = std::max(out.own[z], zone_difference_[z][state][1] / largest_[z]);
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
