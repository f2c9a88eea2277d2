#pragma once
// Free motions and equilibrium of the body that only the contact holds, exact in the tableau with every pair sticking.
#include "contact/reduction.hpp"

namespace c2d {

constexpr int32_t kMostMotions = 3; // in a plane; at most

// The body that the contact has to hold: the one whose S_u is not inverted.
inline int floating_body(const Reduction& r) { return 1 - r.inverted; }

// The free motions are vectors R with S_u R = 0, the equilibrium follows from vectors E with E^T S_u = 0, S_u that of the body:
// G^T tau + sum_k lambda_k g_k = 0 with G = S_t^T E, g_k = E^T s_k; R and G orthonormal. They come from the equations, not from
// how the body would move as a whole: where functions are of lower order than the geometry, the motion that meets no resistance
// is a rotation only up to the error of discretisation. All three go to the tape. r.first and r.strip are used up. Errors: the
// block store's.
c2d_status find_balance(const Reduction& r);
// T R = 0, G^T T = 0 and G^T b_k = -g_k hold only up to the round-off of elimination and reduction, some 1e-11 of T's entries.
// With that round-off a mechanism has a stiffness, and statuses that leave a motion free have solutions of enormous motions; so
// it is taken away, T := (I - G G^T) T (I - R R^T), b_k := b_k - G (G^T b_k + g_k), METHOD (10.5). T in r.first; r.second and
// r.strip are used up.
c2d_status balance_stiffness(const Reduction& r);
// b_k in column 0 of the strip, which is used up but for that.
c2d_status balance_rate(const Reduction& r, int32_t k);

} // namespace c2d
