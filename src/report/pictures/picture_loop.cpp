#include "report/cycle.hpp"
#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

struct Loop : Cycle {
  std::vector<Point> path; // shift, and friction force on side 1, at every recorded step
};

double value_of(const StepRecord& step, Measure what, size_t zone) {
  for (const Quantity& q : step.quantities)
    if (q.what == what && q.zone == static_cast<int32_t>(zone) + 1) return q.value;
  return 0.0; // nothing touches
}

Loop find_loop(const CoefficientRecord& c, size_t zone) {
  Loop out{find_cycle(c), {}};
  for (const StepRecord* step : steps_of_loop(c))
    out.path.push_back({value_of(*step, Measure::kShift, zone), -value_of(*step, Measure::kFrictionForce, zone)});
  return out;
}

// Friction whose sum vanishes, as all round a ring, is round-off beside the normal force.
double least_force(const CoefficientRecord& c, size_t zone) {
  double most = 0.0;
  for (const StepRecord& step : c.steps)
    most = std::max(most, value_of(step, Measure::kMeanPressure, zone) * value_of(step, Measure::kContactWidth, zone));
  return 1e-9 * most;
}

std::string caption(const Scene& scene, size_t coefficient, size_t zone, const Loop& loop) {
  const std::vector<const StepRecord*> steps = steps_of_loop(scene.record->coefficients[coefficient]);
  std::string out =
      "The friction force on side 1 of the zone along t over how far side 2 has moved along t against side 1, on average over "
      "the pairs; markers are recorded steps.";
  if (!loop.any()) return out;
  double area = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (size_t i = loop.first; i < loop.last; ++i)
    area += 0.5 * (loop.path[i].y + loop.path[i + 1].y) * (loop.path[i + 1].x - loop.path[i].x);
  for (size_t i = loop.first; i <= loop.last; ++i) low = std::min(low, loop.path[i].x), high = std::max(high, loop.path[i].x);
  return out + " The last cycle, steps " + std::to_string(steps[loop.first]->step) + " to " +
         std::to_string(steps[loop.last]->step) + ", encloses the area " + figure(std::fabs(area), scene.work_unit, 6) +
         " and is " + figure(high - low, scene.length_unit) + " wide; friction dissipated " +
         figure(value_of(*steps[loop.last], Measure::kDissipated, zone) -
                    value_of(*steps[loop.first], Measure::kDissipated, zone),
                scene.work_unit, 6) +
         " in it. The two agree where all pairs move alike; where the edges slip and the middle sticks the area is less.";
}

void draw_loop_of(const Scene& scene, size_t coefficient, size_t zone, Pictures& out) {
  const double mu = friction_of(scene, coefficient, zone);
  const Loop loop = find_loop(scene.record->coefficients[coefficient], zone);
  Range x, y;
  for (const Point& p : loop.path) x.include(p.x), y.include(p.y);
  if (!(mu > 0.0) || loop.turns.empty() || !(x.high > x.low)) return;
  if (!(y.high - y.low > least_force(scene.record->coefficients[coefficient], zone))) return;
  const std::string name = "loop" + chart_suffix(scene, coefficient, zone);
  const Chart chart{{84.0, 14.0, kPictureWidth - 26.0, 334.0},
                    make_axis(x, "mean displacement of side 2 against side 1", scene.length_unit, 6),
                    make_axis(y, "friction force on side 1", scene.force_unit, 6)};
  std::vector<Point> points, cycle;
  for (const Point& p : loop.path) points.push_back(chart.at(p));
  cycle.assign(points.begin() + static_cast<ptrdiff_t>(loop.first), points.begin() + static_cast<ptrdiff_t>(loop.last) + 1);
  Svg svg(name, kPictureWidth, 378.0);
  if (loop.any()) svg.area({cycle}, "#eeeeee", Stroke{});
  draw_axes(svg, chart);
  const Stroke last{colour::kOrange, 1.4, ""};
  svg.polyline(points, beneath(Stroke{colour::kFaint, last.width, "6 3"}, 1)); // the last cycle may cover what was before
  if (loop.any()) svg.polyline(cycle, last);
  for (const Point& p : points) svg.mark(Mark::kCircle, p, 4.5, colour::kOrange);
  Picture picture{name, "Friction over displacement" + chart_title(scene, mu, zone), caption(scene, coefficient, zone, loop),
                  ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_loop(const Scene& scene, Pictures& out) { draw_charts(scene, scene.record->coefficients.size(), draw_loop_of, out); }

} // namespace app
