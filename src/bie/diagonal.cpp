// The diagonal blocks of a body of straight elements in closed form (METHOD 2.3, equation METHOD (2.4)).
//
// A translation needs no tractions, so int T ds over a path depends on its ends only. For a source on the boundary the path is
// the whole boundary except the elements at the source:
// 1. Rays from the source to the two ends of that path, images included.
// 2. Elements at the source: their sums without the singular part are subtracted.
// 3. The path: METHOD (2.4), where the angle grows by that of the material at the source.
// Cost: constant for each node, in place of one integral per element and node.
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course (diagonal by rigid-body motion).
#include "bie/diagonal.hpp"

#include "bie/integrals/integrals_detail.hpp"
#include "bie/panel.hpp"
#include "memory/config.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(RingPart);

namespace {

// Rays from a source to the start and the end of the boundary without the elements at it.
struct Rays {
  double start[2], end[2];
};

// From the source to the image of a geometry node.
void aim(const Model& m, int image, double x, double y, const double at[2], double ray[2]) {
  const double point[2] = {x / m.head->length_unit, y / m.head->length_unit};
  const Source p = mirrored_source(*m.head, image, point);
  ray[0] = p.x - at[0], ray[1] = p.y - at[1];
}

// Leaves out the elements at the node, and their images if the node is its own image: their own sums are subtracted from the
// diagonal. (A reflection reverses the direction of travel: where the element ends, its image starts.)
void leave_out(const ColumnSystem& system, const Integrator& any, int32_t node, int image, const double at[2], Rays& rays,
               double* diagonal) {
  const Model& m = system.model;
  const int b = system.body, f = m.head->function_nodes;
  int32_t ends[2];
  const int count = ends_at_node(m, b, node, ends);
  for (int n = 0; n < count; ++n) {
    const int32_t element = ends[n] / f;
    const int l = ends[n] % f;
    double x[kElementNodes], y[kElementNodes], own[2][2];
    element_coordinates(m, b, element, x, y);
    const bool to_start = f == 1 || l < f - 1, to_end = f == 1 || l > 0;
    if (to_start) aim(m, image, x[1], y[1], at, image == 0 ? rays.start : rays.end);
    if (to_end) aim(m, image, x[0], y[0], at, image == 0 ? rays.end : rays.start);
    rigid_sum_own_line(any, l, own);
    for (int i = 0; i < 4; ++i) diagonal[i] -= image_sign(image, i / 2) * image_sign(image, i % 2) * own[i / 2][i % 2];
  }
}

// Subtracts the path's integral from the diagonal.
void take_path_off(const Integrator& any, const Rays& rays, double* diagonal) {
  const double(&p)[2] = rays.start, (&q)[2] = rays.end;
  const double p2 = p[0] * p[0] + p[1] * p[1], q2 = q[0] * q[0] + q[1] * q[1];
  const double turn = atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
  // The angle of the path is between 0 and 2 pi; atan2 gives angles above pi as negative ones.
  const double alpha = -any.t2 * (turn < 0.0 ? turn + 2.0 * kPi : turn);
  const double beta = p[0] * p[1] / p2 - q[0] * q[1] / q2;
  const double gamma = 0.5 * ((q[0] * q[0] - q[1] * q[1]) / q2 - (p[0] * p[0] - p[1] * p[1]) / p2);
  double sum[2][2];
  store({alpha, beta, gamma, -0.5 * any.t1 * log(q2 / p2)}, any.k, sum);
  for (int i = 0; i < 4; ++i) diagonal[i] -= sum[i / 2][i % 2];
}

} // namespace

bool fill_diagonal_closed(const ColumnSystem& system, int32_t first_node, int32_t count) {
  const Model& m = system.model;
  if (kSmallCode || !system.batch) return false;
  if (is_axisymmetric(m)) return kRingPart.fill_ring_diagonal(system, first_node, count);
  if (system.quadrature != Quadrature::accurate || m.body[system.body].element_nodes != 2) return false;
  const int32_t lines = m.body[system.body].lines;
  Integrator& any = system.scratch->integrator; // material and functions are the same for all elements
  make_integrator(m, system.body, 0, system.quadrature, Measure::own_length, any);
  for (int32_t node = first_node; node < first_node + count; ++node) {
    const int32_t twin = system.twin[node];
    double* diagonal = system.diagonal + 4 * static_cast<int64_t>(node);
    const double* at = system.point + 2 * static_cast<int64_t>(node);
    if (twin == kSecondTwin || twin == kAxisNode) continue;
    Rays rays = {};
    int images = 0;
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image) || (image > 0 && !mirrored_source(*m.head, image, at).on_itself)) continue;
      ++images;
      leave_out(system, any, node, image, at, rays, diagonal);
      if (twin >= 0) leave_out(system, any, twin, image, at, rays, diagonal);
    }
    if (images <= 2) take_path_off(any, rays, diagonal); // on both lines of symmetry the node is fixed
  }
  return true;
}

} // namespace c2d
