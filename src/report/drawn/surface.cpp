#include "report/drawn/surface.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// The elements of a side are numbered up or down from the first; a side with more or fewer elements than lie between its ends
// goes across the end of a closed region.
bool is_of_side(const c2d_side& side, int32_t element) {
  const int32_t low = std::min(side.first_element, side.last_element), high = std::max(side.first_element, side.last_element);
  if (low == 0) return true;
  const bool between = element >= low && element <= high;
  return high - low + 1 == side.elements ? between : !between || element == low || element == high;
}

Point between(Point a, Point b, double part) { return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)}; }

} // namespace

SurfacePoint surface_at(const BodyScene& body, const c2d_side& side, Point p) {
  SurfacePoint out;
  double least = HUGE_VAL;
  for (const std::vector<OutlinePoint>& curve : body.curves)
    for (size_t i = 0; i < curve.size(); ++i) {
      const OutlinePoint &a = curve[i], &b = curve[(i + 1) % curve.size()];
      if (!is_of_side(side, a.element)) continue;
      const Point way{b.at.x - a.at.x, b.at.y - a.at.y};
      const double square = way.x * way.x + way.y * way.y;
      if (!(square > 0.0)) continue;
      const double along = ((p.x - a.at.x) * way.x + (p.y - a.at.y) * way.y) / square;
      const double part = std::min(1.0, std::max(0.0, along));
      const Point foot = between(a.at, b.at, part), moved = between(a.moved, b.moved, part);
      const double apart = std::hypot(foot.x - p.x, foot.y - p.y);
      if (apart >= least) continue;
      least = apart;
      const double length = std::sqrt(square);
      out = {{way.y / length, -way.x / length}, {moved.x - foot.x, moved.y - foot.y}};
    }
  return out;
}

} // namespace app
