// Quadrature of 1987: appendix A of the thesis, for comparison with its results (METHOD 3.4).
//
// 2, 4 or 10 Gauss points by the distance of the source, thesis (A.3). At the source's own node
//   ln(1/r) = ln(1/|tau|) + ln(1/|q|),   r = |tau q|,
// where the first term is integrated by the logarithmic rule on either side of the node, thesis (A.4).
// The error is not bounded beforehand: it depends on the distance and on the shape of the element.
#include "bie/integrals/integrals_detail.hpp"
#include "memory/math.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {
namespace {

// From the smallest distance r to a geometry node and the chord L between the ends.
int rule_order(const Integrator& in, double sx, double sy) {
  const Element& e = in.element;
  double r2 = 0.0;
  for (int i = 0; i < e.nodes; ++i) {
    const double x = e.x[i] - sx, y = e.y[i] - sy, d2 = x * x + y * y;
    if (i == 0 || d2 < r2) r2 = d2;
  }
  const double length2 = 4.0 * in.chord2;
  if (r2 <= 1.5 * 1.5 * length2) return 10;
  return r2 <= 5.0 * 5.0 * length2 ? 4 : 2;
}

// int ln(1/|tau|) M J on one side of the source, `end` = length of that side:
// end [ int_0^1 ln(1/x) M J dx - ln(end) int_0^1 M J dx ].
double logarithmic_side(const Integrator& in, const Expansion& x, int singular, double sign, double end, int order) {
  const LogRule logs = log_gauss(order);
  const GaussRule rule = gauss_legendre(order);
  double with_log = 0.0, plain = 0.0;
  for (int i = 0; i < order; ++i) {
    const Sample s = sample(in, x, sign * end * logs.x[i]);
    with_log += logs.w[i] * s.shape[singular] * s.jacobian;
    const GaussPoint p = gauss_point(rule, i);
    const Sample t = sample(in, x, sign * end * 0.5 * (1.0 + p.x));
    plain += 0.5 * p.w * t.shape[singular] * t.jacobian;
  }
  return end * (with_log - log(end) * plain);
}

} // namespace

void integrate_thesis(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out) {
  const int order = rule_order(in, sx, sy);
  const GaussRule rule = gauss_legendre(order);
  const double origin = singular >= 0 ? node_eta(in.functions, singular) : 0.0;
  const Expansion x = expand(in, origin, sx, sy, singular >= 0);
  Sums sums = {};
  for (int i = 0; i < order; ++i) {
    const GaussPoint p = gauss_point(rule, i);
    const double tau = p.x - origin;
    const Sample s = sample(in, x, tau);
    const double r2 = s.rx * s.rx + s.ry * s.ry;
    if (!(r2 > 0.0)) continue; // a source on a Gauss point contributes nothing, as in the listing
    const Tensor t = traction_kernel(s.rx, s.ry, 1.0 / r2, s.nx, s.ny, in.t1);
    const Tensor u = displacement_kernel(s.rx, s.ry, r2, in.kappa);
    for (int l = 0; l < in.functions; ++l) {
      const double weight = p.w * s.shape[l];
      if (want_h) add(sums.h[l], weight, t);
      if (!want_g) continue;
      add(sums.g[l], weight * s.jacobian, u);
      if (l == singular) sums.g[l].alpha += 0.5 * in.kappa * weight * s.jacobian * log(tau * tau);
    }
  }
  if (want_g && singular >= 0) {
    double& own = sums.g[singular].alpha;
    if (origin < 1.0) own += in.kappa * logarithmic_side(in, x, singular, 1.0, 1.0 - origin, order);
    if (origin > -1.0) own += in.kappa * logarithmic_side(in, x, singular, -1.0, 1.0 + origin, order);
  }
  finish(in, sums, singular, want_h, want_g, out);
}

} // namespace c2d
