#include "report/drawn/axes.hpp"
#include "report/pictures/gap_lift.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

struct Extent {
  double size = 0.0;         // larger side of the bounding box; at most twice that of the smallest body
  double displacement = 0.0; // largest
  size_t body = 0, end = 0;  // where that is
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

// The outline moved by displacements that are magnified, and gaps with them.
std::vector<std::vector<Point>> deformed_outline(const Scene& scene, size_t b, double magnification, const GapLift* lift) {
  std::vector<std::vector<Point>> out = outline_of(scene.bodies[b], magnification);
  for (size_t c = 0; c < out.size() && lift != nullptr && magnification > 1.0; ++c)
    for (size_t i = 0; i < out[c].size(); ++i) {
      const Point by = lift->at(b, scene.bodies[b].curves[c][i].at);
      out[c][i].x += (magnification - 1.0) * by.x;
      out[c][i].y += (magnification - 1.0) * by.y;
    }
  return out;
}

// 1, 2 or 5 times a power of ten, at least 1, so that the largest displacement is drawn about a twelfth of
// the model.
double choose_magnification(double size, double displacement) {
  if (displacement <= 1e-12 * size || 12.0 * displacement >= size) return 1.0;
  const double wanted = size / 12.0 / displacement;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double part = wanted / power;
  return power * (part < 2.0 ? 1.0 : part < 5.0 ? 2.0 : 5.0);
}

void draw_nodes(Svg& svg, const Scene& scene, const BodyScene& body, const Chart& view, double magnification, const char* ink) {
  for (const Image& image : scene.images)
    for (size_t i = 0; i < body.ends.size(); ++i) {
      if (body.on_line[i / static_cast<size_t>(scene.summary.function_nodes)]) continue;
      const Point at = image.place(body.ends[i]), u = image.direction(body.displacement[i]);
      const Point p = view.at(at.x + magnification * u.x, at.y + magnification * u.y);
      if (p.x >= view.frame.left && p.x <= view.frame.right) svg.mark(Mark::kCircle, p, 3.0, ink);
    }
}

void draw_view(Svg& svg, const Scene& scene, const Chart& view, double magnification, const GapLift* lift) {
  draw_axes(svg, view);
  svg.begin_clip(view.frame);
  for (int pass = 0; pass < 2; ++pass)
    for (size_t b = 0; b < scene.bodies.size(); ++b) {
      const BodyStyle& style = style_of(b);
      std::vector<std::vector<Point>> curves = deformed_outline(scene, b, pass == 0 ? magnification : 0.0, lift);
      for (auto& curve : curves)
        for (Point& p : curve) p = view.at(p.x, p.y);
      if (pass == 0) svg.area(curves, style.fill, Stroke{});
      // Dashes need lines that do not run far outside the view.
      for (const std::vector<Point>& piece : pieces_within(curves, view.frame))
        svg.polyline(piece, pass == 0 ? Stroke{style.edge, 1.6, style.dash} : Stroke{colour::kFaint, 1.0, "2 3"});
      if (pass == 0 && lift == nullptr) draw_nodes(svg, scene, scene.bodies[b], view, magnification, style.edge);
    }
  svg.end_clip();
}

// How the zone's surroundings are drawn.
struct Zoom {
  Range x, y;
  double magnification = 1.0;
  int stretched = 0; // 1: x, 2: y has a larger scale, so that a gap is seen that is small against the zone
};

// The range of the pairs, deformed and undeformed, images included. A flat zone is drawn to scale but stretched.
// Otherwise surfaces that lie on each other from the start may be drawn with larger displacements, a gap may
// not.
Zoom choose_zoom(const Scene& scene) {
  Zoom out;
  double gap = 0.0, displacement = 0.0;
  for (const Image& image : scene.zone_images)
    for (const PairScene& pair : scene.pairs)
      for (const Point& p : pair.on)
        if (is_of_contact(scene, pair)) out.x.include(image.place(p).x), out.y.include(image.place(p).y);
  // Of a model with platens those ends alone that lie among the pairs.
  bool any_platen = false;
  for (const BodyScene& body : scene.bodies) any_platen = any_platen || body.platen;
  const auto lies_among_them = [near_x = out.x, near_y = out.y](Point p) {
    return p.x >= near_x.low && p.x <= near_x.high && p.y >= near_y.low && p.y <= near_y.high;
  };
  const auto each_end = [&](auto&& take) {
    for (const Image& image : scene.zone_images)
      for (const BodyScene& body : scene.bodies)
        for (size_t i = 0; i < body.ends.size(); ++i)
          if (body.status[i] >= 0 && (!any_platen || lies_among_them(image.place(body.ends[i]))))
            take(image.place(body.ends[i]), image.direction(body.displacement[i]));
  };
  for (const PairScene& pair : scene.pairs)
    gap = std::max(gap, std::hypot(pair.on[1].x - pair.on[0].x, pair.on[1].y - pair.on[0].y));
  each_end([&](Point, Point u) { displacement = std::max(displacement, std::hypot(u.x, u.y)); });
  Range x = out.x, y = out.y;
  each_end([&](Point p, Point u) { x.include(p.x + u.x), y.include(p.y + u.y); });
  const double wide = x.high - x.low, high = y.high - y.low;
  if (high < 0.05 * wide && high > 0.0) out.stretched = 2;
  if (wide < 0.05 * high && wide > 0.0) out.stretched = 1;
  if (out.stretched != 0) {
    out.x = x, out.y = y;
    return out;
  }
  const double size = std::max(out.x.high - out.x.low, out.y.high - out.y.low),
               m = gap <= 1e-9 * size ? choose_magnification(size, displacement) : 1.0;
  each_end([&](Point p, Point u) { out.x.include(p.x + m * u.x), out.y.include(p.y + m * u.y); });
  out.magnification = m;
  return out;
}

// Axes of their own scales, with room around the ranges.
Chart stretched_view(const Box& frame, const Zoom& zoom, const std::string& unit) {
  const auto wider = [](const Range& r) {
    const double room = 0.12 * (r.high - r.low);
    return Range{r.low - room, r.high + room, false};
  };
  Chart chart;
  chart.frame = frame;
  chart.zero_line = false;
  chart.x = make_axis(wider(zoom.x), "x", unit, 4, true);
  chart.y = make_axis(wider(zoom.y), "y", unit, 5, true);
  return chart;
}

std::string scale_text(double magnification) {
  return magnification == 1.0 ? "to scale" : "displacements &#215; " + figure(magnification, 9);
}

std::string caption_of(const Scene& scene, const Extent& extent, double magnification) {
  const Point at = scene.bodies[extent.body].ends.empty() ? Point{} : scene.bodies[extent.body].ends[extent.end];
  std::string out = "Shape at " + place_at_end(scene) + ", " + scale_text(magnification) + ": the largest displacement is " +
                    figure(extent.displacement, scene.length_unit, 6) + " at (" + figure(at.x) + ", " + figure(at.y) + ")";
  if (scene.bodies.size() > 1) out += " of body " + std::to_string(extent.body + 1);
  return out + ".";
}

} // namespace

