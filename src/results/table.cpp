// The result table: one row per pair with status, tractions, gap, slip and the displacements of both sides.
//
// The contact solution consists of the tractions tau and the relative motions w' = w - (g, 0) of the pairs. Phases:
//   1. find_motions: sizes x = X w' + sum_k lambda_k x_k of the free rigid-body motions, METHOD (11.2).
//   2. Displacements of each body at its pairs. A body that was solved for: u = F t + sum_k lambda_k v_k + R x, METHOD (10.1),
//      with t = -tau on side 0 and +tau on side 1. A body that keeps its equations follows from the other side and w'.
//   3. Lazy columns (METHOD 10.12): the contact columns of pairs with force are superposed instead, and rigid-body modes are
//      determined from the pairs that support the bodies.
//   4. fill_row: conversion to the units of the caller.
// Columns of F, X, v and R are streamed from the contact tape one at a time: the matrices need not fit in memory. The method of
// flexibility matrices with superposed rigid-body motions is standard in contact of floating bodies (Conry and Seireg, J. Appl.
// Mech. 38, 1971; Johnson, Contact Mechanics, chapter 5).
#include "results/table.hpp"

#include "contact/basis.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(CompressedPart);

namespace {

// The relative motions w' = w - (gap, 0) of all pairs, as in the tableau.
void put_motion(const Session& session, Real* motion) {
  const Follower& f = session.follower;
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    motion[pair.dof] = static_cast<Real>(now.wn - gap_of(*f.t, pair));
    if (pair.tangential) motion[pair.dof + 1] = static_cast<Real>(now.wt);
  }
}

// x = X w' + sum_k lambda_k x_k. area.u[0] stores w' meanwhile, before it receives displacements.
c2d_status find_motions(const Session& session) {
  const Follower& f = session.follower;
  const int32_t m = f.t->m, motions = session.model.head->border;
  Real *motion = session.area.u[0], *column = session.area.column, *x = session.area.motion;
  if (motions > 0) put_motion(session, motion);
  for (int32_t j = 0; j < motions; ++j) {
    const c2d_status status = read_column(session.tape, ContactMatrix::motion, j, column);
    if (status != C2D_OK) return status;
    double sum = 0.0;
    for (int32_t i = 0; i < m; ++i) sum += static_cast<double>(column[i]) * static_cast<double>(motion[i]);
    x[j] = static_cast<Real>(sum);
  }
  for (int32_t k = 0; k < f.t->cases && motions > 0; ++k) {
    if (f.load[k] == 0.0) continue;
    const c2d_status status = read_column(session.tape, ContactMatrix::motion_load, k, column);
    if (status != C2D_OK) return status;
    for (int32_t j = 0; j < motions; ++j) x[j] += static_cast<Real>(f.load[k]) * column[j];
  }
  return C2D_OK;
}

// Adds factor times a column to the displacements of body b. The column has one entry per contact unknown of the body; its
// ranges map them to the pairs of side 0 and side 1.
void add_column(const Session& session, int b, const Real* column, double factor) {
  for_ranges(session.model, b, [&](const UnknownRange& range) {
    Real* u = session.area.u[range.side] + range.all;
    for (int32_t i = 0; i < range.count; ++i) u[i] += static_cast<Real>(factor) * column[range.own + i];
  });
}

// The same for a column on the tape. A zero factor saves the transfer.
c2d_status add_from_tape(const Session& session, int b, BodyMatrix matrix, int32_t column, double factor) {
  if (factor == 0.0) return C2D_OK;
  const c2d_status status = read_column(session.tape, b, matrix, column, session.area.column);
  if (status == C2D_OK) add_column(session, b, session.area.column, factor);
  return status;
}

// Adds F t, with t = -tau where the body is side 0 of a pair and +tau where it is side 1. F may be in memory or on the tape.
c2d_status add_compliance(const Session& session, int b) {
  const Model& m = session.model;
  const Follower& f = session.follower;
  const Real* kept = session.area.flexibility ? flexibility_of(session, b) : nullptr;
  for (PairSide at = first_pair_side(); next_pair_of(m, b, at);) {
    const Pair& pair = m.pair[at.pair];
    const PairState now = pair_state(*f.t, at.pair, f.y);
    const double tau[2] = {now.p, now.q};
    for (int32_t d = 0; d <= pair.tangential; ++d) {
      const int32_t j = dof_on(m, pair, at.side) + d;
      const double t = signed_on(at.side, tau[d]);
      if (kept && t != 0.0) add_column(session, b, kept + static_cast<int64_t>(j) * m.body[b].contact, t);
      const c2d_status status = kept ? c2d_status{C2D_OK} : add_from_tape(session, b, BodyMatrix::flexibility, j, t);
      if (status != C2D_OK) return status;
    }
  }
  return C2D_OK;
}

