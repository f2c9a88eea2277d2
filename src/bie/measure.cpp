#include "bie/measure.hpp"

#include "model/shape.hpp"

namespace c2d {

namespace {

Element scaled_element(const Model& m, int b, int32_t element) {
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  const int nodes = m.head->body[b].element_nodes;
  for (int k = 0; k < nodes; ++k) {
    x[k] /= m.head->length_unit;
    y[k] /= m.head->length_unit;
  }
  return make_element(nodes, x, y);
}

// The element of body 1 that faces a contact element of body 2; -1 if there is none.
int32_t facing_element(const Model& m, int b, int32_t element, bool* reversed) {
  int32_t zone = 0, place = 0;
  if (b != 1 || !find_contact_element(m, b, element, &zone, &place)) return -1;
  const Zone& z = m.zone[zone];
  if (z.is_free != 0) return -1; // tau is per length of body 2
  *reversed = z.element_step[0] != z.element_step[1];
  return zone_element(m, z, 0, place);
}

} // namespace

void make_integrator(const Model& m, int b, int32_t element, Quadrature quadrature, Measure measure, Integrator& out) {
  prepare(out, scaled_element(m, b, element), m.head->function_nodes, strain_poisson_ratio(m, b), quadrature);
  if (measure == Measure::own_length) return;
  bool reversed = false;
  const int32_t facing = facing_element(m, b, element, &reversed);
  if (facing >= 0) set_arc(out, scaled_element(m, 0, facing), reversed);
}

void end_resultants(const Model& m, int b, int32_t element, Measure measure, EndResultant out[kElementNodes]) {
  Integrator integrator;
  make_integrator(m, b, element, Quadrature::accurate, measure, integrator);
  double w[kElementNodes], wx[kElementNodes], wy[kElementNodes];
  resultants(integrator, 0.0, 0.0, w, wx, wy);
  for (int l = 0; l < m.head->function_nodes; ++l) out[l] = EndResultant{w[l], wx[l], wy[l]};
}

double traction_ratio(const Model& m, int b, int32_t element, int l) {
  bool reversed = false;
  const int32_t facing = facing_element(m, b, element, &reversed);
  if (facing < 0 || pair_of_end(m, b, element, l) < 0) return 1.0;
  const double eta = node_eta(m.head->function_nodes, l);
  const Point own = element_point(scaled_element(m, b, element), eta);
  const Point other = element_point(scaled_element(m, 0, facing), reversed ? -eta : eta);
  return other.jacobian / own.jacobian;
}

} // namespace c2d
