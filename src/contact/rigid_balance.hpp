#pragma once
// Rigid motions and equilibrium of a body that only the contact holds, exact in the stiffness with every pair sticking.
#include "contact/reduction.hpp"

namespace c2d {

constexpr int32_t kMostMotions = 3; // in a plane; at most

// The body that the contact has to hold: the one whose S_u is not inverted.
inline int floating_body(const Reduction& r) { return 1 - r.inverted; }

// T in r.first. The body's free motions are vectors R with T R = 0, and its equilibrium is as many vectors G with G^T T = 0, up
// to the round-off of elimination and reduction, some 1e-11 of T's entries. With that round-off a mechanism has a stiffness,
// and statuses that leave a motion free have solutions of enormous motions; so it is taken away,
// T := (I - G G^T) T (I - R R^T), R and G orthonormal. Both are found from T itself: where functions are of lower order than
// the geometry the motion that meets no resistance is a rotation only up to the error of discretisation. G goes to the tape,
// for the proof that there is no equilibrium. r.second and r.strip are used up. Errors: the block store's.
c2d_status balance_stiffness(const Reduction& r);

} // namespace c2d