// For slender bodies whose displacements are unknowns of the contact system (METHOD 10.2): X w' takes the place of F t.
// area.own stores w'.
c2d_status add_unknowns(const Session& session, int b) {
  const Model& m = session.model;
  Real* const column = session.area.column;
  c2d_status status = C2D_OK;
  for_ranges(m, b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count && status == C2D_OK; ++i) {
      status = read_column(session.tape, b, BodyMatrix::flexibility, range.own + i, column);
      session.area.u[range.side][range.all + i] = static_cast<Real>(product(column, session.area.own, m.head->contact));
    }
  });
  return status;
}

// u = F t + sum of lambda_k v_k + R x.
c2d_status add_body(const Session& session, int b) {
  const Body& body = session.model.body[b];
  c2d_status status = is_rigid(session.model, b)            ? c2d_status{C2D_OK}
                      : has_displacements(session.model, b) ? add_unknowns(session, b)
                                                            : add_compliance(session, b);
  for (int32_t k = 0; k < session.follower.t->cases && status == C2D_OK; ++k)
    status = add_from_tape(session, b, BodyMatrix::response, k, session.follower.load[k]);
  for (int32_t j = 0; j < body.free_motions && status == C2D_OK; ++j)
    status = add_from_tape(session, b, BodyMatrix::motions, j, static_cast<double>(session.area.motion[body.first_border + j]));
  return status;
}

void fill_row(const Session& session, int32_t i, double* row) {
  const Follower& f = session.follower;
  const Pair& pair = f.t->pair[i];
  const ModelHeader& head = *session.model.head;
  const PairState now = pair_state(*f.t, i, f.y);
  const double length = head.length_unit;
  const int32_t n = pair.dof, t = pair.dof + 1;
  // A pair on an axis of symmetry cannot slip; its status is reported by its coefficient of friction.
  row[C2D_STATUS] = pair.status;
  if (is_tied(session.model, pair))
    row[C2D_STATUS] = C2D_TIED;
  else if (pair.status != C2D_OPEN && !pair.tangential)
    row[C2D_STATUS] = pair.law.is_smooth() ? C2D_SLIP : C2D_STICK;
  row[C2D_TN] = now.p * head.stress_unit;
  row[C2D_TT] = now.q * head.stress_unit;
  row[C2D_UN1] = session.area.u[0][n] * length;
  row[C2D_UT1] = pair.tangential ? session.area.u[0][t] * length : 0.0;
  row[C2D_UN2] = session.area.u[1][n] * length;
  row[C2D_UT2] = pair.tangential ? session.area.u[1][t] * length : 0.0;
  row[C2D_GAP] = now.wn * length;
  row[C2D_SLIP_SUM] = slip_sum(f, i) * length;
}

// The part of w_n that is not relative motion: the gap, minus the overlap that interference has removed so far.
double gap_now(const Follower& f, const Pair& pair) {
  const ModelHeader& head = *f.model->head;
  const double closed = head.interference == 0 ? 0.0 : f.load[head.interference - 1] * pair.overlap;
  return gap_of(*f.t, pair) - closed / f.t->length_unit;
}

// Displacement of the other side of a pair: u_1 = u_0 + w', or u_0 = u_1 - w', in the frame of the pair.
void follow_pair(const Session& session, int32_t i, int known_side) {
  const Follower& f = session.follower;
  const Pair& pair = session.model.pair[i];
  const PairState now = pair_state(*f.t, i, f.y);
  const Real* known = session.area.u[known_side] + pair.dof;
  Real* out = session.area.u[1 - known_side] + pair.dof;
  const double gap = gap_now(f, pair);
  out[0] = known[0] + static_cast<Real>(signed_on(1 - known_side, now.wn - gap));
  if (pair.tangential) out[1] = known[1] + static_cast<Real>(signed_on(1 - known_side, now.wt));
}

// All pairs of a body that keeps its equations.
void follow_others(const Session& session, int b) {
  for (PairSide at = first_pair_side(); next_pair_of(session.model, b, at);) follow_pair(session, at.pair, 1 - at.side);
}

// Lazy columns: amounts of the rigid-body modes. Some contact degrees of freedom support the bodies (form.held); every column
// was made with zero displacement there. So the amount of a mode is the relative motion at its supporting degree of freedom,
// minus the part h_k caused by the loads.
c2d_status move_on_demand(const Session& session) {
  const Model& m = session.model;
  const Follower& f = session.follower;
  Real *const u = session.area.u[0], *const column = session.area.column;
  Form form;
  c2d_status status = read_form(session.tape, column, &form);
  double amount[kMostHeld] = {};
  for (int32_t i = 0; i < m.head->pairs && form.count > 0; ++i) {
    const Pair& pair = m.pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    const double w[2] = {now.wn - gap_now(f, pair), now.wt};
    for (int32_t k = 0; k < form.count; ++k)
      if (form.held[k] >= pair.dof && form.held[k] <= pair.dof + pair.tangential) amount[k] = w[form.held[k] - pair.dof];
    for (int32_t k = 0; k < form.count && m.head->interference != 0; ++k) // h_k already contains the overlap
      if (form.held[k] == pair.dof) amount[k] -= f.load[m.head->interference - 1] * pair.overlap / m.head->length_unit;
  }
  for (int32_t i = 0; i < f.t->cases && form.count > 0 && status == C2D_OK; ++i) {
    const Real* h = nullptr;
    status = view_column(session.tape, ContactMatrix::closing, i, &h);
    for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) amount[k] -= f.load[i] * static_cast<double>(h[form.held[k]]);
  }
  for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) {
    const Real* motion = nullptr;
    status = view_column(session.tape, ContactMatrix::motion, k, &motion);
    for (int32_t j = 0; j < m.head->contact && status == C2D_OK; ++j) u[j] += static_cast<Real>(amount[k]) * motion[j];
  }
  return status;
}

