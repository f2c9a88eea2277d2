// Body forces in the energy's functionals: optional (memory/parts.hpp).
#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "bie/transfer.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/pair_frame.hpp"
#include "quadrature/gauss.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

void take_particular(Adjoint& a, int32_t element, const Blocks& blocks, const double factor[2]) {
  const Model& m = a.model();
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
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

namespace {

// t.u_p - t_p.u along one element, u_p and t_p those of case k.
[[gnu::noinline]] void add_particular(Adjoint& a, int32_t element, int32_t k) {
  const Model& m = a.model();
  const int nf = m.head->function_nodes;
  const double unit = m.head->length_unit, stress = m.head->stress_unit;
  double u[kElementNodes][2] = {}, t[kElementNodes][2] = {};
  const Element e = element_of(m, a.b, element);
  const GaussRule rule = gauss_legendre(6);
  for (int i = 0; i < rule.n; ++i) {
    const GaussPoint g = gauss_point(rule, i);
    const Point p = element_point(e, g.x);
    const Particular s = particular_solution(m, a.b, k, p.x, p.y);
    const double traction[2] = {s.stress[0] * p.nx + s.stress[2] * p.ny, s.stress[2] * p.nx + s.stress[1] * p.ny};
    double value[kElementNodes];
    shape(nf, g.x, value);
    const double weight = g.w * p.jacobian * (is_axisymmetric(m) ? kTurn * p.x : 1.0);
    for (int l = 0; l < nf; ++l)
      for (int c = 0; c < 2; ++c) {
        u[l][c] += weight * value[l] * s.u[c];
        t[l][c] += weight * value[l] * traction[c];
      }
  }
  for (int l = 0; l < nf; ++l) {
    const int32_t node = functional_node(m, a.b, element, l);
    Unknown unknown[2];
    unknowns_at(m, a.b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      const TractionKind kind = traction_kind(m, a.b, element, l, c, unknown[c]);
      const bool contact = kind == TractionKind::contact;
      const double ratio = contact ? traction_ratio(m, a.b, element, l) : 1.0;
      add_traction(a, element, l, c, kind, ratio * u[l][c] * 2.0 * shear_modulus(m, a.b) / (stress * unit * unit));
      add_displacement(a, node, c, unknown[c], -t[l][c] / (stress * unit));
    }
  }
}

struct ParticularOf {
  const Model* m;
  int b;
  int32_t k;
};
// Positions and displacements in the length unit.
void particular_displacement(const void* context, double x, double y, double u[2]) {
  const ParticularOf& of = *static_cast<const ParticularOf*>(context);
  const double unit = of.m->head->length_unit;
  const Particular p = particular_solution(*of.m, of.b, of.k, unit * x, unit * y);
  for (int c = 0; c < 2; ++c) u[c] = p.u[c] / unit;
}

// What a piece of a free zone hands over to the body, times u_p. Not inlined: a piece must not stand below the search for the
// next.
[[gnu::noinline]] void add_piece(Adjoint& a, const TransferWalk& walk, int32_t k) {
  const Model& m = a.model();
  Transfer piece;
  kFreeZonePart.make_transfer(m, Quadrature::accurate, walk, piece);
  const ParticularOf of = {&m, a.b, k};
  double u[kElementNodes][2];
  weigh(piece.in, particular_displacement, &of, u);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const Pair& pair = m.pair[piece.pair[l]];
    for (int c = 0; c < 2; ++c) {
      double sum = 0.0;
      for (int i = 0; i < piece.in.functions; ++i) sum += piece.weight[i][l] * u[i][c];
      for (int slot = 0; slot <= pair.tangential; ++slot)
        a.tau[pair.dof + slot] -= static_cast<Real>(sum * along(pair, slot, c));
    }
  }
}

} // namespace

void add_body_force(Adjoint& a, int32_t k) {
  const Model& m = a.model();
  if (!is_loaded(body_force(m, a.b, k))) return;
  const double unit = m.head->stress_unit * m.head->length_unit * m.head->length_unit;
  for (int32_t element = 0; element < body_of(m, a.b).elements; ++element)
    if (is_integrated(m, a.b, element)) add_particular(a, element, k);
  TransferWalk walk{};
  walk.body = a.b;
  while (m.body[a.b].free_rows > 0 && kFreeZonePart.next_transfer(m, walk)) add_piece(a, walk, k);
  for (int32_t i = 0; i < m.head->load_cases; ++i) a.lambda[i] += body_force_work(m, a.b, i, k) / unit;
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& load = m.point_load[i];
    if (load.body != a.b) continue;
    const Particular p = particular_solution(m, a.b, k, load.x, load.y);
    a.lambda[load.load_case] += (load.fx * p.u[0] + load.fy * p.u[1]) / unit;
  }
}

void add_particular_at_load(Adjoint& a, const PointLoad& load, const double factor[2]) {
  const Model& m = a.model();
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    const Particular p = particular_solution(m, a.b, k, load.x, load.y);
    a.lambda[k] += (factor[0] * p.u[0] + factor[1] * p.u[1]) / m.head->length_unit;
  }
}

} // namespace c2d
