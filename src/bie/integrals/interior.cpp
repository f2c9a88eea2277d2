// Displacement and stress at points off the boundary: the kernels at a point, and Gauss rules over curved elements (METHOD
// 16.3). Formulas are in interior.hpp, Somigliana's identity and its derivative:
//   u(P) = int U t - int T u,   sigma(P) = int D t - int S u.
// Phases, for one element and one point:
// 1. prepare_field(): nodal values become coefficients of powers of eta, once for all points.
// 2. Far: one Gauss rule. Near: panels as in integrals_curved.cpp. Straight elements: closed forms (interior_straight.cpp).
// 3. The displacement `reference` is subtracted first. A translation has no stress, so this changes nothing but the
//    cancellation: S grows like 1/r^2, and u - reference vanishes where it is largest.
// In complex form a kernel is one or two products instead of the eight components of D and S.
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course (internal points); thesis (3.32) to (3.34).

#include "bie/integrals/integrals_detail.hpp"
#include "bie/integrals/interior_detail.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {

C2D_USES(RingPart);

namespace {

// Quantities of a source-field pair that both kernels use.
struct Ray {
  double r2;
  Complex inverse; // 1/rho
  Complex phase;   // rho*/rho, of modulus 1
};

Ray make_ray(double rx, double ry) {
  Ray ray;
  ray.r2 = rx * rx + ry * ry;
  const double q = 1.0 / ray.r2;
  ray.inverse = {rx * q, -ry * q};
  ray.phase = Complex{rx, -ry} * ray.inverse;
  return ray;
}

// U t and D t, divided by k.
void add_traction(const Ray& ray, Complex t, double kappa, PointField& sum) {
  add(sum.u, (-0.5 * kappa * log(ray.r2)) * t + 0.5 * (t + conj(t * ray.phase)));
  const Complex over = t * ray.inverse;
  sum.trace += 2.0 * over.re;
  add(sum.deviator, kappa * (conj(t) * ray.inverse) + over * ray.phase);
}

// -T u and -S u, divided by k.
void add_displacement(const Ray& ray, Complex n, Complex u, double kappa, PointField& sum) {
  const Complex nu = n * u, over = nu * ray.inverse;
  const double along = dot(n, u);
  add(sum.u, 0.5 * (kappa * over + (2.0 * along) * conj(ray.inverse) + conj(over * ray.phase)));
  const Complex twice = over * ray.inverse;
  sum.trace += 2.0 * twice.re;
  add(sum.deviator, 2.0 * (along * (ray.inverse * ray.inverse) + twice * ray.phase));
}

// One panel: the densities are polynomials in eta, so only the kernels differ from point to point.
void add_panel(const FieldElement& e, Complex reference, const Expansion& x, const Stretch& panel, int order, PointField& sum) {
  const GaussRule rule = gauss_legendre(order);
  const double half = 0.5 * (panel.to - panel.from), middle = 0.5 * (panel.from + panel.to);
  for (int i = 0; i < order; ++i) {
    const GaussPoint point = gauss_point(rule, i);
    const double tau = middle + half * point.x, eta = x.origin + tau, weight = half * point.w;
    const Sample s = sample(e.in, x, tau);
    const Ray ray = make_ray(s.rx, s.ry);
    PointField part = {};
    add_traction(ray, s.jacobian * polynomial(e.t, e.in.functions, eta), e.in.kappa, part);
    if (e.displaced) {
      const Complex u = polynomial(e.u, e.in.functions, eta) - reference;
      add_displacement(ray, {s.nx, s.ny}, u, e.in.kappa, part);
    }
    add_scaled(sum, weight, part);
  }
}

// Far: one rule. Near: panels that shrink towards the nearest point and grow behind it. Parameters are counted from that
// point, so that the distance has the same rounding in all panels. The limits on the loops are not reached for points off the
// boundary.
void add_field_curved(const FieldElement& e, Complex reference, double px, double py, PointField& sum) {
  const double x0 = e.in.element.c[0][0] - px, y0 = e.in.element.c[0][1] - py, r2 = x0 * x0 + y0 * y0;
  for (int i = 0; i < kFarOrderCount; ++i)
    if (r2 > e.in.reach2[i])
      return add_panel(e, reference, expand(e.in, 0.0, px, py, false), {-1.0, 1.0, 1.0}, kFarOrders[i], sum);
  const double origin = nearest_point(e.in.element, px, py).eta, end = 1.0 - origin;
  const Expansion x = expand(e.in, origin, px, py, false);
  Stretch panel = {-1.0 - origin, end, 1.0};
  for (int count = 0; panel.from < end && !C2D_NEVER(count == 400); ++count) {
    for (int cut = 0; !resolved(e.in, x, panel, false) && !C2D_NEVER(cut == 100); ++cut)
      panel.to = panel.from + 0.7 * (panel.to - panel.from);
    add_panel(e, reference, x, panel, kNearOrder, sum);
    const double next = panel.to + 5.0 * (panel.to - panel.from);
    panel = {panel.to, next < end ? next : end, 1.0};
  }
}

} // namespace

