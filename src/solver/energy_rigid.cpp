// What holds a rigid body 1 does work (optional, memory/parts.hpp).
#include "contact/reduction.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {

void add_rigid_motion(const Model& m, int32_t k, Real* tau) {
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    const Pair& pair = m.pair[i];
    double v[2];
    rigid_motion_at_pair(m, pair, k, v);
    for (int32_t d = 0; d <= pair.tangential; ++d) tau[pair.dof + d] += static_cast<Real>(pair.weight * v[d]);
  }
}

} // namespace c2d
