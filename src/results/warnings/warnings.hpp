#pragma once
// What a user should know about a contact state.
#include "solver/session.hpp"

namespace c2d {

// About the contact as it stands. At the end of a path a contact of few elements means a coarse mesh and not a beginning.
enum class Moment { between, end, peak }; // of a path; at its peak the loads are largest
void warn_contact(Session& session, Moment moment);
// With the table filled, where loads are largest.
void warn_facing_meshes(Session& session);
// More than one contact state was found, in the last call.
void warn_not_unique(Session& session);
// What was beyond its limits (solver/judge.hpp), where the path ends because of it.
void warn_breach(c2d_solver* solver);
// Strains that are not small, after back substitution.
void warn_strains(Session& session);
// Smallest pressure inside the contact elements over the largest nodal one, of a contact that is solved; 0 if none is negative.
double tension_ratio(const Session& session);

} // namespace c2d
