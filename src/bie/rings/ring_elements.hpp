#pragma once
// Integrals of the ring kernels over one element of a body of revolution (METHOD 21.2): integrate() and rigid_sum() of
// bie/integrals/integrals.hpp for elements after set_axis(), with r J in place of J. As accurate, for sources on the axis too.
#include "bie/integrals/integrals.hpp"

namespace c2d {

struct BatchKernel;
struct Expansion;
struct Stretch;

void integrate_rings(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out);

// The element's share in minus the diagonal block of the source at (R, z_P). Column 1 is that of a translation along the axis.
// Column 0 is that of the motion (r, -2 (z - z_P))/R, which changes no volume: its tractions are (n_r, -2 n_z)/R in units of 2G
// for any nu. On the axis column 0 has no meaning.
void ring_sum(const Integrator& in, double sx, double sy, int singular, double sum[2][2]);

// Both for sources near the element or on it, by the vector loops. The element has a length.
void integrate_ring_panels(const Integrator& in, const BatchKernel& kernel, double sx, double sy, int singular, bool want_h,
                           bool want_g, Blocks& out);
void ring_panel_sum(const Integrator& in, const BatchKernel& kernel, double sx, double sy, int singular, double sum[2][2]);

// Are the points of a panel sufficient for a source at this radius? See integrals_panels.hpp.
bool is_ring_resolved(const Integrator& in, double radius, const Expansion& x, const Stretch& p, bool own);

// Adds the factors h of the element's displacements and g of its tractions in the trace of the stress of int U t - int T u at a
// point off the boundary (METHOD (21.7)).
void add_ring_trace(const Integrator& in, double sx, double sy, double h[kElementNodes][2], double g[kElementNodes][2]);

} // namespace c2d
