#pragma once
// What the calls of the path share.
#include "interface/entry.hpp"
#include "results/warnings/warnings.hpp"

namespace c2d {

// What a call of the path returns: store errors break the solver, a cancel leaves it valid where it is.
c2d_status finish(Session& session, c2d_status status);
c2d_status begin(Session& session);
// Warns about the contact where it arrives.
c2d_status advance(Session& session, const double* target, Moment moment);

} // namespace c2d
