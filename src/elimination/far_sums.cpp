// Sums of all elements at all nodes of a large body, in n log n time (METHOD 7.6): right-hand sides and diagonal blocks.
//
// Phases, for each load case or for the diagonal:
// 1. Leaves: prescribed tractions and displacements of their elements as multipole series, METHOD (16.10); for the diagonal
//    the ends of the chains, METHOD (2.4).
// 2. Parents, upwards: series are translated and added.
// 3. Nodes, in blocks of kBlockOfPoints: each walks down from the root. Where a cluster is farther than kFarDistance of its
//    radii, its series is evaluated and its branch ends. At near leaves the elements are integrated one by one.
// So a node meets O(log n) clusters and a constant number of elements: a tree code in the sense of Barnes and Hut, Nature 324
// (1986), with the expansions of Greengard and Rokhlin, J. Comput. Phys. 73 (1987). With symmetry, a cluster acts on the
// images of a node instead of the images of the cluster acting on the node, METHOD (5.1).
#include "elimination/far_sums.hpp"

#include "bie/body_force.hpp"
#include "bie/integrals/chosen.hpp"
#include "bie/integrals/kernels.hpp"
#include "bie/panel.hpp"
#include "memory/sizes.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

// Nodes of a block that are near the same elements, and what these elements contribute there: [2 sources] for each load case,
// or the [4 sources] of a diagonal.
struct NearArea {
  double* point;
  int32_t *node, *twin;
  Real* right;
  double* diagonal;
};

uint64_t lay_out_sums(int32_t elements, int32_t loads, char* base, char** cells, NearArea* out) {
  NearArea near{};
  char* room = nullptr;
  AreaCarver area{base};
  constexpr uint64_t n = kBlockOfPoints;
  area.take(near.point, 2 * n);
  area.take(near.node, n);
  area.take(near.twin, n);
  area.take(near.right, 2 * n * static_cast<uint64_t>(loads));
  area.take(near.diagonal, 4 * n);
  area.take(room, far_cells_bytes(elements));
  if (cells) *cells = room;
  if (out) *out = near;
  return area.total();
}

// A body's nodes, the clusters of its elements, and the work area for near elements.
struct NodeWalk {
  const ColumnSystem& system;
  FarCells cells;
  NearArea near;
  double k, kappa;
};

NodeWalk walk_in(const ColumnSystem& system, void* work) {
  const Model& m = system.model;
  const int32_t elements = m.body[system.body].elements;
  const double nu = strain_poisson_ratio(m, system.body);
  char* cells = nullptr;
  NodeWalk w{system, {}, {}, 1.0 / (4.0 * kPi * (1.0 - nu)), 3.0 - 4.0 * nu};
  lay_out_sums(elements, m.head->load_cases, static_cast<char*>(work), &cells, &w.near);
  w.cells = far_cells_in(cells, elements);
  return w;
}

// leaf(first, last, cell) for all leaves, then the clusters above them.
template <class Leaf> void make_cells(const NodeWalk& w, Leaf leaf) {
  const FarCells& cells = w.cells;
  for (int32_t i = 0; i < int32_t{1} << cells.depth; ++i)
    leaf(leaf_begin(cells.elements, cells.depth, i), leaf_begin(cells.elements, cells.depth, i + 1), cells.at(cells.depth, i));
  for (int32_t d = cells.depth - 1; d >= 0; --d)
    for (int32_t i = 0; i < int32_t{1} << d; ++i) make_parent(&cells.at(d + 1, 2 * i), w.kappa, cells.at(d, i));
}

// Common to both kinds of visitors: nodes from `first` on.
struct NodeVisit {
  const NodeWalk& w;
  int32_t first;

  const double* at(uint16_t row) const { return w.system.point + 2 * (static_cast<int64_t>(first) + row); }
  // visit(image, place) for a node and its mirror images, as an element of the body sees them.
  template <class Visit> void for_images(uint16_t row, Visit visit) const {
    const int32_t lines = images_of(w.system);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      const Source p = mirrored_source(*w.system.model.head, image, at(row));
      visit(image, Complex{p.x, p.y});
    }
  }
  bool is_near(const FarCell& cell, uint16_t row) const {
    const double reach = kFarDistance * cell.field.radius;
    bool near = false;
    for_images(row, [&](int, Complex p) {
      const Complex away = p - cell.field.middle;
      near = near || dot(away, away) <= reach * reach;
    });
    return near && reach > 0.0;
  }
  // The system of these nodes alone.
  ColumnSystem chosen(const uint16_t* order, int32_t count) const {
    for (int32_t i = 0; i < count; ++i) w.near.node[i] = first + order[i];
    return choose_nodes(w.system, w.near.node, count, w.near.point, w.near.twin);
  }
};

