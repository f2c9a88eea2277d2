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

// 1, 2 or 5 times a power of ten, so that the largest displacement is drawn about a twelfth of the model.
double choose_magnification(const Extent& extent) {
  if (extent.displacement <= 1e-12 * extent.size) return 1.0;
  const double wanted = extent.size / 12.0 / extent.displacement;
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

} // namespace

void draw_deformed(const Scene& scene, Pictures& out) {
  const Extent extent = measure(scene);
  const double magnification = choose_magnification(extent);
  const bool zoom = !scene.pairs.empty();
  Range x, y, zoom_x, zoom_y;
  for (const BodyScene& body : scene.bodies)
    for (const double m : {0.0, magnification})
      for (const auto& curve : outline_of(body, m))
        for (const Point& p : curve) x.include(p.x), y.include(p.y);
  for (const PairScene& pair : scene.pairs)
    for (const Point& p : pair.on) zoom_x.include(p.x), zoom_y.include(p.y);
  for (size_t b = 0; b < scene.bodies.size(); ++b)
    for (size_t i = 0; i < scene.bodies[b].ends.size(); ++i)
      if (scene.bodies[b].status[i] >= 0) {
        const Point p = scene.bodies[b].ends[i], u = scene.bodies[b].displacement[i];
        zoom_x.include(p.x + u.x), zoom_y.include(p.y + u.y);
      }
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
  draw_view(svg, scene, make_view(whole, x, y, 0.06, scene.length_unit), magnification, false);
  draw_heading(svg, whole, "Displacements " + figure(magnification) + " times as large");
  if (zoom) {
    const Box part{whole.right + gap, top, whole.right + gap + wide, top + high};
    draw_view(svg, scene, make_view(part, zoom_x, zoom_y, 0.12, scene.length_unit), 1.0, true);
    draw_heading(svg, part, "Contact zone, true scale");
  }
  const Point at =
      scene.bodies[extent.body].ends.empty() ? Point{} : scene.bodies[extent.body].ends[extent.end];
  Picture picture{"deformed", "Deformed shape", "", ""};
  picture.caption = "Shape at load factor " + figure(scene.summary.load);
  if (!scene.pairs.empty()) picture.caption += ", &#956; = " + figure(scene.summary.mu);
  picture.caption += ", displacements drawn " + figure(magnification) + " times as large: the largest is " +
                     figure(extent.displacement, scene.length_unit, 6) + " at (" + figure(at.x) + ", " +
                     figure(at.y) + ")";
  if (scene.bodies.size() > 1) picture.caption += " of body " + std::to_string(extent.body + 1);
  picture.caption += ".";
  if (zoom && magnification > 1.0)
    picture.caption +=
        " The gap between the bodies is not magnified, so they seem to overlap in the left view.";
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
