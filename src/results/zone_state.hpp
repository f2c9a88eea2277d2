#pragma once
#include "solver/session.hpp"

namespace c2d {

// Adds the resultants and statuses of a contact zone as it stands to an empty struct. Values are current.
void fill_zone_state(const Session& session, const Zone& zone, c2d_zone_state& out);

} // namespace c2d
