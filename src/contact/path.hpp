#pragma once
// Following a straight piece of the load path through the space of load factors, on one tableau.
#include "contact/tableau.hpp"

namespace c2d {

// What the follower tells and asks while it runs. Both return C2D_OK to go on.
struct PathWatch {
  void* context;
  c2d_status (*tick)(void* context);                 // at least once per event: progress, cancel
  c2d_status (*changed)(void* context, double load); // a status changed (may be null)
  void (*moving)(void* context, double part);        // the loads go on by this part of the direction (may be null)
};

struct PathStats {
  int64_t events;      // loads at which a pair changed its status
  int64_t changes;     // changes of status of single pairs
  int32_t iterations;  // deck stepping: of the last increment
  int32_t unconverged; // deck stepping: increments finished by event following
};

struct Follower {
  Tableau* t;
  const ContactTape* tape;
  double* load;       // [cases] factors reached
  double* direction;  // [cases] target - load at the start of this piece
  double* origin;     // [cases] load at the start of this piece
  Real* y;            // [m] values at `load`
  Real* dy;           // [m] rates along `direction`
  double gap_scale;   // largest initial gap or displacement seen, length unit
  PathWatch watch;
  PathStats stats;
  int32_t last_pair;  // the pair last changed, or that could not be
};

// Magnitudes against which round-off is judged; derived from values and rates, never from units.
struct PathScales {
  double p, w, dp, dw;
};

void refresh(Follower& f);                       // y and dy from the tableau
PathScales path_scales(const Follower& f);
// Change a status and keep the books of slip. False: the pair is the last to hold a motion.
bool apply_change(Follower& f, int32_t pair, int32_t status, int32_t sign, double at);

// Let the last sticking pair go where its own exchange has no pivot: nothing else holds the motion it would make. That
// motion grows until the first pair that slips against it would turn back; this one sticks in its stead. `rates` are
// those in force. False: there is none, and nothing has changed.
bool release_with_partner(Follower& f, int32_t pair, int32_t sign, double at, const Real* rates);

// Follow from `load` to `target` exactly, event by event. *outcome says whether it was reached; `load` holds how far
// it got. Errors: what the watch returns.
c2d_status follow_events(Follower& f, const double* target, c2d_outcome* outcome);

// The part of f.direction to the next event from where the load stands, without going there; statuses are settled for
// that direction. Infinite if none is met within `reach`. *outcome as follow_events.
c2d_status find_event(Follower& f, double reach, double* part, c2d_outcome* outcome);

// Make the statuses consistent with the rates along f.direction without moving the load (design: tableau and
// events; start (b)); y and dy are refreshed. If none are found the statuses are what they were, and *outcome says why.
c2d_status settle(Follower& f, c2d_outcome* outcome);
// The same by following an artificial load down to zero (contact/homotopy.cpp); true if that led to consistent
// statuses. Pairs marked `weak` may change.
bool settle_by_homotopy(Follower& f);

// Keep the statuses and books of all pairs, and go back to what was kept. Errors: the block store's.
void keep_pairs(Follower& f);
c2d_status restore_pairs(Follower& f);

// One increment of the thesis's own stepping, Table 4, on the same tableau; one that does not settle within
// `iteration_limit` rounds is followed by events instead.
c2d_status follow_increment(Follower& f, const double* target, int32_t iteration_limit, c2d_outcome* outcome);

// Slip summed over all episodes, up to now.
double slip_sum(const Follower& f, int32_t pair);

} // namespace c2d
