// What multiplies tau, w' and lambda in the work and reaction of every load case (solver/energy.hpp).
#include <math.h>

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "bie/kernels.hpp"
#include "bie/shape.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"
#include "quadrature/gauss.hpp"
#include "solver/energy.hpp"

namespace c2d {

namespace {

// One functional while it is put together.
struct Adjoint {
  Session& session;
  int b;             // the body at hand
  double* tau;       // [m]
  double* motion;    // [m] of w'
  double* lambda;    // [cases]
  Real* u;           // [m] of the body's contact displacements
  Real* outer;       // of its outer unknowns
  bool touched;      // outer is not all zero
  const Model& model() const { return session.model; }
};

void add_outer(Adjoint& a, int32_t column, double factor) {
  a.outer[column] += static_cast<Real>(factor);
  a.touched = true;
}

// factor times a displacement component, in the length unit.
void add_displacement(Adjoint& a, int32_t node, int c, double factor) {
  const Model& m = a.model();
  const Unknown unknown = unknown_at(m, a.b, node, c);
  if (unknown.kind == UnknownKind::contact) {
    const Pair& pair = m.pair[pair_of_node(m, a.b, node)];
    a.u[pair.dof] += static_cast<Real>(factor * (c == 0 ? pair.nx : pair.ny));
    if (pair.tangential) a.u[pair.dof + 1] += static_cast<Real>(factor * (c == 0 ? pair.ny : -pair.nx));
  } else if (unknown.kind == UnknownKind::displacement) {
    add_outer(a, outer_column(m, a.b, node, c), factor);
  } else {
    const int64_t nodes = m.head->body[a.b].nodes;
    for (int32_t k = 0; k < m.head->load_cases; ++k)
      a.lambda[k] += factor * m.node_disp[a.b][(k * nodes + node) * 2 + c] / m.head->length_unit;
  }
}

enum class TractionKind { contact, solved, given };
TractionKind traction_kind(const Model& m, int b, int32_t element, int l, int c) {
  const int32_t end = element * m.head->function_nodes + l;
  const Unknown unknown = unknown_at(m, b, functional_node(m, b, element, l), c);
  if (unknown.kind == UnknownKind::contact && pair_of_end(m, b, element, l) >= 0) return TractionKind::contact;
  const bool first = unknown.end[0] == end, second = unknown.end[1] == end;
  if (unknown.kind == UnknownKind::traction && first) return TractionKind::solved;
  if (unknown.kind == UnknownKind::shared_traction && (first || second)) return TractionKind::solved;
  return TractionKind::given;
}

// factor times a traction component at an end, in 2 G of the body (a contact one in its own measure).
void add_traction(Adjoint& a, int32_t element, int l, int c, double factor) {
  const Model& m = a.model();
  const double modulus = 2.0 * shear_modulus(m, a.b);
  const int32_t end = element * m.head->function_nodes + l;
  switch (traction_kind(m, a.b, element, l, c)) {
  case TractionKind::contact: {
    const Pair& pair = m.pair[pair_of_end(m, a.b, element, l)];
    const double scaled = (a.b == 1 ? 1.0 : -1.0) * factor * m.head->stress_unit / modulus;
    a.tau[pair.dof] += scaled * (c == 0 ? pair.nx : pair.ny);
    if (pair.tangential) a.tau[pair.dof + 1] += scaled * (c == 0 ? pair.ny : -pair.nx);
    return;
  }
  case TractionKind::solved: {
    add_outer(a, outer_column(m, a.b, functional_node(m, a.b, element, l), c), factor);
    return;
  }
  case TractionKind::given: {
    const int64_t ends = static_cast<int64_t>(m.head->body[a.b].elements) * m.head->function_nodes;
    for (int32_t k = 0; k < m.head->load_cases; ++k)
      a.lambda[k] += factor * m.end_traction[a.b][(k * ends + end) * 2 + c] / modulus;
  }
  }
}

double given_traction(const Model& m, int b, int32_t element, int l, int c, int32_t k) {
  const int64_t ends = static_cast<int64_t>(m.head->body[b].elements) * m.head->function_nodes;
  return m.end_traction[b][(k * ends + static_cast<int64_t>(element) * m.head->function_nodes + l) * 2 + c];
}
double given_displacement(const Model& m, int b, int32_t node, int c, int32_t k) {
  return m.node_disp[b][(static_cast<int64_t>(k) * m.head->body[b].nodes + node) * 2 + c];
}

// Tractions of case k times displacements, or reactions times prescribed displacements of case k.
void add_boundary(Adjoint& a, int32_t k, bool reactions) {
  const Model& m = a.model();
  for (int32_t element = 0; element < m.head->body[a.b].elements; ++element) {
    if (!is_integrated(m, a.b, element)) continue;
    EndResultant weight[4];
    bool known = false;
    for (int l = 0; l < m.head->function_nodes; ++l)
      for (int c = 0; c < 2; ++c) {
        const int32_t node = functional_node(m, a.b, element, l);
        const TractionKind kind = traction_kind(m, a.b, element, l, c);
        if (kind != (reactions ? TractionKind::solved : TractionKind::given)) continue;
        const double value = reactions ? given_displacement(m, a.b, node, c, k) / m.head->length_unit
                                       : given_traction(m, a.b, element, l, c, k) / m.head->stress_unit;
        if (value == 0.0) continue;
        if (!known) end_resultants(m, a.b, element, Measure::own_length, weight);
        known = true;
        if (reactions)
          add_traction(a, element, l, c, weight[l].w * value * 2.0 * shear_modulus(m, a.b) / m.head->stress_unit);
        else
          add_displacement(a, node, c, weight[l].w * value);
      }
  }
}

// ---- point loads --------------------------------------------------------------------------------------------------

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
void add_element_at(Adjoint& a, int32_t element, Measure measure, const double at[2], const double factor[2]) {
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
void add_transferred_at(Adjoint& a, const double at[2], const double factor[2]) {
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

// Its force times the displacement there, from the boundary integrals (the interior form of the equations).
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

// ---- body forces --------------------------------------------------------------------------------------------------

// t.u_p - t_p.u along one element, u_p and t_p those of case k.
void add_particular(Adjoint& a, int32_t element, int32_t k) {
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

// What holds the rigid body 1 against the contact, times its motion in case k.
void add_rigid_motion(Adjoint& a, int32_t k) {
  const Model& m = a.model();
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    const Pair& pair = m.pair[i];
    double v[2];
    rigid_motion_at_pair(m, pair, k, v);
    for (int32_t d = 0; d <= pair.tangential; ++d) a.tau[pair.dof + d] += pair.weight * v[d];
  }
}

// Pressures times the overlaps that case k closes.
void add_overlaps(const Model& m, double* tau) {
  for (int32_t i = 0; i < m.head->pairs; ++i)
    tau[m.pair[i].dof] += m.pair[i].weight * m.pair[i].overlap / m.head->length_unit;
}

// ---- one functional -------------------------------------------------------------------------------------------------

c2d_status add_body(Adjoint& a, int32_t k, bool reactions) {
  const Model& m = a.model();
  const int32_t contact = m.head->contact;
  const PathArea& area = a.session.area;
  a.u = area.u[a.b];
  a.touched = false;
  for (int32_t j = 0; j < contact; ++j) a.u[j] = 0;
  for (int32_t i = 0; i < outer_columns(m, a.b) && !is_rigid(m, a.b); ++i) a.outer[i] = 0;
  if (is_rigid(m, a.b)) {
    if (reactions) add_rigid_motion(a, k);
    return C2D_OK;
  }
  add_boundary(a, k, reactions);
  for (int32_t i = 0; i < m.head->point_loads && !reactions; ++i)
    if (m.point_load[i].body == a.b && m.point_load[i].load_case == k) add_point_load(a, m.point_load[i]);
  if (!reactions) add_body_force(a, k);
  if (!a.touched) return C2D_OK;
  c2d_solver* s = a.session.solver;
  const c2d_status status = transposed_functional(s->plan[a.b], s->tapes, a.outer, area.coefficient, area.work);
  if (status != C2D_OK) return status;
  const Real* w = area.coefficient; // of -u_c, t_c = +-tau, lambda
  const double side = a.b == 1 ? 1.0 : -1.0;
  for (int32_t j = 0; j < contact; ++j) {
    a.u[j] -= w[j];
    a.tau[j] += side * static_cast<double>(w[contact + j]);
  }
  for (int32_t i = 0; i < m.head->load_cases; ++i) a.lambda[i] += static_cast<double>(w[2 * contact + i]);
  return C2D_OK;
}

double product(const Real* a, const Real* b, int32_t n) {
  double sum = 0.0;
  for (int32_t i = 0; i < n; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
  return sum;
}

// Contact displacements out of the functional: those of the inverted body are +-F tau + v lambda, the others differ
// from them by w'.
c2d_status remove_displacements(Adjoint& a) {
  const Session& session = a.session;
  const int32_t m = session.model.head->contact, inverted = session.solver->inverted;
  const double sign = inverted == 0 ? 1.0 : -1.0;
  Real *sum = session.area.u[inverted], *column = session.area.column;
  const Real* other = session.area.u[1 - inverted];
  bool any = false;
  for (int32_t j = 0; j < m; ++j) {
    a.motion[j] = sign * static_cast<double>(other[j]);
    sum[j] += other[j];
    any = any || sum[j] != Real(0);
  }
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < m && any && status == C2D_OK; ++j) {
    status = read_column(session.tape, ContactMatrix::flexibility, j, column);
    if (status == C2D_OK) a.tau[j] += sign * product(column, sum, m);
  }
  for (int32_t k = 0; k < session.model.head->load_cases && any && status == C2D_OK; ++k) {
    status = read_column(session.tape, ContactMatrix::flexibility_load, k, column);
    if (status == C2D_OK) a.lambda[k] += product(column, sum, m);
  }
  return status;
}

c2d_status build_functional(Session& session, int32_t k, bool reactions, double* numbers) {
  const int32_t m = session.model.head->contact, cases = session.model.head->load_cases;
  for (int32_t i = 0; i < 2 * m + cases; ++i) numbers[i] = 0.0;
  Adjoint a{session, 0, numbers, numbers + m, numbers + 2 * static_cast<int64_t>(m), nullptr, session.area.outer, false};
  if (reactions && k + 1 == session.model.head->interference) add_overlaps(session.model, a.tau);
  c2d_status status = C2D_OK;
  for (a.b = 0; a.b < session.model.head->bodies && status == C2D_OK; ++a.b) status = add_body(a, k, reactions);
  return status == C2D_OK && m > 0 ? remove_displacements(a) : status;
}

void weigh_pairs(const Model& m) {
  for (int32_t i = 0; i < m.head->pairs; ++i) m.pair[i].weight = 0.0;
  for (int32_t z = 0; z < m.head->zones; ++z)
    for (int32_t place = 0; place < m.zone[z].elements; ++place) {
      const int b = m.zone[z].is_free != 0 ? 1 : 0;
      const int32_t element = zone_element(m, m.zone[z], b, place);
      EndResultant weight[4];
      end_resultants(m, b, element, Measure::own_length, weight);
      for (int l = 0; l < m.head->function_nodes; ++l) {
        const int32_t pair = pair_of_end(m, b, element, l);
        if (pair >= 0) m.pair[pair].weight += weight[l].w;
      }
    }
}

} // namespace

c2d_status build_energy(c2d_solver* s, const Model& model) {
  weigh_pairs(model);
  Session session;
  open_session(s, session);
  const EnergyBook book = energy_book(s);
  const int64_t size = 2 * static_cast<int64_t>(book.m) + book.cases;
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    tell_progress(s, C2D_PHASE_REDUCE, 0, k, 2 * static_cast<int64_t>(book.cases));
    if (asked_to_stop(s)) return C2D_ERR_CANCELLED;
    const c2d_status status = build_functional(session, k / 2, k % 2 == 1, book.first + k * size);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace c2d
