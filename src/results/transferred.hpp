#pragma once
// Tractions that free zones transfer to the bodies on side 0 (bie/transfer.hpp): optional, for bodies with Body::free_rows
// (memory/parts.hpp).
#include "bie/measure.hpp"
#include "model/pair_frame.hpp"
#include "solver/session.hpp"

namespace c2d {

// Adds the traction at an end of an element of body b.
void add_transferred_traction(const Session& session, int b, int32_t element, int l, double out[2]);
// The traction at function k of a piece per length of side 1.
void transferred_values(const Session& session, const Transfer& piece, int k, double out[2]);
// Adds force and moment about the origin, from the same integrals as in the equations of the body.
void add_transferred_force(const Session& session, int b, double out[3]);

// ---- shared with the rest of the back substitution ----
inline void add_force(double out[3], double fx, double fy, double moment) {
  out[0] += fx;
  out[1] += fy;
  out[2] += moment;
}

} // namespace c2d
