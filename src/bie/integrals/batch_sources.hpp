#pragma once
// Sources taken by the batch (bie/integrals/batch.hpp). Both return false, having done nothing, if the system has no
// batch or the element none of its closed forms.
#include "bie/panel.hpp"

namespace c2d {

// As scatter_sources() for a body's own equations.
bool scatter_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[kElementNodes],
                     Blocks& blocks, const Deposits& deposits);

// One element's share of fill_diagonal().
bool fill_diagonal_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[kElementNodes],
                           int32_t first_node, int32_t count);

// Local node of the element at which the source sits, itself or its twin; -1: none.
int singular_node(const int32_t node[kElementNodes], int count, int32_t source, int32_t twin);

} // namespace c2d
