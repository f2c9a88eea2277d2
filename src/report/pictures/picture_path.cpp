#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>

namespace app {
namespace {

const Stroke kLines[] = {{colour::kBlue, 1.8, ""},           {colour::kOrange, 1.8, "7 3"}, {colour::kGreen, 1.8, "2 2"},
                         {colour::kPurple, 1.8, "10 3 2 3"}, {colour::kInk, 1.8, "14 4"},   {colour::kFaint, 1.8, "4 2 1 2"}};
const Mark kStepMarks[] = {Mark::kCircle, Mark::kSquare, Mark::kTriangle, Mark::kDiamond, Mark::kCross, Mark::kCircle};
constexpr size_t kMostDrawn = 6;

using Value = double (*)(const PathPoint&);
double events(const PathPoint& p) { return p.events; }
double peak(const PathPoint& p) { return p.peak; }
double touching(const PathPoint& p) { return p.count[C2D_STICK] + p.count[C2D_SLIP]; }

// Where a path's points lie on the axis: their loads, or their places among the steps.
std::vector<double> places(const CoefficientHistory& history, bool by_load) {
  std::vector<double> out = positions_by_step(history);
  for (size_t i = 0; by_load && i < out.size(); ++i) out[i] = history.points[i].load;
  return out;
}

bool all_rise(const Scene& scene) {
  for (const CoefficientHistory& h : scene.history->coefficients())
    if (!rises(h)) return false;
  return true;
}

void draw_value(Svg& svg, const Scene& scene, Box frame, const Axis& x, const char* name, const std::string& unit, bool whole,
                bool stairs, bool labels, Value value) {
  const std::vector<CoefficientHistory>& all = scene.history->coefficients();
  const size_t lines = std::min(all.size(), kMostDrawn);
  Range range;
  range.include(0.0);
  for (size_t c = 0; c < lines; ++c)
    for (const PathPoint& p : all[c].points) range.include(value(p));
  const Chart chart{frame, x, make_axis(range, name, unit, 4, false, whole)};
  draw_axes(svg, chart, labels);
  for (size_t c = 0; c < lines; ++c) {
    // Before the first event the contact is what the first point shows; nothing presses at zero load.
    const bool steady = stairs && !all[c].points.empty() && all[c].points[0].events == 0;
    std::vector<Point> points{chart.at(0.0, steady ? value(all[c].points[0]) : 0.0)}, steps;
    const std::vector<double> place = places(all[c], all_rise(scene));
    bool recorded = false;
    for (size_t i = 0; i < place.size(); ++i) {
      recorded = recorded || all[c].points[i].kind != C2D_STEP_CHANGE;
      if (i + 1 < place.size() && place[i + 1] == place[i]) continue; // the last of each place counts
      const PathPoint& p = all[c].points[i];
      const Point at = chart.at(place[i], value(p));
      if (stairs) points.push_back({at.x, points.back().y});
      points.push_back(at);
      if (recorded) steps.push_back(at);
      recorded = false;
    }
    svg.polyline(points, beneath(kLines[c], lines - 1 - c));
    const size_t every = steps.size() / 40 + 1;
    for (size_t i = 0; i < steps.size(); i += every) svg.mark(kStepMarks[c], steps[i], 5.0, kLines[c].colour, c != 1);
  }
}

// Load factors over the steps; the path is the same for all coefficients, the one that came furthest shows
// most of it.
const CoefficientRecord& longest(const Scene& scene) {
  const std::vector<CoefficientRecord>& all = scene.record->coefficients;
  return *std::max_element(all.begin(), all.end(), [](const CoefficientRecord& a, const CoefficientRecord& b) {
    return a.steps.size() < b.steps.size();
  });
}

std::vector<LegendEntry> load_legend(const Scene& scene) {
  std::vector<LegendEntry> out;
  const size_t lines = std::min(scene.cases, kMostDrawn);
  for (size_t k = 0; scene.cases > 1 && k < lines; ++k)
    out.push_back(
        {"factor of load case " + std::to_string(k + 1), beneath(kLines[k], lines - 1 - k), kStepMarks[k], k != 1, ""});
  return out;
}

void draw_loads(Svg& svg, const Scene& scene, const Box& frame, const Axis& x) {
  const CoefficientRecord& record = longest(scene);
  Range range;
  range.include(0.0);
  for (const StepRecord& step : record.steps)
    for (const double load : step.loads) range.include(load);
  const Chart chart{frame, x, make_axis(range, "load factor", "", 4)};
  draw_axes(svg, chart, false);
  draw_heading(svg, frame, scene.cases > 1 ? "Factors of the load cases" : "Load factor");
  const size_t lines = std::min(scene.cases, kMostDrawn);
  for (size_t k = 0; k < lines; ++k) {
    std::vector<Point> points{chart.at(0.0, 0.0)};
    for (const StepRecord& step : record.steps)
      points.push_back(chart.at(step.step, k < step.loads.size() ? step.loads[k] : 0.0));
    svg.polyline(points, beneath(kLines[k], lines - 1 - k));
    for (size_t i = 1; i < points.size(); i += points.size() / 40 + 1)
      svg.mark(kStepMarks[k], points[i], 5.0, kLines[k].colour, k != 1);
  }
}

std::string path_caption(const Scene& scene) {
  std::string out;
  const size_t known = std::min(scene.history->coefficients().size(), scene.record->coefficients.size());
  for (size_t c = 0; c < std::min(known, kMostDrawn); ++c) {
    const CoefficientHistory& h = scene.history->coefficients()[c];
    if (h.points.empty()) continue;
    const PathPoint& last = h.points.back();
    if (!out.empty()) out += "; ";
    out += "&#956; = " + figure(h.mu) + ": " + std::to_string(last.events) + (last.events == 1 ? " event (" : " events (") +
           std::to_string(scene.record->coefficients[c].changes) + " changes of status) up to " + place_on_path(scene, c) +
           ", then " + std::to_string(last.count[1] + last.count[2]) + " pairs in contact and a largest nodal pressure of " +
           figure(last.peak, scene.stress_unit, 6);
  }
  if (known > kMostDrawn) out += "; further coefficients are not drawn";
  return "How the load path went (markers: recorded steps): " + out + ".";
}

} // namespace

void draw_path(const Scene& scene, Pictures& out) {
  if (scene.pairs.empty() || scene.history->coefficients().empty()) return;
  Range load;
  bool any = false; // event
  const bool by_load = all_rise(scene);
  load.include(0.0);
  std::vector<LegendEntry> entries;
  const size_t lines = std::min(scene.history->coefficients().size(), kMostDrawn);
  for (size_t c = 0; c < lines; ++c) {
    const CoefficientHistory& h = scene.history->coefficients()[c];
    for (const PathPoint& p : h.points) any = any || p.events > 0;
    for (const double place : places(h, by_load)) load.include(place);
    entries.push_back({"&#956; = " + figure(h.mu), beneath(kLines[c], lines - 1 - c), kStepMarks[c], c != 1, ""});
  }
  const Axis x = make_axis(load, by_load ? "load factor" : "step", "", 9, true, !by_load);
  const double left = 66.0, right = kPictureWidth - 18.0, high = 120.0, step = high + 32.0;
  const std::vector<LegendEntry> cases = by_load ? std::vector<LegendEntry>{} : load_legend(scene);
  if (entries.size() == 1 && !cases.empty()) entries.clear(); // the title names the only coefficient
  const double first = draw_legend(nullptr, {left, 4.0}, right - left, entries);
  const double top = first + draw_legend(nullptr, {left, 4.0}, right - left, cases) + 30.0;
  const int charts = (by_load ? 0 : 1) + (any ? 1 : 0) + 2;
  Svg svg("path", kPictureWidth, top + charts * step - 32.0 + 44.0);
  draw_legend(&svg, {left, 4.0}, right - left, entries);
  draw_legend(&svg, {left, 4.0 + first}, right - left, cases);
  Box frame{left, top, right, top + high};
  const auto next = [&] { frame.top += step, frame.bottom += step; };
  if (!by_load) {
    draw_loads(svg, scene, frame, x);
    next();
  }
  if (any) {
    draw_value(svg, scene, frame, x, "events", "", true, true, false, events);
    draw_heading(svg, frame, "Events so far (loads at which a status changes)");
    next();
  }
  draw_value(svg, scene, frame, x, "pressure", scene.stress_unit, false, false, false, peak);
  draw_heading(svg, frame, "Largest pressure of all pairs");
  next();
  draw_value(svg, scene, frame, x, "pairs", "", true, true, true, touching);
  draw_heading(svg, frame, "Pairs in contact");
  Picture picture{"path", "The load path", path_caption(scene), ""};
  if (scene.history->coefficients().size() == 1) picture.title += ", &#956; = " + figure(scene.history->coefficients()[0].mu);
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
