#include "figures.hpp"

#include "report/drawn/axes.hpp"

#include <algorithm>
#include <cmath>

namespace chapter9 {
namespace {

using app::Anchor, app::Box, app::Chart, app::LegendEntry, app::Mark, app::Point, app::Stroke, app::Svg;
namespace colour = app::colour;

constexpr double kWide = 400, kHigh = 300; // a panel with its legend and labels
constexpr double kLeft = 62, kRight = 14, kLegend = 62, kBelow = 44;

struct Style {
  Stroke stroke;
  Mark mark;
  bool filled;
};
Style style_of(Look look) {
  switch (look) {
  case Look::kFirst:
    return {{colour::kOrange, 1.6, "6 3"}, Mark::kTriangle, false};
  case Look::kSecond:
    return {{colour::kGreen, 1.6, "2 3"}, Mark::kSquare, false};
  case Look::kThird:
    return {{colour::kPurple, 1.6, "9 3 2 3"}, Mark::kDiamond, false};
  default:
    return {{colour::kBlue, 1.8, ""}, Mark::kCircle, true};
  }
}
const Stroke kContinuum{"#b0b0b0", 4.0, ""};

LegendEntry entry_of(const std::string& name, Look look) {
  const Style style = style_of(look);
  return {name, style.stroke, style.mark, style.filled, ""};
}

void draw_continuum(Svg& svg, const Chart& chart, const Adhesion& continuum) {
  std::vector<Point> points;
  const int n = 200;
  for (int i = 0; i <= n; ++i) {
    const double t = 1.0 - static_cast<double>(i) / n, x = continuum.half_width() * (1 - t * t);
    points.push_back(chart.at(x, continuum.friction(x)));
  }
  svg.polyline(points, kContinuum);
}

void draw_run(Svg& svg, const Chart& chart, const Series& series, const Adhesion* minus) {
  const Style style = style_of(series.look);
  const double unit = minus != nullptr ? 100 / largest_friction(*series.run) : 1.0;
  std::vector<Point> points;
  for (const Node& node : series.run->nodes) {
    const double taken_off = minus != nullptr ? minus->friction(node.x) : 0.0;
    if (minus != nullptr && node.x > kInside * minus->half_width()) break;
    points.push_back(chart.at(node.x, unit * (node.friction - taken_off)));
    if (!node.closed) break; // the first open one ends the curve
  }
  svg.polyline(points, style.stroke);
  for (const Point& at : points) svg.mark(style.mark, at, 5.5, style.stroke.colour, style.filled);
}

void draw_panel(Svg& svg, Point corner, const Panel& panel, const Adhesion& continuum) {
  const Box frame{corner.x + kLeft, corner.y + kLegend, corner.x + kWide - kRight, corner.y + kHigh - kBelow};
  const bool difference = panel.against == Against::kDifference;
  app::Range x, y;
  x.include(0), x.include(1);
  y.include(difference ? -6 : 0), y.include(difference ? 6 : 0.32);
  const Chart chart{frame, app::make_axis(x, "distance from the axis x / a", "", 5),
                    app::make_axis(y,
                                   difference ? "difference from the continuum [%]" : "friction / p&#8320;",
                                   "", 7, true)};
  svg.text({corner.x + kLeft, corner.y + 14}, panel.heading, 12.5);
  std::vector<LegendEntry> entries;
  for (const Series& series : panel.series)
    if (!series.name.empty()) entries.push_back(entry_of(series.name, series.look));
  if (panel.against == Against::kContinuum)
    entries.push_back({"continuum", kContinuum, Mark::kNone, true, ""});
  app::draw_legend(&svg, {corner.x + kLeft, corner.y + 22}, kWide - kLeft - kRight, entries);
  app::draw_axes(svg, chart);
  svg.begin_clip(Box{frame.left - 4, frame.top, frame.right + 4, frame.bottom + 4});
  if (panel.against == Against::kContinuum) draw_continuum(svg, chart, continuum);
  for (const Series& series : panel.series) draw_run(svg, chart, series, difference ? &continuum : nullptr);
  svg.end_clip();
}

// Decades as lines and labels; places are powers of ten.
void draw_decades(Svg& svg, const Chart& chart, bool vertical, const std::vector<std::string>& labels) {
  const Box& f = chart.frame;
  const double low = vertical ? chart.y.low : chart.x.low;
  for (size_t i = 0; i < labels.size(); ++i) {
    const double at = low + static_cast<double>(i);
    for (int part = 1; part < 10 && at + std::log10(part) <= (vertical ? chart.y.high : chart.x.high);
         ++part) {
      const double place = at + std::log10(part);
      const Stroke grid{colour::kGrid, part == 1 ? 1.0 : 0.4, ""};
      if (vertical)
        svg.line({f.left, chart.at(0, place).y}, {f.right, chart.at(0, place).y}, grid);
      else
        svg.line({chart.at(place, 0).x, f.top}, {chart.at(place, 0).x, f.bottom}, grid);
    }
    if (vertical)
      svg.text({f.left - 7, chart.at(0, at).y + 4}, labels[i], 11, Anchor::kEnd);
    else
      svg.text({chart.at(at, 0).x, f.bottom + 16}, labels[i], 11, Anchor::kMiddle);
  }
}

void draw_convergence(Svg& svg, Point corner, double wide, const std::vector<Convergence>& all) {
  const Box frame{corner.x + kLeft, corner.y + 50, corner.x + wide - kRight, corner.y + kHigh - kBelow};
  Chart chart{frame, {}, {}};
  chart.x.low = 1, chart.x.high = 3.7;
  chart.y.low = -2, chart.y.high = 1.4;
  svg.text({corner.x + kLeft, corner.y + 14},
           "Root of the mean square of the difference from event following, which needs one increment", 12.5);
  std::vector<LegendEntry> entries;
  for (const Convergence& c : all) entries.push_back(entry_of(c.name, c.look));
  app::draw_legend(&svg, {corner.x + kLeft, corner.y + 22}, wide - kLeft - kRight, entries);
  draw_decades(svg, chart, false, {"10", "100", "1000"});
  draw_decades(svg, chart, true, {"0.01", "0.1", "1", "10"});
  svg.rectangle(frame, "none", {colour::kInk, 1.0, ""});
  svg.text({0.5 * (frame.left + frame.right), frame.bottom + 33}, "increments of the load", 12,
           Anchor::kMiddle);
  svg.text({frame.left - 44, 0.5 * (frame.top + frame.bottom)}, "rms [% of the largest friction]", 12,
           Anchor::kMiddle, colour::kInk, true);
  for (const Convergence& c : all) {
    const Style style = style_of(c.look);
    std::vector<Point> points;
    for (size_t i = 0; i < c.increments.size(); ++i)
      points.push_back(
          chart.at(std::log10(c.increments[i]), std::log10(std::max(0.01, 100 * c.difference[i]))));
    svg.polyline(points, style.stroke);
    for (const Point& at : points) svg.mark(style.mark, at, 6, style.stroke.colour, style.filled);
  }
}

} // namespace

std::string draw_sheet(const std::vector<Panel>& panels, const Adhesion& continuum,
                       const std::vector<Convergence>& convergence) {
  const size_t rows = (panels.size() + 1) / 2;
  constexpr double kTop = 48;
  Svg svg("chapter9", 2 * kWide, kTop + static_cast<double>(rows + 1) * kHigh);
  svg.rectangle({0, 0, svg.width(), svg.height()}, "white", Stroke{});
  svg.text({kLeft, 18},
           "Friction under a rigid cylinder pressed on a half plane that adheres to it (Poisson's ratio 0.3)",
           14);
  svg.text({kLeft, 35},
           "a, p&#8320;: half width and largest pressure without friction, under the same load; 14 linear "
           "elements over a, as in 1987",
           11.5);
  for (size_t i = 0; i < panels.size(); ++i)
    draw_panel(svg, {static_cast<double>(i % 2) * kWide, kTop + static_cast<double>(i / 2) * kHigh},
               panels[i], continuum);
  draw_convergence(svg, {0, kTop + static_cast<double>(rows) * kHigh}, 2 * kWide, convergence);
  return svg.finish(
      "Increments of the load and friction under full adhesion",
      "Friction under a rigid cylinder that adheres to a half plane, for several increments of the load "
      "and sizes of elements, against event following and the continuum.");
}

} // namespace chapter9
