#include "contact/tableau.hpp"

#include "contact/asleep.hpp"
#include "contact/basis.hpp"
#include "contact/held_columns.hpp"
#include "contact/let_go.hpp"
#include "contact/start.hpp"
#include "linalg/dense.hpp"
#include "linalg/exchange.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(SearchPart);

namespace {

// A pivot this small against the stiffness of its own pair means a motion that nothing else holds: one about to begin, not a
// number to divide by. Stiffness ratios of slender supports stay above 1e-8; round-off of a free motion is 1e-14.
constexpr double kFreePivot = sizeof(Real) == 8 ? 1e-10 : 1e-5;
constexpr double kTinyCompliance = 1e-14;
constexpr double kLeastStiffness = 1e-6; // of a pair, against the stiffest
constexpr double kGoodPivot = 1e-3;      // building: no need to look for a better one

Real* column(const Tableau& t, int32_t j) { return t.t + static_cast<int64_t>(t.m) * j; }
Real entry(const Tableau& t, int32_t i, int32_t j) { return column(t, j)[i]; }
int32_t all_columns(const Tableau& t) { return tableau_columns(t); }

// What is kept of T beside it, of all that are awake.
void read_all_own(const Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i)
    if (!is_asleep(t, i)) read_own(t, i);
}

// As the list's last exchange, of this slot, has changed them.
void change_own(const Tableau& t, const Pair& changed, int32_t slot, const Real* u, const Real* v) {
  t.own[slot] = 0;
  if (changed.tangential) t.cross[changed.dof] = t.cross[changed.dof + 1] = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    if (t.column[i] < 0) continue;
    const int32_t a = t.pair[i].dof, b = a + 1;
    const Real *const normal = v + t.column[i], *const tangent = normal + 1;
    t.own[a] -= u[a] * *normal;
    if (t.pair[i].tangential == 0 || t.smooth) continue;
    t.own[b] -= u[b] * *tangent;
    t.cross[a] -= u[a] * *tangent;
    t.cross[b] -= u[b] * *normal;
  }
}

// A full list is applied before one more exchange, but for those of pairs that have begun to slip since: where an edge of slip
// passes they stick again, some events later, and then both exchanges are gone.
void make_room(Tableau& t, const Pair& changing, int32_t row, int32_t column) {
  DelayedExchanges& list = t.delayed;
  if (list.count < list.most || place_in_list(list, row, column) >= 0) return;
  bool kept[kMostDelayed] = {};
  int32_t count = 0;
  for (int32_t i = 0; i < t.pairs && !t.smooth; ++i) {
    const Pair& pair = t.pair[i];
    if (pair.status != C2D_SLIP || pair.tangential == 0 || is_asleep(t, i) || &pair == &changing) continue;
    const int32_t place = place_in_list(list, pair.dof + 1, column_of(t, i, 1));
    if (place < 0) continue;
    kept[place] = true;
    ++count;
  }
  apply_all_but(list, t.engine, 2 * count <= list.most ? kept : nullptr); // else there would be little room
}

void pivot(Tableau& t, const Pair& pair, int slot) {
  ++t.exchanges;
  const int32_t row = pair.dof + slot;
  if (!delays(t)) {
    exchange(t.m, all_columns(t), t.t, t.m, row, row, t.engine.kernel);
    return;
  }
  const Real *u = nullptr, *v = nullptr;
  const int32_t place = column_of(t, static_cast<int32_t>(&pair - t.pair), slot);
  make_room(t, pair, row, place);
  const bool done = delay_exchange(t.delayed, t.engine, row, place, &u, &v);
  if (C2D_NEVER(!done)) return; // pivots have been judged
  for (int32_t j = t.n; j < all_columns(t); ++j) {
    const Real factor = column(t, j)[row];
    column(t, j)[row] = 0;
    gemm_minus(t.engine, t.m, 1, 1, u, t.m, &factor, 1, column(t, j), t.m);
  }
  change_own(t, pair, row, u, v);
}

bool stiff(const Pair& pair, int slot, double value) { return fabs(value) > kFreePivot * pair.stiffness[slot]; }
bool compliant(const Pair& pair, int slot, double value) { return fabs(value) * pair.stiffness[slot] > kTinyCompliance; }

