#pragma once
// Sums over all elements of a large body at its own nodes, where only the sum is needed: prescribed values in the right-hand
// sides, and rigid-body modes in the diagonal. Element by element the cost grows like n^2; with clusters of elements
// (elimination/far_cells.hpp) that act through series at a distance it grows like n log n (METHOD 7.6).
#include "bie/columns.hpp"
#include "elimination/far_cells.hpp"

namespace c2d {

inline bool has_sums_by_cells(const ColumnSystem& s) {
  return s.quadrature == Quadrature::accurate && may_have_far_cells(s.model.body[s.body].elements);
}
// For straight elements the diagonal has a closed form (bie/diagonal.hpp).
inline bool has_diagonal_by_cells(const ColumnSystem& s) {
  return has_sums_by_cells(s) && (s.model.body[s.body].element_nodes != 2 || s.batch == nullptr);
}

// Bytes of the work area, for at most so many elements and load cases.
uint64_t far_sums_bytes(int32_t elements, int32_t loads);
// As fill_columns() for all right-hand sides: right[i + k * ld].
void fill_right_by_cells(const ColumnSystem& system, Real* right, int64_t ld, void* work);
// As fill_diagonal() for all nodes.
void fill_diagonal_by_cells(const ColumnSystem& system, void* work);

} // namespace c2d
