#include "report/pictures/deformation.hpp"

#include "report/pictures/contour.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kMostOverlap = 0.5;    // pixels
constexpr double kMostGapError = 0.75;  // pixels, of the drawn gap of a pair
constexpr double kNearGap = 20.0;       // pixels: the drawn gaps of pairs that are farther apart are not compared
constexpr double kMostDistortion = 0.1; // of a body's shape by magnified initial gaps
constexpr double kSeen = 1.0;           // pixels, of such a distortion
constexpr double kLeastStep = 0.25;     // pixels, from point to point of the outlines that are compared

// The outline in pixels, without points closer to the one before than a part of a pixel.
Outlines in_pixels(const Outlines& curves, const Chart& view) {
  Outlines out;
  for (const std::vector<Point>& curve : curves) {
    out.emplace_back();
    std::vector<Point>& kept = out.back();
    for (const Point& p : curve) {
      const Point at = view.at(p);
      if (kept.empty() || std::hypot(at.x - kept.back().x, at.y - kept.back().y) >= kLeastStep) kept.push_back(at);
    }
  }
  return out;
}

Box bounds(const Outlines& curves) {
  Range x, y;
  for (const auto& curve : curves)
    for (const Point& p : curve) x.include(p.x), y.include(p.y);
  return {x.low, y.low, x.high, y.high};
}

