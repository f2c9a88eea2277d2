#pragma once
// Displacement and stress inside a body, thesis (3.32) to (3.34), METHOD 16.3: the share of one element at a point P off the
// boundary,
//   u(P) = int U t - int T u,   sigma(P) = int D t - int S u.
// Plane vectors are complex numbers, rho = field point minus P, n = outward normal; then with k = 1/(4 pi (1-nu))
//   U t = k [ -kappa ln|rho| t + (t + conj(t rho*/rho))/2 ]
//  -T u = (k/2) [ kappa n u/rho + 2 (n.u)/rho* + conj(n u rho*/rho^2) ]
// and for the trace sxx + syy and the deviator sxx - syy - 2i sxy
//   D t: 2k Re(t/rho),      k [ kappa t*/rho + t rho*/rho^2 ]
//  -S u: 2k Re(n u/rho^2),  2k [ (n.u)/rho^2 + n u rho*/rho^3 ].
// Lengths and displacements in one unit, tractions and stresses in 2G.
#include "bie/integrals/complex.hpp"
#include "bie/integrals/integrals.hpp"

namespace c2d {

// Stress round the axis of bodies of revolution. A build without rings has no room for it.
template <bool rings> struct RoundStress { double round; };
template <> struct RoundStress<false> { static constexpr double round = 0.0; };
inline void add_round(RoundStress<true>& sum, double stress) { sum.round += stress; }
inline void add_round(RoundStress<false>&, double) {}

struct PointField : RoundStress<kRings> {
  Complex u;
  double trace;     // sxx + syy, in the plane
  Complex deviator; // sxx - syy - 2i sxy
};

// An element with its nodal values: coefficients of powers of eta, in axes along the chord if closed_form.
struct FieldElement {
  Integrator in;
  bool closed_form;
  bool displaced; // has displacements: the reference is subtracted
  Complex axis;   // unit vector along those axes
  Complex t[kElementNodes], u[kElementNodes];
};

// Completes an element whose accurate Integrator `in` is ready. Displacements u[l], tractions t[l] at the functional nodes,
// the latter in the measure of `in`. Null: no displacements.
void prepare_field(const Complex t[kElementNodes], const Complex* u, FieldElement& out);

// Adds the element's share at (x, y), with `reference` subtracted from its displacements: over a closed boundary a translation
// has no stress and displaces the inside by itself. With the displacement of the nearest boundary point as reference nothing
// large cancels near the boundary. Error below 1e-10 of the largest term, at distances from 1e-9 of the element length on; the
// rounding of the coordinates is additional. Of bodies of revolution `reference` stands for a motion
// (bie/rings/ring_field.hpp).
void add_field(const FieldElement& element, Complex reference, double x, double y, PointField& sum);
void add_scaled(PointField& sum, double factor, const PointField& part);

// The field of a force (in 2G times the length unit) at (fx, fy); zero at its own point.
void add_force_field(Complex force, double nu, double fx, double fy, double x, double y, PointField& sum);

// The element's share in the winding number of the boundary about a point off it.
double winding(const Integrator& in, double x, double y);

} // namespace c2d
