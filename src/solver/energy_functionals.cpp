// What multiplies tau, w' and lambda in the work and reaction of every load case (solver/energy.hpp).
#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "solver/energy_adjoint.hpp"
#include "solver/motion.hpp"

namespace c2d {

C2D_USES(BodyForcePart);
C2D_USES(RigidPart);

namespace {

// Pressures times the overlaps that case k closes.
void add_overlaps(const Model& m, Real* tau) {
  for (int32_t i = 0; i < m.head->pairs; ++i)
    tau[m.pair[i].dof] += static_cast<Real>(m.pair[i].weight * m.pair[i].overlap / m.head->length_unit);
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
    if (reactions) kRigidPart.add_rigid_motion(m, k, a.tau);
    return C2D_OK;
  }
  add_boundary(a, k, reactions);
  for (int32_t i = 0; i < m.head->point_loads && !reactions; ++i)
    if (m.point_load[i].body == a.b && m.point_load[i].load_case == k) add_point_load(a, m.point_load[i]);
  if (!reactions && has_body_force(m, a.b)) kBodyForcePart.add_body_force(a, k);
  if (!a.touched) return C2D_OK;
  c2d_solver* s = a.session.solver;
  const c2d_status status = transposed_functional(s->plan[a.b], s->tapes, a.outer, area.coefficient, area.work);
  if (status != C2D_OK) return status;
  const Real* w = area.coefficient; // of -u_c, t_c = +-tau, lambda
  const double side = a.b == 1 ? 1.0 : -1.0;
  for (int32_t j = 0; j < contact; ++j) {
    a.u[j] -= w[j];
    a.tau[j] += static_cast<Real>(side * static_cast<double>(w[contact + j]));
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
    a.motion[j] = static_cast<Real>(sign) * other[j];
    sum[j] += other[j];
    any = any || sum[j] != Real(0);
  }
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < m && any && status == C2D_OK; ++j) {
    status = read_column(session.tape, ContactMatrix::flexibility, j, column);
    if (status == C2D_OK) a.tau[j] += static_cast<Real>(sign * product(column, sum, m));
  }
  for (int32_t k = 0; k < session.model.head->load_cases && any && status == C2D_OK; ++k) {
    status = read_column(session.tape, ContactMatrix::flexibility_load, k, column);
    if (status == C2D_OK) a.lambda[k] += product(column, sum, m);
  }
  return status;
}

c2d_status build_functional(Session& session, int32_t k, bool reactions, Real* contact, double* loads) {
  const int32_t m = session.model.head->contact, cases = session.model.head->load_cases;
  for (int32_t i = 0; i < 2 * m; ++i) contact[i] = 0;
  for (int32_t i = 0; i < cases; ++i) loads[i] = 0.0;
  Adjoint a{session, 0, contact, contact + m, loads, nullptr, session.area.outer, false};
  if (reactions && k + 1 == session.model.head->interference) add_overlaps(session.model, a.tau);
  c2d_status status = C2D_OK;
  for (a.b = 0; a.b < session.model.head->bodies && status == C2D_OK; ++a.b) status = add_body(a, k, reactions);
  return status == C2D_OK && m > 0 ? remove_displacements(a) : status;
}

} // namespace

c2d_status build_energy(c2d_solver* s) {
  Session session;
  open_session(s, session);
  const EnergyBook book = energy_book(s);
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    tell_progress(s, C2D_PHASE_REDUCE, 0, k, 2 * static_cast<int64_t>(book.cases));
    if (asked_to_stop(s)) return C2D_ERR_CANCELLED;
    const c2d_status status =
        build_functional(session, k / 2, k % 2 == 1, book.of_contact + 2 * static_cast<int64_t>(k) * book.m,
                         book.of_loads + static_cast<int64_t>(k) * book.cases);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace c2d
