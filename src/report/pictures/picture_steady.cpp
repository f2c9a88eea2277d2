// The recorded cycle of a zone: friction over slip of the pair that slips most, and the statuses of all pairs.
#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// Slip since the beginning of the cycle, and friction on side 1.
struct PairLoop {
  size_t pair;
  std::vector<Point> path, upper, lower; // the bounds of Coulomb
  std::vector<size_t> steps;             // those points that are recorded steps
  double area = 0.0;
};

PairLoop loop_of_pair(const CoefficientHistory& history, size_t zone, double mu) {
  PairLoop out{static_cast<size_t>(history.followed[zone].pair), {}, {}, {}, {}};
  const std::vector<const PathPoint*> points = points_of_cycle(history);
  for (const PathPoint* p : points) {
    const ZonePoint& now = p->zones[zone];
    const double slip = now.shift - points[0]->zones[zone].shift, bound = mu * std::max(0.0, now.tn);
    if (p->kind != C2D_STEP_CHANGE) out.steps.push_back(out.path.size());
    out.path.push_back({slip, -now.tt});
    out.upper.push_back({slip, bound}), out.lower.push_back({slip, -bound});
  }
  for (size_t i = 0; i + 1 < out.path.size(); ++i)
    out.area += 0.5 * (out.path[i].y + out.path[i + 1].y) * (out.path[i + 1].x - out.path[i].x);
  return out;
}

std::string loop_caption(const Scene& scene, const ZoneScene& zone, const PairLoop& loop) {
  Range x;
  for (const Point& p : loop.path) x.include(p.x);
  // (Forces are per thickness but of bodies of revolution.)
  const bool has_unit = !scene.force_unit.empty() && scene.is_revolved();
  const std::string work_per_area = has_unit ? scene.force_unit + "/" + scene.length_unit : scene.force_unit;
  std::string out = "The friction on side 1 over how far side 2 has moved along t against side 1 since the cycle began, of the "
                    "pair of the zone with the largest slip range: pair " +
                    std::to_string(loop.pair + 1) + " at " + zone.position + " = " +
                    figure(scene.pairs[loop.pair].s, scene.length_unit) +
                    "; markers are recorded steps, the square is the first state. The pair moves over " +
                    figure(x.high - x.low, scene.length_unit) + " and dissipates " + figure(loop.area, work_per_area, 6) +
                    " of work per area in the cycle";
  const double walk = loop.path.back().x;
  if (std::fabs(walk) > 1e-6 * (x.high - x.low)) out += "; it ends " + figure(walk, scene.length_unit) + " from where it began";
  return out + ". Grey lines are the Coulomb bounds.";
}

