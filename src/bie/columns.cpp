#include "bie/columns.hpp"

#include <math.h>

#include "bie/body_force.hpp"
#include "bie/kernels.hpp"
#include "bie/shape.hpp"
#include "bie/transfer.hpp"
#include "model/symmetry.hpp"

namespace c2d {

// ---- numbering --------------------------------------------------------------------------------------------------

void number_unknowns(const Model& m, int b) {
  Body& body = m.head->body[b];
  int32_t column = 0;
  for (int32_t node = 0; node < body.nodes; ++node) {
    m.node_column[b][node] = column;
    for (int c = 0; c < 2; ++c)
      if (unknown_at(m, b, node, c).kind != UnknownKind::contact) ++column;
  }
  m.node_column[b][body.nodes] = column;
  body.columns = column;
}

int32_t outer_column(const Model& m, int b, int32_t node, int component) {
  if (unknown_at(m, b, node, component).kind == UnknownKind::contact) return -1;
  const bool second = component == 1 && unknown_at(m, b, node, 0).kind != UnknownKind::contact;
  return m.node_column[b][node] + (second ? 1 : 0);
}

// ---- elements ---------------------------------------------------------------------------------------------------

namespace {

Element scaled_element(const Model& m, int b, int32_t element) {
  double x[4], y[4];
  element_coordinates(m, b, element, x, y);
  const int nodes = m.head->body[b].element_nodes;
  for (int k = 0; k < nodes; ++k) {
    x[k] /= m.head->length_unit;
    y[k] /= m.head->length_unit;
  }
  return make_element(nodes, x, y);
}

// The element of body 1 that faces a contact element of body 2; -1 if there is none.
int32_t facing_element(const Model& m, int b, int32_t element, bool* reversed) {
  int32_t zone = 0, place = 0;
  if (b != 1 || !find_contact_element(m, b, element, &zone, &place)) return -1;
  const Zone& z = m.zone[zone];
  if (z.is_free != 0) return -1; // tau is per length of body 2
  *reversed = z.element_step[0] != z.element_step[1];
  return zone_element(m, z, 0, place);
}

} // namespace

void make_integrator(const Model& m, int b, int32_t element, Quadrature quadrature, Measure measure,
                     Integrator& out) {
  prepare(out, scaled_element(m, b, element), m.head->function_nodes, strain_poisson_ratio(m, b), quadrature);
  if (measure == Measure::own_length) return;
  bool reversed = false;
  const int32_t facing = facing_element(m, b, element, &reversed);
  if (facing >= 0) set_arc(out, scaled_element(m, 0, facing), reversed);
}

void end_resultants(const Model& m, int b, int32_t element, Measure measure, EndResultant out[4]) {
  Integrator integrator;
  make_integrator(m, b, element, Quadrature::accurate, measure, integrator);
  double w[4], wx[4], wy[4];
  resultants(integrator, 0.0, 0.0, w, wx, wy);
  for (int l = 0; l < m.head->function_nodes; ++l) out[l] = EndResultant{w[l], wx[l], wy[l]};
}

double traction_ratio(const Model& m, int b, int32_t element, int l) {
  bool reversed = false;
  const int32_t facing = facing_element(m, b, element, &reversed);
  if (facing < 0 || pair_of_end(m, b, element, l) < 0) return 1.0;
  const double eta = node_eta(m.head->function_nodes, l);
  const Point own = element_point(scaled_element(m, b, element), eta);
  const Point other = element_point(scaled_element(m, 0, facing), reversed ? -eta : eta);
  return other.jacobian / own.jacobian;
}

// ---- where an element's integrals go ----------------------------------------------------------------------------

namespace {

struct Target { // column -= or += factor * integral; column < 0: nowhere
  int32_t column;
  double factor;
};
// Of one component of one local node: at most the two contact columns of its pair, or one outer column. What is
// prescribed goes to the right-hand sides.
struct Destination {
  Target target[2];
  bool known;   // times value(case), into the right-hand sides
  bool contact; // a contact traction, see Measure
};

struct Range { // the columns wanted, and the first right-hand side
  int32_t first, last, right;
  bool holds(int32_t column) const { return column >= first && column < last; }
  bool holds_right() const { return last > right; }
};

struct ElementTargets {
  Destination h[4][2], g[4][2];
  int32_t node[4];
  bool want_h, want_g;  // tractions on the element's own length
  bool want_contact;    // contact tractions
};

void aim_contact(const Pair& pair, int component, int32_t base, double factor, Destination& out) {
  const double n[2] = {pair.nx, pair.ny}, t[2] = {pair.ny, -pair.nx};
  out.target[0] = Target{base + pair.dof, factor * n[component]};
  if (pair.tangential) out.target[1] = Target{base + pair.dof + 1, factor * t[component]};
}

Destination nowhere() { return Destination{{{-1, 0.0}, {-1, 0.0}}, false, false}; }

Destination displacement_destination(const Model& m, int b, int32_t node, int component, const Unknown& unknown) {
  Destination out = nowhere();
  if (unknown.kind == UnknownKind::contact)
    aim_contact(m.pair[pair_of_node(m, b, node)], component, outer_columns(m, b), 1.0, out);
  else if (unknown.kind == UnknownKind::displacement)
    out.target[0] = Target{outer_column(m, b, node, component), 1.0};
  else
    out.known = true;
  return out;
}

Destination traction_destination(const Model& m, int b, int32_t element, int l, int component,
                                 const Unknown& unknown, int32_t pair) {
  Destination out = nowhere();
  const int32_t end = element * m.head->function_nodes + l;
  const bool holds_unknown =
      (unknown.kind == UnknownKind::traction && unknown.end[0] == end) ||
      (unknown.kind == UnknownKind::shared_traction && (unknown.end[0] == end || unknown.end[1] == end));
  if (pair >= 0 && unknown.kind == UnknownKind::contact) {
    const double scale = m.head->stress_unit / (2.0 * shear_modulus(m, b));
    aim_contact(m.pair[pair], component, outer_columns(m, b) + m.head->contact, scale, out);
    out.contact = b == 1; // on body 1 both measures are one
  } else if (holds_unknown) {
    out.target[0] =
        Target{outer_column(m, b, functional_node(m, b, element, l), component), -1.0};
  } else {
    out.known = true;
  }
  return out;
}

// Prescribed values in the units of the equations; displacement carries the sign of its move to the right.
double known_displacement(const Model& m, int b, int32_t node, int component, int32_t load_case) {
  const int64_t at = (static_cast<int64_t>(load_case) * m.head->body[b].nodes + node) * 2 + component;
  return -m.node_disp[b][at] / m.head->length_unit;
}
double known_traction(const Model& m, int b, int32_t element, int l, int component, int32_t load_case) {
  const int64_t ends = static_cast<int64_t>(m.head->body[b].elements) * m.head->function_nodes;
  const int64_t end = static_cast<int64_t>(element) * m.head->function_nodes + l;
  return m.end_traction[b][(load_case * ends + end) * 2 + component] / (2.0 * shear_modulus(m, b));
}

// Something of this destination falls into the range (for a prescribed one: is not zero in every case).
template <class Value> bool wanted(const Model& m, const Destination& d, const Range& range, Value value) {
  if (range.holds(d.target[0].column) || range.holds(d.target[1].column)) return true;
  if (!d.known || !range.holds_right()) return false;
  for (int32_t k = 0; k < m.head->load_cases; ++k)
    if (range.holds(range.right + k) && value(k) != 0.0) return true;
  return false;
}

void aim(const Model& m, int b, int32_t element, const Range& range, ElementTargets& out) {
  out.want_h = out.want_g = out.want_contact = false;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t node = functional_node(m, b, element, l);
    out.node[l] = node;
    const int32_t pair = pair_of_end(m, b, element, l);
    for (int c = 0; c < 2; ++c) {
      const Unknown unknown = unknown_at(m, b, node, c);
      Destination& h = out.h[l][c] = displacement_destination(m, b, node, c, unknown);
      Destination& g = out.g[l][c] = traction_destination(m, b, element, l, c, unknown, pair);
      const bool want_h = wanted(m, h, range, [&](int32_t k) { return known_displacement(m, b, node, c, k); });
      const bool want_g = wanted(m, g, range, [&](int32_t k) { return known_traction(m, b, element, l, c, k); });
      if (!want_h) h = nowhere();
      if (!want_g) g = nowhere();
      out.want_h = out.want_h || want_h;
      (g.contact ? out.want_contact : out.want_g) |= want_g;
    }
  }
}

// ---- adding into the panel --------------------------------------------------------------------------------------

struct Panel {
  const Model& m;
  int b;
  Range range;
  Real* data;
  int64_t ld;

