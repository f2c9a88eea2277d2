// Near and singular integrals of rings with the points of a panel in the lanes of a vector (METHOD 21.2): as ring_elements.cpp,
// by the loops of bie/integrals/ring_loops.hpp. The factor of the logarithm is a polynomial there, at any distance.
#include "bie/integrals/batch.hpp"
#include "bie/integrals/integrals_panels.hpp"
#include "bie/rings/ring_elements.hpp"

namespace c2d {
namespace {

// Points on their way to the loops: those of the kernels, and those of the factors of the logarithm.
struct Waiting {
  RingPanel panel;
  int count;
};
struct Lanes {
  Waiting waiting[2];
  RingSums sums;
};

struct RingPanels { // see integrals_panels.hpp
  const Integrator& in;
  const BatchKernel& kernel;
  double radius; // of the source
  Lanes& lanes;

  bool has_logarithm() const { return radius > 0.0; }
  void add(const Sample& s, double weight, double scale, Sums&) const {
    take(lanes.waiting[0], s, weight, has_logarithm() ? scale * scale : 1.0);
  }
  void add_logarithm(const Sample& s, double to, double w, Sums&) const { take(lanes.waiting[1], s, 2.0 * to * w, 1.0); }
  bool resolved(const Expansion& x, const Stretch& p, bool own) const { return is_ring_resolved(in, radius, x, p, own); }

  void take(Waiting& w, const Sample& s, double weight, double stretch) const {
    const int i = w.count++;
    RingPanel& p = w.panel;
    p.a[i] = s.rx, p.z[i] = s.ry, p.nx[i] = s.nx, p.ny[i] = s.ny, p.stretch[i] = stretch;
    p.own[i] = -0.5 * in.k * weight * (radius + s.rx);
    const double measured = 0.5 * in.k * weight * s.jacobian * measured_radius(in, s.eta);
    for (int l = 0; l < in.functions; ++l) p.h[l][i] = p.own[i] * s.shape[l], p.g[l][i] = measured * s.shape[l];
    if (w.count == kBatch) flush(w);
  }
  // Lanes that are left get the first one's place, and no weight.
  void flush(Waiting& w) const {
    if (w.count == 0) return;
    RingPanel& p = w.panel;
    for (int i = w.count; i < kBatch; ++i) {
      p.a[i] = p.a[0], p.z[i] = p.z[0], p.nx[i] = p.nx[0], p.ny[i] = p.ny[0], p.stretch[i] = p.stretch[0];
      p.own[i] = 0.0;
      for (int l = 0; l < in.functions; ++l) p.h[l][i] = p.g[l][i] = 0.0;
    }
    const BatchRing element = {0.0, 0.0, in.kappa, in.t1, in.functions};
    kernel.ring_panel(element, radius, p, &w == &lanes.waiting[1], lanes.sums);
    w.count = 0;
  }
};

double sum_of(const double lane[kBatch]) {
  double sum = 0.0;
  for (int i = 0; i < kBatch; ++i) sum += lane[i];
  return sum;
}

void run_panels(const Integrator& in, const BatchKernel& kernel, double sx, double sy, int singular, Lanes& lanes) {
  lanes.sums = RingSums();
  lanes.waiting[0].count = lanes.waiting[1].count = 0;
  const RingPanels panels = {in, kernel, sx, lanes};
  Sums none;
  add_element_integrals(panels, sx, sy, singular, nullptr, none);
  for (Waiting& w : lanes.waiting) panels.flush(w);
}

} // namespace

void integrate_ring_panels(const Integrator& in, const BatchKernel& kernel, double sx, double sy, int singular, bool want_h,
                           bool want_g, Blocks& out) {
  Lanes lanes;
  run_panels(in, kernel, sx, sy, singular, lanes);
  for (int l = 0; l < in.functions; ++l)
    for (int i = 0; i < 4; ++i) {
      if (want_h) out.h[l][i / 2][i % 2] = l == singular ? 0.0 : sum_of(lanes.sums.h[l][i]);
      if (want_g) out.g[l][i / 2][i % 2] = sum_of(lanes.sums.g[l][i]);
    }
}

void ring_panel_sum(const Integrator& in, const BatchKernel& kernel, double sx, double sy, int singular, double sum[2][2]) {
  Lanes lanes;
  run_panels(in, kernel, sx, sy, singular, lanes);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      sum[i][j] = 0.0;
      for (int l = 0; l < in.functions; ++l)
        if (l != singular) sum[i][j] += sum_of(lanes.sums.h[l][2 * i + j]);
    }
    if (sx > 0.0) sum[i][0] += sum_of(lanes.sums.motion[i]) / sx;
  }
}

} // namespace c2d
