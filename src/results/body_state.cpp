// Force and moment of the contact on a body: F = int t ds, M = int (x t_y - y t_x) ds about the origin, with t = +-tau in
// global components. The integrals of the shape functions are those of the equations of equilibrium METHOD (2.6): so the
// contact resultant balances the applied loads to round-off. Free zones add the tractions transferred to side 0 (METHOD 9.2).
#include "results/body_state.hpp"

#include "bie/columns.hpp"
#include "memory/parts.hpp"
#include "results/transferred.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

void contact_resultant(const Session& session, int b, double out[3]) {
  const Model& m = session.model;
  const double length = m.head->length_unit;
  out[0] = out[1] = out[2] = 0.0;
  for (ContactEnd end; next_contact_end(m, b, end);) {
    const EndResultant& w = end.weight();
    double t[2];
    pair_force(session, end.at.pair, signed_on(end.at.side, m.head->stress_unit) * length, t);
    add_force(out, w.w * t[0], w.w * t[1], length * (w.wx * t[1] - w.wy * t[0]));
  }
  if (m.body[b].free_rows > 0) kFreeZonePart.add_transferred_force(session, b, out);
  if (is_axisymmetric(m)) out[0] = out[2] = 0.0; // radial forces cancel round the axis
}

} // namespace c2d
