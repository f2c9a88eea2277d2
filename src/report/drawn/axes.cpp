#include "report/drawn/axes.hpp"

#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

constexpr double kLabelSize = 11.0, kNameSize = 12.0;

// 1, 2 or 5 times a power of ten, near `rough` from above.
double nice_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double part = rough / power;
  return power * (part <= 1.0001 ? 1.0 : part <= 2.0001 ? 2.0 : part <= 5.0001 ? 5.0 : 10.0);
}

std::string superscript(int number) {
  static const char* const kDigits[] = {"&#8304;", "&#185;",  "&#178;",  "&#179;",  "&#8308;",
                                        "&#8309;", "&#8310;", "&#8311;", "&#8312;", "&#8313;"};
  std::string out = number < 0 ? "&#8315;" : "";
  for (const char c : std::to_string(number < 0 ? -number : number)) out += kDigits[c - '0'];
  return out;
}

// ... 0.5, 1, 2, 5, 10 ...: number 0 is 1.
double round_number(int i) {
  static const double kLeads[] = {1.0, 2.0, 5.0};
  const int lead = (i % 3 + 3) % 3;
  return kLeads[lead] * std::pow(10.0, (i - lead) / 3);
}

double place_on(const Axis& axis, double value) {
  return axis.logarithmic ? std::log(value / axis.low) / std::log(axis.high / axis.low)
                          : (value - axis.low) / (axis.high - axis.low);
}

} // namespace

void Range::include(double value) {
  if (!std::isfinite(value)) return;
  low = empty ? value : std::min(low, value);
  high = empty ? value : std::max(high, value);
  empty = false;
}

double Axis::tick(int i) const { return logarithmic ? round_number(static_cast<int>(first + i * step)) : first + i * step; }

std::string Axis::label(int i) const {
  if (logarithmic) {
    const double at = tick(i);
    if (at < 0.9e-3 || at > 1.1e5) {
      const int exponent = static_cast<int>(std::floor(std::log10(at) + 1e-9));
      const int lead = static_cast<int>(std::lround(at / std::pow(10.0, exponent)));
      return (lead == 1 ? "10" : std::to_string(lead) + "&#183;10") + superscript(exponent);
    }
    std::string out;
    append_general(out, at, 0, 6);
    return out;
  }
  double value = tick(i) / power;
  if (std::fabs(value) < 1e-9 * std::fabs(step / power)) value = 0.0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  std::string out = text;
  for (char& c : out)
    if (c == ',') c = '.'; // independent of the locale
  return out[0] == '-' ? "&#8722;" + out.substr(1) : out;
}

Axis make_axis(const Range& range, const std::string& name, const std::string& unit, int about, bool tight, bool whole) {
  double low = range.empty ? 0.0 : range.low, high = range.empty ? 1.0 : range.high;
  const double size = std::max(std::fabs(low), std::fabs(high));
  if (high - low <= 1e-9 * size || size < 1e-290) { // a constant: room around it
    const double room = size < 1e-290 ? 1.0 : 0.5 * size;
    if (low > 0.0 || size < 1e-290)
      low = std::max(0.0, low - room), high += room;
    else
      low -= room, high = std::min(0.0, high + room);
    tight = false;
  }
  Axis axis;
  axis.step = nice_step((high - low) / about);
  const double finer = nice_step((high - low) / (1.6 * about));
  const auto rounded = [&](double step) { return std::ceil(high / step - 1e-6) * step - std::floor(low / step + 1e-6) * step; };
  if (!tight && rounded(finer) < 0.85 * rounded(axis.step)) axis.step = finer; // less empty paper
  if (whole) axis.step = std::max(1.0, axis.step);
  const double slack = 1e-6;
  if (tight) {
    axis.low = low;
    axis.high = high;
    axis.first = std::ceil(low / axis.step - slack) * axis.step;
  } else {
    axis.low = std::floor(low / axis.step + slack) * axis.step;
    axis.high = std::ceil(high / axis.step - slack) * axis.step;
    axis.first = axis.low;
  }
  axis.ticks = static_cast<int>(std::floor((axis.high - axis.first) / axis.step + slack)) + 1;
  const double largest = std::max(std::fabs(axis.low), std::fabs(axis.high));
  const int exponent = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  // Labels of at most four digits before the point and four behind it.
  const int finest = static_cast<int>(std::floor(std::log10(axis.step) + 1e-9));
  int power = 0;
  if (exponent > 4 || finest < -3) power = static_cast<int>(3.0 * std::floor(exponent / 3.0));
  axis.power = std::pow(10.0, power);
  axis.decimals = std::max(0, power - finest);
  axis.name = name;
  std::string scale = power != 0 ? "10" + superscript(power) : "";
  if (!unit.empty()) scale += (scale.empty() ? "" : " ") + unit;
  if (!scale.empty()) axis.name += " [" + scale + "]";
  return axis;
}

