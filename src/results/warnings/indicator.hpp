#pragma once
// Discretisation error indicators of elements (METHOD 16.6), for hosts that refine their mesh.
#include "solver/session.hpp"

namespace c2d {

// Rows of elements first ... first + count - 1 of body b, from 0: column C2D_OFF_... of the i-th at out[i * stride + column].
// Back substitution included. Errors are recorded: STORE_..., CANCELLED.
c2d_status fill_indicators(Session& session, int b, int32_t first, int32_t count, double* out, int64_t stride);

} // namespace c2d
