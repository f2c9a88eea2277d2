#pragma once
// Statuses where rounds of changes find none, and what can be proven where there are none (METHOD 13). Optional
// (memory/parts.hpp): without it such a state is C2D_UNDECIDED.
#include "contact/path.hpp"

namespace c2d {

// All sets of cells, if they are few or few parts of them have to be looked at, and it is not clear beforehand that one
// solution is all there is. *found: how many there are; -1: not known. The pairs have been kept.
c2d_status try_all(Follower& f, bool offends, int32_t* found);

// Where rounds end without rates: by paths, then what can be proven, then by branches, and if those are too many by paths from
// anywhere. *outcome: C2D_REACHED, or why there are none. The pairs have been kept.
c2d_status decide(Follower& f, bool all_tried, c2d_outcome* outcome);

// Where the statuses settled are one end of a range of states, which is noted, the body goes to the place in it that moves
// least, METHOD 13.7.
void place_in_range(Follower& f);

// ---- of settle.cpp ----
// Does a pair's status disagree with its rates?
bool anything_offends(const Follower& f, const PathScales& s);
// Do the statuses hold the body, for all that the last digits say?
bool is_held(const Follower& f);

} // namespace c2d
