#include "model/symmetry.hpp"

namespace c2d {

int32_t lines_along(const Model& m, int b, int32_t element) {
  int32_t lines = m.head->symmetry;
  for (int k = 0; k < body_of(m, b).element_nodes && lines != 0; ++k) {
    const double* p = m.xy[b] + 2 * geometry_node(m, b, element, k);
    lines &= lines_through(*m.head, p[0], p[1]);
  }
  return lines;
}

int32_t lines_at_corner(const Model& m, int b, int32_t node) {
  const int32_t corner = corner_point(m, b, node);
  if (corner < 0) return 0; // inside an element: not on a line, or on an axis element
  return lines_through(*m.head, m.xy[b][2 * corner], m.xy[b][2 * corner + 1]);
}

bool is_held_by_lines(const Model& m, int b, int32_t node, int component) {
  if ((lines_at_corner(m, b, node) >> component & 1) != 0) return true;
  int32_t ends[2];
  return twin_node(m, b, node) < 0 && ends_at_node(m, b, node, ends) == 0;
}

void fold_across(const ModelHeader& head, double p[2]) {
  for (int c = 0; c < 2; ++c) {
    if ((head.symmetry >> c & 1) == 0) continue;
    if (head.line_side[c] * (p[c] - head.line_at[c]) < 0.0) p[c] = 2.0 * head.line_at[c] - p[c];
  }
}

} // namespace c2d
