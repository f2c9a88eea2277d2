// Right-hand sides of point loads: U(P, x_F) F at every source, and force and moment in the balances (METHOD 2.6). U is the
// kernel of METHOD (2.2), evaluated at one point in place of an integral.
// On bodies of revolution the force acts all round, or at a point of the axis (METHOD 21.8).
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course (fundamental solution, concentrated loads).

#include "bie/integrals/kernels.hpp"
#include "bie/panel.hpp"
#include "memory/math.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(HolePart);
C2D_USES(RingPart);

namespace {

void add_load_to_hole(const ColumnSystem& system, const Hole& hole, const Panel& panel, const PointLoad& load) {
  const double row = kHolePart.hole_load(system.model, system.body, hole, load);
  visit_hole(system, hole, [&](int32_t node, const double n[2]) {
    for (int i = 0; i < 2; ++i) panel.add(2 * node + i, panel.range.right + load.load_case, n[i] * row);
  });
}

} // namespace

void add_point_load(const ColumnSystem& system, const Hole* hole, const Panel& panel, const PointLoad& load) {
  if (hole) return add_load_to_hole(system, *hole, panel, load);
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.body[b];
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, b);
  const double scale = balance_scale(m) / (2.0 * shear_modulus(m, b) * unit), from[2] = {load.x / unit, load.y / unit};
  const double f[2] = {load.fx * scale, load.fy * scale};
  const int32_t column = panel.range.right + load.load_case;
  for (int32_t node = 0; node < body.nodes; ++node) {
    if (system.twin[node] == kSecondTwin || system.twin[node] == kAxisNode) continue;
    const double* at = system.point + 2 * static_cast<int64_t>(node);
    // The image of the load acts on P as the load acts on the mirrored P, METHOD (5.1).
    const int32_t lines = image_lines(m, b);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      double u[2][2];
      const Source p = mirrored_source(*m.head, image, at);
      const double rx = from[0] - p.x, ry = from[1] - p.y, seen[2] = {p.x, p.y};
      if (is_axisymmetric(m))
        kRingPart.ring_force(nu, from, seen, u);
      else
        store(displacement_kernel(rx, ry, rx * rx + ry * ry, 3.0 - 4.0 * nu), 1.0 / (4.0 * kPi * (1.0 - nu)), u);
      for (int i = 0; i < 2; ++i) panel.add(2 * node + i, column, image_sign(image, i) * (u[i][0] * f[0] + u[i][1] * f[1]));
    }
  }
  // Rows of the balances: the load is part of the sums METHOD (2.6).
  const double ax = (load.x - body.centre[0]) / unit, ay = (load.y - body.centre[1]) / unit;
  panel.add(2 * body.nodes, column, f[0]);
  panel.add(2 * body.nodes + 1, column, f[1]);
  panel.add(2 * body.nodes + 2, column, ax * f[1] - ay * f[0]);
}

} // namespace c2d
