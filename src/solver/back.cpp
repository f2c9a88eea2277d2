// Back substitution: displacements and tractions of whole boundaries, resultants, the force balance.
#include <math.h>

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "memory/optional.hpp"
#include "solver/hostile_port.hpp"
#include "solver/rigid.hpp"
#include "solver/transferred.hpp"

namespace c2d {

C2D_OPTIONAL(fill_rigid);
C2D_OPTIONAL(body_force_resultant);
C2D_OPTIONAL(add_transferred_traction);
C2D_OPTIONAL(add_transferred_force);

namespace {

// What multiplies the trailing columns [H_c | G_c | r]: -u_c, t_c = +-tau, lambda.
void trailing_coefficients(const Session& session, int b, Real* out) {
  const Follower& f = session.follower;
  const int32_t m = session.model.head->contact;
  const double side = b == 1 ? 1.0 : -1.0;
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    const Pair& pair = session.model.pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    const double tau[2] = {now.p, now.q};
    for (int32_t d = 0; d <= pair.tangential; ++d) {
      out[pair.dof + d] = -session.area.u[b][pair.dof + d];
      out[m + pair.dof + d] = static_cast<Real>(side * tau[d]);
    }
  }
  for (int32_t k = 0; k < session.model.head->load_cases; ++k) out[2 * m + k] = static_cast<Real>(f.load[k]);
}

double prescribed_displacement(const Session& session, int b, int32_t node, int c) {
  double sum = 0.0;
  const int64_t nodes = session.model.head->body[b].nodes;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k)
    sum += session.follower.load[k] * session.model.node_disp[b][(k * nodes + node) * 2 + c];
  return sum;
}
double prescribed_traction(const Session& session, int b, int32_t end, int c) {
  double sum = 0.0;
  const int64_t ends =
      static_cast<int64_t>(session.model.head->body[b].elements) * session.model.head->function_nodes;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k)
    sum += session.follower.load[k] * session.model.end_traction[b][(k * ends + end) * 2 + c];
  return sum;
}

void fill_displacements(const Session& session, int b) {
  const Model& m = session.model;
  for (int32_t node = 0; node < m.head->body[b].nodes; ++node) {
    double u[2];
    const int32_t index = pair_of_node(m, b, node);
    double contact[2] = {0.0, 0.0};
    if (index >= 0) {
      const Pair& pair = m.pair[index];
      const Real* uc = session.area.u[b] + pair.dof;
      to_global(pair, uc[0] * m.head->length_unit, pair.tangential ? uc[1] * m.head->length_unit : 0.0, contact);
    }
    for (int c = 0; c < 2; ++c) {
      const Unknown unknown = unknown_at(m, b, node, c);
      if (unknown.kind == UnknownKind::contact) u[c] = contact[c];
      else if (unknown.kind == UnknownKind::displacement)
        u[c] = session.area.outer[outer_column(m, b, node, c)] * m.head->length_unit;
      else u[c] = prescribed_displacement(session, b, node, c);
    }
    keep_displacement(session, b, node, u);
  }
}

} // namespace

void get_displacement(const Session& session, int b, int32_t node, double u[2]) {
  const Real* kept = session.area.displacement[b] + 2 * static_cast<ptrdiff_t>(node);
  for (int c = 0; c < 2; ++c) u[c] = kept[c] * session.model.head->length_unit;
}
void get_traction(const Session& session, int b, int32_t end, double t[2]) {
  const Real* kept = session.area.traction[b] + 2 * static_cast<ptrdiff_t>(end);
  for (int c = 0; c < 2; ++c) t[c] = kept[c] * session.model.head->stress_unit;
}
void keep_displacement(const Session& session, int b, int32_t node, const double u[2]) {
  Real* kept = session.area.displacement[b] + 2 * static_cast<ptrdiff_t>(node);
  for (int c = 0; c < 2; ++c) kept[c] = static_cast<Real>(u[c] / session.model.head->length_unit);
}
void keep_traction(const Session& session, int b, int32_t end, const double t[2]) {
  Real* kept = session.area.traction[b] + 2 * static_cast<ptrdiff_t>(end);
  for (int c = 0; c < 2; ++c) kept[c] = static_cast<Real>(t[c] / session.model.head->stress_unit);
}

void transferred_traction(const Session& session, int b, int32_t element, int l, double out[2]) {
  out[0] = out[1] = 0.0;
  if (b == 0 && session.model.head->free_rows > 0) add_transferred_traction(session, element, l, out);
}

