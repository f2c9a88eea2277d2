// Back substitution (METHOD 16.1): displacements and tractions on all boundaries at the load reached.
//
// Elimination left, for each body, A_o x_o + H_c u_c = G_c t_c + sum_k lambda_k r_k, METHOD (7.1), in factored form. The
// contact solution gives u_c and t_c, the load path gives the factors lambda_k. Phases, body by body:
//   1. trailing_coefficients: collect (-u_c, t_c, lambda), which multiply the trailing columns [H_c | G_c | r].
//   2. Solve U x_o = L^-1 [H_c | G_c | r] (-u_c, t_c, lambda) backwards through the stored factors (dense or compressed).
//      L^-1 was already applied to the trailing columns during elimination, so only U is read.
//   3. Assign the unknowns: displacements to nodes, tractions to element ends. A rigid body skips phases 1 and 2: its motion is
//      known and its tractions are those of the contact.
//   4. Sum the forces applied to each body and check the balance with the contact (results/balance.cpp).
// The phases run once per load, on the first request for results outside the contact: load steps of a path need none of them.
//
// Block LU with back substitution: Golub and Van Loan, Matrix Computations, chapter 3. Mixed unknowns of the direct boundary
// element method: Brebbia, Telles and Wrobel, Boundary Element Techniques (1984).
#include "results/back.hpp"
#include "bie/columns.hpp"
#include "contact/body_unknowns.hpp"
#include "memory/parts.hpp"
#include "results/balance.hpp"
#include "results/rigid.hpp"
#include "results/table.hpp"
#include "results/transferred.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(RigidPart);
C2D_USES(EnergyPart);
C2D_USES(CompressedPart);

void trailing_coefficients(const Session& session, int b, Real* out) {
  const Follower& f = session.follower;
  const Model& m = session.model;
  const int32_t own = m.body[b].contact;
  // Equilibrium of a pair: the traction tau acts on side 1 and -tau on side 0, hence signed_on. u_c gets a minus because H_c
  // u_c is on the left-hand side of the equation and the factors treat all trailing columns as right-hand sides.
  for (PairSide at = first_pair_side(); next_pair_of(m, b, at);) {
    const Pair& pair = m.pair[at.pair];
    const PairState now = pair_state(*f.t, at.pair, f.y);
    const double tau[2] = {now.p, now.q};
    for (int32_t d = 0; d <= pair.tangential; ++d) {
      const int32_t j = dof_on(m, pair, at.side) + d;
      out[j] = -session.area.u[at.side][pair.dof + d];
      out[own + j] = static_cast<Real>(signed_on(at.side, tau[d]));
    }
  }
  for (int32_t k = 0; k < m.head->load_cases; ++k) out[2 * own + k] = static_cast<Real>(f.load[k]);
}

namespace {

// Prescribed values are linear in the load factors: sum_k lambda_k value_k.
double prescribed_displacement(const Session& session, int b, int32_t node, int c) {
  double sum = 0.0;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k)
    sum += session.follower.load[k] * given_displacement(session.model, b, node, c, k);
  return sum;
}
double prescribed_traction(const Session& session, int b, int32_t end, int c) {
  double sum = 0.0;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k)
    sum += session.follower.load[k] * given_traction(session.model, b, end, c, k);
  return sum;
}

// Each component of a nodal displacement has one of three sources: the contact solution (rotated from the frame of the pair),
// the back-substituted unknown, or the prescribed value. Unknowns are dimensionless: displacements are in the length unit.
void fill_displacements(const Session& session, int b) {
  const Model& m = session.model;
  for (int32_t node = 0; node < m.body[b].nodes; ++node) {
    double u[2];
    const PairSide at = pair_of_node(m, b, node);
    double contact[2] = {0.0, 0.0};
    if (at.pair >= 0) {
      const Pair& pair = m.pair[at.pair];
      const Real* uc = session.area.u[at.side] + pair.dof;
      to_global(pair, uc[0] * m.head->length_unit, pair.tangential ? uc[1] * m.head->length_unit : 0.0, contact);
    }
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      if (unknown[c].kind == UnknownKind::contact)
        u[c] = contact[c];
      else if (unknown[c].kind == UnknownKind::displacement)
        u[c] = session.area.outer[outer_column(m, b, node, c)] * m.head->length_unit;
      else
        u[c] = prescribed_displacement(session, b, node, c);
    }
    keep_displacement(session, b, node, u);
  }
}

} // namespace

namespace {

Real* displacement_of(const Session& session, int b, int32_t node) {
  return session.area.displacement + 2 * (session.model.body[b].first_node + node);
}
Real* traction_of(const Session& session, int b, int32_t end) {
  return session.area.traction + 2 * (session.model.body[b].first_end + end);
}

} // namespace

