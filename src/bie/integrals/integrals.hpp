#pragma once
// Element integrals of the plane-strain Kelvin kernels, METHOD (2.2), (2.3) and 3:
//   U_ij = k [ (3-4 nu) ln(1/r) d_ij + r,i r,j ]                                          (times 2G)
//   T_ij = -(k/r) { dr/dn [ (1-2 nu) d_ij + 2 r,i r,j ] - (1-2 nu)( r,i n_j - r,j n_i ) }
// with k = 1/(4 pi (1-nu)), i = direction of the unit load at the source, j = component at the field point,
// r,i = (x_i - source_i)/r, n = outward normal.

#include "memory/config.hpp"
#include "model/element.hpp"

namespace c2d {

// The accuracy is relative to the largest entry of h or g. Where h nearly vanishes (nu = 0.5 and a source on the line of a
// straight element) it is relative to element length over distance. The rounding of the coordinates is additional.
enum class Quadrature {
  accurate, // error below 1e-12 of the largest entry of the block, at any distance
  thesis    // 2, 4 or 10 Gauss points by distance, logarithmic formula at the source's own node
};

// [l][i][j], l = 0..functions-1 (other entries are not written):
//   h = int T_ij M_l J deta, g = int U_ij M_l J deta.
struct Blocks {
  double h[kElementNodes][2][2];
  double g[kElementNodes][2][2];
};

// The measure of a body of revolution: `turn` is 2 pi times the unit of length, 0 for plane bodies, `middle` is r at eta = 0 of
// the element along which g is measured. A build without rings has no room for it.
template <bool rings> struct AxisMeasure { double turn, middle; };
template <> struct AxisMeasure<false> { static constexpr double turn = 0.0, middle = 0.0; };

// All quantities of an element that do not depend on the source; filled by prepare() and set_arc(), only read afterwards. No
// pointers: may be copied.
struct Integrator : AxisMeasure<kRings> {
  Element element;
  int functions;
  Quadrature mode;
  double k, kappa, t1, t2; // 1/(4 pi (1-nu)), 3-4nu, 1-2nu, 2-2nu
  // chord: half-vector over its squared length, squared half length and its logarithm, doubled angle
  double ux, uy, chord2, log_half, cos2, sin2;
  double radius;      // of a circle about the chord's middle that contains the element
  bool degenerate;    // zero length: all integrals are 0
  bool closed_form_g; // straight, and J for g is constant
  double g_jacobian;  // that constant
  double d[3][2];     // J for g = |d0 + d1 eta + d2 eta^2|
  double reach2[10];  // squared distance from c[0] beyond which the i-th Gauss rule is sufficient
  double semi_axis;   // of the ellipse a panel of the near rule needs
};

inline bool is_ring(const Integrator& in) { return kRings && in.turn != 0.0; }

// Element e with `functions` (1..4) functional nodes, effective plane-strain nu in (-1, 0.5].
void prepare(Integrator& in, const Element& e, int functions, double nu, Quadrature mode);

// Measures g (and resultants) per length of another element: J becomes that of `arc` at the matching point, eta or -eta if
// `reversed`. Positions, and the numbering of local nodes, stay those of the element. Call after prepare().
void set_arc(Integrator& in, const Element& arc, bool reversed);

// The element is that of a body of revolution about x = 0 (METHOD 21): kernels of rings and the measure r J; resultants have
// the measure 2 pi r J, r in the caller's `unit` of length. Call between prepare() and set_arc().
void set_axis(Integrator& in, double unit);

// One quadrature point: shape functions, x - source, outward normal times the element's own Jacobian, J for g.
struct Sample {
  double eta, shape[kElementNodes];
  double rx, ry, nx, ny, jacobian;
};

// The points of the rules for sources that are not near, found when the first source needs them: only x - source depends on
// it. For one element and many sources. Small code finds the points anew for every source.
template <bool small> struct RuleSamples {
  static constexpr int kRules = 12, kPoints = 118;
  bool known[kRules] = {};
  Sample at[kPoints]; // rx, ry: from the middle of the element
  double weight[kPoints];
};
template <> struct RuleSamples<true> {};
using Samples = RuleSamples<kSmallCode>;

// Blocks of the source point (sx,sy). `singular`: local functional node with which the source coincides, -1 if none. Its own h
// is set to zero (free term and principal value follow from rigid translation), its g is complete. A source on the element but
// not on one of its functional nodes is not allowed (the result is finite, but meaningless). Blocks not wanted are not
// written.
void integrate(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out,
               Samples* samples = nullptr);

// sum[i][j] = sum over l != singular of h[l][i][j].
void rigid_sum(const Integrator& in, double sx, double sy, int singular, double sum[2][2]);

// w[l] = int M_l J deta, wx[l] = int M_l (x-ox) J deta, wy[l] = int M_l (y-oy) J deta; J as for g. To
// round-off in either mode (exact where the integrand is a polynomial).
void resultants(const Integrator& in, double ox, double oy, double w[kElementNodes], double wx[kElementNodes],
                double wy[kElementNodes]);
// w[l] = int M_l f J deta with a field f of at most the third degree, in the same measure; exact for straight elements.
using PlaneField = void (*)(const void* context, double x, double y, double f[2]);
void weigh(const Integrator& in, PlaneField field, const void* context, double w[kElementNodes][2]);

} // namespace c2d
