#pragma once
#include "solver/session.hpp"

namespace c2d {

// Adds to the forces applied to body b (BodyResults) those on an element's boundary: tractions and reactions but those of the
// contact, of which `transferred` has two per end (transferred_traction). To be called for all elements of a body, which has
// none applied before, when the tractions are known.
void add_boundary_force(const Session& session, int b, int32_t element, const double* transferred);
// Forces on all bodies, whose boundaries are summed up; the contact's equals what is applied, on a body that the contact has to
// hold. Optional, with the calls that tell it (solver/energy.hpp).
void balance_forces(Session& session);

} // namespace c2d
