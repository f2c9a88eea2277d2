#include "post/edges.hpp"
#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

// Earlier steps: thin, each with a dash of its own.
const Stroke kEarlier[] = {{colour::kFaint, 1.1, "2 3"}, {colour::kFaint, 1.1, "6 3"}, {colour::kFaint, 1.1, "10 3 2 3"}};

std::vector<Point> curve_of(const ZoneScene& zone, const std::vector<double>& table, size_t column, const Chart& chart,
                            double factor = 1.0) {
  std::vector<Point> out;
  for (const ZoneSample& p : zone.samples) {
    const double turn = column == C2D_TT ? p.turn : 1.0;
    out.push_back(chart.at(p.s, turn * factor * table[p.pair * C2D_PAIR_FIELDS + column]));
  }
  return out;
}

struct Layers {
  const Scene& scene;
  const ZoneScene& zone;
  std::vector<const Snapshot*> earlier;
  const CoefficientRecord& record;
  double mu;         // of the zone
  bool by_load;      // the path is one load that rises
  std::string place; // of the table on the path
  Range window;      // of s, where it is not all of the zone that is drawn

  double margin() const { return window.empty ? 5.0 : 0.0; } // for markers
  bool shows(double s) const { return window.empty || (s >= window.low && s <= window.high); }
};

} // namespace

double axis_limit(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table, size_t column) {
  std::vector<std::pair<double, double>> sizes; // size, and the length along which it stands
  double length = 0.0, below = 0.0;
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) {
    const size_t before = p > zone.first ? p - 1 : p, behind = p + 1 < zone.first + zone.pairs ? p + 1 : p;
    const double share = 0.5 * std::fabs(scene.pairs[behind].s - scene.pairs[before].s);
    const double value = std::fabs(table[p * C2D_PAIR_FIELDS + column]);
    sizes.emplace_back(value, share);
    length += share;
  }
  std::sort(sizes.begin(), sizes.end());
  for (const auto& entry : sizes) {
    below += entry.second;
    if (below < 0.97 * length) continue;
    return entry.first > 0.0 && sizes.back().first > 6.0 * entry.first ? 1.3 * entry.first : HUGE_VAL;
  }
  return HUGE_VAL;
}

