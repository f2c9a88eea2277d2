// Elements in the units of the equations, and the length per which a traction on them is measured (METHOD 9.1). In an ordinary
// zone tau is per length of one side. The integrals over the other side use the Jacobian of the facing element, so both bodies
// receive the same force, although their elements differ in length.
#include "bie/measure.hpp"

#include "model/shape.hpp"

namespace c2d {

namespace {

Element scaled_element(const Model& m, int b, int32_t element) {
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  const int nodes = m.body[b].element_nodes;
  for (int k = 0; k < nodes; ++k) {
    x[k] /= m.head->length_unit;
    y[k] /= m.head->length_unit;
  }
  return make_element(nodes, x, y);
}

// The element of side 0 that faces a contact element of side 1; element -1 if there is none.
struct Facing {
  int32_t body;
  int32_t element;
  bool reversed;
};
Facing facing_element(const Model& m, int b, int32_t element) {
  ZonePlace at{};
  find_contact_element(m, b, element, &at);
  if (at.side != 1) return Facing{0, -1, false};
  const Zone& z = m.zone[at.zone];
  if (z.is_free != 0) return Facing{0, -1, false}; // there tau is per length of side 1
  return Facing{z.body[0], zone_element(m, z, 0, at.place), z.element_step[0] != z.element_step[1]};
}

} // namespace

void make_integrator(const Model& m, int b, int32_t element, Quadrature quadrature, Measure measure, Integrator& out) {
  prepare(out, scaled_element(m, b, element), m.head->function_nodes, strain_poisson_ratio(m, b), quadrature);
  if (is_axisymmetric(m) && measure != Measure::section) set_axis(out, m.head->length_unit);
  if (measure != Measure::contact) return;
  const Facing facing = facing_element(m, b, element);
  if (facing.element >= 0) set_arc(out, scaled_element(m, facing.body, facing.element), facing.reversed);
}

void end_resultants(const Model& m, int b, int32_t element, Measure measure, EndResultant out[kElementNodes]) {
  Integrator integrator;
  make_integrator(m, b, element, Quadrature::accurate, measure, integrator);
  double w[kElementNodes], wx[kElementNodes], wy[kElementNodes];
  resultants(integrator, 0.0, 0.0, w, wx, wy);
  for (int l = 0; l < m.head->function_nodes; ++l) out[l] = EndResultant{w[l], wx[l], wy[l]};
}

bool next_contact_end(const Model& m, int b, ContactEnd& end) {
  for (++end.l; end.element < end_of_elements(m, b); ++end.element, end.l = 0) {
    ZonePlace place;
    if (!find_contact_element(m, b, end.element, &place)) continue;
    if (end.l == 0) end_resultants(m, b, end.element, Measure::contact, end.of_element);
    for (; end.l < m.head->function_nodes; ++end.l) {
      end.at = pair_of_end(m, b, end.element, end.l);
      if (end.at.pair >= 0) return true;
    }
  }
  return false;
}

double traction_ratio(const Model& m, int b, int32_t element, int l) {
  const Facing facing = facing_element(m, b, element);
  if (facing.element < 0) return 1.0;
  const double eta = node_eta(m.head->function_nodes, l);
  const Point own = element_point(scaled_element(m, b, element), eta);
  const Point other = element_point(scaled_element(m, facing.body, facing.element), facing.reversed ? -eta : eta);
  return other.jacobian / own.jacobian;
}

} // namespace c2d
