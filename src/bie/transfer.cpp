// Free zones seen from side 0: displacements at the points that pairs face, and integrals of tau over pieces of elements
// (METHOD 9.2, equation METHOD (9.2)).
//   u_c = sum_l N_l(eta) u_l,   int U t ds = -sum over pieces of int U(x_1) M_j J_2 deta_2 tau_j.
// Phases:
// 1. Constraints: one equation per contact unknown of side 0, below the balances. It removes no column.
// 2. Pieces: the facing parts between consecutive nodes of both sides. On each, tau is a polynomial and both geometries are
//    smooth, so the usual integrals apply. J_2 is the measure of both sides, so the forces balance to rounding.
// 3. Each piece, for all sources and images, and in the balances and the equations of holes.
// Integration over the intersections of both meshes is what mortar methods do (for example Wohlmuth, Discretization Methods
// and Iterative Solvers Based on Domain Decomposition, Springer 2001). In this file side 0 has the suffix 1 and side 1 the
// suffix 2, as in METHOD.
#include "bie/transfer.hpp"

#include "bie/panel.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/pair_frame.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(HolePart);

namespace {

// The part of an element between two local coordinates, in the length unit. Ends at nodes get exactly their coordinates: a
// source there is recognised by equality.
Element part_of(const Model& m, int b, int32_t element, double from, double to, const int32_t node[2]) {
  const double unit = m.head->length_unit;
  double x[kElementNodes], y[kElementNodes], px[kElementNodes], py[kElementNodes];
  element_coordinates(m, b, element, x, y);
  const int nodes = m.body[b].element_nodes;
  for (int k = 0; k < nodes; ++k) x[k] /= unit, y[k] /= unit;
  const Element whole = make_element(nodes, x, y);
  for (int k = 0; k < nodes; ++k) {
    const double eta = k == nodes - 1 ? to : from + (to - from) * k / (nodes - 1);
    const Point p = element_point(whole, eta);
    px[k] = eta == -1.0 ? x[0] : (eta == 1.0 ? x[nodes - 1] : p.x);
    py[k] = eta == -1.0 ? y[0] : (eta == 1.0 ? y[nodes - 1] : p.y);
    const int end = k == 0 ? 0 : (k == nodes - 1 ? 1 : -1);
    if (end < 0 || node[end] < 0) continue;
    node_position(m, b, node[end], &px[k], &py[k]);
    px[k] /= unit, py[k] /= unit;
  }
  return make_element(nodes, px, py);
}

int32_t functions_of_piece(const Model& m) { return m.head->function_nodes < 2 ? 2 : m.head->function_nodes; }

} // namespace

void make_transfer(const Model& m, Quadrature quadrature, const TransferWalk& walk, Transfer& out) {
  const FacingPiece& piece = walk.piece;
  const int32_t(&body)[2] = m.zone[walk.zone].body;
  const int nf = m.head->function_nodes, functions = functions_of_piece(m);
  const int first = piece.eta1[0] < piece.eta1[1] ? 0 : 1; // in side 0's direction of travel, opposite to side 1's
  const double from = piece.eta1[first], to = piece.eta1[1 - first];
  const double high = piece.eta2[first], low = piece.eta2[1 - first];
  const int32_t none[2] = {-1, -1};
  out.element1 = piece.element1;
  out.node[0] = node_at(m, body[0], FacePoint{piece.element1, 0, from});
  out.node[1] = node_at(m, body[0], FacePoint{piece.element1, 0, to});
  const double nu = strain_poisson_ratio(m, body[0]);
  prepare(out.in, part_of(m, body[0], piece.element1, from, to, out.node), functions, nu, quadrature);
  if (is_axisymmetric(m)) set_axis(out.in, m.head->length_unit);
  set_arc(out.in, part_of(m, body[1], walk.pieces.element2, low, high, none), true);
  for (int l = 0; l < kElementNodes; ++l) out.pair[l] = l < nf ? pair_of_end(m, body[1], walk.pieces.element2, l).pair : -1;
  for (int l = 0; l < nf; ++l) C2D_ASSERT(out.pair[l] >= 0); // all nodes of side 1 are pairs
  for (int k = 0; k < functions; ++k) shape(nf, high + (low - high) * k / (functions - 1), out.weight[k]);
}

