#pragma once
#include "solver/session.hpp"

namespace c2d {

// Fills resultants and statuses of the current contact state of a zone into a zeroed struct.
void fill_zone_state(const Session& session, const Zone& zone, c2d_zone_state& out);

} // namespace c2d
