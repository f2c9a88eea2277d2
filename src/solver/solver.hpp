#pragma once
// The solver's header in the workspace, and what every call of the C interface does on entry and exit.
#include "contact2d.h"
#include "model/model.hpp"

namespace c2d {
// Forget the model and every result; state: empty. For the deck reader and failed model calls.
void clear_model(c2d_solver* solver);
// Tell a fault, warning or note: through c2d_port.log, and keep the first fault for c2d_last_error.
void report_fault(c2d_solver* solver, const c2d_error& entry);
} // namespace c2d
