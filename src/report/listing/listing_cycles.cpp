// The section "Cycles" of the listing: what the cycle of the load path came to, cycle by cycle and zone by zone.
#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

namespace app {
namespace {

void append_each(std::string& out, const CoefficientRecord& c) {
  out += "\n   cycle         change   dissipated   slip range         walk   stuck slipped\n";
  for (const CycleSeen& one : c.cycles) {
    append_column(out, one.cycles, 8);
    append_general(out, one.change, 15, 3);
    for (const double v : {one.dissipated, one.slip_range, one.walk}) append_general(out, v, 13, 6);
    append_column(out, one.stuck, 8);
    append_column(out, one.slipped, 8);
    out += '\n';
  }
}

void append_zones_of(std::string& out, const CycleSeen& last) {
  out += "\n    zone         walk   slip range touched   stuck slipped\n";
  for (size_t z = 0; z < last.zones.size(); ++z) {
    const ZoneCycle& zone = last.zones[z];
    if (zone.touched == 0) continue;
    append_column(out, static_cast<int64_t>(z) + 1, 8);
    for (const double v : {zone.walk, zone.slip_range}) append_general(out, v, 13, 6);
    for (const int32_t count : {zone.touched, zone.stuck, zone.slipped}) append_column(out, count, 8);
    out += '\n';
  }
}

} // namespace

void append_cycles(std::string& out, const RunRecord& record, const Summary& s, bool all) {
  bool first = true;
  for (const CoefficientRecord& c : record.coefficients) {
    if (c.cycles.empty()) continue;
    if (first) append_section(out, "Cycles");
    first = false;
    append_number(append_name(out, "coefficient of friction"), c.mu);
    out += "\n  " + cycle_text(c, s) + '\n';
    if (!c.other_start.empty()) out += "  " + other_start_text(c) + '\n';
    if (all) append_each(out, c);
    append_zones_of(out, c.cycles.back());
  }
  if (first) return;
  out += "\n  change: over the cycle, of pressures and friction relative to the largest pressure of the path, of gaps to the "
         "largest gap or displacement\n"
         "  walk: (u2 - u1).t from the beginning to the end of the cycle; of a zone the mean of the pairs that touch, of a "
         "cycle the largest of all pairs; stuck: all the time\n";
}

} // namespace app
