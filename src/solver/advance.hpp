#pragma once
// What the calls of the path share.
#include "solver/session.hpp"

namespace c2d {

constexpr uint32_t kStarted = state_bit(C2D_STATE_PREPARED) | state_bit(C2D_STATE_RUNNING);

// What a call of the path returns: store errors break the solver, a cancel leaves it valid where it is.
c2d_status finish(Session& session, c2d_status status);
c2d_status begin(Session& session);
// Warns about the contact where it arrives.
c2d_status advance(Session& session, const double* target, Moment moment);

} // namespace c2d
