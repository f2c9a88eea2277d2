#pragma once
// Free zones whose side 0 has boundary points between the nodes of side 1: contact conditions hold at these nodes alone, and
// what stands out of side 0 between them is not seen.
#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

// Appends by how much a boundary point of side 0 lies inside the other body at the load reached, if that is more than a
// twentieth of what the bodies have come closer, and where; zone and pair, from 0, of the worst. Between two pairs gaps change
// as they do at these. False: none does.
bool tell_between_nodes(const Session& session, Text& out, int32_t* zone, int32_t* pair);

} // namespace c2d