// Both slots of a pair, the larger pivot first. `usable` judges each pivot before anything changes.
bool exchange_pair(Tableau& t, const Pair& pair, bool (*usable)(const Pair&, int, double)) {
  const int32_t a = pair.dof, b = pair.dof + 1;
  C2D_ASSERT(a >= 0 && a + pair.tangential < all_columns_of(t) && !is_asleep(t, static_cast<int32_t>(&pair - t.pair)));
  if (!pair.tangential) {
    if (!usable(pair, 0, own_entry(t, a))) return false;
    pivot(t, pair, 0);
    return true;
  }
  const double aa = own_entry(t, a), bb = own_entry(t, b);
  const bool normal_first = fabs(aa) >= fabs(bb);
  const double first = normal_first ? aa : bb, second = normal_first ? bb : aa;
  const int slot = normal_first ? 0 : 1;
  if (!usable(pair, slot, first)) return false;
  if (!usable(pair, 1 - slot, second - static_cast<double>(cross_entry(t, a, b)) * cross_entry(t, b, a) / first)) return false;
  if (kSmallCode || delays(t)) {
    pivot(t, pair, slot);
    pivot(t, pair, 1 - slot);
  } else {
    exchange_two(t.m, all_columns(t), t.t, t.m, a + slot, b - slot, t.engine.kernel);
    t.exchanges += 2;
  }
  return true;
}

// Rows and columns of one pair: `target` += factor times the other; the normal column += factor times the tangential one.
void add_row(Tableau& t, int32_t target, double by, int32_t source) {
  const Real factor = static_cast<Real>(by);
  if (factor == 0) return;
  if (!delays(t)) return row_add(all_columns(t), t.t, t.m, target, source, factor);
  delayed_row_add(t.delayed, target, source, factor);
  row_add(all_columns(t) - t.n, constants(t), t.m, target, source, factor);
  t.own[target] += factor * t.cross[source];
  t.cross[target] += factor * t.own[source];
}
void add_tangent_column(Tableau& t, const Pair& pair, double by) {
  const Real factor = static_cast<Real>(by);
  if (factor == 0) return;
  const int32_t target = pair.dof, source = target + 1;
  if (!delays(t)) return column_add(t.m, t.t, t.m, target, source, factor);
  const int32_t normal = t.column[&pair - t.pair];
  delayed_column_add(t.delayed, normal, normal + 1, factor);
  t.own[target] += factor * t.cross[target];
  t.cross[source] += factor * t.own[source];
}

// ---- the six elementary changes; slots a = normal, b = tangential -------------------------------------------------

bool open_to_stick(Tableau& t, Pair& pair, double at) {
  Real* offset = pair.tangential ? &constants(t)[pair.dof + 1] : nullptr;
  if (offset) *offset -= static_cast<Real>(at);
  if (!exchange_pair(t, pair, compliant)) {
    if (offset) *offset += static_cast<Real>(at);
    return false;
  }
  pair.offset = static_cast<Real>(at);
  return true;
}

bool stick_to_open(Tableau& t, Pair& pair) {
  if (!exchange_pair(t, pair, stiff)) return false;
  if (pair.tangential) constants(t)[pair.dof + 1] += static_cast<Real>(pair.offset);
  return true;
}

bool stick_to_slip(Tableau& t, Pair& pair, int32_t sign) {
  const int32_t a = pair.dof, b = a + 1;
  if (!pair.tangential) return true;
  const double f = pair.law.slope(sign);
  if (!stiff(pair, 1, own_entry(t, b) - f * cross_entry(t, a, b))) return false;
  add_row(t, b, -f, a);
  pivot(t, pair, 1);
  constants(t)[b] += static_cast<Real>(pair.offset);
  return true;
}

bool slip_to_stick(Tableau& t, Pair& pair, double at) {
  const int32_t a = pair.dof, b = a + 1;
  if (!pair.tangential) return true;
  if (!compliant(pair, 1, own_entry(t, b))) return false;
  constants(t)[b] -= static_cast<Real>(at);
  pivot(t, pair, 1);
  add_row(t, b, pair.law.slope(pair.sign), a);
  pair.offset = static_cast<Real>(at);
  return true;
}