namespace {

double find_top(const Layers& l, size_t column) { return axis_limit(l.scene, l.zone, l.record.table, column); }

// Values and, with a coefficient, the Coulomb limits, up to `top`.
Range range_of(const Layers& l, size_t column, double mu_bound, double top) {
  Range range;
  range.include(0.0);
  const auto within = [&](double value) { return std::max(-top, std::min(top, value)); };
  const auto take = [&](const std::vector<double>& table) {
    for (const ZoneSample& p : l.zone.samples) {
      if (!l.shows(p.s)) continue;
      const double* row = table.data() + p.pair * C2D_PAIR_FIELDS;
      range.include(within((column == C2D_TT ? p.turn : 1.0) * row[column]));
      if (&table != &l.record.table || mu_bound == 0.0) continue;
      range.include(within(mu_bound * row[C2D_TN]));
      range.include(within(-mu_bound * row[C2D_TN]));
    }
  };
  for (const Snapshot* s : l.earlier) take(s->table);
  take(l.record.table);
  return range;
}

void draw_earlier(Svg& svg, const Layers& l, size_t column, const Chart& chart) {
  size_t i = 0;
  for (const Snapshot* s : l.earlier) svg.polyline(curve_of(l.zone, s->table, column, chart), kEarlier[i++ % 3]);
}

// Markers show the status: full circle stick, triangle slip, cross open, square tied. Those beyond the axis are omitted.
void draw_marks(Svg& svg, const Layers& l, size_t column, const Chart& chart, const char* ink) {
  const std::vector<Point> places = curve_of(l.zone, l.record.table, column, chart);
  for (size_t i = 0; i < places.size(); ++i) {
    if (places[i].y < chart.frame.top - 1.0 || places[i].y > chart.frame.bottom + 1.0) continue;
    const int status = static_cast<int>(l.record.table[l.zone.samples[i].pair * C2D_PAIR_FIELDS + C2D_STATUS]);
    svg.mark(status_mark(status), places[i], status == C2D_OPEN ? 5.0 : 6.0, ink);
  }
}

// States which values lie beyond the axis.
void tell_beyond(Svg& svg, const Layers& l, size_t column, const Chart& chart) {
  const double axis = (1 + 1e-6) * std::max(std::fabs(chart.y.low), std::fabs(chart.y.high));
  size_t beyond = 0, largest = l.zone.first;
  for (size_t p = l.zone.first; p < l.zone.first + l.zone.pairs; ++p) {
    const auto size = [&](size_t pair) { return std::fabs(l.record.table[pair * C2D_PAIR_FIELDS + column]); };
    if (l.shows(l.scene.pairs[p].s) && size(p) > axis) ++beyond;
    if (size(p) > size(largest)) largest = p;
  }
  if (beyond == 0) return;
  std::string text = std::to_string(beyond) + (beyond == 1 ? " pair" : " pairs") + " beyond the axis";
  if (l.window.empty) // there is room to say more
    text += ": up to " + figure(l.record.table[largest * C2D_PAIR_FIELDS + column], l.scene.stress_unit) + " at " +
            l.zone.position + " = " + figure(l.scene.pairs[largest].s, l.scene.length_unit);
  svg.text({0.5 * (chart.frame.left + chart.frame.right), chart.frame.top + 16.0}, text, 11.0, Anchor::kMiddle, colour::kInk,
           false, true);
}

// A tie carries any shear stress, and so does contact without slip.
bool has_bounds(const Layers& l) { return !l.zone.tied && std::isfinite(l.mu) && l.mu > 0.0; }

std::vector<LegendEntry> legend(const Layers& l, bool friction) {
  std::vector<LegendEntry> out;
  out.push_back({traction_name(l.zone, true), Stroke{colour::kBlue, 2.0, ""}, Mark::kNone, true, ""});
  if (friction) {
    out.push_back({traction_name(l.zone, false), Stroke{colour::kOrange, 2.0, ""}, Mark::kNone, true, ""});
    if (has_bounds(l))
      out.push_back({"Coulomb bounds &#177;&#956; tn", Stroke{colour::kInk, 0.8, "4 2"}, Mark::kNone, true, "#eeeeee"});
  }
  size_t i = 0;
  for (const Snapshot* s : l.earlier) {
    const std::string when =
        l.by_load ? "load " + figure(s->load) : "step " + std::to_string(s->step) + ": load " + list_of(s->loads);
    out.push_back({when, kEarlier[i++ % 3], Mark::kNone, true, ""});
  }
  for (const LegendEntry& entry : status_legend(is_tied(l.record, l.zone))) out.push_back(entry);
  return out;
}

// What tractions refer to, and where the curves come from.
std::string measure_text(const Layers& l) {
  std::string out = ". Stresses are forces on " + body_label(l.scene, l.zone.body[1]) + " per undeformed length of " +
                    body_label(l.scene, l.zone.body[l.zone.free ? 1 : 0]) +
                    ", n points into it and t is n turned by -90 degrees.";
  if (l.zone.has_images) out += std::string(" The part beyond the ") + l.scene.mirror_name() + " is the image.";
  return out;
}

std::string tie_text(const Layers& l) {
  size_t most[2] = {l.zone.first, l.zone.first};
  const auto size = [&](size_t pair, int column) {
    return std::fabs(l.record.table[pair * C2D_PAIR_FIELDS + static_cast<size_t>(column)]);
  };
  for (size_t p = l.zone.first; p < l.zone.first + l.zone.pairs; ++p)
    for (const int k : {0, 1})
      if (size(p, k == 0 ? C2D_TN : C2D_TT) > size(most[k], k == 0 ? C2D_TN : C2D_TT)) most[k] = p;
  const auto text = [&](size_t pair, int column) {
    return figure(l.record.table[pair * C2D_PAIR_FIELDS + static_cast<size_t>(column)], l.scene.stress_unit, 6) + " at " +
           l.zone.position + " = " + figure(l.scene.pairs[pair].s, l.scene.length_unit);
  };
  return "the largest stresses of the " + std::to_string(l.zone.pairs) + " tied pairs are tn = " + text(most[0], C2D_TN) +
         " and tt = " + text(most[1], C2D_TT);
}

// Digits by which both ends of an interval differ in the third at least.
int digits_of(double low, double high) {
  const double size = std::max(std::fabs(low), std::fabs(high));
  const double more = high > low && size > 0.0 ? std::ceil(std::log10(size / (high - low))) : 0.0;
  return static_cast<int>(std::min(9.0, 4.0 + std::max(0.0, more)));
}

std::string caption(const Layers& l) {
  const Scene& scene = l.scene;
  const ZoneFacts f = find_facts(scene, l.zone, l.record.table);
  const std::string& length = scene.length_unit;
  std::string out = "At " + l.place + " ";
  if (f.touching == 0) return out + "no pair touches.";
  if (l.zone.tied) return out + tie_text(l) + measure_text(l);
  const PairScene& peak = scene.pairs[f.peak_pair];
  out += "the largest pressure of a pair is " + figure(f.peak, scene.stress_unit, 6) + " at " + l.zone.position + " = " +
         figure(peak.s, length) + " (pair " + std::to_string(f.peak_pair + 1) + "); ";
  out += std::to_string(f.touching) + " of " + std::to_string(l.zone.pairs) +
         (l.zone.pairs == 1 ? " pair touches" : " pairs touch");
  const double size = f.high - f.low;
  const double line = scene.pairs[l.zone.origin].s;
  if (l.zone.symmetric_origin && (f.low == line || f.high == line))
    out += ", contact half width " + figure(size, length) + " (to the last touching node)";
  else
    out += " between " + std::string(l.zone.position) + " = " + figure(f.low, length, digits_of(f.low, f.high)) + " and " +
           figure(f.high, length, digits_of(f.low, f.high));
  if (l.mu > 0.0 && f.sticking > 0)
    out += words_of_sticking(l.scene, l.zone, f) + ", " + std::to_string(f.slipping) +
           (f.slipping == 1 ? " pair slips" : " pairs slip");
  else if (l.mu > 0.0)
    out += "; no pair sticks";
  return out + measure_text(l);
}

void draw_pressure(Svg& svg, const Layers& l, const Box& frame, const Axis& axis, bool labels) {
  const double top = find_top(l, C2D_TN);
  const Chart chart{frame, axis, make_axis(range_of(l, C2D_TN, 0.0, top), traction_name(l.zone, true), l.scene.stress_unit, 6)};
  draw_axes(svg, chart, labels);
  draw_heading(svg, frame, l.zone.tied ? "Normal stress of the tie (pressure is positive)" : "Contact pressure");
  svg.begin_clip(Box{frame.left - l.margin(), frame.top - 1.0, frame.right + l.margin(), frame.bottom + 5.0});
  svg.polyline(curve_of(l.zone, l.record.table, C2D_TN, chart), Stroke{colour::kBlue, 2.0, ""});
  draw_marks(svg, l, C2D_TN, chart, colour::kBlue);
  draw_earlier(svg, l, C2D_TN, chart); // thin ones over the wide one, which would hide them
  svg.end_clip();
  tell_beyond(svg, l, C2D_TN, chart);
}

void draw_friction(Svg& svg, const Layers& l, const Box& frame, const Axis& axis) {
  const double bound = has_bounds(l) ? l.mu : 0.0;
  const double highest = find_top(l, C2D_TN);
  const double top = bound > 0.0 && std::isfinite(highest) ? bound * highest : find_top(l, C2D_TT);
  const Chart chart{frame, axis,
                    make_axis(range_of(l, C2D_TT, bound, top), traction_name(l.zone, false), l.scene.stress_unit, 6)};
  std::vector<Point> upper = curve_of(l.zone, l.record.table, C2D_TN, chart, bound);
  const std::vector<Point> lower = curve_of(l.zone, l.record.table, C2D_TN, chart, -bound);
  std::vector<Point> band = upper;
  band.insert(band.end(), lower.rbegin(), lower.rend());
  const Box room{frame.left - l.margin(), frame.top, frame.right + l.margin(), frame.bottom};
  svg.begin_clip(room);
  if (bound > 0.0) svg.area({band}, "#eeeeee", Stroke{});
  svg.end_clip();
  draw_axes(svg, chart);
  draw_heading(svg, frame, l.zone.tied ? "Shear stress of the tie" : "Friction");
  svg.begin_clip(room);
  if (bound > 0.0) {
    svg.polyline(upper, Stroke{colour::kInk, 0.8, "4 2"});
    svg.polyline(lower, Stroke{colour::kInk, 0.8, "4 2"});
  }
  svg.polyline(curve_of(l.zone, l.record.table, C2D_TT, chart), Stroke{colour::kOrange, 2.0, ""});
  draw_marks(svg, l, C2D_TT, chart, colour::kOrange);
  draw_earlier(svg, l, C2D_TT, chart);
  svg.end_clip();
  tell_beyond(svg, l, C2D_TT, chart);
}

// The largest in size, at the states that are drawn.
double most_of(const Layers& l, size_t column) {
  double most = 0.0;
  const auto take = [&](const std::vector<double>& table) {
    for (const ZoneSample& p : l.zone.samples) most = std::max(most, std::fabs(table[p.pair * C2D_PAIR_FIELDS + column]));
  };
  for (const Snapshot* s : l.earlier) take(s->table);
  take(l.record.table);
  return most;
}

// Both diagrams, one below the other, and their height.
double height_of_diagrams(bool friction) { return friction ? 450.0 : 280.0; }
void draw_diagrams(Svg& svg, const Layers& l, bool friction, const Box& place, const Axis& axis) {
  constexpr double kBetween = 30.0;
  const double high = friction ? (height_of_diagrams(true) - kBetween) / 2 : height_of_diagrams(false);
  draw_pressure(svg, l, {place.left, place.top, place.right, place.top + high}, axis, !friction);
  if (friction) draw_friction(svg, l, {place.left, place.top + high + kBetween, place.right, place.bottom}, axis);
}

// ---- around the edges of contact ----------------------------------------------------------------------------------------

// From an edge of contact (the last pair that touches, and the next one is open) to some pairs beyond what slips there.
Range around_edge(const Layers& l, size_t last, int outwards) {
  constexpr int kOutside = 3, kInside = 3;
  const std::vector<ZoneSample>& p = l.zone.samples;
  const auto status = [&](size_t i) { return static_cast<int>(l.record.table[p[i].pair * C2D_PAIR_FIELDS + C2D_STATUS]); };
  const auto moved = [&](size_t i, int steps) {
    const ptrdiff_t to = static_cast<ptrdiff_t>(i) + steps;
    return static_cast<size_t>(std::max<ptrdiff_t>(0, std::min(to, static_cast<ptrdiff_t>(p.size()) - 1)));
  };
  size_t inner = last;
  while (moved(inner, -outwards) != inner && status(inner) == C2D_SLIP && l.mu > 0.0) inner = moved(inner, -outwards);
  Range out;
  out.include(p[moved(inner, -kInside * outwards)].s);
  out.include(p[moved(last, kOutside * outwards)].s);
  return out;
}

// Is this edge important: slip beside stick, or the largest pressure?
bool says_much(const Layers& l, const Range& window) {
  bool slips = false, sticks = false, has_peak = false;
  double most = 0.0;
  for (const ZoneSample& p : l.zone.samples) {
    const double* row = l.record.table.data() + p.pair * C2D_PAIR_FIELDS;
    const bool inside = p.s >= window.low && p.s <= window.high;
    if (row[C2D_TN] > most) most = row[C2D_TN], has_peak = inside;
    const int status = static_cast<int>(row[C2D_STATUS]);
    slips = slips || (inside && status == C2D_SLIP);
    sticks = sticks || status == C2D_STICK;
  }
  return has_peak || (l.mu > 0.0 && slips && sticks);
}

// The first and the last edge with important detail in so small a part of the zone that the whole view does not show it.
std::vector<Range> find_windows(const Layers& l) {
  constexpr double kLittle = 0.2; // of the zone
  const std::vector<ZoneSample>& p = l.zone.samples;
  const auto touches = [&](size_t i) {
    return static_cast<int>(l.record.table[p[i].pair * C2D_PAIR_FIELDS + C2D_STATUS]) != C2D_OPEN;
  };
  std::vector<Range> all;
  for (size_t i = 0; i + 1 < p.size(); ++i) {
    if (touches(i) == touches(i + 1) || (l.zone.has_images && p[i].turn < 0.0)) continue;
    const Range window = touches(i) ? around_edge(l, i, 1) : around_edge(l, i + 1, -1);
    if (window.high - window.low < kLittle * (p.back().s - p.front().s) && says_much(l, window)) all.push_back(window);
  }
  if (all.size() > 2) all = {all.front(), all.back()};
  return all;
}

void draw_edges(const Layers& whole, bool friction, const std::string& suffix, const std::string& title, Pictures& out) {
  const std::vector<Range> windows = find_windows(whole);
  if (windows.empty()) return;
  const double left = 66.0, right = kPictureWidth - 18.0, between = 62.0;
  const std::vector<LegendEntry> entries = legend(whole, friction);
  const double top = draw_legend(nullptr, {left, 4.0}, right - left, entries) + 32.0;
  const double bottom = top + height_of_diagrams(friction), wide = (right - left - between) / 2;
  Svg svg("edges" + suffix, kPictureWidth, bottom + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, entries);
  for (size_t i = 0; i < windows.size(); ++i) {
    Layers l = whole;
    l.window = windows[i];
    const double from = left + static_cast<double>(i) * (wide + between), to = windows.size() == 1 ? right : from + wide;
    const std::string name = windows.size() == 1 ? position_name(l.scene, l.zone) : l.zone.position;
    draw_diagrams(svg, l, friction, {from, top, to, bottom}, make_axis(l.window, name, l.scene.length_unit, 5, true));
  }
  Picture picture{"edges" + suffix, title,
                  "The same around " + std::string(windows.size() == 1 ? "the edge" : "the first and the last edge") +
                      " of contact, where most happens in little of the zone; every marker is a pair.",
                  ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

void draw_tractions_of(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  static const CoefficientHistory kNone;
  const std::vector<CoefficientHistory>& histories = scene.history->coefficients();
  const CoefficientHistory& history = coefficient < histories.size() ? histories[coefficient] : kNone;
  const Layers l{
      scene,
      scene.zones[zone_index],
      earlier_states(history, scene.record->coefficients[coefficient].step, scene.record->coefficients[coefficient].table),
      scene.record->coefficients[coefficient],
      friction_of(scene, coefficient, zone_index),
      rises(history),
      place_on_path(scene, coefficient),
      {}};
  const double most = most_of(l, C2D_TN);
  const bool friction = (l.zone.tied || l.mu > 0.0) && most_of(l, C2D_TT) > kNoFriction * most;
  if (most == 0.0) return; // nothing touches, or without force
  const double left = 66.0, right = kPictureWidth - 18.0;
  const std::vector<LegendEntry> entries = legend(l, friction);
  const double top = draw_legend(nullptr, {left, 4.0}, right - left, entries) + 32.0;
  const std::string suffix = chart_suffix(scene, coefficient, zone_index), name = "tractions" + suffix;
  Svg svg(name, kPictureWidth, top + height_of_diagrams(friction) + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, entries);
  const Axis axis = position_axis(scene, l.zone);
  draw_diagrams(svg, l, friction, {left, top, right, top + height_of_diagrams(friction)}, axis);
  const std::string what = l.zone.tied ? "Stresses of the tie"
                           : friction  ? "Contact pressure and friction"
                                       : "Contact pressure";
  Picture picture{name, what + chart_title(scene, l.mu, zone_index), caption(l), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
  draw_edges(l, friction, suffix, "At the edges of contact" + chart_title(scene, l.mu, zone_index), out);
}

} // namespace

void draw_tractions(const Scene& scene, Pictures& out) {
  draw_charts(scene, scene.record->coefficients.size(), draw_tractions_of, out);
}

} // namespace app
