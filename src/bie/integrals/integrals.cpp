// Integrals of the Kelvin kernels over one element, for one source point (METHOD 3):
//   h_l = int T_ij M_l J deta,   g_l = int U_ij M_l J deta,   METHOD (2.2) and (2.3).
// This file prepares an element once for all sources, and selects the rule:
// 1. Straight element, constant J: closed forms (integrals_straight.cpp).
// 2. Anything else: Gauss rules whose error bound is known beforehand (integrals_curved.cpp).
// 3. Quadrature::thesis: the rules of 1987 (integrals_thesis.cpp).
// Error bound: if the integrand is analytic in the Bernstein ellipse of parameter R about [-1, 1], the error of the n-point
// Gauss rule decreases like R^(-2n). So it suffices to know how far the nearest zero of x(eta) - source is. No adaptive
// refinement is needed, and no coordinate transformation as Telles's (Int. J. Numer. Meth. Eng. 24, 1987).
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course; Davis and Rabinowitz, Methods of Numerical
// Integration; Trefethen, SIAM Review 50 (2008).
#include "bie/integrals/integrals.hpp"

#include "bie/integrals/integrals_detail.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {

C2D_USES(RingPart);

namespace {

constexpr double kTolerance = 1e-13;
constexpr double kNever = 1e300; // a squared distance that no source has

double length(const double v[2]) { return sqrt(v[0] * v[0] + v[1] * v[1]); }

bool constant_jacobian(const Integrator& in) {
  return in.d[1][0] == 0.0 && in.d[1][1] == 0.0 && in.d[2][0] == 0.0 && in.d[2][1] == 0.0;
}

// Quantities of the chord that do not depend on the source. The circle about the middle contains the element by the triangle
// inequality on its polynomial coefficients.
void prepare_chord(Integrator& in) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double hx = 0.5 * (e.x[last] - e.x[0]), hy = 0.5 * (e.y[last] - e.y[0]);
  in.chord2 = hx * hx + hy * hy;
  in.radius = length(e.c[1]) + length(e.c[2]) + length(e.c[3]);
  in.degenerate = !(in.radius > 0.0);
  if (!kClosedForms || !(in.chord2 > 0.0)) return;
  in.ux = hx / in.chord2;
  in.uy = hy / in.chord2;
  in.cos2 = (hx * hx - hy * hy) / in.chord2;
  in.sin2 = 2.0 * hx * hy / in.chord2;
  in.log_half = 0.5 * log(in.chord2);
}

// The semi-axis of the ellipse in which the kernels must be analytic.
double rule_axis(const Integrator& in, int order, int degree) {
  const double semi = gauss_semi_axis(order, degree, kTolerance);
  if (!is_ring(in)) return semi;
  // The factor r of a ring counts as a degree there. In that ellipse it is at most 1 + growth times that of the middle: without
  // the degree a smaller one is sufficient.
  const double(&c)[kElementNodes][2] = in.element.c;
  const double growth = semi * (fabs(c[1][0]) + semi * (fabs(c[2][0]) + semi * fabs(c[3][0])));
  const double smaller = gauss_semi_axis(order, degree - 1, kTolerance * c[0][0] / (c[0][0] + growth));
  return smaller < semi ? smaller : semi;
}

// Distances beyond which each Gauss rule is sufficient. In a disc of radius R about the middle, which contains the Bernstein
// ellipse of semi-axis R, |x - x(0)| <= |c1| R + |c2| R^2 + |c3| R^3. A source farther from x(0) than that is no zero of x -
// source in the disc, so the kernels are analytic there. J must be analytic there too, because g contains it.
void prepare_reach(Integrator& in) {
  const double(&c)[kElementNodes][2] = in.element.c;
  // The shape function is a polynomial factor and uses up part of the rule's degree.
  const int degree = in.functions - 1 + (in.element.straight ? 0 : 1) + (is_ring(in) ? 1 : 0);
  const double c1 = length(c[1]), c2 = length(c[2]), c3 = length(c[3]);
  for (int i = 0; i < kFarOrderCount; ++i) {
    const double r = rule_axis(in, kFarOrders[i], degree);
    const double reach = r * (c1 + r * (c2 + r * c3));
    in.reach2[i] = r > 0.0 && has_no_zero(in.d, 0.0, r) ? reach * reach : kNever;
  }
  in.semi_axis = gauss_semi_axis(kNearOrder, degree, kTolerance);
}

[[maybe_unused]] void set_measure(AxisMeasure<true>& out, double turn, double middle) { out.turn = turn, out.middle = middle; }
[[maybe_unused]] void set_measure(AxisMeasure<false>&, double, double) {}

