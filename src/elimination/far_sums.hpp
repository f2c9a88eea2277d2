#pragma once
// What all elements of a large body do at its own nodes, where no more than their sum is asked for: prescribed values in the
// right-hand sides, and rigid motions in the diagonal. Element by element that grows like the square of the nodes; by cells of
// elements (elimination/far_cells.hpp), each of which stands for all of its own far away, like n log n (METHOD 7.6).
#include "bie/columns.hpp"
#include "elimination/far_cells.hpp"

namespace c2d {

inline bool has_sums_by_cells(const ColumnSystem& s) {
  return s.quadrature == Quadrature::accurate && may_have_far_cells(s.model.body[s.body].elements);
}
// Of straight elements it is known in closed form (bie/diagonal.hpp).
inline bool has_diagonal_by_cells(const ColumnSystem& s) {
  return has_sums_by_cells(s) && (s.model.body[s.body].element_nodes != 2 || s.batch == nullptr);
}

// What they work in, for no more elements and load cases.
uint64_t far_sums_bytes(int32_t elements, int32_t loads);
// As fill_columns() for all right-hand sides: right[i + k * ld].
void fill_right_by_cells(const ColumnSystem& system, Real* right, int64_t ld, void* work);
// As fill_diagonal() for all nodes.
void fill_diagonal_by_cells(const ColumnSystem& system, void* work);

} // namespace c2d
