// What is followed of a cycle that is repeated: numbers over the cycles, and over the steps of the recorded one.
#include "report/cycle.hpp"
#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const Stroke kZoneLines[] = {{colour::kBlue, 1.8, ""},     {colour::kOrange, 1.8, "7 3"},
                             {colour::kGreen, 1.8, "2 2"}, {colour::kPurple, 1.8, "10 3 2 3"},
                             {colour::kInk, 1.8, "14 4"},  {colour::kFaint, 1.8, "4 2 1 2"}};
const Mark kZoneMarks[] = {Mark::kCircle, Mark::kSquare, Mark::kTriangle, Mark::kDiamond, Mark::kCross, Mark::kCircle};
constexpr size_t kMostZones = 6;
constexpr double kLeastChange = 1e-16; // less is round-off

struct ZoneLineDrawn {
  size_t style; // of kZoneLines
  std::vector<Point> points;
};
struct CyclePanel {
  std::string heading, name, unit;
  std::vector<ZoneLineDrawn> lines;
  bool logarithmic = false;
  double nothing = 0.0; // values of this size are round-off
  bool is_zero() const {
    for (const ZoneLineDrawn& line : lines)
      for (const Point& p : line.points)
        if (std::fabs(p.y) > nothing) return false;
    return true;
  }
};

// Zones in which something slips or walks in the cycle, as far as there are styles for them.
std::vector<size_t> moving_zones(const Scene& scene, const CoefficientRecord& c) {
  std::vector<size_t> out;
  for (size_t z = 0; z < std::min(scene.zones.size(), c.cycles.back().zones.size()) && out.size() < kMostZones; ++z)
    if (!scene.zones[z].tied && c.cycles.back().zones[z].touched > 0) out.push_back(z);
  return out;
}

ZoneLineDrawn over_cycles(const CoefficientRecord& c, size_t style, double (*value)(const CycleSeen&)) {
  ZoneLineDrawn out{style, {}};
  for (const CycleSeen& one : c.cycles) out.points.push_back({static_cast<double>(one.cycles), value(one)});
  return out;
}

// Displacements that are round-off beside the slip ranges.
double round_off_of_walk(const CoefficientRecord& c) { return 1e-9 * c.cycles.back().slip_range; }

CyclePanel walk_panel(const Scene& scene, const CoefficientRecord& c, const std::vector<size_t>& zones) {
  CyclePanel out{
      "Walk in each cycle, mean of the pairs that touch", "walk", scene.length_unit, {}, false, round_off_of_walk(c)};
  for (size_t k = 0; k < zones.size(); ++k) {
    ZoneLineDrawn line{k, {}};
    for (const CycleSeen& one : c.cycles) line.points.push_back({static_cast<double>(one.cycles), one.zones[zones[k]].walk});
    out.lines.push_back(line);
  }
  return out;
}

std::vector<CyclePanel> panels_of(const Scene& scene, const CoefficientRecord& c, const std::vector<size_t>& zones) {
  const std::vector<CyclePanel> all{
      {"Change over each cycle, of the largest pressure or gap",
       "change",
       "",
       {over_cycles(c, 0, [](const CycleSeen& one) { return std::max(one.change, kLeastChange); })},
       true},
      {"Dissipated by friction in each cycle",
       "dissipated",
       scene.work_unit,
       {over_cycles(c, 0, [](const CycleSeen& one) { return one.dissipated; })},
       false},
      {"Largest slip range in each cycle",
       "slip range",
       scene.length_unit,
       {over_cycles(c, 0, [](const CycleSeen& one) { return one.slip_range; })},
       false},
      walk_panel(scene, c, zones)};
  std::vector<CyclePanel> out;
  for (const CyclePanel& panel : all)
    if (!panel.is_zero()) out.push_back(panel);
  return out;
}

