#pragma once
// Is there an equilibrium at all? Limit analysis of the bodies that the contact has to hold.
#include "contact/path.hpp"

namespace c2d {

// The contact's forces can balance the rates of the loads only if these lie in the cone of what the pairs can do to each
// free motion of the bodies: both directions of p and q of a pair that sticks within its bounds, one side of a pair on the
// cone, Coulomb's law of a pair at the apex. That is a linear programme of as many equations as there are free motions.
// Where it has no solution, its dual is a motion of the bodies on which the loads do work and which no force of a pair
// opposes: proof that there are no rates, whatever the bodies' compliance. *outcome: C2D_GROSS_SLIDING if with unbounded
// friction there is a solution, else C2D_TIPPING if the contact takes part of the load, else C2D_FREE_MOTION. Where the
// programme has a solution: C2D_UNDECIDED unless `all_tried`; then there are no rates all the same (friction is no associated
// law): C2D_NO_ADMISSIBLE_CHANGE. f.moving: the body whose part of that motion is the largest. Errors: the block store's.
c2d_status limit_analysis(Follower& f, bool all_tried, c2d_outcome* outcome);

// Do the loads, and do their rates, no work on any free motion, but for round-off? Errors: the block store's.
c2d_status loads_balance(const Follower& f, bool* values, bool* rates);

} // namespace c2d
