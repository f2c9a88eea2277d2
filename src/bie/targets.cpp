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

// What load cases of the range prescribe on an element that is not zero. Case by case, because the values of one lie together.
struct Given {
  bool h[kElementNodes][2], g[kElementNodes][2];
};
void find_given(const Model& m, int b, int32_t element, const Range& range, const int32_t node[kElementNodes], Given& out) {
  const int nf = m.head->function_nodes;
  for (int l = 0; l < nf; ++l)
    for (int c = 0; c < 2; ++c) out.h[l][c] = out.g[l][c] = false;
  for (int32_t k = range.first_case(); k < range.end_case(); ++k)
    for (int l = 0; l < nf; ++l)
      for (int c = 0; c < 2; ++c) {
        out.h[l][c] |= given_displacement(m, b, node[l], c, k) != 0.0;
        out.g[l][c] |= given_traction(m, b, element * nf + l, c, k) != 0.0;
      }
}

// Does anything of this destination fall into the range? A prescribed value must also differ from zero in some load case.
bool wanted(const Destination& d, const Range& range, bool given) {
  return range.contains(d.target[0].column) || range.contains(d.target[1].column) || (d.known && given);
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
  for (int l = 0; l < m.head->function_nodes; ++l) out.node[l] = functional_node(m, b, element, l);
  Given given;
  find_given(m, b, element, range, out.node, given);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t node = out.node[l];
    const PairSide contact = pair_of_end(m, b, element, l);
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      Destination& h = out.h[l][c] = displacement_destination(m, b, node, c, unknown[c]);
      Destination& g = out.g[l][c] = traction_destination(m, b, element, l, c, unknown[c], contact);
      out.shared = out.shared || goes_to_two(h) || goes_to_two(g);
      const bool want_h = wanted(h, range, given.h[l][c]), want_g = wanted(g, range, given.g[l][c]);
      if (!want_h) h = nowhere();
      if (!want_g) g = nowhere();
      out.want_h = out.want_h || want_h;
      (g.contact ? out.want_contact : out.want_g) |= want_g;
    }
  }
}

} // namespace c2d