namespace {

// Does the element of side 1 contribute to one of the columns that are assembled? Pieces are searched only if it does.
bool is_wanted(const Model& m, const Zone& z, const TransferWalk& walk) {
  if (walk.to == 0) return true;
  const int32_t element = zone_element(m, z, 1, walk.place);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const int32_t i = pair_of_end(m, z.body[1], element, l).pair;
    if (i < 0) continue;
    const int32_t first = dof_on(m, m.pair[i], 0);
    if (first + m.pair[i].tangential >= walk.from && first < walk.to) return true;
  }
  return false;
}

} // namespace

bool next_transfer(const Model& m, TransferWalk& walk) {
  for (; walk.zone < m.head->zones; ++walk.zone, walk.place = 0) {
    const Zone& z = m.zone[walk.zone];
    if (z.is_free == 0 || z.body[0] != walk.body) continue;
    for (; walk.place < z.elements; ++walk.place) {
      if (!walk.inside && !is_wanted(m, z, walk)) continue;
      if (!walk.inside) walk.pieces = start_pieces(m, z, walk.place);
      walk.inside = next_piece(walk.pieces, walk.piece);
      if (walk.inside) return true;
    }
  }
  return false;
}

namespace {

struct Columns { // the panel of a body
  int b;
  int32_t first, count;
  Real* data;
  int64_t ld;
  void add(int32_t row, int32_t j, double value) const {
    if (j >= first && j < first + count) data[(j - first) * ld + row] += static_cast<Real>(value);
  }
};

// Adds weight * u of a node's component to one of the rows below the balances: to its column, or to the right-hand sides if it
// is prescribed.
void add_displacement(const Model& m, const Columns& panel, int32_t row, int32_t node, int component, double weight) {
  const int b = panel.b;
  const Unknown unknown = unknown_at(m, b, node, component);
  const int32_t outer = outer_columns(m, b);
  if (unknown.kind == UnknownKind::displacement) {
    panel.add(row, outer_column(m, b, node, component), weight);
  } else if (unknown.kind == UnknownKind::contact) { // of an ordinary zone beside this one
    const PairSide at = pair_of_node(m, b, node);
    const Pair& pair = m.pair[at.pair];
    const int32_t column = outer + dof_on(m, pair, at.side);
    for (int d = 0; d <= pair.tangential; ++d) panel.add(row, column + d, weight * along(pair, d, component));
  } else {
    for (int32_t k = 0; k < m.head->load_cases; ++k) {
      const double value = -weight * given_displacement(m, b, node, component, k) / m.head->length_unit;
      panel.add(row, outer + 2 * m.body[b].contact + k, value);
    }
  }
}

// Adds part * u of side 0 at a pair, interpolated by one element, to the pair's row for direction d.
void add_faced_displacement(const Model& m, const Columns& panel, const Pair& pair, int d, int32_t element, double part) {
  const int nf = m.head->function_nodes;
  const int32_t row = 2 * m.body[panel.b].nodes + 3 + pair.row + d;
  double value[kElementNodes];
  shape(nf, pair.eta, value);
  for (int l = 0; l < nf; ++l)
    for (int c = 0; c < 2; ++c) {
      const double weight = part * value[l] * along(pair, d, c);
      if (weight != 0.0) add_displacement(m, panel, row, functional_node(m, panel.b, element, l), c, weight);
    }
}

// Constant functions jump between elements: a point there moves with the mean of both, so it does not matter to which element
// it is assigned.
[[gnu::noinline]] void add_constraints(const Model& m, const Columns& panel) {
  const int32_t below = 2 * m.body[panel.b].nodes + 3, outer = outer_columns(m, panel.b);
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    const Pair& pair = m.pair[i];
    if (pair.node[0] >= 0 || body_on(m, pair, 0) != panel.b) continue;
    const int32_t beside = m.head->function_nodes == 1 ? element_beside_pair(m, pair) : -1;
    for (int d = 0; d <= pair.tangential; ++d) {
      add_faced_displacement(m, panel, pair, d, pair.element, beside < 0 ? 1.0 : 0.5);
      if (beside >= 0) add_faced_displacement(m, panel, pair, d, beside, 0.5);
      panel.add(below + pair.row + d, outer + dof_on(m, pair, 0) + d, -1.0);
    }
  }
}