Axis make_log_axis(const Range& range, const std::string& name) {
  double low = range.empty ? 1.0 : range.high, high = low;
  if (!range.empty && range.low > 0.0) low = range.low;
  if (!(high > 0.0)) low = high = 1.0;
  int first = 3 * static_cast<int>(std::floor(std::log10(low))), last = 3 * static_cast<int>(std::ceil(std::log10(high))) + 1;
  while (round_number(first + 1) <= low * (1.0 + 1e-9)) ++first;
  while (last > first + 1 && round_number(last - 1) >= high * (1.0 - 1e-9)) --last;
  Axis axis;
  axis.name = name;
  axis.logarithmic = true;
  axis.low = round_number(first), axis.high = round_number(last);
  axis.step = last - first > 9 ? 3.0 : 1.0; // more than three decades: only powers of ten
  axis.first = axis.step > 1.0 ? 3.0 * std::ceil(first / 3.0) : first;
  axis.ticks = static_cast<int>(std::floor((last - axis.first) / axis.step)) + 1;
  axis.power = 1.0, axis.decimals = 0;
  return axis;
}

Point Chart::at(double vx, double vy) const {
  return {frame.left + place_on(x, vx) * frame.width(), frame.bottom - place_on(y, vy) * frame.height()};
}

Outlines Chart::at(Outlines curves) const {
  for (std::vector<Point>& curve : curves)
    for (Point& p : curve) p = at(p);
  return curves;
}

bool Chart::is_near(Point p) const {
  return p.x > frame.left - 20 && p.x < frame.right + 20 && p.y > frame.top - 20 && p.y < frame.bottom + 20;
}

void draw_axes(Svg& svg, const Chart& chart, bool labels_x) {
  const Box& f = chart.frame;
  const Stroke grid{colour::kGrid, 0.7, ""}, edge{colour::kInk, 1.0, ""}, zero{colour::kFaint, 1.0, ""};
  double last = -1e9;
  for (int i = 0; i < chart.x.ticks; ++i) {
    const double x = chart.at(chart.x.tick(i), 0.0).x;
    svg.line({x, f.top}, {x, f.bottom}, grid);
    svg.line({x, f.bottom}, {x, f.bottom + 4.0}, edge);
    const std::string label = chart.x.label(i);
    const double half = 0.5 * text_width(label, kLabelSize);
    if (!labels_x || x - half < last + 4.0) continue;
    svg.text({x, f.bottom + 16.0}, label, kLabelSize, Anchor::kMiddle);
    last = x + half;
  }
  double widest = 0.0, above = 1e9;
  for (int i = 0; i < chart.y.ticks; ++i) {
    const double y = chart.at(0.0, chart.y.tick(i)).y;
    svg.line({f.left, y}, {f.right, y}, grid);
    svg.line({f.left - 4.0, y}, {f.left, y}, edge);
    if (above - y < kLabelSize + 2.0) continue;
    const std::string label = chart.y.label(i);
    svg.text({f.left - 7.0, y + 4.0}, label, kLabelSize, Anchor::kEnd);
    widest = std::max(widest, text_width(label, kLabelSize));
    above = y;
  }
  if (chart.zero_line && chart.y.low < 0.0 && chart.y.high > 0.0)
    svg.line(chart.at(chart.x.low, 0.0), chart.at(chart.x.high, 0.0), zero);
  svg.rectangle(f, "none", edge);
  if (labels_x) svg.text({0.5 * (f.left + f.right), f.bottom + 33.0}, chart.x.name, kNameSize, Anchor::kMiddle);
  // Where wide labels leave it no room beside them a short name stands above them.
  const double beside = f.left - widest - 16.0, least = 0.6 * kNameSize;
  if (beside < least && text_width(chart.y.name, kNameSize) < f.left - 8.0)
    svg.text({4.0, f.top - 8.0}, chart.y.name, kNameSize);
  else
    svg.text({std::max(least, beside), 0.5 * (f.top + f.bottom)}, chart.y.name, kNameSize, Anchor::kMiddle, colour::kInk, true);
}

