#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// In percent; "-" where there is none.
void append_percent(std::string& out, double part, int width) {
  if (std::isfinite(part))
    append_general(out, 100 * part, width, 2);
  else
    append_column(out, "-", width);
}

void append_rounds(std::string& out, const MeshLoop& loop) {
  out += "    mesh   elements   pairs   equations    seconds   change of tractions, %   of energy, %\n";
  for (size_t i = 0; i < loop.rounds.size(); ++i) {
    const MeshRound& round = loop.rounds[i];
    append_column(out, static_cast<int64_t>(i) + 1, 8);
    append_column(out, round.elements, 11);
    append_column(out, round.pairs, 8);
    append_column(out, round.equations, 12);
    append_general(out, round.seconds, 11, 2);
    append_percent(out, round.pressure, 25);
    append_percent(out, round.energy, 15);
    if (i == loop.taken) out += "   taken";
    out += '\n';
  }
}

void append_number_or(std::string& out, int32_t number, const char* none, int width) {
  if (number > 0)
    append_column(out, number, width);
  else
    append_column(out, none, width);
}

std::string name_of(const Stated& s) { return s.item > 0 ? s.name() + " " + std::to_string(s.item) : s.name(); }

RoundOff round_off_of(const RunRecord& record) {
  static const std::vector<Quantity> kNone;
  const auto& runs = record.coefficients;
  const std::vector<Quantity>& all = runs.empty() || runs.back().steps.empty() ? kNone : runs.back().steps.back().quantities;
  return round_off(all, std::max(extent_of(all), extent_of(record.meshes.stated)));
}

void append_row(std::string& out, const Stated& s, const RoundOff& noise, size_t width) {
  append_number_or(out, s.zone, s.body > 0 ? "-" : "all", 8);
  append_number_or(out, s.body, "-", 7);
  const std::string name = name_of(s);
  out += "   " + name;
  out.append(width - characters_in(name), ' ');
  if (s.has_value())
    append_general(out, noise.shown(s.what, shown_value(s.what, s.value, s.along), s.error), 14);
  else
    append_column(out, "-", 14);
  append_percent(out, noise.shown(s.what, s.scale) == 0.0 ? NAN : s.relative_error(), 11);
  append_percent(out, s.tolerance, 14);
  out += std::isnan(s.tolerance) ? "" : s.is_met() ? "   met" : "   not met";
  if (s.is_unbounded()) out += "   unbounded";
  if (s.body > 0 && std::isfinite(s.at[0])) {
    append_general(out += "   at (", s.at[0], 0);
    append_general(out += ", ", s.at[1], 0);
    out += ')';
  }
  if (std::isfinite(s.angle)) append_general(out += "   plane ", s.angle, 0, 4), out += " deg";
  out += '\n';
}

} // namespace

void append_accuracy(std::string& out, const RunRecord& record) {
  const MeshLoop& loop = record.meshes;
  if (!loop.ran()) return;
  append_section(out, "Accuracy");
  append_rounds(out, loop);
  out += "\n  changes are relative to the previous mesh, whose elements are twice as long; none after an adapted mesh\n";
  if (!loop.stated.empty()) {
    size_t width = 18;
    for (const Stated& s : loop.stated) width = std::max(width, characters_in(name_of(s)) + 1);
    out += "\n    zone   body   quantity";
    out.append(width - 8, ' ') += "         value   error, %   requested, %\n";
    const RoundOff noise = round_off_of(record);
    for (const Stated& s : loop.stated) append_row(out, s, noise, width);
    out += "\n  errors are estimates, not bounds; errors of edges are relative to the contact length, those of a force to the "
           "total "
           "force of the zone\n";
  }
  if (const std::string why = loop.ending(); !why.empty()) out += "  " + why + ".\n";
}

} // namespace app
