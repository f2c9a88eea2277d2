// What the reduction does where body 1 is rigid: optional (memory/parts.hpp).
#include "contact/reduction.hpp"
#include "model/pair_frame.hpp"

namespace c2d {

void rigid_motion_at_pair(const Model& m, const Pair& pair, int32_t load_case, double v[2]) {
  double x, y, u[2];
  node_position(m, 0, pair.node[0], &x, &y);
  rigid_displacement(m, load_case, x, y, u);
  to_frame(pair, u[0] / m.head->length_unit, u[1] / m.head->length_unit, v); // a power of two: the same digits
}

c2d_status move_rigidly(const Reduction& r) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < r.tape.cases && status == C2D_OK; ++k) {
    for (int32_t i = 0; i < r.model.head->pairs; ++i) {
      const Pair& pair = r.model.pair[i];
      double v[2];
      rigid_motion_at_pair(r.model, pair, k, v);
      for (int32_t d = 0; d <= pair.tangential; ++d) r.strip[pair.dof + d] = static_cast<Real>(v[d]);
    }
    status = write_column(r.tape, ContactMatrix::flexibility_load, k, r.strip);
  }
  return status;
}

} // namespace c2d