void draw_pair_loop(const Scene& scene, size_t coefficient, size_t zone, Pictures& out) {
  const CoefficientHistory& history = scene.history->coefficients()[coefficient];
  const double mu = friction_of(scene, coefficient, zone);
  if (zone >= history.followed.size() || history.followed[zone].pair < 0 || !(mu > 0.0) || points_of_cycle(history).empty())
    return;
  const PairLoop loop = loop_of_pair(history, zone, mu);
  Range x, y;
  for (const Point& p : loop.path) x.include(p.x), y.include(p.y);
  for (const Point& p : loop.upper) y.include(p.y);
  for (const Point& p : loop.lower) y.include(p.y);
  if (!(x.high > x.low) || !(y.high > y.low)) return;
  const std::string name = "cycle_loop" + chart_suffix(scene, coefficient, zone);
  Svg svg(name, kPictureWidth, 378.0);
  const Chart chart{{84.0, 14.0, kPictureWidth - 26.0, 334.0},
                    make_axis(x, "displacement since the cycle began", scene.length_unit, 6),
                    make_axis(y, "friction on side 1", scene.stress_unit, 6)};
  draw_axes(svg, chart);
  const auto drawn = [&](const std::vector<Point>& path, const Stroke& stroke) {
    std::vector<Point> points;
    for (const Point& p : path) points.push_back(chart.at(p));
    svg.polyline(points, stroke);
  };
  drawn(loop.upper, Stroke{colour::kFaint, 1.4, "6 3"});
  drawn(loop.lower, Stroke{colour::kFaint, 1.4, "6 3"});
  drawn(loop.path, Stroke{colour::kOrange, 1.8, ""});
  const size_t every = loop.steps.size() / 60 + 1;
  for (size_t i = 0; i < loop.steps.size(); i += every)
    svg.mark(i == 0 ? Mark::kSquare : Mark::kCircle, chart.at(loop.path[loop.steps[i]]), i == 0 ? 8.0 : 4.5, colour::kOrange);
  Picture picture{name, "Friction over slip in the last cycle" + chart_title(scene, mu, zone),
                  loop_caption(scene, scene.zones[zone], loop), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

// What each pair did over the whole cycle: slipped at some time, else stuck as long as it lasted, else was open.
std::string over_all(const std::vector<const PathPoint*>& points) {
  std::string out(points[0]->status.size(), static_cast<char>(C2D_STICK));
  for (const PathPoint* p : points)
    for (size_t i = 0; i < out.size(); ++i) {
      if (p->status[i] == C2D_SLIP) out[i] = static_cast<char>(C2D_SLIP);
      if (p->status[i] == C2D_OPEN && out[i] == C2D_STICK) out[i] = static_cast<char>(C2D_OPEN);
    }
  return out;
}

std::string counts_of(const ZoneScene& zone, const std::string& all) {
  const auto count = [&](int status) {
    return std::to_string(std::count(all.begin() + static_cast<ptrdiff_t>(zone.first),
                                     all.begin() + static_cast<ptrdiff_t>(zone.first + zone.pairs), static_cast<char>(status)));
  };
  return count(C2D_STICK) + " of " + std::to_string(zone.pairs) + " pairs stick all the time, " + count(C2D_SLIP) +
         " slip at some time";
}

void draw_cycle_strip(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  const ZoneScene& zone = scene.zones[zone_index];
  const CoefficientHistory& history = scene.history->coefficients()[coefficient];
  const std::vector<const PathPoint*> points = points_of_cycle(history);
  if (zone.tied || points.empty() || scene.summary.stepping == C2D_STEPPING_DECK) return;
  for (const PathPoint* p : points)
    if (p->status.empty()) return; // too many for the memory
  const std::vector<double> height = positions_by_step(history);
  const std::string name = "cycle_status" + chart_suffix(scene, coefficient, zone_index), all = over_all(points);
  Svg svg(name, kPictureWidth, 436.0);
  const StatusFills fills = status_fills(svg);
  const Box bar{66.0, 52.0, kPictureWidth - 18.0, 66.0}, frame{bar.left, 76.0, bar.right, 388.0};
  draw_legend(&svg, {frame.left, 4.0}, frame.width(), fills_legend(fills));
  draw_heading(svg, bar, "Over the whole cycle: stuck always, or slips");
  Range y;
  for (size_t i = history.cycle; i < height.size(); ++i) y.include(height[i]);
  const Chart chart{frame, position_axis(scene, zone), make_axis(y, "step", "", 7, true, true)};
  draw_axes(svg, chart);
  const std::vector<double> border = borders_of(zone);
  svg.raw("<g shape-rendering=\"crispEdges\">\n"); // no seams
  draw_status_row(svg, chart, zone, border, all, bar.top, bar.bottom, fills);
  for (size_t i = 0; i + 1 < points.size();) {
    size_t end = i + 1; // of equal rows one
    while (end + 1 < points.size() && points[end]->status == points[i]->status) ++end;
    const double from = height[history.cycle + i], to = height[history.cycle + end];
    if (to > from)
      draw_status_row(svg, chart, zone, border, points[i]->status, chart.at(0.0, to).y, chart.at(0.0, from).y, fills);
    i = end;
  }
  svg.raw("</g>\n");
  svg.rectangle(bar, "none", Stroke{colour::kInk, 1.0, ""});
  svg.rectangle(frame, "none", Stroke{colour::kInk, 1.0, ""});
  Picture picture{
      name,
      "Open, stick and slip in the last cycle" + chart_title(scene, friction_of(scene, coefficient, zone_index), zone_index),
      "Which part of the zone was open, stuck or slipped in the course of the recorded cycle. Over the whole of it " +
          counts_of(zone, all) + ".",
      ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_cycle_loop(const Scene& scene, Pictures& out) {
  draw_charts(scene, std::min(scene.record->coefficients.size(), scene.history->coefficients().size()), draw_pair_loop, out);
}

void draw_cycle_status(const Scene& scene, Pictures& out) {
  draw_charts(scene, std::min(scene.record->coefficients.size(), scene.history->coefficients().size()), draw_cycle_strip, out);
}

} // namespace app
