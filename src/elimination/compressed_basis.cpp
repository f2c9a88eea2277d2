// Which equations and unknowns stand for a cell: those of which the others are combinations in all that the cell has to do with
// the rest of the body. Of the rest, what is within a circle round the cell is looked at as it is. What lies outside acts on
// the cell like forces on the circle, and feels of it what the circle feels.

#include "bie/integrals/kernels.hpp"
#include "elimination/compressed_work.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

struct Circle {
  double x, y, radius;
};

Circle circle_of(const Compression& t, int32_t cell) {
  const double* c = t.w.circle + 3 * static_cast<int64_t>(cell);
  return Circle{c[0], c[1], c[2]};
}

const double* point_of(const Compression& t, int32_t node) { return t.system.point + 2 * static_cast<int64_t>(node); }

// From the centre of a circle to a point. Images of the point are no nearer, as both lie on the body's side of the line.
double distance(const Circle& circle, const double p[2]) { return hypot(p[0] - circle.x, p[1] - circle.y); }

double proxy_radius(const Circle& circle) { return kProxyRadius * circle.radius; }

bool is_near(const Compression& t, const Circle& circle, int32_t node, double reach) {
  return distance(circle, point_of(t, node)) < proxy_radius(circle) + reach;
}

struct Range {
  int32_t first, last;
};
Range rows_of(const Compression& t, const Depth& d, int32_t cell) {
  const int32_t* begin = t.w.row_begin[d.which];
  return Range{begin[cell], begin[cell + 1]};
}
Range columns_of(const Compression& t, const Depth& d, int32_t cell) {
  const int32_t* begin = t.w.column_begin[d.which];
  return Range{begin[cell], begin[cell + 1]};
}

// visit(other) for the cells that may reach into a cell's circle.
template <class Visit> void visit_near_cells(const Compression& t, const Depth& d, int32_t cell, Visit visit) {
  const Circle own = circle_of(t, cell);
  for (int32_t other = 0; other < d.cells; ++other) {
    if (other == cell) continue;
    const Circle c = circle_of(t, other);
    const double at[2] = {c.x, c.y};
    if (distance(own, at) < proxy_radius(own) + c.radius) visit(other);
  }
}

// visit(column, node) for the unknowns near a cell: those of other cells, and all that the border has there.
template <class Visit> void visit_near_columns(const Compression& t, const Depth& d, int32_t cell, Visit visit) {
  const Circle own = circle_of(t, cell);
  visit_near_cells(t, d, cell, [&](int32_t other) {
    const Range range = columns_of(t, d, other);
    for (int32_t j = range.first; j < range.last; ++j) {
      const int32_t id = t.w.columns[d.which][j];
      if (is_near(t, own, id / 2, t.w.reach[id / 2])) visit(column_of(t, id), id / 2);
    }
  });
  for (int32_t i = 0; i < t.plan.nodes - t.plan.tree; ++i) {
    const int32_t node = t.w.border[i];
    if (!is_near(t, own, node, t.w.reach[node])) continue;
    visit_columns(t.plan, t.system.model, t.system.body, node, [&](int32_t j) { visit(j, node); });
  }
}

// visit(row id) for the equations near a cell.
template <class Visit> void visit_near_rows(const Compression& t, const Depth& d, int32_t cell, Visit visit) {
  const Circle own = circle_of(t, cell);
  visit_near_cells(t, d, cell, [&](int32_t other) {
    const Range range = rows_of(t, d, other);
    for (int32_t i = range.first; i < range.last; ++i) {
      const int32_t id = t.w.rows[d.which][i];
      if (is_near(t, own, id / 2, 0.0)) visit(id);
    }
  });
  for (int32_t i = 0; i < t.plan.nodes - t.plan.tree; ++i)
    for (int c = 0; c < 2; ++c)
      if (is_near(t, own, t.w.border[i], 0.0)) visit(2 * t.w.border[i] + c);
}

// Points on the circle round a cell; how many, none where the cell is a point.
int32_t place_proxies(const Compression& t, const Circle& circle, double* point) {
  if (!(circle.radius > 0.0)) return 0;
  const double radius = proxy_radius(circle);
  for (int32_t k = 0; k < kProxies; ++k) {
    const double angle = 2.0 * kPi * (k + 0.5) / kProxies;
    point[2 * k] = circle.x + radius * cos(angle);
    point[2 * k + 1] = circle.y + radius * sin(angle);
  }
  static_cast<void>(t);
  return kProxies;
}

// ---- equations --------------------------------------------------------------------------------------------------------

// What columns do to the rows of a cell, chunk by chunk.
struct ColumnSamples {
  Compression& t;
  const ColumnSystem& chosen; // the cell's nodes as sources
  const int32_t* rows;        // of the cell
  int32_t count;
  SampleSum& sum;
  int32_t* columns; // of a chunk
  int32_t* nodes;
  int32_t held;

