// c2d_link_axisymmetric.
#include "bie/rings/ring_batches.hpp"
#include "bie/rings/ring_elements.hpp"
#include "bie/rings/ring_field.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_BRINGS(c2d_set_symmetry);

} // namespace c2d

// (Without names of functions where a build has no rings: nothing else is linked then.)
const c2d::RingPart c2d::kRingPart =
    kRings ? RingPart{true,           integrate_rings, ring_sum,   scatter_rings, take_rings, fill_ring_diagonal,
                      add_ring_trace, add_ring_field,  ring_force, add_ring_force}
           : RingPart{};

extern "C" void c2d_link_axisymmetric(void) {}
