#include "model/validate_finding.hpp"

#include <string.h>

namespace c2d {

Finding::Finding() {
  memset(&entry, 0, sizeof entry);
  entry.struct_size = static_cast<uint32_t>(sizeof entry);
  entry.severity = C2D_FAULT;
  entry.status = C2D_ERR_INPUT;
  text = text_in(entry.text);
}

Finding::Finding(int32_t number) : Finding() {
  entry.severity = C2D_WARNING;
  entry.status = number;
}

namespace {
void set_line(Finding& finding, int32_t line) {
  if (line > 0 && finding.entry.line == 0) finding.entry.line = line;
}
} // namespace

void locate_point(Finding& finding, const Model& m, int b, int32_t geometry_point) {
  finding.entry.body = b + 1;
  finding.entry.node = geometry_point + 1;
  set_line(finding, m.node_line[b][geometry_point]);
}

void locate_element(Finding& finding, const Model& m, int b, int32_t element) {
  finding.entry.body = b + 1;
  finding.entry.element = element + 1;
  set_line(finding, m.node_line[b][geometry_node(m, b, element, 0)]);
}

void locate_node(Finding& finding, const Model& m, int b, int32_t node) {
  finding.entry.body = b + 1;
  finding.entry.node = node + 1;
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  for (int i = 0; i < count; ++i) { // the first end that a card names, else the first
    const bool better = (m.end_code[b][ends[i]] & kGiven) != 0 && finding.entry.line == 0;
    if (i == 0 || better) finding.entry.element = ends[i] / m.head->function_nodes + 1;
    if (better) set_line(finding, m.end_line[b][ends[i]]);
  }
}

void locate_zone(Finding& finding, const Model& m, int32_t zone) {
  finding.entry.zone = zone + 1;
  set_line(finding, m.zone[zone].line);
}

void locate_pair(Finding& finding, const Model& m, int32_t pair) {
  finding.entry.pair = pair + 1;
  locate_zone(finding, m, m.pair[pair].zone);
}

void tell(Reporter& reporter, const Finding& finding) {
  if (finding.entry.severity == C2D_FAULT) ++reporter.faults;
  if (reporter.tell != nullptr) reporter.tell(reporter.context, finding.entry);
}

} // namespace c2d
