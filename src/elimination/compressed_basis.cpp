// Skeletons of a cluster: the rows S and columns C that represent it to the rest of the body (METHOD 7.6).
//
// Phases, for the rows and likewise for the columns of a cluster:
// 1. Samples: the interaction of the cluster with everything inside a circle of kProxyRadius times its own radius, entry by
//    entry.
// 2. Proxies: kProxies points on that circle replace everything outside. Sources outside act on the cluster like forces on the
//    circle, and the cluster acts on them as it acts on the circle.
// 3. Global terms: rigid-body modes, balances, holes. They reach every cluster, near or far.
// 4. Interpolative decomposition of the samples (linalg/interpolate.hpp): it chooses S and X, or C and Z, of METHOD (7.3):
//   A(R, outside) = X^T A(S, outside),   A(outside, cluster) = A(outside, C) Z.
// The proxies make the cost of a cluster independent of the size of the body. They are exact to rounding because a field of
// elastostatics outside a circle is determined by its values on the circle, and its modes decay like 2^-m.
// Not adaptive cross approximation (Bebendorf, Hierarchical Matrices, Springer 2008): on straight sides part of T vanishes
// exactly, and a search for crosses would stop early.
// Literature: Martinsson and Rokhlin, J. Comput. Phys. 205 (2005); Cheng, Gimbutas, Martinsson and Rokhlin, SIAM J. Sci.
// Comput. 26 (2005), interpolative decomposition.

#include "bie/integrals/kernels.hpp"
#include "elimination/compressed_work.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

struct Circle {
  double x, y, radius;
};

Circle circle_of(const Compression& t, int32_t cluster) {
  const double* c = t.w.circle + 3 * static_cast<int64_t>(cluster);
  return Circle{c[0], c[1], c[2]};
}

const double* point_of(const Compression& t, int32_t node) { return t.system.point + 2 * static_cast<int64_t>(node); }

// Distance from the centre of a circle. An image of the point is never nearer, because point and circle lie on the body's side
// of the line of symmetry.
double distance(const Circle& circle, const double p[2]) { return hypot(p[0] - circle.x, p[1] - circle.y); }

double proxy_radius(const Circle& circle) { return kProxyRadius * circle.radius; }

// A node is near if its elements reach into the circle. Its interaction is then sampled exactly and needs no proxy.
bool is_near(const Compression& t, const Circle& circle, int32_t node, double reach) {
  return distance(circle, point_of(t, node)) < proxy_radius(circle) + reach;
}

struct Range {
  int32_t first, last;
};
Range rows_of(const Compression& t, const Depth& d, int32_t cluster) {
  const int32_t* begin = t.w.row_begin[d.which];
  return Range{begin[cluster], begin[cluster + 1]};
}
Range columns_of(const Compression& t, const Depth& d, int32_t cluster) {
  const int32_t* begin = t.w.column_begin[d.which];
  return Range{begin[cluster], begin[cluster + 1]};
}

// visit(other) for the clusters that may reach into the circle. Whole clusters are excluded first, since most of them are far.
template <class Visit> void visit_near_clusters(const Compression& t, const Depth& d, int32_t cluster, Visit visit) {
  const Circle own = circle_of(t, cluster);
  for (int32_t other = 0; other < d.clusters; ++other) {
    if (other == cluster) continue;
    const Circle c = circle_of(t, other);
    const double at[2] = {c.x, c.y};
    if (distance(own, at) < proxy_radius(own) + c.radius) visit(other);
  }
}

