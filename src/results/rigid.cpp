// Results of rigid bodies (METHOD 10.5).
//
// u(x) = sum_k lambda_k (given motion of load case k at x) + sum_j x_j R_j(x), with R_j the free motions, scaled to be
// dimensionless, and x_j their sizes from the contact solution. Displacements are linear in the rotation (small angles).
// A rigid body has no stress and no tractions except those of its contact.
#include "results/rigid.hpp"

#include "bie/measure.hpp"
#include "memory/hostile.hpp"
#include "model/pair_frame.hpp"
#include "results/back.hpp"

namespace c2d {

namespace {

// Number of free motions whose sizes the contact solution contains.
int32_t moving(const Body& body) {
  if (C2D_NEVER(body.free_motions > 0 && body.contact == 0)) return 0; // such a solver is blocked before results exist
  return body.free_motions;
}

} // namespace

void rigid_displacement_now(const Session& session, int b, double x, double y, double u[2]) {
  u[0] = u[1] = 0.0;
  if (session.solver->blocked || session.solver->floating) return; // no solution, so the motion is unknown
  for (int32_t k = 0; k < session.model.head->load_cases; ++k) {
    double part[2];
    rigid_displacement(session.model, b, k, x, y, part);
    for (int c = 0; c < 2; ++c) u[c] += session.follower.load[k] * part[c];
  }
  const Body& body = session.model.body[b];
  const double unit = session.model.head->length_unit;
  for (int32_t j = 0; j < moving(body); ++j) {
    const double* motion = body.free_motion[j];
    const double factor = static_cast<double>(session.area.motion[body.first_border + j]);
    u[0] += factor * (motion[0] * unit - motion[2] * (y - body.centre[1]));
    u[1] += factor * (motion[1] * unit + motion[2] * (x - body.centre[0]));
  }
}

void rigid_motion_now(const Session& session, int b, double motion[3]) {
  const Body& body = session.model.body[b];
  rigid_displacement_now(session, b, body.centre[0], body.centre[1], motion);
  motion[2] = 0.0;
  for (int32_t k = 0; k < session.model.head->load_cases; ++k)
    motion[2] += session.follower.load[k] * session.model.rigid_motion[b][k].rotation;
  for (int32_t j = 0; j < moving(body); ++j)
    motion[2] += static_cast<double>(session.area.motion[body.first_border + j]) * body.free_motion[j][2];
}

void fill_rigid(const Session& session, int b) {
  const Model& m = session.model;
  for (int32_t node = 0; node < m.body[b].nodes; ++node) {
    double x, y, u[2];
    node_position(m, b, node, &x, &y);
    rigid_displacement_now(session, b, x, y, u);
    keep_displacement(session, b, node, u);
  }
  for (int32_t element = 0; element < m.body[b].elements; ++element)
    for (int l = 0; l < m.head->function_nodes; ++l) {
      double t[2];
      contact_traction(session, b, element, l, t);
      keep_traction(session, b, element * m.head->function_nodes + l, t);
    }
  for (double& multiplier : results_of(session.solver, b).multiplier) multiplier = 0.0;
}

} // namespace c2d
