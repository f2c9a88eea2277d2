// Interior points of large bodies by a tree of multipole expansions (METHOD 16.7).
//
// Direct evaluation costs points times elements. Far from a group of elements their field is smooth and a short series
// represents it: the tree code of the fast multipole family (Greengard and Rokhlin, J. Comput. Phys. 73, 1987; for elasticity
// in boundary elements see Liu, Fast Multipole Boundary Element Method, 2009).
//
// Phases:
//   1. make_cells. A binary tree along the contour. For every leaf the coefficients f_j, x_j of METHOD (16.11) about its
//   middle;
//      parents by shifting those of their children (binomial series).
//   2. place_block. Nearest boundary point and winding number for a block of points, by a walk down the tree: a cell that
//   cannot
//      contain the nearest point and does not surround the point contributes only the winding of its chord.
//   3. sum_block. Displacements and stresses by the same walk: a cell at a distance of three radii or more contributes its
//      expansion METHOD (16.10), closer ones are opened, leaves are integrated element by element.
//
// A constant displacement subtracted per point (results/interior/interior.cpp) would change the coefficients of every cell for
// every point. Instead a fixed one, the mean over the boundary (`rest`), is built into the coefficients; the difference to the
// point's own value acts on a whole chain of elements through its two end points only.
#include "results/interior/interior_cells.hpp"

#include "bie/integrals/kernels.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/workers.hpp"
#include "results/back.hpp"
#include "results/interior/interior_elements.hpp"
#include "solver/demand/far_cells.hpp"

namespace c2d {

namespace {

FarCells cells_of(const Session& session, int b) { return far_cells_in(session.area.work, session.model.body[b].elements); }

// ---- making --------------------------------------------------------------------------------------------------------------

struct CellJob {
  const Session* session;
  int b;
  FarCells cells;
  int32_t first; // leaf of task 0
};

// Prepares one element with nodal tractions t and displacements u as the source of a field.
void element_field(const Session& session, int b, int32_t element, Measure measure, const Complex* t, const Complex* u,
                   FieldElement& out) {
  make_integrator(session.model, b, element, Quadrature::accurate, measure, out.in);
  prepare_field(t, u, out);
}

// One leaf: its bounding circle and the coefficients of its elements. Contact tractions of side 1 are measured per length of
// side 0 and are added as a second field of the same element.
void make_leaf(void* argument, int32_t task) {
  const CellJob& job = *static_cast<const CellJob*>(argument);
  const Session& session = *job.session;
  const int32_t leaf = job.first + task, n = job.cells.elements, depth = job.cells.depth;
  const int32_t first = leaf_begin(n, depth, leaf), last = leaf_begin(n, depth, leaf + 1);
  FarCell& cell = job.cells.at(depth, leaf);
  bound_leaf(
      session.model, job.b, first, last, [&](int32_t element) { return is_integrated(session.model, job.b, element); }, cell);
  for (int32_t element = first; element < last; ++element) {
    if (!is_integrated(session.model, job.b, element)) continue;
    NodalValues values;
    FieldElement e;
    nodal_values(session, job.b, element, values);
    element_field(session, job.b, element, Measure::own_length, values.own, values.u, e);
    add_to_far_field(e, *job.cells.rest, cell.field);
    if (!values.any_contact) continue;
    element_field(session, job.b, element, Measure::contact, values.contact, nullptr, e);
    add_to_far_field(e, Complex{0.0, 0.0}, cell.field);
  }
}

// Mean nodal displacement: subtracted from the coefficients of all cells, so that a large rigid-body translation does not
// cancel against itself in their sums.
Complex mean_displacement(const Session& session, int b) {
  const int32_t nodes = session.model.body[b].nodes;
  Complex sum = {0.0, 0.0};
  for (int32_t node = 0; node < nodes; ++node) {
    double u[2];
    get_displacement(session, b, node, u);
    add(sum, Complex{u[0], u[1]});
  }
  return (1.0 / (nodes * session.model.head->length_unit)) * sum;
}

struct Material {
  double k, kappa;
};
Material material_of(const Model& m, int b) {
  const double nu = strain_poisson_ratio(m, b);
  return {1.0 / (4.0 * kPi * (1.0 - nu)), 3.0 - 4.0 * nu};
}

// Builds the tree of a body unless it exists already. It is stored in the work memory of back substitution, which is free now.
// The tree serves all later calls at the same load; progress and cancellation are checked between groups of leaves.
c2d_status make_cells(const Session& session, int b) {
  c2d_solver* s = session.solver;
  CellJob job{&session, b, cells_of(session, b), 0};
  const FarCells& cells = job.cells;
  if (far_cells_of(s) == b + 1) return C2D_OK;
  take_back_work(s);
  *cells.rest = mean_displacement(session, b);
  const Workers workers = workers_of(&s->port);
  const int32_t leaves = int32_t{1} << cells.depth, step = 4 * workers.count;
  for (job.first = 0; job.first < leaves; job.first += step) {
    const c2d_status status = pause_at_points(session, b, leaf_begin(cells.elements, cells.depth, job.first));
    if (status != C2D_OK) return status;
    run_tasks(workers, leaves - job.first < step ? leaves - job.first : step, make_leaf, &job);
  }
  // Upward pass, from the leaves to the root.
  const double kappa = material_of(session.model, b).kappa;
  for (int32_t d = cells.depth - 1; d >= 0; --d)
    for (int32_t i = 0; i < int32_t{1} << d; ++i) make_parent(&cells.at(d + 1, 2 * i), kappa, cells.at(d, i));
  if (s->back_substituted != 0) s->back_substituted = 2 + b; // records whose tree is in memory
  return C2D_OK;
}

// ---- walking -------------------------------------------------------------------------------------------------------------

// Common part of both walks.
struct Visit {
  const Session& session;
  int b;
  const Points& block;

