#include "report/json/json.hpp"

#include "report/json/json_object.hpp"

#include <cmath>

namespace app {
namespace {

void append_influence(std::string& out, const ToleranceTable& table, const Toleranced& t, size_t parameter) {
  Object o(out, "{", ", ");
  o.word("parameter", table.parameters[parameter].name.c_str());
  o.number("derivative", t.by[parameter].derivative);
  o.number("share", table.share(t, parameter));
  if (!t.by[parameter].why.empty()) o.word("why", t.by[parameter].why.c_str());
  out += '}';
}

void append_json_toleranced(std::string& out, const ToleranceTable& table, const Toleranced& t) {
  const Stated& s = t.number;
  Object o(out, "{", ", ");
  o.word("name", s.name().c_str());
  if (s.zone > 0) o.integer("zone", s.zone);
  if (s.body > 0) o.integer("body", s.body);
  if (s.item > 0) o.integer("item", s.item);
  o.number("value", shown_value(s.what, s.value, s.along));
  o.number("worst_case", table.worst_case(t));
  o.number("root_of_squares", table.root_of_squares(t));
  if (std::isfinite(s.at[0])) {
    o.number("x", s.at[0]);
    o.number("y", s.at[1]);
  }
  o.key("by") += '[';
  for (size_t p = 0; p < t.by.size(); ++p) {
    if (p > 0) out += ", ";
    append_influence(out, table, t, p);
  }
  out += "]}";
}

void append_json_parameter(std::string& out, const ToleranceOf& p) {
  Object o(out, "{", ", ");
  o.word("name", p.name.c_str());
  o.number("value", p.value);
  o.number("tolerance", p.size);
  if (!p.why.empty()) o.word("why", p.why.c_str());
  out += '}';
}

} // namespace

void append_tolerances(std::string& out, const ToleranceTable& table) {
  Object o(out, "{", ", ");
  o.key("parameters") += '[';
  for (size_t p = 0; p < table.parameters.size(); ++p) {
    out += p == 0 ? "\n    " : ",\n    ";
    append_json_parameter(out, table.parameters[p]);
  }
  out += ']';
  o.key("numbers") += '[';
  for (size_t i = 0; i < table.numbers.size(); ++i) {
    out += i == 0 ? "\n    " : ",\n    ";
    append_json_toleranced(out, table, table.numbers[i]);
  }
  out += ']';
  o.word("stopped", table.why.c_str());
  out += '}';
}

} // namespace app
