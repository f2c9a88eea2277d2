#include "report/listing/listing.hpp"

#include "report/listing/listing_items.hpp"
#include "report/text.hpp"

#include <cmath>

namespace app {
namespace {

// Tractions of all touching pairs after a change of status (IOUT of 3 or more).
void append_answers(std::string& out, const c2d_step& step) {
  static const int kColumns[] = {C2D_TN, C2D_TT, C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2, C2D_GAP, C2D_SLIP_SUM};
  out += "            pair           tn           tt          un1          ut1          un2          ut2"
         "          gap         slip\n";
  for (int32_t p = 0; p < step.pairs; ++p) {
    const double* row = step.table + p * step.stride;
    if (static_cast<int>(row[C2D_STATUS]) == C2D_OPEN) continue;
    append_column(out, p + 1, 16);
    for (const int c : kColumns) append_scientific(out, row[c], 13);
    out += '\n';
  }
}

// "-0.375", right-aligned in 7 columns.
void append_place(std::string& out, double eta) {
  const long thousandths = std::lround(std::fabs(eta) * 1000.0);
  std::string text = eta < 0.0 && thousandths > 0 ? "-" : "";
  text += std::to_string(thousandths / 1000) + "." + std::to_string(1000 + thousandths % 1000).substr(1);
  append_column(out, text.c_str(), 7);
}

} // namespace

c2d_status append_zones(std::string& out, c2d_solver* solver, const Summary& s) {
  if (s.zones == 0) return C2D_OK;
  const bool named = s.names_bodies();
  append_section(out, "Contact zones");
  out += named ? "    zone   pairs   elements          side 1 elements     nodes             side 2 elements     "
                 "nodes   bodies\n"
               : "    zone   pairs   elements          body 1 elements     nodes             body 2 elements     "
                 "nodes\n";
  for (int32_t i = 1; i <= s.zones; ++i) {
    c2d_zone z = C2D_INIT(c2d_zone);
    if (const c2d_status status = c2d_get_zone(solver, i, &z); status != C2D_OK) return status;
    append_column(out, i, 8);
    append_column(out, z.pairs, 8);
    append_column(out, z.side2.elements, 11);
    for (int k = 0; k < 2; ++k) {
      const c2d_side& side = k == 0 ? z.side1 : z.side2;
      append_column(out, side.first_element, k == 0 ? 19 : 20);
      append_column(out, side.last_element, 6);
      if (side.first_node == 0) { // a free zone: points of side 1, no nodes
        append_column(out, "points", 12);
        continue;
      }
      append_column(out, side.first_node, 6);
      append_column(out, side.last_node, 6);
    }
    if (named) out += "   " + bodies_text(s, z);
    if (!s.zone_name[static_cast<size_t>(i) - 1].empty()) out += ", " + s.zone_name[static_cast<size_t>(i) - 1];
    out += '\n';
  }
  return C2D_OK;
}

void append_step(std::string& out, const c2d_step& step, bool first) {
  const size_t others = step.cases > 1 ? static_cast<size_t>(step.cases) - 1 : 0; // load cases
  int32_t count[3] = {0, 0, 0};
  for (int32_t p = 0; p < step.pairs; ++p) {
    const int32_t status = static_cast<int32_t>(step.table[p * step.stride + C2D_STATUS]);
    if (status >= 0 && status < 3) ++count[status];
  }
  if (first) {
    append_section(out, "Increments");
    append_number(append_name(out, "coefficient of friction"), step.mu);
    out += step.cases > 1 ? "\n\n    step   load factors" : "\n\n    step    load factor";
    out.append(15 * others, ' ') += "    open   stick    slip changes   status of the pairs (- open, o stick, / slip)\n";
  }
  if (step.kind == C2D_STEP_CHANGE)
    append_column(out, "change", 8);
  else if (step.kind == C2D_STEP_CYCLE)
    append_column(out, "cycle", 8);
  else if (step.kind == C2D_STEP_STOPPED)
    append_column(out, "stopped", 8);
  else
    append_column(out, step.step, 8);
  append_general(out, step.load, 15, 8);
  for (size_t k = 1; k <= others; ++k) append_general(out, step.loads[k], 15, 8);
  for (const int32_t c : count) append_column(out, c, 8);
  append_column(out, step.changes, 8);
  out += "   ";
  static const char kMark[] = "-o/";
  for (int32_t p = 0; p < step.pairs; ++p) {
    const int32_t status = static_cast<int32_t>(step.table[p * step.stride + C2D_STATUS]);
    if (p > 0 && p % 100 == 0) out.append(1, '\n').append(58 + 15 * others, ' ');
    out += status >= 0 && status < 3 ? kMark[status] : '?';
  }
  out += '\n';
  if (step.kind == C2D_STEP_CHANGE) append_answers(out, step);
}

namespace {

// Explains n, t, tn and tt of zones with their sides on these bodies; `free`: one of them joins
// meshes that do not match.
void append_frame(std::string& out, const Summary& s, const c2d_zone& zone, bool free) {
  const std::string body1 = body_text(s, zone.side1.body), body2 = body_text(s, zone.side2.body);
  out += "  Frame: n from " + body1 + " to " + body2 + ", t is n turned by -90 degrees. Tractions act on " + body2 +
         " per length of " + body1;
  if (free)
    out += ",\n  in zones of non-matching meshes per length of " + body2 + "; their pairs have a coordinate on an element of " +
           body1 + ", from -1 to 1,\n  instead of an end";
  out += ".\n\n";
}

void append_end(std::string& out, const CoefficientRecord& c, const ContactEnd& end) {
  const double* row = c.table.data() + static_cast<size_t>(end.pair - 1) * C2D_PAIR_FIELDS;
  append_column(out, end.pair, 8);
  append_column(out, end.element, 8);
  if (end.local > 0)
    append_column(out, end.local, 7);
  else
    append_place(out, end.eta);
  const double un = row[end.side == 1 ? C2D_UN1 : C2D_UN2], ut = row[end.side == 1 ? C2D_UT1 : C2D_UT2];
  for (const double number : {end.x, end.y, un, ut, row[C2D_TN], row[C2D_TT]}) append_scientific(out, number, 13);
  append_column(out, status_word(static_cast<int32_t>(row[C2D_STATUS])), 8);
  out += '\n';
}

const char kEndColumns[] =
    "    pair element    end            x            y           un           ut           tn           tt  status\n";

// All ends of a body, whose zones are alike: of the only two bodies.
void append_ends(std::string& out, const CoefficientRecord& c, const std::vector<ContactEnd>& ends, const Summary& s) {
  bool free = false;
  for (const c2d_zone& zone : s.zone) free = free || (zone.kind & C2D_ZONE_FREE) != 0;
  append_frame(out, s, s.zone[0], free);
  out += kEndColumns;
  for (const ContactEnd& end : ends) append_end(out, c, end);
}

void append_zone_frame(std::string& out, const Summary& s, const c2d_zone& zone) {
  if ((zone.kind & C2D_ZONE_FREE) == 0) return append_frame(out, s, zone, false);
  const std::string body1 = body_text(s, zone.side1.body), body2 = body_text(s, zone.side2.body);
  out += "  Frame: n from " + body1 + " to " + body2 + ", t is n turned by -90 degrees. Tractions act on " + body2 +
         " per length of " + body2 + ";\n  pairs have a coordinate on an element of " + body1 +
         ", from -1 to 1, instead of an end.\n\n";
}

// The same zone by zone.
void append_zone_ends(std::string& out, const CoefficientRecord& c, const std::vector<ContactEnd>& ends, const Summary& s) {
  int32_t zone = 0;
  for (const ContactEnd& end : ends) {
    if (end.zone != zone) {
      zone = end.zone;
      const c2d_zone& z = s.zone[static_cast<size_t>(zone) - 1];
      out += "\n  " + zone_text(s, zone) + ": " + bodies_text(s, z) + "\n";
      append_zone_frame(out, s, z);
      out += kEndColumns;
    }
    append_end(out, c, end);
  }
}

} // namespace

void append_contact_zone(std::string& out, const CoefficientRecord& c, const std::vector<ContactEnd>* ends, const Summary& s) {
  if (s.pairs == 0 || c.table.empty()) return;
  for (int32_t body = 1; body <= s.bodies; ++body) {
    const std::vector<ContactEnd>& own = ends[body - 1];
    if (s.names_bodies() && own.empty()) continue; // touches no other body
    append_section(out, "Contact zone of " + body_text(s, body));
    append_item(out, "coefficient of friction", c.mu);
    append_loads(out, c.loads);
    (s.names_bodies() ? append_zone_ends : append_ends)(out, c, own, s);
  }
}

} // namespace app
