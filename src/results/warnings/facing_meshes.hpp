#pragma once
// Free zones whose side 0 is meshed too coarsely for side 1. The displacement of side 0 is linear on its elements and has a
// kink at each of their ends, which the exact one has not. The pressure of a finer side 1 follows it: a kink d in the surface
// of a half plane raises its pressure by E/(2 pi (1 - nu^2)) d ln(L/h) within an element of length h at the kink, relative to
// that at a distance L.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

// With the table filled. Appends this error relative to the highest pressure of the zone if it exceeds a twentieth; zone and
// pair, from 0, of the worst. False: there is none.
bool tell_facing_meshes(const Session& session, Text& out, int32_t* zone, int32_t* pair);

} // namespace c2d
