#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"
#include "report/totals.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kZeroForce = 1e-12; // of the sum of the sizes of all tractions

// One component of force of one body.
struct Row {
  std::string name;
  double applied, contact, lines; // the last: of the lines of symmetry
  double sum() const { return applied + contact + lines; }
};

std::vector<Row> rows_of_body(const Scene& scene, int32_t body, const std::string& label) {
  const c2d_body_result& b = scene.summary.body[body - 1];
  std::vector<Row> out;
  for (int k = 0; k < 2; ++k) {
    const bool cut = (lines_that_cut(scene.summary, body) >> k & 1) != 0; // by a line that carries this component
    out.push_back({label + (k == 0 ? ", fx" : ", fy"), b.applied[k], b.contact[k], cut ? -b.applied[k] - b.contact[k] : 0.0});
  }
  return out;
}

void draw_bar(Svg& svg, const Chart& chart, double y, double value, const std::string& fill, const char* ink) {
  const double zero = chart.at(0.0, 0.0).x, end = chart.at(value, 0.0).x;
  svg.rectangle({std::min(zero, end), y, std::max(zero, end), y + 11.0}, fill, Stroke{ink, 0.8, ""});
}

// Contact forces: of two bodies either one, of more every zone.
std::string contact_text(const Scene& scene) {
  const Summary& s = scene.summary;
  const double noise = kZeroForce * sum_of_forces(scene);
  const auto size = [&](const double* force) {
    const double is = std::hypot(force[0], force[1]);
    return figure(is <= noise ? 0.0 : is, scene.force_unit, 6);
  };
  if (!s.names_bodies()) return "; the contact carries " + size(s.body[0].contact);
  std::string out;
  c2d_zone_state state = C2D_INIT(c2d_zone_state);
  for (size_t z = 0; z < std::min(scene.zones.size(), kMostCharts); ++z) {
    if (c2d_get_zone_state(scene.solver, static_cast<int32_t>(z) + 1, &state) != C2D_OK) break;
    out += (z == 0 ? "; the contact carries " : ", ") + size(state.force) + " in " + zone_label(scene, z) + " (" +
           bodies_of(scene, scene.zones[z]) + ")";
  }
  return out;
}

// A long name would leave the bars no room: the number alone.
std::string short_label(const Scene& scene, int32_t body) {
  const std::string label = body_label(scene, body);
  return text_width(label, 12.0) < 130.0 ? label : "body " + std::to_string(body);
}

std::string caption(const Scene& scene, const std::vector<Row>& rows, bool lines) {
  std::string out =
      (scene.is_revolved() ? "Forces on each body at " : "Forces per unit thickness on each body at ") + place_at_end(scene);
  out += ": loads and supports";
  if (!scene.pairs.empty()) out += lines ? ", contact tractions" : " and contact tractions";
  if (lines) out += " and the lines of symmetry";
  out += scene.pairs.empty() && !lines ? " add up to zero" : " cancel";
  double worst = 0.0;
  for (const Row& row : rows) worst = std::max(worst, std::fabs(row.sum()));
  const double all = sum_of_forces(scene);
  if (all > 0.0) out += " to within " + figure(worst / all, 2) + " of the sum of the sizes of all tractions";
  if (!scene.pairs.empty()) out += contact_text(scene);
  const std::string whose = whose_forces(scene.summary);
  return out + (whose.empty() ? "." : ". They are those " + whose + ".");
}

} // namespace

void draw_balance(const Scene& scene, Pictures& out) {
  const Summary& s = scene.summary;
  std::vector<Row> rows;
  Range range;
  range.include(0.0);
  for (int32_t b = 1; b <= s.bodies; ++b)
    for (const Row& each : rows_of_body(scene, b, short_label(scene, b))) rows.push_back(each);
  const bool contact = !scene.pairs.empty();
  bool lines = false;
  for (int32_t b = 1; b <= s.bodies; ++b) lines = lines || lines_that_cut(s, b) != 0;
  const std::string words = caption(scene, rows, lines);
  const double noise = kZeroForce * sum_of_forces(scene);
  for (Row& each : rows)
    for (double* value : {&each.applied, &each.contact, &each.lines}) {
      if (std::fabs(*value) <= noise) *value = 0.0;
      range.include(*value);
    }
  double left = 84.0;
  for (const Row& each : rows) left = std::max(left, 16.0 + text_width(each.name, 12.0));
  const double row = 28.0 + (contact ? 12.0 : 0.0) + (lines ? 14.0 : 0.0), right = kPictureWidth - 112.0, top = 54.0;
  const double bottom = top + row * static_cast<double>(rows.size());
  Svg svg("balance", kPictureWidth, bottom + 44.0);
  const std::string hatched = svg.hatch(colour::kOrange, "#fbe3d0");
  std::vector<LegendEntry> entries{{"loads and supports", Stroke{colour::kBlue, 0.8, ""}, Mark::kNone, true, colour::kBlue}};
  if (contact) entries.push_back({"contact", Stroke{colour::kOrange, 0.8, ""}, Mark::kNone, true, hatched});
  if (lines) entries.push_back({"lines of symmetry", Stroke{colour::kGreen, 1.6, ""}, Mark::kNone, true, "none"});
  draw_legend(&svg, {left, 4.0}, right + 106.0 - left, entries);
  Chart chart{{left, top, right, bottom},
              make_axis(range, scene.is_revolved() ? "force" : "force per thickness", scene.force_unit, 7),
              Axis{}};
  chart.y.name = "";
  chart.y.low = 0.0, chart.y.high = 1.0, chart.y.ticks = 0;
  draw_axes(svg, chart);
  svg.text({right + 106.0, top - 8.0}, "sum", 11.0, Anchor::kEnd);
  for (size_t i = 0; i < rows.size(); ++i) {
    const double y = top + row * static_cast<double>(i);
    if (i > 0) svg.line({left, y}, {right, y}, Stroke{colour::kGrid, 0.7, ""});
    draw_bar(svg, chart, y + 8.0, rows[i].applied, colour::kBlue, colour::kBlue);
    if (contact) draw_bar(svg, chart, y + 22.0, rows[i].contact, hatched, colour::kOrange);
    if (rows[i].lines != 0.0) draw_bar(svg, chart, y + (contact ? 36.0 : 22.0), rows[i].lines, "none", colour::kGreen);
    const double middle = y + 0.5 * row + 4.0;
    svg.text({left - 8.0, middle}, rows[i].name, 12.0, Anchor::kEnd);
    svg.text({right + 106.0, middle}, figure(std::fabs(rows[i].sum()) <= noise ? 0.0 : rows[i].sum(), scene.force_unit, 3),
             11.0, Anchor::kEnd);
  }
  const double zero = chart.at(0.0, 0.0).x;
  svg.line({zero, top}, {zero, bottom}, Stroke{colour::kInk, 1.0, ""});
  Picture picture{"balance", "Balance of forces", words, ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