// Distributes integrals of the functions of a piece to the columns of tau at the ends of the element of side 1. The columns do
// not depend on the row, so they are found once for a piece.
struct Receiver {
  const Columns& panel;
  int functions, ends;
  const double (*weight)[kElementNodes];
  struct End {
    int32_t column;
    int dofs;
    double factor[2][2]; // of slot, of component
  } end[kElementNodes];

  Receiver(const Model& m, const Columns& to, const Transfer& t)
      : panel(to), functions(t.in.functions), ends(m.head->function_nodes), weight(t.weight) {
    const double scale = m.head->stress_unit / (2.0 * shear_modulus(m, to.b));
    for (int l = 0; l < ends; ++l) {
      const Pair& pair = m.pair[t.pair[l]];
      end[l].column = outer_columns(m, to.b) + m.body[to.b].contact + dof_on(m, pair, 0);
      end[l].dofs = 1 + pair.tangential;
      for (int d = 0; d < end[l].dofs; ++d)
        for (int c = 0; c < 2; ++c) end[l].factor[d][c] = scale * along(pair, d, c);
    }
  }
  void send(const double value[kElementNodes], int32_t row, int component) const {
    for (int l = 0; l < ends; ++l) {
      double sum = 0.0;
      for (int k = 0; k < functions; ++k) sum += weight[k][l] * value[k];
      for (int d = 0; d < end[l].dofs; ++d) panel.add(row, end[l].column + d, end[l].factor[d][component] * sum);
    }
  }
};

// A piece in the equations at the nodes of a hole. (Not inlined, like the others: the search for the next piece would
// otherwise run on top of their frames.)
[[gnu::noinline]] void add_to_hole(const ColumnSystem& system, const Hole& hole, const Columns& panel, const Transfer& t) {
  const Receiver to(system.model, panel, t);
  HoleRow& row = system.scratch->hole_row;
  kHolePart.hole_row(system.model, panel.b, hole, t.in, false, true, system.scratch->hole_field, row);
  visit_hole(system, hole, [&](int32_t node, const double n[2]) {
    for (int i = 0; i < 2; ++i)
      for (int c = 0; c < 2; ++c) {
        double value[kElementNodes];
        for (int k = 0; k < t.in.functions; ++k) value[k] = n[i] * row.g[k][c];
        to.send(value, 2 * node + i, c);
      }
  });
}

[[gnu::noinline]] void add_piece(const ColumnSystem& system, const Columns& panel, const Transfer& t) {
  const Model& m = system.model;
  const Receiver to(m, panel, t);
  Blocks& blocks = system.scratch->blocks;
  const Body& body = m.body[panel.b];
  Samples samples;
  for (int32_t source = 0; source < body.nodes; ++source) {
    if (system.twin[source] == kSecondTwin || system.twin[source] == kAxisNode) continue;
    const int32_t images = image_lines(m, panel.b);
    for (int image = 0; image <= images; ++image) {
      if (!is_image(images, image)) continue;
      const Source p = mirrored_source(*m.head, image, system.point + 2 * static_cast<int64_t>(source));
      // The source is singular if it is the node at one end of the piece.
      const int at = !p.on_itself ? -1 : (t.node[0] == source ? 0 : (t.node[1] == source ? t.in.functions - 1 : -1));
      integrate(t.in, p.x, p.y, at, false, true, blocks, &samples);
      for (int i = 0; i < 2; ++i)
        for (int c = 0; c < 2; ++c) {
          double value[kElementNodes];
          for (int k = 0; k < t.in.functions; ++k) value[k] = image_sign(image, i) * blocks.g[k][i][c];
          to.send(value, 2 * source + i, c);
        }
    }
  }
  // The balances, METHOD (2.6): those that symmetry satisfies have no row.
  const int32_t row = 2 * body.nodes, lines = body.lines;
  double w[kElementNodes], wx[kElementNodes], wy[kElementNodes];
  resultants(t.in, body.centre[0] / m.head->length_unit, body.centre[1] / m.head->length_unit, w, wx, wy);
  for (double& force : w) force *= balance_scale(m);
  for (int c = 0; c < 2; ++c)
    if ((lines >> c & 1) == 0) to.send(w, row + c, c);
  if (lines != 0) return;
  for (double& moment : wy) moment = -moment;
  to.send(wy, row + 2, 0);
  to.send(wx, row + 2, 1);
}