bool slip_to_open(Tableau& t, Pair& pair) {
  const int32_t a = pair.dof;
  if (!stiff(pair, 0, own_entry(t, a))) return false;
  pivot(t, pair, 0);
  if (pair.tangential) add_tangent_column(t, pair, -pair.law.slope(pair.sign));
  return true;
}

bool open_to_slip(Tableau& t, Pair& pair, int32_t sign) {
  const int32_t a = pair.dof, b = a + 1;
  const double f = pair.tangential ? pair.law.slope(sign) : 0.0;
  const double pivot_value = own_entry(t, a) + (f != 0.0 ? f * cross_entry(t, a, b) : 0.0);
  if (!compliant(pair, 0, pivot_value)) return false;
  if (pair.tangential) add_tangent_column(t, pair, f);
  pivot(t, pair, 0);
  return true;
}

bool change(Tableau& t, Pair& pair, int32_t status, int32_t sign, double at) {
  switch (pair.status) {
  case C2D_OPEN: return status == C2D_STICK ? open_to_stick(t, pair, at) : open_to_slip(t, pair, sign);
  case C2D_STICK: return status == C2D_OPEN ? stick_to_open(t, pair) : stick_to_slip(t, pair, sign);
  default: return status == C2D_OPEN ? slip_to_open(t, pair) : slip_to_stick(t, pair, at);
  }
}

} // namespace

bool change_status(Tableau& t, int32_t index, int32_t status, int32_t sign, double at) {
  Pair& pair = t.pair[index];
  C2D_ASSERT(index != t.guided - 1 && !(t.smooth && pair.tangential && status == C2D_STICK));
  if (pair.status == status && (status != C2D_SLIP || pair.sign == sign)) return true;
  if (pair.status == C2D_OPEN && is_let_go(t)) return false;
  if (C2D_NEVER(is_asleep(t, index))) return false;    // whatever touches has been woken
  if (pair.status == C2D_SLIP && status == C2D_SLIP) { // the other way: by sticking in between
    const int32_t old_sign = pair.sign;
    if (!slip_to_stick(t, pair, at)) return false;
    pair.status = C2D_STICK;
    if (!stick_to_slip(t, pair, sign)) {
      stick_to_slip(t, pair, old_sign);
      pair.status = C2D_SLIP;
      return false;
    }
  } else if (!change(t, pair, status, sign, at)) {
    return false;
  }
  pair.status = static_cast<int8_t>(status);
  pair.sign = static_cast<int8_t>(status == C2D_SLIP ? sign : 0);
  return true;
}

// ---- building -----------------------------------------------------------------------------------------------------

namespace {

// Motions of the pairs when the body slides freely.
struct Sliding {
  const Tableau& t;
  double of(int32_t pair, int slot) const {
    double w[2];
    motion_at_pair(*t.model, t.body->body, t.body->slide, t.body->centre, t.pair[pair], w);
    return w[slot];
  }
};

// A spring against the mean of the pairs' motions in the way in which the body slides freely (METHOD 13.6). As the loads do no
// work on it, it stays without force, and its stiffness does not matter.
void hold_slide(Tableau& t) {
  if (!t.body || t.body->slides == 0) return;
  const Sliding slide{t};
  for (int32_t j = 0; j < t.pairs; ++j)
    for (int c = 0; c <= t.pair[j].tangential; ++c) {
      const double part = t.stiffness * t.pair[j].length * slide.of(j, c);
      for (int32_t i = 0; i < t.pairs; ++i)
        for (int r = 0; r <= t.pair[i].tangential; ++r)
          column(t, column_of(t, j, c))[t.pair[i].dof + r] += static_cast<Real>(part * slide.of(i, r));
    }
}

bool is_smooth(const Tableau& t) {
  bool smooth = delays(t);
  for (int32_t i = 0; i < t.pairs && smooth; ++i) smooth = t.pair[i].tangential == 0 || t.pair[i].law.is_smooth();
  return smooth;
}

// Slots whose motion is among the unknowns of the tableau on the tape have left the basis in which every pair sticks.
c2d_status load_basis(Tableau& t, const ContactTape& tape, Form* form) {
  for (int32_t i = 0; i < t.pairs; ++i) t.pair[i].mark.exchanged = 0;
  if (kSmallCode || !delays(t)) return C2D_OK;
  Real* const basis = t.t;
  const c2d_status status = read_form(tape, basis, form);
  if (status != C2D_OK) return status;
  t.smooth = form->sliding && is_smooth(t); // but in what a stranger may have saved it is
  t.delayed.count = 0;
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int slot = 0; slot <= t.pair[i].tangential; ++slot)
      if (basis[t.pair[i].dof + slot] != kBasisForce)
        t.pair[i].mark.exchanged = static_cast<uint8_t>(t.pair[i].mark.exchanged | 1 << slot) & 3;
  return C2D_OK;
}

