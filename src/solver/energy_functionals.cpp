// What multiplies tau, w' and lambda in the work and reaction of every load case (solver/energy.hpp).
#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/orthonormal.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "solver/energy_adjoint.hpp"
#include "solver/motion.hpp"

namespace c2d {

C2D_USES(BodyForcePart);
C2D_USES(CompressedPart);
C2D_USES(RigidPart);

namespace {

// Pressures times the overlaps that case k closes.
void add_overlaps(const Model& m, Real* tau) {
  for (int32_t i = 0; i < m.head->pairs; ++i)
    tau[m.pair[i].dof] += static_cast<Real>(m.pair[i].weight * m.pair[i].overlap / m.head->length_unit);
}

// ---- one functional -------------------------------------------------------------------------------------------------

// Outer unknowns out of the functional: they follow from -u_c, t_c = +-tau and lambda.
c2d_status remove_outer(Adjoint& a) {
  const Model& m = a.model();
  const PathArea& area = a.session.area;
  c2d_solver* s = a.session.solver;
  const EliminationPlan& plan = plan_of(s, a.b);
  take_back_work(s);
  const c2d_status status = is_compressed(plan)
                                ? kCompressedPart.compression_functional(a.session, a.b, a.outer, area.coefficient)
                                : transposed_functional(plan, s->tapes, a.outer, area.coefficient, area.work);
  if (status != C2D_OK) return status;
  const Real* w = area.coefficient;
  const int32_t own = is_on_demand(m) ? 0 : m.body[a.b].contact; // (what tractions bring there comes with their columns)
  for (int32_t j = 0; j < own; ++j) a.u[j] -= w[j];
  for_ranges(m, a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count && own > 0; ++i) a.tau[range.all + i] += signed_on(range.side, w[own + range.own + i]);
  });
  for (int32_t i = 0; i < m.head->load_cases; ++i) a.lambda[i] += static_cast<double>(w[2 * own + i]);
  return C2D_OK;
}

// tau out of the contact displacements u = F t + ..., t = -tau on the body's sides 0, +tau on its sides 1.
c2d_status add_compliance(Adjoint& a) {
  const Model& m = a.model();
  Real* column = a.session.area.column;
  c2d_status status = C2D_OK;
  for_ranges(m, a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count && status == C2D_OK; ++i) {
      status = read_column(a.session.tape, a.b, BodyMatrix::flexibility, range.own + i, column);
      if (status == C2D_OK)
        a.tau[range.all + i] += static_cast<Real>(signed_on(range.side, product(column, a.u, m.body[a.b].contact)));
    }
  });
  return status;
}

// Coefficients of displacements on the sides of the pairs are put together from all bodies, in area.u.
void add_to_sides(Adjoint& a) {
  for_ranges(a.model(), a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) a.session.area.u[range.side][range.all + i] += a.u[range.own + i];
  });
}

// Displacements of a body that keeps its equations out of the functional: those of what it meets, and w'.
void remove_kept(Adjoint& a) {
  for_ranges(a.model(), a.b, [&](const UnknownRange& range) {
    Real *own = a.session.area.u[range.side] + range.all, *other = a.session.area.u[1 - range.side] + range.all;
    for (int32_t i = 0; i < range.count; ++i) {
      other[i] += own[i];
      a.jump[range.all + i] += signed_on(range.side, own[i]);
    }
  });
}

// The coefficients of a body's displacements; false: all are zero.
bool gather_displacements(Adjoint& a) {
  bool any = false;
  for_ranges(a.model(), a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) {
      a.u[range.own + i] = a.session.area.u[range.side][range.all + i];
      any = any || a.u[range.own + i] != Real(0);
    }
  });
  return any;
}

// Of a functional of motions: what the overlaps make of it that a load case closes.
double overlap_part(const Model& m, const Real* motions) {
  double sum = 0.0;
  for (int32_t i = 0; i < m.head->pairs; ++i)
    sum += static_cast<double>(motions[m.pair[i].dof]) * m.pair[i].overlap / m.head->length_unit;
  return sum;
}

