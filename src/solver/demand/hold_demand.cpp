#include "solver/demand/hold_demand.hpp"

#include "contact/body_unknowns.hpp"
#include "contact/held_columns.hpp"
#include "contact/reduction/reduction.hpp"
#include "linalg/dense.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "solver/demand/on_demand.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

// R with 1 in the slots that hold may have so much elsewhere, as in contact/reduction/open_form.cpp.
constexpr double kMovesMost = 10, kWeighsLeast = 1e-12;
constexpr double kNothing = sizeof(Real) == 8 ? 1e-12 : 1e-5;

// A few columns of numbers combined, side by side: kMostHeld to each.
struct Turn {
  int32_t count;
  double of[kMostHeld * kMostHeld]; // column k from k * kMostHeld on
  double* column(int32_t k) { return of + k * kMostHeld; }
  const double* column(int32_t k) const { return of + k * kMostHeld; }
};
Turn as_it_is(int32_t count) {
  Turn out{count, {}};
  for (int32_t k = 0; k < count; ++k) out.column(k)[k] = 1.0;
  return out;
}
// A row of the columns combined.
void combine_row(const Turn& t, const double* row, double* out) {
  for (int32_t k = 0; k < t.count; ++k) {
    out[k] = 0.0;
    for (int32_t j = 0; j < t.count; ++j) out[k] += row[j] * t.column(k)[j];
  }
}
// Column `from` comes to `own` and gets 1 in a row, and the others, by it, 0. `row`: combined.
void clear_row(Turn& t, int32_t own, int32_t from, double* row) {
  for (int32_t j = 0; j < t.count && from != own; ++j) {
    const double kept = t.column(own)[j];
    t.column(own)[j] = t.column(from)[j];
    t.column(from)[j] = kept;
  }
  const double kept = row[own];
  row[own] = row[from];
  row[from] = from == own ? row[from] : kept;
  for (int32_t j = 0; j < t.count; ++j) t.column(own)[j] /= row[own];
  for (int32_t k = 0; k < t.count; ++k)
    for (int32_t j = 0; j < t.count && k != own; ++j) t.column(k)[j] -= row[k] * t.column(own)[j];
}

// ---- which slots --------------------------------------------------------------------------------------------------------

// What each motion moves a slot of a pair.
void motion_row(const Model& m, const Pair& pair, int slot, double* row) {
  for (int32_t j = 0; j < m.head->motions; ++j) row[j] = 0.0;
  for (int side = 0; side < 2; ++side) {
    const int b = body_on(m, pair, side);
    for (int32_t j = 0; j < m.body[b].free_motions; ++j) {
      double w[2];
      motion_at_pair(m, b, m.body[b].free_motion[j], m.body[b].centre, pair, w);
      row[m.body[b].first_motion + j] = w[slot];
    }
  }
}

bool may_rub(c2d_solver* s, const Pair& pair) {
  bool rubs = s->model.coefficients == 0; // told later
  for (int32_t i = 0; i < s->model.coefficients; ++i) rubs = rubs || coefficient_of_zone(s, pair.zone, i) != 0.0;
  return rubs;
}

// visit(pair, slot) for every one in question.
template <class Visit> void for_slots(c2d_solver* s, const Model& m, bool tangents, Visit visit) {
  for (int32_t i = 0; i < m.head->pairs; ++i)
    for (int slot = 0; slot <= (tangents && may_rub(s, m.pair[i]) ? m.pair[i].tangential : 0); ++slot) visit(m.pair[i], slot);
}

bool is_among(const HeldSlots& held, int32_t count, int32_t slot) {
  for (int32_t k = 0; k < count; ++k)
    if (held.slot[k] == slot) return true;
  return false;
}

void sort(HeldSlots& held) {
  for (int32_t k = 1; k < held.count; ++k)
    for (int32_t j = k; j > 0 && held.slot[j] < held.slot[j - 1]; --j) {
      const int32_t kept = held.slot[j];
      held.slot[j] = held.slot[j - 1];
      held.slot[j - 1] = kept;
    }
}

