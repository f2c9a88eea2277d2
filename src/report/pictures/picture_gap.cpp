#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

void draw_column(Svg& svg, const ZoneScene& zone, const std::vector<double>& table, size_t column, const Chart& chart,
                 const Stroke& stroke) {
  std::vector<Point> points;
  for (const ZoneSample& p : zone.samples) {
    const double turn = column == C2D_SLIP_SUM ? p.turn : 1.0;
    points.push_back(chart.at(p.s, turn * table[p.pair * C2D_PAIR_FIELDS + column]));
  }
  svg.polyline(points, stroke);
  for (size_t i = 0; i < points.size(); ++i) {
    const int status = static_cast<int>(table[zone.samples[i].pair * C2D_PAIR_FIELDS + C2D_STATUS]);
    svg.mark(status_mark(status), points[i], status == C2D_OPEN ? 5.0 : 6.0, stroke.colour);
  }
}

struct Largest {
  double value = 0.0;
  size_t pair = 0;
};
Largest find_largest(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table, size_t column,
                     bool touching) {
  Largest out{0.0, zone.first};
  const double nothing = 1e-12 * std::fabs(scene.pairs[zone.first].s - scene.pairs[zone.first + zone.pairs - 1].s);
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) {
    const double* row = table.data() + p * C2D_PAIR_FIELDS;
    if (touching && static_cast<int>(row[C2D_STATUS]) == C2D_OPEN) continue;
    if (std::fabs(row[column]) > std::max(nothing, std::fabs(out.value))) out = {row[column], p};
  }
  return out;
}

std::string caption(const Scene& scene, const ZoneScene& zone, size_t coefficient) {
  const CoefficientRecord& record = scene.record->coefficients[coefficient];
  const Largest gap = find_largest(scene, zone, record.table, C2D_GAP, false);
  const Largest slip = find_largest(scene, zone, record.table, C2D_SLIP_SUM, true);
  std::string out = "At " + place_on_path(scene, coefficient) + " the widest gap is " +
                    figure(gap.value, scene.length_unit, 6) + " (pair " + std::to_string(gap.pair + 1) + ")";
  if (slip.value != 0.0)
    out += "; the largest slip of a touching pair is " + figure(slip.value, scene.length_unit, 6) + " at " + zone.position +
           " = " + figure(scene.pairs[slip.pair].s, scene.length_unit) + " (pair " + std::to_string(slip.pair + 1) + ")";
  else
    out += "; no touching pair has slipped";
  return out + ".";
}

// Gap or slip over the zone; without what is zero everywhere.
struct Panel {
  size_t column;
  Range range;
  std::string name, heading;
  Stroke stroke;
};

std::vector<Panel> find_panels(const ZoneScene& zone, const std::vector<double>& table, double nothing) {
  std::vector<Panel> all{
      {C2D_GAP, {}, "gap", "Normal gap", Stroke{colour::kGreen, 2.0, ""}},
      {C2D_SLIP_SUM,
       {},
       "slip",
       "Slip of body " + std::to_string(zone.body[1]) + " against body " + std::to_string(zone.body[0]) + " along t, summed up",
       Stroke{colour::kPurple, 2.0, "6 2"}}};
  std::vector<Panel> out;
  for (Panel& panel : all) {
    panel.range.include(0.0);
    for (const ZoneSample& p : zone.samples) {
      const double value = table[p.pair * C2D_PAIR_FIELDS + panel.column];
      if (std::fabs(value) > nothing) panel.range.include(panel.column == C2D_SLIP_SUM ? p.turn * value : value);
    }
    if (panel.range.low < 0.0 || panel.range.high > 0.0) out.push_back(panel);
  }
  return out;
}

void draw_gap_of(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  const ZoneScene& zone = scene.zones[zone_index];
  const CoefficientRecord& record = scene.record->coefficients[coefficient];
  Range s;
  for (const ZoneSample& p : zone.samples) s.include(p.s);
  const std::vector<Panel> panels = find_panels(zone, record.table, 1e-12 * (s.high - s.low)); // round-off is no gap
  if (panels.empty()) return;
  const double left = 66.0, right = kPictureWidth - 18.0, top = 54.0, high = 170.0;
  const double bottom = top + static_cast<double>(panels.size()) * (high + 30.0) - 30.0;
  const std::string name = "gap" + chart_suffix(scene, coefficient, zone_index);
  Svg svg(name, kPictureWidth, bottom + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, status_legend(is_tied(record, zone)));
  const Axis axis = position_axis(scene, zone);
  for (size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    const double from = top + static_cast<double>(i) * (high + 30.0);
    const Chart chart{{left, from, right, from + high}, axis, make_axis(panel.range, panel.name, scene.length_unit, 5)};
    draw_axes(svg, chart, i + 1 == panels.size());
    draw_heading(svg, chart.frame, panel.heading);
    draw_column(svg, zone, record.table, panel.column, chart, panel.stroke);
  }
  const char* title = panels.size() == 2 ? "Gap and slip" : panels[0].column == C2D_GAP ? "Gap" : "Slip";
  Picture picture{name, title + chart_title(scene, friction_of(scene, coefficient, zone_index), zone_index),
                  caption(scene, zone, coefficient), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_gap(const Scene& scene, Pictures& out) { draw_charts(scene, scene.record->coefficients.size(), draw_gap_of, out); }

} // namespace app
