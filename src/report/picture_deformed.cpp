#include "report/axes.hpp"
#include "report/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

struct Extent {
  double size = 0.0;         // larger side of the bounding box
  double displacement = 0.0; // largest
  size_t body = 0, end = 0;  // where that is
};

Extent measure(const Scene& scene) {
  Extent out;
  Range x, y;
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyScene& body = scene.bodies[b];
    for (const Point& p : body.ends) x.include(p.x), y.include(p.y);
    for (size_t i = 0; i < body.displacement.size(); ++i) {
      const double size = std::hypot(body.displacement[i].x, body.displacement[i].y);
      if (size > out.displacement) out.displacement = size, out.body = b, out.end = i;
    }
  }
  out.size = std::max(x.high - x.low, y.high - y.low);
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

void draw_view(Svg& svg, const Scene& scene, const Chart& view, double magnification, bool nodes) {
  draw_axes(svg, view);
  svg.begin_clip(view.frame);
  const char* const edge[2] = {colour::kBlue, "#8a5a00"};
  for (int pass = 0; pass < 2; ++pass)
    for (size_t b = 0; b < scene.bodies.size(); ++b) {
      std::vector<std::vector<Point>> curves = outline_of(scene.bodies[b], pass == 0 ? magnification : 0.0);
      for (auto& curve : curves)
        for (Point& p : curve) p = view.at(p.x, p.y);
      if (pass == 0)
        svg.area(curves, colour::kBody[b], Stroke{edge[b], 1.6, b == 0 ? "" : "7 2"});
      else
        svg.area(curves, "none", Stroke{colour::kFaint, 1.0, "2 3"});
      if (pass == 1 || !nodes) continue;
      const BodyScene& body = scene.bodies[b];
      for (size_t i = 0; i < body.ends.size(); ++i) {
        const Point p = view.at(body.ends[i].x + magnification * body.displacement[i].x,
                                body.ends[i].y + magnification * body.displacement[i].y);
        if (p.x >= view.frame.left && p.x <= view.frame.right) svg.mark(Mark::kCircle, p, 3.0, edge[b]);
      }
    }
  svg.end_clip();
}

// The contact zone's range, deformed and undeformed. Surfaces that lie on each other from the start may be
// drawn with larger displacements, a gap may not.
double choose_zoom(const Scene& scene, Range& x, Range& y) {
  double gap = 0.0, displacement = 0.0;
  for (const PairScene& pair : scene.pairs) {
    for (const Point& p : pair.on) x.include(p.x), y.include(p.y);
    gap = std::max(gap, std::hypot(pair.on[1].x - pair.on[0].x, pair.on[1].y - pair.on[0].y));
  }
  const double size = std::max(x.high - x.low, y.high - y.low);
  const auto each = [&](auto&& take) {
    for (const BodyScene& body : scene.bodies)
      for (size_t i = 0; i < body.ends.size(); ++i)
        if (body.status[i] >= 0) take(body.ends[i], body.displacement[i]);
  };
  each([&](Point, Point u) { displacement = std::max(displacement, std::hypot(u.x, u.y)); });
  const double m = gap <= 1e-9 * size ? choose_magnification(size, displacement) : 1.0;
  each([&](Point p, Point u) { x.include(p.x + m * u.x), y.include(p.y + m * u.y); });
  return m;
}

std::string scale_text(double magnification) {
  return magnification == 1.0 ? "true scale" : "displacements &#215; " + figure(magnification, 9);
}

} // namespace

void draw_deformed(const Scene& scene, Pictures& out) {
  const Extent extent = measure(scene);
  const double magnification = choose_magnification(extent.size, extent.displacement);
  const bool zoom = !scene.pairs.empty();
  Range x, y, zoom_x, zoom_y;
  for (const BodyScene& body : scene.bodies)
    for (const double m : {0.0, magnification})
      for (const auto& curve : outline_of(body, m))
        for (const Point& p : curve) x.include(p.x), y.include(p.y);
  const double zoom_magnification = choose_zoom(scene, zoom_x, zoom_y);
  const double left = 62.0, gap = 66.0, right = 14.0, top = 54.0;
  const double wide = zoom ? (kPictureWidth - left - gap - right) / 2.0 : kPictureWidth - left - right;
  const double high = view_height(x, y, wide, 240.0, zoom ? 420.0 : 460.0);
  Svg svg("deformed", kPictureWidth, top + high + 42.0);
  std::vector<LegendEntry> entries;
  entries.push_back({"deformed body 1", Stroke{colour::kBlue, 1.6, ""}, Mark::kNone, true, colour::kBody[0]});
  if (scene.bodies.size() > 1)
    entries.push_back(
        {"deformed body 2", Stroke{"#8a5a00", 1.6, "7 2"}, Mark::kNone, true, colour::kBody[1]});
  entries.push_back({"undeformed", Stroke{colour::kFaint, 1.0, "2 3"}, Mark::kNone, true, ""});
  draw_legend(&svg, {left, 4.0}, kPictureWidth - left - right, entries);
  const Box whole{left, top, left + wide, top + high};
  draw_view(svg, scene, make_view(whole, x, y, 14.0, scene.length_unit), magnification, false);
  draw_heading(svg, whole, "Whole model, " + scale_text(magnification));
  if (zoom) {
    const Box part{whole.right + gap, top, whole.right + gap + wide, top + high};
    draw_view(svg, scene, make_view(part, zoom_x, zoom_y, 26.0, scene.length_unit), zoom_magnification, true);
    draw_heading(svg, part, "Contact zone, " + scale_text(zoom_magnification));
  }
  const Point at =
      scene.bodies[extent.body].ends.empty() ? Point{} : scene.bodies[extent.body].ends[extent.end];
  Picture picture{"deformed", "Deformed shape", "", ""};
  picture.caption = "Shape at load factor " + figure(scene.summary.load);
  if (!scene.pairs.empty()) picture.caption += ", &#956; = " + figure(scene.summary.mu);
  picture.caption += ", " + scale_text(magnification) + ": the largest displacement is " +
                     figure(extent.displacement, scene.length_unit, 6) + " at (" + figure(at.x) + ", " +
                     figure(at.y) + ")";
  if (scene.bodies.size() > 1) picture.caption += " of body " + std::to_string(extent.body + 1);
  picture.caption += ".";
  if (zoom && magnification > zoom_magnification && zoom_magnification == 1.0)
    picture.caption +=
        " The gap between the bodies is not magnified, so they seem to overlap in the left view.";
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