// The slots in which what is left moves farthest, by the length on which a force would act.
bool choose(c2d_solver* s, const Model& m, bool tangents, HeldSlots& out) {
  out.count = m.head->motions;
  Turn turn = as_it_is(out.count);
  for (int32_t k = 0; k < out.count; ++k) {
    double best = 0.0, raw[kMostHeld], row[kMostHeld], taken[kMostHeld];
    int32_t column = k;
    for_slots(s, m, tangents, [&](const Pair& pair, int slot) {
      if (is_among(out, k, pair.dof + slot)) return;
      motion_row(m, pair, slot, raw);
      combine_row(turn, raw, row);
      for (int32_t j = k; j < out.count; ++j) {
        if (fabs(row[j]) * pair.length <= best) continue;
        best = fabs(row[j]) * pair.length;
        column = j;
        out.slot[k] = pair.dof + slot;
        for (int32_t i = 0; i < out.count; ++i) taken[i] = row[i];
      }
    });
    if (best == 0.0) return false;
    clear_row(turn, k, column, taken);
  }
  double most = 0.0;
  for (int32_t i = 0; i < m.head->pairs; ++i)
    for (int slot = 0; slot <= m.pair[i].tangential; ++slot) {
      double raw[kMostHeld], row[kMostHeld];
      motion_row(m, m.pair[i], slot, raw);
      combine_row(turn, raw, row);
      for (int32_t j = 0; j < out.count; ++j) most = fmax(most, fabs(row[j]));
    }
  sort(out);
  return most <= kMovesMost;
}

} // namespace

bool choose_held(c2d_solver* s, const Model& m, HeldSlots& out) {
  if (m.head->motions > kMostHeld) return false;
  return choose(s, m, false, out) || choose(s, m, true, out);
}

// ---- R and G on the tape ------------------------------------------------------------------------------------------------

namespace {

// The columns of a matrix of all bodies in the places of the pairs: visit(j, column, ranges of the body).
struct BodyColumn {
  int b;
  int32_t motion; // of all
  const Real* numbers;
};
template <class Visit> c2d_status for_columns(const Session& session, BodyMatrix matrix, Visit visit) {
  const Model& m = session.model;
  for (int b = 0; b < m.head->bodies; ++b)
    for (int32_t j = 0; j < m.body[b].free_motions && m.body[b].contact > 0; ++j) {
      const c2d_status status = read_column(session.tape, b, matrix, j, session.area.column);
      if (status != C2D_OK) return status;
      visit(BodyColumn{b, m.body[b].first_motion + j, session.area.column});
    }
  return C2D_OK;
}

// What combines the columns of a matrix so that they have 1 in their own slot and 0 in the others.
c2d_status find_turn(const Session& session, BodyMatrix matrix, const int32_t* slots, int32_t count, Turn& out) {
  double rows[kMostHeld][kMostHeld] = {}, most = 0.0;
  const c2d_status status = for_columns(session, matrix, [&](const BodyColumn& of) {
    for_ranges(session.model, of.b, [&](const UnknownRange& range) {
      for (int32_t i = 0; i < range.count; ++i) most = fmax(most, fabs(static_cast<double>(of.numbers[range.own + i])));
      for (int32_t k = 0; k < count; ++k)
        if (slots[k] >= range.all && slots[k] < range.all + range.count)
          rows[k][of.motion] += signed_on(range.side, static_cast<double>(of.numbers[range.own + slots[k] - range.all]));
    });
  });
  if (status != C2D_OK) return status;
  out = as_it_is(count);
  for (int32_t k = 0; k < count; ++k) {
    double row[kMostHeld];
    combine_row(out, rows[k], row);
    int32_t column = k;
    for (int32_t j = k; j < count; ++j)
      if (fabs(row[j]) > fabs(row[column])) column = j;
    if (!(fabs(row[column]) > kWeighsLeast * most)) return C2D_ERR_SINGULAR;
    clear_row(out, k, column, row);
  }
  return C2D_OK;
}

// The columns so combined, to the tape; of R on side 0 alone, too.
c2d_status write_turned(const Session& session, BodyMatrix matrix, const Turn& turn, const int32_t* slots, ContactMatrix to,
                        bool of_side_0) {
  const Model& m = session.model;
  const int64_t contact = m.head->contact;
  Real* const out = room_for_columns(session);
  for (int64_t i = 0; i < contact * turn.count; ++i) out[i] = 0;
  c2d_status status = for_columns(session, matrix, [&](const BodyColumn& of) {
    for_ranges(m, of.b, [&](const UnknownRange& range) {
      for (int32_t k = 0; k < turn.count && (!of_side_0 || range.side == 0); ++k) {
        const Real by =
            static_cast<Real>(of_side_0 ? turn.column(k)[of.motion] : signed_on(range.side, turn.column(k)[of.motion]));
        for (int32_t i = 0; i < range.count; ++i) out[k * contact + range.all + i] += by * of.numbers[range.own + i];
      }
    });
  });
  for (int32_t k = 0; k < turn.count && status == C2D_OK; ++k) {
    for (int32_t j = 0; j < turn.count && !of_side_0; ++j) out[k * contact + slots[j]] = j == k ? Real(1) : Real(0);
    status = write_column(session.tape, to, k, out + k * contact);
  }
  return status;
}

c2d_status write_basis(const Session& session, const HeldSlots& held, bool sliding) {
  Real* const basis = session.area.column;
  for (int32_t i = 0; i < session.model.head->contact; ++i)
    basis[i] = sliding && is_sliding_slot(session.model, i) ? kBasisNoForce : kBasisMotion;
  for (int32_t k = 0; k < held.count; ++k) basis[held.slot[k]] = kBasisForce;
  return write_column(session.tape, ContactMatrix::basis, 0, basis);
}

// ---- their columns and the rates of the loads ---------------------------------------------------------------------------

// The pairs of the slots, each once; how many.
int32_t list_pairs(const Model& m, const int32_t* slots, int32_t count, int32_t out[kMostHeld]) {
  int32_t listed = 0;
  for (int32_t k = 0; k < count; ++k) {
    const int32_t pair = pair_of_slot(m, slots[k]); // (slots ascend)
    if (listed == 0 || out[listed - 1] != pair) out[listed++] = pair;
  }
  return listed;
}

// G^T tau + given = 0 with G turned: the forces in the slots that hold.
c2d_status find_forces(const Session& session, const Turn& turn, int32_t k, double force[kMostHeld]) {
  const Model& m = session.model;
  for (int32_t s = 0; s < turn.count; ++s) force[s] = 0.0;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (m.body[b].contact == 0 || m.body[b].free_motions == 0) continue;
    Real g[kMostMotions];
    const c2d_status status = read_column(session.tape, b, BodyMatrix::given, k, g);
    if (status != C2D_OK) return status;
    for (int32_t s = 0; s < turn.count; ++s)
      for (int32_t j = 0; j < m.body[b].free_motions; ++j)
        force[s] -= turn.column(s)[m.body[b].first_motion + j] * static_cast<double>(g[j]);
  }
  return C2D_OK;
}

