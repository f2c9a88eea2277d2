#include "model/validate_finding.hpp"

namespace c2d {

namespace {

bool carries_load(const Model& m, int b) {
  const int64_t cases = m.head->load_cases, nodes = 2 * static_cast<int64_t>(body_of(m, b).nodes) * cases;
  const int64_t ends = 2 * static_cast<int64_t>(body_of(m, b).elements) * m.head->function_nodes * cases;
  bool loaded = body_of(m, b).has_force != 0;
  for (int64_t i = 0; i < ends; ++i) loaded = loaded || m.end_traction[b][i] != 0;
  for (int64_t i = 0; i < nodes; ++i) loaded = loaded || m.node_disp[b][i] != 0;
  for (int32_t i = 0; i < m.head->point_loads; ++i) loaded = loaded || m.point_load[i].body == b;
  return loaded;
}

} // namespace

void check_rigid(const Model& m, int b, Reporter& reporter) {
  if (carries_load(m, b))
    report(reporter, in_body(b), "body ", body_named(m, b),
           " is rigid, expected no tractions, displacements other than zero or forces there (*RIGID moves it)");
  const int32_t lines = body_of(m, b).lines, prevented = lines | (lines != 0 ? 4 : 0);
  if ((body_of(m, b).free_rigidly & prevented) != 0)
    report(reporter, in_body(b), "the rigid body ", body_named(m, b),
           " may move freely across a line of symmetry, expected motions along it");
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    const RigidMotion& motion = m.rigid_motion[b][k];
    const bool across = ((lines & 1) != 0 && motion.ux != 0) || ((lines & 2) != 0 && motion.uy != 0);
    if (!across && (lines == 0 || motion.rotation == 0)) continue;
    report(reporter, in_body(b), "the motion of the rigid body ", body_named(m, b), " in load case ", k + 1,
           " leaves the line of symmetry, expected one along it");
  }
}

} // namespace c2d
