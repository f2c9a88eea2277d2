#include "report/page/page_torsion.hpp"

#include "report/pictures/pictures.hpp"

#include <cmath>

namespace app {
namespace {

std::string torsion_cell(const std::string& text, const char* tag = "td") {
  return std::string("<") + tag + ">" + text + "</" + tag + ">";
}
std::string torsion_figure(double value) { return torsion_cell(std::isfinite(value) ? figure(value, 6) : "&#8211;"); }

} // namespace

void append_page_torsion(std::string& out, const Scene& scene) {
  const TorsionTable& t = scene.record->meshes.torsion;
  if (!t.any()) return;
  out += "<section id=\"torsion-table\">\n<h2>Loads round the axis</h2>\n";
  if (!t.why.empty()) {
    out += "<p>No results: " + escape_xml(t.why) + ".</p>\n</section>\n";
    return;
  }
  const TorsionStep& last = t.steps.back();
  out += "<div class=\"wide\"><table class=\"dense\">\n<tr>" + torsion_cell("turned", "th") + torsion_cell("angle", "th") +
         torsion_cell("torque on it", "th") + "</tr>\n";
  for (size_t i = 0; i < t.parts.size(); ++i)
    out += "<tr>" + torsion_cell(escape_xml(t.parts[i].name)) + torsion_figure(last.angle[i]) + torsion_figure(last.torque[i]) +
           "</tr>\n";
  out += "</table></div>\n";
  if (!t.contacts.empty()) {
    out += "<div class=\"wide\"><table class=\"dense\">\n<tr>" + torsion_cell("interface", "th") +
           torsion_cell("torque", "th") + torsion_cell("slip starts at", "th") + torsion_cell("all slip at", "th") +
           torsion_cell("turns through", "th") + "</tr>\n";
    for (size_t i = 0; i < t.contacts.size(); ++i)
      out += "<tr>" + torsion_cell(escape_xml(t.contacts[i].name)) + torsion_figure(last.carried[i]) +
             torsion_figure(t.contacts[i].start) + torsion_figure(t.contacts[i].through) +
             torsion_figure(t.contacts[i].turns_through) + "</tr>\n";
    out += "</table></div>\n";
  }
  out += "<p>Torques are those of the whole circle, of the part that is drawn, in the last state.";
  if (!t.ended.empty()) out += " The history ended early: " + escape_xml(t.ended) + ".";
  out += "</p>\n</section>\n";
}

} // namespace app
