// Construction of faults and warnings. A finding fills c2d_error in place: numbers from 1 and the line of the caller's input
// come from its location, the text is appended part by part, without memory allocation.
#include "model/validate/validate_finding.hpp"

#include <string.h>

namespace c2d {

Finding::Finding(int32_t number, const Where& where) {
  memset(&entry, 0, sizeof entry);
  entry.struct_size = static_cast<uint32_t>(sizeof entry);
  entry.severity = number == 0 ? C2D_FAULT : C2D_WARNING;
  entry.status = number == 0 ? int32_t{C2D_ERR_INPUT} : number;
  entry.line = where.line > 0 ? where.line : 0;
  entry.body = where.body;
  entry.zone = where.zone;
  entry.pair = where.pair;
  entry.element = where.element;
  entry.node = where.node;
  text = text_in(entry.text);
}
Finding::Finding(const Where& where) : Finding(0, where) {}

Text& put_body(Text& text, const char* characters, const Model& m, int b) {
  return put_with_name(text, characters, b + 1, m.body[b].name);
}
Text& put_zone(Text& text, const char* characters, const Model& m, int32_t zone) {
  return put_with_name(text, characters, zone + 1, m.zone[zone].name);
}

Where at_point(const Model& m, int b, int32_t geometry_point) {
  return {m.node_line[b][geometry_point], b + 1, 0, 0, 0, geometry_point + 1};
}

Where at_element(const Model& m, int b, int32_t element) {
  return {m.node_line[b][geometry_node(m, b, element, 0)], b + 1, 0, 0, element + 1, 0};
}

Where at_node(const Model& m, int b, int32_t node) {
  Where out = {0, b + 1, 0, 0, 0, node + 1};
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  for (int i = 0; i < count; ++i) { // the first end with a condition card, whose line is known; else the first end
    const bool better = (m.end_code[b][ends[i]] & kGiven) != 0 && out.line == 0;
    if (i == 0 || better) out.element = ends[i] / m.head->function_nodes + 1;
    if (better && m.end_line[b][ends[i]] > 0) out.line = m.end_line[b][ends[i]];
  }
  return out;
}

Where in_zone(const Model& m, int32_t zone) { return {m.zone[zone].line, 0, zone + 1, 0, 0, 0}; }

Where in_zone(const Model& m, int32_t zone, int b, int32_t element) {
  Where out = at_element(m, b, element);
  out.zone = zone + 1;
  if (m.zone[zone].line > 0) out.line = m.zone[zone].line;
  return out;
}

Where at_pair(const Model& m, int32_t pair) {
  Where out = in_zone(m, m.pair[pair].zone);
  out.pair = pair + 1;
  return out;
}

ZoneFinding::ZoneFinding(const Model& m, int32_t zone) : Finding(in_zone(m, zone)) { say(*this, "zone ", zone_named(m, zone)); }
ZoneFinding::ZoneFinding(int32_t number, const Model& m, int32_t zone, int32_t pair) : Finding(number, at_pair(m, pair)) {
  say(*this, "zone ", zone_named(m, zone));
}

void report(Reporter& reporter, const Finding& finding) {
  if (finding.entry.severity == C2D_FAULT) ++reporter.faults;
  reporter.tell(reporter.context, finding.entry);
}

} // namespace c2d
