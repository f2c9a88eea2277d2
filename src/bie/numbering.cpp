// Columns of the outer unknowns: node by node along the contour, two for each node outside the contact. Consecutive columns
// then belong to neighbouring elements, so a panel of the elimination integrates few elements.
#include "bie/columns.hpp"

namespace c2d {

void number_unknowns(const Model& m, int b) {
  Body& body = m.body[b];
  int32_t column = 0;
  for (int32_t node = 0; node < body.nodes; ++node) {
    m.node_column[b][node] = column;
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c)
      if (unknown[c].kind != UnknownKind::contact) ++column;
  }
  m.node_column[b][body.nodes] = column;
  body.columns = column;
}

int32_t outer_column(const Model& m, int b, int32_t node, int component) {
  const int32_t first = m.node_column[b][node], columns = m.node_column[b][node + 1] - first;
  // A node with one outer unknown has the other component in contact.
  if (columns == 2) return first + component;
  return columns == 0 || unknown_at(m, b, node, component).kind == UnknownKind::contact ? -1 : first;
}

} // namespace c2d
