#include "report/axes.hpp"
#include "report/pictures.hpp"

#include <cmath>

namespace app {
namespace {

// Earlier steps: thin, each with a dash of its own.
const Stroke kEarlier[] = {
    {colour::kFaint, 1.1, "2 3"}, {colour::kFaint, 1.1, "6 3"}, {colour::kFaint, 1.1, "10 3 2 3"}};

std::vector<Point> curve_of(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table,
                            size_t column, const Chart& chart, double factor = 1.0) {
  std::vector<Point> out;
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p)
    out.push_back(chart.at(scene.pairs[p].s, factor * table[p * C2D_PAIR_FIELDS + column]));
  return out;
}

struct Layers {
  const Scene& scene;
  const ZoneScene& zone;
  const CoefficientHistory& history;
  const CoefficientRecord& record;
  double mu; // of the zone
};

Range range_of(const Layers& l, size_t column, double mu_bound) {
  Range range;
  range.include(0.0);
  const auto take = [&](const std::vector<double>& table) {
    for (size_t p = l.zone.first; p < l.zone.first + l.zone.pairs; ++p) {
      range.include(table[p * C2D_PAIR_FIELDS + column]);
      const double bound = mu_bound * table[p * C2D_PAIR_FIELDS + C2D_TN];
      if (&table != &l.record.table || mu_bound == 0.0) continue;
      range.include(bound);
      range.include(-bound);
    }
  };
  for (const Snapshot& s : l.history.earlier) take(s.table);
  take(l.record.table);
  return range;
}

void draw_earlier(Svg& svg, const Layers& l, size_t column, const Chart& chart) {
  size_t i = 0;
  for (const Snapshot& s : l.history.earlier) {
    if (s.load == l.record.load && s.step == l.record.step) continue;
    svg.polyline(curve_of(l.scene, l.zone, s.table, column, chart), kEarlier[i++ % 3]);
  }
}

// Markers tell the status: full circle stick, triangle slip, cross open.
void draw_marks(Svg& svg, const Layers& l, size_t column, const Chart& chart, const char* ink) {
  for (size_t p = l.zone.first; p < l.zone.first + l.zone.pairs; ++p) {
    const double* row = l.record.table.data() + p * C2D_PAIR_FIELDS;
    const int status = static_cast<int>(row[C2D_STATUS]);
    const Mark mark = status == C2D_STICK  ? Mark::kCircle
                      : status == C2D_SLIP ? Mark::kTriangle
                                           : Mark::kCross;
    svg.mark(mark, chart.at(l.scene.pairs[p].s, row[column]), status == C2D_OPEN ? 5.0 : 6.0, ink);
  }
}

std::vector<LegendEntry> legend(const Layers& l, bool friction) {
  std::vector<LegendEntry> out;
  const std::string load = "load " + figure(l.record.load);
  out.push_back({"pressure tn, " + load, Stroke{colour::kBlue, 2.0, ""}, Mark::kNone, true, ""});
  if (friction) {
    out.push_back({"friction tt, " + load, Stroke{colour::kOrange, 2.0, ""}, Mark::kNone, true, ""});
    if (std::isfinite(l.mu))
      out.push_back(
          {"Coulomb bounds &#177;&#956; tn", Stroke{colour::kInk, 0.8, "4 2"}, Mark::kNone, true, "#eeeeee"});
  }
  size_t i = 0;
  for (const Snapshot& s : l.history.earlier) {
    if (s.load == l.record.load && s.step == l.record.step) continue;
    out.push_back({"load " + figure(s.load), kEarlier[i++ % 3], Mark::kNone, true, ""});
  }
  out.push_back({"stick", Stroke{}, Mark::kCircle, true, ""});
  out.push_back({"slip", Stroke{}, Mark::kTriangle, true, ""});
  out.push_back({"open", Stroke{}, Mark::kCross, true, ""});
  return out;
}

std::string caption(const Layers& l) {
  const Scene& scene = l.scene;
  const ZoneFacts f = find_facts(scene, l.zone, l.record.table);
  const std::string& length = scene.length_unit;
  std::string out = "At load factor " + figure(l.record.load) + " ";
  if (f.touching == 0) return out + "no pair touches.";
  const PairScene& peak = scene.pairs[f.peak_pair];
  out += "the peak pressure is " + figure(f.peak, scene.stress_unit, 6) +
         " at s = " + figure(peak.s, length) + " (pair " + std::to_string(f.peak_pair + 1) + "); ";
  out += std::to_string(f.touching) + " of " + std::to_string(l.zone.pairs) +
         (l.zone.pairs == 1 ? " pair touches" : " pairs touch");
  const double size = f.high - f.low;
  if (l.zone.symmetric_origin && (f.low == 0.0 || f.high == 0.0))
    out += ", contact half width " + figure(size, length) + " (to the last touching node)";
  else
    out += " between s = " + figure(f.low, length) + " and " + figure(f.high, length);
  if (l.mu > 0.0 && f.sticking > 0)
    out += "; sticking from s = " + figure(f.stick_low, length) + " to " + figure(f.stick_high, length) +
           ", " + std::to_string(f.slipping) + (f.slipping == 1 ? " pair slips" : " pairs slip");
  else if (l.mu > 0.0)
    out += "; no pair sticks";
  return out + ".";
}

void draw_one(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  static const CoefficientHistory kNone;
  const std::vector<CoefficientHistory>& histories = scene.history->coefficients();
  const Layers l{scene, scene.zones[zone_index],
                 coefficient < histories.size() ? histories[coefficient] : kNone,
                 scene.record->coefficients[coefficient], friction_of(scene, coefficient, zone_index)};
  const bool friction = l.mu > 0.0;
  const double bound = std::isfinite(l.mu) ? l.mu : 0.0;
  const double left = 76.0, right = kPictureWidth - 16.0;
  const std::vector<LegendEntry> entries = legend(l, friction);
  const double legend_height = draw_legend(nullptr, {left, 4.0}, right - left, entries);
  const double top = legend_height + 32.0, high = friction ? 210.0 : 280.0;
  const double bottom = friction ? top + 2.0 * high + 30.0 : top + high;
  const std::string name = "tractions" + chart_suffix(scene, coefficient, zone_index);
  Svg svg(name, kPictureWidth, bottom + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, entries);

  Range s;
  for (size_t p = l.zone.first; p < l.zone.first + l.zone.pairs; ++p) s.include(scene.pairs[p].s);
  const Axis axis = make_axis(s, position_name(l.zone), scene.length_unit, 9, false);
  const Range pressure_range = range_of(l, C2D_TN, 0.0);
  const Chart pressure{
      {left, top, right, top + high}, axis, make_axis(pressure_range, "pressure tn", scene.stress_unit, 6)};
  draw_axes(svg, pressure, !friction);
  draw_heading(svg, pressure.frame, "Pressure");
  svg.begin_clip(Box{left - 5.0, top - 5.0, right + 5.0, bottom + 5.0});
  draw_earlier(svg, l, C2D_TN, pressure);
  svg.polyline(curve_of(scene, l.zone, l.record.table, C2D_TN, pressure), Stroke{colour::kBlue, 2.0, ""});
  draw_marks(svg, l, C2D_TN, pressure, colour::kBlue);
  svg.end_clip();
  if (friction) {
    const Chart chart{{left, top + high + 30.0, right, bottom},
                      axis,
                      make_axis(range_of(l, C2D_TT, bound), "friction tt", scene.stress_unit, 6)};
    std::vector<Point> upper = curve_of(scene, l.zone, l.record.table, C2D_TN, chart, bound);
    const std::vector<Point> lower = curve_of(scene, l.zone, l.record.table, C2D_TN, chart, -bound);
    std::vector<Point> band = upper;
    band.insert(band.end(), lower.rbegin(), lower.rend());
    if (bound > 0.0) svg.area({band}, "#eeeeee", Stroke{});
    draw_axes(svg, chart);
    draw_heading(svg, chart.frame, "Friction");
    if (bound > 0.0) {
      svg.polyline(upper, Stroke{colour::kInk, 0.8, "4 2"});
      svg.polyline(lower, Stroke{colour::kInk, 0.8, "4 2"});
    }
    draw_earlier(svg, l, C2D_TT, chart);
    svg.polyline(curve_of(scene, l.zone, l.record.table, C2D_TT, chart), Stroke{colour::kOrange, 2.0, ""});
    draw_marks(svg, l, C2D_TT, chart, colour::kOrange);
  }
  Picture picture{name, "Pressure and friction, " + chart_title(scene, l.mu, zone_index), caption(l), ""};
  if (!friction) picture.title = "Pressure, " + chart_title(scene, l.mu, zone_index);
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_tractions(const Scene& scene, Pictures& out) {
  size_t drawn = 0;
  for (size_t c = 0; c < scene.record->coefficients.size(); ++c)
    for (size_t z = 0; z < scene.zones.size(); ++z)
      if (!scene.record->coefficients[c].table.empty() && scene.zones[z].pairs > 0 && drawn++ < kMostCharts)
        draw_one(scene, c, z, out);
}

} // namespace app
