#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// What a view has to show.
struct MeshExtent {
  Range x, y;
  void include(Point p) { x.include(p.x), y.include(p.y); }
  double size() const { return std::max(x.high - x.low, y.high - y.low); }
  // Both directions at least `least` wide and not beyond `most`, about the middle.
  void limit(double least, double most, Point middle) {
    for (Range* range : {&x, &y}) {
      const double at = range == &x ? middle.x : middle.y, room = 0.5 * (least - (range->high - range->low));
      if (room > 0.0) range->low -= room, range->high += room;
      if (range->high - range->low > most) range->low = at - 0.5 * most, range->high = at + 0.5 * most;
    }
  }
};

// The touching stretch of the zone with the shortest elements, in that zone about where they are.
class Close {
public:
  explicit Close(const Scene& scene) : scene_(scene) {}
  bool find(double whole, MeshExtent& out) {
    for (const ZoneScene& zone : scene_.zones) look_at(zone);
    if (zone_ == nullptr) return false;
    const std::vector<double>* table = last_table();
    for (size_t p = zone_->first; p < zone_->first + zone_->pairs; ++p) {
      const bool open = table != nullptr && static_cast<int>((*table)[p * C2D_PAIR_FIELDS + C2D_STATUS]) == C2D_OPEN;
      if (open) continue;
      for (const Image& image : scene_.zone_images)
        out.include(image.place(scene_.pairs[p].on[0])), out.include(image.place(scene_.pairs[p].on[1]));
    }
    if (out.x.empty) out.include(finest_);
    const double room = 0.15 * out.size();
    out.x.low -= room, out.x.high += room, out.y.low -= room, out.y.high += room;
    out.limit(std::max(12.0 * shortest_, 1e-9 * whole), 0.4 * whole, finest_);
    return true;
  }

private:
  const std::vector<double>* last_table() const {
    const std::vector<CoefficientRecord>& all = scene_.record->coefficients;
    return all.empty() || all.back().table.empty() ? nullptr : &all.back().table;
  }
  void look_at(const ZoneScene& zone) {
    if (scene_.bodies[static_cast<size_t>(zone.body[0]) - 1].platen) return;
    for (size_t p = zone.first + 1; p < zone.first + zone.pairs; ++p) {
      const Point a = scene_.pairs[p - 1].on[1], b = scene_.pairs[p].on[1];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (length > 0.0 && (zone_ == nullptr || length < 0.999 * shortest_)) shortest_ = length, finest_ = b, zone_ = &zone;
    }
  }

  const Scene& scene_;
  const ZoneScene* zone_ = nullptr;
  double shortest_ = 0.0;
  Point finest_;
};

// A stroke across the boundary at every end of an element; at a corner it halves the angle.
void draw_ends(Svg& svg, const Image& image, const MeshCurve& curve, const Chart& view, double half, const Stroke& stroke) {
  std::vector<Point> points;
  for (const auto& end : curve.ends) {
    const Point p = image.place({end[0], end[1]});
    points.push_back(view.at(p));
  }
  const size_t last = points.size() - 1;
  for (size_t i = curve.closed ? 1 : 0; i < points.size(); ++i) {
    const Point before = points[i > 0 ? i - 1 : 0], after = points[i < last ? i + 1 : curve.closed ? 1 : last], at = points[i];
    if (at.x < view.frame.left || at.x > view.frame.right || at.y < view.frame.top || at.y > view.frame.bottom) continue;
    const double to = std::hypot(at.x - before.x, at.y - before.y), from = std::hypot(after.x - at.x, after.y - at.y);
    Point along;
    if (to > 0.0) along = {(at.x - before.x) / to, (at.y - before.y) / to};
    if (from > 0.0) along = {along.x + (after.x - at.x) / from, along.y + (after.y - at.y) / from};
    const double size = std::hypot(along.x, along.y);
    if (!(size > 0.0)) continue;
    const Point across{-along.y / size * half, along.x / size * half};
    svg.line({at.x - across.x, at.y - across.y}, {at.x + across.x, at.y + across.y}, stroke);
  }
}

