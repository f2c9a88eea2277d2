#include "report/drawn/axes.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// One component of force of one body.
struct Row {
  std::string name;
  double applied, contact;
};

void draw_bar(Svg& svg, const Chart& chart, double y, double value, const std::string& fill, const char* ink) {
  const double zero = chart.at(0.0, 0.0).x, end = chart.at(value, 0.0).x;
  svg.rectangle({std::min(zero, end), y, std::max(zero, end), y + 11.0}, fill, Stroke{ink, 0.8, ""});
}

// Contact forces: of two bodies either one, of more every zone.
std::string contact_text(const Scene& scene) {
  const Summary& s = scene.summary;
  if (!s.names_bodies())
    return "; the contact carries " + figure(std::hypot(s.body[0].contact[0], s.body[0].contact[1]), scene.force_unit, 6);
  std::string out;
  c2d_zone_state state = C2D_INIT(c2d_zone_state);
  for (size_t z = 0; z < std::min(scene.zones.size(), kMostCharts); ++z) {
    if (c2d_get_zone_state(scene.solver, static_cast<int32_t>(z) + 1, &state) != C2D_OK) break;
    out += (z == 0 ? "; the contact carries " : ", ") +
           figure(std::hypot(state.force[0], state.force[1]), scene.force_unit, 6) + " in " + zone_label(scene, z) + " (" +
           bodies_of(scene, scene.zones[z]) + ")";
  }
  return out;
}

// A long name would leave the bars no room: the number alone.
std::string short_label(const Scene& scene, int32_t body) {
  const std::string label = body_label(scene, body);
  return text_width(label, 12.0) < 130.0 ? label : "body " + std::to_string(body);
}

std::string caption(const Scene& scene) {
  const Summary& s = scene.summary;
  std::string out = "Forces per unit thickness on each body at " + place_at_end(scene);
  out += ": loads and supports";
  out += scene.pairs.empty() ? " add up to zero" : " and contact tractions cancel";
  double largest = 0.0, worst = 0.0;
  for (int32_t b = 0; b < s.bodies; ++b)
    for (int k = 0; k < 2; ++k) {
      largest = std::max({largest, std::fabs(s.body[b].applied[k]), std::fabs(s.body[b].contact[k])});
      worst = std::max(worst, std::fabs(s.body[b].applied[k] + s.body[b].contact[k]));
    }
  if (largest > 0.0) out += " to within " + figure(worst / largest, 2) + " of the largest force";
  if (!scene.pairs.empty()) out += contact_text(scene);
  if (scene.summary.plane == C2D_AXISYMMETRIC) out += ". They are those of the whole circumference";
  if (mirror_lines(scene.summary) != 0)
    out += ". They are those of the part that is modelled, without the forces across the lines of symmetry";
  return out + ".";
}

} // namespace

void draw_balance(const Scene& scene, Pictures& out) {
  const Summary& s = scene.summary;
  std::vector<Row> rows;
  Range range;
  range.include(0.0);
  for (int32_t b = 0; b < s.bodies; ++b)
    for (int k = 0; k < 2; ++k) {
      rows.push_back({short_label(scene, b + 1) + (k == 0 ? ", fx" : ", fy"), s.body[b].applied[k], s.body[b].contact[k]});
      range.include(s.body[b].applied[k]);
      range.include(s.body[b].contact[k]);
    }
  const bool contact = !scene.pairs.empty();
  double left = 84.0;
  for (const Row& each : rows) left = std::max(left, 16.0 + text_width(each.name, 12.0));
  const double row = contact ? 40.0 : 28.0, right = kPictureWidth - 112.0, top = 54.0;
  const double bottom = top + row * static_cast<double>(rows.size());
  Svg svg("balance", kPictureWidth, bottom + 44.0);
  const std::string hatched = svg.hatch(colour::kOrange, "#fbe3d0");
  std::vector<LegendEntry> entries{{"loads and supports", Stroke{colour::kBlue, 0.8, ""}, Mark::kNone, true, colour::kBlue}};
  if (contact) entries.push_back({"contact", Stroke{colour::kOrange, 0.8, ""}, Mark::kNone, true, hatched});
  draw_legend(&svg, {left, 4.0}, right - left, entries);
  Chart chart{{left, top, right, bottom}, make_axis(range, "force per thickness", scene.force_unit, 7), Axis{}};
  chart.y.name = "";
  chart.y.low = 0.0, chart.y.high = 1.0, chart.y.ticks = 0;
  draw_axes(svg, chart);
  svg.text({right + 106.0, top - 8.0}, "sum", 11.0, Anchor::kEnd);
  for (size_t i = 0; i < rows.size(); ++i) {
    const double y = top + row * static_cast<double>(i);
    if (i > 0) svg.line({left, y}, {right, y}, Stroke{colour::kGrid, 0.7, ""});
    draw_bar(svg, chart, y + 8.0, rows[i].applied, colour::kBlue, colour::kBlue);
    if (contact) draw_bar(svg, chart, y + 22.0, rows[i].contact, hatched, colour::kOrange);
    const double middle = y + 0.5 * row + 4.0;
    svg.text({left - 8.0, middle}, rows[i].name, 12.0, Anchor::kEnd);
    svg.text({right + 106.0, middle}, figure(rows[i].applied + rows[i].contact, scene.force_unit, 3), 11.0, Anchor::kEnd);
  }
  const double zero = chart.at(0.0, 0.0).x;
  svg.line({zero, top}, {zero, bottom}, Stroke{colour::kInk, 1.0, ""});
  Picture picture{"balance", "Balance of forces", caption(scene), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
