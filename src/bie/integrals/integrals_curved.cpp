// Integrals over curved elements, or straight ones whose Jacobian is not constant (METHOD 3.3).
//
// Three cases, by the distance of the source:
// 1. Far: the cheapest Gauss rule on the whole element whose a-priori bound is met.
// 2. Near: panels that grow geometrically away from the nearest point of the element, kNearOrder points each, with a bound of
//    their own.
// 3. Source on the element: the same panels from the source on. There r = |tau| |q(tau)| with a smooth q, so
//   ln r = ln(|tau| / c) + ln(c |q|),
// and the first term is integrated by a logarithmic Gauss rule. The singular part of T at the source's own node is not
// integrated; it follows from a rigid-body translation (METHOD 2.3). Geometric panels reach any distance with a number of
// panels proportional to its logarithm, and the order is constant.
// Literature: Davis and Rabinowitz, Methods of Numerical Integration, on geometric subdivision and singular integrands;
// Brebbia and Dominguez, Boundary Elements: An Introductory Course, on the free term by rigid-body motion.
#include "bie/integrals/integrals_detail.hpp"
#include "memory/config.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {
namespace {

struct Job {
  const Integrator& in;
  int singular;
  bool want_h, want_g;
};

double square(const double v[2]) { return v[0] * v[0] + v[1] * v[1]; }

double length(const double v[2]) { return sqrt(square(v)); }

// Adds one quadrature point; r2 = |x - source|^2. `log_of` replaces r2 in the logarithm if a factor is split off.
void add_point(const Job& job, const Sample& s, double weight, double r2, double log_of, Sums& sums) {
  const Integrator& in = job.in;
  const double q = 1.0 / r2;
  if (job.want_h) {
    const Tensor t = traction_kernel(s.rx, s.ry, q, s.nx, s.ny, in.t1);
    for (int l = 0; l < in.functions; ++l) add(sums.h[l], weight * s.shape[l], t);
  }
  if (job.want_g) {
    const Tensor u = displacement_kernel(s.rx, s.ry, q, log_of, in.kappa);
    const double weight_g = weight * s.jacobian;
    for (int l = 0; l < in.functions; ++l) add(sums.g[l], weight_g * s.shape[l], u);
  }
}

// Gauss rule on a panel. In the panel at the source (`own`), c is the panel's length. ln(c |q|) is smooth and belongs here;
// ln(tau / c) is integrated below by the logarithmic rule.
void add_panel(const Job& job, const Expansion& x, const Stretch& p, bool own, int order, Sums& sums) {
  const GaussRule rule = gauss_legendre(order);
  const double half = 0.5 * (p.to - p.from), middle = 0.5 * (p.from + p.to);
  for (int i = 0; i < order; ++i) {
    const GaussPoint point = gauss_point(rule, i);
    const double tau = middle + half * point.x;
    const Sample s = sample(job.in, x, p.sign * tau);
    const double r2 = s.rx * s.rx + s.ry * s.ry, scale = own ? p.to / tau : 1.0;
    add_point(job, s, half * point.w, r2, r2 * scale * scale, sums);
  }
  if (!own || !job.want_g) return;
  const LogRule logs = log_gauss(kNearOrder);
  for (int i = 0; i < logs.n; ++i) {
    const Sample s = sample(job.in, x, p.sign * p.to * logs.x[i]);
    const double weight = job.in.kappa * p.to * logs.w[i] * s.jacobian;
    for (int l = 0; l < job.in.functions; ++l) sums.g[l].alpha += weight * s.shape[l];
  }
}

// One side of the origin, |tau| from 0 to `end`. A panel that does not meet its bound is shortened by the factor 0.7; the next
// one is tried five times as long. The limits on both loops are not reached unless the source lies on the element without
// being one of its nodes.
void add_side(const Job& job, const Expansion& x, double sign, double end, Sums& sums) {
  Stretch p = {0.0, end, sign};
  for (int panel = 0; p.from < end && !C2D_NEVER(panel == 200); ++panel) {
    const bool own = job.singular >= 0 && panel == 0;
    for (int cut = 0; cut < 100 && !resolved(job.in, x, p, own); ++cut) p.to = p.from + 0.7 * (p.to - p.from);
    add_panel(job, x, p, own, kNearOrder, sums);
    const double next = p.to + 5.0 * (p.to - p.from);
    p.from = p.to;
    p.to = next < end ? next : end;
  }
}

// Squared distance from the source to the point at tau.
double distance2(const Expansion& x, double tau) {
  double r[2];
  for (int i = 0; i < 2; ++i) r[i] = x.delta[i] + tau * (x.b[0][i] + tau * (x.b[1][i] + tau * x.b[2][i]));
  return square(r);
}

// The parameter of the point nearest to the source, relative to the expansion's origin and within [lo, hi]: the real part of
// the complex root of x(tau) = source. That root, not the geometric distance, limits the Bernstein ellipse. Newton's method
// starts from the best of nine points; its result counts only if it is nearer. (Small code takes the nearest point itself and
// needs more panels.)
double nearest(const Expansion& x, double lo, double hi) {
  double best = 0.0, best2 = distance2(x, 0.0);
  for (int i = 0; i <= 8; ++i) {
    const double tau = lo + 0.125 * i * (hi - lo), d2 = distance2(x, tau);
    if (d2 < best2) {
      best = tau;
      best2 = d2;
    }
  }
  double re = best, im = 0.0;
  for (int i = 0; i < 12; ++i) {
    double f[2] = {x.b[2][0], x.b[2][1]}, df[2] = {0.0, 0.0}; // Horner in complex arithmetic
    for (int k = 2; k >= 0; --k) {
      const double* next = k > 0 ? x.b[k - 1] : x.delta;
      const double dr = df[0] * re - df[1] * im + f[0], di = df[0] * im + df[1] * re + f[1];
      const double fr = f[0] * re - f[1] * im + next[0], fi = f[0] * im + f[1] * re + next[1];
      df[0] = dr;
      df[1] = di;
      f[0] = fr;
      f[1] = fi;
    }
    const double slope2 = square(df);
    // A zero derivative: a double root, from which Newton's method would jump away.
    if (!(slope2 > 1e-12 * square(x.b[0]))) break;
    const double step_re = (f[0] * df[0] + f[1] * df[1]) / slope2, step_im = (f[1] * df[0] - f[0] * df[1]) / slope2;
    re -= step_re;
    im -= step_im;
    if (re * re + im * im > 16.0) break;
    const double tau = re < lo ? lo : (re > hi ? hi : re), d2 = distance2(x, tau);
    if (d2 < best2) {
      best = tau;
      best2 = d2;
    }
    if (step_re * step_re + step_im * step_im < 1e-28 * (re * re + im * im)) break;
  }
  return best;
}

// Moves the origin to tau. delta is updated from its old value, so it keeps the accuracy that it has near an end.
Expansion moved(const Expansion& x, double tau) {
  Expansion y;
  y.origin = x.origin + tau;
  for (int i = 0; i < 2; ++i) {
    const double b1 = x.b[0][i], b2 = x.b[1][i], b3 = x.b[2][i];
    y.delta[i] = x.delta[i] + tau * (b1 + tau * (b2 + tau * b3));
    y.b[0][i] = b1 + tau * (2.0 * b2 + 3.0 * tau * b3);
    y.b[1][i] = b2 + 3.0 * tau * b3;
    y.b[2][i] = b3;
  }
  return y;
}

// A source near the element but not on it. Distances are measured from the nearer end: x - source is a small difference there,
// and the end's coordinates are exact numbers. A source close to an end is then as accurate as any other.
void add_near(const Job& job, double sx, double sy, Sums& sums) {
  const Element& e = job.in.element;
  const int last = e.nodes - 1;
  const double a[2] = {e.x[0] - sx, e.y[0] - sy}, b[2] = {e.x[last] - sx, e.y[last] - sy};
  const bool first = square(a) < square(b);
  Expansion end = expand(job.in, first ? -1.0 : 1.0, sx, sy, false);
  for (int i = 0; i < 2; ++i) end.delta[i] = first ? a[i] : b[i];
  const double lo = first ? 0.0 : -2.0, hi = first ? 2.0 : 0.0;
  const double tau = kSmallCode ? nearest_point(e, sx, sy).eta - end.origin : nearest(end, lo, hi);
  const Expansion x = moved(end, tau);
  if (tau < hi) add_side(job, x, 1.0, hi - tau, sums);
  if (tau > lo) add_side(job, x, -1.0, tau - lo, sums);
}

} // namespace

