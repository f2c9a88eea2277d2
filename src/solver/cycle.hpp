#pragma once
// Cycles of loads (METHOD 23). All is linear between two events, so as long as the same pairs change their statuses in the same
// order, the state at the end of a cycle is an affine function F of the state x at its beginning. Phases of each cycle:
//   1. follow it, and note which pairs change their statuses, how far each slips, and whether it sticks all the time;
//   2. at its end find the change r = F(x) - x of pressures, friction and gaps, and end if it is small;
//   3. where the last two cycles had the same events, keep the direction in which r and F(x) have changed, r made
//      orthonormal to those kept before;
//   4. go to the state F(x) - sum (q_j . r) G_j, q_j and G_j the directions: of all combinations of the states, with weights
//   that
//      sum to 1, the one with the least change (Anderson 1965; reduced rank extrapolation, Eddy 1979). It is dropped if a pair
//      violates its conditions, or if the cycle from it has other events: then plain cycles go on from F(x).
#include "contact2d_cycle.h"
#include "solver/session.hpp"

namespace c2d {

// What is kept of a pair at the end of a cycle: all that with the statuses and loads makes a state.
struct CycleMemory {
  double offset, slip_done, slip_from, gap; // Pair; SlipGap::now
};
struct CyclePair {
  CycleMemory end;             // of the last cycle followed
  double p, q, wn;             // at the beginning of the cycle
  double change[2];            // of the last cycle: of pressure and gap, and of friction
  double wt, slip;             // at the beginning of the cycle
  double least, most;          // of the slip in this cycle
  double range, walk;          // of the last whole cycle
  int8_t status, sign;         // seen last
  int8_t end_status, end_sign; // with `end`
  int8_t sticks, touches;      // in this cycle: all the time, for some of it
  int8_t stuck, touched;       // in the last whole one
};
struct CycleHead {
  uint64_t request;         // what c2d_cycle was asked for
  uint64_t sequence;        // of the events of the cycles to which directions belong
  uint64_t events, segment; // of the cycle under way, and of its segment
  int32_t cycles, repeated, extrapolations;
  int32_t directions;   // kept
  int32_t extrapolated; // 1: the cycle under way began at an extrapolated state
  int32_t plain, wait;  // plain cycles since the last extrapolation that failed, and how many of them are needed
  int32_t steady;
  double p_scale, w_scale; // of the changes
  double left;             // of the way to the fixed point, by the next extrapolation
  double previous, change, dissipated, dissipated_before;
};
struct CycleRecord {
  CycleHead* head;
  CyclePair* pair;   // [pairs]
  double* direction; // [cycle_states] each: 2 numbers of change a pair, then CycleMemory of each
};
CycleRecord cycle_record(c2d_solver* solver); // of one with room for cycles

// No cycle has been followed. begin_cycle: at its first load; note_corner: at the end of each of its segments.
void start_cycles(Session& session);
void begin_cycle(Session& session);
void note_corner(Session& session);
// At the end of a cycle. The state may be that of an extrapolation then, or that of the end of the cycle before. Errors: the
// block store's.
struct CycleRule {
  double tolerance; // of the change over a steady cycle
  int32_t mode;     // C2D_CYCLES_...
};
c2d_status end_cycle(Session& session, const CycleRule& rule);
// Bounded friction of the pairs becomes 0, at the beginning of a path; then that of the coefficient that is run, and closed
// pairs stick where they are. Errors: the block store's.
void stop_friction(Session& session);
c2d_status start_friction(Session& session);
// Slip above this is more than the round-off and the change that is left, in the length unit.
double least_slip(const CycleHead& head);

} // namespace c2d
