#include "contact/asleep.hpp"

#include <string.h>

#include "contact/held_columns.hpp"
#include "contact/let_go.hpp"
#include "contact/start.hpp"
#include "linalg/dense.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

Real* t_column(const Tableau& t, int32_t j) { return t.t + static_cast<int64_t>(t.m) * j; }

// Pairs that wake together: one, and as many as have as many columns as the list is long, a function of the number of unknowns,
// or, where columns need no more than be read, twice as many: the list has room for what they say of those that are awake.
struct Waking {
  int32_t count, columns;
  int32_t pair[kMostDelayed];
};
bool add(const Tableau& t, int32_t pair, Waking& w) {
  const int32_t columns = 1 + last_slot(t, t.pair[pair]);
  const int32_t most = is_on_demand(*t.model) ? t.delayed.most : 2 * t.delayed.most;
  if (w.count > 0 && (w.count == kMostDelayed || w.columns + columns > most)) return false;
  w.pair[w.count++] = pair;
  w.columns += columns;
  return true;
}

// Has y of this slot on the tape changed places with its z? There it is a motion, but a force where bodies are held.
bool has_changed_places(const Tableau& t, const Form& form, int32_t pair, int slot) {
  const Pair& p = t.pair[pair];
  const bool sticks = p.status == C2D_STICK || t.guided - 1 == pair;
  const bool force = sticks || (p.status == C2D_SLIP && slot == 0);
  return force != has_force(form, *t.model, p.dof + slot);
}

// What a column on the tape says of the pairs that are awake goes into `by`, for the columns of T in use, and out of it.
void take_apart(const Tableau& t, const Form& form, Real* column, Real* by) {
  for (int32_t j = 0; j < t.delayed.cols; ++j) by[j] = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    for (int slot = 0; slot <= last_slot(t, pair) && !is_asleep(t, i); ++slot) {
      Real& there = column[pair.dof + slot];
      if (has_changed_places(t, form, i, slot)) {
        by[column_of(t, i, slot)] += there;
        there = 0;
      } else if (slot == 0 && last_slot(t, pair) == 1 && pair.status == C2D_SLIP && t.guided - 1 != i) {
        by[column_of(t, i, 1)] += static_cast<Real>(-pair.law.slope(pair.sign)) * there; // r of a pair that holds a body
      }
    }
  }
}

c2d_status wake(Tableau& t, const ContactTape& tape, const Waking& w) {
  apply_list(t);
  const int32_t used = t.delayed.cols;
  if (used + w.columns > t.n) return C2D_ERR_MEMORY; // on demand, if a stranger has set columns apart
  const c2d_status made = need_columns(tape, w.pair, w.count);
  if (made != C2D_OK) return made;
  Real *const first = t_column(t, used), *const by = t.delayed.numbers; // the list is empty
  Form form;
  c2d_status status = read_form(tape, first, &form);
  OpenColumns columns{tape, form, first, 0, {}};
  for (int32_t k = 0; k < w.count; ++k)
    for (int slot = 0; slot <= last_slot(t, t.pair[w.pair[k]]) && status == C2D_OK; ++slot)
      status = columns.take(t.pair[w.pair[k]].dof + slot);
  if (status == C2D_OK) status = columns.finish();
  if (status != C2D_OK) return status;
  for (int32_t j = 0; j < w.columns; ++j) take_apart(t, form, t_column(t, used + j), by + static_cast<int64_t>(j) * used);
  if (used > 0) gemm_minus(t.engine, t.m, w.columns, used, t.t, t.m, by, used, first, t.m);
  for (int32_t k = 0; k < w.count; ++k) {
    t.column[w.pair[k]] = t.delayed.cols;
    t.delayed.cols += 1 + last_slot(t, t.pair[w.pair[k]]);
    read_own(t, w.pair[k]);
  }
  return C2D_OK;
}

// Behind another pair, by its gap, then by its number; -1: before all.
bool is_behind(const Follower& f, int32_t i, int32_t other) {
  const auto gap = [&](int32_t k) { return f.y[f.t->pair[k].dof]; };
  return other < 0 || gap(i) > gap(other) || (gap(i) == gap(other) && i > other);
}
// The next one behind `last` of those that count; -1: none.
template <class Counts> int32_t next_nearest(const Follower& f, int32_t last, Counts counts) {
  int32_t next = -1;
  for (int32_t i = 0; i < f.t->pairs; ++i)
    if (counts(i) && is_behind(f, i, last) && (next < 0 || is_behind(f, next, i))) next = i;
  return next;
}

// Adds those that sleep with the smallest gaps, as many as have room.
void add_nearest(const Follower& f, Waking& w) {
  const auto sleeps = [&](int32_t i) { return is_asleep(*f.t, i) && i != w.pair[0]; };
  for (int32_t i = next_nearest(f, -1, sleeps); i >= 0 && add(*f.t, i, w);) i = next_nearest(f, i, sleeps);
}