  Complex seen(int image, double x, double y) const { return {block.seen(image, 0, x), block.seen(image, 1, y)}; }
  // Is the point, or one of its images, within `radii` cell radii of the middle of the cell?
  bool is_within(const FarCell& cell, double radii, double x, double y) const {
    const int32_t lines = block.lines(b);
    const double reach = radii * cell.field.radius;
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      const Complex w = seen(image, x, y) - cell.field.middle;
      if (dot(w, w) <= reach * reach) return true;
    }
    return false;
  }
  Points chosen(const uint16_t* order, int32_t count) const {
    Points out = block;
    out.count = count;
    out.chosen = order;
    return out;
  }
};

// Walk for the nearest boundary point and the winding number. A cell must be opened if it may contain a nearer boundary point
// than the best so far, or if the point lies in its circle: then the elements may wind around it differently from their chord.
struct PlacingVisit : Visit {
  bool is_near(const FarCell& cell, int32_t row) const {
    const PointSearch& p = block.search(row);
    if (!(cell.field.radius > 0.0)) return false;
    if (cell.chains > 2 || is_within(cell, 1.0 + 1e-9, p.x, p.y)) return true;
    const Complex w = Complex{p.x, p.y} - cell.field.middle;
    const double reach = p.distance + cell.field.radius;
    return dot(w, w) <= reach * reach;
  }
  void meet(const FarCell& cell, int32_t row) const {
    PointSearch& p = block.search(row);
    const int32_t lines = block.lines(b);
    for (int64_t c = 0; c < cell.chains; ++c)
      for (int image = 0; image <= lines; ++image)
        if (is_image(lines, image)) p.windings += chord_winding(cell.chain[c], lines != 0, seen(image, p.x, p.y));
  }
  void meet_elements(int32_t first, int32_t last, const uint16_t* order, int32_t count) const {
    const Points points = chosen(order, count);
    for (int32_t element = first; element < last; ++element)
      if (is_integrated(session.model, b, element)) place_by_element(session, b, element, points);
  }
};

// Walk for displacements and stresses: far cells by their expansion, near leaves by their elements.
struct FieldVisit : Visit {
  Material material;
  Complex rest;

  bool is_near(const FarCell& cell, int32_t row) const {
    const PointSums& p = block.sums(row);
    return cell.chains > 2 || is_within(cell, kFarDistance, p.x, p.y);
  }
  void meet(const FarCell& cell, int32_t row) const {
    if (!(cell.field.radius > 0.0)) return;
    PointSums& p = block.sums(row);
    const int32_t lines = block.lines(b);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      const Complex reference = {image_sign(image, 0) * p.reference[0], image_sign(image, 1) * p.reference[1]};
      const Complex at = seen(image, p.x, p.y);
      PointField sum = {};
      add_far_field(cell.field, material.k, material.kappa, at.re, at.im, sum);
      for (int64_t c = 0; c < cell.chains; ++c)
        add_uniform_chain(cell.chain[c], rest - reference, material.k, material.kappa, at.re, at.im, sum);
      add_displacement(image, sum, p);
      add_stress(image, sum, p);
    }
  }
  void meet_elements(int32_t first, int32_t last, const uint16_t* order, int32_t count) const {
    const Points points = chosen(order, count);
    for (int32_t element = first; element < last; ++element)
      if (is_integrated(session.model, b, element)) integrate_element(session, b, element, points);
  }
};

