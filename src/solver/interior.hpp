#pragma once
// Stress at element ends, for c2d_get. The boundary results must be current.
#include "solver/session.hpp"

namespace c2d {

// field: C2D_END_SXX ... C2D_END_HOOP; body and end = element * function_nodes + local from 0.
double end_stress(const Session& session, int32_t field, int b, int32_t end);

} // namespace c2d
