// Element integrals of the ring kernels (METHOD 21.2) by the panels of curved elements (bie/integrals/integrals_panels.hpp).
//
// The kernels have the singularities of the plane ones at the source and at its reflection in the axis, which is at least as
// far away: rules and panels that are sufficient for the source are sufficient for both. In the panel at the source the
// logarithm is split off with its exact factor (ring_logarithms), of T as well. That factor has all digits only where r is not
// small against R: so this panel ends within 0.7 R of the source, which is near enough for the reflection too.
#include "bie/rings/ring_elements.hpp"

#include "bie/integrals/integrals_panels.hpp"
#include "bie/rings/ring_kernels.hpp"

namespace c2d {
namespace {

Tensor tensor_of(const double b[2][2]) {
  return {0.5 * (b[0][0] + b[1][1]), 0.5 * (b[0][0] - b[1][1]), 0.5 * (b[0][1] + b[1][0]), 0.5 * (b[0][1] - b[1][0])};
}

// out -= factor * k
void take(double factor, const RingMoments& k, RingMoments& out) {
  for (int i = 0; i < 2; ++i) out.n1[i] -= factor * k.n1[i];
  for (int i = 0; i < 3; ++i) out.n3[i] -= factor * k.n3[i];
  for (int i = 0; i < 4; ++i) out.n5[i] -= factor * k.n5[i];
}

// The ring kernels of one element, see integrals_panels.hpp. `motion` receives what the motion along r adds to ring_sum();
// null: not wanted.
struct RingElement {
  const Integrator& in;
  double radius; // of the source
  bool want_h, want_g;
  double* motion;

  RingPlace place(const Sample& s) const { return {radius, s.rx, s.ry}; }

  void add(const Sample& s, double weight, double scale, Sums& sums) const {
    RingMoments k = ring_moments(place(s));
    if (scale != 1.0 && has_logarithm()) take(2.0 * log(scale), ring_logarithms(place(s)), k);
    add_moments(s, k, weight, sums);
  }
  bool has_logarithm() const { return radius > 0.0; }
  void add_logarithm(const Sample& s, double to, double w, Sums& sums) const {
    add_moments(s, ring_logarithms(place(s)), 2.0 * to * w, sums);
  }

  void add_moments(const Sample& s, const RingMoments& k, double weight, Sums& sums) const {
    const RingMaterial material = {in.kappa, in.t1};
    const double n[2] = {s.nx, s.ny}, own = weight * (radius + s.rx);
    double u[2][2], t[2][2];
    if (want_g || motion) ring_displacement(place(s), k, material, u);
    if (want_h) ring_traction(place(s), k, material, n, t);
    if (want_g) {
      const double measured = weight * s.jacobian * measured_radius(in, s.eta);
      for (int l = 0; l < in.functions; ++l) c2d::add(sums.g[l], measured * s.shape[l], tensor_of(u));
    }
    if (want_h)
      for (int l = 0; l < in.functions; ++l) c2d::add(sums.h[l], own * s.shape[l], tensor_of(t));
    for (int i = 0; i < 2 && motion; ++i)
      motion[i] += own * (u[i][0] * n[0] - 2.0 * u[i][1] * n[1] - s.rx * t[i][0] + 2.0 * s.ry * t[i][1]);
  }

  bool resolved(const Expansion& x, const Stretch& p, bool own) const { return is_ring_resolved(in, radius, x, p, own); }
};

// The trace of the stress at a point off the boundary, see integrals_panels.hpp.
struct RingTrace {
  const Integrator& in;
  double radius; // of the point
  double (*h)[2], (*g)[2];

  void add(const Sample& s, double weight, double, Sums&) const {
    const RingPlace at = {radius, s.rx, s.ry};
    const double n[2] = {s.nx, s.ny}, factor = (2.0 - 0.5 * in.t2) * in.k * weight; // (1 + nu) k
    const double own = factor * (radius + s.rx), measured = factor * s.jacobian * measured_radius(in, s.eta);
    double u[2], t[2];
    ring_trace(at, ring_moments(at), n, u, t);
    for (int l = 0; l < in.functions; ++l)
      for (int i = 0; i < 2; ++i) {
        h[l][i] += own * s.shape[l] * u[i];
        g[l][i] += measured * s.shape[l] * t[i];
      }
  }
  bool has_logarithm() const { return false; }
  void add_logarithm(const Sample&, double, double, Sums&) const {}
  bool resolved(const Expansion& x, const Stretch& p, bool own) const { return c2d::resolved(in, x, p, own); }
};

} // namespace

bool is_ring_resolved(const Integrator& in, double radius, const Expansion& x, const Stretch& p, bool own) {
  if (!resolved(in, x, p, own)) return false;
  if (!own || !(radius > 0.0)) return true;
  const double tau = p.sign * p.to;
  double end[2];
  for (int i = 0; i < 2; ++i) end[i] = tau * (x.b[0][i] + tau * (x.b[1][i] + tau * x.b[2][i]));
  return squared(end) <= 0.5 * radius * radius;
}

void integrate_rings(const Integrator& in, double sx, double sy, int singular, bool want_h, bool want_g, Blocks& out) {
  Sums sums = {};
  add_element_integrals(RingElement{in, sx, want_h, want_g, nullptr}, sx, sy, singular, nullptr, sums);
  finish(in, sums, singular, want_h, want_g, out);
}

void ring_sum(const Integrator& in, double sx, double sy, int singular, double sum[2][2]) {
  sum[0][0] = sum[0][1] = sum[1][0] = sum[1][1] = 0.0;
  if (in.degenerate) return;
  Sums sums = {};
  double motion[2] = {0.0, 0.0};
  add_element_integrals(RingElement{in, sx, true, false, sx > 0.0 ? motion : nullptr}, sx, sy, singular, nullptr, sums);
  Blocks blocks;
  finish(in, sums, singular, true, false, blocks);
  for (int l = 0; l < in.functions; ++l)
    for (int i = 0; i < 4; ++i) sum[i / 2][i % 2] += blocks.h[l][i / 2][i % 2];
  for (int i = 0; i < 2 && sx > 0.0; ++i) sum[i][0] -= in.k * motion[i] / sx;
}

void add_ring_trace(const Integrator& in, double sx, double sy, double h[kElementNodes][2], double g[kElementNodes][2]) {
  if (in.degenerate) return;
  Sums none;
  add_element_integrals(RingTrace{in, sx, h, g}, sx, sy, -1, nullptr, none);
}

} // namespace c2d
