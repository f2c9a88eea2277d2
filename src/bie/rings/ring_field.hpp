#pragma once
// Displacement and stress inside a body of revolution: add_field() of bie/integrals/interior.hpp for elements after set_axis().
// Vectors are r + i z, the trace and the deviator those of the section. `reference` is the displacement at the point of the
// motion reference.im e_z + reference.re (r, -2 (z - z_P))/r_P, which changes no volume (METHOD 21.3); on the axis reference.re
// is 0.
#include "bie/integrals/interior.hpp"

namespace c2d {

// u[i][j]: displacement along i at a point of the force j (in 2G times the length unit squared, per unit of the angle) of the
// ring through `from`, on the axis of a point.
void ring_force(double nu, const double from[2], const double at[2], double u[2][2]);
// The field of such a force; zero at its own place.
void add_ring_force(const double force[2], double nu, const double from[2], const double at[2], PointField& sum);

void add_ring_field(const FieldElement& e, const Complex& reference, double x, double y, PointField& sum);

} // namespace c2d
