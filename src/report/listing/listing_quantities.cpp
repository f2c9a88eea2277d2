#include "report/listing/listing.hpp"

#include "report/listing/key_table.hpp"
#include "report/listing/listing_items.hpp"
#include "report/text.hpp"
#include "report/totals.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

void append_row(std::string& out, const TableNumber& number, const RoundOff& noise) {
  const Quantity& q = number.is;
  if (q.zone > 0)
    append_column(out, q.zone, 8);
  else
    append_column(out, "all", 8);
  std::string name = name_of(q.what);
  if (q.item > 0) name += " " + std::to_string(q.item);
  out += "   " + (name += number.of);
  out.append(name.size() < 18 ? 18 - name.size() : 1, ' ');
  append_general(out, noise.shown(q.what, shown_value(q.what, q.value, q.along), q.error), 14);
  std::string error;
  if (std::isfinite(q.error)) append_general(error += "+- ", noise.shown(q.what, q.error), 0, 2);
  if (!error.empty() || std::isfinite(q.at[0])) out.append(2, ' ') += error;
  if (std::isfinite(q.at[0])) {
    out.append(error.size() < 14 ? 14 - error.size() : 1, ' ');
    for (const double v : {q.at[0], q.at[1], q.along}) append_general(out, v, 14);
  }
  out += '\n';
}

// Lists, which are as long as they like, begin at the left.
void append_line(std::string& out, const KeyTable& table, const std::vector<std::string>& cells,
                 const std::vector<size_t>& widths) {
  for (size_t k = 0; k < cells.size(); ++k) {
    if (!table.is_list(k)) {
      append_column(out, cells[k].c_str(), k == 0 ? 8 : 14);
      continue;
    }
    out += "  " + cells[k];
    if (k + 1 < cells.size()) out.append(widths[k] - cells[k].size(), ' ');
  }
  out += '\n';
}

void append_table(std::string& out, const KeyTable& table) {
  std::vector<size_t> widths;
  for (const std::string& name : table.heading) widths.push_back(name.size());
  for (const std::vector<std::string>& row : table.rows)
    for (size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  append_line(out, table, table.heading, widths);
  for (const std::vector<std::string>& row : table.rows) append_line(out, table, row, widths);
}

} // namespace

void append_quantities(std::string& out, const RunRecord& record, const Summary& s) {
  if (s.pairs == 0) return;
  append_section(out, "Contact in numbers");
  for (const CoefficientRecord& c : record.coefficients) {
    if (c.steps.empty()) continue;
    append_number(append_name(out, "coefficient of friction"), c.mu);
    out += "\n";
    append_loads(out, c.loads);
    out += "\n    zone   quantity                   value    stated error              x             y         along\n";
    const std::vector<Quantity>& all = c.steps.back().quantities;
    const RoundOff noise = round_off(all, extent_of(all));
    for (const TableNumber& number : with_wholes(all, s)) append_row(out, number, noise);
    out += '\n';
  }
  if (const std::string whose = whose_forces(s); !whose.empty())
    out += "  forces, moments and dissipated work: " + whose + '\n';
  out += "  along: distance of a place along the second side of the contact statement from the start of its first curve (of a "
         "deck: along side 2), the same on every mesh; it is the value of an edge or border\n"
         "  widths: of the whole contact; half width and eccentricity: of one stretch\n"
         "  edge pressure p: tn = p / sqrt(d); edge friction q: tt = q sqrt(d); d: distance inside the edge\n";
}

void append_key_tables(std::string& out, const RunRecord& record, const Summary& s) {
  if (s.pairs == 0) return;
  std::string tables;
  for (const CoefficientRecord& c : record.coefficients)
    for (int32_t zone = 1; zone <= s.zones; ++zone) {
      const KeyTable table = key_table(c, zone, 6);
      if (table.rows.size() < 2) continue; // the last state stands above
      append_number(append_name(tables, "coefficient of friction"), c.mu);
      tables += "\n  " + zone_text(s, zone) + "\n";
      append_table(tables, table);
    }
  if (tables.empty()) return;
  append_section(out, "Contact in numbers, step by step");
  out += tables + "\n  dissipated: by friction in the zone since zero load\n  peak along, edges, borders: distances along the "
                  "second side of the contact statement, the same on every mesh\n";
}

} // namespace app
