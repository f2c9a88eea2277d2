// The result table: a row per pair, with the displacements of both bodies.
#include "results/table.hpp"

namespace c2d {

namespace {

// u of the inverted body: -+F tau + sum lambda v, with F stored with a minus sign.
c2d_status inverted_displacements(Session& session) {
  const Follower& f = session.follower;
  const c2d_solver* s = session.solver;
  const int32_t m = f.t->m;
  Real *u = session.area.u[s->inverted], *column = session.area.column;
  const double sign = s->inverted == 0 ? 1.0 : -1.0;
  for (int32_t i = 0; i < m; ++i) u[i] = 0;
  const auto add = [&](const Real* from, double factor) {
    for (int32_t i = 0; i < m; ++i) u[i] += static_cast<Real>(factor) * from[i];
  };
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    const double tau[2] = {now.p, now.q};
    for (int32_t d = 0; d <= pair.tangential; ++d) {
      if (tau[d] == 0.0) continue;
      const int32_t j = pair.dof + d;
      const Real* from = session.area.flexibility ? session.area.flexibility + static_cast<int64_t>(j) * m : column;
      if (!session.area.flexibility) {
        const c2d_status status = read_column(session.tape, ContactMatrix::flexibility, j, column);
        if (status != C2D_OK) return status;
      }
      add(from, sign * tau[d]);
    }
  }
  for (int32_t k = 0; k < f.t->cases; ++k) {
    if (f.load[k] == 0.0) continue;
    const c2d_status status = read_column(session.tape, ContactMatrix::flexibility_load, k, column);
    if (status != C2D_OK) return status;
    add(column, f.load[k]);
  }
  return C2D_OK;
}

void other_displacements(Session& session) {
  const Follower& f = session.follower;
  const int inverted = session.solver->inverted;
  const double sign = inverted == 0 ? 1.0 : -1.0; // u_2 = u_1 + w', u_1 = u_2 - w'
  const Real* known = session.area.u[inverted];
  Real* out = session.area.u[1 - inverted];
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    const double gap = effective_gap(*session.model.head, pair, f.load) / f.t->length_unit;
    out[pair.dof] = known[pair.dof] + static_cast<Real>(sign * (now.wn - gap));
    if (pair.tangential) out[pair.dof + 1] = known[pair.dof + 1] + static_cast<Real>(sign * now.wt);
  }
}

void fill_row(const Session& session, int32_t i, double* row) {
  const Follower& f = session.follower;
  const Pair& pair = f.t->pair[i];
  const ModelHeader& head = *session.model.head;
  const PairState now = pair_state(*f.t, i, f.y);
  const double length = head.length_unit;
  const int32_t n = pair.dof, t = pair.dof + 1;
  row[C2D_STATUS] = pair.status;
  if (pair.status != C2D_OPEN && !pair.tangential) row[C2D_STATUS] = pair.mu > 0.0 ? C2D_STICK : C2D_SLIP;
  row[C2D_TN] = now.p * head.stress_unit;
  row[C2D_TT] = now.q * head.stress_unit;
  row[C2D_UN1] = session.area.u[0][n] * length;
  row[C2D_UT1] = pair.tangential ? session.area.u[0][t] * length : 0.0;
  row[C2D_UN2] = session.area.u[1][n] * length;
  row[C2D_UT2] = pair.tangential ? session.area.u[1][t] * length : 0.0;
  row[C2D_GAP] = now.wn * length;
  row[C2D_SLIP_SUM] = slip_sum(f, i) * length;
}

} // namespace

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
  if (s->blocked || s->floating) { // nothing has happened yet: zero load, or no solution at all
    for (int b = 0; b < 2; ++b)
      for (int32_t i = 0; i < m; ++i) session.area.u[b][i] = 0;
    for (int32_t i = 0; i < s->model.pairs; ++i) {
      double* row = table + static_cast<int64_t>(i) * C2D_PAIR_FIELDS;
      for (int c = C2D_STATUS; c <= C2D_SLIP_SUM; ++c) row[c] = 0.0;
      row[C2D_GAP] = session.model.pair[i].gap;
    }
    return C2D_OK;
  }
  if (!s->unsound) refresh(session.follower);
  const c2d_status status = inverted_displacements(session);
  if (status != C2D_OK) return status;
  other_displacements(session);
  for (int32_t i = 0; i < s->model.pairs; ++i) fill_row(session, i, table + static_cast<int64_t>(i) * C2D_PAIR_FIELDS);
  return C2D_OK;
}

} // namespace c2d