void draw_panel(Svg& svg, const Box& frame, const Axis& x, const CyclePanel& panel, const std::vector<double>& jumps,
                bool labels) {
  Range range;
  if (!panel.logarithmic) range.include(0.0);
  for (const ZoneLineDrawn& line : panel.lines)
    for (const Point& p : line.points) range.include(p.y);
  const Chart chart{frame, x,
                    panel.logarithmic ? make_log_axis(range, panel.name) : make_axis(range, panel.name, panel.unit, 4)};
  draw_axes(svg, chart, labels);
  draw_heading(svg, frame, panel.heading);
  for (const double at : jumps) {
    const double across = chart.at(at, chart.y.high).x;
    svg.line({across, frame.top}, {across, frame.bottom}, Stroke{colour::kFaint, 1.0, "3 3"});
  }
  for (size_t k = 0; k < panel.lines.size(); ++k) {
    const ZoneLineDrawn& line = panel.lines[k];
    std::vector<Point> points;
    for (const Point& p : line.points) points.push_back(chart.at(p));
    svg.polyline(points, beneath(kZoneLines[line.style], panel.lines.size() - 1 - k));
    const size_t every = points.size() / 40 + 1; // the last one in any case
    for (size_t i = (points.size() - 1) % every; i < points.size(); i += every)
      svg.mark(kZoneMarks[line.style], points[i], 5.0, kZoneLines[line.style].colour, line.style != 1);
  }
}

std::vector<LegendEntry> zones_legend(const Scene& scene, const std::vector<size_t>& zones, bool jumps) {
  std::vector<LegendEntry> out;
  for (size_t k = 0; zones.size() > 1 && k < zones.size(); ++k)
    out.push_back({zone_label(scene, zones[k]), beneath(kZoneLines[k], zones.size() - 1 - k), kZoneMarks[k], k != 1, ""});
  if (jumps) out.push_back({"extrapolation", Stroke{colour::kFaint, 1.0, "3 3"}, Mark::kNone, true, ""});
  return out;
}

