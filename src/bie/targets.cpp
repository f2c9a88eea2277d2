// Targets: for each nodal component of an element, the columns that receive its integrals, or the right-hand sides if the
// value is prescribed (METHOD 2.2). At each node and in each direction exactly one of displacement and traction is unknown; in
// contact both are, in the pair's frame, so a component has two columns there.
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course (boundary conditions, corners).
#include "bie/targets.hpp"
#include "model/pair_frame.hpp"

namespace c2d {

namespace {

// Global component = normal and tangential unknowns times the direction cosines of the pair's frame.
void place_contact(const Model& m, const PairSide& at, int component, int32_t base, double factor, Destination& out) {
  const Pair& pair = m.pair[at.pair];
  const int32_t first = base + dof_on(m, pair, at.side);
  for (int dof = 0; dof <= pair.tangential; ++dof) out.target[dof] = Target{first + dof, factor * along(pair, dof, component)};
}

Destination nowhere() { return Destination{{{-1, 0.0}, {-1, 0.0}}, false, false}; }

Destination traction_destination(const Model& m, int b, int32_t element, int l, int component, const Unknown& unknown,
                                 const PairSide& contact) {
  Destination out = nowhere();
  const int32_t end = element * m.head->function_nodes + l;
  const bool has_unknown = (unknown.kind == UnknownKind::traction && unknown.end[0] == end) ||
                           unknown.kind == UnknownKind::shared_traction; // (both ends of its node)
  if (contact.pair >= 0 && is_of_contact(m, contact, functional_node(m, b, element, l), component, unknown)) {
    const double scale = m.head->stress_unit / (2.0 * shear_modulus(m, b));
    place_contact(m, contact, component, outer_columns(m, b) + m.body[b].contact, scale, out);
    out.contact = contact.side == 1; // on side 0 both measures are the same
  } else if (has_unknown) {
    out.target[0] = Target{outer_column(m, b, functional_node(m, b, element, l), component), -1.0};
  } else {
    out.known = true;
  }
  return out;
}

// A component at a local node of an element.
struct Place {
  int b;
  int32_t element, node;
  int l, component;
};

// Does anything of this destination fall into the range? A prescribed value must also differ from zero in some load case.
bool wanted(const Model& m, const Destination& d, const Range& range, const Place& at, bool traction) {
  if (range.contains(d.target[0].column) || range.contains(d.target[1].column)) return true;
  if (!d.known || !range.has_right()) return false;
  for (int32_t k = 0; k < m.head->load_cases; ++k) {
    if (!range.contains(range.right + k)) continue;
    const double value = traction ? known_traction(m, at.b, at.element, at.l, at.component, k)
                                  : known_displacement(m, at.b, at.node, at.component, k);
    if (value != 0.0) return true;
  }
  return false;
}

} // namespace

Destination displacement_destination(const Model& m, int b, int32_t node, int component, const Unknown& unknown) {
  Destination out = nowhere();
  if (unknown.kind == UnknownKind::contact)
    place_contact(m, pair_of_node(m, b, node), component, outer_columns(m, b), 1.0, out);
  else if (unknown.kind == UnknownKind::displacement)
    out.target[0] = Target{outer_column(m, b, node, component), 1.0};
  else
    out.known = true;
  return out;
}

double known_displacement(const Model& m, int b, int32_t node, int component, int32_t load_case) {
  return -given_displacement(m, b, node, component, load_case) / m.head->length_unit;
}
double known_traction(const Model& m, int b, int32_t element, int l, int component, int32_t load_case) {
  return given_traction(m, b, element * m.head->function_nodes + l, component, load_case) / (2.0 * shear_modulus(m, b));
}

namespace {

bool goes_to_two(const Destination& d) {
  return d.target[1].column >= 0 && d.target[0].factor != 0.0 && d.target[1].factor != 0.0;
}

} // namespace

bool concerns(const Model& m, int b, int32_t node, const Range& range) {
  if (range.last > m.body[b].columns) return true;
  return m.node_column[b][node] < range.last && m.node_column[b][node + 1] > range.first;
}

void aim(const Model& m, int b, int32_t element, const Range& range, ElementTargets& out) {
  out.want_h = out.want_g = out.want_contact = out.shared = false;
  // Most elements have no column in a narrow panel: they are excluded before their unknowns are looked up.
  bool concerned = false;
  for (int l = 0; l < m.head->function_nodes && !concerned; ++l)
    concerned = concerns(m, b, functional_node(m, b, element, l), range);
  if (!concerned) return;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t node = functional_node(m, b, element, l);
    out.node[l] = node;
    const PairSide contact = pair_of_end(m, b, element, l);
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      Destination& h = out.h[l][c] = displacement_destination(m, b, node, c, unknown[c]);
      Destination& g = out.g[l][c] = traction_destination(m, b, element, l, c, unknown[c], contact);
      const Place at{b, element, node, l, c};
      out.shared = out.shared || goes_to_two(h) || goes_to_two(g);
      const bool want_h = wanted(m, h, range, at, false), want_g = wanted(m, g, range, at, true);
      if (!want_h) h = nowhere();
      if (!want_g) g = nowhere();
      out.want_h = out.want_h || want_h;
      (g.contact ? out.want_contact : out.want_g) |= want_g;
    }
  }
}

} // namespace c2d
