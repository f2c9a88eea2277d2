#pragma once
// Overlap between the nodes of a free zone: contact conditions are enforced at the nodes of side 1 only, so boundary points of
// side 0 between them can penetrate unnoticed.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

// Appends the largest depth of a boundary point of side 0 inside the other body at the load reached and its position, if it
// exceeds a twentieth of the largest closure of gaps; zone and pair, from 0, of the worst. Between two pairs the change of the
// gap is interpolated. False: there is none.
bool tell_between_nodes(const Session& session, Text& out, int32_t* zone, int32_t* pair);

} // namespace c2d
