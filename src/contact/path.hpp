#pragma once
// Following a straight piece of the load path through the space of load factors, on one tableau.
#include "contact/rates/rate_problem.hpp"
#include "model/model.hpp"

namespace c2d {

// What the follower tells and asks while it runs. Both return C2D_OK to go on.
struct PathWatch {
  void* context;
  c2d_status (*tick)(void* context);                 // at least once per event: progress, cancel
  c2d_status (*changed)(void* context, double load); // a status changed (may be null)
  void (*moving)(void* context, double part);        // the loads go on by this part of the direction (may be null)
  // The state may jump at this load, and has (may be null). Behind a jump that nothing catches, the state before it is the
  // last.
  c2d_status (*jumping)(void* context, bool done);
};

struct PathStats {
  int64_t events;      // loads at which a pair changed its status
  int64_t changes;     // changes of status of single pairs
  int32_t iterations;  // deck stepping: of the last increment
  int32_t unconverged; // deck stepping: increments finished by event following
};

// A load at which a pair reaches what its status demands: its gap or pressure is zero, or its friction at the bound.
struct Event {
  double step;                // part of the piece of path, from where the load stood
  int32_t pair, status, sign; // the status next to its own; pair -1: none
};

// Round-off of values after some thousand exchanges stays below 1e-12 of their scale; rates are differences of them.
constexpr double kValueTolerance = 1e-11;
constexpr double kRateTolerance = 1e-9;
constexpr double kMixedNoise = 1e-12; // of a pair's stiffness times a motion, against forces, and the other way round

// Magnitudes against which round-off is judged; derived from values and rates, never from units.
struct PathScales {
  double p, w, dp, dw;
  double mixed = kMixedNoise; // where no pair has a force, kRateTolerance: rates of forces may be all round-off
};

// Those of y, dy and the statuses as they are, for whoever asks next; not on a small stack.
template <bool small> struct KeptScales {
  PathScales scales;
  bool valid = false;
};
template <> struct KeptScales<true> {};
inline void keep(KeptScales<true>&, const PathScales&) {}
inline void keep(KeptScales<false>& kept, const PathScales& scales) { kept = {scales, true}; }
inline void forget(KeptScales<true>&) {}
inline void forget(KeptScales<false>& kept) { kept.valid = false; }
inline bool recall(const KeptScales<true>&, PathScales&) { return false; }
inline bool recall(const KeptScales<false>& kept, PathScales& scales) {
  if (kept.valid) scales = kept.scales;
  return kept.valid;
}

struct Follower {
  Tableau* t;
  const ContactTape* tape;
  double* load;                // [cases] factors reached
  double* direction;           // [cases] target - load at the start of this piece
  double* origin;              // [cases] load at the start of this piece
  Real* y;                     // [m] values at `load`
  Real* dy;                    // [m] rates along `direction`
  KeptScales<kSmallCode> kept; // (of small code in what pointers leave before the next number)
  double gap_scale;            // largest initial gap or displacement seen, length unit
  double pressure_scale;       // largest pressure or friction seen on this path, stress unit
  const Model* model;
  RateArea rate_area;
  Event bound;           // the event that led here, until statuses are settled
  bool idle;             // the body that the contact has to hold has no force there (contact/let_go.hpp)
  bool goes_on;          // this piece of the path goes on in the direction of the one before
  bool more_solutions;   // there may be more there;
  bool range;            // they are a range of places of the body, which no force tells apart;
  int32_t solutions;     // most contact states found at one load since the struct was filled;
  double solutions_load; // that load, of the first case
  double guide;          // w_t of the guided pair of the tableau, per unit of `direction`
  PathWatch watch;
  PathStats stats;
  int32_t last_pair; // the pair last changed, or that could not be
  int32_t moving;    // the body that moves most where limit analysis found no equilibrium; -1: none
};

// Rates of a pair's forces and motions up to these are none: round-off of the largest, and of what the pair's own stiffness
// makes of the other kind.
struct NoRate {
  double force, motion;
};
NoRate no_rate(const Pair& pair, const PathScales& s);

void refresh(Follower& f); // y and dy from the tableau
// The guided pair of the tableau, if there is one, sticks where it is.
void end_guide(Follower& f);
PathScales path_scales(const Follower& f);
// The largest on this path so far: kValueTolerance of them is round-off. Where the body is idle (f.idle) all its pressures are:
// the scale of pressures is then so much larger that none of them counts.
PathScales decision_scales(Follower& f);
// The same where nothing but asking has come between.
PathScales same_scales(Follower& f);
// Change a status and keep the books of slip. False: the pair is the last to hold a motion.
bool apply_change(Follower& f, int32_t pair, int32_t status, int32_t sign, double at);

// The same without the exchange: the tableau has to be built anew.
void set_status(Follower& f, int32_t pair, int32_t status, int32_t sign);

// Gaps that follow slip stay what they are, until follow_events() moves them.
void hold_gaps(const Tableau& t);

// Follow from `load` to `target` exactly, event by event. *outcome says whether it was reached; `load` holds how far
// it got. Errors: what the watch returns.
c2d_status follow_events(Follower& f, const double* target, c2d_outcome* outcome);

// The part of f.direction to the next event from where the load stands, without going there; statuses are settled for
// that direction. Infinite if none is met within `reach`. *outcome as follow_events.
c2d_status find_event(Follower& f, double reach, double* part, c2d_outcome* outcome);

// Make the statuses consistent with the rates along f.direction without moving the load (METHOD 13). y and dy are those of load
// and direction, before and after. Few pairs in doubt:
// all sets of cells are tried, which also tells how many solutions there are, f.solutions. Else rounds of changes, then
// follow_cells. If there are no such statuses, or none are found, they are what they were, and *outcome says why.
c2d_status settle(Follower& f, c2d_outcome* outcome);
// Has the pair no pressure and no gap? That of the event that led here is so, whatever the last digits say.
inline bool is_unloaded(const Follower& f, int32_t i, const PairState& now, const PathScales& s) {
  const Pair& pair = f.t->pair[i];
  const bool open = pair.status == C2D_OPEN;
  if (i == f.bound.pair && (open || f.bound.status != C2D_SLIP || pair.law.is_smooth())) return true; // it touched or lifted
  return open ? now.wn <= kValueTolerance * s.w : now.p <= kValueTolerance * s.p;
}
// Is the pair's status for its rates to decide? In any case fills what `d` says of the pair itself.
bool is_in_doubt(const Follower& f, int32_t pair, const PathScales& s, Doubt& d);

// Keep the statuses and books of all pairs, and go back to what was kept. Errors: the block store's.
void keep_pairs(Follower& f);
c2d_status restore_pairs(Follower& f);
c2d_status rebuild(Follower& f); // the tableau, for the statuses as they are

// One increment of the thesis's own stepping, Table 4, on the same tableau; one that does not settle within
// `iteration_limit` rounds is followed by events instead.
c2d_status follow_increment(Follower& f, const double* target, int32_t iteration_limit, c2d_outcome* outcome);

// Slip summed over all episodes, up to now.
double slip_sum(const Follower& f, int32_t pair);

} // namespace c2d
