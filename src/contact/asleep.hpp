#pragma once
// Pairs that are far from touching sleep: the tableau has their rows, which tell when they touch, and their columns are on the
// tape as they were with every pair open (contact/reduction/open_form.hpp). What becomes of such a column when others change
// places is made up for when it is activated, METHOD (11.5).
#include "contact/basis.hpp"
#include "contact/path.hpp"

namespace c2d {

// May open pairs of the tableau that is about to be built sleep? Not where a body rests along a motion, nor where the state may
// jump; where a body is let go on demand alone, while the tableau is built (end_sleep).
bool may_sleep(const Tableau& t, const Form& form);

// Of a body that is let go, or comes to rest, no column is looked at before there is a new tableau: none sleeps, so that what
// touches is seen.
void end_sleep(Tableau& t);
// Of open pairs that are awake all but the nearest fall asleep, where there are many: after all of a contact has opened T is no
// wider than before it closed. Errors: the block store's.
c2d_status rest_far(Follower& f);
// Pairs that sleep wake where they touch, by the scales of the state, with others that are about to. y is that of the tableau.
// Errors: the block store's.
c2d_status wake_touching(Follower& f, const PathScales& s);
c2d_status wake_all(Follower& f);

} // namespace c2d
