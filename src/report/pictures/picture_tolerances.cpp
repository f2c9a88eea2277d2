#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr size_t kMostToleranceRows = 16, kOwnFills = 5; // numbers; parameters with a fill of their own
constexpr double kToleranceRow = 34.0;

struct ToleranceBar {
  std::string name;
  std::vector<double> shares; // percent of the number, of an edge of the length of contact; one per fill
  double worst, root;
};

// The numbers with derivatives by all parameters; the parameters without a fill of their own are added up.
std::vector<ToleranceBar> bars_of(const Scene& scene, const ToleranceTable& table) {
  std::vector<ToleranceBar> out;
  for (const Toleranced& t : table.numbers) {
    const double scale = t.number.scale / 100.0;
    if (!(scale > 0.0) || !(table.worst_case(t) > 0.0)) continue; // also without a derivative
    ToleranceBar bar{escape_xml(table.name_of(t)), {}, table.worst_case(t) / scale, table.root_of_squares(t) / scale};
    if (t.number.zone > 0 && table.is_of_several_zones())
      bar.name += ", " + zone_label(scene, static_cast<size_t>(t.number.zone) - 1);
    for (size_t p = 0; p < table.parameters.size(); ++p) {
      if (p <= kOwnFills) bar.shares.push_back(0.0);
      bar.shares.back() += table.share(t, p) / scale;
    }
    out.push_back(bar);
  }
  std::stable_sort(out.begin(), out.end(), [](const ToleranceBar& a, const ToleranceBar& b) { return a.worst > b.worst; });
  if (out.size() > kMostToleranceRows) out.resize(kMostToleranceRows);
  return out;
}

std::vector<LegendEntry> legend_of_parameters(Svg& svg, const ToleranceTable& table) {
  const std::string fills[] = {colour::kBlue, svg.hatch(colour::kOrange, "#fbe3d0"),
                               "#a4b494",     svg.hatch(colour::kPurple, "#e8d0dc"),
                               colour::kInk,  "#eeeeee"};
  const char* const edges[] = {colour::kBlue, colour::kOrange, "#33521f", colour::kPurple, colour::kInk, colour::kFaint};
  std::vector<LegendEntry> out;
  for (size_t p = 0; p < std::min(table.parameters.size(), kOwnFills + 1); ++p) {
    const bool rest = p == kOwnFills && table.parameters.size() > kOwnFills + 1;
    const ToleranceOf& t = table.parameters[p];
    const std::string text = rest ? "all others" : escape_xml(t.name) + " &#177; " + figure(t.size);
    out.push_back({text, Stroke{edges[p], 0.8, ""}, Mark::kNone, true, fills[p]});
  }
  return out;
}

void draw_tolerance_bar(Svg& svg, const Chart& chart, double y, const ToleranceBar& bar,
                        const std::vector<LegendEntry>& fills) {
  double from = 0.0;
  for (size_t p = 0; p < bar.shares.size(); ++p) {
    const double left = chart.at(from, 0.0).x, right = chart.at(from += bar.shares[p], 0.0).x;
    if (right - left > 0.2) svg.rectangle({left, y, right, y + 11.0}, fills[p].fill, fills[p].stroke);
  }
  const double root = chart.at(bar.root, 0.0).x;
  svg.line({root, y - 3.0}, {root, y + 14.0}, Stroke{colour::kInk, 2.0, ""});
}

} // namespace

void draw_tolerances(const Scene& scene, Pictures& out) {
  const ToleranceTable& table = scene.record->meshes.tolerances;
  const std::vector<ToleranceBar> bars = bars_of(scene, table);
  if (bars.empty()) return;
  Range range;
  range.include(0.0);
  for (const ToleranceBar& bar : bars) range.include(bar.worst);
  Svg svg("tolerances", kPictureWidth, 0.0);
  const std::vector<LegendEntry> entries = legend_of_parameters(svg, table);
  const double left = 18.0, right = kPictureWidth - 24.0;
  const double top = 12.0 + draw_legend(&svg, {left, 4.0}, right - left, entries);
  const double bottom = top + kToleranceRow * static_cast<double>(bars.size());
  Chart chart{{left, top, right, bottom},
              make_axis(range, "change, % of the number (of an edge: of the length of contact)", "", 6),
              Axis{}};
  chart.y.low = 0.0, chart.y.high = 1.0, chart.y.ticks = 0;
  draw_axes(svg, chart);
  for (size_t i = 0; i < bars.size(); ++i) {
    const double y = top + kToleranceRow * static_cast<double>(i);
    svg.text({left + 6.0, y + 13.0}, bars[i].name, 11.0, Anchor::kStart, colour::kInk, false, true);
    draw_tolerance_bar(svg, chart, y + 18.0, bars[i], entries);
  }
  svg.set_height(bottom + 44.0);
  Picture picture{
      "tolerances", "Tolerances of parameters",
      "What the tolerances of the parameters change in each number: one share beside the other up to the worst case; "
      "the stroke is the root of the sum of their squares.",
      ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
