#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr size_t kMostFatigueLines = 4;
constexpr double kShownPart = 0.1;  // of the largest value: the picture shows the stretch where the parameter is larger, and
constexpr double kBesidePart = 0.3; // this part of it on both sides
constexpr double kFatigueHeight = 150.0;

// The stretch of a line that is shown.
Range stretch_of(const FatigueLine& line) {
  double most = 0.0;
  for (const auto& p : line.points) most = std::max(most, p[1]);
  Range out;
  for (const auto& p : line.points)
    if (p[1] >= kShownPart * most) out.include(p[0]);
  const double beside = kBesidePart * (out.high - out.low);
  Range shown;
  for (const double end : {out.low - beside, out.high + beside})
    shown.include(std::clamp(end, line.points.front()[0], line.points.back()[0]));
  return shown;
}

void draw_fatigue_line(Svg& svg, const Box& frame, const Scene& scene, const FatigueLine& line) {
  const Range stretch = stretch_of(line);
  Range values;
  values.include(0.0);
  std::vector<Point> points;
  for (const auto& p : line.points)
    if (p[0] >= stretch.low && p[0] <= stretch.high) values.include(p[1]), points.push_back({p[0], p[1]});
  const std::string unit = row_of(line.what).unit == Unit::kStress  ? scene.stress_unit
                           : row_of(line.what).unit == Unit::kForce ? scene.force_unit
                                                                    : std::string();
  const Chart chart{frame, make_axis(stretch, "distance along " + escape_xml(line.along), scene.length_unit, 6, true),
                    make_axis(values, name_of(line.what), unit, 5)};
  draw_axes(svg, chart);
  std::vector<Point> pixels;
  for (const Point& p : points) pixels.push_back(chart.at(p));
  svg.polyline(pixels, Stroke{colour::kBlue, 1.6, ""});
  const auto most = std::max_element(points.begin(), points.end(), [](Point a, Point b) { return a.y < b.y; });
  if (most != points.end()) svg.mark(Mark::kCircle, chart.at(*most), 7.0, colour::kOrange, true);
}

} // namespace

void draw_fatigue(const Scene& scene, Pictures& out) {
  std::vector<const FatigueLine*> lines;
  for (const FatigueLine& line : scene.record->meshes.fatigue)
    if (line.points.size() > 2 && lines.size() < kMostFatigueLines &&
        std::any_of(line.points.begin(), line.points.end(), [](const auto& p) { return p[1] > 0.0; }))
      lines.push_back(&line);
  if (lines.empty()) return;
  const double step = kFatigueHeight + 84.0;
  Svg svg("fatigue", kPictureWidth, step * static_cast<double>(lines.size()));
  for (size_t i = 0; i < lines.size(); ++i) {
    const double top = 30.0 + step * static_cast<double>(i);
    const Box frame{72.0, top, kPictureWidth - 18.0, top + kFatigueHeight};
    draw_fatigue_line(svg, frame, scene, *lines[i]);
    draw_heading(svg, frame, std::string(name_of(lines[i]->what)) + ", " + body_label(scene, lines[i]->body));
  }
  Picture picture{
      "fatigue", "Fatigue parameters along the surface",
      "Over the last cycle, where they are above a tenth of their largest value: at the nodes, those of Ruiz at the "
      "pairs, and at edges of contacts that slip. The circle is the largest.",
      ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
