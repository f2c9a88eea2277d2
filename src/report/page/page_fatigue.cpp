#include "report/page/page_fatigue.hpp"

#include "report/page/page_terms.hpp"
#include "report/pictures/pictures.hpp"

#include <cmath>

namespace app {
namespace {

std::string fatigue_cell(const std::string& text) { return "<td>" + text + "</td>"; }
std::string fatigue_figure(double value, int digits) { return std::isfinite(value) ? figure(value, digits) : "&#8211;"; }

void append_fatigue_row(std::string& out, const Scene& scene, const Stated& s) {
  const std::string unit = unit_of(s.what, scene);
  out += "<tr>" + fatigue_cell(term_link(s.what) + escape_xml(s.of)) + fatigue_cell(body_label(scene, s.body)) +
         fatigue_cell(figure(s.value, unit, 5)) + fatigue_cell("&#177; " + fatigue_figure(s.error, 2));
  for (const double at : s.at) out += fatigue_cell(fatigue_figure(at, 5));
  out += fatigue_cell(std::isfinite(s.angle) ? figure(s.angle, 4) + "&#176;" : "&#8211;") + "</tr>\n";
}

} // namespace

bool is_fatigue(const Stated& s) { return s.what >= Measure::kSwt && s.what <= Measure::kCrackRange; }

void append_page_fatigue(std::string& out, const Scene& scene) {
  std::string rows;
  for (const Stated& s : scene.record->meshes.stated)
    if (is_fatigue(s)) append_fatigue_row(rows, scene, s);
  if (rows.empty()) return;
  out += "<section id=\"fatigue-table\">\n<h2>Fatigue, last cycle</h2>\n<div class=\"wide\"><table class=\"dense\">\n<tr>";
  const std::string unit = scene.length_unit.empty() ? "" : ", " + scene.length_unit;
  for (const std::string& name : {std::string("parameter"), std::string("body"), std::string("value"),
                                  std::string("stated error"), "x" + unit, "y" + unit, std::string("plane")})
    out += "<th>" + name + "</th>";
  out += "</tr>\n" + rows +
         "</table></div>\n<p>Plane: the angle of its normal from x; planes that contain the z direction are searched.</p>\n"
         "</section>\n";
}

} // namespace app
