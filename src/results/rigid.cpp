#include "results/rigid.hpp"

#include "model/rigid.hpp"
#include "results/back.hpp"
#include "results/transferred.hpp"

namespace c2d {

void rigid_displacement_now(const Session& session, double x, double y, double u[2]) {
  u[0] = u[1] = 0.0;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k) {
    double part[2];
    rigid_displacement(session.model, k, x, y, part);
    for (int c = 0; c < 2; ++c) u[c] += session.follower.load[k] * part[c];
  }
}

void fill_rigid(const Session& session) {
  const Model& m = session.model;
  for (int32_t node = 0; node < m.head->body[0].nodes; ++node) {
    double x, y, u[2];
    node_position(m, 0, node, &x, &y);
    rigid_displacement_now(session, x, y, u);
    keep_displacement(session, 0, node, u);
  }
  for (int32_t element = 0; element < m.head->body[0].elements; ++element)
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const int32_t index = pair_of_end(m, 0, element, l);
      double t[2] = {0.0, 0.0};
      if (index >= 0) {
        const PairState now = pair_state(*session.follower.t, index, session.follower.y);
        to_global(m.pair[index], -now.p * m.head->stress_unit, -now.q * m.head->stress_unit, t);
      }
      keep_traction(session, 0, element * m.head->function_nodes + l, t);
    }
  for (double& multiplier : session.solver->multiplier[0]) multiplier = 0.0;
}

} // namespace c2d
