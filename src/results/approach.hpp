#pragma once
#include "solver/session.hpp"

namespace c2d {

// Computes approach and shift of a contact zone from its force in `out`: mean relative motions of the two bodies, independent
// of the number of pairs. Tied zones and self-contact have none. Errors: those of the block store.
c2d_status find_approach(Session& session, const Zone& zone, c2d_zone_state& out);

} // namespace c2d
