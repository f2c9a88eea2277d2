// Parts of a body's equations: chosen nodes or points, in chosen columns. Compressed elimination asks for such blocks (METHOD
// 7.6).
//
// The routines of columns.cpp do the work: a copy of the system whose sources are the chosen nodes gives the rows, and a table
// of places gives the columns. So the entries are those of the whole matrix.
// Balances along rigid-body modes that the body's equations leave free are replaced by METHOD (10.13), sum R_i . u_i = 0,
// which makes the system regular.
#include "bie/integrals/chosen.hpp"

#include "bie/panel.hpp"
#include "memory/math.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(HolePart);

ColumnSystem choose_nodes(const ColumnSystem& whole, const int32_t* node, int32_t count, double* point, int32_t* twin) {
  ColumnSystem out = whole;
  out.point = point;
  out.twin = twin;
  out.chosen = node;
  out.sources = count;
  out.some_passed_over = false;
  for (int32_t s = 0; s < count; ++s) {
    for (int i = 0; i < 2; ++i) point[2 * s + i] = whole.point[2 * static_cast<int64_t>(node[s]) + i];
    twin[s] = whole.twin[node[s]];
    out.some_passed_over = out.some_passed_over || twin[s] < kSingle;
  }
  return out;
}

// Points off the boundary have no node, no twin and no image.
ColumnSystem choose_points(const ColumnSystem& whole, double* point, int32_t count, int32_t* node, int32_t* twin) {
  ColumnSystem out = whole;
  out.point = point;
  out.twin = twin;
  out.chosen = node;
  out.sources = count;
  out.some_passed_over = false;
  out.alone = true;
  for (int32_t s = 0; s < count; ++s) node[s] = kNoNode, twin[s] = kSingle;
  return out;
}

namespace {

// All columns except the right-hand sides.
Range all_unknowns(const ColumnSystem& system) {
  const int32_t end = outer_columns(system.model, system.body) + 2 * system.model.body[system.body].contact;
  return Range{0, end, end};
}

Panel panel_of(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld) {
  return Panel{system.model, system.body, all_unknowns(system), out, ld, columns.place};
}

void clear_rows(int32_t rows, int32_t columns, Real* out, int64_t ld) {
  for (int32_t j = 0; j < columns; ++j)
    for (int32_t i = 0; i < rows; ++i) out[j * ld + i] = 0;
}

// visit(element, targets, measure) for every element of the columns and each measure of its tractions.
template <class Visit>
void visit_elements(const ColumnSystem& system, const Range& range, const ChosenColumns& columns, Visit visit) {
  ElementTargets& targets = system.scratch->targets;
  for (int32_t k = 0; k < columns.element_count; ++k) {
    const int32_t element = columns.elements[k];
    aim(system.model, system.body, element, range, targets);
    if (targets.want_h || targets.want_g) visit(element, targets, Measure::own_length);
    if (targets.want_contact) visit(element, targets, Measure::contact);
  }
}

void add_elements(const ColumnSystem& system, const Range& range, const ChosenColumns& columns, const Panel& panel) {
  clear_rows(2 * system.sources, columns.count, panel.data, panel.ld);
  visit_elements(system, range, columns, [&](int32_t element, const ElementTargets& targets, Measure measure) {
    add_element(system, nullptr, panel, element, targets, measure);
  });
}

// Rows whose displacement symmetry fixes: u = 0.
void fix_rows(const ColumnSystem& system, const ChosenColumns& columns, const Panel& panel) {
  const Model& m = system.model;
  for (int32_t s = 0; s < system.sources; ++s)
    for (int c = 0; c < 2; ++c) {
      const int32_t node = system.chosen[s];
      if (!is_held_by_symmetry(m, system.body, node, c)) continue;
      for (int32_t j = 0; j < columns.count; ++j) panel.data[j * panel.ld + 2 * s + c] = 0;
      panel.add(2 * s + c, outer_column(m, system.body, node, c), 1.0);
    }
}

} // namespace

void fill_tractions(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld) {
  const Panel panel = panel_of(system, columns, out, ld);
  Range tractions = all_unknowns(system);
  tractions.first = tractions.last - system.model.body[system.body].contact;
  add_elements(system, tractions, columns, panel);
  if (system.model.body[system.body].lines != 0) fix_rows(system, columns, panel);
}

void fill_chosen(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld) {
  const Panel panel = panel_of(system, columns, out, ld);
  add_elements(system, all_unknowns(system), columns, panel);
  if (system.alone) return; // points off the boundary have no diagonal
  for (int32_t s = 0; s < system.sources; ++s) add_node(system, panel, s);
  if (system.model.body[system.body].lines != 0) fix_rows(system, columns, panel);
}

