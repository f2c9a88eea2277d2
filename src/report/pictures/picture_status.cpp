#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// A stretch of the path over which no status changes.
struct Band {
  double from, to;
  const std::string* status;
};

// With event stepping the status of a point is valid until the next point; between the increments of the deck's
// stepping only what was found at their ends is known, and is shown below them.
std::vector<Band> find_bands(const CoefficientHistory& history, const std::vector<double>& height, bool backwards) {
  std::vector<Band> out;
  const size_t n = history.points.size();
  const auto add = [&](double from, double to, const PathPoint& p) {
    if (to > from && !p.status.empty()) {
      if (!out.empty() && *out.back().status == p.status)
        out.back().to = to;
      else
        out.push_back({from, to, &p.status});
    }
  };
  if (n == 0) return out;
  if (backwards || n == 1) {
    for (size_t i = 0; i < n; ++i) add(i == 0 ? 0.0 : height[i - 1], height[i], history.points[i]);
    return out;
  }
  if (history.points[0].kind != C2D_STEP_CHANGE) add(0.0, height[0], history.points[0]);
  for (size_t i = 0; i + 1 < n; ++i) add(height[i], height[i + 1], history.points[i]);
  return out;
}

} // namespace

std::vector<double> borders_of(const ZoneScene& zone) {
  const std::vector<ZoneSample>& p = zone.samples;
  const size_t n = p.size();
  std::vector<double> out(n + 1, 0.0);
  for (size_t i = 1; i < n; ++i) out[i] = 0.5 * (p[i - 1].s + p[i].s);
  out[0] = p[0].s;
  out[n] = p[n - 1].s;
  if (n == 1) out[0] -= 0.5, out[1] += 0.5;
  return out;
}

void draw_status_row(Svg& svg, const Chart& chart, const ZoneScene& zone, const std::vector<double>& border,
                     const std::string& status, double top, double bottom, const StatusFills& fills) {
  for (size_t i = 0; i < zone.samples.size();) {
    const char now = status[zone.samples[i].pair];
    size_t end = i + 1;
    while (end < zone.samples.size() && status[zone.samples[end].pair] == now) ++end;
    const double a = chart.at(border[i], 0.0).x, b = chart.at(border[end], 0.0).x;
    i = end;
    if (now != C2D_OPEN)
      svg.rectangle({std::min(a, b), top, std::max(a, b), bottom}, fills.of[now == C2D_STICK ? 1 : 2], Stroke{});
  }
}

StatusFills status_fills(Svg& svg) { return {{"white", colour::kBlue, svg.hatch(colour::kOrange, "#fbe3d0")}}; }

std::vector<LegendEntry> fills_legend(const StatusFills& fills) {
  const Stroke thin{colour::kFaint, 0.6, ""};
  return {{"open", thin, Mark::kNone, true, fills.of[0]},
          {"stick", thin, Mark::kNone, true, fills.of[1]},
          {"slip", thin, Mark::kNone, true, fills.of[2]}};
}

namespace {

std::string status_caption(const Scene& scene, const ZoneScene& zone, size_t coefficient) {
  const CoefficientRecord& record = scene.record->coefficients[coefficient];
  const CoefficientHistory& history = scene.history->coefficients()[coefficient];
  const ZoneFacts f = find_facts(scene, zone, record.table);
  const size_t events = static_cast<size_t>(history.points.empty() ? 0 : history.points.back().events);
  std::string out = "Which part of the zone was open, stuck or slipped along the load path, with " + std::to_string(events) +
                    (events == 1 ? " event" : " events") + "; at " + place_on_path(scene, coefficient) + ": " +
                    std::to_string(f.sticking) + " of " + std::to_string(zone.pairs) + " pairs stick, " +
                    std::to_string(f.slipping) + " slip, " + std::to_string(static_cast<int32_t>(zone.pairs) - f.touching) +
                    " are open";
  if (f.sticking > 0) out += words_of_sticking(scene, zone, f);
  return out + ".";
}

void draw_bands(Svg& svg, const Chart& chart, const ZoneScene& zone, const std::vector<Band>& bands,
                const std::vector<double>& border, const StatusFills& fills) {
  svg.raw("<g shape-rendering=\"crispEdges\">\n"); // no seams
  for (const Band& band : bands)
    draw_status_row(svg, chart, zone, border, *band.status, chart.at(0.0, band.to).y, chart.at(0.0, band.from).y, fills);
  svg.raw("</g>\n");
}

void draw_status_of(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  const ZoneScene& zone = scene.zones[zone_index];
  if (is_tied(scene.record->coefficients[coefficient], zone)) return; // everywhere, at every load
  const CoefficientHistory& history = scene.history->coefficients()[coefficient];
  const bool by_load = rises(history);
  std::vector<double> height = positions_by_step(history);
  for (size_t i = 0; by_load && i < height.size(); ++i) height[i] = history.points[i].load;
  const std::vector<Band> bands = find_bands(history, height, scene.summary.stepping == C2D_STEPPING_DECK);
  if (bands.empty()) return;
  const std::string name = "status" + chart_suffix(scene, coefficient, zone_index);
  Svg svg(name, kPictureWidth, 400.0);
  const StatusFills fills = status_fills(svg);
  const Box frame{66.0, 34.0, kPictureWidth - 18.0, 352.0};
  draw_legend(&svg, {frame.left, 4.0}, frame.width(), fills_legend(fills));
  const std::vector<double> border = borders_of(zone);
  Range y;
  y.include(0.0);
  for (const double h : height) y.include(h);
  const Chart chart{frame, position_axis(scene, zone), make_axis(y, by_load ? "load factor" : "step", "", 7, true, !by_load)};
  draw_axes(svg, chart);
  draw_bands(svg, chart, zone, bands, border, fills);
  svg.rectangle(frame, "none", Stroke{colour::kInk, 1.0, ""});
  for (const ZoneSample& p : zone.samples) { // where the pairs are
    const double x = chart.at(p.s, 0.0).x;
    svg.line({x, frame.top - 4.0}, {x, frame.top}, Stroke{colour::kGreen, 1.2, ""});
  }
  Picture picture{
      name, "Open, stick and slip over the load" + chart_title(scene, friction_of(scene, coefficient, zone_index), zone_index),
      status_caption(scene, zone, coefficient), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_status_map(const Scene& scene, Pictures& out) {
  draw_charts(scene, std::min(scene.record->coefficients.size(), scene.history->coefficients().size()), draw_status_of, out);
}

} // namespace app
