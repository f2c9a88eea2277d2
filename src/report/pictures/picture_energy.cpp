#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// A quantity of energy and how it is drawn; the work, which the elastic energy often covers, wider and in large hollow
// marks.
struct EnergyCurve {
  double EnergyPoint::*value;
  const char* name;
  Stroke stroke;
  Mark mark;
  double size;
};
const EnergyCurve kCurves[] = {
    {&EnergyPoint::work, "work of the loads", {colour::kBlue, 4.0, ""}, Mark::kCircle, 9.0},
    {&EnergyPoint::elastic, "elastic energy", {colour::kGreen, 1.4, "7 3"}, Mark::kSquare, 4.0},
    {&EnergyPoint::dissipated, "dissipated by friction", {colour::kOrange, 2.0, "2 2"}, Mark::kTriangle, 5.5}};

struct Axes {
  bool by_load;
  Axis x, y[2];    // work and elastic energy; dissipation
  bool dissipates; // else the second is left out
};

double place_of(const CoefficientHistory& h, size_t i, bool by_load) {
  return by_load ? h.energy[i].load : static_cast<double>(i + 1);
}

// All coefficients are drawn to the same scales.
Axes make_axes(const Scene& scene, size_t count) {
  Axes out{true, {}, {}, true};
  Range place, size[2];
  const std::vector<CoefficientHistory>& all = scene.history->coefficients();
  for (size_t c = 0; c < count; ++c) out.by_load = out.by_load && rises(all[c]);
  place.include(0.0);
  for (Range& range : size) range.include(0.0);
  for (size_t c = 0; c < count; ++c)
    for (size_t i = 0; i < all[c].energy.size(); ++i) {
      place.include(place_of(all[c], i, out.by_load));
      for (size_t k = 0; k < 3; ++k) size[k / 2].include(all[c].energy[i].*kCurves[k].value);
    }
  const double largest = std::max(std::fabs(size[0].low), std::fabs(size[0].high));
  if (std::max(std::fabs(size[1].low), std::fabs(size[1].high)) < 1e-12 * largest) out.dissipates = false;
  out.x = make_axis(place, out.by_load ? "load factor" : "step", "", 5, true, !out.by_load);
  out.y[0] = make_axis(size[0], scene.is_revolved() ? "energy" : "energy per thickness", scene.work_unit, 5);
  out.y[1] = make_axis(size[1], "dissipated", scene.work_unit, 5);
  return out;
}

void draw_curve(Svg& svg, const Chart& chart, const CoefficientHistory& h, const EnergyCurve& curve, bool by_load) {
  std::vector<Point> points{chart.at(0.0, 0.0)};
  for (size_t i = 0; i < h.energy.size(); ++i) points.push_back(chart.at(place_of(h, i, by_load), h.energy[i].*curve.value));
  svg.polyline(points, curve.stroke);
  const size_t every = points.size() / 30 + 1;
  for (size_t i = 1; i < points.size(); i += every)
    svg.mark(curve.mark, points[i], curve.size, curve.stroke.colour, curve.mark != Mark::kCircle);
}

// One row: work and elastic energy on the left, dissipation, which may be much less, on the right.
void draw_row(Svg& svg, const CoefficientHistory& h, const Axes& axes, double top, double bottom, bool labels) {
  constexpr double kFirst = 62.0, kBetween = 68.0, kLast = kPictureWidth - 18.0, kWide = (kLast - kFirst - kBetween) / 2.0;
  const Box frames[2] = {{kFirst, top, axes.dissipates ? kFirst + kWide : kLast, bottom}, {kLast - kWide, top, kLast, bottom}};
  for (size_t side = 0; side < (axes.dissipates ? 2 : 1); ++side) {
    const Chart chart{frames[side], axes.x, axes.y[side]};
    draw_axes(svg, chart, labels);
    draw_heading(svg, frames[side], (side == 0 ? "work, elastic, &#956; = " : "dissipated, &#956; = ") + figure(h.mu));
    for (size_t k = 0; k < 3; ++k)
      if (k / 2 == side) draw_curve(svg, chart, h, kCurves[k], axes.by_load);
  }
}

std::string caption(const Scene& scene, size_t c) {
  const CoefficientHistory& h = scene.history->coefficients()[c];
  const EnergyPoint& last = h.energy.back();
  return "&#956; = " + figure(h.mu) + ": at " + place_on_path(scene, c) + " the loads have done the work " +
         figure(last.work, scene.work_unit, 6) + ", of which " + figure(last.elastic, scene.work_unit, 6) + " is stored and " +
         figure(last.dissipated, scene.work_unit, 6) + " dissipated by friction; the defect of the balance is " +
         figure(100.0 * last.defect, 2) + " %.";
}

} // namespace

void draw_energy(const Scene& scene, Pictures& out) {
  const std::vector<CoefficientHistory>& all = scene.history->coefficients();
  size_t count = 0;
  while (count < std::min(all.size(), kMostCharts) && !all[count].energy.empty()) ++count;
  if (count == 0) return;
  const Axes axes = make_axes(scene, count);
  std::vector<LegendEntry> entries;
  for (const EnergyCurve& curve : kCurves)
    if (axes.dissipates || curve.value != &EnergyPoint::dissipated)
      entries.push_back({curve.name, curve.stroke, curve.mark, curve.mark != Mark::kCircle, ""});
  const double top = 34.0 + draw_legend(nullptr, {62.0, 4.0}, kPictureWidth - 74.0, entries), high = count == 1 ? 220.0 : 150.0,
               row = high + 32.0;
  Svg svg("energy", kPictureWidth, top + row * static_cast<double>(count) + 12.0);
  draw_legend(&svg, {62.0, 4.0}, kPictureWidth - 74.0, entries);
  Picture picture{"energy", "Balance of energy", "", ""};
  if (count == 1) picture.title += ", &#956; = " + figure(all[0].mu);
  for (size_t c = 0; c < count; ++c) {
    const double at = top + row * static_cast<double>(c);
    draw_row(svg, all[c], axes, at, at + high, c + 1 == count);
    picture.caption += (c > 0 ? " " : "") + caption(scene, c);
  }
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
