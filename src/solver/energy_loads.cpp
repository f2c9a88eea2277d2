// Point loads and body forces in the energy's functionals.
#include <math.h>

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "bie/kernels.hpp"
#include "bie/shape.hpp"
#include "bie/transfer.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"
#include "quadrature/gauss.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {

namespace {

// The boundary integrals hold for u - u_p and t - t_p: what the body forces' own part of an element takes off.
void take_particular(Adjoint& a, int32_t element, const Blocks& blocks, const double factor[2]) {
  const Model& m = a.model();
  for (int32_t k = 0; k < m.head->load_cases && has_body_force(m, a.b); ++k) {
    if (!is_loaded(body_force(m, a.b, k))) continue;
    for (int l = 0; l < m.head->function_nodes; ++l) {
      double x, y, t[2];
      node_position(m, a.b, functional_node(m, a.b, element, l), &x, &y);
      const Particular p = particular_solution(m, a.b, k, x, y);
      particular_traction(m, a.b, k, element, l, t);
      for (int c = 0; c < 2; ++c) {
        const double h = factor[0] * blocks.h[l][0][c] + factor[1] * blocks.h[l][1][c];
        const double g = factor[0] * blocks.g[l][0][c] + factor[1] * blocks.g[l][1][c];
        a.lambda[k] += h * p.u[c] / m.head->length_unit - g * t[c] / (2.0 * shear_modulus(m, a.b));
      }
    }
  }
}

// factor[i] times what an element's tractions and displacements do to the displacement at (x, y) in the length unit.
[[gnu::noinline]] void add_element_at(Adjoint& a, int32_t element, Measure measure, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  Integrator integrator;
  make_integrator(m, a.b, element, Quadrature::accurate, measure, integrator);
  const bool own = measure == Measure::own_length;
  Blocks blocks;
  integrate(integrator, at[0], at[1], -1, own, true, blocks);
  for (int l = 0; l < m.head->function_nodes; ++l)
    for (int c = 0; c < 2; ++c) {
      if (own)
        add_displacement(a, functional_node(m, a.b, element, l), c,
                         -factor[0] * blocks.h[l][0][c] - factor[1] * blocks.h[l][1][c]);
      const bool contact = a.b == 1 && traction_kind(m, a.b, element, l, c) == TractionKind::contact;
      if (contact == !own)
        add_traction(a, element, l, c, factor[0] * blocks.g[l][0][c] + factor[1] * blocks.g[l][1][c]);
    }
  if (own) take_particular(a, element, blocks, factor);
}

// The field of all point loads of the body.
void add_point_fields(Adjoint& a, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, a.b);
  const Box box = box_of_body(m, a.b);
  const double width = (m.head->symmetry & 1 ? 2.0 : 1.0) * (box.x_max - box.x_min),
               height = (m.head->symmetry & 2 ? 2.0 : 1.0) * (box.y_max - box.y_min);
  const double size = hypot(width, height) / unit; // of the whole body
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& other = m.point_load[i];
    if (other.body != a.b) continue;
    const double rx = other.x / unit - at[0], ry = other.y / unit - at[1], r2 = rx * rx + ry * ry;
    const bool own = r2 <= 1e-18 * size * size;
    const double scale = 1.0 / (2.0 * shear_modulus(m, a.b) * unit * 4.0 * kPi * (1.0 - nu));
    double u[2][2];
    store(own ? displacement_kernel(0.0, 0.0, 0.0, size * size, 3.0 - 4.0 * nu)
              : displacement_kernel(rx, ry, r2, 3.0 - 4.0 * nu),
          scale, u);
    for (int c = 0; c < 2; ++c)
      a.lambda[other.load_case] += factor[c] * (u[c][0] * other.fx + u[c][1] * other.fy);
  }
}

