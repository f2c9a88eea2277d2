#pragma once
// The three integration methods of integrals.cpp. Arguments as for integrate().

#include "bie/integrals/integrals.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/config.hpp"

namespace c2d {

// Straight elements have closed forms, at a third of the cost. Small code integrates them like curved ones.
constexpr bool kClosedForms = !kSmallCode;

// Gauss rules for the far case, cheapest first; Integrator::reach2 has one entry for each.
constexpr int kFarOrders[] = {2, 3, 4, 5, 6, 8, 10, 12, 16, 20};
constexpr int kFarOrderCount = 10;
constexpr int kUpperHalf = kFarOrderCount, kLowerHalf = kUpperHalf + 1; // rules of kNearOrder points on half an element
// Gauss and logarithmic points per panel of the near rule.
constexpr int kNearOrder = 16;

// The element seen from the source, as a polynomial about a parameter `origin`: x(origin + tau) - source = delta + tau (b[0] +
// tau (b[1] + tau b[2])), without cancellation near the origin.
struct Expansion {
  double origin;
  double delta[2];
  double b[3][2];
};

// A panel: part of an element on one side of an expansion's origin.
struct Stretch {
  double from, to; // |tau|; on both sides from < 0
  double sign;     // side of the origin
};

// Is the rule sufficient on the panel? In the disc about its middle that contains the panel's ellipse, neither x - source (q
// in the source's own panel) nor dx/deta of J may vanish; both are checked by the triangle inequality. The latter also where g
// is not wanted: h must not depend on what else is wanted.
bool resolved(const Integrator& in, const Expansion& x, const Stretch& p, bool own);

inline double squared(const double v[2]) { return v[0] * v[0] + v[1] * v[1]; }

// The parameter of the point nearest to the source, relative to the origin and within [lo, hi]; the expansion about it.
double nearest_parameter(const Expansion& x, double lo, double hi);
Expansion moved(const Expansion& x, double tau);

// Sums of the blocks, divided by k.
struct Sums {
  Tensor h[kElementNodes];
  Tensor g[kElementNodes];
};

// About parameter `origin`; the source is `node_eta` = origin exactly if at_source.
Expansion expand(const Integrator& in, double origin, double sx, double sy, bool at_source);
Sample sample(const Integrator& in, const Expansion& x, double tau);
// The points of rule `rule`, 0 to kLowerHalf.
struct RulePoints {
  const Sample* at;
  const double* weight;
  int count;
};
RulePoints rule_points(const Integrator& in, int rule, RuleSamples<false>& samples);
void finish(const Integrator& in, const Sums& sums, int singular, bool want_h, bool want_g, Blocks& out);

// Straight elements, constant J: closed forms. Likewise their sum over l without the source's own node. The sum without a
// singular node is valid for any path between the same ends that does not pass between source and chord.
void integrate_straight(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out);
void rigid_sum_chord(const Integrator& in, double sx, double sy, double sum[2][2]);
void rigid_sum_own_line(const Integrator& in, int singular, double sum[2][2]);

// Anything: Gauss rules on the whole element, or on panels that shrink towards the source.
void integrate_curved(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Samples* samples,
                      Blocks& out);

// The rule of the thesis's appendix A.
void integrate_thesis(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out);

// r of the element along which g is measured; in the plane without meaning.
inline double measured_radius(const Integrator& in, double eta) {
  return in.middle + eta * (in.d[0][0] + eta * (in.d[1][0] / 2.0 + eta * in.d[2][0] / 3.0));
}

// Vector polynomial d0 + d1 u + d2 u^2 about `origin` has no zero in the disc |u - origin| < radius, by the triangle
// inequality (sufficient, not necessary).
bool has_no_zero(const double d[3][2], double origin, double radius);

} // namespace c2d
