#pragma once
// Sources processed in batches (bie/integrals/batch.hpp). Both functions return false, and have done nothing, if the system has
// no batch or the element has no closed form.
#include "bie/panel.hpp"

namespace c2d {

// As scatter_sources() for a body's own equations.
bool scatter_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[kElementNodes],
                     Blocks& blocks, const Deposits& deposits);

// The share of one element in fill_diagonal().
bool fill_diagonal_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[kElementNodes],
                           int32_t first_node, int32_t count);

// Local node of the element at which the source, or its twin, is located; -1: none.
int singular_node(const int32_t node[kElementNodes], int count, int32_t source, int32_t twin);

} // namespace c2d
