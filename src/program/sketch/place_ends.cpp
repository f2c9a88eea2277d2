#include "program/sketch/place_ends.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace sketch {
namespace {

constexpr double kTogether = 0.25; // of an element: a place nearer than this to an end that has moved uses that end

// `moved`: ends that have moved already.
void place_end(MeshedCurve& curve, double s, std::vector<double>& moved) {
  std::vector<double>& all = curve.ends;
  const auto above = std::upper_bound(all.begin(), all.end(), s);
  if (above == all.begin() || above == all.end()) return;
  const auto k = static_cast<size_t>(above - all.begin());
  const double from = all[k - 1], to = all[k], room = kTogether * (to - from);
  const auto has_moved = [&](double end) { return std::count(moved.begin(), moved.end(), end) != 0; };
  const bool low = k > 1 && !has_moved(from), high = k + 1 < all.size() && !has_moved(to);
  if ((!low && s - from < room) || (!high && to - s < room)) return;
  if (low && (!high || s - from < to - s))
    all[k - 1] = s;
  else if (high)
    all[k] = s;
  else
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(k), s);
  moved.push_back(s);
}

} // namespace

// Sampling, then Newton's method on the distance.
double nearest_length(const MeshedCurve& curve, Point p) {
  const Shape& shape = *curve.curve->shape;
  const int n = 64 + 4 * shape.pieces();
  double best = 0, least = HUGE_VAL;
  for (int i = 0; i <= n; ++i)
    if (const double d = length(shape.at(static_cast<double>(i) / n) - p); d < least)
      least = d, best = static_cast<double>(i) / n;
  for (int step = 0; step < 20; ++step) {
    const Shape::Local l = shape.local(best);
    const double slope = dot(l.d, l.d) + dot(l.at - p, l.dd), off = dot(l.at - p, l.d);
    if (!(slope > 0)) break;
    best = std::clamp(best - off / slope, 0.0, 1.0);
  }
  return curve.measure.length_to(best);
}

Located locate(const Sketch& sketch, const Spot& spot, bool in_contact, Mesh& mesh) {
  Located out;
  double least = HUGE_VAL;
  size_t first = 0;
  for (MeshedOutline& outline : mesh.bodies[static_cast<size_t>(spot.body)])
    for (MeshedCurve& curve : outline.curves) {
      if (!in_contact || holds_pairs(sketch, *curve.curve)) {
        const double s = nearest_length(curve, spot.at), off = length(curve.curve->shape->at(curve.measure.u_at(s)) - spot.at);
        if (off < least) least = off, out = {&curve, s, first};
      }
      first += curve.elements();
    }
  return out;
}

void place_ends(const Sketch& sketch, const std::vector<Spot>& spots, Mesh& mesh) {
  std::map<MeshedCurve*, std::vector<double>> moved; // ends that have moved
  for (const Spot& spot : spots)
    if (const Located at = locate(sketch, spot, true, mesh); at.curve != nullptr)
      place_end(*at.curve, at.length, moved[at.curve]);
}

} // namespace sketch