  Real* column(int32_t j) const { return range.holds(j) ? data + (j - range.first) * ld : nullptr; }
  void add(int32_t row, int32_t j, double value) const {
    if (Real* to = column(j)) to[row] += static_cast<Real>(value);
  }
  template <class Value> void send(const Destination& d, int32_t row, double integral, Value value) const {
    for (const Target& target : d.target)
      if (target.column >= 0) add(row, target.column, target.factor * integral);
    if (!d.known || !range.holds_right()) return;
    for (int32_t k = 0; k < m.head->load_cases; ++k) add(row, range.right + k, value(k) * integral);
  }
  void send_h(const Destination& d, int32_t node, int c, int32_t row, double integral) const {
    send(d, row, integral, [&](int32_t k) { return known_displacement(m, b, node, c, k); });
  }
  void send_g(const Destination& d, int32_t element, int l, int c, int32_t row, double integral) const {
    send(d, row, integral, [&](int32_t k) { return known_traction(m, b, element, l, c, k); });
  }
};

// Where the integrals of one element go, worked out once for all sources: column[2 s + i] += factor * block[i] with
// `block` the place of the component's integral for i = 0; i = 1 stands two doubles on.
struct Deposit {
  const double* block;
  Real* column;
  double factor;
};
constexpr int kMostDeposits = 48; // 4 nodes, 2 components, h and g: at most two contact columns, or one, each
struct Deposits {
  Deposit list[kMostDeposits];
  int count;