namespace {

void fill_end_traction(const Session& session, int b, int32_t element, int l) {
  const Model& m = session.model;
  const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
  double t[2];
  const int32_t index = pair_of_end(m, b, element, l);
  double contact[2] = {0.0, 0.0};
  if (index >= 0) {
    const PairState now = pair_state(*session.follower.t, index, session.follower.y);
    const double scale = (b == 1 ? 1.0 : -1.0) * m.head->stress_unit * traction_ratio(m, b, element, l);
    to_global(m.pair[index], now.p * scale, now.q * scale, contact);
  }
  for (int c = 0; c < 2; ++c) {
    const Unknown unknown = unknown_at(m, b, node, c);
    const bool here = unknown.end[0] == end || (unknown.kind == UnknownKind::shared_traction && unknown.end[1] == end);
    const bool solved = unknown.kind == UnknownKind::traction || unknown.kind == UnknownKind::shared_traction;
    if (index >= 0 && unknown.kind == UnknownKind::contact) t[c] = contact[c];
    else if (solved && here) t[c] = session.area.outer[outer_column(m, b, node, c)] * 2.0 * shear_modulus(m, b);
    else t[c] = prescribed_traction(session, b, end, c);
  }
  double transferred[2];
  transferred_traction(session, b, element, l, transferred);
  for (int c = 0; c < 2; ++c) t[c] += transferred[c];
  keep_traction(session, b, end, t);
}

c2d_status back_substitute_body(Session& session, int b) {
  const Model& m = session.model;
  if (is_rigid(m, b)) {
    fill_rigid(session);
    return C2D_OK;
  }
  trailing_coefficients(session, b, session.area.coefficient);
  Tapes& tapes = session.solver->tapes;
  const HostilePort hostile(tapes);
  const c2d_status status =
      back_substitute(session.solver->plan[b], tapes, session.area.coefficient, session.area.outer, session.area.work);
  if (status != C2D_OK) return status;
  for (int i = 0; i < 3; ++i) session.solver->multiplier[b][i] = session.area.outer[m.head->body[b].columns + i];
  fill_displacements(session, b);
  for (int32_t element = 0; element < m.head->body[b].elements; ++element)
    for (int l = 0; l < m.head->function_nodes; ++l) fill_end_traction(session, b, element, l);
  return C2D_OK;
}

// ---- resultants ---------------------------------------------------------------------------------------------------

// The contact's share of an element, from tau itself in its own measure.
void add_contact_end(const Session& session, int b, int32_t index, const EndResultant& w, double out[3]) {
  const ModelHeader& head = *session.model.head;
  const PairState now = pair_state(*session.follower.t, index, session.follower.y);
  const double scale = (b == 1 ? 1.0 : -1.0) * head.stress_unit * head.length_unit;
  double t[2];
  to_global(session.model.pair[index], now.p * scale, now.q * scale, t);
  add_force(out, w.w * t[0], w.w * t[1], head.length_unit * (w.wx * t[1] - w.wy * t[0]));
}

void sum_forces(Session& session, int b) {
  const Model& m = session.model;
  const double unit = m.head->length_unit;
  double *applied = session.solver->applied[b], *contact = session.solver->contact_force[b];
  for (int i = 0; i < 3; ++i) applied[i] = contact[i] = 0.0;
  for (int32_t element = 0; element < m.head->body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    EndResultant own[4], shared[4];
    end_resultants(m, b, element, Measure::own_length, own);
    end_resultants(m, b, element, Measure::contact, shared);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const int32_t index = pair_of_end(m, b, element, l);
      if (index >= 0) add_contact_end(session, b, index, shared[l], contact);
      const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
      double total[2], t[2];
      get_traction(session, b, end, total);
      transferred_traction(session, b, element, l, t);
      for (int c = 0; c < 2; ++c) t[c] = total[c] - t[c];
      const EndResultant& w = own[l];
      for (int c = 0; c < 2; ++c) {
        if (index >= 0 && (is_rigid(m, b) || unknown_at(m, b, node, c).kind == UnknownKind::contact)) continue;
        add_force(applied, c == 0 ? unit * w.w * t[0] : 0.0, c == 1 ? unit * w.w * t[1] : 0.0,
                  unit * unit * (c == 1 ? w.wx * t[1] : -w.wy * t[0]));
      }
    }
  }
  if (b == 0 && m.head->free_rows > 0) add_transferred_force(session, contact);
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& p = m.point_load[i];
    if (p.body != b) continue;
    const double f = session.follower.load[p.load_case];
    add_force(applied, f * p.fx, f * p.fy, f * (p.x * p.fy - p.y * p.fx));
  }
  for (int32_t k = 0; k < m.head->load_cases && has_body_force(m, b); ++k) {
    double force[3];
    body_force_resultant(m, b, k, 0.0, 0.0, force);
    const double f = session.follower.load[k];
    add_force(applied, f * force[0], f * force[1], f * force[2]);
  }
  if (!is_rigid(m, b)) return;
  for (int i = 0; i < 3; ++i) applied[i] = -contact[i]; // what holds it
}

// Part of a force along the translations that the body is free to follow; all of it if it is held.
void free_part(const Body& body, int32_t symmetry, const double force[3], double out[2]) {
  if (body.free_motions == 0) { // what acts across a symmetry line is balanced by the other side
    for (int c = 0; c < 2; ++c) out[c] = (symmetry >> c & 1) != 0 ? 0.0 : force[c];
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

// design: contact force equals applied load, on the body that the contact has to hold.
void balance_forces(Session& session) {
  c2d_solver* s = session.solver;
  const int b = s->model.contact > 0 ? 1 - s->inverted : 0;
  double applied[2], contact[2];
  free_part(s->model.body[b], s->model.symmetry, s->applied[b], applied);
  free_part(s->model.body[b], s->model.symmetry, s->contact_force[b], contact);
  s->force_applied = hypot(applied[0], applied[1]);
  s->force_contact = hypot(contact[0], contact[1]);
  const double rest = hypot(applied[0] + contact[0], applied[1] + contact[1]);
  const double size = s->force_applied > s->force_contact ? s->force_applied : s->force_contact;
  s->force_error = size > 0.0 && s->model.contact > 0 ? rest / size : 0.0;
}

} // namespace

c2d_status back_substitute_all(Session& session) {
  c2d_solver* s = session.solver;
  if (s->back_substituted || s->blocked || s->floating) return C2D_OK;
  const double start = clock_now(s);
  c2d_status status = s->table_is_current ? c2d_status{C2D_OK} : fill_table(session);
  for (int b = 0; b < s->model.bodies && status == C2D_OK; ++b) status = back_substitute_body(session, b);
  if (status == C2D_OK) {
    for (int b = 0; b < s->model.bodies; ++b) sum_forces(session, b);
    balance_forces(session);
    s->back_substituted = 1;
  }
  tell_progress(s, C2D_PHASE_BACK, 0, 0, 0);
  s->seconds[C2D_PHASE_BACK] += clock_now(s) - start;
  return status;
}

} // namespace c2d
