// The kernels at a point, and Gauss rules over curved elements. See interior.hpp for the formulas.
#include <math.h>

#include "bie/integrals_detail.hpp"
#include "bie/interior_detail.hpp"
#include "bie/kernels.hpp"
#include "bie/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {
namespace {


// What both kernels of a source-field pair need.
struct Ray {
  double r2;
  Complex inverse; // 1/rho
  Complex phase;   // rho*/rho
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

void add_scaled(PointField& sum, double factor, const PointField& part) {
  add(sum.u, factor * part.u);
  sum.trace += factor * part.trace;
  add(sum.deviator, factor * part.deviator);
}

Complex polynomial(const Complex* c, int n, double eta) {
  Complex sum = c[n - 1];
  for (int k = n - 2; k >= 0; --k) sum = eta * sum + c[k];
  return sum;
}

struct Panel { // parameters from the expansion's origin
  double from, to;
};

void add_panel(const FieldElement& e, Complex reference, const Expansion& x, const Panel& panel, int order,
               PointField& sum) {
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

// Neither x - P nor the measure vanishes in the disc round the panel's middle that holds the rule's ellipse, by the
// triangle inequality.
bool resolved(const FieldElement& e, const Expansion& x, const Panel& panel) {
  const double t = 0.5 * (panel.from + panel.to), radius = e.in.semi_axis * 0.5 * (panel.to - panel.from);
  double at[2], d1[2], d2[2];
  for (int i = 0; i < 2; ++i) {
    const double b1 = x.b[0][i], b2 = x.b[1][i], b3 = x.b[2][i];
    at[i] = x.delta[i] + t * (b1 + t * (b2 + t * b3));
    d1[i] = b1 + t * (2.0 * b2 + 3.0 * t * b3);
    d2[i] = b2 + 3.0 * t * b3;
  }
  const double bound = hypot(d1[0], d1[1]) + radius * (hypot(d2[0], d2[1]) + radius * hypot(x.b[2][0], x.b[2][1]));
  return hypot(at[0], at[1]) > radius * bound && has_no_zero(e.in.d, x.origin + t, radius);
}

// One rule far away; else panels that shrink on the way to the nearest point and grow behind it, with parameters counted
// from there, so that the rounding of the distance is the same for all. The bounds of the loops are out of reach for
// points off the boundary.
void add_field_curved(const FieldElement& e, Complex reference, double px, double py, PointField& sum) {
  const double x0 = e.in.element.c[0][0] - px, y0 = e.in.element.c[0][1] - py, r2 = x0 * x0 + y0 * y0;
  for (int i = 0; i < kFarOrderCount; ++i)
    if (r2 > e.in.reach2[i])
      return add_panel(e, reference, expand(e.in, 0.0, px, py, false), {-1.0, 1.0}, kFarOrders[i], sum);
  const double origin = nearest_point(e.in.element, px, py).eta, end = 1.0 - origin;
  const Expansion x = expand(e.in, origin, px, py, false);
  Panel panel = {-1.0 - origin, end};
  for (int count = 0; count < 400 && panel.from < end; ++count) {
    for (int cut = 0; cut < 100 && !resolved(e, x, panel); ++cut)
      panel.to = panel.from + 0.7 * (panel.to - panel.from);
    add_panel(e, reference, x, panel, kNearOrder, sum);
    const double next = panel.to + 5.0 * (panel.to - panel.from);
    panel = {panel.to, next < end ? next : end};
  }
}

} // namespace

void prepare_field(const Complex t[4], const Complex* u, FieldElement& out) {
  const Integrator& in = out.in;
  out.displaced = u != nullptr;
  out.closed_form = in.closed_form_g && !in.degenerate;
  const double h2 = in.chord2;
  out.axis = out.closed_form ? sqrt(h2) * Complex{in.ux, in.uy} : Complex{1.0, 0.0};
  for (int k = 0; k < 4; ++k) {
    out.t[k] = out.u[k] = Complex{0.0, 0.0};
    if (k >= in.functions) continue;
    for (int l = 0; l < in.functions; ++l) {
      const Complex turned = shape_coefficients(in.functions, l)[k] * conj(out.axis);
      add(out.t[k], turned * t[l]);
      if (u) add(out.u[k], turned * u[l]);
    }
  }
}

void add_field(const FieldElement& e, Complex reference, double x, double y, PointField& sum) {
  if (e.in.degenerate) return;
  if (!e.displaced) reference = Complex{0.0, 0.0};
  if (e.closed_form) return add_field_straight(e, reference, x, y, sum);
  PointField part = {};
  add_field_curved(e, reference, x, y, part);
  add_scaled(sum, e.in.k, part);
}

void add_force_field(Complex force, double nu, double fx, double fy, double x, double y, PointField& sum) {
  const double rx = fx - x, ry = fy - y;
  if (!(rx * rx + ry * ry > 1e-30)) return;
  PointField part = {};
  add_traction(make_ray(rx, ry), force, 3.0 - 4.0 * nu, part);
  add_scaled(sum, 1.0 / (4.0 * kPi * (1.0 - nu)), part);
}

// The angle under which the element is seen. Outside the disc that holds the element and its chord it is the chord's;
// elsewhere the isotropic part of int T tells, which is -angle/(2 pi).
double winding(const Integrator& in, double x, double y) {
  const Element& e = in.element;
  const int last = e.nodes - 1;
  const double ax = e.x[0] - x, ay = e.y[0] - y, bx = e.x[last] - x, by = e.y[last] - y;
  const double mx = 0.5 * (ax + bx), my = 0.5 * (ay + by);
  if (in.degenerate) return 0.0;
  if (e.straight || mx * mx + my * my > 4.0 * in.radius * in.radius)
    return atan2(ax * by - ay * bx, ax * bx + ay * by) / (2.0 * kPi);
  double sum[2][2];
  rigid_sum(in, x, y, -1, sum);
  return -0.5 * (sum[0][0] + sum[1][1]);
}

namespace {

struct Offset { // of a point of the element from P, with derivatives
  double rx, ry, dx, dy, ddx, ddy;
  double distance2() const { return rx * rx + ry * ry; }
};

Offset offset_at(const Element& e, double eta, double x, double y) {
  const double(&c)[4][2] = e.c;
  return {(c[0][0] - x) + eta * (c[1][0] + eta * (c[2][0] + eta * c[3][0])),
          (c[0][1] - y) + eta * (c[1][1] + eta * (c[2][1] + eta * c[3][1])),
          c[1][0] + eta * (2.0 * c[2][0] + 3.0 * eta * c[3][0]),
          c[1][1] + eta * (2.0 * c[2][1] + 3.0 * eta * c[3][1]),
          2.0 * c[2][0] + 6.0 * eta * c[3][0],
          2.0 * c[2][1] + 6.0 * eta * c[3][1]};
}

double clamped(double eta) { return eta < -1.0 ? -1.0 : (eta > 1.0 ? 1.0 : eta); }

// Newton's step on the squared distance; without curvature where that would lead to a maximum. Exact on a straight
// element.
double newton_step(const Offset& o) {
  const double slope = o.rx * o.dx + o.ry * o.dy, speed = o.dx * o.dx + o.dy * o.dy;
  const double curvature = speed + o.rx * o.ddx + o.ry * o.ddy;
  const double divisor = curvature > 0.1 * speed ? curvature : speed;
  return divisor > 0.0 ? slope / divisor : 0.0;
}

} // namespace

Nearest nearest_point(const Element& e, double x, double y) {
  double best = 0.0, best2 = offset_at(e, 0.0, x, y).distance2();
  for (int i = 0; i <= 8 && !e.straight; ++i) {
    const double eta = -1.0 + 0.25 * i, d2 = offset_at(e, eta, x, y).distance2();
    if (!(d2 < best2)) continue;
    best = eta;
    best2 = d2;
  }
  for (int i = 0; i < 20; ++i) {
    const double eta = clamped(best - newton_step(offset_at(e, best, x, y)));
    const double d2 = offset_at(e, eta, x, y).distance2();
    if (!(d2 < best2)) break;
    best = eta;
    best2 = d2;
  }
  return {best, sqrt(best2)};
}

} // namespace c2d
