// Assembly of a body's equations, column by column (METHOD 2, equations METHOD (2.5) and (2.6)):
//   H u - G t - rho - omega e_z x (x - x_0) = 0 at every functional node, sum of forces = 0, sum of moments = 0.
// The elimination asks for a range of columns.
// Phases:
// 1. For each element with an unknown or a prescribed value in the range: work out where its integrals go (targets.cpp),
//    integrate it for all sources (sources.cpp), add its share of the balances.
// 2. Point loads and body forces, into the right-hand sides.
// 3. Holes: the same integrals in the additional term of METHOD (4.1).
// 4. Nodes: free term and principal value (the diagonal), twins, rho and omega.
// 5. Free zones (transfer.cpp), and at last the rows that symmetry replaces by u = 0.
// Columns and not rows, because an element's integrals belong to a few columns: each panel of the elimination integrates only
// the elements that it needs.
// Literature: Brebbia and Dominguez, Boundary Elements: An Introductory Course; Rizzo, Quart. Appl. Math. 25 (1967).
#include "bie/columns.hpp"

#include "bie/body_force.hpp"
#include "bie/panel.hpp"
#include "bie/transfer.hpp"
#include "memory/hostile.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(BodyForcePart);
C2D_USES(HolePart);

namespace {

constexpr int32_t kManyCases = 16;

// Prescribed values of one element in one load case. They multiply the same integrals as unknowns do.
void aim_right_hand_side(const Panel& panel, int32_t element, const ElementTargets& t, int32_t load_case, bool want_h,
                         bool want_g, bool contact, const Blocks& blocks, Deposits& out) {
  const Model& m = panel.m;
  Real* column = panel.column(panel.range.right + load_case);
  for (int l = 0; l < m.head->function_nodes; ++l)
    for (int c = 0; c < 2; ++c) {
      if (want_h && t.h[l][c].known && given_displacement(m, panel.b, t.node[l], c, load_case) != 0.0)
        out.add(&blocks.h[l][0][c], column, known_displacement(m, panel.b, t.node[l], c, load_case));
      if (want_g && t.g[l][c].known && t.g[l][c].contact == contact &&
          given_traction(m, panel.b, element * m.head->function_nodes + l, c, load_case) != 0.0)
        out.add(&blocks.g[l][0][c], column, known_traction(m, panel.b, element, l, c, load_case));
    }
}

// Are values prescribed here that go to the right-hand sides of the panel?
bool has_values(const ElementTargets& t, int function_nodes) {
  bool known = false;
  for (int l = 0; l < function_nodes; ++l)
    for (int c = 0; c < 2; ++c) known = known || t.h[l][c].known || t.g[l][c].known;
  return known;
}

} // namespace

void add_element(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t element, const ElementTargets& t,
                 Measure measure) {
  if (!kSmallCode && system.rest && !hole) return;
  const Model& m = system.model;
  const int nf = m.head->function_nodes;
  const bool contact = measure == Measure::contact;
  // Displacements go with the element's own length. Tractions of the contact are measured per length of the other side, so
  // they have integrals of their own.
  const bool want_h = t.want_h && !contact, want_g = contact ? t.want_contact : t.want_g;
  make_integrator(m, system.body, element, system.quadrature, measure, system.scratch->integrator);
  const Blocks& blocks = system.scratch->blocks;
  Deposits& deposits = system.scratch->deposits;
  deposits.count = 0;
  for (int l = 0; l < nf; ++l)
    for (int c = 0; c < 2; ++c) {
      if (want_h) add_deposits(panel, t.h[l][c], &blocks.h[l][0][c], deposits);
      if (want_g && t.g[l][c].contact == contact) add_deposits(panel, t.g[l][c], &blocks.g[l][0][c], deposits);
    }
  // The first load case shares the pass over the sources with the unknowns. Of further ones each has a pass of its own; where
  // there are many, as many share one as the list of deposits has room for. (Few have the digits that they always had.)
  const int32_t first = panel.range.first_case(), cases = kSmallCode || has_values(t, nf) ? panel.range.end_case() : 0;
  const bool many = !kSmallCode && m.head->load_cases > kManyCases, shared = t.shared;
  for (int32_t next = 0; next == 0 || next < cases; deposits.count = 0) {
    if (next < cases) aim_right_hand_side(panel, element, t, next, want_h, want_g, contact, blocks, deposits);
    const bool alone = next++ == 0 || !many;
    if (next < first) next = first;
    for (; !alone && next < cases && deposits.count <= kMostDeposits - 4 * nf; ++next)
      aim_right_hand_side(panel, element, t, next, want_h, want_g, contact, blocks, deposits);
    if (deposits.count == 0) continue;
    system.scratch->targets.shared = shared || !alone; // a component goes to the columns of several cases
    scatter_sources(system, hole, t.node, want_h, want_g);
    system.scratch->targets.shared = shared;
  }
}

// Resultants of the shape functions: their integrals are exact, so forces and moments balance to rounding in METHOD (2.6).
void add_balance(const ColumnSystem& system, const Panel& panel, int32_t element, const ElementTargets& t, Measure measure,
                 int32_t row) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.body[b];
  Integrator& integrator = system.scratch->integrator;
  make_integrator(m, b, element, system.quadrature, measure, integrator);
  double w[kElementNodes], wx[kElementNodes], wy[kElementNodes];
  resultants(integrator, body.centre[0] / m.head->length_unit, body.centre[1] / m.head->length_unit, w, wx, wy);
  for (int l = 0; l < m.head->function_nodes; ++l)
    for (int c = 0; c < 2; ++c) {
      if (t.g[l][c].contact != (measure == Measure::contact)) continue;
      panel.send_g(t.g[l][c], element, l, c, row + c, balance_scale(m) * w[l]);
      panel.send_g(t.g[l][c], element, l, c, row + 2, c == 0 ? -wy[l] : wx[l]);
    }
}