Box common(const Box& a, const Box& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

bool is_empty(const Box& box) { return !(box.left <= box.right && box.top <= box.bottom); }

// Calls `take` for points at most a pixel apart along the curves, within the box.
template <class Take> void each_point(const Outlines& curves, const Box& box, Take&& take) {
  for (const std::vector<Point>& curve : curves)
    for (size_t i = 0; i < curve.size(); ++i) {
      const Point a = curve[i], b = curve[(i + 1) % curve.size()];
      const Box around{std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
      if (is_empty(common(around, box))) continue;
      const int parts = static_cast<int>(std::min(2000.0, std::ceil(std::hypot(b.x - a.x, b.y - a.y))));
      for (int k = 0; k < std::max(1, parts); ++k) {
        const double part = static_cast<double>(k) / std::max(1, parts);
        const Point p{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
        if (p.x >= box.left && p.x <= box.right && p.y >= box.top && p.y <= box.bottom) take(p);
      }
    }
}

double depth_within(const Outlines& a, const Outlines& b, const Box& box) {
  double most = 0.0;
  each_point(a, box, [&](Point p) {
    if (is_inside(b, p)) most = std::max(most, distance_to_outline(b, p));
  });
  return most;
}

// Are gaps of pairs drawn as large as they are, times the factor?
bool gaps_fit(const Scene& scene, const Deformation& d, double scale) {
  const std::vector<double>& table = scene.record->coefficients.back().table;
  for (size_t p = 0; p < scene.pairs.size() && (p + 1) * C2D_PAIR_FIELDS <= table.size(); ++p) {
    const PairScene& pair = scene.pairs[p];
    const ZoneScene& zone = scene.zones[static_cast<size_t>(pair.zone) - 1];
    const size_t one = static_cast<size_t>(zone.body[0]) - 1, two = static_cast<size_t>(zone.body[1]) - 1;
    if (scene.bodies[one].platen) continue;
    const Point a = d.place(one, pair.on[0], pair.moved[0]), b = d.place(two, pair.on[1], pair.moved[1]);
    const double drawn = scale * ((b.x - a.x) * pair.normal.x + (b.y - a.y) * pair.normal.y);
    const double is = scale * d.factor() * table[p * C2D_PAIR_FIELDS + C2D_GAP];
    if (is < kNearGap && std::fabs(drawn - is) > kMostGapError) return false;
    if (drawn < -kMostOverlap) return false;
  }
  return true;
}

// Do magnified initial gaps leave the bodies their shape, or are they too small to be seen?
bool shapes_fit(const Scene& scene, const Deformation& d, const Chart& view, double scale) {
  for (size_t b = 0; b < scene.bodies.size(); ++b)
    for (const std::vector<OutlinePoint>& curve : scene.bodies[b].curves) {
      double change = 0.0; // since the last place without distortion
      for (size_t i = 0; i < curve.size(); ++i) {
        const Point from = curve[i].at, to = curve[(i + 1) % curve.size()].at, at = view.at(from);
        const Point a = d.lifted(b, from), c = d.lifted(b, to);
        const double more = distance(a, c);
        if (more <= kMostDistortion * distance(from, to) || !view.is_near(at))
          change = 0.0;
        else if ((change += scale * more) > kSeen)
          return false;
      }
    }
  return true;
}

bool bodies_fit(const Scene& scene, const Deformation& d, const Chart& view) {
  std::vector<Outlines> shapes;
  for (size_t b = 0; b < scene.bodies.size(); ++b) shapes.push_back(in_pixels(d.outline(scene.bodies[b], b), view));
  for (size_t a = 0; a < shapes.size(); ++a)
    for (size_t b = a + 1; b < shapes.size(); ++b)
      if (depth_of_overlap(shapes[a], shapes[b], view.frame) > kMostOverlap) return false;
  return true;
}

bool fits(const Scene& scene, const Deformation& d, const Chart& view) {
  const double scale = view.frame.width() / (view.x.high - view.x.low);
  return gaps_fit(scene, d, scale) && shapes_fit(scene, d, view, scale) && bodies_fit(scene, d, view);
}

// The next of ... 1, 2, 5, 10, 20 ... below.
double next_below(double factor) {
  const double power = std::pow(10.0, std::floor(std::log10(factor) + 1e-9)), lead = std::round(factor / power);
  return lead > 2.0 ? 2.0 * power : lead > 1.0 ? power : 0.5 * power;
}

} // namespace

Point Deformation::lifted(size_t body, Point at) const {
  if (lift_ == nullptr || factor_ <= 1.0) return {};
  const Point by = lift_->at(body, at);
  return {(factor_ - 1.0) * by.x, (factor_ - 1.0) * by.y};
}

Point Deformation::place(size_t body, Point at, Point displacement) const {
  const Point by = lifted(body, at);
  return {at.x + factor_ * (displacement.x - reference_.x) + by.x, at.y + factor_ * (displacement.y - reference_.y) + by.y};
}

Outlines Deformation::outline(const BodyScene& shape, size_t body) const {
  Outlines out;
  for (const std::vector<OutlinePoint>& curve : shape.curves) {
    out.emplace_back();
    for (const OutlinePoint& p : curve) out.back().push_back(place(body, p.at, {p.moved.x - p.at.x, p.moved.y - p.at.y}));
  }
  return out;
}

double round_below(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted))), part = wanted / power;
  return power * (part < 2.0 ? 1.0 : part < 5.0 ? 2.0 : 5.0);
}

double wanted_factor(double size, double displacement, double share) {
  if (displacement <= 1e-12 * size || displacement >= share * size) return 1.0;
  return round_below(share * size / displacement);
}

double depth_of_overlap(const Outlines& a, const Outlines& b, const Box& box) {
  const Box where = common(common(bounds(a), bounds(b)), box);
  if (is_empty(where)) return 0.0;
  return std::max(depth_within(a, b, where), depth_within(b, a, where));
}

Deformation choose_deformation(const Scene& scene, const GapLift& lift, double wanted, Point reference, const ViewOf& view) {
  for (double factor = wanted; factor > 1.0; factor = next_below(factor))
    for (const GapLift* by : {static_cast<const GapLift*>(nullptr), &lift}) {
      const Deformation d(by, factor, reference);
      if (fits(scene, d, view(d))) return d;
    }
  return {nullptr, 1.0, reference};
}

std::string scale_text(const Deformation& deformation) {
  return deformation.factor() == 1.0 ? "to scale" : "displacements and gaps &#215; " + figure(deformation.factor(), 9);
}

} // namespace app
