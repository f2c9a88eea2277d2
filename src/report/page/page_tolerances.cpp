// The table of tolerances of parameters on the page.
#include "report/page/page_tolerances.hpp"

#include "report/page/page_terms.hpp"
#include "report/pictures/pictures.hpp"

#include <cmath>

namespace app {
namespace {

std::string cell(const std::string& text, const char* tag = "td") {
  return std::string("<") + tag + ">" + text + "</" + tag + ">";
}
std::string figure_or_dash(double value, int digits) { return std::isfinite(value) ? figure(value, digits) : "&#8211;"; }

// A list item for each reason; numbers that share one are named together.
void append_reasons(std::string& out, const ToleranceTable& table) {
  std::string items;
  for (size_t p = 0; p < table.parameters.size(); ++p) {
    const std::string by = "<li>By " + escape_xml(table.parameters[p].name) + " ";
    if (!table.parameters[p].why.empty()) items += by + "no number: " + escape_xml(table.parameters[p].why) + ".</li>\n";
    for (const Toleranced& t : table.numbers)
      if (table.parameters[p].why.empty() && !t.by[p].why.empty())
        items += by + "not the " + escape_xml(table.name_of(t)) + ": " + escape_xml(t.by[p].why) + ".</li>\n";
  }
  if (!items.empty()) out += "<p>No usable derivative:</p>\n<ul>\n" + items + "</ul>\n";
}

} // namespace

void append_page_tolerances(std::string& out, const Scene& scene) {
  const ToleranceTable& table = scene.record->meshes.tolerances;
  if (!table.any()) return;
  out += "<section id=\"tolerance-table\">\n<h2>Wanted numbers and tolerances</h2>\n";
  if (!table.why.empty()) out += "<p>No derivatives: " + escape_xml(table.why) + ".</p>\n";
  if (!table.numbers.empty()) {
    out += "<div class=\"wide\"><table class=\"dense\">\n<tr>" + cell("quantity", "th") + cell("value", "th") +
           cell("worst case", "th") + cell("root of squares", "th");
    for (const ToleranceOf& p : table.parameters)
      out += cell("by " + escape_xml(p.name) + " = " + figure(p.value, 6) + " &#177; " + figure(p.size), "th");
    out += "</tr>\n";
    for (const Toleranced& t : table.numbers) {
      std::string name = escape_xml(table.name_of(t));
      if (t.number.zone > 0 && table.is_of_several_zones())
        name += ", " + zone_label(scene, static_cast<size_t>(t.number.zone) - 1);
      out += "<tr>" + cell(name) +
             cell(figure(shown_value(t.number.what, t.number.value, t.number.along), unit_of(t.number.what, scene), 6)) +
             cell(figure_or_dash(table.worst_case(t), 3)) + cell(figure_or_dash(table.root_of_squares(t), 3));
      for (size_t p = 0; p < t.by.size(); ++p) out += cell(figure_or_dash(table.share(t, p), 3));
      out += "</tr>\n";
    }
    out += "</table></div>\n<p>By a parameter: the share, the magnitude of the derivative times the tolerance, in the unit of "
           "the value.</p>\n";
    append_reasons(out, table);
  }
  out += "</section>\n";
}

} // namespace app
