// Right-hand sides of point loads and body forces.
#include <math.h>

#include "bie/body_force.hpp"
#include "bie/kernels.hpp"
#include "bie/panel.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

void add_load_to_hole(const ColumnSystem& system, const Hole& hole, const Panel& panel, const PointLoad& load) {
  const double row = hole_load(system.model, system.body, hole, load);
  visit_hole(system, hole, [&](int32_t node, const double n[2]) {
    for (int i = 0; i < 2; ++i) panel.add(2 * node + i, panel.range.right + load.load_case, n[i] * row);
  });
}

} // namespace

void add_point_load(const ColumnSystem& system, const Hole* hole, const Panel& panel, const PointLoad& load) {
  if (hole) return add_load_to_hole(system, *hole, panel, load);
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.head->body[b];
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, b);
  const double scale = 1.0 / (2.0 * shear_modulus(m, b) * unit);
  const double f[2] = {load.fx * scale, load.fy * scale};
  const int32_t column = panel.range.right + load.load_case;
  for (int32_t node = 0; node < body.nodes; ++node) {
    if (system.twin[node] == kSecondTwin || system.twin[node] == kAxisNode) continue;
    const double* at = system.point + 2 * static_cast<int64_t>(node);
    for (int image = 0; image <= m.head->symmetry; ++image) {
      if (!is_image(*m.head, image)) continue;
      double u[2][2];
      const Source p = mirrored_source(*m.head, image, at);
      const double rx = load.x / unit - p.x, ry = load.y / unit - p.y;
      store(displacement_kernel(rx, ry, rx * rx + ry * ry, 3.0 - 4.0 * nu), 1.0 / (4.0 * kPi * (1.0 - nu)), u);
      for (int i = 0; i < 2; ++i)
        panel.add(2 * node + i, column, image_sign(image, i) * (u[i][0] * f[0] + u[i][1] * f[1]));
    }
  }
  const double ax = (load.x - body.centre[0]) / unit, ay = (load.y - body.centre[1]) / unit;
  panel.add(2 * body.nodes, column, f[0]);
  panel.add(2 * body.nodes + 1, column, f[1]);
  panel.add(2 * body.nodes + 2, column, ax * f[1] - ay * f[0]);
}

namespace {

// H u_p - G t_p of one element, into the right-hand side of one load case.
void add_particular(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t element, int32_t load_case) {
  const Model& m = system.model;
  const int b = system.body, nf = m.head->function_nodes;
  Real* column = panel.column(panel.range.right + load_case);
  make_integrator(m, b, element, system.quadrature, Measure::own_length, system.scratch->integrator);
  const Blocks& blocks = system.scratch->blocks;
  Deposits& deposits = system.scratch->deposits;
  deposits.count = 0;
  int32_t node[4];
  for (int l = 0; l < nf; ++l) {
    node[l] = functional_node(m, b, element, l);
    double x, y, t[2];
    node_position(m, b, node[l], &x, &y);
    const Particular p = particular_solution(m, b, load_case, x, y);
    particular_traction(m, b, load_case, element, l, t);
    for (int c = 0; c < 2; ++c) {
      deposits.add(&blocks.h[l][0][c], column, p.u[c] / m.head->length_unit);
      deposits.add(&blocks.g[l][0][c], column, -t[c] / (2.0 * shear_modulus(m, b)));
    }
  }
  if (deposits.count > 0) pay_sources(system, hole, node, true, true);
}

} // namespace

// What the body force of a load case adds to its right-hand side: the equations hold for u - u_p and t - t_p.
void add_body_force(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t load_case) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.head->body[b];
  const int32_t column = panel.range.right + load_case;
  if (!panel.range.holds(column) || !is_loaded(body_force(m, b, load_case))) return;
  for (int32_t element = 0; element < body.elements; ++element)
    if (is_integrated(m, b, element)) add_particular(system, hole, panel, element, load_case);
  if (hole) return;
  for (int32_t node = 0; node < body.nodes; ++node) {
    if (system.twin[node] == kSecondTwin || system.twin[node] == kAxisNode) continue;
    double x, y;
    node_position(m, b, node, &x, &y);
    const Particular p = particular_solution(m, b, load_case, x, y);
    const double* block = system.diagonal + 4 * static_cast<int64_t>(node);
    for (int i = 0; i < 2; ++i)
      panel.add(2 * node + i, column, (block[2 * i] * p.u[0] + block[2 * i + 1] * p.u[1]) / m.head->length_unit);
  }
  double force[3];
  body_force_resultant(m, b, load_case, body.centre[0], body.centre[1], force);
  const double scale = 1.0 / (2.0 * shear_modulus(m, b) * m.head->length_unit);
  for (int i = 0; i < 2; ++i) panel.add(2 * body.nodes + i, column, scale * force[i]);
  panel.add(2 * body.nodes + 2, column, scale * force[2] / m.head->length_unit);
}

} // namespace c2d
