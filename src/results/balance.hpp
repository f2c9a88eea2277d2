#pragma once
#include "solver/session.hpp"

namespace c2d {

// Forces on all bodies; the contact's equals what is applied, on a body that the contact has to hold. Optional, with the calls
// that tell it (solver/energy.hpp).
void balance_forces(Session& session);

} // namespace c2d
