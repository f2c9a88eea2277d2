// Blocks of a body's matrix by lists of rows and columns: entries are integrated on demand, and the whole matrix never exists.
// Each node is one source and each element is integrated once per block, however many of the listed rows and columns belong to
// it (METHOD 7.6).
#include "elimination/compressed_work.hpp"
#include "model/symmetry.hpp"

namespace c2d {

// Two equations of a node share their integrals, so the list has nodes.
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

void clear_sources(Compression& t, const int32_t* sources, int32_t count) {
  for (int32_t s = 0; s < count; ++s) t.w.position[sources[s]] = -1;
}

// Stamps instead of a cleared array: a block costs as much as its own size, not as the body's.
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
  // `place` is as long as the body has columns: only the entries that were set are cleared.
  for (int32_t j = 0; j < column_count; ++j) w.place[column_of(t, columns[j])] = -1;
}

// Not for the second of two nodes at one place, nor where symmetry gives u = 0 in place of the equation.
bool has_integrals(const Compression& t, int32_t node, int component) {
  return t.system.twin[node] >= kSingle && !is_held_by_symmetry(t.system.model, t.system.body, node, component);
}

} // namespace c2d