  void add(const double* block, Real* column, double factor) {
    if (column && factor != 0.0 && count < kMostDeposits) list[count++] = Deposit{block, column, factor};
  }
  void pay(int32_t source) const {
    for (int n = 0; n < count; ++n) {
      const Deposit& d = list[n];
      Real* to = d.column + 2 * source;
      to[0] += static_cast<Real>(d.factor * d.block[0]);
      to[1] += static_cast<Real>(d.factor * d.block[2]);
    }
  }
};

void aim_deposits(const Panel& panel, const Destination& d, const double* block, Deposits& out) {
  for (const Target& target : d.target)
    if (target.column >= 0) out.add(block, panel.column(target.column), target.factor);
}

// Local node of the element at which the source sits, itself or its twin; -1: none.
int singular_node(const int32_t node[4], int count, int32_t source, int32_t twin) {
  for (int l = 0; l < count; ++l)
    if (node[l] == source || (twin >= 0 && node[l] == twin)) return l;
  return -1;
}

} // namespace

Source mirrored_source(const ModelHeader& head, int image, const double at[2]) {
  if (image == 0) return Source{at[0], at[1], true};
  double p[2];
  for (int c = 0; c < 2; ++c)
    p[c] = (image >> c & 1) != 0 ? 2.0 * (head.line_at[c] / head.length_unit) - at[c] : at[c];
  return Source{p[0], p[1], p[0] == at[0] && p[1] == at[1]};
}

namespace {

void sign_rows(int image, int functions, double block[4][2][2]) {
  for (int l = 0; l < functions; ++l)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) block[l][i][j] *= image_sign(image, i);
}

// Prescribed values of one element and one load case.
void aim_right_hand_side(const Panel& panel, int32_t element, const ElementTargets& t, int32_t load_case,
                         bool want_h, bool want_g, bool contact, const Blocks& blocks, Deposits& out) {
  const Model& m = panel.m;
  Real* column = panel.column(panel.range.right + load_case);
  for (int l = 0; l < m.head->function_nodes; ++l)
    for (int c = 0; c < 2; ++c) {
      if (want_h && t.h[l][c].known)
        out.add(&blocks.h[l][0][c], column, known_displacement(m, panel.b, t.node[l], c, load_case));
      if (want_g && t.g[l][c].known && t.g[l][c].contact == contact)
        out.add(&blocks.g[l][0][c], column, known_traction(m, panel.b, element, l, c, load_case));
    }
}

// Integrals of an element for every source and image, paid where the deposits say.
void pay_sources(const ColumnSystem& system, const Integrator& integrator, const int32_t node[4], bool want_h,
                 bool want_g, Blocks& blocks, const Deposits& deposits) {
  const Model& m = system.model;
  const int nf = m.head->function_nodes;
  for (int32_t source = 0; source < m.head->body[system.body].nodes; ++source) {
    const int32_t twin = system.twin[source];
    if (twin == kSecondTwin || twin == kAxisNode) continue;
    const double* at = system.point + 2 * static_cast<int64_t>(source);
    for (int image = 0; image <= m.head->symmetry; ++image) {
      if (!is_image(*m.head, image)) continue;
      const Source p = mirrored_source(*m.head, image, at);
      const int singular = p.on_itself ? singular_node(node, nf, source, twin) : -1;
      integrate(integrator, p.x, p.y, singular, want_h, want_g, blocks);
      if (image > 0 && want_h) sign_rows(image, nf, blocks.h);
      if (image > 0 && want_g) sign_rows(image, nf, blocks.g);
      deposits.pay(source);
    }
  }
}

