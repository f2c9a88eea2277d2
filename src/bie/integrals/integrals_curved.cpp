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
#include "bie/integrals/integrals_panels.hpp"
#include "memory/config.hpp"
#include "memory/math.hpp"

namespace c2d {
namespace {

double length(const double v[2]) { return sqrt(squared(v)); }

// The plane kernels of one element.
struct PlaneKernel {
  const Integrator& in;
  bool want_h, want_g;

  void add(const Sample& s, double weight, double scale, Sums& sums) const {
    const double r2 = s.rx * s.rx + s.ry * s.ry, q = 1.0 / r2;
    if (want_h) {
      const Tensor t = traction_kernel(s.rx, s.ry, q, s.nx, s.ny, in.t1);
      for (int l = 0; l < in.functions; ++l) c2d::add(sums.h[l], weight * s.shape[l], t);
    }
    if (want_g) {
      const Tensor u = displacement_kernel(s.rx, s.ry, q, r2 * scale * scale, in.kappa);
      const double weight_g = weight * s.jacobian;
      for (int l = 0; l < in.functions; ++l) c2d::add(sums.g[l], weight_g * s.shape[l], u);
    }
  }
  bool has_logarithm() const { return want_g; }
  void add_logarithm(const Sample& s, double to, double w, Sums& sums) const {
    const double factor = in.kappa * to * w * s.jacobian;
    for (int l = 0; l < in.functions; ++l) sums.g[l].alpha += factor * s.shape[l];
  }
  bool resolved(const Expansion& x, const Stretch& p, bool own) const { return c2d::resolved(in, x, p, own); }
};

// Squared distance from the source to the point at tau.
double distance2(const Expansion& x, double tau) {
  double r[2];
  for (int i = 0; i < 2; ++i) r[i] = x.delta[i] + tau * (x.b[0][i] + tau * (x.b[1][i] + tau * x.b[2][i]));
  return squared(r);
}

} // namespace

// The parameter of the point nearest to the source, relative to the expansion's origin and within [lo, hi]: the real part of
// the complex root of x(tau) = source. That root, not the geometric distance, limits the Bernstein ellipse. Newton's method
// starts from the best of nine points; its result counts only if it is nearer. (Small code takes the nearest point itself and
// needs more panels.)
double nearest_parameter(const Expansion& x, double lo, double hi) {
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
    const double slope2 = squared(df);
    // A zero derivative: a double root, from which Newton's method would jump away.
    if (!(slope2 > 1e-12 * squared(x.b[0]))) break;
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

RulePoints rule_points(const Integrator& in, int rule, RuleSamples<false>& samples) {
  constexpr int kFirst[] = {0, 2, 5, 9, 14, 20, 28, 38, 50, 66, 86, 102, 118};
  const int first = kFirst[rule], count = kFirst[rule + 1] - first;
  if (!samples.known[rule]) {
    const Expansion x = expand(in, 0.0, in.element.c[0][0], in.element.c[0][1], true);
    const double sign = rule == kLowerHalf ? -1.0 : 1.0, half = rule < kUpperHalf ? 1.0 : 0.5, middle = 1.0 - half;
    const GaussRule gauss = gauss_legendre(count);
    for (int i = 0; i < count; ++i) {
      const GaussPoint p = gauss_point(gauss, i);
      samples.at[first + i] = sample(in, x, sign * (middle + half * p.x));
      samples.weight[first + i] = half * p.w;
    }
    samples.known[rule] = true;
  }
  return {samples.at + first, samples.weight + first, count};
}

[[maybe_unused]] static RuleSamples<false>* seen(RuleSamples<false>* samples) { return samples; }
[[maybe_unused]] static RuleSamples<false>* seen(RuleSamples<true>*) { return nullptr; }

void integrate_curved(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Samples* samples,
                      Blocks& out) {
  Sums sums = {};
  add_element_integrals(PlaneKernel{in, want_h, want_g}, sx, sy, singular, seen(samples), sums);
  finish(in, sums, singular, want_h, want_g, out);
}

} // namespace c2d
