#pragma once
// Free zones where the elements of side 0 are too long for those of side 1. Side 0's displacement is linear over its elements,
// and has a kink at each of their ends that the true one has not. Pressures of a finer side 1 follow it: a kink d of the
// displacement of a half plane makes its pressure E/(2 pi (1 - nu^2)) d ln(L/h) higher within an element h of the kink than an
// element L away.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

// With the table filled. Appends how much of the highest pressure of a zone that is, if it is more than a twentieth; zone and
// pair, from 0, of the worst. False: it is nowhere.
bool tell_facing_meshes(const Session& session, Text& out, int32_t* zone, int32_t* pair);

} // namespace c2d