void draw_deformed(const Scene& scene, Pictures& out) {
  const Extent extent = measure(scene);
  const GapLift lift(scene);
  const double magnification = choose_magnification(extent.size, std::max(extent.displacement, lift.largest()));
  const bool zoom = has_contact(scene);
  Range x, y;
  for (size_t b = 0; b < scene.bodies.size(); ++b)
    for (const double m : {0.0, magnification})
      for (const auto& curve : deformed_outline(scene, b, m, &lift))
        for (const Point& p : curve) x.include(p.x), y.include(p.y);
  const Zoom near = choose_zoom(scene);
  std::vector<LegendEntry> entries;
  for (size_t b = 0; b < scene.bodies.size() && !scene.bodies[b].platen; ++b) // they are the last
    entries.push_back({"deformed body " + std::to_string(b + 1), Stroke{style_of(b).edge, 1.6, style_of(b).dash}, Mark::kNone,
                       true, style_of(b).fill});
  entries.push_back({"undeformed", Stroke{colour::kFaint, 1.0, "2 3"}, Mark::kNone, true, ""});
  const double left = 62.0, gap = 66.0, right = 14.0;
  const double top = 33.0 + draw_legend(nullptr, {left, 4.0}, kPictureWidth - left - right, entries);
  const double wide = zoom ? (kPictureWidth - left - gap - right) / 2.0 : kPictureWidth - left - right;
  const double high = view_height(x, y, wide, 240.0, zoom ? 420.0 : 460.0);
  Svg svg("deformed", kPictureWidth, top + high + 42.0);
  draw_legend(&svg, {left, 4.0}, kPictureWidth - left - right, entries);
  const Box whole{left, top, left + wide, top + high};
  draw_view(svg, scene, make_view(whole, x, y, 14.0, scene.length_unit), magnification, &lift);
  draw_heading(svg, whole, "Whole model, " + scale_text(magnification));
  if (zoom) {
    const Box part{whole.right + gap, top, whole.right + gap + wide, top + high};
    const Chart view = near.stretched != 0 ? stretched_view(part, near, scene.length_unit)
                                           : make_view(part, near.x, near.y, 26.0, scene.length_unit);
    draw_view(svg, scene, view, near.magnification, nullptr);
    draw_heading(svg, part,
                 near.stretched == 0   ? "Contact " + contact_zones(scene) + ", " + scale_text(near.magnification)
                 : near.stretched == 1 ? "Contact " + contact_zones(scene) + ", not magnified, x stretched"
                                       : "Contact " + contact_zones(scene) + ", not magnified, y stretched");
  }
  Picture picture{"deformed", "Deformed shape", caption_of(scene, extent, magnification), ""};
  if (zoom && magnification > near.magnification && near.magnification == 1.0)
    picture.caption += " In the left view the gaps between the bodies are magnified like the displacements.";
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
