#pragma once
// How the contact surface of one body gives way: its reduced equations S_u u = S_t t + sum_k lambda_k s_k solved for u,
//   u = F t + sum_k lambda_k v_k + R x,   0 = G^T t + sum_k lambda_k g_k.
// R: its motions that no support prevents (none: S_u is inverted), and G what they are in balance with, G = S_t^T E, g_k = E^T
// s_k, E^T S_u = 0. They come from the equations, not from how the body would move as a whole: where functions are of lower
// order than the geometry, the motion that meets no resistance is a rotation only up to the error of discretisation. A body
// with motions is held at as many of its contact unknowns, those that hold it best: S_u R = 0 is solved for the others, and the
// equations left over by the elimination are the balances. The motions of the held unknowns are x, so that F and v are zero
// there. Of a body that keeps its equations, or whose displacements are unknowns, R, G, E and g are found alone; a rigid body
// has v alone.
#include "contact/reduction/reduction.hpp"

namespace c2d {

// All of these of body b, to the tape. Uses r.first, r.second and r.strip. C2D_ERR_SINGULAR: there is more that meets no
// resistance than its motions. Errors: the block store's.
c2d_status find_compliance(const Reduction& r, int b);
// v and g of body b again, whose columns s are on the tape anew.
c2d_status find_load_response(const Reduction& r, int b);

// |z|, U^T z = f: by how much larger round-off of the rows, whose entries are of size one, is in the first `counted` of the n
// unknowns of an upper factor. f is 1 or -1 for these, so that z grows, and 0 for the others. z: room for n numbers.
double growth_of(const Real* upper, int64_t ld, int32_t n, int32_t counted, Real* z);

} // namespace c2d
