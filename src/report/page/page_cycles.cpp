#include "report/page/page_cycles.hpp"

#include "report/cycle.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using Cells = std::vector<std::string>;

void append_cells(std::string& out, const Cells& cells, const char* tag = "td") {
  out += "<tr>";
  for (const std::string& cell : cells) out += std::string("<") + tag + ">" + cell + "</" + tag + ">";
  out += "</tr>\n";
}

std::string cycle_heading(const char* name, const std::string& unit) { return unit.empty() ? name : name + (", " + unit); }

void append_cycle_rows(std::string& out, const Scene& scene, const CoefficientRecord& c) {
  out += "<details>\n<summary>Cycle by cycle, &#956; = " + figure(c.mu) + "</summary>\n<div class=\"wide\"><table>\n";
  append_cells(out,
               {"cycle", "change", cycle_heading("dissipated", scene.work_unit), cycle_heading("slip range", scene.length_unit),
                cycle_heading("largest walk", scene.length_unit), "pairs stuck", "pairs slipped", "extrapolations"},
               "th");
  for (const CycleSeen& one : c.cycles)
    append_cells(out, {std::to_string(one.cycles), figure(one.change, 3), figure(one.dissipated, 6), figure(one.slip_range, 6),
                       figure(one.walk, 6), std::to_string(one.stuck), std::to_string(one.slipped),
                       std::to_string(one.extrapolations)});
  out += "</table></div>\n</details>\n";
}

double value_in(const StepRecord& step, Measure what, size_t zone) {
  for (const Quantity& q : step.quantities)
    if (q.what == what && q.zone == static_cast<int32_t>(zone) + 1) return q.value;
  return 0.0; // nothing touches
}

// (u2 - u1).t of a zone at the recorded steps of the cycle, since its beginning.
std::vector<double> displacements_in_cycle(const Scene& scene, size_t coefficient, size_t zone) {
  std::vector<double> out;
  if (coefficient >= scene.history->coefficients().size()) return out;
  const std::vector<const PathPoint*> points = points_of_cycle(scene.history->coefficients()[coefficient]);
  for (const PathPoint* p : points)
    if (p->kind != C2D_STEP_CHANGE) out.push_back(p->zones[zone].mean - points[0]->zones[zone].mean);
  const double nothing = 1e-9 * scene.record->coefficients[coefficient].cycles.back().slip_range; // round-off
  for (double& d : out) d = std::fabs(d) <= nothing ? 0.0 : d;
  return out;
}

void append_step_rows(std::string& out, const Scene& scene, const CoefficientRecord& c, size_t coefficient, size_t zone) {
  const std::vector<const StepRecord*> steps = steps_of_cycle(c);
  const std::vector<double> moved = displacements_in_cycle(scene, coefficient, zone);
  if (steps.empty() || steps[0]->quantities.empty() || moved.size() != steps.size()) return;
  out += "<details>\n<summary>Steps of the last cycle" + chart_title(scene, friction_of(scene, coefficient, zone), zone) +
         "</summary>\n<div class=\"wide\"><table>\n";
  Cells names{"step"};
  const bool few = scene.cases <= 4; // else the factors would fill the table
  for (size_t k = 1; few && k <= scene.cases; ++k) names.push_back(k == 1 ? "load" : "load" + std::to_string(k));
  names.push_back(cycle_heading("peak pressure", scene.stress_unit));
  names.push_back(cycle_heading("displacement", scene.length_unit));
  names.push_back(cycle_heading("dissipated", scene.work_unit));
  append_cells(out, names, "th");
  for (size_t i = 0; i < steps.size(); ++i) {
    Cells row{i == 0 ? "start" : std::to_string(steps[i]->step)};
    for (size_t k = 0; few && k < steps[i]->loads.size(); ++k) row.push_back(figure(steps[i]->loads[k], 5));
    row.push_back(figure(value_in(*steps[i], Measure::kPeakPressure, zone), 6));
    row.push_back(figure(moved[i], 6));
    row.push_back(figure(value_in(*steps[i], Measure::kDissipated, zone) - value_in(*steps[0], Measure::kDissipated, zone), 6));
    append_cells(out, row);
  }
  out += "</table></div>\n<p>Displacement of side 2 against side 1 along t, mean of the pairs that touch in the cycle, and "
         "work of friction, both since "
         "the cycle began.</p>\n</details>\n";
}

} // namespace

void append_page_cycles(std::string& out, const Scene& scene) {
  bool first = true;
  for (size_t i = 0; i < std::min(scene.record->coefficients.size(), kMostCharts); ++i) {
    const CoefficientRecord& c = scene.record->coefficients[i];
    if (c.cycles.empty()) continue;
    if (first) out += "<section id=\"cycle-table\">\n<h2>Cycles</h2>\n";
    first = false;
    out += "<p>&#956; = " + figure(c.mu) + ": " + escape_xml(cycle_text(c, scene.summary)) + ".</p>\n";
    if (!c.other_start.empty()) out += "<p>Compared: " + escape_xml(other_start_text(c)) + ".</p>\n";
    append_cycle_rows(out, scene, c);
    for (size_t z = 0; z < scene.zones.size(); ++z)
      if (!scene.zones[z].tied && z < kMostCharts) append_step_rows(out, scene, c, i, z);
  }
  if (!first) out += "</section>\n";
}

} // namespace app