// Where columns go, one after another; of pairs that sleep they go nowhere.
void place_columns(Tableau& t, bool some_sleep) {
  if (!delays(t)) return;
  t.delayed.cols = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    t.column[i] = some_sleep && pair.status == C2D_OPEN && pair.mark.exchanged == 1 + 2 * pair.tangential ? -1 : t.delayed.cols;
    if (t.column[i] >= 0) t.delayed.cols += 1 + last_slot(t, pair);
  }
}

// How stiff a slot is while those beside it rest: T's own entry with every pair sticking; else A tells.
double own_stiffness(const Tableau& t, const ContactTape& tape, const Form& form, int32_t i, int slot, const Real* column) {
  if (kSmallCode || !form.open) return fabs(static_cast<double>(column[t.pair[i].dof + slot]));
  const double compliance = local_compliance(*tape.model, i, slot, column);
  return compliance > 0.0 ? 1.0 / compliance : 0.0;
}

// Pairs that are awake need their columns on demand, many at a time. Before any is there, that of one pair is made, to tell how
// stiff pairs are.
c2d_status need_awake(const Tableau& t, const ContactTape& tape) {
  if (!is_on_demand(*tape.model)) return C2D_OK;
  bool some = false;
  for (int32_t i = 0; i < t.pairs; ++i) some = some || t.pair[i].made >= 0 || !is_asleep(t, i);
  int32_t needed[kMostDelayed] = {0}, count = some ? 0 : 1;
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < t.pairs && status == C2D_OK; ++i) {
    if (is_asleep(t, i) || t.pair[i].made >= 0) continue;
    needed[count++] = i;
    if (count < kMostDelayed) continue;
    status = need_columns(tape, needed, count);
    count = 0;
  }
  return status == C2D_OK && count > 0 ? need_columns(tape, needed, count) : status;
}

// Columns of the pairs that are awake, which stand one after another.
c2d_status load_open_columns(const Tableau& t, const ContactTape& tape, const Form& form) {
  OpenColumns columns{tape, form, t.t, 0, {}};
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int slot = 0; slot <= last_slot(t, t.pair[i]) && !is_asleep(t, i) && status == C2D_OK; ++slot)
      status = columns.take(t.pair[i].dof + slot);
  return status == C2D_OK ? columns.finish() : status;
}

c2d_status load_start(Tableau& t, const ContactTape& tape) {
  Form form;
  c2d_status status = load_basis(t, tape, &form);
  t.stiffness = 0.0;
  t.open = form.open;
  t.sliding = form.sliding;
  // (Without friction there are no columns of tangents, in which a motion that they hold would go on.)
  place_columns(t, !kSmallCode && may_sleep(t, form) && !(is_smooth(t) && holds_tangents(*t.model, form)));
  if (!kSmallCode && status == C2D_OK) status = need_awake(t, tape);
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int slot = 0; slot <= last_slot(t, t.pair[i]) && status == C2D_OK; ++slot) {
      if (is_on_demand(*tape.model) && t.pair[i].made < 0) continue;
      Real* const to = is_asleep(t, i) ? constants(t) : column(t, column_of(t, i, slot));
      const int32_t dof = t.pair[i].dof + slot;
      status = form.open ? read_compliance(tape, t.pair[i], slot, to) : read_column(tape, ContactMatrix::stiffness, dof, to);
      if (status != C2D_OK) break;
      const double own = own_stiffness(t, tape, form, i, slot, to);
      t.stiffness = fmax(t.stiffness, own);
      t.pair[i].stiffness[slot] = static_cast<Real>(own);
    }
  if (!kSmallCode && form.open && status == C2D_OK) status = load_open_columns(t, tape, form);
  if (status == C2D_OK) status = read_matrix(tape, ContactMatrix::stiffness_load, load_rates(t, 0), t.m);
  if (status != C2D_OK) return status;
  for (int32_t i = 0; i < t.m; ++i) constants(t)[i] = 0;
  for (int32_t i = 0; i < t.m && follows_slip(t); ++i) slip_rates(t)[i] = 0;
  if (!(t.stiffness > 0.0)) t.stiffness = 1.0; // pairs that hold a body and nothing else
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int slot = 0; slot <= t.pair[i].tangential; ++slot) {
      Real* const own = t.pair[i].stiffness;
      own[slot] = static_cast<Real>(
          fmax(static_cast<double>(own[slot <= last_slot(t, t.pair[i]) ? slot : 0]), kLeastStiffness * t.stiffness));
    }
  hold_slide(t);
  return C2D_OK;
}