// So much of a row of X (w' - overlaps closed).
void add_motion_row(Adjoint& a, Real part, const Real* row) {
  const ModelHeader& head = *a.model().head;
  for (int32_t i = 0; i < head.contact; ++i) a.jump[i] += part * row[i];
  if (head.interference != 0) a.lambda[head.interference - 1] -= static_cast<double>(part) * overlap_part(a.model(), row);
}

// Where displacements are unknowns X w' stands in the place of F t.
c2d_status add_unknowns(Adjoint& a) {
  Real* column = a.session.area.column;
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < a.model().body[a.b].contact && status == C2D_OK; ++i) {
    if (a.u[i] == Real(0)) continue;
    status = read_column(a.session.tape, a.b, BodyMatrix::flexibility, i, column);
    if (status == C2D_OK) add_motion_row(a, a.u[i], column);
  }
  return status;
}

// Those of another body: u = F t + sum lambda_k v_k + R x.
c2d_status remove_displacements(Adjoint& a) {
  const Model& m = a.model();
  const Body& body = m.body[a.b];
  if (!gather_displacements(a)) return C2D_OK;
  const ContactTape& tape = a.session.tape;
  Real* column = a.session.area.column;
  c2d_status status = is_rigid(m, a.b) ? c2d_status{C2D_OK} : has_displacements(m, a.b) ? add_unknowns(a) : add_compliance(a);
  for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) {
    status = read_column(tape, a.b, BodyMatrix::response, k, column);
    if (status == C2D_OK) a.lambda[k] += product(column, a.u, body.contact);
  }
  for (int32_t j = 0; j < body.free_motions && status == C2D_OK; ++j) {
    status = read_column(tape, a.b, BodyMatrix::motions, j, column);
    if (status == C2D_OK) a.motion[body.first_border + j] += static_cast<Real>(product(column, a.u, body.contact));
  }
  return status;
}

// Force and moment on a rigid body times its motion.
c2d_status add_given(Adjoint& a, int32_t k) {
  const Body& body = a.model().body[a.b];
  Real g[kMostMotions];
  if (body.free_motions == 0) return C2D_OK;
  const c2d_status status = read_column(a.session.tape, a.b, BodyMatrix::given, k, g);
  for (int32_t j = 0; j < body.free_motions && status == C2D_OK; ++j) a.motion[body.first_border + j] += g[j];
  return status;
}

// What case k does on a body with its boundary, point loads and body force.
void add_loads(Adjoint& a, int32_t k, bool reactions) {
  const Model& m = a.model();
  a.touched = false;
  for (int32_t j = 0; j < m.body[a.b].contact; ++j) a.u[j] = 0;
  for (int32_t i = 0; i < outer_columns(m, a.b); ++i) a.outer[i] = 0;
  add_boundary(a, k, reactions);
  for (int32_t i = 0; i < m.head->point_loads && !reactions; ++i)
    if (m.point_load[i].body == a.b && m.point_load[i].load_case == k) add_point_load(a, m.point_load[i]);
  if (!reactions && has_body_force(m, a.b)) kBodyForcePart.add_body_force(a, k);
}

c2d_status add_body(Adjoint& a, int32_t k, bool reactions) {
  const Model& m = a.model();
  if (is_rigid(m, a.b)) {
    if (reactions)
      kRigidPart.add_rigid_motion(m, a.b, k, a.tau);
    else if (m.body[a.b].contact > 0)
      return add_given(a, k);
    return C2D_OK;
  }
  add_loads(a, k, reactions);
  c2d_status status = C2D_OK;
  if (is_on_demand(m) && a.touched) status = kCompressedPart.functional_of_motions(a.session, a.b, a.outer, a.motion);
  if (a.touched && status == C2D_OK) status = remove_outer(a);
  add_to_sides(a);
  return status;
}

