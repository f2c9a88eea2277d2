#pragma once
// A body that the contact has held lies apart from the other, and the loads do not move it (METHOD 13.5): it carries no contact
// force, and where it is within its free motions nothing says. It then keeps, in the mean over the pairs, the place relative to
// the other body that it had when the last pair let go.
#include "contact/path.hpp"

namespace c2d {

constexpr int kFreeMotions = 3; // of a body at most
constexpr int kMostResting = 12;

// No pair touches and the body has free motions: such a tableau is built for the place above and knows no exchanges.
bool is_let_go(const Tableau& t);

// Where a pair was when the body was let go, gap (slot 0) and w_t. It stands where a touching pair has the history of its
// friction, of which one that is let go has none.
inline double place_of(const Pair& pair, int slot) { return slot == 0 ? pair.slip_from : pair.offset; }
inline void keep_place(Pair& pair, double wn, double wt) {
  pair.slip_from = static_cast<Real>(wn);
  pair.offset = static_cast<Real>(wt);
}

// Of an open pair: it touches without force and follows what it touches, METHOD 13.8: what would press it moves the body away.
inline bool leans(const Pair& open) { return open.sign != 0; }
inline void lean(Pair& pair) { pair.sign = 1; }

// The last step of building it. Slots `left` have no pivot any more: their columns are the free motions. `t` has for them what
// the rule asks for instead of forces; it has the motions at rest, zeros, in these rows, and then the gaps among the constants.
// False: they are no motions of their own.
bool place_body(const Tableau& t, const int32_t* left, int32_t count);

// Motions that the statuses leave free although some pairs are closed, METHOD 13.8. May bodies rest where they are along those
// of slots `left`, because the loads of the path do no work on them? And, for one after the other: the slot's force is zero, as
// another pair's is, and instead the bodies keep their place in the mean over the pairs. `column`: m numbers.
bool may_rest(const Tableau& t, const int32_t* left, int32_t count);
bool rest_along(const Tableau& t, int32_t slot, Real* column);
// Bodies that rest, and pairs that begin to close: they are closed, as a trial that settle() judges, and the tableau is built
// anew. So it is where statuses have changed (`changed`), since only then is it that of the bodies at rest.
c2d_status rest_again(Follower& f, bool changed);

// Of the pairs that are open, with the place they have now as the one to keep.
void keep_open_places(Follower& f);
// All pairs open, with the place that the body has now as the one to keep.
void leave_place(Follower& f);

// Is the body idle: has it no force in any pair, and do the loads do no work on its free motions? What its pairs have by way of
// forces is round-off then, up to 1e-9 of what their motion would make, and f.idle lets decisions take it for that. `s`:
// the scales of this state. Errors: the block store's.
c2d_status note_idle(Follower& f, const PathScales& s);

// Does the body slide along with the other without any force, now and as the loads go on? Nothing offends then, and it could be
// anywhere on its way.
bool slides_without_force(Follower& f);

// Let the body go if it is idle, the loads do not begin to move it, and no pair would close at once. The pairs have
// been kept. *done: it is let go; if not, everything is as it was.
c2d_status try_let_go(Follower& f, bool* done);

// A body that is let go, with the rates along f.direction. *quiet: it stays so. Else pairs that touch hold it again as a trial
// that settle() judges; if none can, the outcome is a free motion.
c2d_status hold_again(Follower& f, bool* quiet, c2d_outcome* outcome);

} // namespace c2d
