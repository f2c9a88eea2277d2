#pragma once
// Integrals over one straight element for several sources at once, one source per lane of the vector registers: closed forms
// next to the element, series in its length over the distance elsewhere, with logarithm and arctangent of their own. One set
// of functions per instruction set (linalg/kernel.hpp); the same numbers as integrate(), to round-off.
#include "bie/deposits.hpp"
#include "bie/integrals/interior.hpp"
#include "linalg/kernel.hpp"

namespace c2d {

constexpr int kBatch = 8; // sources

// The blocks of integrals.hpp, [l][j][2 s + i]: as the rows of a column follow each other.
struct BatchBlocks {
  double h[kElementNodes][2][2 * kBatch];
  double g[kElementNodes][2][2 * kBatch];
};

// An element prepared for batches: ends, half-vector over its squared length, and the factors of everything that depends on
// the source. Names as in integrals.hpp.
struct BatchElement {
  double x0, y0, x1, y1, ux, uy;
  double h_alpha, h_delta, h_cos2, h_sin2; // -k t2, k t1, -k cos2, -k sin2
  double g_alpha, g_log, g_cos2, g_sin2;   // k J (1/2 - kappa ln|h|), k J kappa, -k J cos2, -k J sin2
  double g_half_cos2, g_half_sin2;         // k J cos2 / 2, k J sin2 / 2
  int functions;
};
BatchElement batch_element(const Integrator& in);

// The one column that receives a component of one local node, [kind][l][j] with h before g; null: none.
struct BatchColumns {
  Real* to[2][kElementNodes][2];
  double factor[2][kElementNodes][2];
};

// Batches of an element: sources at xy = x0 y0 x1 y1 ..., the first of which has rows 2 first and 2 first + 1 of the panel.
struct BatchRun {
  BatchElement element;
  const Deposits* deposits; // of `blocks`
  const Blocks* blocks;
  bool want_h, want_g;
  double sign[2];             // of the rows of an image
  const BatchColumns* direct; // the same deposits, see aim_columns(); null: one by one
};
// For deposits with at most one column per component and for the element itself, not an image: lists the columns in `out`.
void aim_columns(const BatchRun& run, BatchColumns& out);

// An element with its nodal values, for far points: names as in interior.hpp and interior_straight.cpp. 1 to 3 functions.
struct BatchFieldElement {
  double x0, y0, ux, uy, kappa;
  double k_t, k_log, k_d, k_s, half_k; // k J, k J kappa, k J/|h|, 2k/|h|, k/2
  Complex axis, axis2;                 // that and its square
  Complex t[3], u[3];
  Complex u0; // part of the displacement that does not depend on the point
  int functions;
  bool displaced;
};
// False if the element has no closed form, or too many functions.
bool batch_field_element(const FieldElement& e, BatchFieldElement& out);
struct BatchPoints {
  double x[kBatch], y[kBatch], reference_x[kBatch], reference_y[kBatch];
};
struct BatchField { // as PointField; near: 1 where the element is too near for the series, the rest is undefined there
  double ux[kBatch], uy[kBatch], trace[kBatch], deviator_re[kBatch], deviator_im[kBatch], near[kBatch];
  bool some_near;
};

// Rings (bie/rings/ring_batches.hpp): an element of a body of revolution, x and z of its first node, and a point of one
// of its rules from there on. Weights are those of T times -k/2 and of U times k/2, as the kernels are found without these
// factors.
struct BatchRing {
  double x, z, kappa, t1;
  int functions;
};
struct RingPoint {
  double x, z, r, nx, ny;
  double own, h[kElementNodes], g[kElementNodes]; // of T, with the functions; of U
};
// Points of a panel as one source sees them; squares of the factors by which their logarithm is split off (1: none).
// Names as above.
struct RingPanel {
  double a[kBatch], z[kBatch], nx[kBatch], ny[kBatch], stretch[kBatch], own[kBatch];
  double h[kElementNodes][kBatch], g[kElementNodes][kBatch];
};
// Sums of the lanes: the blocks [l][2 i + j], and what the motion along r adds to ring_sum().
struct RingSums {
  double h[kElementNodes][4][kBatch], g[kElementNodes][4][kBatch], motion[2][kBatch];
};

struct BatchKernel {
  // The blocks of the sources at xy, for an element with is_batched(). A source at one of the element's functional nodes gets
  // finite numbers without meaning. Blocks not wanted are not written.
  void (*integrate)(const BatchElement& e, const double* xy, bool want_h, bool want_g, BatchBlocks& out);
  // Scatters the blocks of one batch as its deposits say: of all sources, or of the first `count`.
  void (*scatter)(const BatchRun& run, int32_t first, int32_t count, const BatchBlocks& out);
  // Both for `count` sources, in whole batches, none at a functional node. `room` is work space.
  void (*integrate_and_scatter)(const BatchRun& run, const double* xy, int32_t first, int32_t count, BatchBlocks& room);
  // rigid_sum(): sum[4 s + 2 i + j].
  void (*rigid)(const BatchElement& e, const double* xy, double sum[4 * kBatch]);
  // Subtracts it from the diagonals of `count` sources, in whole batches.
  void (*rigid_off)(const BatchElement& e, const double* xy, int32_t count, double* diagonal);
  // add_field() for sums that start at 0.
  void (*field)(const BatchFieldElement& e, const BatchPoints& points, BatchField& out);
  // Rings: the blocks of the sources at xy by `count` points; ring_sum(), sum[4 s + 2 i + j]; the points of a panel, or
  // the factors of their logarithms.
  void (*rings)(const BatchRing& e, const RingPoint* points, int count, const double* xy, BatchBlocks& out);
  void (*ring_rigid)(const BatchRing& e, const RingPoint* points, int count, const double* xy, double sum[4 * kBatch]);
  void (*ring_panel)(const BatchRing& e, double radius, const RingPanel& p, bool logarithms, RingSums& sums);
  // Of kBatch numbers each: ln x, x > 0 and normal; atan2(y, x), 0 if both are.
  void (*logarithm)(const double* x, double* out);
  void (*angle)(const double* y, const double* x, double* out);
};

// Null for plain, and for a set that this build does not contain.
const BatchKernel* batch_for(Instructions set);

// Does the element have closed forms for the wanted integrals?
bool is_batched(const Integrator& in, bool want_g);

// One function per file with loops, see linalg/kernel_sets.hpp.
const BatchKernel* baseline_batch();
const BatchKernel* avx2_batch();
const BatchKernel* avx512_batch();

} // namespace c2d