// Motions of the bodies out of the functional: x = X (w' - overlaps closed) + sum lambda_k x_k.
c2d_status remove_motions(Adjoint& a) {
  const ModelHeader& head = *a.model().head;
  if (is_on_demand(a.model())) return kCompressedPart.hold_functional(a.session, a.motion, a.jump, a.lambda);
  Real* column = a.session.area.column;
  bool any = false;
  for (int32_t j = 0; j < head.border; ++j) {
    const Real part = a.motion[j];
    if (part == Real(0)) continue;
    any = true;
    const c2d_status status = read_column(a.session.tape, ContactMatrix::motion, j, column);
    if (status != C2D_OK) return status;
    add_motion_row(a, part, column);
  }
  for (int32_t k = 0; k < head.load_cases && any; ++k) {
    const c2d_status status = read_column(a.session.tape, ContactMatrix::motion_load, k, column);
    if (status != C2D_OK) return status;
    a.lambda[k] += product(column, a.motion, head.border);
  }
  return C2D_OK;
}

c2d_status build_functional(Session& session, int32_t k, bool reactions, Real* contact, double* loads) {
  const PathArea& area = session.area;
  const ModelHeader& head = *session.model.head;
  const int32_t m = head.contact;
  for (int32_t i = 0; i < 2 * m; ++i) contact[i] = 0;
  for (int32_t i = 0; i < head.load_cases; ++i) loads[i] = 0.0;
  for (int32_t i = 0; i < (is_on_demand(session.model) ? head.motions : head.border); ++i) area.motion[i] = 0;
  for (Real* u : area.u)
    for (int32_t i = 0; i < m; ++i) u[i] = 0;
  Adjoint a{session, 0, contact, contact + m, loads, area.motion, area.own, area.outer, false};
  if (reactions && k + 1 == head.interference) add_overlaps(session.model, a.tau);
  c2d_status status = C2D_OK;
  for (a.b = 0; a.b < head.bodies && status == C2D_OK; ++a.b) status = add_body(a, k, reactions);
  for (a.b = 0; a.b < head.bodies; ++a.b)
    if (keeps_equations(session.model, a.b)) remove_kept(a);
  for (a.b = 0; a.b < head.bodies && status == C2D_OK; ++a.b)
    if (session.model.body[a.b].contact > 0 && !keeps_equations(session.model, a.b)) status = remove_displacements(a);
  return status == C2D_OK ? remove_motions(a) : status;
}

} // namespace

void add_demanded(Session& session, int b, const DemandedColumns& columns) {
  if (kSmallCode) return;
  const EnergyBook book = energy_book(session.solver);
  const PathArea& area = session.area;
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    // What the loads do without the solution has been counted: that goes where it is of no use.
    Adjoint a{session, b, area.u[0], area.u[1], book.r, area.motion, area.own, area.outer, false};
    add_loads(a, k / 2, k % 2 == 1);
    Real* const of_tau = book.of_contact + 2 * static_cast<int64_t>(k) * book.m;
    const int32_t unknowns = outer_columns(session.model, b);
    for (int32_t j = 0; j < columns.count && a.touched; ++j) {
      double sum = 0.0;
      for (int32_t i = 0; i < unknowns; ++i)
        if (a.outer[i] != 0)
          sum += static_cast<double>(a.outer[i]) * static_cast<double>(columns.x[static_cast<int64_t>(i) * columns.count + j]);
      of_tau[columns.dof[j]] += static_cast<Real>(signed_on(columns.side[j], sum));
    }
  }
}

void hold_demanded(Session& session, const Form& form, int32_t dof, const Real* column) {
  if (kSmallCode) return;
  const EnergyBook book = energy_book(session.solver);
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    Real *const of_tau = book.of_contact + 2 * static_cast<int64_t>(k) * book.m, *const of_jump = of_tau + book.m;
    for (int32_t i = 0; i < form.count; ++i) of_tau[dof] -= column[form.held[i]] * of_jump[form.held[i]];
  }
}

c2d_status build_energy(c2d_solver* s) {
  Session session;
  open_session(s, session);
  const EnergyBook book = energy_book(s);
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    tell_progress(s, C2D_PHASE_REDUCE, 0, k, 2 * static_cast<int64_t>(book.cases));
    if ((kSmallCode || s->state == C2D_STATE_MODEL) && asked_to_stop(s)) return C2D_ERR_CANCELLED; // (allow_friction)
    const c2d_status status =
        build_functional(session, k / 2, k % 2 == 1, book.of_contact + 2 * static_cast<int64_t>(k) * book.m,
                         book.of_loads + static_cast<int64_t>(k) * book.cases);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace c2d