// The blocks of one element for every source, tractions in one measure; h goes with the element's own length.
void add_element(const ColumnSystem& system, const Panel& panel, int32_t element, const ElementTargets& t,
                 Measure measure) {
  const Model& m = system.model;
  const int nf = m.head->function_nodes;
  const bool contact = measure == Measure::contact;
  const bool want_h = t.want_h && !contact, want_g = contact ? t.want_contact : t.want_g;
  Integrator integrator;
  make_integrator(m, system.body, element, system.quadrature, measure, integrator);
  Blocks blocks;
  Deposits deposits;
  deposits.count = 0;
  for (int l = 0; l < nf; ++l)
    for (int c = 0; c < 2; ++c) {
      if (want_h) aim_deposits(panel, t.h[l][c], &blocks.h[l][0][c], deposits);
      if (want_g && t.g[l][c].contact == contact) aim_deposits(panel, t.g[l][c], &blocks.g[l][0][c], deposits);
    }
  // One load case shares the pass over the sources with the unknowns; each further one has a pass of its own.
  const int32_t passes = panel.range.holds_right() ? m.head->load_cases : 1;
  for (int32_t pass = 0; pass < passes; ++pass) {
    if (pass > 0) deposits.count = 0;
    if (panel.range.holds_right())
      aim_right_hand_side(panel, element, t, pass, want_h, want_g, contact, blocks, deposits);
    if (deposits.count == 0) continue;
    pay_sources(system, integrator, t.node, want_h, want_g, blocks, deposits);
  }
}

// The element's share of the three balance rows.
void add_balance(const ColumnSystem& system, const Panel& panel, int32_t element, const ElementTargets& t,
                 Measure measure) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.head->body[b];
  const int32_t row = 2 * body.nodes;
  Integrator integrator;
  make_integrator(m, b, element, system.quadrature, measure, integrator);
  double w[4], wx[4], wy[4];
  resultants(integrator, body.centre[0] / m.head->length_unit, body.centre[1] / m.head->length_unit, w, wx, wy);
  for (int l = 0; l < m.head->function_nodes; ++l)
    for (int c = 0; c < 2; ++c) {
      if (t.g[l][c].contact != (measure == Measure::contact)) continue;
      panel.send_g(t.g[l][c], element, l, c, row + c, w[l]);
      panel.send_g(t.g[l][c], element, l, c, row + 2, c == 0 ? -wy[l] : wx[l]);
    }
}

// Free term, twin equations and the multipliers' columns of one node.
void add_node(const ColumnSystem& system, const Panel& panel, int32_t node) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.head->body[b];
  if (system.twin[node] == kAxisNode) return;
  const bool second = system.twin[node] == kSecondTwin;
  const int32_t twin = second ? twin_node(m, b, node) : kSingle;
  for (int c = 0; c < 2; ++c) {
    const Destination d = displacement_destination(m, b, node, c, unknown_at(m, b, node, c));
    if (second) {
      const Destination other = displacement_destination(m, b, twin, c, unknown_at(m, b, twin, c));
      panel.send_h(d, node, c, 2 * node + c, 1.0);
      panel.send_h(other, twin, c, 2 * node + c, -1.0);
    } else {
      const double* block = system.diagonal + 4 * static_cast<int64_t>(node);
      for (int i = 0; i < 2; ++i) panel.send_h(d, node, c, 2 * node + i, block[2 * i + c]);
    }
  }
  if (second) return;
  const double* at = system.point + 2 * static_cast<int64_t>(node);
  panel.add(2 * node, body.columns, -1.0);
  panel.add(2 * node + 1, body.columns + 1, -1.0);
  panel.add(2 * node, body.columns + 2, at[1] - body.centre[1] / m.head->length_unit);
  panel.add(2 * node + 1, body.columns + 2, -(at[0] - body.centre[0] / m.head->length_unit));
}

