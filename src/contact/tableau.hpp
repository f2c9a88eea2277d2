#pragma once
// The contact tableau: half of the contact unknowns (basic, y) as linear functions of the other half (z = 0) and of
// the load factors,  y = T z + c + sum_k lambda_k b_k.  Columns 0 ... n-1 are T, column n is c, then b_k: the rates
// of everything with the loads. Slot `dof` of a pair holds its normal quantities, `dof + 1` the tangential ones:
//   open   z = p, q     y = w_n, w_t          w = (u.n + gap, u.t), u = u1 - u0 of the sides, in the model's length unit
//   stick  z = w_n, w_t - offset    y = p, q  p, q: force on side 1 per length of side 0 in its stress unit
//   slip   z = w_n, r   y = p, w_t            r = q - sign mu p
// A change of status is one or two Gauss-Jordan exchanges. In a large tableau those of T are kept back in a list, `delayed`,
// which is applied as a whole when it is full; constants and rates of loads are always up to date. Columns of pairs that are
// far from touching stay on the tape, contact/asleep.hpp.
#include "contact/contact_tape.hpp"
#include "linalg/delayed.hpp"
#include "model/model.hpp"

namespace c2d {

struct FreeBody; // contact/start.hpp

// Tied pairs have rows, their forces, and no columns.
struct Tableau {
  int32_t m, n, cases, pairs; // rows: all contact unknowns; columns: those of the first `pairs` pairs, which may change
  Pair* pair;
  Real* t; // m * tableau_columns()
  double length_unit;
  double stiffness;  // largest diagonal entry with every pair sticking; 0 until built
  int64_t exchanges; // so far
  Engine engine;
  int32_t free_motions; // of the bodies that the contact has to hold: left free where no pair touches (contact/let_go.hpp)
  const Model* model;   // for motions that no pair resists; null: there are none
  const FreeBody* body;
  int32_t guided = 0; // number of a pair that slides at a given rate, METHOD 13.7, and is a sticking one here; 0: none
  const double *load = nullptr, *direction = nullptr; // [cases] of the path
  int32_t may_rest = 0; // 1: motions that the statuses leave, and on which these loads do no work, are no fault, METHOD 13.8:
  int32_t resting = 0;  // so many, along which the bodies keep their place in this tableau
  DelayedExchanges delayed = {}; // of T
  Real *own = nullptr,
       *cross = nullptr;              // [m] where there is a list: T of a slot by itself, and of a row by its pair's other slot
  int32_t* column = nullptr;          // [pairs] likewise: where the columns of a pair's slots begin in t; -1: they are asleep
  bool smooth = false;                // there is a list, and no pair has friction: only columns of normal slots are left
  bool open = false, sliding = false; // of the form on the tape (contact/basis.hpp)
  SlipGap* slip = nullptr;            // [pairs] where gaps follow slip (contact/slip_path.hpp)
};
// Do gaps follow slip? Then there is a column more, behind those of the loads: the rates of everything with what is added to
// the gaps along the rest of the path's piece.
inline bool follows_slip(const Tableau& t) { return !kSmallCode && t.slip != nullptr; }
// Between the points that face each other, as they were made and by slip: w_n less this is the motion. With its rate, less that
// of w_n.
inline double gap_by_slip(const Tableau& t, const Pair& pair) { return follows_slip(t) ? t.slip[&pair - t.pair].now : 0.0; }
inline double gap_of(const Tableau& t, const Pair& pair) { return pair.gap / t.length_unit + gap_by_slip(t, pair); }
inline double gap_rate(const Tableau& t, const Pair& pair) { return follows_slip(t) ? t.slip[&pair - t.pair].rate : 0.0; }

inline bool delays(const Tableau& t) { return !kSmallCode && t.delayed.most > 0; }
// Where the list and what goes with it lie: `numbers` of them, C2D_PATH_ARRAYS_ of contact2d_memory.h.
void place_list(Tableau& t, Real* numbers, int32_t count, int32_t columns);

inline Real* constants(const Tableau& t) { return t.t + static_cast<int64_t>(t.m) * t.n; }
inline bool has_normal_columns(const Tableau& t) { return !kSmallCode && t.smooth; }
// The column of a pair's slot; of a pair that is not asleep.
inline int32_t column_of(const Tableau& t, int32_t pair, int slot) {
  return (delays(t) ? t.column[pair] : t.pair[pair].dof) + slot;
}
inline bool is_asleep(const Tableau& t, int32_t pair) { return delays(t) && t.column[pair] < 0; }
// The last slot of a pair that has a column.
inline int last_slot(const Tableau& t, const Pair& pair) { return has_normal_columns(t) ? 0 : pair.tangential; }
// The columns of T in use, from the first on. Some sleep: there are fewer than could be.
inline int32_t used_columns(const Tableau& t) { return delays(t) ? t.delayed.cols : t.n; }
// Those of all pairs that may change: more than there is room for on demand.
inline int32_t all_columns_of(const Tableau& t) {
  return t.model != nullptr && is_on_demand(*t.model) ? t.model->head->path_unknowns : t.n;
}
inline bool some_sleep(const Tableau& t) { return delays(t) && t.delayed.cols < (t.smooth ? t.pairs : all_columns_of(t)); }
// Where the column of a slot begins.
Real* slot_column(const Tableau& t, int32_t slot);
// T of a slot by itself, and of its row by the other slot of the pair; y += factor times a column: whatever the list holds.
// With an empty list T is in t.t.
inline Real own_entry(const Tableau& t, int32_t slot) {
  return delays(t) ? t.own[slot] : t.t[static_cast<int64_t>(slot) * t.m + slot];
}
inline Real cross_entry(const Tableau& t, int32_t slot, int32_t other) {
  return delays(t) ? t.cross[slot] : t.t[static_cast<int64_t>(other) * t.m + slot];
}
// read_own: once T is the tableau, of a pair that is awake.
void read_own(const Tableau& t, int32_t pair);
void add_column_to(const Tableau& t, int32_t column, double factor, Real* y);
// slip_rates(), of the rates that gaps have.
void find_slip_rates(const Tableau& t);
void apply_list(Tableau& t);
inline Real* load_rates(const Tableau& t, int32_t k) { return t.t + static_cast<int64_t>(t.m) * (t.n + 1 + k); }
inline Real* slip_rates(const Tableau& t) { return load_rates(t, t.cases); }
constexpr int64_t tableau_columns(int64_t n, int64_t cases) { return n + 1 + cases; }
inline int32_t tableau_columns(const Tableau& t) {
  return static_cast<int32_t>(tableau_columns(t.n, t.cases)) + (follows_slip(t) ? 1 : 0);
}

// The tableau for the statuses, signs, offsets and coefficients that the pairs have now, from that on the tape
// (contact/basis.hpp). Load-free reference: w = (gap, 0), tau = 0. Errors: the block
// store's; C2D_ERR_SINGULAR if the statuses leave a motion free (*culprit: a pair that should have been released), unless no
// pair touches (contact/let_go.hpp).
c2d_status build_tableau(Tableau& t, const ContactTape& tape, int32_t* culprit);

// Change one pair's status. `sign`: of friction on body 2, for slip. `at`: w_t at which it will stick, for stick.
// False if a pivot is unusable: the pair is the last to hold a motion; then nothing has changed.
bool change_status(Tableau& t, int32_t pair, int32_t status, int32_t sign, double at);

// c + sum_k factor_k b_k (with_constants), or the rates along a direction: sum_k factor_k b_k with slip_rates, into out[m].
void combine(const Tableau& t, const double* factor, bool with_constants, Real* out);

// Quantities of a pair out of combined values y (zero where z holds them; w_t of a sticking pair: its offset). They are read
// all the time, and a call would cost more than that.
struct PairState {
  double wn, wt, p, q;
};
inline PairState read_pair(const Pair& pair, const Real* y, double offset) {
  const double normal = y[pair.dof], tangential = pair.tangential ? static_cast<double>(y[pair.dof + 1]) : 0.0;
  switch (pair.status) {
  case C2D_OPEN: return {normal, tangential, 0.0, 0.0};
  case C2D_STICK: return {0.0, offset, normal, tangential};
  default: return {0.0, tangential, normal, pair.tangential ? pair.law.slope(pair.sign) * normal : 0.0};
  }
}
inline PairState pair_state(const Tableau& t, int32_t pair, const Real* y) {
  return read_pair(t.pair[pair], y, t.pair[pair].tangential ? t.pair[pair].offset : 0.0);
}
// The same out of combined rates (the offset does not move).
inline PairState pair_rates(const Tableau& t, int32_t pair, const Real* dy) { return read_pair(t.pair[pair], dy, 0.0); }

} // namespace c2d