// y -= R y_H.
c2d_status move_along(const Session& session, const HeldSlots& held, Real* y) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < held.count && status == C2D_OK; ++k) {
    const Real *r = nullptr, by = y[held.slot[k]];
    status = view_column(session.tape, ContactMatrix::motions, k, &r);
    for (int32_t i = 0; i < session.model.head->contact && status == C2D_OK; ++i) y[i] -= by * r[i];
  }
  return status;
}

double largest_in(const Session& session, const Real* x) {
  return static_cast<double>(largest(kPlainEngine, session.model.head->contact, x));
}

// Of a body that bends much more than it gives way locally columns have lost digits (contact/reduction/open_form.hpp): those of
// the slots that hold motions tell.
c2d_status judge_columns(const Session& session, const HeldSlots& held) {
  const Model& m = session.model;
  for (int32_t k = 0; k < held.count; ++k) {
    const Real* a = nullptr;
    const c2d_status status = view_column(session.tape, ContactMatrix::compliance, held_column(m, held.slot[k]), &a);
    if (status != C2D_OK) return status;
    const int32_t pair = pair_of_slot(m, held.slot[k]);
    if (loses_digits(m, pair, held.slot[k] - m.pair[pair].dof, a, largest_in(session, a))) return C2D_ERR_LIMIT;
  }
  return C2D_OK;
}

// b of a load case from its h, as hold_rate of contact/reduction/open_form.cpp.
c2d_status write_rate(const Session& session, const HeldSlots& held, const Turn& turn, int32_t k) {
  const int32_t contact = session.model.head->contact;
  Real* const b = session.area.column;
  double force[kMostHeld];
  c2d_status status = read_column(session.tape, ContactMatrix::closing, k, b);
  if (status == C2D_OK) status = find_forces(session, turn, k, force);
  const double terms = status == C2D_OK ? largest_in(session, b) : 0.0;
  if (status == C2D_OK) status = move_along(session, held, b);
  if (status == C2D_OK && largest_in(session, b) <= kNothing * terms)
    for (int32_t i = 0; i < contact; ++i) b[i] = 0; // the loads move bodies as if rigid
  for (int32_t s = 0; s < held.count && status == C2D_OK; ++s) {
    const Real* a = nullptr;
    status = view_column(session.tape, ContactMatrix::compliance, held_column(session.model, held.slot[s]), &a);
    for (int32_t i = 0; i < contact && status == C2D_OK; ++i) b[i] += static_cast<Real>(force[s]) * a[i];
  }
  if (status == C2D_OK) status = move_along(session, held, b);
  for (int32_t s = 0; s < held.count; ++s) b[held.slot[s]] = static_cast<Real>(force[s]);
  return status == C2D_OK ? write_column(session.tape, ContactMatrix::stiffness_load, k, b) : status;
}

} // namespace