// Upper bound of the distance to the boundary: descend to the child with the nearer middle, down to a leaf; all its points lie
// within |P - c| + R. Not always the nearest leaf, but any upper bound is valid, and a tight one prunes the walk. Some leaf has
// elements, so at least one of two children is never empty.
void bound_distance(const FarCells& cells, PointSearch& p) {
  const Complex at = {p.x, p.y};
  int32_t i = 0;
  for (int32_t d = 1; d <= cells.depth; ++d) {
    double away[2];
    for (int k = 0; k < 2; ++k) {
      const FarField& field = cells.at(d, 2 * i + k).field;
      away[k] = field.radius > 0.0 ? length_of(at - field.middle) : 1e300;
    }
    i = 2 * i + (away[1] < away[0] ? 1 : 0);
  }
  const FarField& field = cells.at(cells.depth, i).field;
  p.distance = (1.0 + 1e-12) * (length_of(at - field.middle) + field.radius) + kRounding;
}

struct PointJob {
  const Session* session;
  const Points* points;
  int b;
  int32_t first; // point of task 0
  FarCells cells;

  Points block(int32_t task) const { return some_points(*points, first + task * kBlockOfPoints, kBlockOfPoints); }
};

void place_block(void* argument, int32_t task) {
  const PointJob& job = *static_cast<const PointJob*>(argument);
  const Points block = job.block(task);
  uint16_t order[kBlockOfPoints];
  int32_t count = 0;
  for (int32_t i = 0; i < block.count; ++i) {
    if (block.place(i) != kUnplaced) continue;
    bound_distance(job.cells, block.search(i));
    order[count++] = static_cast<uint16_t>(i);
  }
  walk(job.cells, order, count, PlacingVisit{{*job.session, job.b, block}});
}

void sum_block(void* argument, int32_t task) {
  const PointJob& job = *static_cast<const PointJob*>(argument);
  const Points block = job.block(task);
  uint16_t order[kBlockOfPoints];
  int32_t count = 0;
  for (int32_t i = 0; i < block.count; ++i)
    if (is_inside(block.place(i), job.b)) order[count++] = static_cast<uint16_t>(i);
  walk(job.cells, order, count,
       FieldVisit{{*job.session, job.b, block}, material_of(job.session->model, job.b), *job.cells.rest});
}

// Runs a task on all blocks of points, on as many threads as the port offers.
c2d_status run_blocks(PointJob& job, void (*task)(void*, int32_t)) {
  const Session& session = *job.session;
  const Workers workers = workers_of(&session.solver->port);
  const int32_t blocks = (job.points->count + kBlockOfPoints - 1) / kBlockOfPoints;
  for (int32_t block = 0; block < blocks; block += workers.count) {
    const int32_t done = static_cast<int32_t>(static_cast<int64_t>(block) * session.model.body[job.b].elements / blocks);
    const c2d_status status = pause_at_points(session, job.b, done);
    if (status != C2D_OK) return status;
    job.first = block * kBlockOfPoints;
    run_tasks(workers, blocks - block < workers.count ? blocks - block : workers.count, task, &job);
  }
  return C2D_OK;
}

} // namespace

bool has_far_cells(const Session& session, int b) {
  return is_compressed(plan_of(session.solver, b)) && may_have_far_cells(session.model.body[b].elements);
}

c2d_status evaluate_by_cells(const Session& session, int b, const Points& points) {
  begin_placing(points);
  c2d_status status = make_cells(session, b);
  PointJob job{&session, &points, b, 0, cells_of(session, b)};
  if (status == C2D_OK) status = run_blocks(job, place_block);
  if (status != C2D_OK) return status;
  end_placing(session, b, points);
  return run_blocks(job, sum_block);
}

} // namespace c2d
