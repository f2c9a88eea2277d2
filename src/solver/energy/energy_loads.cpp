// Point loads in the energy's functionals.

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/shape.hpp"
#include "model/symmetry.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(BodyForcePart);
C2D_USES(RingPart);

namespace {

// factor[i] times what an element's tractions and displacements do to the displacement at (x, y) in the length unit.
[[gnu::noinline]] void add_element_at(Adjoint& a, int32_t element, Measure measure, const double at[2],
                                      const double factor[2]) {
  const Model& m = a.model();
  if (!kSmallCode && a.cases) {
    a.from = static_cast<int32_t>(a.cases[2 * element]);
    a.end = static_cast<int32_t>(a.cases[2 * element + 1]);
  }
  Integrator integrator;
  make_integrator(m, a.b, element, Quadrature::accurate, measure, integrator);
  const bool own = measure == Measure::own_length;
  Blocks blocks;
  integrate(integrator, at[0], at[1], -1, own, true, blocks);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t node = functional_node(m, a.b, element, l);
    Unknown unknown[2];
    unknowns_at(m, a.b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      if (own) add_displacement(a, node, c, unknown[c], -factor[0] * blocks.h[l][0][c] - factor[1] * blocks.h[l][1][c]);
      const TractionKind kind = traction_kind(m, a.b, element, l, c, unknown[c]);
      const bool contact = kind == TractionKind::contact && pair_of_end(m, a.b, element, l).side == 1;
      if (contact == !own) add_traction(a, element, l, c, kind, factor[0] * blocks.g[l][0][c] + factor[1] * blocks.g[l][1][c]);
    }
  }
  if (own && has_body_force(m, a.b)) kBodyForcePart.take_particular(a, element, blocks, factor);
  visit_all_cases(a);
}

// The field of all point loads of the body.
void add_point_fields(Adjoint& a, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, a.b);
  const Box box = box_of_body(m, a.b);
  const double width = (m.body[a.b].lines & 1 ? 2.0 : 1.0) * (box.x_max - box.x_min),
               height = (m.body[a.b].lines & 2 ? 2.0 : 1.0) * (box.y_max - box.y_min);
  const double size = hypot(width, height) / unit; // of the whole body
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& other = m.point_load[i];
    if (other.body != a.b) continue;
    const double rx = other.x / unit - at[0], ry = other.y / unit - at[1], r2 = rx * rx + ry * ry;
    const bool own = r2 <= 1e-18 * size * size;
    double scale = 1.0 / (2.0 * shear_modulus(m, a.b) * unit * 4.0 * kPi * (1.0 - nu)), u[2][2];
    if (is_axisymmetric(m)) {
      scale = balance_scale(m) / (2.0 * shear_modulus(m, a.b) * unit);
      const double from[2] = {other.x / unit, other.y / unit}, seen[2] = {at[0], own ? from[1] + size : at[1]};
      kRingPart.ring_force(nu, from, seen, u);
      for (int k = 0; k < 4; ++k) u[k / 2][k % 2] *= scale;
    } else
      store(own ? displacement_kernel(0.0, 0.0, 0.0, size * size, 3.0 - 4.0 * nu)
                : displacement_kernel(rx, ry, r2, 3.0 - 4.0 * nu),
            scale, u);
    for (int c = 0; c < 2; ++c) a.lambda[other.load_case] += factor[c] * (u[c][0] * other.fx + u[c][1] * other.fy);
  }
}

// All elements and point loads as one of their images, which act as they themselves at the mirrored point, mirrored.
void add_image_at(Adjoint& a, int image, const double point[2], const double force[2]) {
  const Model& m = a.model();
  double at[2], factor[2];
  for (int c = 0; c < 2; ++c) {
    at[c] = (image >> c & 1) != 0 ? 2.0 * (m.head->line_at[c] / m.head->length_unit) - point[c] : point[c];
    factor[c] = image_sign(image, c) * force[c];
  }
  for (int32_t element = 0; element < m.body[a.b].elements; ++element) {
    if (!is_integrated(m, a.b, element)) continue;
    add_element_at(a, element, Measure::own_length, at, factor);
    ZonePlace place;
    if (find_contact_element(m, a.b, element, &place) && place.side == 1)
      add_element_at(a, element, Measure::contact, at, factor);
  }
  add_point_fields(a, at, factor);
  if (m.body[a.b].free_rows > 0) kFreeZonePart.add_transferred_at(a, at, factor);
}

} // namespace

void add_point_load(Adjoint& a, const PointLoad& load) {
  const Model& m = a.model();
  const Body& body = m.body[a.b];
  const double unit = m.head->length_unit;
  const double at[2] = {load.x / unit, load.y / unit};
  const double factor[2] = {load.fx / (m.head->stress_unit * unit), load.fy / (m.head->stress_unit * unit)};
  const int32_t lines = image_lines(m, a.b);
  for (int image = 0; image <= lines; ++image)
    if (is_image(lines, image)) add_image_at(a, image, at, factor);
  const double dx = at[0] - body.centre[0] / unit, dy = at[1] - body.centre[1] / unit;
  add_outer(a, body.columns, factor[0]);
  add_outer(a, body.columns + 1, factor[1]);
  add_outer(a, body.columns + 2, factor[1] * dx - factor[0] * dy);
  if (has_body_force(m, a.b)) kBodyForcePart.add_particular_at_load(a, load, factor);
}

} // namespace c2d
