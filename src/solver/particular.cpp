#include "solver/particular.hpp"

#include "bie/body_force.hpp"
#include "model/shape.hpp"

namespace c2d {

namespace {

Particular particular_now(const Session& session, int b, double x, double y) {
  const Model& m = session.model;
  Particular sum = {{0.0, 0.0}, {0.0, 0.0, 0.0}};
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    const double f = session.follower.load[k];
    const Particular p = particular_solution(m, b, k, x, y);
    for (int c = 0; c < 2; ++c) sum.u[c] += f * p.u[c];
    for (int c = 0; c < 3; ++c) sum.stress[c] += f * p.stress[c];
  }
  return sum;
}

void particular_traction_now(const Session& session, int b, int32_t element, int l, double t[2]) {
  const Model& m = session.model;
  t[0] = t[1] = 0.0;
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    double part[2];
    particular_traction(m, b, k, element, l, part);
    for (int c = 0; c < 2; ++c) t[c] += session.follower.load[k] * part[c];
  }
}

Particular particular_at_node(const Session& session, int b, int32_t node) {
  double x, y;
  node_position(session.model, b, node, &x, &y);
  return particular_now(session, b, x, y);
}

} // namespace

void particular_at_end(const Session& session, int b, int32_t element, int l, double u[2], double t[2]) {
  const Particular p = particular_at_node(session, b, functional_node(session.model, b, element, l));
  u[0] = p.u[0];
  u[1] = p.u[1];
  particular_traction_now(session, b, element, l, t);
}

void interpolated_particular(const Session& session, int b, int32_t element, double eta, double u[2]) {
  const Model& m = session.model;
  double value[kElementNodes];
  shape(m.head->function_nodes, eta, value);
  u[0] = u[1] = 0.0;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const Particular p = particular_at_node(session, b, functional_node(m, b, element, l));
    for (int c = 0; c < 2; ++c) u[c] += value[l] * p.u[c];
  }
}

void add_particular_at(const Session& session, int b, const double at[2], double u[2], double stress[3]) {
  const double g = shear_modulus(session.model, b), unit = session.model.head->length_unit;
  const Particular p = particular_now(session, b, at[0], at[1]);
  for (int c = 0; c < 2; ++c) u[c] += p.u[c] / unit;
  stress[0] += 0.5 * (p.stress[0] + p.stress[1]) / g;
  stress[1] += 0.5 * (p.stress[0] - p.stress[1]) / g;
  stress[2] -= p.stress[2] / g;
}

} // namespace c2d
