#pragma once
// Warnings about a contact state.
#include "solver/session.hpp"

namespace c2d {

// Checks the current contact. Few elements in contact mean a coarse mesh only at the peak or the end of a path; before, the
// contact may still be growing.
enum class Moment { between, end, peak }; // of a path; peak: largest loads
void warn_contact(Session& session, Moment moment);
// At the largest loads, with the table filled.
void warn_facing_meshes(Session& session);
// If the last call found more than one contact state.
void warn_not_unique(Session& session);
// The limit (solver/judge.hpp) whose violation ended the path.
void warn_breach(c2d_solver* solver);
// Strains and rotations beyond the linear theory, after back substitution.
void warn_strains(Session& session);
// Smallest pressure inside the contact elements over the largest nodal one, of a contact that is solved; 0 if none is negative.
double tension_ratio(const Session& session);

} // namespace c2d
