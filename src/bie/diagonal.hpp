#pragma once
// The diagonal in closed form, METHOD (2.4). With r, theta the ray from the source to a point of a path and k as in
// integrals.hpp,
//   int T ds = k [ -(2-2nu) theta - sin(2 theta)/2, cos(2 theta)/2 - (1-2nu) ln r ]
//                [ cos(2 theta)/2 + (1-2nu) ln r,   -(2-2nu) theta + sin(2 theta)/2 ]   between its ends:
// it does not depend on the way, because a translation needs no tractions. The boundary without the elements at the source is
// such a path, over which theta grows by the angle of the material at the source, holes or not. No element needs to be
// visited. With images it is the boundary of the body and of all its images.
#include "bie/columns.hpp"

namespace c2d {

// fill_diagonal() for bodies of straight elements with closed boundaries, and for rings (bie/rings/ring_batches.hpp); false,
// having done nothing, for others and in small builds. Agrees with the sum over the elements to round-off.
bool fill_diagonal_closed(const ColumnSystem& system, int32_t first_node, int32_t count);

} // namespace c2d
