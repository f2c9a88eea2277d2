#include "report/axes.hpp"
#include "report/pictures.hpp"
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
    out += "; the largest slip of a touching pair is " + figure(slip.value, scene.length_unit, 6) +
           " at s = " + figure(scene.pairs[slip.pair].s, scene.length_unit) + " (pair " + std::to_string(slip.pair + 1) + ")";
  else
    out += "; no touching pair has slipped";
  return out + ".";
}

void draw_one(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  const ZoneScene& zone = scene.zones[zone_index];
  const CoefficientRecord& record = scene.record->coefficients[coefficient];
  const double left = 76.0, right = kPictureWidth - 16.0, top = 54.0, high = 170.0, bottom = top + 2.0 * high + 30.0;
  const std::string name = "gap" + chart_suffix(scene, coefficient, zone_index);
  Svg svg(name, kPictureWidth, bottom + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, status_legend());
  Range s, gap, slip;
  gap.include(0.0);
  slip.include(0.0);
  for (const ZoneSample& p : zone.samples) s.include(p.s);
  const double nothing = 1e-12 * (s.high - s.low); // round-off is no gap
  for (const ZoneSample& p : zone.samples) {
    const double* row = record.table.data() + p.pair * C2D_PAIR_FIELDS;
    if (std::fabs(row[C2D_GAP]) > nothing) gap.include(row[C2D_GAP]);
    if (std::fabs(row[C2D_SLIP_SUM]) > nothing) slip.include(p.turn * row[C2D_SLIP_SUM]);
  }
  const Axis axis = make_axis(s, position_name(scene, zone), scene.length_unit, 9);
  const Chart upper{{left, top, right, top + high}, axis, make_axis(gap, "gap", scene.length_unit, 5)};
  const Chart lower{{left, top + high + 30.0, right, bottom}, axis, make_axis(slip, "slip", scene.length_unit, 5)};
  draw_axes(svg, upper, false);
  draw_heading(svg, upper.frame, "Normal gap");
  draw_column(svg, zone, record.table, C2D_GAP, upper, Stroke{colour::kGreen, 2.0, ""});
  draw_axes(svg, lower);
  draw_heading(svg, lower.frame,
               "Accumulated slip of " + body_label(scene, zone.body[1]) + " against " + body_label(scene, zone.body[0]) +
                   ", along t");
  draw_column(svg, zone, record.table, C2D_SLIP_SUM, lower, Stroke{colour::kPurple, 2.0, "6 2"});
  const auto say_zero = [&](const Chart& chart, const Range& range) {
    if (range.low == 0.0 && range.high == 0.0)
      svg.text({0.5 * (left + right), 0.5 * (chart.frame.top + chart.frame.bottom)}, "zero everywhere", 12.0, Anchor::kMiddle,
               colour::kInk, false, true);
  };
  say_zero(upper, gap);
  say_zero(lower, slip);
  Picture picture{name, "Gap and slip, " + chart_title(scene, friction_of(scene, coefficient, zone_index), zone_index),
                  caption(scene, zone, coefficient), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_gap(const Scene& scene, Pictures& out) { draw_charts(scene, scene.record->coefficients.size(), draw_one, out); }

} // namespace app
