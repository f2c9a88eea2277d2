#include "report/json/json_torsion.hpp"

#include "report/json/json_object.hpp"

namespace app {
namespace {

template <class Values> void append_numbers(Object& o, const char* name, const Values& values) {
  std::string& out = o.key(name);
  out += '[';
  bool is_first = true;
  for (const double value : values) {
    if (!is_first) out += ", ";
    is_first = false;
    if (std::isfinite(value))
      append_number(out, value);
    else
      out += "null";
  }
  out += ']';
}

template <class List, class Append> void append_objects(Object& o, const char* name, const List& list, const Append& append) {
  std::string& out = o.key(name);
  out += '[';
  for (size_t i = 0; i < list.size(); ++i) {
    out += i > 0 ? ",\n      " : "\n      ";
    Object item(out, "{", ", ");
    append(item, list[i]);
    out += '}';
  }
  out += ']';
}

} // namespace

void append_json_torsion(std::string& out, const TorsionTable& table) {
  Object o(out, "{", ",\n    ");
  if (!table.why.empty()) {
    o.word("why", table.why.c_str());
    out += '}';
    return;
  }
  append_objects(o, "turned", table.parts, [](Object& item, const TorsionPart& p) {
    item.word("name", p.name.c_str()), item.integer("body", p.body), item.word("given", p.is_loaded ? "traction" : "angle");
  });
  append_objects(o, "interfaces", table.contacts, [](Object& item, const TorsionContact& c) {
    item.word("name", c.name.c_str());
    item.number("turns_through", c.turns_through), item.number("slip_starts", c.start);
    append_numbers(item, "slip_starts_at", c.start_at);
    item.number("all_slip", c.through);
  });
  append_objects(o, "steps", table.steps, [](Object& item, const TorsionStep& s) {
    append_numbers(item, "loads", s.loads), append_numbers(item, "angle", s.angle), append_numbers(item, "torque", s.torque);
    append_numbers(item, "carried", s.carried), append_numbers(item, "slipping", s.slipping);
  });
  append_objects(o, "borders", table.borders, [](Object& item, const TorsionBorder& b) {
    item.integer("interface", b.contact), append_numbers(item, "at", b.at);
  });
  if (!table.ended.empty()) o.word("ended", table.ended.c_str());
  o.number("residual", table.residual);
  o.number("imbalance", table.imbalance);
  out += '}';
}

} // namespace app
