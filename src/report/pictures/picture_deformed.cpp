#include "post/zone_line.hpp"
#include "report/drawn/axes.hpp"
#include "report/pictures/deformation.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

struct Extent {
  double size = 0.0;         // larger side of the bounding box; at most twice that of the smallest body
  double displacement = 0.0; // largest
  size_t body = 0, end = 0;  // where that is
  double wanted = 1.0;       // factor at which that would be well visible
};

Extent measure(const Scene& scene) {
  Extent out;
  Range x, y;
  double least = HUGE_VAL;
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyScene& body = scene.bodies[b];
    Range own[2];
    for (const Point& p : body.ends) x.include(p.x), y.include(p.y), own[0].include(p.x), own[1].include(p.y);
    if (!body.ends.empty()) least = std::min(least, std::max(own[0].high - own[0].low, own[1].high - own[1].low));
    for (size_t i = 0; i < body.displacement.size(); ++i) {
      const double size = std::hypot(body.displacement[i].x, body.displacement[i].y);
      if (size > out.displacement) out.displacement = size, out.body = b, out.end = i;
    }
  }
  out.size = std::min(std::max(x.high - x.low, y.high - y.low), 2.0 * least);
  return out;
}

constexpr double kShare = 1.0 / 12.0; // of the size of the model: the largest displacement as it is drawn

void draw_shapes(Svg& svg, const Scene& scene, const Chart& view, const Deformation& deformation) {
  draw_axes(svg, view);
  svg.begin_clip(view.frame);
  for (int pass = 0; pass < 2; ++pass)
    for (size_t b = 0; b < scene.bodies.size(); ++b) {
      const BodyStyle& style = style_of(b);
      const Outlines curves = view.at(pass == 0 ? deformation.outline(scene.bodies[b], b) : outline_of(scene.bodies[b], 0.0));
      if (pass == 0) svg.area(curves, style.fill, Stroke{});
      // Dashes need lines that do not run far outside the view.
      for (const std::vector<Point>& piece : pieces_within(curves, view.frame))
        svg.polyline(piece, pass == 0 ? Stroke{style.edge, 1.4, style.dash} : Stroke{colour::kFaint, 1.0, "2 3"});
    }
  svg.end_clip();
}

std::string caption_of(const Scene& scene, const Extent& extent, const Deformation& deformation) {
  const Point at = scene.bodies[extent.body].ends.empty() ? Point{} : scene.bodies[extent.body].ends[extent.end];
  std::string out = "Shape at " + place_at_end(scene) + ", " + scale_text(deformation) + ": the largest displacement is " +
                    figure(extent.displacement, scene.length_unit, 6) + " at " + place_text(scene, at, extent.size);
  if (scene.bodies.size() > 1) out += " of " + body_label(scene, static_cast<int64_t>(extent.body) + 1);
  out += ".";
  if (deformation.factor() < extent.wanted) out += " A larger factor would draw bodies that touch over each other, or apart.";
  return out;
}

} // namespace

void draw_deformed(const Scene& scene, Pictures& out) {
  Extent extent = measure(scene);
  const GapLift lift(scene);
  extent.wanted = wanted_factor(extent.size, std::max(extent.displacement, lift.largest()), kShare);
  const double left = 62.0, right = 14.0;
  std::vector<LegendEntry> entries;
  for (size_t b = 0; b < scene.bodies.size() && !scene.bodies[b].platen; ++b) // they are the last
    entries.push_back({"deformed " + body_label(scene, static_cast<int64_t>(b) + 1),
                       Stroke{style_of(b).edge, 1.4, style_of(b).dash}, Mark::kNone, true, style_of(b).fill});
  entries.push_back({"undeformed", Stroke{colour::kFaint, 1.0, "2 3"}, Mark::kNone, true, ""});
  const double top = 33.0 + draw_legend(nullptr, {left, 4.0}, kPictureWidth - left - right, entries);
  const ViewOf view_of = [&](const Deformation& d) {
    Range x, y;
    for (size_t b = 0; b < scene.bodies.size(); ++b)
      for (const Outlines& curves : {outline_of(scene.bodies[b], 0.0), d.outline(scene.bodies[b], b)})
        for (const auto& curve : curves)
          for (const Point& p : curve) x.include(p.x), y.include(p.y);
    const double high = view_height(x, y, kPictureWidth - left - right, 200.0, 400.0);
    return make_view({left, top, kPictureWidth - right, top + high}, x, y, 14.0, scene.length_unit);
  };
  const Deformation deformation = choose_deformation(scene, lift, extent.wanted, {}, view_of);
  const Chart view = view_of(deformation);
  Svg svg("deformed", kPictureWidth, view.frame.bottom + 42.0);
  draw_legend(&svg, {left, 4.0}, kPictureWidth - left - right, entries);
  draw_shapes(svg, scene, view, deformation);
  const std::string scale = scale_text(deformation);
  draw_heading(svg, view.frame, "Whole model, " + scale);
  Picture picture{"deformed", "Deformed shape", caption_of(scene, extent, deformation), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