  void flush() {
    CompressedWork& w = t.w;
    const int64_t ld = 2 * static_cast<int64_t>(chosen.sources);
    for (int32_t j = 0; j < held; ++j) w.place[columns[j]] = j;
    const int32_t elements = list_elements(t, nodes, held, w.elements);
    fill_chosen(chosen, ChosenColumns{w.place, held, w.elements, elements}, w.block, ld);
    for (int32_t j = 0; j < held; ++j) {
      w.place[columns[j]] = -1;
      for (int32_t i = 0; i < count; ++i) w.sample[i] = w.block[j * ld + 2 * w.position[rows[i] / 2] + rows[i] % 2];
      add_sample(sum, w.sample, 1, true);
    }
    held = 0;
  }
  void take(int32_t column, int32_t node) {
    columns[held] = column;
    nodes[held++] = node;
    if (held == kChunk) flush();
  }
};

// Forces on the circle.
void add_proxy_forces(Compression& t, const int32_t* rows, int32_t count, const double* point, int32_t proxies,
                      SampleSum& sum) {
  const double nu = strain_poisson_ratio(t.system.model, t.system.body), kappa = 3.0 - 4.0 * nu;
  Real* sample[2] = {t.w.sample, t.w.sample + count};
  for (int32_t k = 0; k < proxies; ++k) {
    for (int32_t i = 0; i < count; ++i) {
      const double *p = point_of(t, rows[i] / 2), rx = point[2 * k] - p[0], ry = point[2 * k + 1] - p[1];
      double u[2][2];
      store(displacement_kernel(rx, ry, rx * rx + ry * ry, kappa), has_integrals(t, rows[i] / 2, rows[i] % 2) ? 1.0 : 0.0, u);
      for (int j = 0; j < 2; ++j) sample[j][i] = static_cast<Real>(u[rows[i] % 2][j]);
    }
    for (int j = 0; j < 2; ++j) add_sample(sum, sample[j], 1, true);
  }
}

// rho and omega.
void add_motions(Compression& t, const int32_t* rows, int32_t count, SampleSum& sum) {
  const Model& m = t.system.model;
  const Body& body = m.body[t.system.body];
  for (int motion = 0; motion < 3; ++motion) {
    for (int32_t i = 0; i < count; ++i) {
      const int c = rows[i] % 2;
      const double *p = point_of(t, rows[i] / 2), x = p[0] - body.centre[0] / m.head->length_unit,
                   y = p[1] - body.centre[1] / m.head->length_unit;
      const double value = motion < 2 ? (c == motion ? 1.0 : 0.0) : (c == 0 ? y : -x);
      t.w.sample[i] = has_integrals(t, rows[i] / 2, c) ? static_cast<Real>(value) : Real(0);
    }
    add_sample(sum, t.w.sample, 1, true);
  }
}

// The normals of holes whose nodes are in the cell.
void add_hole_normals(Compression& t, const int32_t* rows, int32_t count, SampleSum& sum) {
  for (int32_t hole = 0; hole < t.plan.holes; ++hole) {
    bool some = false;
    for (int32_t i = 0; i < count; ++i) {
      const int32_t node = rows[i] / 2;
      t.w.sample[i] = 0;
      if (t.w.hole_at[node] != hole || !has_integrals(t, node, rows[i] % 2)) continue;
      double n[2];
      hole_normal(t.system.model, t.system.body, node, n);
      t.w.sample[i] = static_cast<Real>(n[rows[i] % 2]);
      some = true;
    }
    if (some) add_sample(sum, t.w.sample, 1, true);
  }
}

} // namespace

int32_t choose_rows(Compression& t, const Depth& d, int32_t cell) {
  CompressedWork& w = t.w;
  const Range range = rows_of(t, d, cell);
  const int32_t *rows = w.rows[d.which] + range.first, count = range.last - range.first;
  int64_t samples = 2 * kProxies + 3 + t.plan.holes;
  visit_near_columns(t, d, cell, [&](int32_t, int32_t) { ++samples; });
  SampleSum sum = begin_samples(w.samples, count, samples, t.engine.kernel);
  double* proxies = w.point + 2 * static_cast<int64_t>(t.plan.nodes);
  add_proxy_forces(t, rows, count, proxies, place_proxies(t, circle_of(t, cell), proxies), sum);
  add_motions(t, rows, count, sum);
  add_hole_normals(t, rows, count, sum);
  const int32_t sources = list_sources(t, rows, count, w.sources);
  const ColumnSystem chosen = choose_nodes(t.system, w.sources, sources, w.point, w.twin);
  ColumnSamples near{t, chosen, rows, count, sum, w.pivots, w.list, 0};
  visit_near_columns(t, d, cell, [&](int32_t column, int32_t node) { near.take(column, node); });
  if (near.held > 0) near.flush();
  forget_sources(t, w.sources, sources);
  return interpolate(sum, kCompressedTolerance, false, t.plan.rank, w.row_order, w.norms, w.row_x);
}

// ---- unknowns -----------------------------------------------------------------------------------------------------------

