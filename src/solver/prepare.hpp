#pragma once
// Assemble, eliminate, reduce.
#include "solver/solver.hpp"

namespace c2d {

// The model in state `model` becomes `prepared`; where only loads have changed and factors are kept, they go through those.
// Errors are recorded and returned; a store error breaks the solver.
c2d_status prepare(c2d_solver* solver);
// Tells how much the condition of the equations costs, if that is much.
void warn_condition(c2d_solver* solver);

} // namespace c2d
