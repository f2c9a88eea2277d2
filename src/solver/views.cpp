// The arrays of the workspace as the rooms below see them.

#include "memory/math.hpp"
#include "model/validate/validate.hpp"
#include "solver/solver.hpp"

namespace c2d {

Model model_of(c2d_solver* s) {
  Body* const body = array_of<Body>(s, kBodies);
  Model m;
  m.head = &s->model;
  m.body = body;
  m.xy = {body};
  m.node_line = {body};
  m.end_traction = {body};
  m.node_disp = {body};
  m.end_code = {body};
  m.end_line = {body};
  m.node_column = {body};
  m.region = {body};
  m.body_force = {body};
  m.rigid_motion = {body};
  m.load_work = {body};
  m.zone = array_of<Zone>(s, kZones);
  m.pair = array_of<Pair>(s, kPairs);
  m.point_load = array_of<PointLoad>(s, kPointLoads);
  m.curve = array_of<Curve>(s, kCurves);
  m.slip_gap = s->model.curves > 0 ? array_of<SlipGap>(s, kSlipGaps) : nullptr;
  m.friction = array_of<double>(s, kFriction);
  m.path = array_of<Path>(s, kPaths);
  m.path_load = array_of<double>(s, kPathLoads);
  return m;
}

Sizes sizes_of(c2d_solver* s) {
  Sizes sizes = s->sizes;
  sizes.body = array_of<c2d_body_limits>(s, kBodyLimits);
  return sizes;
}
EliminationPlan& plan_of(c2d_solver* s, int b) { return array_of<EliminationPlan>(s, kPlans)[b]; }
BodyResults& results_of(c2d_solver* s, int b) { return array_of<BodyResults>(s, kBodyResults)[b]; }

// Zero or more; infinity is full adhesion. Not-a-numbers are told apart without comparing them.
bool is_coefficient(double value) { return isinf(value) ? value > 0.0 : (is_usable(value) && value >= 0.0); }
double* zone_friction(c2d_solver* s, int32_t i) {
  return array_of<double>(s, kFriction) + s->sizes.coefficients + i * s->sizes.zones;
}
double coefficient_of_zone(c2d_solver* s, int32_t zone, int32_t i) {
  if (s->model.coefficients == 0) return 0.0;
  const double own = zone < s->model.zones ? zone_friction(s, i)[zone] : -1.0;
  return own < 0.0 ? array_of<double>(s, kFriction)[i] : own;
}

} // namespace c2d