// Slots that must leave the all-stick basis: both of an open pair, the tangential one of a slipping pair.
bool must_leave(const Pair& pair, int slot) {
  if (slot == 1) return pair.status != C2D_STICK;
  return pair.status == C2D_OPEN;
}

bool has_left(const Pair& pair, int slot) { return (pair.mark.exchanged >> slot & 1) != 0; }

// From w = (gap, 0) a pair in contact comes to w = (0, offset), if it slips (0, 0): by how much in a slot.
double closing(const Tableau& t, const Pair& pair, int slot) {
  if (slot == 0) return -gap_of(t, pair);
  return pair.status == C2D_STICK ? pair.offset : 0.0;
}

// Slots in which forces are given on the tape have those motions to come to rest at, in the others they are given.
void impose(const Tableau& t, int32_t pair, int slot, double by, Real* c) {
  if (has_left(t.pair[pair], slot)) {
    c[t.pair[pair].dof + slot] -= static_cast<Real>(by);
    return;
  }
  for (int32_t row = 0; row < t.m && by != 0.0; ++row)
    c[row] += static_cast<Real>(by) * entry(t, row, column_of(t, pair, slot));
}

// Close the gaps of the pairs in contact.
void impose_contact(Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    if (pair.status == C2D_OPEN) continue;
    for (int slot = 0; slot <= pair.tangential; ++slot) impose(t, i, slot, closing(t, pair, slot), constants(t));
    if (follows_slip(t)) impose(t, i, 0, -gap_rate(t, pair), slip_rates(t));
  }
}

void takes_part(Pair& pair, int slot) { pair.mark.exchanged = static_cast<uint8_t>(pair.mark.exchanged & ~(1 << slot)) & 3; }

// Of a closed pair whose normal force is an unknown on the tape: that of its tangent, too, from which friction is taken.
bool bring_tangents_in(Tableau& t, int32_t* culprit) {
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    const bool rubs = pair.status == C2D_STICK || (pair.status == C2D_SLIP && !pair.law.is_smooth());
    if (pair.tangential == 0 || !rubs || has_left(pair, 0) || !has_left(pair, 1)) continue;
    if (!compliant(pair, 1, own_entry(t, pair.dof + 1))) {
      *culprit = i;
      return false;
    }
    pivot(t, pair, 1);
    takes_part(pair, 1);
  }
  return true;
}

// A closed pair that is open on the tape, or whose tangent alone holds a body there.
bool bring_pair_in(Tableau& t, Pair& pair) {
  const int32_t a = pair.dof;
  if (pair.tangential != 0 && !has_left(pair, 1)) {
    if (!compliant(pair, 0, own_entry(t, a))) return false;
    pivot(t, pair, 0); // both forces are unknowns then
  } else if (pair.status == C2D_STICK) {
    if (!exchange_pair(t, pair, compliant)) return false;
    takes_part(pair, 1);
  } else {
    const double f = pair.tangential ? pair.law.slope(pair.sign) : 0.0;
    if (!compliant(pair, 0, own_entry(t, a) + (f != 0.0 ? f * cross_entry(t, a, a + 1) : 0.0))) return false;
    if (f != 0.0) add_tangent_column(t, pair, f);
    pivot(t, pair, 0);
  }
  takes_part(pair, 0);
  return true;
}

