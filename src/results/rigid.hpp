#pragma once
// Results of a rigid body 1: optional (memory/parts.hpp).
#include "solver/session.hpp"

namespace c2d {

// Displacement of a point at the load reached.
void rigid_displacement_now(const Session& session, double x, double y, double u[2]);
// Its motion, and what the contact does to it: displacements and tractions of its whole boundary.
void fill_rigid(const Session& session);

} // namespace c2d