// After every change of J: closed forms need a constant one.
void refresh(Integrator& in) {
  in.closed_form_g = kClosedForms && in.element.straight && constant_jacobian(in) && !is_ring(in);
  in.g_jacobian = length(in.d[0]);
  if (!in.closed_form_g) prepare_reach(in);
}

void clear(double block[kElementNodes][2][2], int functions) {
  for (int l = 0; l < functions; ++l) {
    block[l][0][0] = block[l][0][1] = block[l][1][0] = block[l][1][1] = 0.0;
  }
}

} // namespace

// |d(u)| >= |d(0)| - r |d'(0)| - r^2 |d2| in the disc: sufficient, not necessary, and cheap.
bool has_no_zero(const double d[3][2], double origin, double radius) {
  double at[2], slope[2];
  for (int i = 0; i < 2; ++i) {
    at[i] = d[0][i] + origin * (d[1][i] + origin * d[2][i]);
    slope[i] = d[1][i] + 2.0 * origin * d[2][i];
  }
  return length(at) > radius * (length(slope) + radius * length(d[2]));
}

// Taylor shift of the element's polynomial. x(origin) - source is formed once; for a source on the element it is exactly zero,
// and no digits cancel later.
Expansion expand(const Integrator& in, double origin, double sx, double sy, bool at_source) {
  const double(&c)[kElementNodes][2] = in.element.c;
  const double source[2] = {sx, sy};
  Expansion x;
  x.origin = origin;
  for (int i = 0; i < 2; ++i) {
    const double moved = origin * (c[1][i] + origin * (c[2][i] + origin * c[3][i]));
    x.delta[i] = at_source ? 0.0 : (c[0][i] - source[i]) + moved;
    x.b[0][i] = c[1][i] + origin * (2.0 * c[2][i] + 3.0 * origin * c[3][i]);
    x.b[1][i] = c[2][i] + 3.0 * origin * c[3][i];
    x.b[2][i] = c[3][i];
  }
  return x;
}

Sample sample(const Integrator& in, const Expansion& x, double tau) {
  Sample s;
  const double eta = x.origin + tau;
  s.eta = eta;
  shape(in.functions, eta, s.shape);
  s.rx = x.delta[0] + tau * (x.b[0][0] + tau * (x.b[1][0] + tau * x.b[2][0]));
  s.ry = x.delta[1] + tau * (x.b[0][1] + tau * (x.b[1][1] + tau * x.b[2][1]));
  s.nx = x.b[0][1] + tau * (2.0 * x.b[1][1] + 3.0 * tau * x.b[2][1]);
  s.ny = -(x.b[0][0] + tau * (2.0 * x.b[1][0] + 3.0 * tau * x.b[2][0]));
  // J for tractions may belong to another element (set_arc), the normal is always the element's own.
  const double jx = in.d[0][0] + eta * (in.d[1][0] + eta * in.d[2][0]);
  const double jy = in.d[0][1] + eta * (in.d[1][1] + eta * in.d[2][1]);
  s.jacobian = sqrt(jx * jx + jy * jy);
  return s;
}

void finish(const Integrator& in, const Sums& sums, int singular, bool want_h, bool want_g, Blocks& out) {
  for (int l = 0; l < in.functions; ++l) {
    if (want_h) store(sums.h[l], l == singular ? 0.0 : in.k, out.h[l]);
    if (want_g) store(sums.g[l], in.k, out.g[l]);
  }
}

void prepare(Integrator& in, const Element& e, int functions, double nu, Quadrature mode) {
  in = Integrator();
  in.element = e;
  in.functions = functions;
  in.mode = mode;
  in.k = 1.0 / (4.0 * kPi * (1.0 - nu));
  in.kappa = 3.0 - 4.0 * nu;
  in.t1 = 1.0 - 2.0 * nu;
  in.t2 = 2.0 - 2.0 * nu;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 2; ++i) in.d[k][i] = (k + 1) * e.c[k + 1][i];
  }
  prepare_chord(in);
  refresh(in);
}

void set_axis(Integrator& in, double unit) {
  set_measure(in, 2.0 * kPi * unit, in.element.c[0][0]);
  refresh(in);
}

void set_arc(Integrator& in, const Element& arc, bool reversed) {
  set_measure(in, in.turn, arc.c[0][0]);
  for (int k = 0; k < 3; ++k) {
    const double sign = reversed && k != 1 ? -1.0 : 1.0; // of the derivative of arc(-eta)
    for (int i = 0; i < 2; ++i) in.d[k][i] = sign * (k + 1) * arc.c[k + 1][i];
  }
  refresh(in);
}

