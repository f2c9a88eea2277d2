// The arrays of the workspace as the rooms below see them.
#include <math.h>

#include "model/validate.hpp"
#include "solver/solver.hpp"

namespace c2d {

Model model_of(c2d_solver* s) {
  Model m;
  m.head = &s->model;
  for (int b = 0; b < 2; ++b) {
    m.xy[b] = array_of<double>(s, kXy + b);
    m.node_line[b] = array_of<int32_t>(s, kNodeLine + b);
    m.end_traction[b] = array_of<double>(s, kEndTraction + b);
    m.node_disp[b] = array_of<double>(s, kNodeDisp + b);
    m.end_code[b] = array_of<uint8_t>(s, kEndCode + b);
    m.end_line[b] = array_of<int32_t>(s, kEndLine + b);
    m.node_column[b] = array_of<int32_t>(s, kNodeColumn + b);
    m.region[b] = array_of<Region>(s, kRegions + b);
  }
  m.zone = array_of<Zone>(s, kZones);
  m.pair = array_of<Pair>(s, kPairs);
  m.point_load = array_of<PointLoad>(s, kPointLoads);
  m.curve = array_of<Curve>(s, kCurves);
  m.friction = array_of<double>(s, kFriction);
  m.path = array_of<Path>(s, kPaths);
  m.rigid_motion = array_of<RigidMotion>(s, kRigidMotions);
  m.body_force = array_of<BodyForce>(s, kBodyForces);
  m.path_load = array_of<double>(s, kPathLoads);
  return m;
}

// Zero or more; infinity is full adhesion. Not-a-numbers are told apart without comparing them.
bool is_coefficient(double mu) { return isinf(mu) ? mu > 0.0 : (is_usable(mu) && mu >= 0.0); }
double* zone_friction(c2d_solver* s, int32_t i) {
  return array_of<double>(s, kFriction) + s->sizes.coefficients + i * s->sizes.zones;
}
double coefficient_of_zone(c2d_solver* s, int32_t zone, int32_t i) {
  if (s->model.coefficients == 0) return 0.0;
  const double own = zone < s->model.zones ? zone_friction(s, i)[zone] : -1.0;
  return own < 0.0 ? array_of<double>(s, kFriction)[i] : own;
}

} // namespace c2d