void draw_view(Svg& svg, const Scene& scene, const MeshRound& round, const Chart& view, double half,
               const std::string& heading) {
  draw_axes(svg, view);
  svg.begin_clip(view.frame);
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    const Outlines curves = view.at(outline_of(scene.bodies[b], 0.0));
    svg.area(curves, style_of(b).fill, Stroke{});
    for (const std::vector<Point>& piece : pieces_within(curves, view.frame))
      svg.polyline(piece, Stroke{style_of(b).edge, 1.0, ""});
  }
  for (const Image& image : scene.images)
    for (const MeshCurve& curve : round.curves)
      if (!curve.ends.empty())
        draw_ends(svg, image, curve, view, half, Stroke{style_of(static_cast<size_t>(curve.body) - 1).edge, 0.9, ""});
  svg.end_clip();
  draw_heading(svg, view.frame, heading);
}

std::string heading_of(const MeshLoop& loop, size_t round) {
  return "Mesh " + std::to_string(round + 1) + ": " + std::to_string(loop.rounds[round].elements) + " elements";
}

std::string caption_of(const MeshLoop& loop) {
  const std::string why = escape_xml(loop.ending());
  std::string out = (why.empty() ? "" : why + ". ") + "Strokes across the boundary are ends of elements. ";
  if (loop.taken == 0) return out + "The results are those of the first mesh. The dashed frame is enlarged.";
  return out + "On the left is the first mesh, on the right the one of the results, number " + std::to_string(loop.taken + 1) +
         " of " + std::to_string(loop.rounds.size()) + " that were solved. The dashed frames are enlarged below.";
}

} // namespace

void draw_meshes(const Scene& scene, Pictures& out) {
  const MeshLoop& loop = scene.record->meshes;
  if (!loop.ran() || loop.rounds[loop.taken].curves.empty()) return; // a deck is drawn as it is
  MeshExtent whole, part;
  for (const BodyScene& body : scene.bodies)
    for (const auto& curve : body.curves)
      for (const OutlinePoint& p : curve) whole.include(p.at);
  if (whole.x.empty) return;
  const bool zoom = Close(scene).find(whole.size(), part);
  const double left = 54.0, gap = 54.0, right = 8.0, top = 30.0, below = 44.0;
  const bool both = loop.taken > 0; // one mesh alone has its contact beside it
  const double wide = (kPictureWidth - left - gap - right) / 2.0, high = view_height(whole.x, whole.y, wide, 160.0, 340.0),
               high_part = !zoom  ? 0.0
                           : both ? view_height(part.x, part.y, wide, 120.0, 300.0)
                                  : high;
  const double second = both ? top + high + below + 26.0 : top;
  Svg svg("meshes", kPictureWidth, zoom && both ? second + high_part + below : top + high + below);
  for (size_t c = 0; c < (both ? 2 : 1); ++c) {
    const size_t number = c == 0 ? 0 : loop.taken;
    const MeshRound& round = loop.rounds[number];
    const double from = left + static_cast<double>(c) * (wide + gap), from_part = both ? from : from + wide + gap;
    const Chart view = make_view({from, top, from + wide, top + high}, whole.x, whole.y, 12.0, scene.length_unit);
    draw_view(svg, scene, round, view, 3.0, heading_of(loop, number));
    if (!zoom) continue;
    const Box frame{from_part, second, from_part + wide, second + high_part};
    const Chart close = make_view(frame, part.x, part.y, 0.0, scene.length_unit);
    draw_zoom_frame(svg, view, close);
    draw_view(svg, scene, round, close, 5.0, "The contact on mesh " + std::to_string(number + 1));
  }
  Picture picture{"meshes", "Meshes", caption_of(loop), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
