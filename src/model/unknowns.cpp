// The unknown of each functional node and component: displacement or traction (METHOD 2.2).
//
// A boundary element equation is written per node and component, so exactly one quantity may be unknown there. A node has one
// displacement but two tractions, one per element end:
//   displacement free, all tractions known:   the displacement is unknown
//   displacement known, one traction unknown: that traction
//   displacement known, both unknown:         one traction shared by both ends (a smooth boundary; at a corner an
//   approximation) node of a contact pair:                   displacement and traction belong to the contact system
// Anything else is a fault of the model (UnknownKind none, several).
#include "model/unknowns.hpp"
#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"

namespace c2d {

// Nodes on side 0 of a free zone belong to no pair; their contact traction is transferred (METHOD 9.2) and is no unknown. A
// card that declares traction and displacement unknown there leaves the traction to the contact.
static bool is_left_to_contact(const Model& m, int b, int32_t end, int component) {
  ZonePlace at;
  const int32_t f = m.head->function_nodes, element = end / f;
  return find_contact_element(m, b, element, &at) && at.side == 0 && m.zone[at.zone].is_free != 0 &&
         !displacement_known(m, b, functional_node(m, b, element, end % f), component);
}

bool traction_known(const Model& m, int b, int32_t end, int component) {
  const uint8_t code = m.end_code[b][end];
  return (code & kGiven) == 0 || (code & (component == 0 ? kKnownTx : kKnownTy)) != 0 ||
         is_left_to_contact(m, b, end, component);
}

static bool is_displacement_known(const Model& m, int b, const int32_t* ends, int count, int component) {
  for (int i = 0; i < count; ++i)
    if ((m.end_code[b][ends[i]] & (component == 0 ? kKnownUx : kKnownUy)) != 0) return true;
  return false;
}

bool displacement_known(const Model& m, int b, int32_t node, int component) {
  int32_t ends[2];
  return is_displacement_known(m, b, ends, all_ends_at_node(m, b, node, ends), component);
}

bool is_contact_component(const Pair& pair, int component) {
  const int along_normal = fabs(pair.nx) > fabs(pair.ny) ? 0 : 1;
  return pair.tangential != 0 || component == along_normal;
}

namespace {

// Both displacement and traction of a contact node are unknown; the contact conditions supply the missing equation. So the
// displacement must be free (checked in build_frames), and ends outside the contact may have no unknown traction.
UnknownKind contact_kind(const Model& m, int b, const int32_t* ends, int count, int component) {
  const int32_t f = m.head->function_nodes;
  for (int i = 0; i < count; ++i) {
    const bool in_contact = pair_of_end(m, b, ends[i] / f, ends[i] % f).pair >= 0;
    if (!in_contact && !traction_known(m, b, ends[i], component)) return UnknownKind::several;
  }
  return UnknownKind::contact;
}

// Data common to both components of a node.
struct NodeEnds {
  int32_t ends[2]; // except those on lines of symmetry
  int count;
  bool fixed[2];
  int32_t pair;
};

NodeEnds ends_of(const Model& m, int b, int32_t node) {
  NodeEnds at;
  const int all = all_ends_at_node(m, b, node, at.ends);
  for (int c = 0; c < 2; ++c) at.fixed[c] = is_displacement_known(m, b, at.ends, all, c);
  at.count = ends_off_axis(m, b, at.ends, all);
  at.pair = pair_of_node(m, b, node).pair;
  return at;
}

Unknown find_unknown(const Model& m, int b, int32_t node, const NodeEnds& at, int component) {
  Unknown unknown = {UnknownKind::displacement, {-1, -1}, false};
  if (is_held_by_symmetry(m, b, node, component)) return unknown;
  const bool fixed = at.fixed[component];
  if (at.pair >= 0 && is_contact_component(m.pair[at.pair], component)) {
    unknown.loaded = !kSmallCode && m.body[b].on_demand != 0;
    if (unknown.loaded) return unknown;
    unknown.kind = contact_kind(m, b, at.ends, at.count, component);
    return unknown;
  }
  // In a direction fixed by symmetry a contact end has no traction unless a card declares it unknown.
  int tractions = 0;
  for (int i = 0; i < at.count; ++i) {
    if (!traction_known(m, b, at.ends[i], component)) unknown.end[tractions++] = at.ends[i];
  }
  if (!fixed)
    unknown.kind = tractions == 0 ? UnknownKind::displacement : UnknownKind::several;
  else if (tractions == 0)
    unknown.kind = UnknownKind::none;
  else
    unknown.kind = tractions == 1 ? UnknownKind::traction : UnknownKind::shared_traction;
  return unknown;
}

} // namespace

bool is_of_contact(const Model& m, const PairSide& at, int32_t node, int component, const Unknown& unknown) {
  if (at.pair < 0) return false;
  const Pair& pair = m.pair[at.pair];
  return pair.node[at.side] == node ? is_in_contact(unknown) : is_contact_component(pair, component);
}

Unknown unknown_at(const Model& m, int b, int32_t node, int component) {
  return find_unknown(m, b, node, ends_of(m, b, node), component);
}

void unknowns_at(const Model& m, int b, int32_t node, Unknown unknown[2]) {
  const NodeEnds at = ends_of(m, b, node);
  for (int c = 0; c < 2; ++c) unknown[c] = find_unknown(m, b, node, at, c);
}

int32_t further_unknowns(const Model& m, int end) {
  int32_t count = 0;
  for (int b = 0; b < end; ++b)
    if (has_displacements(m, b)) count += m.body[b].contact;
  return count;
}

double shear_modulus(const Model& m, int b) {
  const Body& body = body_of(m, b);
  return body.youngs_modulus / (2 * (1 + body.poisson_ratio));
}

double strain_poisson_ratio(const Model& m, int b) {
  const double nu = body_of(m, b).poisson_ratio;
  return m.head->plane == C2D_PLANE_STRESS ? nu / (1 + nu) : nu;
}

namespace {
double power_of_two_near(double value) {
  int exponent;
  frexp(value, &exponent);
  return ldexp(1, exponent);
}
} // namespace

bool has_body_forces(const Model& m) {
  for (int b = 0; b < m.head->bodies; ++b)
    if (m.body[b].has_force != 0) return true;
  return false;
}

// Units are powers of two: dividing by them is exact, so results do not depend on the units of the input beyond the last
// digits. Lengths refer to the largest body, stresses to 2G of the softest one, whose deformation dominates.
void set_units(const Model& m) {
  double size = 0, modulus = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    const Box box = box_of_body(m, b);
    size = fmax(size, fmax(box.x_max - box.x_min, box.y_max - box.y_min));
    if (is_rigid(m, b)) continue; // a rigid body has no modulus
    modulus = modulus > 0 ? fmin(modulus, 2 * shear_modulus(m, b)) : 2 * shear_modulus(m, b);
  }
  m.head->length_unit = size > 0 ? power_of_two_near(size) : 1;
  m.head->stress_unit = modulus > 0 ? power_of_two_near(modulus) : 1;
}

} // namespace c2d
