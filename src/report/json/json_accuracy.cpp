#include "report/json/json.hpp"

#include "report/json/json_object.hpp"

#include <cmath>

namespace app {
namespace {

void append_json_rounds(std::string& out, const MeshLoop& loop) {
  out += '[';
  for (size_t i = 0; i < loop.rounds.size(); ++i) {
    const MeshRound& round = loop.rounds[i];
    out += i == 0 ? "\n    " : ",\n    ";
    Object o(out, "{", ", ");
    o.integer("elements", round.elements);
    o.integer("pairs", round.pairs);
    o.integer("equations", round.equations);
    o.number("seconds", round.seconds);
    if (std::isfinite(round.pressure)) o.number("tractions_change", round.pressure);
    if (std::isfinite(round.energy)) o.number("energy_change", round.energy);
    o.key("taken") += i == loop.taken ? "true" : "false";
    out += '}';
  }
  out += ']';
}

void append_stated(std::string& out, const Stated& s) {
  Object o(out, "{", ", ");
  o.word("name", s.name().c_str());
  if (s.zone > 0) o.integer("zone", s.zone);
  if (s.body > 0) o.integer("body", s.body);
  if (s.item > 0) o.integer("item", s.item);
  if (s.has_value()) o.number("value", s.value);
  if (s.has_value()) o.number("error", s.error);
  o.number("relative_error", s.relative_error());
  if (!std::isnan(s.tolerance)) {
    o.number("tolerance", s.tolerance);
    o.key("met") += s.is_met() ? "true" : "false";
  }
  if (s.is_unbounded()) o.key("unbounded") += "true";
  if (std::isfinite(s.at[0])) {
    o.number("x", s.at[0]);
    o.number("y", s.at[1]);
  }
  if (std::isfinite(s.along)) o.number("along", s.along);
  if (std::isfinite(s.angle)) o.number("plane_angle", s.angle);
  out += '}';
}

} // namespace

void append_accuracy(std::string& out, const MeshLoop& loop) {
  Object o(out, "{", ", ");
  append_json_rounds(o.key("rounds"), loop);
  o.key("stated") += '[';
  for (size_t i = 0; i < loop.stated.size(); ++i) {
    out += i == 0 ? "\n    " : ",\n    ";
    append_stated(out, loop.stated[i]);
  }
  out += ']';
  o.word("stopped", loop.stopped.c_str());
  if (loop.positions > 0) o.number("positions", loop.positions);
  out += '}';
}

} // namespace app
