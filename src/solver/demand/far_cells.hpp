#pragma once
// The cells of a body for points inside (METHOD 16.7, results/interior/interior_cells.hpp). They lie in the work of back
// substitution when that is done.
#include "elimination/far_cells.hpp"
#include "solver/solver.hpp"

namespace c2d {

// Body (from 1) whose cells are there, 0: none.
inline int32_t far_cells_of(const c2d_solver* s) { return s->back_substituted > 1 ? s->back_substituted - 1 : 0; }

} // namespace c2d