namespace {

// What the unknowns of a cell do elsewhere; `columns` are placed, their elements listed.
struct RowSamples {
  Compression& t;
  const ChosenColumns& columns;
  SampleSum& sum;
  int32_t* rows; // of a chunk
  int32_t held;

  void flush() {
    CompressedWork& w = t.w;
    const int32_t sources = list_sources(t, rows, held, w.sources);
    const int64_t ld = 2 * static_cast<int64_t>(sources);
    fill_chosen(choose_nodes(t.system, w.sources, sources, w.point, w.twin), columns, w.block, ld);
    for (int32_t i = 0; i < held; ++i) add_sample(sum, w.block + 2 * w.position[rows[i] / 2] + rows[i] % 2, ld, false);
    forget_sources(t, w.sources, sources);
    held = 0;
  }
  void take(int32_t row) {
    rows[held++] = row;
    if (held == kChunk) flush();
  }
};

void add_proxy_fields(Compression& t, const ChosenColumns& columns, const Circle& circle, SampleSum& sum) {
  CompressedWork& w = t.w;
  const int32_t proxies = place_proxies(t, circle, w.point);
  if (proxies == 0) return;
  const int64_t ld = 2 * static_cast<int64_t>(proxies);
  fill_chosen(choose_points(t.system, w.point, proxies, w.sources, w.twin), columns, w.block, ld);
  for (int32_t i = 0; i < 2 * proxies; ++i) add_sample(sum, w.block + i, ld, false);
}

// The balances or motions, and the holes whose place inside is near.
void add_sums(Compression& t, const ChosenColumns& columns, const Circle& circle, SampleSum& sum) {
  Real* out = t.w.block;
  fill_sums(t.system, columns, 1.0, out, 3);
  for (int i = 0; i < 3; ++i) add_sample(sum, out + i, 3, false);
  for (int32_t k = 0; k < t.plan.holes; ++k) {
    const Hole& hole = t.w.hole[k];
    bool near = false;
    for (int32_t p = 0; p < hole.points; ++p) near = near || distance(circle, hole.at[p]) < proxy_radius(circle);
    if (!near) continue;
    fill_hole_row(t.system, hole, columns, out, 1);
    add_sample(sum, out, 1, true);
  }
}

} // namespace

int32_t choose_columns(Compression& t, const Depth& d, int32_t cell) {
  CompressedWork& w = t.w;
  const Range range = columns_of(t, d, cell);
  const int32_t *ids = w.columns[d.which] + range.first, count = range.last - range.first;
  for (int32_t j = 0; j < count; ++j) {
    w.place[column_of(t, ids[j])] = j;
    w.list[j] = ids[j] / 2;
  }
  const ChosenColumns columns{w.place, count, w.elements, list_elements(t, w.list, count, w.elements)};
  int64_t samples = 2 * kProxies + 3 + t.plan.holes;
  visit_near_rows(t, d, cell, [&](int32_t) { ++samples; });
  SampleSum sum = begin_samples(w.samples, count, samples, t.engine.kernel);
  add_proxy_fields(t, columns, circle_of(t, cell), sum);
  add_sums(t, columns, circle_of(t, cell), sum);
  RowSamples near{t, columns, sum, w.pivots, 0};
  visit_near_rows(t, d, cell, [&](int32_t row) { near.take(row); });
  if (near.held > 0) near.flush();
  for (int32_t j = 0; j < count; ++j) w.place[column_of(t, ids[j])] = -1;
  return interpolate(sum, kCompressedTolerance, true, t.plan.rank, w.column_order, w.norms, w.column_x);
}

void place_circles(Compression& t, const Depth& d) {
  CompressedWork& w = t.w;
  for (int32_t cell = 0; cell < d.cells; ++cell) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    const Range ranges[2] = {rows_of(t, d, cell), columns_of(t, d, cell)};
    const int32_t* lists[2] = {w.rows[d.which], w.columns[d.which]};
    for (int kind = 0; kind < 2; ++kind)
      for (int32_t k = ranges[kind].first; k < ranges[kind].last; ++k)
        for (int i = 0; i < 2; ++i) {
          const double x = point_of(t, lists[kind][k] / 2)[i];
          low[i] = x < low[i] ? x : low[i];
          high[i] = x > high[i] ? x : high[i];
        }
    double* circle = w.circle + 3 * static_cast<int64_t>(cell);
    circle[2] = 0.0;
    for (int i = 0; i < 2; ++i) circle[i] = 0.5 * (low[i] + high[i]);
    for (int kind = 0; kind < 2; ++kind)
      for (int32_t k = ranges[kind].first; k < ranges[kind].last; ++k) {
        const int32_t node = lists[kind][k] / 2;
        const double *p = point_of(t, node), reach = kind == 1 ? w.reach[node] : 0.0;
        const double r = hypot(p[0] - circle[0], p[1] - circle[1]) + reach;
        if (r > circle[2]) circle[2] = r;
      }
  }
}

} // namespace c2d