void get_displacement(const Session& session, int b, int32_t node, double u[2]) {
  const Real* kept = displacement_of(session, b, node);
  for (int c = 0; c < 2; ++c) u[c] = kept[c] * session.model.head->length_unit;
}
void get_traction(const Session& session, int b, int32_t end, double t[2]) {
  const Real* kept = traction_of(session, b, end);
  for (int c = 0; c < 2; ++c) t[c] = kept[c] * session.model.head->stress_unit;
}
void keep_displacement(const Session& session, int b, int32_t node, const double u[2]) {
  Real* kept = displacement_of(session, b, node);
  for (int c = 0; c < 2; ++c) kept[c] = static_cast<Real>(u[c] / session.model.head->length_unit);
}
void keep_traction(const Session& session, int b, int32_t end, const double t[2]) {
  Real* kept = traction_of(session, b, end);
  for (int c = 0; c < 2; ++c) kept[c] = static_cast<Real>(t[c] / session.model.head->stress_unit);
}

PairSide contact_traction(const Session& session, int b, int32_t element, int l, double out[2]) {
  const Model& m = session.model;
  const PairSide at = pair_of_end(m, b, element, l);
  out[0] = out[1] = 0.0;
  if (at.pair < 0) return at;
  pair_force(session, at.pair, signed_on(at.side, m.head->stress_unit) * traction_ratio(m, b, element, l), out);
  return at;
}

void transferred_traction(const Session& session, int b, int32_t element, int l, double out[2]) {
  out[0] = out[1] = 0.0;
  if (session.model.body[b].free_rows > 0) kFreeZonePart.add_transferred_traction(session, b, element, l, out);
}

namespace {

// Traction of one element end: contact, unknown (stored divided by 2G) or prescribed, plus the mortar-transferred traction of a
// free zone, which acts in addition to prescribed tractions. `transferred` returns that last share: the balance of forces must
// leave it out, and finding it costs a search for the facing point.
void fill_end_traction(const Session& session, int b, int32_t element, int l, double transferred[2]) {
  const Model& m = session.model;
  const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
  double t[2];
  double contact[2];
  const PairSide at = contact_traction(session, b, element, l, contact);
  Unknown both[2];
  unknowns_at(m, b, node, both);
  for (int c = 0; c < 2; ++c) {
    const Unknown& unknown = both[c];
    // A corner with a known displacement and two unknown tractions has one value, valid at both ends of its node.
    const bool here = unknown.end[0] == end || unknown.kind == UnknownKind::shared_traction;
    const bool solved = unknown.kind == UnknownKind::traction || unknown.kind == UnknownKind::shared_traction;
    if (is_of_contact(m, at, node, c, unknown))
      t[c] = contact[c];
    else if (solved && here)
      t[c] = session.area.outer[outer_column(m, b, node, c)] * 2.0 * shear_modulus(m, b);
    else
      t[c] = prescribed_traction(session, b, end, c);
  }
  transferred_traction(session, b, element, l, transferred);
  for (int c = 0; c < 2; ++c) t[c] += transferred[c];
  keep_traction(session, b, end, t);
}

c2d_status back_substitute_body(Session& session, int b) {
  const Model& m = session.model;
  if (is_rigid(m, b)) {
    kRigidPart.fill_rigid(session, b);
    return C2D_OK;
  }
  trailing_coefficients(session, b, session.area.coefficient);
  c2d_solver* s = session.solver;
  const EliminationPlan& plan = plan_of(s, b);
  const c2d_status status =
      is_compressed(plan) ? kCompressedPart.solve_compressed(session, b)
                          : back_substitute(plan, s->tapes, session.area.coefficient, session.area.outer, session.area.work);
  if (status != C2D_OK) return status;
  // The last three unknowns are rho and omega of the balanced equations, METHOD (2.5): interior points need them.
  for (int i = 0; i < 3; ++i) results_of(s, b).multiplier[i] = session.area.outer[m.body[b].columns + i];
  fill_displacements(session, b);
  for (double& force : results_of(s, b).applied) force = 0.0;
  for (int32_t element = 0; element < m.body[b].elements; ++element) {
    double transferred[2 * kElementNodes];
    for (int l = 0; l < m.head->function_nodes; ++l) fill_end_traction(session, b, element, l, transferred + 2 * l);
    if (s->keeps_energy) kEnergyPart.add_boundary_force(session, b, element, transferred);
  }
  return C2D_OK;
}

} // namespace

c2d_status back_substitute_all(Session& session) {
  c2d_solver* s = session.solver;
  // blocked, floating: rigid-body motions are unsupported, so that there is no solution to substitute; results stay zero.
  if (s->back_substituted || s->blocked || s->floating) return C2D_OK;
  const double start = clock_now(s);
  c2d_status status = s->table_is_current ? c2d_status{C2D_OK} : fill_table(session);
  for (int b = 0; b < s->model.bodies && status == C2D_OK; ++b) status = back_substitute_body(session, b);
  if (status == C2D_OK) {
    if (s->keeps_energy) kEnergyPart.balance_forces(session);
    s->back_substituted = 1;
  }
  tell_progress(s, C2D_PHASE_BACK, 0, 0, 0);
  s->seconds[C2D_PHASE_BACK] += clock_now(s) - start;
  return status;
}

} // namespace c2d
