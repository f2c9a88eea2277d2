#pragma once
// A binary tree over the elements of a body, as they follow each other along its contour, for points inside (METHOD 16.7,
// results/interior_cells.hpp). It lies in the work of back substitution when that is done.
#include "bie/far_field.hpp"
#include "elimination/cells.hpp"
#include "solver/solver.hpp"

namespace c2d {

constexpr int32_t kCellElements = kHostile ? 3 : 40, kLeastElements = kHostile ? 12 : 400; // of a leaf; of a body with a tree

// Elements that follow each other. What a uniform displacement of theirs does depends on the ends alone; whole regions of the
// contour have none, so that there are two chains at most, but where lines of symmetry cut off many.
struct FarCell {
  FarField field;
  Chain chain[2];
  int64_t chains; // 3: more than have room; such a cell is near to all points
};

// All of them from the root on, depth by depth.
struct FarCells {
  Complex* rest; // a displacement that is taken off all others
  FarCell* cell;
  int32_t elements, depth;
  FarCell& at(int32_t d, int32_t i) const { return cell[(int64_t{1} << d) - 1 + i]; }
};

inline bool may_have_far_cells(int32_t elements) { return elements >= kLeastElements; }
inline uint64_t far_cells_bytes(int32_t elements) {
  if (!may_have_far_cells(elements)) return 0;
  return sizeof(Complex) + ((uint64_t{2} << tree_depth(elements, kCellElements)) - 1) * sizeof(FarCell);
}
inline FarCells far_cells_in(void* memory, int32_t elements) {
  char* const from = static_cast<char*>(memory);
  return FarCells{reinterpret_cast<Complex*>(from), reinterpret_cast<FarCell*>(from + sizeof(Complex)), elements,
                  tree_depth(elements, kCellElements)};
}
// Body (from 1) whose cells are there, 0: none.
inline int32_t far_cells_of(const c2d_solver* s) { return s->back_substituted > 1 ? s->back_substituted - 1 : 0; }

} // namespace c2d