// x - source (or q, in the source's own panel) is bounded away from zero in the disc that contains the panel's ellipse. The
// same test covers J.
bool resolved(const Integrator& in, const Expansion& x, const Stretch& p, bool own) {
  const double t = p.sign * 0.5 * (p.from + p.to), radius = in.semi_axis * 0.5 * (p.to - p.from);
  double at[2], d1[2], d2[2], d3[2];
  for (int i = 0; i < 2; ++i) {
    const double b1 = x.b[0][i], b2 = x.b[1][i], b3 = x.b[2][i];
    const double q = b1 + t * (b2 + t * b3);
    at[i] = own ? q : x.delta[i] + t * q;
    d1[i] = own ? b2 + 2.0 * t * b3 : b1 + t * (2.0 * b2 + 3.0 * t * b3);
    d2[i] = own ? b3 : b2 + 3.0 * t * b3;
    d3[i] = own ? 0.0 : b3;
  }
  if (!(length(at) > radius * (length(d1) + radius * (length(d2) + radius * length(d3))))) return false;
  return has_no_zero(in.d, x.origin + t, radius);
}

void integrate_curved(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out) {
  const Job job = {in, singular, want_h, want_g};
  Sums sums = {};
  if (singular >= 0) {
    const double eta = node_eta(in.functions, singular);
    const Expansion x = expand(in, eta, sx, sy, true);
    if (eta < 1.0) add_side(job, x, 1.0, 1.0 - eta, sums);
    if (eta > -1.0) add_side(job, x, -1.0, 1.0 + eta, sums);
  } else {
    const Expansion x = expand(in, 0.0, sx, sy, false);
    const double r2 = square(x.delta);
    int i = 0;
    while (i < kFarOrderCount && r2 <= in.reach2[i]) ++i;
    if (i < kFarOrderCount) {
      add_panel(job, x, {-1.0, 1.0, 1.0}, false, kFarOrders[i], sums);
      // Two half panels are the most frequent near case and need no search for the nearest point.
    } else if (resolved(in, x, {0.0, 1.0, 1.0}, false) && resolved(in, x, {0.0, 1.0, -1.0}, false)) {
      add_panel(job, x, {0.0, 1.0, 1.0}, false, kNearOrder, sums);
      add_panel(job, x, {0.0, 1.0, -1.0}, false, kNearOrder, sums);
    } else {
      add_near(job, sx, sy, sums);
    }
  }
  finish(in, sums, singular, want_h, want_g, out);
}

} // namespace c2d