void add_point_load(const ColumnSystem& system, const Panel& panel, const PointLoad& load) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.head->body[b];
  const double unit = m.head->length_unit, nu = strain_poisson_ratio(m, b);
  const double scale = 1.0 / (2.0 * shear_modulus(m, b) * unit);
  const double f[2] = {load.fx * scale, load.fy * scale};
  const int32_t column = panel.range.right + load.load_case;
  for (int32_t node = 0; node < body.nodes; ++node) {
    if (system.twin[node] == kSecondTwin || system.twin[node] == kAxisNode) continue;
    const double* at = system.point + 2 * static_cast<int64_t>(node);
    for (int image = 0; image <= m.head->symmetry; ++image) {
      if (!is_image(*m.head, image)) continue;
      double u[2][2];
      const Source p = mirrored_source(*m.head, image, at);
      const double rx = load.x / unit - p.x, ry = load.y / unit - p.y;
      store(displacement_kernel(rx, ry, rx * rx + ry * ry, 3.0 - 4.0 * nu), 1.0 / (4.0 * kPi * (1.0 - nu)), u);
      for (int i = 0; i < 2; ++i)
        panel.add(2 * node + i, column, image_sign(image, i) * (u[i][0] * f[0] + u[i][1] * f[1]));
    }
  }
  const double ax = (load.x - body.centre[0]) / unit, ay = (load.y - body.centre[1]) / unit;
  panel.add(2 * body.nodes, column, f[0]);
  panel.add(2 * body.nodes + 1, column, f[1]);
  panel.add(2 * body.nodes + 2, column, ax * f[1] - ay * f[0]);
}

// H u_p - G t_p of one element, into the right-hand side of one load case.
void add_particular(const ColumnSystem& system, const Panel& panel, int32_t element, int32_t load_case) {
  const Model& m = system.model;
  const int b = system.body, nf = m.head->function_nodes;
  Real* column = panel.column(panel.range.right + load_case);
  Integrator integrator;
  make_integrator(m, b, element, system.quadrature, Measure::own_length, integrator);
  Blocks blocks;
  Deposits deposits;
  deposits.count = 0;
  int32_t node[4];
  for (int l = 0; l < nf; ++l) {
    node[l] = functional_node(m, b, element, l);
    double x, y, t[2];
    node_position(m, b, node[l], &x, &y);
    const Particular p = particular_solution(m, b, load_case, x, y);
    particular_traction(m, b, load_case, element, l, t);
    for (int c = 0; c < 2; ++c) {
      deposits.add(&blocks.h[l][0][c], column, p.u[c] / m.head->length_unit);
      deposits.add(&blocks.g[l][0][c], column, -t[c] / (2.0 * shear_modulus(m, b)));
    }
  }
  if (deposits.count > 0) pay_sources(system, integrator, node, true, true, blocks, deposits);
}

// What the body force of a load case adds to its right-hand side: the equations hold for u - u_p and t - t_p.
void add_body_force(const ColumnSystem& system, const Panel& panel, int32_t load_case) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.head->body[b];
  const int32_t column = panel.range.right + load_case;
  if (!panel.range.holds(column) || !is_loaded(body_force(m, b, load_case))) return;
  for (int32_t element = 0; element < body.elements; ++element)
    if (is_integrated(m, b, element)) add_particular(system, panel, element, load_case);
  for (int32_t node = 0; node < body.nodes; ++node) {
    if (system.twin[node] == kSecondTwin || system.twin[node] == kAxisNode) continue;
    double x, y;
    node_position(m, b, node, &x, &y);
    const Particular p = particular_solution(m, b, load_case, x, y);
    const double* block = system.diagonal + 4 * static_cast<int64_t>(node);
    for (int i = 0; i < 2; ++i)
      panel.add(2 * node + i, column, (block[2 * i] * p.u[0] + block[2 * i + 1] * p.u[1]) / m.head->length_unit);
  }
  double force[3];
  body_force_resultant(m, b, load_case, body.centre[0], body.centre[1], force);
  const double scale = 1.0 / (2.0 * shear_modulus(m, b) * m.head->length_unit);
  for (int i = 0; i < 2; ++i) panel.add(2 * body.nodes + i, column, scale * force[i]);
  panel.add(2 * body.nodes + 2, column, scale * force[2] / m.head->length_unit);
}

// This row says: the unknown of column j is zero.
void hold(const Panel& panel, int32_t row, int32_t j) {
  for (int32_t k = panel.range.first; k < panel.range.last; ++k) *(panel.column(k) + row) = 0;
  panel.add(row, j, 1.0);
}