// visit(column, node) for the unknowns near a cluster: those of other clusters, and all columns of the border there.
template <class Visit> void visit_near_columns(const Compression& t, const Depth& d, int32_t cluster, Visit visit) {
  const Circle own = circle_of(t, cluster);
  visit_near_clusters(t, d, cluster, [&](int32_t other) {
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

// visit(row id) for the equations near a cluster. An equation belongs to a point, so it has no extent of its own.
template <class Visit> void visit_near_rows(const Compression& t, const Depth& d, int32_t cluster, Visit visit) {
  const Circle own = circle_of(t, cluster);
  visit_near_clusters(t, d, cluster, [&](int32_t other) {
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

// Points on the circle round a cluster; returns how many. A cluster that is a single point has no circle.
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

// Samples of the rows: the entries that near columns have in the cluster's equations. Columns come in chunks, because
// assembling an element for all of its columns at once costs as much as for one.
struct ColumnSamples {
  Compression& t;
  const ColumnSystem& chosen; // the cluster's nodes as sources
  const int32_t* rows;        // of the cluster
  int32_t count;
  SampleSum& sum;
  int32_t* columns; // of a chunk
  int32_t* nodes;
  int32_t filled;

  void flush() {
    CompressedWork& w = t.w;
    const int64_t ld = 2 * static_cast<int64_t>(chosen.sources);
    for (int32_t j = 0; j < filled; ++j) w.place[columns[j]] = j;
    const int32_t elements = list_elements(t, nodes, filled, w.elements);
    fill_chosen(chosen, ChosenColumns{w.place, filled, w.elements, elements}, w.block, ld);
    for (int32_t j = 0; j < filled; ++j) {
      w.place[columns[j]] = -1;
      for (int32_t i = 0; i < count; ++i) w.sample[i] = w.block[j * ld + 2 * w.position[rows[i] / 2] + rows[i] % 2];
      add_sample(sum, w.sample, 1, true);
    }
    filled = 0;
  }
  void take(int32_t column, int32_t node) {
    columns[filled] = column;
    nodes[filled++] = node;
    if (filled == kChunk) flush();
  }
};

// Samples of the rows: unit forces at the proxies, by the kernel U. A row that symmetry replaces by u = 0 feels nothing.
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

// Samples of the rows: the columns of rho and omega, which are not zero in any equation, METHOD (2.5).
void add_rigid_modes(Compression& t, const int32_t* rows, int32_t count, SampleSum& sum) {
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

// Samples of the rows: the column of tr V of each hole that has nodes in the cluster, METHOD (4.1).
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

int32_t choose_rows(Compression& t, const Depth& d, int32_t cluster) {
  CompressedWork& w = t.w;
  const Range range = rows_of(t, d, cluster);
  const int32_t *rows = w.rows[d.which] + range.first, count = range.last - range.first;
  int64_t samples = 2 * kProxies + 3 + t.plan.holes;
  visit_near_columns(t, d, cluster, [&](int32_t, int32_t) { ++samples; });
  SampleSum sum = begin_samples(w.samples, count, samples, t.engine.kernel);
  double* proxies = w.point + 2 * static_cast<int64_t>(t.plan.nodes);
  add_proxy_forces(t, rows, count, proxies, place_proxies(t, circle_of(t, cluster), proxies), sum);
  add_rigid_modes(t, rows, count, sum);
  add_hole_normals(t, rows, count, sum);
  const int32_t sources = list_sources(t, rows, count, w.sources);
  const ColumnSystem chosen = choose_nodes(t.system, w.sources, sources, w.point, w.twin);
  ColumnSamples near{t, chosen, rows, count, sum, w.pivots, w.list, 0};
  visit_near_columns(t, d, cluster, [&](int32_t column, int32_t node) { near.take(column, node); });
  if (near.filled > 0) near.flush();
  clear_sources(t, w.sources, sources);
  // Tolerance relative to the largest row: equations are equally scaled, since each contains the free term 1/2.
  return interpolate(sum, kCompressedTolerance, false, t.plan.rank, w.row_order, w.norms, w.row_x);
}

// ---- unknowns -----------------------------------------------------------------------------------------------------------

namespace {

// Samples of the columns: what the cluster's unknowns contribute to near equations. `columns` are placed and their elements
// listed already, for they are the same for all chunks.
struct RowSamples {
  Compression& t;
  const ChosenColumns& columns;
  SampleSum& sum;
  int32_t* rows; // of a chunk
  int32_t filled;

  void flush() {
    CompressedWork& w = t.w;
    const int32_t sources = list_sources(t, rows, filled, w.sources);
    const int64_t ld = 2 * static_cast<int64_t>(sources);
    fill_chosen(choose_nodes(t.system, w.sources, sources, w.point, w.twin), columns, w.block, ld);
    for (int32_t i = 0; i < filled; ++i) add_sample(sum, w.block + 2 * w.position[rows[i] / 2] + rows[i] % 2, ld, false);
    clear_sources(t, w.sources, sources);
    filled = 0;
  }
  void take(int32_t row) {
    rows[filled++] = row;
    if (filled == kChunk) flush();
  }
};

// Samples of the columns: displacement that the cluster's elements cause at the proxies.
void add_proxy_fields(Compression& t, const ChosenColumns& columns, const Circle& circle, SampleSum& sum) {
  CompressedWork& w = t.w;
  const int32_t proxies = place_proxies(t, circle, w.point);
  if (proxies == 0) return;
  const int64_t ld = 2 * static_cast<int64_t>(proxies);
  fill_chosen(choose_points(t.system, w.point, proxies, w.sources, w.twin), columns, w.block, ld);
  for (int32_t i = 0; i < 2 * proxies; ++i) add_sample(sum, w.block + i, ld, false);
}

// Samples of the columns: the balances, or the sums that replace them for rigid-body modes, and the rows of near holes.
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

int32_t choose_columns(Compression& t, const Depth& d, int32_t cluster) {
  CompressedWork& w = t.w;
  const Range range = columns_of(t, d, cluster);
  const int32_t *ids = w.columns[d.which] + range.first, count = range.last - range.first;
  for (int32_t j = 0; j < count; ++j) {
    w.place[column_of(t, ids[j])] = j;
    w.list[j] = ids[j] / 2;
  }
  const ChosenColumns columns{w.place, count, w.elements, list_elements(t, w.list, count, w.elements)};
  int64_t samples = 2 * kProxies + 3 + t.plan.holes;
  visit_near_rows(t, d, cluster, [&](int32_t) { ++samples; });
  SampleSum sum = begin_samples(w.samples, count, samples, t.engine.kernel);
  add_proxy_fields(t, columns, circle_of(t, cluster), sum);
  add_sums(t, columns, circle_of(t, cluster), sum);
  RowSamples near{t, columns, sum, w.pivots, 0};
  visit_near_rows(t, d, cluster, [&](int32_t row) { near.take(row); });
  if (near.filled > 0) near.flush();
  for (int32_t j = 0; j < count; ++j) w.place[column_of(t, ids[j])] = -1;
  // Tolerance relative to each column: displacements and tractions differ by powers of the element length.
  return interpolate(sum, kCompressedTolerance, true, t.plan.rank, w.column_order, w.norms, w.column_x);
}

// Circle round each cluster: centre of the bounding box, radius to its farthest node. For unknowns the extent of their
// elements is added; an equation is a point.
void place_circles(Compression& t, const Depth& d) {
  CompressedWork& w = t.w;
  for (int32_t cluster = 0; cluster < d.clusters; ++cluster) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    const Range ranges[2] = {rows_of(t, d, cluster), columns_of(t, d, cluster)};
    const int32_t* lists[2] = {w.rows[d.which], w.columns[d.which]};
    for (int kind = 0; kind < 2; ++kind)
      for (int32_t k = ranges[kind].first; k < ranges[kind].last; ++k)
        for (int i = 0; i < 2; ++i) {
          const double x = point_of(t, lists[kind][k] / 2)[i];
          low[i] = x < low[i] ? x : low[i];
          high[i] = x > high[i] ? x : high[i];
        }
    double* circle = w.circle + 3 * static_cast<int64_t>(cluster);
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
