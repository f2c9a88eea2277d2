// Axes of a chart: a range rounded to steps of 1, 2 or 5, labels with as many digits as the step needs, a
// power of ten and the unit in the name of the axis, a light grid.
#pragma once

#include "report/drawn/svg.hpp"

#include <string>
#include <vector>

namespace app {

struct Range {
  double low = 0.0, high = 0.0;
  bool empty = true;
  void include(double value);
};

struct Axis {
  std::string name;         // with power of ten and unit
  double low, high;         // ends of the axis
  double first, step;       // ticks
  int ticks;                //
  double power;             // values are divided by this for their labels
  int decimals;             // of the labels
  bool logarithmic = false; // `first` and `step` then count ... 1, 2, 5, 10, 20, 50 ... from 1
  std::string label(int tick) const;
  double tick(int i) const;
};

// `unit` may be empty. About `about` ticks. `tight`: the ends are those of the range, not rounded outwards.
// `whole`: ticks are whole numbers.
Axis make_axis(const Range& range, const std::string& name, const std::string& unit, int about, bool tight = false,
               bool whole = false);

// From the 1, 2 or 5 times a power of ten below the range to the one above it; values that are not positive are not shown.
Axis make_log_axis(const Range& range, const std::string& name);

struct Chart {
  Box frame;
  Axis x, y;
  bool zero_line = true; // where y = 0
  Point at(double vx, double vy) const;
  Point at(Point value) const { return at(value.x, value.y); }
  Outlines at(Outlines curves) const;
  bool is_near(Point pixel) const; // in the frame, or at most 20 pixels outside
};
// Grid, frame, tick labels and names. Without `labels_x` the x axis has ticks only (the chart below has the
// labels).
void draw_axes(Svg& svg, const Chart& chart, bool labels_x = true);
// A title in bold above the left corner of the frame.
void draw_heading(Svg& svg, const Box& frame, const std::string& text);

// One scale for both directions: extends the ranges to the aspect of the frame, with at least `margin` pixels around
// them.
Chart make_view(const Box& frame, Range x, Range y, double margin, const std::string& unit);
// Marks in the whole view the frame of a detail view, large enough to be visible.
void draw_zoom_frame(Svg& svg, const Chart& whole, const Chart& part);
// Height of a view of these ranges at this width, within bounds.
double view_height(const Range& x, const Range& y, double width, double lowest, double highest);

// Entries in rows, left to right; a line sample, a filled box or a marker each.
struct LegendEntry {
  std::string text;
  Stroke stroke;
  Mark mark = Mark::kNone;
  bool mark_filled = true;
  std::string fill;        // not empty: a box
  Head head = Head::kNone; // at the right end of the line
};
// A curve that `later` ones may cover is wider than each of them, so that its edges are seen beside them.
inline Stroke beneath(Stroke stroke, size_t later) {
  stroke.width += 1.2 * static_cast<double>(later);
  return stroke;
}
// Draws from (left, top) and returns the height used; with `svg` null only the height.
double draw_legend(Svg* svg, Point corner, double width, const std::vector<LegendEntry>& entries);

} // namespace app