c2d_status hold_on_demand(c2d_solver* s, bool sliding) {
  Session session;
  open_session(s, session);
  const Model& m = session.model;
  HeldSlots held;
  Turn turn = as_it_is(0);
  const bool found = choose_held(s, m, held); // as it was planned
  c2d_status status = found ? c2d_status{C2D_OK} : c2d_status{C2D_ERR_SINGULAR};
  if (status == C2D_OK) status = find_turn(session, BodyMatrix::motions, held.slot, held.count, turn);
  if (status == C2D_OK) status = write_turned(session, BodyMatrix::motions, turn, held.slot, ContactMatrix::motions, false);
  if (status == C2D_OK) status = write_turned(session, BodyMatrix::motions, turn, held.slot, ContactMatrix::motion, true);
  if (status == C2D_OK) status = find_turn(session, BodyMatrix::resultants, held.slot, held.count, turn);
  if (status == C2D_OK)
    status = write_turned(session, BodyMatrix::resultants, turn, held.slot, ContactMatrix::resultants, false);
  if (status == C2D_OK) status = write_basis(session, held, sliding);
  int32_t pair[kMostHeld];
  const int32_t pairs = list_pairs(m, held.slot, held.count, pair);
  s->sliding = sliding; // (build_judge says so again)
  if (status == C2D_OK) status = make_some(session, pair, pairs, false);
  if (status == C2D_OK) status = judge_columns(session, held);
  for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) status = write_rate(session, held, turn, k);
  return status;
}

c2d_status count_held(c2d_solver* s) {
  Session session;
  open_session(s, session);
  Form form;
  c2d_status status = read_form(session.tape, session.area.column, &form);
  int32_t pair[kMostHeld];
  const int32_t pairs = list_pairs(session.model, form.held, form.count, pair);
  if (status != C2D_OK || pairs == 0) return status;
  for (int32_t i = 0; i < pairs; ++i) session.model.pair[pair[i]].made = -1;
  s->made = 0; // they are the first, and come to the same places
  return make_some(session, pair, pairs, true);
}

c2d_status remake_columns(c2d_solver* s) {
  Session session;
  open_session(s, session);
  const Model& m = session.model;
  const int32_t made = s->made;
  c2d_status status = C2D_OK;
  s->made = 0;
  while (s->made < made && status == C2D_OK) {
    int32_t next = 0;
    while (next < m.head->pairs && m.pair[next].made != s->made) ++next;
    if (next == m.head->pairs) return C2D_ERR_INTERNAL; // what a stranger has saved
    m.pair[next].made = -1;
    status = make_some(session, &next, 1, false); // and gets the number that it had
  }
  return status;
}

// ---- energies -----------------------------------------------------------------------------------------------------------

c2d_status functional_of_motions(const Session& session, int b, const Real* outer, Real* motion) {
  const int32_t count = session.model.body[b].free_motions;
  if (count == 0 || session.model.body[b].contact == 0) return C2D_OK;
  Real* x = nullptr;
  const c2d_status status = solve_body_motions(session, b, &x);
  for (int32_t k = 0; k < count && status == C2D_OK; ++k) {
    double sum = 0.0;
    for (int32_t i = 0; i < outer_columns(session.model, b); ++i)
      sum += static_cast<double>(outer[i]) * static_cast<double>(x[static_cast<int64_t>(i) * count + k]);
    motion[session.model.body[b].first_border + k] += static_cast<Real>(sum);
  }
  return status;
}

c2d_status hold_functional(const Session& session, const Real* motion, Real* jump, double* lambda) {
  const ModelHeader& head = *session.model.head;
  Form form;
  c2d_status status = read_form(session.tape, session.area.column, &form);
  Turn turn = as_it_is(0);
  if (status == C2D_OK) status = find_turn(session, BodyMatrix::motions, form.held, form.count, turn);
  double part[kMostHeld] = {};
  for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) {
    for (int32_t j = 0; j < form.count; ++j) part[k] += turn.column(k)[j] * static_cast<double>(motion[j]);
    jump[form.held[k]] += static_cast<Real>(part[k]);
  }
  for (int32_t i = 0; i < head.load_cases && status == C2D_OK && form.count > 0; ++i) {
    const Real* h = nullptr;
    status = view_column(session.tape, ContactMatrix::closing, i, &h);
    for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) {
      const Pair& pair = session.model.pair[pair_of_slot(session.model, form.held[k])];
      const bool closes = i + 1 == head.interference && pair.dof == form.held[k]; // h has it taken off
      lambda[i] -= part[k] * (static_cast<double>(h[form.held[k]]) + (closes ? pair.overlap / head.length_unit : 0.0));
    }
  }
  return status;
}

} // namespace c2d