// All pairs that are closed, the one first that gives way most. Bodies at rest in the slots that hold them give way wherever
// they are pressed; only friction can be against it.
bool bring_in(Tableau& t, int32_t* culprit) {
  if (!bring_tangents_in(t, culprit)) return false;
  for (;;) {
    Pair* next = nullptr;
    double best = -1.0;
    for (int32_t i = 0; i < t.pairs; ++i) {
      Pair& pair = t.pair[i];
      if (pair.status == C2D_OPEN || !has_left(pair, 0)) continue;
      const double size = pair.stiffness[0] * fabs(static_cast<double>(own_entry(t, pair.dof)));
      if (size <= best) continue;
      best = size;
      next = &pair;
    }
    if (!next) return true;
    if (!bring_pair_in(t, *next)) {
      *culprit = static_cast<int32_t>(next - t.pair);
      return false;
    }
  }
}

// q into r of slipping pairs, of which both forces are unknowns.
void impose_friction(Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    if (pair.status == C2D_SLIP && pair.tangential && !has_left(pair, 1))
      add_row(t, pair.dof + 1, -pair.law.slope(pair.sign), pair.dof);
  }
}

// A slot among those that still must leave.
struct Slot {
  Pair* pair;
  int which;
  int32_t dof() const { return pair->dof + which; }
  int32_t column_in(const Tableau& t) const { return column_of(t, static_cast<int32_t>(pair - t.pair), which); }
  void is_done() const { pair->mark.exchanged = static_cast<uint8_t>(pair->mark.exchanged | 1 << which) & 3; }
};
bool stays(const Pair& pair, int which) { return !must_leave(pair, which) || has_left(pair, which); }

template <class Visit> void visit_leaving(const Tableau& t, Visit visit) {
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int which = 0; which <= t.pair[i].tangential; ++which)
      if (!stays(t.pair[i], which)) visit(Slot{&t.pair[i], which});
}

// The largest pivot: on the diagonal if that is a good one, else anywhere among the slots that must leave. 0: none is left.
double largest_pivot(Tableau& t, Slot* row, Slot* column) {
  double best = 0.0;
  visit_leaving(t, [&](const Slot& slot) {
    const double size = fabs(static_cast<double>(own_entry(t, slot.dof())));
    if (size <= best && best > 0.0) return;
    best = size;
    *row = *column = slot;
  });
  if (!row->pair || best > kGoodPivot * column->pair->stiffness[column->which]) return best;
  apply_list(t);
  visit_leaving(t, [&](const Slot& c) {
    visit_leaving(t, [&](const Slot& r) {
      const double size = fabs(static_cast<double>(entry(t, r.dof(), c.column_in(t))));
      if (size <= best) return;
      best = size;
      *row = r;
      *column = c;
    });
  });
  return best;
}

void swap_rows(const Tableau& t, int32_t a, int32_t b) {
  if (a == b) return;
  const int32_t used = used_columns(t);
  for (int32_t j = 0; j < all_columns(t); j = j + 1 == used ? t.n : j + 1) {
    const Real kept = column(t, j)[a];
    column(t, j)[a] = column(t, j)[b];
    column(t, j)[b] = kept;
  }
  if (delays(t)) read_all_own(t);
}
Slot slot_of(const Tableau& t, int32_t dof) {
  for (int32_t i = 0;; ++i)
    if (dof <= t.pair[i].dof + t.pair[i].tangential) return {&t.pair[i], dof - t.pair[i].dof};
}

void swap_columns(const Tableau& t, int32_t a, int32_t b) {
  Real *first = slot_column(t, a), *second = slot_column(t, b);
  for (int32_t i = 0; i < t.m; ++i) {
    const Real kept = first[i];
    first[i] = second[i];
    second[i] = kept;
  }
}

