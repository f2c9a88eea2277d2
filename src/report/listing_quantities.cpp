#include "report/listing.hpp"

#include "report/listing_items.hpp"
#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

void append_row(std::string& out, const Quantity& q) {
  if (q.zone > 0)
    append_column(out, q.zone, 8);
  else
    append_column(out, "all", 8);
  std::string name = name_of(q.what);
  if (q.item > 0) name += " " + std::to_string(q.item);
  out += "   " + name;
  out.append(name.size() < 18 ? 18 - name.size() : 1, ' ');
  append_general(out, q.value, 14);
  std::string error;
  if (std::isfinite(q.error)) append_general(error += "+- ", q.error, 0, 2);
  if (!error.empty() || std::isfinite(q.at[0])) out.append(2, ' ') += error;
  if (std::isfinite(q.at[0])) {
    out.append(error.size() < 14 ? 14 - error.size() : 1, ' ');
    for (const double v : q.at) append_general(out, v, 14);
  }
  out += '\n';
}

} // namespace

void append_quantities(std::string& out, const RunRecord& record, const Summary& s) {
  if (s.pairs == 0) return;
  append_section(out, "Contact in numbers");
  for (const CoefficientRecord& c : record.coefficients) {
    if (c.steps.empty()) continue;
    append_number(append_name(out, "coefficient of friction"), c.mu);
    out += "\n";
    append_item(out, "load factor", c.load);
    out += "\n    zone   quantity                   value    stated error              x             y\n";
    for (const Quantity& q : c.steps.back().quantities) append_row(out, q);
    out += '\n';
  }
  out += "  edges and borders are counted by the length along side 2 from the zone's first pair, x and y is where they are; an "
         "edge\n"
         "  pressure is p / sqrt(d), an edge friction q sqrt(d), at the distance d inside an edge\n";
}

} // namespace app
