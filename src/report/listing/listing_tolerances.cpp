#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

void append_toleranced_parameters(std::string& out, const ToleranceTable& table) {
  out += "    parameter                 value      tolerance\n";
  for (const ToleranceOf& p : table.parameters) {
    out += "    " + p.name;
    out.append(p.name.size() < 15 ? 15 - p.name.size() : 0, ' ');
    append_general(out, p.value, 16);
    append_general(out, p.size, 15, 4);
    out += p.why.empty() ? "\n" : "   no derivatives: " + p.why + "\n";
  }
}

void append_or_dash(std::string& out, double value, int width, int digits) {
  if (std::isfinite(value))
    append_general(out, value, width, digits);
  else
    append_column(out, "-", width);
}

// A number with its sums, then a line for each parameter.
void append_toleranced(std::string& out, const ToleranceTable& table, const Toleranced& t, size_t width) {
  const Stated& s = t.number;
  if (s.zone > 0)
    append_column(out, s.zone, 8);
  else
    append_column(out, s.body > 0 ? "-" : "all", 8);
  if (s.body > 0)
    append_column(out, s.body, 7);
  else
    append_column(out, "-", 7);
  const std::string name = table.name_of(t);
  out += "   " + name;
  out.append(width - characters_in(name), ' ');
  append_general(out, shown_value(s.what, s.value, s.along), 14);
  append_or_dash(out, table.worst_case(t), 14, 4);
  append_or_dash(out, table.root_of_squares(t), 18, 4);
  out += '\n';
  for (size_t p = 0; p < t.by.size(); ++p) {
    const std::string by = "  by " + table.parameters[p].name;
    out.append(18, ' ') += by;
    out.append(by.size() < width ? width - by.size() : 0, ' ');
    append_or_dash(out, t.by[p].derivative, 14, 5);
    append_or_dash(out, table.share(t, p), 14, 4);
    if (!t.by[p].why.empty()) out += "   no usable derivative: " + t.by[p].why;
    out += '\n';
  }
}

} // namespace

void append_tolerances(std::string& out, const RunRecord& record) {
  const ToleranceTable& table = record.meshes.tolerances;
  if (!table.any()) return;
  append_section(out, "Tolerances");
  append_toleranced_parameters(out, table);
  if (!table.why.empty()) out += "\n  no derivatives: " + table.why + "\n";
  if (table.numbers.empty()) return;
  size_t width = 18;
  for (const Toleranced& t : table.numbers) width = std::max(width, characters_in(table.name_of(t)) + 1);
  for (const ToleranceOf& p : table.parameters) width = std::max(width, p.name.size() + 6);
  out += "\n    zone   body   quantity";
  out.append(width - 8, ' ') += "         value    worst case   root of squares\n";
  out.append(18, ' ') += "  by parameter";
  out.append(width - 14, ' ') += "    derivative         share\n";
  for (const Toleranced& t : table.numbers) append_toleranced(out, table, t, width);
  out +=
      "\n  share: magnitude of the derivative times the tolerance; worst case: their sum; derivatives are differences on the "
      "mesh of the results\n";
}

} // namespace app
