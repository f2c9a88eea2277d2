#pragma once
// The result table: a row per pair.
#include "solver/session.hpp"

namespace c2d {

// Rigid-body motions x of bodies supported by contact alone, to area.motion, and the displacements of all bodies at the pairs,
// to area.u. Errors: those of the block store.
c2d_status contact_displacements(Session& session);
// The same, and the table. Errors: those of the block store.
c2d_status fill_table(Session& session);
// The constant columns: zone, normals and positions.
void fill_positions(const Model& model, double* table);

} // namespace c2d
