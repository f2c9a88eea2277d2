#pragma once
// Assemble, eliminate, reduce.
#include "solver/solver.hpp"

namespace c2d {

// The model in state `model` becomes `prepared`; where only loads have changed and factors are kept, they go through those.
// Errors are recorded and returned; a store error breaks the solver.
c2d_status prepare(c2d_solver* solver);

} // namespace c2d
