#include "program/estimate/far.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kMargin = 0.4; // of the length that touches, kept beside it
constexpr size_t kLeast = 3;    // elements, too

// An element of a mesh: which curve it is on, where.
struct Element {
  sketch::MeshedCurve* curve;
  double from, to;
};

std::vector<Element> elements_of(std::vector<sketch::MeshedOutline>& outlines) {
  std::vector<Element> out;
  for (sketch::MeshedOutline& outline : outlines)
    for (sketch::MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e) out.push_back({&curve, curve.ends[e], curve.ends[e + 1]});
  return out;
}

// The elements of side 2 of a zone, one behind the other.
std::vector<size_t> row_of(const Trial& trial, size_t zone) {
  const Side& side = trial.zones[zone][1];
  const size_t n = trial.lengths[static_cast<size_t>(side.body)].size();
  std::vector<size_t> out;
  for (auto e = static_cast<size_t>(side.first);; e = (e + 1) % n) {
    out.push_back(e);
    if (e == static_cast<size_t>(side.last) || out.size() == n) return out;
  }
}

// Which elements of a row touch at any state.
std::vector<char> touching(const Trial& trial, size_t zone, const std::vector<size_t>& row) {
  const auto body = static_cast<size_t>(trial.zones[zone][1].body), nodes = static_cast<size_t>(trial.nodes);
  std::vector<char> out(row.size(), 0);
  for (const State& state : trial.states)
    for (size_t i = 0; i < row.size(); ++i)
      for (size_t k = 0; k < nodes; ++k)
        if (state.ends[body][kStatus][row[i] * nodes + k] > 0) out[i] = 1;
  return out;
}

} // namespace

void mark_far(const Trial& trial, sketch::Mesh& mesh) {
  for (size_t z = 0; z < trial.zones.size(); ++z) {
    if (trial.tied[z] != 0) continue;
    const auto body = static_cast<size_t>(trial.zones[z][1].body);
    const std::vector<size_t> row = row_of(trial, z);
    const std::vector<char> touches = touching(trial, z, row);
    double length = 0;
    for (size_t i = 0; i < row.size(); ++i) length += touches[i] != 0 ? trial.lengths[body][row[i]] : 0;
    if (length == 0) continue;
    std::vector<char> keeps = touches;
    for (const int step : {1, -1}) { // beside what touches, both ways
      double since = HUGE_VAL;
      size_t count = kLeast;
      for (size_t k = 0; k < row.size(); ++k) {
        const size_t i = step > 0 ? k : row.size() - 1 - k;
        if (touches[i] != 0) {
          since = 0, count = 0;
          continue;
        }
        if (since < kMargin * length || count < kLeast) keeps[i] = 1;
        since += trial.lengths[body][row[i]], ++count;
      }
    }
    const std::vector<Element> all = elements_of(mesh.bodies[body]);
    for (size_t i = 0; i < row.size(); ++i)
      if (keeps[i] == 0) all[row[i]].curve->far.push_back({all[row[i]].from, all[row[i]].to});
  }
}

bool is_cut_off(const Trial& trial, const sketch::Mesh& mesh) {
  for (size_t z = 0; z < trial.zones.size(); ++z) {
    if (trial.tied[z] != 0) continue;
    const auto body = static_cast<size_t>(trial.zones[z][1].body);
    const std::vector<size_t> row = row_of(trial, z);
    const std::vector<char> touches = touching(trial, z, row);
    auto outlines = mesh.bodies[body];
    const std::vector<Element> all = elements_of(outlines);
    const auto is_far_at = [&](size_t element, double s) {
      const auto& far = all[element].curve->far;
      return std::any_of(far.begin(), far.end(), [&](const auto& f) { return s > f.first * (1 - 1e-9) && s < f.second * (1 + 1e-9); });
    };
    const size_t first = row.front(), last = row.back();
    if (touches.front() != 0 && is_far_at(first, all[first].from)) return true;
    if (touches.back() != 0 && is_far_at(last, all[last].to)) return true;
  }
  return false;
}

} // namespace estimate
