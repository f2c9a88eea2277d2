// What holds a rigid body does work (optional, memory/parts.hpp).
#include "bie/measure.hpp"
#include "contact/reduction.hpp"
#include "model/pair_frame.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {

namespace {

// Of a platen with the integrals that its balance has: what it is given and what it is loaded with do work of one kind.
void add_platen_motion(const Model& m, int b, const RigidMotion& given, Real* tau) {
  const double unit = m.head->length_unit;
  for (int32_t element = 0; element < end_of_elements(m, b); ++element) {
    ZonePlace place;
    if (!find_contact_element(m, b, element, &place)) continue;
    EndResultant weight[kElementNodes];
    end_resultants(m, b, element, Measure::contact, weight);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const PairSide at = pair_of_end(m, b, element, l);
      if (at.pair < 0) continue;
      const EndResultant& w = weight[l];
      const double u[2] = {given.ux / unit * w.w - given.rotation * (w.wy - given.y0 / unit * w.w),
                           given.uy / unit * w.w + given.rotation * (w.wx - given.x0 / unit * w.w)};
      const Pair& pair = m.pair[at.pair];
      double v[2];
      to_frame(pair, u[0], u[1], v);
      for (int32_t d = 0; d <= pair.tangential; ++d) tau[pair.dof + d] -= static_cast<Real>(sign_of_side(at.side) * v[d]);
    }
  }
}

} // namespace

void add_rigid_motion(const Model& m, int b, int32_t k, Real* tau) {
  if (is_platen(m, b)) return add_platen_motion(m, b, m.rigid_motion[b][k], tau);
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
