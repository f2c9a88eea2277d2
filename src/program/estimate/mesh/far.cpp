// Elements of side 2 that stay away from contact are left out of the zone (METHOD 16.5). Phases: find the elements that touched
// in any increment; keep neighbours within kMargin of the touching length and at least kLeast elements; mark all others as far.
#include "program/estimate/mesh/far.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kMargin = 0.2; // of the touching length: kept on either side of it
constexpr size_t kLeast = 2;    // elements kept at least

// An element of a mesh: its curve and its position on it.
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

// Does a place, or an end of an element, lie in the part left out?
bool is_far(const sketch::MeshedCurve& curve, double s) {
  const double near = 1e-9 * curve.measure.length();
  return std::any_of(curve.far.begin(), curve.far.end(),
                     [&](const auto& f) { return s > f.first - near && s < f.second + near; });
}

// The elements of side 2 of a zone, in order.
std::vector<size_t> row_of(const Trial& trial, size_t zone) {
  const Side& side = trial.zones[zone][1];
  const size_t n = trial.lengths[static_cast<size_t>(side.body)].size();
  std::vector<size_t> out;
  for (auto e = static_cast<size_t>(side.first);; e = (e + 1) % n) {
    out.push_back(e);
    if (e == static_cast<size_t>(side.last) || out.size() == n) return out;
  }
}

// The elements of a row that touch at any time.
std::vector<char> touching(const Trial& trial, size_t zone, const std::vector<size_t>& row) {
  const auto body = static_cast<size_t>(trial.zones[zone][1].body), nodes = static_cast<size_t>(trial.nodes);
  std::vector<char> out(row.size(), 0);
  for (size_t i = 0; i < row.size() && body < trial.touched.size(); ++i)
    for (size_t k = 0; k < nodes; ++k)
      if (trial.touched[body][row[i] * nodes + k] != 0) out[i] = 1;
  return out;
}

// Touching elements of an outline with their neighbours, up to a length and a number of elements; cyclic on a closed outline.
std::vector<char> kept(const std::vector<double>& lengths, const std::vector<char>& touches, size_t first,
                       const sketch::MeshedOutline& outline, double margin) {
  const size_t n = outline.elements();
  std::vector<char> out(n, 0);
  for (const bool back : {false, true}) {
    double since = HUGE_VAL;
    size_t count = kLeast;
    for (size_t k = 0; k < (outline.open ? n : 2 * n); ++k) {
      const size_t i = back ? n - 1 - k % n : k % n;
      if (touches[first + i] != 0)
        since = 0, count = 0;
      else if (since < margin || count < kLeast)
        since += lengths[first + i], ++count;
      else
        continue;
      out[i] = 1;
    }
  }
  return out;
}

} // namespace

bool mark_far(const sketch::Sketch& sketch, const Trial& trial, sketch::Mesh& mesh) {
  bool any = false;
  for (size_t body = 0; body < mesh.bodies.size(); ++body) {
    std::vector<char> touches(trial.lengths[body].size(), 0);
    double length = 0;
    for (size_t z = 0; z < trial.zones.size(); ++z) {
      if (trial.tied[z] != 0 || trial.zones[z][1].body != static_cast<int32_t>(body)) continue;
      const std::vector<size_t> row = row_of(trial, z);
      const std::vector<char> of_row = touching(trial, z, row);
      for (size_t i = 0; i < row.size(); ++i)
        if (of_row[i] != 0) touches[row[i]] = 1, length += trial.lengths[body][row[i]];
    }
    if (length == 0) continue;
    size_t first = 0;
    for (sketch::MeshedOutline& outline : mesh.bodies[body]) {
      std::vector<char> keeps = kept(trial.lengths[body], touches, first, outline, kMargin * length);
      for (sketch::MeshedCurve& curve : outline.curves) {
        const bool may_touch = sketch::holds_pairs(sketch, *curve.curve);
        for (size_t e = 0; e < curve.elements(); ++e)
          if (keeps[e] == 0 && may_touch && !is_far(curve, (curve.ends[e] + curve.ends[e + 1]) / 2))
            curve.far.push_back({curve.ends[e], curve.ends[e + 1]}), any = true;
        keeps.erase(keeps.begin(), keeps.begin() + static_cast<std::ptrdiff_t>(curve.elements()));
        first += curve.elements();
      }
    }
  }
  return any;
}

bool is_cut_off(const Trial& trial, const sketch::Mesh& mesh) {
  for (size_t z = 0; z < trial.zones.size(); ++z) {
    if (trial.tied[z] != 0) continue;
    const auto body = static_cast<size_t>(trial.zones[z][1].body);
    const std::vector<size_t> row = row_of(trial, z);
    const std::vector<char> touches = touching(trial, z, row);
    auto outlines = mesh.bodies[body];
    const std::vector<Element> all = elements_of(outlines);
    const size_t first = row.front(), last = row.back();
    if (touches.front() != 0 && is_far(*all[first].curve, all[first].from)) return true;
    if (touches.back() != 0 && is_far(*all[last].curve, all[last].to)) return true;
  }
  return false;
}

} // namespace estimate
