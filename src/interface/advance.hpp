#pragma once
// Shared by the calls of the load path.
#include "interface/entry.hpp"
#include "results/warnings/warnings.hpp"

namespace c2d {

// Status of a path call: store errors break the solver, a cancel leaves it valid at the load reached.
c2d_status finish(Session& session, c2d_status status);
c2d_status begin(Session& session);
// Advances and checks the contact for warnings.
c2d_status advance(Session& session, const double* target, Moment moment);

} // namespace c2d
