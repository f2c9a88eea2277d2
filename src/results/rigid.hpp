#pragma once
// Results of rigid bodies: optional (memory/parts.hpp).
#include "solver/session.hpp"

namespace c2d {

// Displacement of a point at the load reached.
void rigid_displacement_now(const Session& session, int b, double x, double y, double u[2]);
// Motion at the load reached: of its point (Body::centre), and its rotation; with x of the state (results/table.hpp).
void rigid_motion_now(const Session& session, int b, double motion[3]);
// Its motion, and what the contact does to it: displacements and tractions of its whole boundary.
void fill_rigid(const Session& session, int b);

} // namespace c2d