// Lazy columns: displacements of side 0 from the columns of pairs with force and from the loads; side 1 follows by w'. Pairs
// without force need no column, and none may exist for them.
c2d_status displacements_on_demand(const Session& session) {
  const Model& m = session.model;
  const Follower& f = session.follower;
  Real *const u = session.area.u[0], *const column = session.area.column;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies; ++b)
    for (int32_t k = 0; k < f.t->cases && status == C2D_OK && m.body[b].contact > 0; ++k)
      status = add_from_tape(session, b, BodyMatrix::response, k, f.load[k]);
  for (int32_t i = 0; i < m.head->pairs && status == C2D_OK; ++i) {
    const PairState now = pair_state(*f.t, i, f.y);
    const double tau[2] = {now.p, now.q};
    for (int slot = 0; slot <= m.pair[i].tangential && status == C2D_OK; ++slot) {
      if (tau[slot] == 0.0) continue;
      status = read_column(session.tape, ContactMatrix::stiffness, m.pair[i].made + slot, column);
      for (int32_t j = 0; j < m.head->contact; ++j) u[j] += static_cast<Real>(tau[slot]) * column[j];
    }
  }
  if (status == C2D_OK && m.head->motions > 0) status = move_on_demand(session);
  for (int32_t i = 0; i < m.head->pairs; ++i) follow_pair(session, i, 0);
  return status == C2D_OK && m.head->motions > 0 ? kCompressedPart.fit_rigid(session) : status;
}

} // namespace

c2d_status contact_displacements(Session& session) {
  const Model& m = session.model;
  c2d_status status = find_motions(session);
  if (further_unknowns(m) > 0) put_motion(session, session.area.own);
  for (Real* u : session.area.u)
    for (int32_t i = 0; i < m.head->contact; ++i) u[i] = 0;
  if (is_on_demand(m)) return status == C2D_OK ? displacements_on_demand(session) : status;
  for (int b = 0; b < m.head->bodies && status == C2D_OK; ++b)
    if (m.body[b].contact > 0 && !keeps_equations(m, b)) status = add_body(session, b);
  for (int b = 0; b < m.head->bodies && status == C2D_OK; ++b)
    if (keeps_equations(m, b)) follow_others(session, b);
  return status;
}

void fill_positions(const Model& m, double* table) {
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    double* row = table + static_cast<int64_t>(i) * C2D_PAIR_FIELDS;
    const Pair& pair = m.pair[i];
    pair_position(m, pair, 0, &row[C2D_X], &row[C2D_Y]);
    row[C2D_NX] = pair.nx;
    row[C2D_NY] = pair.ny;
    row[C2D_PAIR_NODE1] = pair.node[0] + 1;
    row[C2D_PAIR_NODE2] = pair.node[1] + 1;
    row[C2D_PAIR_ZONE] = pair.zone + 1;
  }
}

c2d_status fill_table(Session& session) {
  c2d_solver* s = session.solver;
  double* table = array_of<double>(s, kPairTable);
  fill_positions(session.model, table);
  s->table_is_current = 1;
  if (s->model.contact == 0) return C2D_OK;
  const int32_t m = s->model.contact;
  if (s->blocked || s->floating) { // no solution: before the first contact, or unsupported motions
    for (Real* u : session.area.u)
      for (int32_t i = 0; i < m; ++i) u[i] = 0;
    for (int32_t i = 0; i < s->model.pairs; ++i) {
      double* row = table + static_cast<int64_t>(i) * C2D_PAIR_FIELDS;
      for (int c = C2D_STATUS; c <= C2D_SLIP_SUM; ++c) row[c] = 0.0;
      if (is_tied(session.model, session.model.pair[i])) row[C2D_STATUS] = C2D_TIED;
      row[C2D_GAP] = session.model.pair[i].gap;
    }
    return C2D_OK;
  }
  if (!s->unsound) refresh(session.follower); // tractions and motions of the state from the tableau
  const c2d_status status = contact_displacements(session);
  if (status != C2D_OK) return status;
  for (int32_t i = 0; i < s->model.pairs; ++i) fill_row(session, i, table + static_cast<int64_t>(i) * C2D_PAIR_FIELDS);
  return C2D_OK;
}

} // namespace c2d
