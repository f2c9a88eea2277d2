#pragma once
// Everything outside the contact (METHOD 16).
#include "solver/session.hpp"

namespace c2d {

// Results on all boundaries and the balance of forces. Errors: those of the block store.
c2d_status back_substitute_all(Session& session);
// The current coefficients of the trailing columns [H_c | G_c | r] of a body: -u_c, t_c = +-tau, lambda. After fill_table.
void trailing_coefficients(const Session& session, int b, Real* out);
// The only access to stored boundary results; in the caller's units.
void get_displacement(const Session& session, int b, int32_t node, double u[2]);
void get_traction(const Session& session, int b, int32_t end, double t[2]);
void keep_displacement(const Session& session, int b, int32_t node, const double u[2]);
void keep_traction(const Session& session, int b, int32_t end, const double t[2]);
// Traction of the contact at an end of an element; false, zero: the contact has none there.
PairSide contact_traction(const Session& session, int b, int32_t element, int l, double out[2]);
// Traction that free zones transfer to the body on side 0, at an end of an element; zero elsewhere.
void transferred_traction(const Session& session, int b, int32_t element, int l, double out[2]);

} // namespace c2d
