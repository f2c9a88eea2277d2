#pragma once
// Panels of the near rule, for the plane kernels (integrals_curved.cpp) and for those of rings (bie/rings). A Kernel has the
// element `in`, and functions
//   add(s, weight, scale, sums): a point; without ln(scale) times the factor of ln(1/tau). scale = 1 away from the source;
//   add_logarithm(s, to, w, sums): that factor, times to w; has_logarithm(): is there one?
//   resolved(x, panel, own): are kNearOrder points sufficient on the panel?
#include "bie/integrals/integrals_detail.hpp"
#include "memory/hostile.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {

// Gauss rule on a panel. In the panel at the source (`own`) ln(1/tau) is split off: the rest is smooth and belongs here, the
// logarithm is integrated below by the logarithmic rule.
template <class Kernel>
void add_panel(const Kernel& kernel, const Expansion& x, const Stretch& p, bool own, int order, Sums& sums) {
  const GaussRule rule = gauss_legendre(order);
  const double half = 0.5 * (p.to - p.from), middle = 0.5 * (p.from + p.to);
  for (int i = 0; i < order; ++i) {
    const GaussPoint point = gauss_point(rule, i);
    const double tau = middle + half * point.x;
    kernel.add(sample(kernel.in, x, p.sign * tau), half * point.w, own ? p.to / tau : 1.0, sums);
  }
  if (!own || !kernel.has_logarithm()) return;
  const LogRule logs = log_gauss(kNearOrder);
  for (int i = 0; i < logs.n; ++i) kernel.add_logarithm(sample(kernel.in, x, p.sign * p.to * logs.x[i]), p.to, logs.w[i], sums);
}

// A rule on the element, or on a half of it, by points that were found for an earlier source. The same sums as add_panel().
template <class Kernel>
void add_rule(const Kernel& kernel, const double delta[2], int rule, RuleSamples<false>& samples, Sums& sums) {
  const RulePoints points = rule_points(kernel.in, rule, samples);
  for (int i = 0; i < points.count; ++i) {
    Sample s = points.at[i];
    s.rx += delta[0], s.ry += delta[1];
    kernel.add(s, points.weight[i], 1.0, sums);
  }
}

// One side of the origin, |tau| from 0 to `end`. A panel that does not meet its bound is shortened by the factor 0.7; the next
// one is tried five times as long. The limits on both loops are not reached unless the source lies on the element without
// being one of its nodes.
template <class Kernel>
void add_side(const Kernel& kernel, const Expansion& x, double sign, double end, bool at_source, Sums& sums) {
  Stretch p = {0.0, end, sign};
  for (int panel = 0; p.from < end && !C2D_NEVER(panel == 200); ++panel) {
    const bool own = at_source && panel == 0;
    for (int cut = 0; cut < 100 && !kernel.resolved(x, p, own); ++cut) p.to = p.from + 0.7 * (p.to - p.from);
    add_panel(kernel, x, p, own, kNearOrder, sums);
    const double next = p.to + 5.0 * (p.to - p.from);
    p.from = p.to;
    p.to = next < end ? next : end;
  }
}

// A source near the element but not on it. Distances are measured from the nearer end: x - source is a small difference there,
// and the end's coordinates are exact numbers. A source close to an end is then as accurate as any other.
template <class Kernel> void add_near(const Kernel& kernel, double sx, double sy, Sums& sums) {
  const Element& e = kernel.in.element;
  const int last = e.nodes - 1;
  const double a[2] = {e.x[0] - sx, e.y[0] - sy}, b[2] = {e.x[last] - sx, e.y[last] - sy};
  const bool first = squared(a) < squared(b);
  Expansion end = expand(kernel.in, first ? -1.0 : 1.0, sx, sy, false);
  for (int i = 0; i < 2; ++i) end.delta[i] = first ? a[i] : b[i];
  const double lo = first ? 0.0 : -2.0, hi = first ? 2.0 : 0.0;
  const double tau = kSmallCode ? nearest_point(e, sx, sy).eta - end.origin : nearest_parameter(end, lo, hi);
  const Expansion x = moved(end, tau);
  if (tau < hi) add_side(kernel, x, 1.0, hi - tau, false, sums);
  if (tau > lo) add_side(kernel, x, -1.0, tau - lo, false, sums);
}

// The element for one source: at its functional node `singular`, far away, or near. `samples` (may be null) are the element's.
template <class Kernel>
void add_element_integrals(const Kernel& kernel, double sx, double sy, int singular, RuleSamples<false>* samples, Sums& sums) {
  const Integrator& in = kernel.in;
  if (singular >= 0) {
    const double eta = node_eta(in.functions, singular);
    const Expansion x = expand(in, eta, sx, sy, true);
    if (eta < 1.0) add_side(kernel, x, 1.0, 1.0 - eta, true, sums);
    if (eta > -1.0) add_side(kernel, x, -1.0, 1.0 + eta, true, sums);
    return;
  }
  const double delta[2] = {in.element.c[0][0] - sx, in.element.c[0][1] - sy};
  const double r2 = squared(delta);
  int i = 0;
  while (i < kFarOrderCount && r2 <= in.reach2[i]) ++i;
  if (!kSmallCode && i < kFarOrderCount && samples) return add_rule(kernel, delta, i, *samples, sums);
  const Expansion x = expand(in, 0.0, sx, sy, false);
  if (i < kFarOrderCount) {
    add_panel(kernel, x, {-1.0, 1.0, 1.0}, false, kFarOrders[i], sums);
    // Two half panels are the most frequent near case and need no search for the nearest point.
  } else if (kernel.resolved(x, {0.0, 1.0, 1.0}, false) && kernel.resolved(x, {0.0, 1.0, -1.0}, false)) {
    for (int half = kUpperHalf; half <= kLowerHalf; ++half) {
      if (!kSmallCode && samples)
        add_rule(kernel, delta, half, *samples, sums);
      else
        add_panel(kernel, x, {0.0, 1.0, half == kUpperHalf ? 1.0 : -1.0}, false, kNearOrder, sums);
    }
  } else {
    add_near(kernel, sx, sy, sums);
  }
}

} // namespace c2d
