#pragma once
#include "solver/session.hpp"

namespace c2d {

// Fills in approach and shift of a contact zone, of which `out` has the force: relative motions of its two bodies as wholes,
// which do not depend on how many pairs the zone has. Ties and zones of a body with itself have none. Errors: the block
// store's.
c2d_status find_approach(Session& session, const Zone& zone, c2d_zone_state& out);

} // namespace c2d