void fill_balances(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld) {
  const Panel panel = panel_of(system, columns, out, ld);
  clear_rows(3, columns.count, out, ld);
  visit_elements(system, all_unknowns(system), columns, [&](int32_t element, const ElementTargets& targets, Measure measure) {
    if (measure == Measure::contact || targets.want_g) add_balance(system, panel, element, targets, measure, 0);
  });
  const int32_t lines = system.model.body[system.body].lines;
  // Balances that symmetry satisfies by itself: rho or omega is zero instead.
  for (int c = 0; c < 3 && lines != 0; ++c) {
    if (c < 2 && (lines >> c & 1) == 0) continue;
    for (int32_t j = 0; j < columns.count; ++j) out[j * ld + c] = 0;
    panel.add(c, system.model.body[system.body].columns + c, 1.0);
  }
}

namespace {

// Row k: displacements of a node times the free rigid-body mode k.
void add_node_modes(const ColumnSystem& system, const ChosenColumns& columns, int32_t node, double weight, Real* out,
                    int64_t ld) {
  const Model& m = system.model;
  const Body& body = m.body[system.body];
  const double unit = m.head->length_unit;
  double x, y;
  node_position(m, system.body, node, &x, &y);
  Unknown unknown[2];
  unknowns_at(m, system.body, node, unknown);
  for (int c = 0; c < 2; ++c) {
    if (unknown[c].kind != UnknownKind::displacement) continue;
    const int32_t place = columns.place[outer_column(m, system.body, node, c)];
    const double arm = c == 0 ? -(y - body.centre[1]) / unit : (x - body.centre[0]) / unit;
    for (int32_t k = 0; k < motions_held(m, system.body) && place >= 0; ++k)
      out[place * ld + k] = static_cast<Real>(weight * (body.free_motion[k][c] + body.free_motion[k][2] * arm));
  }
}

// Three orthonormal rows, the free rigid-body modes first: Gram-Schmidt with a second pass, which restores orthogonality to
// rounding.
void complete_modes(const Body& body, double rows[3][3]) {
  int count = body.free_motions;
  for (int k = 0; k < count; ++k)
    for (int c = 0; c < 3; ++c) rows[k][c] = body.free_motion[k][c];
  for (int next = 0; next < 3 && count < 3; ++next) {
    double row[3] = {0.0, 0.0, 0.0}, size = 0.0;
    row[next] = 1.0;
    for (int pass = 0; pass < 2; ++pass)
      for (int k = 0; k < count; ++k) {
        double part = 0.0;
        for (int c = 0; c < 3; ++c) part += rows[k][c] * row[c];
        for (int c = 0; c < 3; ++c) row[c] -= part * rows[k][c];
      }
    for (double value : row) size += value * value;
    if (size < 0.1) continue; // at least one unit vector has more than this outside one or two rows
    for (int c = 0; c < 3; ++c) rows[count][c] = row[c] / sqrt(size);
    ++count;
  }
}

} // namespace

void rotate_balances(const Model& m, int b, Real* sums) {
  const int32_t modes = motions_held(m, b);
  if (modes == 0) return;
  double rows[3][3];
  complete_modes(m.body[b], rows);
  // The balances in the basis of these modes: those along free modes vanish, those orthogonal to them remain.
  const double before[3] = {static_cast<double>(sums[0]), static_cast<double>(sums[1]), static_cast<double>(sums[2])};
  for (int k = 0; k < 3; ++k) {
    double sum = 0.0;
    for (int c = 0; c < 3; ++c) sum += rows[k][c] * before[c];
    sums[k] = k < modes ? Real(0) : static_cast<Real>(sum);
  }
}

void fill_sums(const ColumnSystem& system, const ChosenColumns& columns, double weight, Real* out, int64_t ld) {
  const Model& m = system.model;
  fill_balances(system, columns, out, ld);
  if (motions_held(m, system.body) == 0) return;
  for (int32_t j = 0; j < columns.count; ++j) rotate_balances(m, system.body, out + j * ld);
  for (int32_t k = 0; k < columns.element_count; ++k)
    for (int l = 0; l < m.head->function_nodes; ++l)
      add_node_modes(system, columns, functional_node(m, system.body, columns.elements[k], l), weight, out, ld);
}

void fill_hole_row(const ColumnSystem& system, const Hole& hole, const ChosenColumns& columns, Real* out, int64_t ld) {
  const Panel panel = panel_of(system, columns, out, ld);
  const Model& m = system.model;
  AssemblyScratch& scratch = *system.scratch;
  clear_rows(1, columns.count, out, ld);
  visit_elements(system, all_unknowns(system), columns, [&](int32_t element, const ElementTargets& t, Measure measure) {
    const bool contact = measure == Measure::contact;
    make_integrator(m, system.body, element, system.quadrature, measure, scratch.integrator);
    kHolePart.hole_row(m, system.body, hole, scratch.integrator, !contact, true, scratch.hole_field, scratch.hole_row);
    for (int l = 0; l < m.head->function_nodes; ++l)
      for (int c = 0; c < 2; ++c) {
        if (!contact) panel.send_h(t.h[l][c], t.node[l], c, 0, scratch.hole_row.h[l][c]);
        if (t.g[l][c].contact == contact) panel.send_g(t.g[l][c], element, l, c, 0, scratch.hole_row.g[l][c]);
      }
  });
}

} // namespace c2d
