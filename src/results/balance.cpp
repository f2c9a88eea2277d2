// Resultant forces on the bodies and their equilibrium. Optional (memory/parts.hpp).
//
// Phases:
//   1. add_boundary_force, element by element during back substitution: applied = int t ds over all tractions and reactions
//      outside the contact, with moments int x cross t ds about the origin.
//   2. sum_forces: add point loads and body forces; compute the contact resultant (results/body_state.cpp).
//   3. balance_of: error = |applied + contact| / max(|applied|, |contact|), along the translations the body is free to follow.
//   4. Report the worst body.
// The integrals use the exact resultants of the shape functions, the same as the equations of equilibrium METHOD (2.6) of the
// discrete system. In exact arithmetic the error is therefore zero for any mesh: it measures the round-off of elimination,
// reduction and contact solution, not the discretisation.
#include "results/balance.hpp"
#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "results/back.hpp"
#include "results/body_state.hpp"
#include "results/transferred.hpp"
#include "solver/load_path.hpp"
#include "solver/support.hpp"

namespace c2d {

C2D_USES(BodyForcePart);

void add_boundary_force(const Session& session, int b, int32_t element, const double* transferred) {
  const Model& m = session.model;
  const double unit = m.head->length_unit;
  double* applied = results_of(session.solver, b).applied;
  if (!is_integrated(m, b, element)) return; // zero length, or replaced by an image: it carries no force
  EndResultant own[kElementNodes];
  end_resultants(m, b, element, Measure::own_length, own);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const PairSide at = pair_of_end(m, b, element, l);
    const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
    double t[2];
    get_traction(session, b, end, t);
    for (int c = 0; c < 2; ++c) t[c] -= transferred[2 * l + c]; // a contact force, counted with the contact
    const EndResultant& w = own[l];
    for (int c = 0; c < 2; ++c) {
      if (is_of_contact(m, at, node, c, unknown_at(m, b, node, c))) continue;
      add_force(applied, c == 0 ? unit * w.w * t[0] : 0.0, c == 1 ? unit * w.w * t[1] : 0.0,
                unit * unit * (c == 1 ? w.wx * t[1] : -w.wy * t[0]));
    }
  }
}

namespace {

void add_loads(const Session& session, int b, double applied[3]) {
  const Model& m = session.model;
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& p = m.point_load[i];
    if (p.body != b) continue;
    const double f = session.follower.load[p.load_case];
    add_force(applied, f * p.fx, f * p.fy, f * (p.x * p.fy - p.y * p.fx));
  }
  for (int32_t k = 0; k < m.head->load_cases && has_body_force(m, b); ++k) {
    double force[3] = {0.0, 0.0, 0.0};
    kBodyForcePart.body_force_resultant(m, b, k, 0.0, 0.0, force);
    const double f = session.follower.load[k];
    add_force(applied, f * force[0], f * force[1], f * force[2]);
  }
}

// A rigid body has no equations. Along prescribed motions the support reacts with minus the contact force; along free motions
// the given load acts. The given moment refers to the reference point of the body and is moved to the origin.
void hold_rigid(const Session& session, int b, const double contact[3], double applied[3]) {
  const Model& m = session.model;
  const Body& body = m.body[b];
  double load[3] = {0.0, 0.0, 0.0}; // moment about its point
  for (int32_t k = 0; k < m.head->load_cases; ++k)
    for (int i = 0; i < 3; ++i) load[i] += session.follower.load[k] * m.rigid_motion[b][k].load[i];
  for (int i = 0; i < 3; ++i) applied[i] = i < 2 && (body.free_rigidly >> i & 1) != 0 ? load[i] : -contact[i];
  if ((body.free_rigidly & 4) != 0) applied[2] = load[2] + body.centre[0] * applied[1] - body.centre[1] * applied[0];
}

void sum_forces(const Session& session, int b) {
  BodyResults& results = results_of(session.solver, b);
  double* applied = results.applied;
  contact_resultant(session, b, results.contact_force);
  if (is_rigid(session.model, b)) return hold_rigid(session, b, results.contact_force, applied);
  add_loads(session, b, applied);
  if (is_axisymmetric(session.model)) applied[0] = applied[2] = 0.0; // radial forces cancel round the axis
}

// Projection of a force onto the free translations of a body. A fully supported body compares the whole force: then the
// reactions balance the contact. Free motions may include rotations about a point, so their translational parts are
// orthonormalised first.
void free_part(const Body& body, const double force[3], double out[2]) {
  if (body.free_motions == 0) { // the other half balances forces across a line of symmetry
    for (int c = 0; c < 2; ++c) out[c] = (body.lines >> c & 1) != 0 ? 0.0 : force[c];
    return;
  }
  double basis[3][3];
  int rank = 0;
  for (int i = 0; i < body.free_motions && rank < 2; ++i) {
    double row[3] = {body.free_motion[i][0], body.free_motion[i][1], 0.0};
    rank += extend_basis(basis, rank, 2, row);
  }
  out[0] = out[1] = 0.0;
  for (int i = 0; i < rank; ++i) {
    const double along = basis[i][0] * force[0] + basis[i][1] * force[1];
    for (int c = 0; c < 2; ++c) out[c] += along * basis[i][c];
  }
}

struct Balance {
  double applied, contact, error; // error: relative to the larger of the two
};

Balance balance_of(const Session& session, int b) {
  c2d_solver* s = session.solver;
  const Body& body = session.model.body[b];
  const BodyResults& results = results_of(s, b);
  double applied[2], contact[2];
  free_part(body, results.applied, applied);
  free_part(body, results.contact_force, contact);
  Balance out{hypot(applied[0], applied[1]), hypot(contact[0], contact[1]), 0.0};
  const double rest = hypot(applied[0] + contact[0], applied[1] + contact[1]);
  const double size = out.applied > out.contact ? out.applied : out.contact;
  // After unloading, the remaining forces are round-off of earlier ones or of displacements; their ratio has no meaning.
  const double round_off = 1e-12 * path_scales(session.follower).w * s->model.stress_unit * s->model.length_unit;
  const bool loaded = size > kNoPressure * s->peak_force && size > round_off;
  out.error = s->model.contact > 0 && loaded ? rest / size : 0.0;
  return out;
}

// Which bodies are checked. If some bodies are supported by contact alone, only these, since no support can take up an error
// of their contact forces. Otherwise all, but of two deformable bodies only the softer one.
bool is_looked_at(const Model& m, int b, bool some_float) {
  const Body& body = m.body[b];
  if (body.contact == 0 || is_rigid(m, b)) return false;
  if (some_float) return body.free_motions > 0;
  if (m.head->bodies != 2 || is_rigid(m, 1 - b)) return true;
  return (shear_modulus(m, 1) > shear_modulus(m, 0)) == (b == 0);
}

} // namespace

void balance_forces(Session& session) {
  const Model& m = session.model;
  c2d_solver* s = session.solver;
  bool some_float = false;
  for (int b = 0; b < m.head->bodies; ++b) {
    sum_forces(session, b);
    some_float = some_float || (m.body[b].contact > 0 && m.body[b].free_motions > 0);
  }
  Balance worst{};
  worst.error = -1.0;
  for (int b = 0; b < m.head->bodies; ++b) {
    const bool first = m.head->contact == 0 && b == 0;
    if (!first && !is_looked_at(m, b, some_float)) continue;
    const Balance balance = balance_of(session, b);
    if (!(balance.error <= worst.error)) worst = balance;
  }
  s->force_applied = worst.applied;
  s->force_contact = worst.contact;
  s->force_error = worst.error;
}

} // namespace c2d
