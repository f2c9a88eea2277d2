// The cycles of a load path in the JSON: what they came to, and each of them.
#include "report/json/json.hpp"

#include "report/json/json_object.hpp"

namespace app {
namespace {

void append_cycle_zones(std::string& out, const CycleSeen& one) {
  out += '[';
  for (size_t z = 0; z < one.zones.size(); ++z) {
    if (z > 0) out += ", ";
    const ZoneCycle& zone = one.zones[z];
    Object o(out, "{", ", ");
    o.integer("zone", static_cast<int64_t>(z) + 1);
    o.integer("touched", zone.touched);
    o.integer("stuck", zone.stuck);
    o.integer("slipped", zone.slipped);
    o.number("walk", zone.walk);
    o.number("slip_range", zone.slip_range);
    out += '}';
  }
  out += ']';
}

void append_cycle(std::string& out, const CycleSeen& one) {
  Object o(out, "{", ", ");
  o.integer("cycle", one.cycles);
  o.integer("extrapolations", one.extrapolations);
  o.number("change", one.change);
  o.number("dissipated", one.dissipated);
  o.number("elastic", one.elastic);
  o.number("slip_range", one.slip_range);
  o.integer("slip_range_pair", one.range_pair);
  o.number("walk", one.walk);
  o.integer("walk_pair", one.walk_pair);
  o.integer("stuck", one.stuck);
  o.integer("slipped", one.slipped);
  append_cycle_zones(o.key("zones"), one);
  out += '}';
}

void append_other_start(std::string& out, const CoefficientRecord& c) {
  const OtherStart& other = c.other_start[0];
  Object o(out, "{", ", ");
  o.word("text", other_start_text(c).c_str());
  if (other.why.empty()) {
    o.word("result", cycle_word(other.last.result));
    o.key("same") += other.same ? "true" : "false";
    o.number("difference", other.apart);
    append_cycle(o.key("last"), other.last);
  }
  out += '}';
}

} // namespace

void append_json_cycles(std::string& out, const RunRecord& record, const Summary& s) {
  out += '[';
  bool first = true;
  for (const CoefficientRecord& c : record.coefficients) {
    if (c.cycles.empty()) continue;
    out += first ? "\n    " : ",\n    ";
    first = false;
    Object o(out, "{", ", ");
    o.number("mu", c.mu);
    o.word("result", cycle_word(c.cycles.back().result));
    o.word("text", cycle_text(c, s).c_str());
    if (!c.other_start.empty()) append_other_start(o.key("frictionless"), c);
    o.key("cycles") += '[';
    for (size_t i = 0; i < c.cycles.size(); ++i) append_cycle(out += i > 0 ? ",\n      " : "\n      ", c.cycles[i]);
    out += "]}";
  }
  out += ']';
}

} // namespace app
