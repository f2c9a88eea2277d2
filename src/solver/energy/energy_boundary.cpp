// Displacements and tractions in the energy's functionals, and the work of what the conditions prescribe.
#include "bie/columns.hpp"
#include "memory/parts.hpp"
#include "model/pair_frame.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

C2D_USES(CompressedPart);

c2d_status solve_transposed(Session& session, int b, int32_t count, Real* const* f, Real* const* w,
                            const FunctionalTiles& tiles) {
  c2d_solver* s = session.solver;
  const EliminationPlan& plan = plan_of(s, b);
  take_back_work(s);
  if (!is_compressed(plan)) return transposed_functionals(plan, s->tapes, count, f, w, session.area.work, tiles);
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < count && status == C2D_OK; ++i)
    status = kCompressedPart.compression_functional(session, b, f[i], w[i]);
  return status;
}

Prescribed prescribed_displacement(const Model& m, int b, int32_t node, int c) {
  return {m.node_disp[b] + 2 * static_cast<int64_t>(node) + c, 2 * static_cast<int64_t>(m.body[b].nodes), m.head->length_unit};
}

Prescribed prescribed_traction(const Model& m, int b, int32_t element, int l, int c) {
  const int64_t functions = m.head->function_nodes;
  return {m.end_traction[b] + 2 * (element * functions + l) + c, 2 * (m.body[b].elements * functions),
          2.0 * shear_modulus(m, b)};
}

void add_prescribed(const Prescribed& given, const CaseSpan& cases, int32_t count, const double* factor,
                    double* const* lambda) {
  const auto add = [&](int32_t k) { // most cases load other places
    if (const double value = given.value[k * given.stride]; value != 0.0)
      for (int32_t i = 0; i < count; ++i) lambda[i][k] += factor[i] * value / given.unit;
  };
  add(0);
  for (int32_t k = cases.from; k < cases.end; ++k) add(k);
}

void add_outer(Adjoint& a, int32_t column, double factor) {
  a.outer[column] += static_cast<Real>(factor);
  a.touched = true;
}

void add_displacement(Adjoint& a, int32_t node, int c, const Unknown& unknown, double factor) {
  const Model& m = a.model();
  if (unknown.kind == UnknownKind::contact) {
    const PairSide at = pair_of_node(m, a.b, node);
    const Pair& pair = m.pair[at.pair];
    for (int slot = 0; slot <= pair.tangential; ++slot)
      a.u[dof_on(m, pair, at.side) + slot] += static_cast<Real>(factor * along(pair, slot, c));
  } else if (unknown.kind == UnknownKind::displacement) {
    add_outer(a, outer_column(m, a.b, node, c), factor);
  } else {
    add_prescribed(prescribed_displacement(m, a.b, node, c), {1, m.head->load_cases}, 1, &factor, &a.lambda);
  }
}

TractionKind traction_kind(const Model& m, int b, int32_t element, int l, int component, const Unknown& unknown) {
  const int32_t end = element * m.head->function_nodes + l;
  if (unknown.kind == UnknownKind::traction && unknown.end[0] == end) return TractionKind::solved;
  if (unknown.kind == UnknownKind::shared_traction) return TractionKind::solved; // (at both ends of its node)
  const PairSide at = pair_of_end(m, b, element, l);
  if (at.pair >= 0 && is_of_contact(m, at, functional_node(m, b, element, l), component, unknown)) return TractionKind::contact;
  return TractionKind::given;
}

void add_traction(Adjoint& a, int32_t element, int l, int c, TractionKind kind, double factor) {
  const Model& m = a.model();
  if (kind == TractionKind::contact) {
    const PairSide at = pair_of_end(m, a.b, element, l);
    const Pair& pair = m.pair[at.pair];
    const double scaled = signed_on(at.side, factor) * m.head->stress_unit / (2.0 * shear_modulus(m, a.b));
    for (int slot = 0; slot <= pair.tangential; ++slot)
      a.tau[pair.dof + slot] += static_cast<Real>(scaled * along(pair, slot, c));
  } else if (kind == TractionKind::solved) {
    add_outer(a, outer_column(m, a.b, functional_node(m, a.b, element, l), c), factor);
  } else {
    add_prescribed(prescribed_traction(m, a.b, element, l, c), {1, m.head->load_cases}, 1, &factor, &a.lambda);
  }
}

bool prescribes(const Model& m, int b, int32_t k, bool displacements) {
  const int64_t count = 2 * (displacements ? static_cast<int64_t>(m.body[b].nodes)
                                           : static_cast<int64_t>(m.body[b].elements) * m.head->function_nodes);
  const double* const given = (displacements ? m.node_disp[b] : m.end_traction[b]) + k * count;
  int64_t i = 0;
  while (i < count && given[i] == 0.0) ++i;
  return i < count;
}

bool prescribes(const Model& m, int b, int32_t element, int32_t k, bool displacements) {
  for (int l = 0; l < m.head->function_nodes; ++l)
    for (int c = 0; c < 2; ++c)
      if ((displacements ? given_displacement(m, b, functional_node(m, b, element, l), c, k)
                         : given_traction(m, b, element * m.head->function_nodes + l, c, k)) != 0.0)
        return true;
  return false;
}

void add_boundary(Adjoint& a, int32_t k, bool reactions) {
  const Model& m = a.model();
  if (!kSmallCode && !prescribes(m, a.b, k, reactions)) return;
  for (int32_t element = 0; element < m.body[a.b].elements; ++element) {
    if (!prescribes(m, a.b, element, k, reactions) || !is_integrated(m, a.b, element)) continue;
    EndResultant weight[kElementNodes];
    bool known = false;
    for (int l = 0; l < m.head->function_nodes; ++l)
      for (int c = 0; c < 2; ++c) {
        const int32_t node = functional_node(m, a.b, element, l);
        const double value = reactions
                                 ? given_displacement(m, a.b, node, c, k) / m.head->length_unit
                                 : given_traction(m, a.b, element * m.head->function_nodes + l, c, k) / m.head->stress_unit;
        if (value == 0.0) continue;
        const Unknown unknown = unknown_at(m, a.b, node, c);
        const TractionKind kind = traction_kind(m, a.b, element, l, c, unknown);
        if (kind != (reactions ? TractionKind::solved : TractionKind::given)) continue;
        if (!known) end_resultants(m, a.b, element, Measure::own_length, weight);
        known = true;
        if (reactions)
          add_traction(a, element, l, c, kind, weight[l].w * value * 2.0 * shear_modulus(m, a.b) / m.head->stress_unit);
        else
          add_displacement(a, node, c, unknown, weight[l].w * value);
      }
  }
}

} // namespace c2d