// Open pairs that are awake may have so many columns, over those that the list has room for; so many stay.
constexpr int32_t kIdleMost = 3, kIdleLeft = 1;

bool is_idle(const Tableau& t, int32_t i) { return t.pair[i].status == C2D_OPEN && !is_asleep(t, i) && t.guided - 1 != i; }

int32_t idle_columns(const Tableau& t) {
  int32_t columns = 0;
  for (int32_t i = 0; i < t.pairs; ++i) columns += is_idle(t, i) ? 1 + last_slot(t, t.pair[i]) : 0;
  return columns;
}

bool holds_a_body(const Tableau& t, const Form& form, int32_t i) {
  const Pair& pair = t.pair[i];
  return has_force(form, *t.model, pair.dof) || (last_slot(t, pair) == 1 && has_force(form, *t.model, pair.dof + 1));
}

// The last of those that stay awake: the nearest for whose columns there is room.
int32_t last_awake(const Follower& f) {
  const Tableau& t = *f.t;
  const auto idle = [&](int32_t i) { return is_idle(t, i); };
  int32_t last = -1;
  for (int32_t columns = 0; columns < kIdleLeft * t.delayed.most; columns += 1 + last_slot(t, t.pair[last]))
    last = next_nearest(f, last, idle); // (there are more)
  return last;
}

int32_t owner_of_last(const Tableau& t) {
  for (int32_t i = 0;; ++i)
    if (t.column[i] >= 0 && t.column[i] + 1 + last_slot(t, t.pair[i]) == t.delayed.cols) return i;
}

// Its columns go, and the last ones come into their place. The list is empty. A pair without a tangent stays where others have
// one.
void fall_asleep(Tableau& t, int32_t i) {
  const int32_t last = owner_of_last(t), columns = 1 + last_slot(t, t.pair[i]);
  if (1 + last_slot(t, t.pair[last]) != columns) return;
  for (int32_t slot = 0; slot < columns && last != i; ++slot)
    memcpy(t_column(t, t.column[i] + slot), t_column(t, t.column[last] + slot), static_cast<size_t>(t.m) * sizeof(Real));
  t.column[last] = t.column[i];
  t.column[i] = -1;
  t.delayed.cols -= columns;
}

} // namespace

c2d_status rest_far(Follower& f) {
  Tableau& t = *f.t;
  Form form;
  form.open = t.open;
  form.sliding = t.sliding;
  if (!delays(t) || !t.open || is_let_go(t) || idle_columns(t) <= kIdleMost * t.delayed.most || !may_sleep(t, form))
    return C2D_OK;
  apply_list(t);
  const c2d_status status = read_form(*f.tape, t.delayed.numbers, &form); // (the list is empty)
  if (status != C2D_OK) return status;
  const int32_t last = last_awake(f);
  for (int32_t i = 0; i < t.pairs; ++i)
    if (is_idle(t, i) && is_behind(f, i, last) && !holds_a_body(t, form, i)) fall_asleep(t, i);
  return C2D_OK;
}

void end_sleep(Tableau& t) {
  for (int32_t i = 0; i < t.pairs && delays(t); ++i)
    if (t.column[i] < 0) t.column[i] = 0;
}

bool may_sleep(const Tableau& t, const Form& form) {
  if (!form.open || t.may_rest != 0 || (form.sliding && !t.smooth)) return false;
  if (is_let_go(t) && !is_on_demand(*t.model)) return false;
  if (t.body->slides != 0) return false;
  for (int32_t i = 0; i < t.pairs; ++i)
    if (t.pair[i].tangential != 0 && !t.pair[i].law.has_bound()) return false;
  return true;
}

c2d_status wake_touching(Follower& f, const PathScales& s) {
  Tableau& t = *f.t;
  while (some_sleep(t)) {
    int32_t touching = -1;
    for (int32_t i = 0; i < t.pairs && touching < 0; ++i)
      if (is_asleep(t, i) && is_unloaded(f, i, pair_state(t, i, f.y), s)) touching = i;
    if (touching < 0) return C2D_OK;
    Waking w{};
    add(t, touching, w);
    add_nearest(f, w);
    const c2d_status status = wake(t, *f.tape, w);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

c2d_status wake_all(Follower& f) {
  Tableau& t = *f.t;
  for (int32_t i = 0; i < t.pairs && some_sleep(t);) {
    Waking w{};
    for (; i < t.pairs && (!is_asleep(t, i) || add(t, i, w)); ++i) {
    }
    const c2d_status status = w.count > 0 ? wake(t, *f.tape, w) : c2d_status{C2D_OK};
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace c2d