void add_node(const ColumnSystem& system, const Panel& panel, int32_t source) {
  const Model& m = system.model;
  const int b = system.body;
  const Body& body = m.body[b];
  const int32_t node = node_of_source(system, source), row = 2 * source;
  if (system.twin[source] == kAxisNode) return;
  const bool second = system.twin[source] == kSecondTwin;
  if (!second && !concerns(m, b, node, panel.range)) return;
  const int32_t twin = second ? twin_node(m, b, node) : kSingle;
  Unknown unknown[2];
  unknowns_at(m, b, node, unknown);
  for (int c = 0; c < 2; ++c) {
    const Destination d = displacement_destination(m, b, node, c, unknown[c]);
    // The second of two nodes at one place: its equations are u_first = u_second, METHOD 2.5.
    if (second) {
      const Destination other = displacement_destination(m, b, twin, c, unknown_at(m, b, twin, c));
      panel.send_h(d, node, c, row + c, 1.0);
      panel.send_h(other, twin, c, row + c, -1.0);
    } else {
      const double* block = system.diagonal + 4 * static_cast<int64_t>(node);
      for (int i = 0; i < 2; ++i) panel.send_h(d, node, c, row + i, block[2 * i + c]);
    }
  }
  if (second) return;
  const double* at = system.point + 2 * static_cast<int64_t>(source);
  // rho and omega e_z x (x - x_0) in this node's two equations.
  panel.add(row, body.columns, -1.0);
  panel.add(row + 1, body.columns + 1, -1.0);
  panel.add(row, body.columns + 2, at[1] - body.centre[1] / m.head->length_unit);
  panel.add(row + 1, body.columns + 2, -(at[0] - body.centre[0] / m.head->length_unit));
}

namespace {

// Everything that is integrated or acts at points. With a hole: its additional term instead.
void add_all(const ColumnSystem& system, const Hole* hole, const Panel& panel) {
  const Model& m = system.model;
  const int b = system.body;
  const int32_t balance = 2 * m.body[b].nodes;
  for (int32_t element = 0; element < m.body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    ElementTargets& targets = system.scratch->targets;
    aim(m, b, element, panel.range, targets);
    if (targets.want_h || targets.want_g) add_element(system, hole, panel, element, targets, Measure::own_length);
    if (targets.want_g && !hole) add_balance(system, panel, element, targets, Measure::own_length, balance);
    if (!targets.want_contact) continue;
    add_element(system, hole, panel, element, targets, Measure::contact);
    if (!hole) add_balance(system, panel, element, targets, Measure::contact, balance);
  }
  for (int32_t i = 0; i < m.head->point_loads && panel.range.has_right(); ++i)
    if (m.point_load[i].body == b && panel.column(panel.range.right + m.point_load[i].load_case))
      add_point_load(system, hole, panel, m.point_load[i]);
  for (int32_t k = panel.range.first_case(); k < panel.range.end_case() && has_body_force(m, b); ++k)
    kBodyForcePart.add_body_force_columns(system, hole, panel, k);
}

// Replaces a row by the equation "the unknown of column j is zero".
void set_zero_row(const Panel& panel, int32_t row, int32_t j) {
  for (int32_t k = panel.range.first; k < panel.range.last; ++k) *(panel.column(k) + row) = 0;
  panel.add(row, j, 1.0);
}

// Rows that symmetry leaves empty, or whose displacement it fixes, become u = 0. Of the balances only those remain that a
// symmetric state can violate: the force along a single line (METHOD 5).
[[gnu::noinline]] void fix_by_symmetry(const ColumnSystem& system, const Panel& panel) {
  const Model& m = system.model;
  const Body& body = m.body[system.body];
  for (int32_t node = 0; node < body.nodes; ++node)
    for (int c = 0; c < 2; ++c)
      if (is_held_by_symmetry(m, system.body, node, c))
        set_zero_row(panel, 2 * node + c, outer_column(m, system.body, node, c));
  for (int c = 0; c < 3; ++c)
    if (c == 2 || (body.lines >> c & 1) != 0) set_zero_row(panel, 2 * body.nodes + c, body.columns + c);
}

// Everything but free zones. (Not inlined: the call chain below is deep.)
[[gnu::noinline]] void fill_own_columns(const ColumnSystem& system, const Panel& panel) {
  const Model& m = system.model;
  const int b = system.body;
  const int32_t rows = system_rows(m, b);
  C2D_ASSERT(rows <= panel.ld && panel.range.first >= 0);
  for (int32_t j = panel.range.first; j < panel.range.last; ++j)
    for (int32_t i = 0; i < rows; ++i) panel.column(j)[i] = 0;
  add_all(system, nullptr, panel);
  HoleWalk walk{};
  Hole hole;
  while (kHolePart.next_hole(m, b, walk, hole)) add_all(system, &hole, panel);
  for (int32_t node = 0; node < m.body[b].nodes; ++node) add_node(system, panel, node);
}

} // namespace

void fill_columns(const ColumnSystem& system, int32_t first, int32_t count, Real* data, int64_t ld) {
  const Model& m = system.model;
  const Body& body = m.body[system.body];
  const Range range{first, first + count, outer_columns(m, system.body) + 2 * body.contact};
  const Panel panel{m, system.body, range, data, ld};
  fill_own_columns(system, panel);
  if (body.free_rows > 0) kFreeZonePart.fill_transfer(system, first, count, data, ld);
  if (body.lines != 0) fix_by_symmetry(system, panel);
}

} // namespace c2d
