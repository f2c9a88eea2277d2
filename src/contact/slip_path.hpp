#pragma once
// Gaps that follow slip while the path is followed, METHOD 12. What slip adds to a gap is no linear function of the motion.
// From one event to the next it changes as the loads do, towards what the rates say slip will come to: that is one load more,
// whose rates are a column of the tableau. The path stays one of events, and what was added is made right anew at each of them.
#include "contact/path.hpp"

namespace c2d {

// Gaps go to what slip adds to them after the `rest` of f.direction, by the rates along it. y and dy are those of load and
// direction, before and after.
void aim_gaps(Follower& f, double rest);

} // namespace c2d
