#pragma once
#include "solver/session.hpp"

namespace c2d {

// Adds to the forces applied to body b (BodyResults) those on an element: tractions and reactions except those of the contact;
// `transferred` has two components per end (transferred_traction). Call it for all elements of a body once the tractions are
// known, with the applied forces initialised to zero.
void add_boundary_force(const Session& session, int b, int32_t element, const double* transferred);
// Forces on all bodies, after add_boundary_force, and their balance: on a body supported by contact alone the contact force
// balances the applied one. Optional, with the calls that report it (solver/energy/energy.hpp).
void balance_forces(Session& session);

} // namespace c2d