// All pieces, in the equations at the nodes of a hole or in all others. (Equations that symmetry replaces are cleared later.)
[[gnu::noinline]] void add_pieces(const ColumnSystem& system, const Hole* hole, const Columns& panel) {
  const int32_t before = outer_columns(system.model, panel.b) + system.model.body[panel.b].contact;
  TransferWalk walk{};
  walk.body = system.body;
  walk.from = panel.first - before;
  walk.to = panel.first + panel.count - before;
  Transfer& transfer = system.scratch->transfer;
  while (next_transfer(system.model, walk)) {
    make_transfer(system.model, system.quadrature, walk, transfer);
    if (hole)
      add_to_hole(system, *hole, panel, transfer);
    else
      add_piece(system, panel, transfer);
  }
}

} // namespace

void fill_transfer(const ColumnSystem& system, int32_t first, int32_t count, Real* data, int64_t ld) {
  const Model& m = system.model;
  const int b = system.body;
  const Columns panel{b, first, count, data, ld};
  add_constraints(m, panel);
  // Only the columns of tau have integrals over pieces.
  const int32_t from = outer_columns(m, b) + m.body[b].contact;
  if (first + count <= from || first >= from + m.body[b].contact) return;
  add_pieces(system, nullptr, panel);
  HoleWalk holes{};
  Hole hole;
  while (kHolePart.next_hole(m, b, holes, hole)) add_pieces(system, &hole, panel);
}

namespace {

[[gnu::noinline]] Point point_of(const Model& m, int b, const FacePoint& at) {
  return element_point(element_of(m, b, at.element), at.eta);
}

// The traction at the end `at` as a combination of tau where it faces side 1. (Not inlined: the search for `faced` is deep.)
[[gnu::noinline]] void weigh_end(const Model& m, const Zone& z, const FacePoint& at, const FacePoint& faced,
                                 TransferredEnd& out) {
  const int nf = m.head->function_nodes;
  double n[2];
  facing_direction(m, z, at, faced, n);
  const Point p = point_of(m, z.body[0], at), q = point_of(m, z.body[1], faced);
  // Both points advance by the same amount across n, the direction of the line that joins them. This gives the ratio of
  // lengths.
  const double advance1 = p.nx * n[0] + p.ny * n[1], advance2 = -(q.nx * n[0] + q.ny * n[1]);
  out.ratio = advance2 > 0.0 ? advance1 / advance2 : 1.0;
  shape(nf, faced.eta, out.weight);
  for (int k = 0; k < kElementNodes; ++k) out.pair[k] = k < nf ? pair_of_end(m, z.body[1], faced.element, k).pair : -1;
  for (int k = 0; k < nf; ++k) C2D_ASSERT(out.pair[k] >= 0); // as above
}

} // namespace

bool transferred_end(const Model& m, int b, int32_t element, int l, TransferredEnd& out) {
  const int nf = m.head->function_nodes;
  ZonePlace place;
  if (!find_contact_element(m, b, element, &place) || place.side != 0 || m.zone[place.zone].is_free == 0) return false;
  if ((m.end_code[b][element * nf + l] & kFacesNothing) != 0) return false;
  const Zone& z = m.zone[place.zone];
  const FacePoint at{element, place.place, node_eta(nf, l)};
  FacePoint faced;
  if (!facing_point_by_pairs(m, z, at, faced)) return false;
  weigh_end(m, z, at, faced, out);
  return true;
}

} // namespace c2d
