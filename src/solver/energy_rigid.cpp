// What holds a rigid body does work (optional, memory/parts.hpp).
#include "contact/reduction.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {

void add_rigid_motion(const Model& m, int b, int32_t k, Real* tau) {
  for (int32_t i = 0; i < m.head->pairs; ++i)
    for (int side = 0; side < 2; ++side) {
      const Pair& pair = m.pair[i];
      if (body_on(m, pair, side) != b) continue;
      double v[2];
      rigid_motion_at_pair(m, pair, side, k, v);
      const double held = -sign_of_side(side) * pair.weight;
      for (int32_t d = 0; d <= pair.tangential; ++d) tau[pair.dof + d] += static_cast<Real>(held * v[d]);
    }
}

} // namespace c2d