// The tractions that free zones hand over to body 1.
[[gnu::noinline]] void add_transferred_at(Adjoint& a, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  const double scale = -m.head->stress_unit / (2.0 * shear_modulus(m, 0));
  TransferWalk walk{};
  Transfer piece;
  Blocks blocks;
  while (next_transfer(m, Quadrature::accurate, walk, piece)) {
    integrate(piece.in, at[0], at[1], -1, false, true, blocks);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      if (piece.pair[l] < 0) continue;
      const Pair& pair = m.pair[piece.pair[l]];
      for (int c = 0; c < 2; ++c) {
        double sum = 0.0;
        for (int k = 0; k < piece.in.functions; ++k)
          sum += piece.weight[k][l] * (factor[0] * blocks.g[k][0][c] + factor[1] * blocks.g[k][1][c]);
        a.tau[pair.dof] += scale * sum * (c == 0 ? pair.nx : pair.ny);
        if (pair.tangential) a.tau[pair.dof + 1] += scale * sum * (c == 0 ? pair.ny : -pair.nx);
      }
    }
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
  for (int32_t element = 0; element < m.head->body[a.b].elements; ++element) {
    if (!is_integrated(m, a.b, element)) continue;
    add_element_at(a, element, Measure::own_length, at, factor);
    int32_t zone = 0, place = 0;
    if (a.b == 1 && find_contact_element(m, a.b, element, &zone, &place))
      add_element_at(a, element, Measure::contact, at, factor);
  }
  add_point_fields(a, at, factor);
  if (a.b == 0 && m.head->free_rows > 0) add_transferred_at(a, at, factor);
}

// t.u_p - t_p.u along one element, u_p and t_p those of case k.
[[gnu::noinline]] void add_particular(Adjoint& a, int32_t element, int32_t k) {
  const Model& m = a.model();
  const int nf = m.head->function_nodes;
  const double unit = m.head->length_unit, stress = m.head->stress_unit;
  double x[4], y[4], u[4][2] = {}, t[4][2] = {};
  element_coordinates(m, a.b, element, x, y);
  const Element e = make_element(body_of(m, a.b).element_nodes, x, y);
  const GaussRule rule = gauss_legendre(6);
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint g = gauss_point(rule, i);
    const Point p = element_point(e, g.x);
    const Particular s = particular_solution(m, a.b, k, p.x, p.y);
    const double traction[2] = {s.stress[0] * p.nx + s.stress[2] * p.ny, s.stress[2] * p.nx + s.stress[1] * p.ny};
    double value[4];
    shape(nf, g.x, value);
    for (int l = 0; l < nf; ++l)
      for (int c = 0; c < 2; ++c) {
        u[l][c] += g.w * p.jacobian * value[l] * s.u[c];
        t[l][c] += g.w * p.jacobian * value[l] * traction[c];
      }
  }
  for (int l = 0; l < nf; ++l)
    for (int c = 0; c < 2; ++c) {
      const bool contact = traction_kind(m, a.b, element, l, c) == TractionKind::contact;
      const double ratio = contact ? traction_ratio(m, a.b, element, l) : 1.0;
      add_traction(a, element, l, c, ratio * u[l][c] * 2.0 * shear_modulus(m, a.b) / (stress * unit * unit));
      add_displacement(a, functional_node(m, a.b, element, l), c, -t[l][c] / (stress * unit));
    }
}

} // namespace

void add_point_load(Adjoint& a, const PointLoad& load) {
  const Model& m = a.model();
  const Body& body = m.head->body[a.b];
  const double unit = m.head->length_unit;
  const double at[2] = {load.x / unit, load.y / unit};
  const double factor[2] = {load.fx / (m.head->stress_unit * unit), load.fy / (m.head->stress_unit * unit)};
  for (int image = 0; image <= m.head->symmetry; ++image)
    if (is_image(*m.head, image)) add_image_at(a, image, at, factor);
  const double dx = at[0] - body.centre[0] / unit, dy = at[1] - body.centre[1] / unit;
  add_outer(a, body.columns, factor[0]);
  add_outer(a, body.columns + 1, factor[1]);
  add_outer(a, body.columns + 2, factor[1] * dx - factor[0] * dy);
  for (int32_t k = 0; k < m.head->load_cases && has_body_force(m, a.b); ++k) {
    const Particular p = particular_solution(m, a.b, k, load.x, load.y);
    a.lambda[k] += (factor[0] * p.u[0] + factor[1] * p.u[1]) / unit;
  }
}

void add_body_force(Adjoint& a, int32_t k) {
  const Model& m = a.model();
  if (!is_loaded(body_force(m, a.b, k))) return;
  const double unit = m.head->stress_unit * m.head->length_unit * m.head->length_unit;
  for (int32_t element = 0; element < body_of(m, a.b).elements; ++element)
    if (is_integrated(m, a.b, element)) add_particular(a, element, k);
  for (int32_t i = 0; i < m.head->load_cases; ++i) a.lambda[i] += body_force_work(m, a.b, i, k) / unit;
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& load = m.point_load[i];
    if (load.body != a.b) continue;
    const Particular p = particular_solution(m, a.b, k, load.x, load.y);
    a.lambda[load.load_case] += (load.fx * p.u[0] + load.fy * p.u[1]) / unit;
  }
}

} // namespace c2d