// Where symmetry leaves nothing of an equation, or fixes the displacement: u = 0 in place of it. Of the balances those
// remain that a symmetric state can violate: the force along the only line.
void hold_by_symmetry(const ColumnSystem& system, const Panel& panel) {
  const Model& m = system.model;
  const Body& body = m.head->body[system.body];
  for (int32_t node = 0; node < body.nodes; ++node)
    for (int c = 0; c < 2; ++c)
      if (is_held_by_symmetry(m, system.body, node, c))
        hold(panel, 2 * node + c, outer_column(m, system.body, node, c));
  for (int c = 0; c < 3; ++c)
    if (c == 2 || (m.head->symmetry >> c & 1) != 0) hold(panel, 2 * body.nodes + c, body.columns + c);
}

} // namespace

void place_sources(const ColumnSystem& system) {
  const Model& m = system.model;
  for (int32_t node = 0; node < m.head->body[system.body].nodes; ++node) {
    double x, y;
    node_position(m, system.body, node, &x, &y);
    system.point[2 * static_cast<int64_t>(node)] = x / m.head->length_unit;
    system.point[2 * static_cast<int64_t>(node) + 1] = y / m.head->length_unit;
    const bool second = is_second_twin(m, system.body, node);
    system.twin[node] = second ? kSecondTwin : twin_node(m, system.body, node);
    int32_t ends[2];
    if (m.head->symmetry != 0 && ends_at_node(m, system.body, node, ends) == 0) system.twin[node] = kAxisNode;
  }
}

void fill_columns(const ColumnSystem& system, int32_t first, int32_t count, Real* data, int64_t ld) {
  const Model& m = system.model;
  const int b = system.body;
  const int32_t rows = system_rows(m, b);
  for (int32_t j = 0; j < count; ++j)
    for (int32_t i = 0; i < rows; ++i) data[j * ld + i] = 0;
  const Range range{first, first + count, outer_columns(m, b) + 2 * m.head->contact};
  const Panel panel{m, b, range, data, ld};
  for (int32_t element = 0; element < m.head->body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    ElementTargets targets;
    aim(m, b, element, range, targets);
    if (targets.want_h || targets.want_g) add_element(system, panel, element, targets, Measure::own_length);
    if (targets.want_g) add_balance(system, panel, element, targets, Measure::own_length);
    if (!targets.want_contact) continue;
    add_element(system, panel, element, targets, Measure::contact);
    add_balance(system, panel, element, targets, Measure::contact);
  }
  for (int32_t node = 0; node < m.head->body[b].nodes; ++node) add_node(system, panel, node);
  for (int32_t i = 0; i < m.head->point_loads && range.holds_right(); ++i)
    if (m.point_load[i].body == b) add_point_load(system, panel, m.point_load[i]);
  for (int32_t k = 0; k < m.head->load_cases && has_body_force(m, b); ++k) add_body_force(system, panel, k);
  if (m.head->symmetry != 0) hold_by_symmetry(system, panel);
  if (b == 0 && m.head->free_rows > 0) fill_transfer(system, first, count, data, ld);
}

void fill_diagonal(const ColumnSystem& system, int32_t first_node, int32_t count) {
  const Model& m = system.model;
  const int b = system.body;
  for (int64_t i = 4 * static_cast<int64_t>(first_node); i < 4 * static_cast<int64_t>(first_node + count); ++i)
    system.diagonal[i] = 0.0;
  for (int32_t element = 0; element < m.head->body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    Integrator integrator;
    make_integrator(m, b, element, system.quadrature, Measure::own_length, integrator);
    int32_t node[4];
    for (int l = 0; l < m.head->function_nodes; ++l) node[l] = functional_node(m, b, element, l);
    for (int32_t source = first_node; source < first_node + count; ++source) {
      const int32_t twin = system.twin[source];
      if (twin == kSecondTwin || twin == kAxisNode) continue;
      double sum[2][2];
      const double* at = system.point + 2 * static_cast<int64_t>(source);
      double* block = system.diagonal + 4 * static_cast<int64_t>(source);
      for (int image = 0; image <= m.head->symmetry; ++image) {
        if (!is_image(*m.head, image)) continue;
        const Source p = mirrored_source(*m.head, image, at);
        const int singular = p.on_itself ? singular_node(node, m.head->function_nodes, source, twin) : -1;
        rigid_sum(integrator, p.x, p.y, singular, sum);
        for (int i = 0; i < 4; ++i)
          block[i] -= image_sign(image, i / 2) * image_sign(image, i % 2) * sum[i / 2][i % 2];
      }
    }
  }
}

} // namespace c2d