// visitor(first) for blocks of nodes with equations of their own. A block stays in the cache while it passes through the tree.
template <class Visitor> void walk_nodes(const NodeWalk& w, Visitor visitor) {
  const int32_t nodes = w.system.model.body[w.system.body].nodes;
  uint16_t order[kBlockOfPoints];
  for (int32_t first = 0; first < nodes; first += kBlockOfPoints) {
    int32_t count = 0;
    for (int32_t i = 0; i < kBlockOfPoints && first + i < nodes; ++i)
      if (w.system.twin[first + i] >= kSingle) order[count++] = static_cast<uint16_t>(i);
    if (count > 0) walk(w.cells, order, count, visitor(first));
  }
}

// ---- right-hand sides -----------------------------------------------------------------------------------------------------

// All right-hand sides, and the load case of the present walk. Near elements act for all load cases in the first walk, because
// their integrals are the same.
struct Sides {
  Range range;
  int32_t load;
  Real* right;
  int64_t ld;
};

bool has_force(const ColumnSystem& system, int32_t load) {
  const Model& m = system.model;
  return has_body_force(m, system.body) && is_loaded(body_force(m, system.body, load));
}

// Is anything prescribed on the element in any load case? A particular solution counts as prescribed. Fills the targets.
bool is_prescribed(const ColumnSystem& system, const Range& range, int32_t element) {
  if (!is_integrated(system.model, system.body, element)) return false;
  ElementTargets& t = system.scratch->targets;
  aim(system.model, system.body, element, range, t);
  return t.want_h || t.want_g || has_body_force(system.model, system.body);
}

// The equations are those of u - u_p and t - t_p, METHOD (6.1).
void take_particular_off(const ColumnSystem& system, int32_t element, int l, int32_t load, double t[2], double u[2]) {
  const Model& m = system.model;
  const int b = system.body;
  double x, y, tp[2];
  node_position(m, b, functional_node(m, b, element, l), &x, &y);
  const Particular p = particular_solution(m, b, load, x, y);
  particular_traction(m, b, load, element, l, tp);
  for (int c = 0; c < 2; ++c) {
    t[c] -= tp[c] / (2.0 * shear_modulus(m, b));
    u[c] -= p.u[c] / m.head->length_unit;
  }
}

// Adds the prescribed values of one element in one load case to a series. is_prescribed() has been called for it.
void add_prescribed(const ColumnSystem& system, int32_t element, int32_t load, FarField& out) {
  const Model& m = system.model;
  const ElementTargets& at = system.scratch->targets;
  const bool forced = has_force(system, load);
  Complex traction[kElementNodes], displacement[kElementNodes];
  bool some = false;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    double t[2], u[2];
    for (int c = 0; c < 2; ++c) {
      t[c] = at.g[l][c].known ? known_traction(m, system.body, element, l, c, load) : 0.0;
      u[c] = at.h[l][c].known ? -known_displacement(m, system.body, at.node[l], c, load) : 0.0;
    }
    if (forced) take_particular_off(system, element, l, load, t, u);
    for (int c = 0; c < 2; ++c) some = some || t[c] != 0.0 || u[c] != 0.0;
    traction[l] = Complex{t[0], t[1]}, displacement[l] = Complex{u[0], u[1]};
  }
  if (!some) return;
  FieldElement& e = system.scratch->hole_field;
  make_integrator(m, system.body, element, Quadrature::accurate, Measure::own_length, e.in);
  prepare_field(traction, at.want_h || forced ? displacement : nullptr, e);
  add_to_far_field(e, Complex{0.0, 0.0}, out);
}

struct RightVisit : NodeVisit {
  const Sides& sides;

  void add(int32_t node, int c, int32_t load, double value) const {
    if (!is_held_by_symmetry(w.system.model, w.system.body, node, c))
      sides.right[load * sides.ld + 2 * static_cast<int64_t>(node) + c] += static_cast<Real>(value);
  }
  void meet(const FarCell& cell, uint16_t row) const {
    if (!(cell.field.radius > 0.0)) return;
    for_images(row, [&](int image, Complex p) {
      const Complex u = far_displacement(cell.field, w.k, w.kappa, p.re, p.im);
      add(first + row, 0, sides.load, image_sign(image, 0) * u.re);
      add(first + row, 1, sides.load, image_sign(image, 1) * u.im);
    });
  }
  void meet_elements(int32_t from, int32_t to, const uint16_t* order, int32_t count) const {
    // Near elements contributed to all load cases in the first walk.
    if (sides.load > 0) return;
    const ColumnSystem system = chosen(order, count);
    const int32_t rows = 2 * count, loads = system.model.head->load_cases;
    const Panel panel{system.model, system.body, sides.range, w.near.right, rows};
    for (int32_t i = 0; i < rows * loads; ++i) w.near.right[i] = 0;
    for (int32_t element = from; element < to; ++element) {
      if (!is_prescribed(system, sides.range, element)) continue;
      add_element(system, nullptr, panel, element, system.scratch->targets, Measure::own_length);
      for (int32_t load = 0; load < loads; ++load)
        if (has_force(system, load)) add_particular(system, nullptr, panel, element, load);
    }
    for (int32_t load = 0; load < loads; ++load)
      for (int32_t i = 0; i < rows; ++i)
        add(w.near.node[i / 2], i % 2, load, static_cast<double>(w.near.right[load * rows + i]));
  }
};

} // namespace

