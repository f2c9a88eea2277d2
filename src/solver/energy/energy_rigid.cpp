// What holds a rigid body does work (optional, memory/parts.hpp).
#include "bie/measure.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/reduction/reduction.hpp"
#include "model/pair_frame.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

namespace {

// Of a platen with the integrals that its balance has: what it is given and what it is loaded with do work of one kind.
void add_platen_motion(const Model& m, int b, const RigidMotion& given, Real* tau) {
  const double unit = m.head->length_unit;
  for (ContactEnd end; next_contact_end(m, b, end);) {
    const EndResultant& w = end.weight();
    const double u[2] = {given.ux / unit * w.w - given.rotation * (w.wy - given.y0 / unit * w.w),
                         given.uy / unit * w.w + given.rotation * (w.wx - given.x0 / unit * w.w)};
    const Pair& pair = m.pair[end.at.pair];
    double v[2];
    to_frame(pair, u[0], u[1], v);
    for (int32_t d = 0; d <= pair.tangential; ++d) tau[pair.dof + d] -= static_cast<Real>(signed_on(end.at.side, v[d]));
  }
}

} // namespace

void add_rigid_motion(const Model& m, int b, int32_t k, Real* tau) {
  if (is_platen(m, b)) return add_platen_motion(m, b, m.rigid_motion[b][k], tau);
  for_pairs_of(m, b, [&](const Pair& pair, int side) {
    double v[2];
    rigid_motion_at_pair(m, pair, side, k, v);
    const double held = signed_on(1 - side, pair.weight);
    for (int32_t d = 0; d <= pair.tangential; ++d) tau[pair.dof + d] += static_cast<Real>(held * v[d]);
  });
}

} // namespace c2d
