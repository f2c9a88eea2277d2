#include "model/geometry.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "model/validate/validate_finding.hpp"

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

// Bits of the motions of a rigid body: free ones, and those prescribed in any load case.
int32_t motions_made(const Model& m, int b) {
  int32_t made = body_of(m, b).free_rigidly;
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    const RigidMotion& motion = m.rigid_motion[b][k];
    made |= (motion.ux != 0 ? 1 : 0) | (motion.uy != 0 ? 2 : 0) | (motion.rotation != 0 ? 4 : 0);
  }
  return made;
}

// Faults of a platen refer to the line of its card.
Where at_platen(const Zone& z, Where where) {
  where.line = z.line;
  return where;
}
Where at_rigid(const Model& m, int b) { return is_platen(m, b) ? at_platen(tie_of_platen(m, b), in_body(b)) : in_body(b); }

// Is an element end free of conditions, as without a card?
bool is_left_free(const Model& m, int b, int32_t end) {
  const int64_t ends = static_cast<int64_t>(body_of(m, b).elements) * m.head->function_nodes;
  constexpr int kKnown = kKnownTx | kKnownTy | kKnownUx | kKnownUy, kTractions = kKnownTx | kKnownTy;
  bool free = (m.end_code[b][end] & kGiven) == 0 || (m.end_code[b][end] & kKnown) == kTractions;
  for (int64_t k = 0; k < m.head->load_cases; ++k)
    for (int c = 0; c < 2; ++c) free = free && m.end_traction[b][(k * ends + end) * 2 + c] == 0;
  return free;
}

// Ends of elements of the platen must have no conditions: the platen determines displacement and traction.
bool check_ends(const Model& m, int b, const Zone& z, Reporter& reporter) {
  const int32_t f = m.head->function_nodes;
  for (int32_t k = 0; k < z.elements; ++k)
    for (int32_t element = zone_element(m, z, 1, k), l = 0; l < f; ++l) {
      if (is_left_free(m, z.body[1], element * f + l)) continue;
      report(reporter, at_platen(z, at_element(m, z.body[1], element)), "end ", l + 1, " of element ", element + 1, " of body ",
             body_named(m, z.body[1]), " is moved by body ", body_named(m, b),
             " and has a boundary condition as well, expected no condition there");
      return false;
    }
  return true;
}

// The last nodes of the platen also belong to the neighbouring elements, which may fix them only in directions in which the
// platen does not move.
void check_neighbours(const Model& m, int b, const Zone& z, Reporter& reporter) {
  const int32_t made = motions_made(m, b);
  for (int32_t k = 0; k < z.pairs; ++k)
    for (int c = 0; c < 2; ++c) {
      const int32_t node = zone_node(m, z, 1, k);
      if ((made & (4 | 1 << c)) == 0 || !displacement_known(m, z.body[1], node, c)) continue;
      return report(reporter, at_platen(z, at_node(m, z.body[1], node)), "node ", node + 1, " of body ",
                    body_named(m, z.body[1]), " is moved by body ", body_named(m, b), ", and the element beside it prescribes ",
                    c == 0 ? "ux" : "uy",
                    " there, expected no such condition, or a platen that neither moves in this direction nor rotates");
    }
}

} // namespace

void check_rigid(const Model& m, int b, Reporter& reporter) {
  if (carries_load(m, b))
    report(reporter, at_rigid(m, b), "body ", body_named(m, b),
           " is rigid, expected no tractions, non-zero displacements or forces on it (*RIGID prescribes its motion)");
  if (is_platen(m, b) && check_ends(m, b, tie_of_platen(m, b), reporter)) check_neighbours(m, b, tie_of_platen(m, b), reporter);
  const int32_t lines = body_of(m, b).lines, prevented = lines | (lines != 0 ? 4 : 0);
  if ((body_of(m, b).free_rigidly & prevented) != 0)
    report(reporter, at_rigid(m, b), "the rigid body ", body_named(m, b),
           is_axisymmetric(m) ? " may move freely across the axis" : " may move freely across a line of symmetry",
           ", expected motions along it");
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    const RigidMotion& motion = m.rigid_motion[b][k];
    const bool across = ((lines & 1) != 0 && motion.ux != 0) || ((lines & 2) != 0 && motion.uy != 0);
    if (!across && (lines == 0 || motion.rotation == 0)) continue;
    report(reporter, at_rigid(m, b), "the motion of the rigid body ", body_named(m, b), " in load case ", k + 1,
           is_axisymmetric(m) ? " leaves the axis" : " leaves the line of symmetry", ", expected one along it");
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
  if (f == 1) { // constant functions: between two elements both nodes
    *low = at.place - (along == -1.0 ? 1 : 0);
    *high = at.place + (along == 1.0 ? 1 : 0);
    return;
  }
  *low = at.place * (f - 1);
  *high = *low + f - 1;
  for (int l = 0; l < f; ++l)
    if (along == node_eta(f, l)) *low = *high = at.place * (f - 1) + l;
}

// A rigid body on side 1: its pairs prescribe displacements of side 0, one per pair. If side 0 has fewer nodes than pairs over
// some range the system is overdetermined. Greedy assignment of each pair to the first free node that it depends on.
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
                  ": the mesh of the rigid body ", body_named(m, z.body[1]), " is finer than that of body ",
                  body_named(m, z.body[0]), " up to element ", pair.element + 1,
                  "; expected at most one rigid node for each node faced, or the rigid body as side 1 of the zone");
  }
}

} // namespace

void check_rigid_zones(const Model& m, int b, Reporter& reporter) {
  for (int32_t i = 0; i < m.head->zones; ++i)
    if (m.zone[i].is_free != 0 && m.zone[i].body[1] == b) check_density(m, i, reporter);
}

} // namespace c2d
