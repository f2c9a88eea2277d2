#pragma once
// Resultant of the contact on a body.
#include "solver/session.hpp"

namespace c2d {

// Force and moment about the origin of all contact tractions on body b, from the exact resultants of their shape functions.
// Needs the current state of the pairs.
void contact_resultant(const Session& session, int b, double out[3]);

} // namespace c2d