void draw_panels(const Scene& scene, Picture picture, const Axis& x, const std::vector<CyclePanel>& panels,
                 const std::vector<size_t>& zones, const std::vector<double>& jumps, Pictures& out) {
  constexpr double kFirst = 72.0, kLast = kPictureWidth - 18.0, kHigh = 120.0, kRow = kHigh + 34.0;
  const std::vector<LegendEntry> legend = zones_legend(scene, zones, !jumps.empty());
  const double top = draw_legend(nullptr, {kFirst, 4.0}, kLast - kFirst, legend) + 30.0;
  Svg svg(picture.name, kPictureWidth, top + kRow * static_cast<double>(panels.size()) + 8.0);
  draw_legend(&svg, {kFirst, 4.0}, kLast - kFirst, legend);
  for (size_t i = 0; i < panels.size(); ++i) {
    const double at = top + kRow * static_cast<double>(i);
    draw_panel(svg, {kFirst, at, kLast, at + kHigh}, x, panels[i], jumps, i + 1 == panels.size());
  }
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

// Half way between two cycles of which the second begins at an extrapolated state.
std::vector<double> extrapolations_of(const CoefficientRecord& c) {
  std::vector<double> out;
  for (size_t i = 0; i + 1 < c.cycles.size(); ++i)
    if (c.cycles[i].extrapolations > (i > 0 ? c.cycles[i - 1].extrapolations : 0)) out.push_back(c.cycles[i].cycles + 0.5);
  return out;
}

std::string suffix_of(const Scene& scene, size_t coefficient) {
  return scene.summary.coefficients > 1 ? "_" + std::to_string(coefficient + 1) : "";
}

void draw_over_cycles(const Scene& scene, size_t coefficient, Pictures& out) {
  const CoefficientRecord& c = scene.record->coefficients[coefficient];
  const std::vector<size_t> zones = moving_zones(scene, c);
  const CycleSeen& last = c.cycles.back();
  Range cycles;
  cycles.include(std::min(1, last.cycles - 1)); // of a single one, too
  cycles.include(last.cycles);
  Picture picture{"cycles" + suffix_of(scene, coefficient), "Cycles until steady, &#956; = " + figure(c.mu), "", ""};
  picture.caption = "How the numbers of a cycle went: " + escape_xml(cycle_text(c, scene.summary)) +
                    ". In the last cycle friction dissipated " + figure(last.dissipated, scene.work_unit, 6) +
                    " and the largest slip range was " + figure(last.slip_range, scene.length_unit, 6) + ".";
  if (last.extrapolations > 0)
    picture.caption += " After " + std::to_string(last.extrapolations) + (last.extrapolations == 1 ? " cycle" : " cycles") +
                       " the state was extrapolated (dashed lines); each cycle shown was followed.";
  draw_panels(scene, picture, make_axis(cycles, "cycle", "", 9, true, true), panels_of(scene, c, zones), zones,
              extrapolations_of(c), out);
}

// Where the steps of the recorded cycle end, and where it begins.
std::vector<const PathPoint*> recorded_points(const Scene& scene, size_t coefficient) {
  std::vector<const PathPoint*> out;
  if (coefficient >= scene.history->coefficients().size()) return out;
  for (const PathPoint* p : points_of_cycle(scene.history->coefficients()[coefficient]))
    if (p->kind != C2D_STEP_CHANGE) out.push_back(p);
  return out;
}

CyclePanel displacement_panel(const Scene& scene, const CoefficientRecord& c, const std::vector<const PathPoint*>& points,
                              const std::vector<size_t>& zones) {
  CyclePanel out{"Side 2 against side 1 along t, since the cycle began",
                 "displacement",
                 scene.length_unit,
                 {},
                 false,
                 round_off_of_walk(c)};
  for (size_t k = 0; k < zones.size(); ++k) {
    ZoneLineDrawn line{k, {}};
    for (const PathPoint* p : points)
      line.points.push_back({static_cast<double>(p->step), p->zones[zones[k]].mean - points[0]->zones[zones[k]].mean});
    out.lines.push_back(line);
  }
  return out;
}

CyclePanel dissipation_panel(const Scene& scene, const CoefficientRecord& c) {
  CyclePanel out{"Dissipated by friction since the cycle began", "dissipated", scene.work_unit, {{0, {}}}, false};
  const std::vector<const StepRecord*> steps = steps_of_cycle(c);
  for (const StepRecord* step : steps)
    out.lines[0].points.push_back({static_cast<double>(step->step), step->dissipated - steps[0]->dissipated});
  return out;
}

void draw_over_steps(const Scene& scene, size_t coefficient, Pictures& out) {
  const CoefficientRecord& c = scene.record->coefficients[coefficient];
  const std::vector<const PathPoint*> points = recorded_points(scene, coefficient);
  if (points.size() < 3) return;
  const std::vector<size_t> zones = moving_zones(scene, c);
  std::vector<CyclePanel> panels{displacement_panel(scene, c, points, zones), dissipation_panel(scene, c)};
  panels.erase(std::remove_if(panels.begin(), panels.end(), [](const CyclePanel& p) { return p.is_zero(); }), panels.end());
  if (panels.empty()) return;
  Range range;
  range.include(points.front()->step), range.include(points.back()->step);
  const Picture picture{"cycle_steps" + suffix_of(scene, coefficient), "Steps of the last cycle, &#956; = " + figure(c.mu),
                        "The recorded cycle, step by step: how far side 2 of a zone moves against side 1, mean of the pairs "
                        "that touch in the cycle, and what friction dissipates. The displacement at the end is the walk.",
                        ""};
  draw_panels(scene, picture, make_axis(range, "step", "", 9, true, true), panels, zones, {}, out);
}

} // namespace

void draw_cycles(const Scene& scene, Pictures& out) {
  for (size_t i = 0; i < std::min(scene.record->coefficients.size(), kMostCharts); ++i) {
    if (scene.record->coefficients[i].cycles.empty()) continue;
    draw_over_cycles(scene, i, out);
    draw_over_steps(scene, i, out);
  }
}

} // namespace app
