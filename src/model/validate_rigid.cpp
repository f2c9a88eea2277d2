#include "model/validate_finding.hpp"

namespace c2d {

void check_rigid(const Model& m, Reporter& reporter) {
  const int64_t cases = m.head->load_cases, nodes = 2 * static_cast<int64_t>(body_of(m, 0).nodes) * cases;
  const int64_t ends = 2 * static_cast<int64_t>(body_of(m, 0).elements) * m.head->function_nodes * cases;
  bool loaded = (m.head->body_forces & 1) != 0;
  for (int64_t i = 0; i < ends; ++i) loaded = loaded || m.end_traction[0][i] != 0;
  for (int64_t i = 0; i < nodes; ++i) loaded = loaded || m.node_disp[0][i] != 0;
  for (int32_t i = 0; i < m.head->point_loads; ++i) loaded = loaded || m.point_load[i].body == 0;
  if (loaded)
    report(reporter, in_body(0),
           "body 1 is rigid, expected no tractions, displacements other than zero or forces there (*RIGID moves it)");
  for (int32_t z = 0; z < m.head->zones; ++z) {
    if (m.zone[z].is_free == 0) continue;
    report(reporter, Where{0, 0, z + 1, 0, 0, 0}, "zone ", z + 1,
           " joins meshes that do not match, expected matching ones where body 1 is rigid");
  }
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    const RigidMotion& motion = m.rigid_motion[k];
    const bool across = ((m.head->symmetry & 1) != 0 && motion.ux != 0) || ((m.head->symmetry & 2) != 0 && motion.uy != 0);
    if (!across && (m.head->symmetry == 0 || motion.rotation == 0)) continue;
    report(reporter, in_body(0), "the motion of the rigid body 1 in load case ", k + 1,
           " leaves the line of symmetry, expected one along it");
  }
}

} // namespace c2d
