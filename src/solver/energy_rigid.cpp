// What holds a rigid body does work (optional, memory/parts.hpp).
#include "contact/body_unknowns.hpp"
#include "contact/reduction.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {

void add_rigid_motion(const Model& m, int b, int32_t k, Real* tau) {
  for_pairs_of(m, b, [&](const Pair& pair, int side) {
    double v[2];
    rigid_motion_at_pair(m, pair, side, k, v);
    const double held = signed_on(1 - side, pair.weight);
    for (int32_t d = 0; d <= pair.tangential; ++d) tau[pair.dof + d] += static_cast<Real>(held * v[d]);
  });
}

} // namespace c2d
