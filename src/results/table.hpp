#pragma once
// The result table: a row per pair.
#include "solver/session.hpp"

namespace c2d {

// Motions x of the bodies that only the contact holds, into area.motion, and of all bodies the displacements at the pairs, into
// area.u. Errors: the block store's.
c2d_status contact_displacements(Session& session);
// That, and the table. Errors: the block store's.
c2d_status fill_table(Session& session);
// Zone, normals and positions, which do not change.
void fill_positions(const Model& model, double* table);

} // namespace c2d
