#pragma once
// The result table: a row per pair.
#include "solver/session.hpp"

namespace c2d {

// Displacements of both bodies at the pairs, and the table. Errors: the block store's.
c2d_status fill_table(Session& session);
// Zone, normals and positions, which do not change.
void fill_positions(const Model& model, double* table);

} // namespace c2d
