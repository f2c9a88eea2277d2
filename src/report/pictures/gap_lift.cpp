#include "report/pictures/gap_lift.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr size_t kMostSources = 400; // of a zone; of more every second, third, ... is taken

} // namespace

GapLift::GapLift(const Scene& scene) : of_(scene.bodies.size()) {
  if (scene.record->coefficients.empty()) return;
  const std::vector<double>& table = scene.record->coefficients.back().table;
  std::vector<Source> pairs(scene.pairs.size());
  for (size_t p = 0; p < scene.pairs.size() && (p + 1) * C2D_PAIR_FIELDS <= table.size(); ++p) {
    const double* row = table.data() + p * C2D_PAIR_FIELDS;
    const double gap = row[C2D_GAP] - (row[C2D_UN2] - row[C2D_UN1]);
    const Point n = scene.pairs[p].normal;
    pairs[p] = {scene.pairs[p].on[1], {gap * n.x, gap * n.y}};
    largest_ = std::max(largest_, std::fabs(gap));
  }
  place(scene, pairs);
}

// From body 1 on, each body against those that stand already.
void GapLift::place(const Scene& scene, const std::vector<Source>& pairs) {
  std::vector<char> stands(scene.bodies.size(), 0);
  if (!stands.empty()) stands[0] = 1;
  for (bool more = true; more;) {
    more = false;
    const std::vector<char> before = stands;
    for (const ZoneScene& zone : scene.zones) {
      const size_t one = static_cast<size_t>(zone.body[0]) - 1, two = static_cast<size_t>(zone.body[1]) - 1;
      if (one == two || before[one] == before[two]) continue;
      const size_t moved = before[one] ? two : one, fixed = before[one] ? one : two;
      const double sign = before[one] ? 1.0 : -1.0;
      const size_t every = zone.pairs / kMostSources + 1;
      for (size_t p = zone.first; p < zone.first + zone.pairs; p += every) {
        const Point base = at(fixed, pairs[p].at);
        const Point by{base.x + sign * pairs[p].by.x, base.y + sign * pairs[p].by.y};
        for (const Image& image : scene.images) of_[moved].push_back({image.place(pairs[p].at), image.direction(by)});
      }
      stands[moved] = 1;
      more = true;
    }
  }
}

// Means with the inverse fourth power of the distance as weight.
Point GapLift::at(size_t body, Point p) const {
  double sum = 0.0;
  Point out;
  for (const Source& s : of_[body]) {
    const double dx = p.x - s.at.x, dy = p.y - s.at.y, square = dx * dx + dy * dy;
    if (square == 0.0) return s.by;
    const double weight = 1.0 / square / square;
    if (!std::isfinite(weight)) return s.by;
    sum += weight, out.x += weight * s.by.x, out.y += weight * s.by.y;
  }
  return sum > 0.0 ? Point{out.x / sum, out.y / sum} : Point{};
}

} // namespace app
