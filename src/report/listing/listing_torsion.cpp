// The results of loads round the axis.
#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr int kTorsionColumn = 15;

void append_torsion_value(std::string& out, double value) {
  if (std::isfinite(value))
    append_general(out, value, kTorsionColumn, 7);
  else
    append_column(out, "-", kTorsionColumn);
}

void append_torsion_name(std::string& out, const std::string& name, size_t width) {
  out += "    " + name;
  out.append(width - characters_in(name), ' ');
}

// The angle and the torque of every part at every step.
void append_torsion_steps(std::string& out, const TorsionTable& t) {
  size_t width = 12;
  for (const TorsionPart& part : t.parts) width = std::max(width, characters_in(part.name) + 1);
  for (const TorsionContact& contact : t.contacts) width = std::max(width, characters_in(contact.name) + 1);
  append_torsion_name(out, "turned", width);
  append_column(out, "angle", kTorsionColumn), append_column(out, "torque on it", kTorsionColumn);
  out += "   load factors\n";
  for (const TorsionStep& step : t.steps)
    for (size_t i = 0; i < t.parts.size(); ++i) {
      append_torsion_name(out, t.parts[i].name, width);
      append_torsion_value(out, step.angle[i]), append_torsion_value(out, step.torque[i]);
      out += "  ";
      for (const double load : step.loads) append_general(out, load, 13, 8);
      out += '\n';
    }
  if (t.contacts.empty()) return;
  out += '\n';
  append_torsion_name(out, "interface", width);
  for (const char* heading : {"torque", "slip starts at", "all slip at", "turns through"})
    append_column(out, heading, kTorsionColumn);
  out += '\n';
  for (size_t i = 0; i < t.contacts.size(); ++i) {
    const TorsionContact& c = t.contacts[i];
    append_torsion_name(out, c.name, width);
    append_torsion_value(out, t.steps.empty() ? NAN : t.steps.back().carried[i]);
    for (const double v : {c.start, c.through, c.turns_through}) append_torsion_value(out, v);
    out += '\n';
  }
}

} // namespace

void append_torsion(std::string& out, const RunRecord& record) {
  const TorsionTable& t = record.meshes.torsion;
  if (!t.any()) return;
  append_section(out, "Loads round the axis");
  if (!t.why.empty()) {
    out += "  no results: " + t.why + "\n";
    return;
  }
  append_torsion_steps(out, t);
  for (const TorsionBorder& b : t.borders) {
    out += "    slip of " + t.contacts[static_cast<size_t>(b.contact) - 1].name + " ends at";
    append_general(out, b.at[0], 14, 7), append_general(out, b.at[1], 14, 7);
    out += '\n';
  }
  out +=
      "\n  Torques are those of the whole circle, of the part that is drawn; friction round the axis acts on the pressures of "
      "the last\n  state, without the friction along the surface.\n";
  if (!t.ended.empty()) out += "  The history ended early: " + t.ended + ".\n";
  append_number(append_name(out, "residual of the contacts"), t.residual);
  out += '\n';
  append_number(append_name(out, "balance of the torques"), t.imbalance);
  out += '\n';
}

} // namespace app
