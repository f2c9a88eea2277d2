#pragma once
// Body forces at interior points, at the load reached: the boundary integrals are those of u - u_p and t - t_p; u_p and
// sigma_p are known at every point. Optional, for bodies with body forces (memory/parts.hpp).
#include "solver/session.hpp"

namespace c2d {

// u_p at a local functional node of an element, and t_p.
void particular_at_end(const Session& session, int b, int32_t element, int l, double u[2], double t[2]);
// u_p on an element as the shape functions have it.
void interpolated_particular(const Session& session, int b, int32_t element, double eta, double u[2]);
// Adds u_p at a point, in the length unit, and sigma_p there: trace, deviator, minus shear, over 2 G.
void add_particular_at(const Session& session, int b, const double at[2], double u[2], double stress[3]);

} // namespace c2d