// Pivots off the diagonal leave the columns that left in each other's places.
void sort_columns(const Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int which = 0; which <= t.pair[i].tangential; ++which) {
      int32_t* const place = &t.pair[i].place[which];
      while (*place != t.pair[i].dof + which) {
        const Slot other = slot_of(t, *place);
        swap_columns(t, t.pair[i].dof + which, *place);
        *place = other.pair->place[other.which];
        other.pair->place[other.which] = other.dof();
      }
    }
}

// Slots for which there is no pivot left, if they are the free motions of a body that no pair touches, or bodies may rest; else
// -1.
int32_t slots_left(const Tableau& t, int32_t left[kMostResting]) {
  int32_t count = 0;
  visit_leaving(t, [&](const Slot& slot) {
    if (count < kMostResting) left[count] = slot.dof();
    ++count;
  });
  const bool let_go = is_let_go(t) && t.free_motions <= kFreeMotions && count == t.free_motions;
  return let_go || (t.may_rest != 0 && count <= kMostResting) ? count : -1;
}

// Exchanges all slots that must leave the all-stick basis, but for left[0 .. count): false, if others have no pivot.
bool exchange_leaving(Tableau& t, int32_t* culprit, int32_t left[kMostResting], int32_t* count) {
  for (int32_t i = 0; i < t.pairs; ++i)
    for (int which = 0; which < 2; ++which) t.pair[i].place[which] = t.pair[i].dof + which;
  for (;;) {
    Slot row{nullptr, 0}, column{nullptr, 0};
    const double size = largest_pivot(t, &row, &column);
    if (!row.pair) break;
    if (!(size > kFreePivot * column.pair->stiffness[column.which])) {
      *culprit = static_cast<int32_t>(column.pair - t.pair);
      *count = slots_left(t, left);
      return *count > 0;
    }
    swap_rows(t, row.dof(), column.dof());
    const int32_t kept = row.pair->place[row.which];
    row.pair->place[row.which] = column.pair->place[column.which];
    column.pair->place[column.which] = kept;
    pivot(t, *column.pair, column.which);
    column.is_done();
  }
  return true;
}

// Without friction no column of a tangential slot is looked at again.
void leave_normal_columns(Tableau& t) {
  if (kSmallCode || t.smooth) return;
  t.smooth = is_smooth(t);
  if (!t.smooth) return;
  t.delayed.cols = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    if (t.column[i] < 0) continue;
    const int32_t to = t.delayed.cols++;
    for (int32_t row = 0; row < t.m; ++row) column(t, to)[row] = entry(t, row, t.column[i]);
    t.column[i] = to;
  }
}

void restore_gaps(Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    if (pair.status != C2D_OPEN) continue;
    constants(t)[pair.dof] += static_cast<Real>(gap_of(t, pair));
    if (follows_slip(t)) slip_rates(t)[pair.dof] += static_cast<Real>(gap_rate(t, pair));
  }
}

// While the tableau is built a guided pair is what it is there, a sticking one.
struct GuidedSticks {
  Pair* pair;
  int8_t sign;
  explicit GuidedSticks(Tableau& t) : pair(t.guided > 0 ? &t.pair[t.guided - 1] : nullptr), sign(pair ? pair->sign : 0) {
    if (pair) pair->status = C2D_STICK, pair->sign = 0;
  }
  ~GuidedSticks() {
    if (pair) pair->status = C2D_SLIP, pair->sign = sign;
  }
};

} // namespace

c2d_status build_tableau(Tableau& t, const ContactTape& tape, int32_t* culprit) {
  const GuidedSticks guided(t);
  const c2d_status status = load_start(t, tape);
  if (status != C2D_OK) return status;
  if (delays(t)) read_all_own(t);
  impose_contact(t);
  if (!kSmallCode && !bring_in(t, culprit)) return C2D_ERR_SINGULAR;
  impose_friction(t);
  int32_t left[kMostResting], count = 0;
  t.resting = 0;
  if (!exchange_leaving(t, culprit, left, &count)) return C2D_ERR_SINGULAR;
  apply_list(t);
  const bool let_go = is_let_go(t) && t.free_motions <= kFreeMotions;
  if (let_go && count != t.free_motions) return C2D_ERR_SINGULAR; // round-off held what nothing holds
  if (!let_go && count > 0 && !kSearchPart.may_rest(t, left, count)) return C2D_ERR_SINGULAR;
  for (int32_t j = t.n; j < all_columns(t); ++j)
    for (int32_t k = 0; k < count; ++k) column(t, j)[left[k]] = 0; // a body that is let go, at rest
  restore_gaps(t);
  bool placed = true;
  if (let_go) placed = kSearchPart.place_body(t, left, count);
  if (C2D_NEVER(!placed)) return C2D_ERR_SINGULAR; // contact/let_go.cpp
  for (; !let_go && t.resting < count; ++t.resting) {
    const bool rests = kSearchPart.rest_along(t, left[t.resting], static_cast<Real*>(tape.buffer));
    if (C2D_NEVER(!rests)) return C2D_ERR_SINGULAR; // contact/let_go.cpp
  }
  sort_columns(t);
  leave_normal_columns(t);
  if (delays(t)) read_all_own(t);
  if (!kSmallCode && let_go) end_sleep(t);
  return C2D_OK;
}