void draw_heading(Svg& svg, const Box& frame, const std::string& text) { svg.text({frame.left, frame.top - 8.0}, text, 12.5); }

Chart make_view(const Box& frame, Range x, Range y, double margin, const std::string& unit) {
  const double wide = frame.width() - 2.0 * margin, high = frame.height() - 2.0 * margin;
  double scale = std::max((x.high - x.low) / wide, (y.high - y.low) / high);
  if (!(scale > 0.0)) scale = 1.0 / wide;
  const double half_x = 0.5 * scale * frame.width(), half_y = 0.5 * scale * frame.height();
  const double mid_x = 0.5 * (x.low + x.high), mid_y = 0.5 * (y.low + y.high);
  x.low = mid_x - half_x, x.high = mid_x + half_x;
  y.low = mid_y - half_y, y.high = mid_y + half_y;
  Chart chart;
  chart.frame = frame;
  chart.zero_line = false;
  const auto axis = [&](const Range& range, const char* name, double about) {
    Axis out = make_axis(range, name, unit, static_cast<int>(about), true);
    for (int n = 3; out.ticks < 3 && n < 10; ++n) out = make_axis(range, name, unit, n, true);
    return out;
  };
  chart.x = axis(x, "x", std::max(2.0, frame.width() / 75.0));
  chart.y = axis(y, "y", std::max(2.0, frame.height() / 60.0));
  return chart;
}

void draw_zoom_frame(Svg& svg, const Chart& whole, const Chart& part) {
  Point a = whole.at(part.x.low, part.y.high), b = whole.at(part.x.high, part.y.low);
  const double room = 6.0 - 0.5 * std::min(b.x - a.x, b.y - a.y);
  if (room > 0.0) a = {a.x - room, a.y - room}, b = {b.x + room, b.y + room};
  svg.begin_clip(whole.frame);
  svg.rectangle({a.x, a.y, b.x, b.y}, "none", Stroke{colour::kInk, 1.0, "5 3"});
  svg.end_clip();
}

double view_height(const Range& x, const Range& y, double width, double lowest, double highest) {
  const double wide = x.high - x.low, high = y.high - y.low;
  const double wanted = wide > 0.0 ? width * high / wide : highest;
  return std::min(highest, std::max(lowest, wanted));
}

double draw_legend(Svg* svg, Point corner, double width, const std::vector<LegendEntry>& entries) {
  const double sample = 26.0, row = 18.0;
  double x = corner.x, y = corner.y + 9.0;
  for (const LegendEntry& e : entries) {
    const double wide = sample + 6.0 + text_width(e.text, kLabelSize) + 16.0;
    if (x > corner.x && x + wide - 16.0 > corner.x + width) x = corner.x, y += row;
    if (svg != nullptr) {
      if (!e.fill.empty())
        svg->rectangle({x, y - 6.0, x + sample, y + 5.0}, e.fill, e.stroke);
      else if (std::string("none") != e.stroke.colour && e.head != Head::kNone)
        svg->arrow({x, y}, {x + sample, y}, e.stroke, 5.5 + 1.2 * e.stroke.width, e.head);
      else if (std::string("none") != e.stroke.colour)
        svg->line({x, y}, {x + sample, y}, e.stroke);
      svg->mark(e.mark, {x + 0.5 * sample, y}, 6.0, e.stroke.colour == std::string("none") ? colour::kInk : e.stroke.colour,
                e.mark_filled);
      svg->text({x + sample + 6.0, y + 4.0}, e.text, kLabelSize);
    }
    x += wide;
  }
  return entries.empty() ? 0.0 : y + 12.0 - corner.y;
}

} // namespace app
