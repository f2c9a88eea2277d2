#pragma once
// Sources of a body of revolution in batches (bie/integrals/batch.hpp): elements that are not near by the vector loops of
// rings, eight sources at once; near and singular ones by panels whose points are the lanes. As accurate as ring_elements.hpp.
// Both functions return false, and have done nothing, if the system has no batch.
#include "bie/panel.hpp"

namespace c2d {

// As scatter_sources() for a body's own equations.
bool scatter_rings(const ColumnSystem& system, const Integrator& in, const int32_t node[kElementNodes], Blocks& blocks,
                   const Deposits& deposits);

// The share of one element in fill_diagonal().
bool take_rings(const ColumnSystem& system, const Integrator& in, const int32_t node[kElementNodes], int32_t first_node,
                int32_t count);

// fill_diagonal(), by a path round each source in the place of a sum over all elements; false as above, and for bodies farther
// from the axis than 10,000 times their size. They hardly resist a radial motion, so round-off is most of the error; in the sum
// of the integrals that the columns contain it is smaller by a quarter.
bool fill_ring_diagonal(const ColumnSystem& system, int32_t first_node, int32_t count);

} // namespace c2d
