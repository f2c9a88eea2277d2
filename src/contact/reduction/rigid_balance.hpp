#pragma once
// Free motions and equilibrium of the bodies that only the contact holds, exact in the tableau with every pair sticking.
#include "contact/reduction/reduction.hpp"

namespace c2d {

// R and G of all bodies, side by side and orthonormal (METHOD 10): R with w' = R x where nothing is strained, Q = G mix with
// Q^T tau + sum_k lambda_k mix^T g_k = 0. All to the tape. Uses r.first and r.second. C2D_ERR_SINGULAR: some motion moves all
// bodies as one, or no pair at all. Errors: the block store's.
c2d_status join_motions(const Reduction& r);
// mix^T g_k into out[0 .. motions). Uses the last columns of the strip.
c2d_status given_resultants(const Reduction& r, int32_t k, Real* out);
// T R = 0, Q^T T = 0 and Q^T b_k = -mix^T g_k hold only up to the round-off of elimination and reduction, some 1e-11 of T's
// entries. With that round-off a mechanism has a stiffness, and statuses that leave a motion free have solutions of enormous
// motions; so it is taken away, T := (I - Q Q^T) T (I - R R^T), b_k := b_k - Q (Q^T b_k + mix^T g_k), METHOD (10.5). T in m
// columns at this distance. Uses r.first and the strip.
c2d_status balance_stiffness(const Reduction& r, Real* t, int64_t ld);
// The parts of x along `count` columns of a matrix, which are orthonormal, taken off, or all but -given[j] of the j-th.
c2d_status take_out(const ContactTape& tape, ContactMatrix matrix, int32_t count, const Real* given, Real* x, Real* column);
// b_k in column 0 of the strip, mix^T g_k in `given`.
c2d_status balance_rate(const Reduction& r, const Real* given);

} // namespace c2d
