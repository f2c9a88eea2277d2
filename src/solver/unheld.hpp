#pragma once
// What moves freely, by name (METHOD 7.3). Optional, with the warnings (memory/parts.hpp).
#include "solver/solver.hpp"

namespace c2d {

// Tells the motions that no support, tie or pair prevents, before anything is assembled: of each body those that it makes
// alone, then bodies that move together. `prevented`: orthonormal rows of head->motions numbers, `rank` of them: what the pairs
// prevent of the motions of bodies in contact; null: that is not known. One motion of one body is left to the outcome, which
// names it.
void tell_unheld(c2d_solver* solver, const double* prevented, int32_t rank);

} // namespace c2d
