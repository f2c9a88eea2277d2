#pragma once
// Results of rigid bodies: optional (memory/parts.hpp).
#include "solver/session.hpp"

namespace c2d {

// Displacement of a point at the load reached.
void rigid_displacement_now(const Session& session, int b, double x, double y, double u[2]);
// Motion at the load reached: displacement of its reference point (Body::centre) and rotation; needs x (results/table.hpp).
void rigid_motion_now(const Session& session, int b, double motion[3]);
// Displacements and contact tractions of its whole boundary.
void fill_rigid(const Session& session, int b);

} // namespace c2d
