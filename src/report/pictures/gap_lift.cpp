#include "report/pictures/gap_lift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr size_t kMostSources = 400; // of a zone; of more every second, third, ... is taken
constexpr double kBeside = 100.0;    // of the outline over the length of a zone

// Distance from `from` along the unit vector `along` to the nearest place of an outline, at most `most` in either direction;
// not finite if there is none.
double distance_along(const BodyScene& body, Point from, Point along, double most) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::vector<OutlinePoint>& curve : body.curves)
    for (size_t i = 0; i < curve.size(); ++i) {
      const Point a = curve[i].at, b = curve[(i + 1) % curve.size()].at;
      const double aside = along.x * (a.y - from.y) - along.y * (a.x - from.x);
      const double bside = along.x * (b.y - from.y) - along.y * (b.x - from.x);
      if (aside == bside || (aside > 0.0) == (bside > 0.0)) continue;
      const double part = aside / (aside - bside);
      const double far = along.x * (a.x + part * (b.x - a.x) - from.x) + along.y * (a.y + part * (b.y - a.y) - from.y);
      if (std::fabs(far) <= most && std::fabs(far) < std::fabs(nearest)) nearest = far;
    }
  return nearest;
}

} // namespace

GapLift::GapLift(const Scene& scene) : of_(scene.bodies.size()) {
  if (scene.record->coefficients.empty()) return;
  const std::vector<double>& table = scene.record->coefficients.back().table;
  std::vector<Source> pairs(scene.pairs.size());
  for (size_t p = 0; p < scene.pairs.size() && (p + 1) * C2D_PAIR_FIELDS <= table.size(); ++p) {
    const double* row = table.data() + p * C2D_PAIR_FIELDS;
    const double gap = row[C2D_GAP] - (row[C2D_UN2] - row[C2D_UN1]);
    const Point n = scene.pairs[p].normal;
    const double lift = std::max(gap, 0.0); // magnified, the overlap of a press fit would exceed the motion that closes it
    pairs[p] = {scene.pairs[p].on[1], {lift * n.x, lift * n.y}};
    largest_ = std::max(largest_, std::fabs(gap));
  }
  for (const ZoneScene& zone : scene.zones) beside_.push_back(table.empty() ? std::vector<Source>() : beside(scene, zone));
  place(scene, pairs);
}

// Beside a zone, up to its length from either end, the sides have a gap as well: along the normal of the end, from places of
// side 2 that face body 1 to its outline. Without it the shape would have a notch where the zone ends.
std::vector<GapLift::Source> GapLift::beside(const Scene& scene, const ZoneScene& zone) {
  const BodyScene& one = scene.bodies[static_cast<size_t>(zone.body[0]) - 1];
  const BodyScene& two = scene.bodies[static_cast<size_t>(zone.body[1]) - 1];
  std::vector<Source> found;
  if (zone.tied || zone.pairs < 2 || one.platen) return found;
  const PairScene* const pairs = scene.pairs.data() + zone.first;
  const double length = distance(pairs[0].on[1], pairs[zone.pairs - 1].on[1]);
  for (const size_t end : {size_t{0}, zone.pairs - 1}) {
    const Point at = pairs[end].on[1], next = pairs[end == 0 ? 1 : end - 1].on[1], n = pairs[end].normal;
    const auto take = [&](Point p, Point way) {
      const double off = distance(p, at);
      const bool faces = way.x * n.y - way.y * n.x > 0.0; // material is on the left, n points away from body 1
      if (!faces || !(off < length) || off >= distance(p, next) || off < 0.5 * distance(at, next)) return;
      const double gap = -distance_along(one, p, n, length);
      if (std::isfinite(gap) && gap >= 0.0) found.push_back({p, {gap * n.x, gap * n.y}});
    };
    for (const std::vector<OutlinePoint>& curve : two.curves)
      for (size_t i = 0; i < curve.size(); ++i) {
        const Point from = curve[i].at, way = curve[(i + 1) % curve.size()].at - from;
        if (distance(from, at) > length + app::length(way)) continue;
        const int parts = static_cast<int>(std::min(kBeside, std::ceil(kBeside * app::length(way) / length)));
        for (int k = 0; k < parts; ++k) take(from + (static_cast<double>(k) / parts) * way, way);
      }
  }
  return found;
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
      const auto add = [&](const Source& source) {
        const Point base = at(fixed, source.at);
        const Point by{base.x + sign * source.by.x, base.y + sign * source.by.y};
        for (const Image& image : scene.images) of_[moved].push_back({image.place(source.at), image.direction(by)});
      };
      const size_t every = zone.pairs / kMostSources + 1;
      for (size_t p = zone.first; p < zone.first + zone.pairs; p += every) add(pairs[p]);
      for (const Source& source : beside_[static_cast<size_t>(&zone - scene.zones.data())]) add(source);
      stands[moved] = 1;
      more = true;
    }
    for (size_t b = 0; b < stands.size(); ++b)
      if (stands[b] && !before[b] && scene.bodies[b].rigid) move_as_rigid(of_[b]);
  }
}

// One translation, the mean, in place of a field that would bend the body.
void GapLift::move_as_rigid(std::vector<Source>& sources) {
  Point sum;
  for (const Source& s : sources) sum = sum + s.by;
  if (!sources.empty()) sources = {{sources.front().at, (1.0 / static_cast<double>(sources.size())) * sum}};
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
