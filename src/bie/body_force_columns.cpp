// Right-hand sides of body forces: H u_p - G t_p, moved to the right, and the force and moment of the body force in the
// balances (METHOD (6.1)). An optional part (memory/parts.hpp).
#include "bie/body_force.hpp"
#include "bie/panel.hpp"

namespace c2d {

void add_particular(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t element, int32_t load_case) {
  const Model& m = system.model;
  const int b = system.body, nf = m.head->function_nodes;
  Real* column = panel.column(panel.range.right + load_case);
  make_integrator(m, b, element, system.quadrature, Measure::own_length, system.scratch->integrator);
  const Blocks& blocks = system.scratch->blocks;
  Deposits& deposits = system.scratch->deposits;
  deposits.count = 0;
  int32_t node[kElementNodes];
  for (int l = 0; l < nf; ++l) {
    node[l] = functional_node(m, b, element, l);
    double x, y, t[2];
    node_position(m, b, node[l], &x, &y);
    const Particular p = particular_solution(m, b, load_case, x, y);
    particular_traction(m, b, load_case, element, l, t);
    for (int c = 0; c < 2; ++c) {
      // u_p and t_p are interpolated like any displacement and traction of the element.
      deposits.add(&blocks.h[l][0][c], column, p.u[c] / m.head->length_unit);
      deposits.add(&blocks.g[l][0][c], column, -t[c] / (2.0 * shear_modulus(m, b)));
    }
  }
  system.scratch->targets.shared = false;
  if (deposits.count > 0) scatter_sources(system, hole, node, true, true);
}

// The body force of one load case in its right-hand side: METHOD (2.5) is valid for u - u_p and t - t_p.
void add_body_force_columns(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t load_case) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.body[b];
  const int32_t column = panel.range.right + load_case;
  if (!panel.range.contains(column) || !is_loaded(body_force(m, b, load_case))) return;
  const bool elsewhere = !kSmallCode && system.rest && !hole;
  for (int32_t element = 0; element < body.elements && !elsewhere; ++element)
    if (is_integrated(m, b, element)) add_particular(system, hole, panel, element, load_case);
  if (hole) return;
  // The diagonal block acts on u_p as it does on u.
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
  const double scale = balance_scale(m) / (2.0 * shear_modulus(m, b) * m.head->length_unit);
  for (int i = 0; i < 2; ++i) panel.add(2 * body.nodes + i, column, scale * force[i]);
  panel.add(2 * body.nodes + 2, column, scale * force[2] / m.head->length_unit);
}

} // namespace c2d