void integrate(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out,
               Samples* samples) {
  // Double nodes are joined by an element without length: it has no integrals.
  if (in.degenerate) {
    if (want_h) clear(out.h, in.functions);
    if (want_g) clear(out.g, in.functions);
    return;
  }
  if (is_ring(in)) return kRingPart.integrate_rings(in, sx, sy, singular, want_h, want_g, out);
  if (in.mode == Quadrature::thesis) {
    integrate_thesis(in, sx, sy, singular, want_h, want_g, out);
    return;
  }
  // T has no Jacobian of its own, so h is closed on every straight element. g needs a constant J besides.
  const bool closed_h = kClosedForms && want_h && in.element.straight, closed_g = want_g && in.closed_form_g;
  if (kClosedForms && (closed_h || closed_g)) integrate_straight(in, sx, sy, singular, closed_h, closed_g, out);
  if (want_h != closed_h || want_g != closed_g) {
    integrate_curved(in, sx, sy, singular, want_h && !closed_h, want_g, samples, out); // (where g is closed, so is h)
  }
}

void rigid_sum(const Integrator& in, double sx, double sy, int singular, double sum[2][2]) {
  if (is_ring(in)) return kRingPart.ring_sum(in, sx, sy, singular, sum);
  // A uniform translation needs no tractions, so the integral depends on the path only through its ends: METHOD (2.4). Outside
  // the circle that contains element and chord, the chord may replace the element.
  if (kClosedForms && in.mode == Quadrature::accurate && !in.degenerate) {
    const double x = sx - 0.5 * (in.element.x[0] + in.element.x[in.element.nodes - 1]);
    const double y = sy - 0.5 * (in.element.y[0] + in.element.y[in.element.nodes - 1]);
    const bool outside = in.chord2 > 0.0 && x * x + y * y > in.radius * in.radius;
    if (in.element.straight && singular >= 0) return rigid_sum_own_line(in, singular, sum);
    if (singular < 0 && (in.element.straight || outside)) return rigid_sum_chord(in, sx, sy, sum);
  }
  Blocks blocks;
  integrate(in, sx, sy, singular, true, false, blocks);
  sum[0][0] = sum[0][1] = sum[1][0] = sum[1][1] = 0.0;
  for (int l = 0; l < in.functions; ++l) {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) sum[i][j] += blocks.h[l][i][j];
    }
  }
}

void resultants(const Integrator& in, double ox, double oy, double w[kElementNodes], double wx[kElementNodes],
                double wy[kElementNodes]) {
  for (int l = 0; l < in.functions; ++l) w[l] = wx[l] = wy[l] = 0.0;
  const double r = gauss_semi_axis(kNearOrder, in.functions + 2, kTolerance);
  // M x is a polynomial of degree six at most: four points are exact if J is constant.
  const GaussRule rule = gauss_legendre(constant_jacobian(in) ? 4 : kNearOrder);
  const Expansion x = expand(in, 0.0, ox, oy, false);
  // Panels grow geometrically from -1; each is halved until J has no zero near it.
  double a = -1.0, step = 2.0;
  for (int panel = 0; a < 1.0 && !C2D_NEVER(panel == 200); ++panel) { // each panel is much longer than the one before
    double b = a + step < 1.0 ? a + step : 1.0;
    for (int cut = 0; !C2D_NEVER(cut == 50); ++cut) { // an element whose Jacobian vanishes is refused
      if (constant_jacobian(in) || has_no_zero(in.d, 0.5 * (a + b), 0.5 * (b - a) * r)) break;
      b = a + 0.5 * (b - a);
    }
    step = 4.0 * (b - a);
    for (int i = 0; i < rule.n; ++i) {
      const GaussPoint p = gauss_point(rule, i);
      const Sample s = sample(in, x, 0.5 * (a + b) + 0.5 * (b - a) * p.x);
      const double round = is_ring(in) ? in.turn * measured_radius(in, s.eta) : 1.0;
      for (int l = 0; l < in.functions; ++l) {
        const double weight = 0.5 * (b - a) * p.w * s.jacobian * round * s.shape[l];
        w[l] += weight;
        wx[l] += weight * s.rx;
        wy[l] += weight * s.ry;
      }
    }
    a = b;
  }
}

void weigh(const Integrator& in, PlaneField field, const void* context, double w[kElementNodes][2]) {
  for (int l = 0; l < in.functions; ++l) w[l][0] = w[l][1] = 0.0;
  const GaussRule rule = gauss_legendre(6);
  const Expansion at = expand(in, 0.0, 0.0, 0.0, false);
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint p = gauss_point(rule, i);
    const Sample s = sample(in, at, p.x);
    const double weight = p.w * s.jacobian * (is_ring(in) ? in.turn * measured_radius(in, s.eta) : 1.0);
    double f[2];
    field(context, s.rx, s.ry, f);
    for (int l = 0; l < in.functions; ++l)
      for (int c = 0; c < 2; ++c) w[l][c] += weight * s.shape[l] * f[c];
  }
}

} // namespace c2d