uint64_t far_sums_bytes(int32_t elements, int32_t loads) {
  return may_have_far_cells(elements) ? lay_out_sums(elements, loads, nullptr, nullptr, nullptr) : 0;
}

void fill_right_by_cells(const ColumnSystem& system, Real* right, int64_t ld, void* work) {
  const Model& m = system.model;
  const int b = system.body;
  const int32_t begin = outer_columns(m, b) + 2 * m.body[b].contact, loads = m.head->load_cases;
  // First everything that is not a sum over elements: free terms of particular solutions, point loads.
  ColumnSystem rest = system;
  rest.rest = true;
  fill_columns(rest, begin, loads, right, ld);
  const NodeWalk w = walk_in(system, work);
  Sides sides{{begin, begin + loads, begin}, 0, right, ld};
  // The series depend on the prescribed values, so the tree is built once for each load case.
  for (; sides.load < loads; ++sides.load) {
    const auto counts = [&](int32_t element) { return is_prescribed(system, sides.range, element); };
    make_cells(w, [&](int32_t first, int32_t last, FarCell& cell) {
      bound_leaf(m, b, first, last, counts, cell);
      for (int32_t element = first; element < last; ++element)
        if (counts(element)) add_prescribed(system, element, sides.load, cell.field);
    });
    walk_nodes(w, [&](int32_t first) { return RightVisit{{w, first}, sides}; });
  }
}

// ---- diagonal -------------------------------------------------------------------------------------------------------------

namespace {

struct DiagonalVisit : NodeVisit {
  double* diagonal(int32_t node) const { return w.system.diagonal + 4 * static_cast<int64_t>(node); }
  bool is_near(const FarCell& cell, uint16_t row) const { return cell.chains > 2 || NodeVisit::is_near(cell, row); }
  void meet(const FarCell& cell, uint16_t row) const {
    double* const block = diagonal(first + row);
    for_images(row, [&](int image, Complex p) {
      // A unit translation in x and one in y: the two columns of the diagonal block.
      for (int64_t i = 0; i < cell.chains; ++i)
        for (int c = 0; c < 2; ++c) {
          PointField sum = {};
          add_uniform_chain(cell.chain[i], Complex{c == 0 ? 1.0 : 0.0, c == 0 ? 0.0 : 1.0}, w.k, w.kappa, p.re, p.im, sum);
          block[c] += image_sign(image, 0) * image_sign(image, c) * sum.u.re;
          block[2 + c] += image_sign(image, 1) * image_sign(image, c) * sum.u.im;
        }
    });
  }
  void meet_elements(int32_t from, int32_t to, const uint16_t* order, int32_t count) const {
    ColumnSystem system = chosen(order, count);
    system.diagonal = w.near.diagonal;
    for (int32_t i = 0; i < 4 * count; ++i) w.near.diagonal[i] = 0.0;
    for (int32_t element = from; element < to; ++element)
      if (is_integrated(system.model, system.body, element)) take_rigid_sums(system, element, 0, count);
    for (int32_t i = 0; i < 4 * count; ++i) diagonal(w.near.node[i / 4])[i % 4] += w.near.diagonal[i];
  }
};

} // namespace

void fill_diagonal_by_cells(const ColumnSystem& system, void* work) {
  const Model& m = system.model;
  const int b = system.body;
  for (int64_t i = 0; i < 4 * static_cast<int64_t>(m.body[b].nodes); ++i) system.diagonal[i] = 0.0;
  const NodeWalk w = walk_in(system, work);
  const auto counts = [&](int32_t element) { return is_integrated(m, b, element); };
  make_cells(w, [&](int32_t first, int32_t last, FarCell& cell) { bound_leaf(m, b, first, last, counts, cell); });
  walk_nodes(w, [&](int32_t first) { return DiagonalVisit{{w, first}}; });
}

} // namespace c2d
