// Blocks of a body's equations, by lists of rows and columns.
#include "elimination/compressed_work.hpp"
#include "model/symmetry.hpp"

namespace c2d {

int32_t list_sources(Compression& t, const int32_t* ids, int32_t count, int32_t* sources) {
  int32_t listed = 0;
  for (int32_t i = 0; i < count; ++i) {
    const int32_t node = ids[i] / 2;
    if (t.w.position[node] >= 0) continue;
    t.w.position[node] = listed;
    sources[listed++] = node;
  }
  return listed;
}

void forget_sources(Compression& t, const int32_t* sources, int32_t count) {
  for (int32_t s = 0; s < count; ++s) t.w.position[sources[s]] = -1;
}

int32_t list_elements(Compression& t, const int32_t* nodes, int32_t count, int32_t* elements) {
  const Model& m = t.system.model;
  int32_t listed = 0;
  ++t.tick;
  for (int32_t i = 0; i < count; ++i) {
    int32_t ends[2];
    const int found = ends_at_node(m, t.system.body, nodes[i], ends);
    for (int k = 0; k < found; ++k) {
      const int32_t element = ends[k] / m.head->function_nodes;
      if (t.w.stamp[element] == t.tick) continue;
      t.w.stamp[element] = t.tick;
      elements[listed++] = element;
    }
  }
  return listed;
}

void fill_block(Compression& t, const int32_t* rows, int32_t row_count, const int32_t* columns, int32_t column_count,
                int64_t* ld, int32_t* sources) {
  CompressedWork& w = t.w;
  *sources = list_sources(t, rows, row_count, w.sources);
  *ld = 2 * static_cast<int64_t>(*sources);
  for (int32_t j = 0; j < column_count; ++j) {
    w.place[column_of(t, columns[j])] = j;
    w.list[j] = columns[j] / 2;
  }
  const int32_t elements = list_elements(t, w.list, column_count, w.elements);
  const ColumnSystem chosen = choose_nodes(t.system, w.sources, *sources, w.point, w.twin);
  fill_chosen(chosen, ChosenColumns{w.place, column_count, w.elements, elements}, w.block, *ld);
  for (int32_t j = 0; j < column_count; ++j) w.place[column_of(t, columns[j])] = -1;
}

bool has_integrals(const Compression& t, int32_t node, int component) {
  return t.system.twin[node] >= kSingle && !is_held_by_symmetry(t.system.model, t.system.body, node, component);
}

} // namespace c2d