// ---- reading ------------------------------------------------------------------------------------------------------

Real* slot_column(const Tableau& t, int32_t slot) { return column(t, delays(t) ? slot_of(t, slot).column_in(t) : slot); }

template <bool hostile> int32_t longest_list(int64_t all) {
  if constexpr (hostile)
    if (all > kHostileWidth) return kHostileWidth;
  return static_cast<int32_t>(all);
}

void place_list(Tableau& t, Real* numbers, int32_t count, int32_t columns) {
  if (kSmallCode) return;
  const int64_t m = t.m;
  const int32_t most = longest_list<kHostile>(delayed_exchanges(m));
  t.own = numbers;
  t.cross = numbers + m;
  t.column = reinterpret_cast<int32_t*>(numbers + 2 * m);
  t.delayed = {t.m, columns, t.t, most, numbers + 3 * m, count};
  t.smooth = is_smooth(t);
}

void read_own(const Tableau& t, int32_t i) {
  const int32_t a = t.pair[i].dof, b = a + 1, normal = t.column[i], tangent = normal + 1;
  t.own[a] = entry(t, a, normal);
  if (t.pair[i].tangential == 0 || t.smooth) return;
  t.own[b] = entry(t, b, tangent);
  t.cross[a] = entry(t, a, tangent);
  t.cross[b] = entry(t, b, normal);
}

void add_column_to(const Tableau& t, int32_t j, double factor, Real* y) {
  const Real by = static_cast<Real>(factor);
  if (delays(t)) return add_column_to(t.delayed, t.engine, j, by, y);
  for (int32_t i = 0; i < t.m; ++i) y[i] += by * entry(t, i, j);
}
void find_slip_rates(const Tableau& t) {
  Real *const rates = slip_rates(t), by[kMostDelayed] = {};
  for (int32_t i = 0; i < t.m; ++i) rates[i] = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Real rate = static_cast<Real>(t.slip[i].rate);
    if (rate == 0) continue;
    if (t.pair[i].status == C2D_OPEN)
      rates[t.pair[i].dof] += rate;
    else if (delays(t))
      add_before_list(t.delayed, column_of(t, i, 0), -rate, rates, by);
    else
      add_column_to(t, column_of(t, i, 0), -t.slip[i].rate, rates);
  }
  if (delays(t)) subtract_list(t.delayed, t.engine, by, rates);
}
void apply_list(Tableau& t) {
  if (delays(t)) apply_delayed(t.delayed, t.engine);
}

void combine(const Tableau& t, const double* factor, bool with_constants, Real* out) {
  const Real* const from = constants(t);
  if (with_constants)
    for (int32_t i = 0; i < t.m; ++i) out[i] = from[i];
  else
    for (int32_t i = 0; i < t.m; ++i) out[i] = follows_slip(t) ? slip_rates(t)[i] : Real(0);
  for (int32_t k = 0; k < t.cases; ++k) {
    const Real f = static_cast<Real>(factor[k]);
    const Real* rate = load_rates(t, k);
    if (delays(t) && t.engine.kernel) {
      t.engine.kernel->add(t.m, f, rate, out);
      continue;
    }
    for (int32_t i = 0; i < t.m; ++i) out[i] += f * rate[i];
  }
}

} // namespace c2d
