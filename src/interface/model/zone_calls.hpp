#pragma once
// What the calls for both kinds of contact zones share.
#include "interface/model/refuse.hpp"

namespace c2d {

// Steps of +1 or -1 that lead from first to last in count-1 steps, round the ring [start, start + size) if there is one;
// 0: none does. `preferred` decides where both do.
int32_t range_step(int32_t first, int32_t last, int32_t count, int32_t start, int32_t size, int32_t preferred);

// First and last element of a side are some of its body.
c2d_status check_side_elements(c2d_solver* s, const c2d_side& side);
// "the element range of body B does not hold the number of elements given"
c2d_status refuse_range(c2d_solver* s, const char* kind, int32_t body, const char* expected);
// How many elements a side has: as it says, or from first to last by their numbers.
int32_t side_elements(const c2d_side& side);
// Room that pairs take of c2d_limits::pairs: both sides of a zone of a body with itself count.
inline int64_t room_of(int64_t pairs, bool self) { return self ? 2 * pairs : pairs; }
int64_t room_taken(c2d_solver* solver, bool free_alone);
// The last step of both kinds: the zone stands at the end of the list.
void keep_zone(c2d_solver* s, Zone& z);
// Of kind C2D_ZONE_FREE, after the checks of any kind.
c2d_status add_free_zone(c2d_solver* s, const c2d_zone& given); // free_zone_calls.cpp

} // namespace c2d