void add_scaled(PointField& sum, double factor, const PointField& part) {
  add(sum.u, factor * part.u);
  sum.trace += factor * part.trace;
  add(sum.deviator, factor * part.deviator);
  add_round(sum, factor * part.round);
}

void prepare_field(const Complex t[kElementNodes], const Complex* u, FieldElement& out) {
  const Integrator& in = out.in;
  out.displaced = u != nullptr;
  out.closed_form = kClosedForms && in.closed_form_g && !in.degenerate;
  const double h2 = in.chord2;
  out.axis = out.closed_form ? sqrt(h2) * Complex{in.ux, in.uy} : Complex{1.0, 0.0};
  for (int k = 0; k < kElementNodes; ++k) {
    out.t[k] = out.u[k] = Complex{0.0, 0.0};
    if (k >= in.functions) continue;
    for (int l = 0; l < in.functions; ++l) {
      // Closed forms use the element's own axes: the nodal values are rotated once, here.
      const Complex turned = shape_coefficients(in.functions, l)[k] * conj(out.axis);
      add(out.t[k], turned * t[l]);
      if (u) add(out.u[k], turned * u[l]);
    }
  }
}

void add_field(const FieldElement& e, Complex reference, double x, double y, PointField& sum) {
  if (e.in.degenerate) return;
  if (!e.displaced) reference = Complex{0.0, 0.0};
  if (is_ring(e.in)) return kRingPart.add_ring_field(e, reference, x, y, sum);
  if (kClosedForms && e.closed_form) return add_field_straight(e, reference, x, y, sum);
  PointField part = {};
  add_field_curved(e, reference, x, y, part);
  add_scaled(sum, e.in.k, part);
}

void add_force_field(Complex force, double nu, double fx, double fy, double x, double y, PointField& sum) {
  const double rx = fx - x, ry = fy - y;
  // The field of a force at its own point is infinite; such a point gets nothing.
  if (!(rx * rx + ry * ry > 1e-30)) return;
  PointField part = {};
  add_traction(make_ray(rx, ry), force, 3.0 - 4.0 * nu, part);
  add_scaled(sum, 1.0 / (4.0 * kPi * (1.0 - nu)), part);
}

// The angle at which the element is seen from the point, over 2 pi. Outside the disc that contains the element and its chord
// it is the angle of the chord. Elsewhere it follows from the isotropic part of int T, which is -angle/(2 pi).
double winding(const Integrator& in, double x, double y) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double ax = e.x[0] - x, ay = e.y[0] - y, bx = e.x[last] - x, by = e.y[last] - y;
  const double mx = 0.5 * (ax + bx), my = 0.5 * (ay + by);
  if (e.straight || mx * mx + my * my > 4.0 * in.radius * in.radius)
    return atan2(ax * by - ay * bx, ax * bx + ay * by) / (2.0 * kPi);
  double sum[2][2];
  rigid_sum(in, x, y, -1, sum);
  return -0.5 * (sum[0][0] + sum[1][1]);
}

} // namespace c2d
