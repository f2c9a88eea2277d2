#include "model/geometry.hpp"
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

namespace {

// Functional nodes of side 0 on which the displacement of a pair's point there depends, counted along the zone.
void nodes_faced(const Model& m, const Pair& pair, int32_t* low, int32_t* high) {
  const Zone& z = zone_of(m, pair);
  const int32_t f = m.head->function_nodes;
  ZonePlace at = {0, 0, 0};
  find_contact_element(m, z.body[0], pair.element, &at);
  const double along = z.element_step[0] * pair.eta;
  if (f == 1) { // between two elements that of both
    *low = at.place - (along == -1.0 ? 1 : 0);
    *high = at.place + (along == 1.0 ? 1 : 0);
    return;
  }
  *low = at.place * (f - 1);
  *high = *low + f - 1;
  for (int l = 0; l < f; ++l)
    if (along == node_eta(f, l)) *low = *high = at.place * (f - 1) + l;
}

// A rigid body on side 1 whose nodes the nodes of side 0 cannot follow, one each.
void check_density(const Model& m, int32_t zone, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  int32_t next = -1;
  for (int32_t k = 0; k < z.pairs; ++k) {
    const Pair& pair = m.pair[z.first_pair + k];
    int32_t low, high;
    nodes_faced(m, pair, &low, &high);
    next = low > next ? low : next + 1;
    if (next <= high) continue;
    return report(reporter, in_zone(m, zone, z.body[0], pair.element), "zone ", zone_named(m, zone),
                  ": the nodes of the rigid body ", body_named(m, z.body[1]), " are denser than those of body ",
                  body_named(m, z.body[0]), " that they face, as far as its element ", pair.element + 1,
                  "; expected no more than one for each, or the rigid body as the zone's first");
  }
}

} // namespace

void check_rigid_zones(const Model& m, int b, Reporter& reporter) {
  for (int32_t i = 0; i < m.head->zones; ++i)
    if (m.zone[i].is_free != 0 && m.zone[i].body[1] == b) check_density(m, i, reporter);
}

} // namespace c2d
