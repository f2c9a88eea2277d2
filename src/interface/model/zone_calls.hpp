#pragma once
// Shared by both kinds of contact zones.
#include "interface/model/refuse.hpp"

namespace c2d {

// The step, +1 or -1, that leads from first to last in count-1 steps, across the end of the ring [start, start + size) if any;
// 0: none. `preferred` decides if both do.
int32_t range_step(int32_t first, int32_t last, int32_t count, int32_t start, int32_t size, int32_t preferred);

// Checks that first and last element of a side exist in its body.
c2d_status check_side_elements(c2d_solver* s, const c2d_side& side);
// Message: "the element range of body B does not contain the number of elements given".
c2d_status refuse_range(c2d_solver* s, const char* kind, int32_t body, const char* expected);
// Number of elements of a side: as given, or from first and last.
int32_t side_elements(const c2d_side& side);
// Share of c2d_limits::pairs: in self-contact both sides count.
inline int64_t room_of(int64_t pairs, bool self) { return self ? 2 * pairs : pairs; }
int64_t room_taken(c2d_solver* solver, bool free_alone);
// Last step for both kinds: appends the zone to the list.
void keep_zone(c2d_solver* s, Zone& z);
// For C2D_ZONE_FREE, after the common checks.
c2d_status add_free_zone(c2d_solver* s, const c2d_zone& given); // free_zone_calls.cpp

} // namespace c2d
