// The border of compressed elimination: what the tree leaves, together with what belongs to no cluster, as a small dense
// system (METHOD 7.6).
//
// Rows: those of the root, of the nodes in contact, the balances METHOD (2.6), one for each hole.
// Columns: unknowns of the root, of the nodes in contact, rho and omega, tr V of the holes; then the contact and the
// right-hand sides.
// Phases:
// 1. find_root_products(): the root's skeleton columns act on the border's rows, q = A(border, C) V, and c goes to their
//    right-hand sides.
// 2. eliminate() requests the columns panel by panel (fill_border) and proceeds as for a small body, METHOD 7.1.
// 3. Its rows of the contact go to the sink: the same reduced equations, METHOD (7.2), as without compression.
// A hole gets an unknown tr V and an equation of its own here. This splits METHOD (4.1), in which n tr V couples all nodes of
// a hole, into sparse parts that clusters can treat separately.
// Literature: bordered systems, Golub and Van Loan, Matrix Computations, section 3.2 (Schur complement by block elimination).
#include <string.h>

#include "elimination/compressed_work.hpp"
#include "linalg/dense.hpp"

namespace c2d {

namespace {

struct Border {
  Compression& t;
  const TreeCluster& root;
  ColumnSystem chosen; // the root's nodes and those of the border
  int32_t nodes;       // of the border
  int32_t elements;    // at nodes of the border, in w.elements
  int32_t outer;       // unknowns of nodes of the border, rho, omega
  const RowSink* sink;
  int32_t room() const { return root.unknowns; }
  int32_t rows() const { return room() + border_rows(t.plan); }
  int32_t first_hole() const { return room() + 2 * nodes + 3; }
  int32_t first_contact() const { return room() + outer + t.plan.holes; }
  int32_t first_right() const { return first_contact() + 2 * border_contact(t.plan); }
};

// The column of the body for each outer unknown of the border.
void list_outer(const Compression& t, int32_t* columns) {
  const Model& m = t.system.model;
  const int b = t.system.body;
  int32_t listed = 0;
  for (int32_t i = 0; i < t.plan.nodes - t.plan.tree; ++i) {
    const int32_t node = t.w.border[i];
    for (int32_t j = m.node_column[b][node]; j < m.node_column[b][node + 1]; ++j) columns[listed++] = j;
  }
  for (int32_t k = 0; k < 3; ++k) columns[listed++] = m.body[b].columns + k;
}

// Rows of a chunk in w.block: two for each source, then the balances and the holes.
int64_t rows_of(const Compression& t, int32_t sources) { return 2 * static_cast<int64_t>(sources) + 3 + t.plan.holes; }

// Sums over the boundary, below the rows of the sources.
void fill_below(const Compression& t, const ChosenColumns& columns, int32_t sources) {
  const int64_t ld = rows_of(t, sources);
  Real* below = t.w.block + 2 * static_cast<int64_t>(sources);
  fill_sums(t.system, columns, weight_of_modes(t.plan), below, ld);
  for (int32_t k = 0; k < t.plan.holes; ++k) fill_hole_row(t.system, t.w.hole[k], columns, below + 3 + k, ld);
}

// ---- the root's columns in the border ---------------------------------------------------------------------------------

// root_q += A V and root_c -= A c for columns first ... of the root: the border feels the root through them only.
void add_products(Compression& t, const TreeCluster& root, int32_t first, int32_t count) {
  CompressedWork& w = t.w;
  const int32_t n = root.unknowns, rows = border_rows(t.plan), loads = right_sides(t.plan);
  Real* v = w.e; // transposed and negative
  for (int32_t j = 0; j < n; ++j)
    for (int32_t i = 0; i < count; ++i) v[i + static_cast<int64_t>(j) * count] = -w.v[j + static_cast<int64_t>(first + i) * n];
  gemm_minus(t.engine, rows, n, count, w.block, rows, v, count, w.root_q, rows);
  for (int32_t k = 0; k < loads; ++k)
    for (int32_t j = 0; j < count; ++j)
      for (int32_t i = 0; i < rows; ++i)
        w.root_c[n + i + static_cast<int64_t>(k) * (rows + n)] -=
            w.block[i + static_cast<int64_t>(j) * rows] * w.c[first + j + static_cast<int64_t>(k) * root.columns];
}

void find_root_products(Compression& t, const TreeCluster& root) {
  CompressedWork& w = t.w;
  const int32_t rows = border_rows(t.plan), nodes = t.plan.nodes - t.plan.tree, n = root.unknowns, loads = right_sides(t.plan);
  for (int64_t i = 0; i < static_cast<int64_t>(rows) * n; ++i) w.root_q[i] = 0;
  const int64_t body_rows = 2 * static_cast<int64_t>(t.plan.nodes) + 3;
  for (int32_t k = 0; k < loads; ++k) {
    Real* to = w.root_c + static_cast<int64_t>(k) * (rows + n);
    const Real* right = w.right + k * body_rows;
    for (int32_t i = 0; i < n; ++i) to[i] = w.b[i + static_cast<int64_t>(k) * n];
    for (int32_t i = 0; i < 2 * nodes; ++i) to[n + i] = right[2 * w.border[i / 2] + i % 2];
    for (int32_t i = 0; i < 3; ++i) to[n + 2 * nodes + i] = right[2 * t.plan.nodes + i];
    for (int32_t i = 0; i < t.plan.holes; ++i) to[n + 2 * nodes + 3 + i] = 0;
  }
  const ColumnSystem chosen = choose_nodes(t.system, w.border, nodes, w.point, w.twin);
  // Chunks, because the border's rows times all columns of the root need not fit into the block.
  const int64_t fit = block_numbers(t.plan) / rows;
  const int32_t most = fit < kChunk ? static_cast<int32_t>(fit) : kChunk;
  for (int32_t first = 0; first < root.columns; first += most) {
    const int32_t count = root.columns - first < most ? root.columns - first : most;
    for (int32_t j = 0; j < count; ++j) {
      w.place[column_of(t, root.column_ids[first + j])] = j;
      w.list[j] = root.column_ids[first + j] / 2;
    }
    const ChosenColumns columns{w.place, count, w.elements, list_elements(t, w.list, count, w.elements)};
    fill_chosen(chosen, columns, w.block, rows);
    fill_below(t, columns, nodes);
    for (int32_t j = 0; j < count; ++j) w.place[column_of(t, root.column_ids[first + j])] = -1;
    add_products(t, root, first, count);
    for (int64_t i = 0; i < static_cast<int64_t>(rows) * count && t.plan.keeps != 0; ++i)
      w.sums[i + static_cast<int64_t>(first) * rows] = w.block[i];
  }
  for (int64_t i = 0; i < static_cast<int64_t>(n) * n; ++i) w.root_d[i] = w.d[i];
}

// ---- columns ------------------------------------------------------------------------------------------------------------

void fill_root_column(const Border& b, int32_t j, Real* to) {
  const CompressedWork& w = b.t.w;
  const int32_t n = b.root.unknowns, rows = border_rows(b.t.plan);
  for (int32_t i = 0; i < n; ++i) to[i] = w.root_d[j + static_cast<int64_t>(i) * n];
  for (int32_t i = 0; i < rows; ++i) to[n + i] = w.root_q[i + static_cast<int64_t>(j) * rows];
}

// Column of tr V: the normal of the hole at each of its nodes. The hole's own row defines tr V, hence the -1 there.
void fill_hole_column(const Border& b, int32_t hole, Real* to) {
  const Compression& t = b.t;
  const auto normal = [&](int32_t node, int c) {
    double n[2] = {0.0, 0.0};
    if (t.w.hole_at[node] == hole && has_integrals(t, node, c)) hole_normal(t.system.model, t.system.body, node, n);
    return static_cast<Real>(n[c]);
  };
  for (int32_t i = 0; i < b.room(); ++i) to[i] = normal(b.root.row_ids[i] / 2, b.root.row_ids[i] % 2);
  for (int32_t i = 0; i < 2 * b.nodes; ++i) to[b.room() + i] = normal(t.w.border[i / 2], i % 2);
  for (int32_t i = b.first_hole() - 3; i < b.rows(); ++i) to[i] = i == b.first_hole() + hole ? Real(-1) : Real(0);
}

void fill_right_column(const Border& b, int32_t k, Real* to) {
  const int32_t all = b.rows();
  memcpy(to, b.t.w.root_c + static_cast<int64_t>(k) * all, static_cast<size_t>(all) * sizeof(Real));
}

// Columns of the body, listed in w.list, into consecutive columns of the panel.
void fill_body_columns(const Border& b, int32_t count, Real* panel, int64_t ld) {
  const Compression& t = b.t;
  CompressedWork w = t.w;
  const int32_t sources = b.chosen.sources;
  const int64_t rows = rows_of(t, sources);
  for (int32_t j = 0; j < count; ++j) w.place[w.list[j]] = j;
  const ChosenColumns columns{w.place, count, w.elements, b.elements};
  fill_chosen(b.chosen, columns, w.block, rows);
  fill_below(t, columns, sources);
  const int64_t border = 2 * static_cast<int64_t>(sources - b.nodes);
  for (int32_t j = 0; j < count; ++j) {
    w.place[w.list[j]] = -1;
    const Real* from = w.block + j * rows;
    Real* to = panel + j * ld;
    for (int32_t i = 0; i < b.room(); ++i) to[i] = from[2 * w.position[b.root.row_ids[i] / 2] + b.root.row_ids[i] % 2];
    for (int32_t i = 0; i < border_rows(t.plan); ++i) to[b.room() + i] = from[border + i];
  }
}

// Fills as many columns from `first` on as are of one kind and fit into the block. Returns their number.
int32_t fill_some(const Border& b, int32_t first, int32_t count, Real* panel, int64_t ld) {
  const Compression& t = b.t;
  if (first < b.room()) return fill_root_column(b, first, panel), 1;
  const int32_t j = first - b.room();
  if (j >= b.outer && first < b.first_contact()) return fill_hole_column(b, j - b.outer, panel), 1;
  if (first >= b.first_right()) return fill_right_column(b, first - b.first_right(), panel), 1;
  const bool contact = first >= b.first_contact();
  const int64_t fit = block_numbers(t.plan) / rows_of(t, b.chosen.sources);
  int32_t most = fit < kChunk ? static_cast<int32_t>(fit) : kChunk;
  const int32_t left = (contact ? b.first_right() : b.room() + b.outer) - first;
  if (left < most) most = left;
  if (count < most) most = count;
  for (int32_t k = 0; k < most; ++k)
    t.w.list[k] = contact ? t.plan.columns + first - b.first_contact() + k : t.w.sources[b.chosen.sources + j + k];
  fill_body_columns(b, most, panel, ld);
  return most;
}

c2d_status fill_border(void* context, int32_t first, int32_t count, Real* panel, int64_t ld) {
  const Border& b = *static_cast<const Border*>(context);
  for (int32_t done = 0; done < count;) done += fill_some(b, first + done, count - done, panel + done * ld, ld);
  return C2D_OK;
}

// Passes the reduced rows on, except those of the random right-hand side, which only back substitution uses.
c2d_status take_rows(void* context, int32_t first, int32_t count, const Real* rows, int64_t ld) {
  const Border& b = *static_cast<const Border*>(context);
  const int32_t end = 2 * border_contact(b.t.plan) + b.t.plan.loads, some = first + count > end ? end - first : count;
  if (some == 0) return C2D_OK;
  return b.sink->take(b.sink->context, first, some, rows, ld);
}

// The last record: which unknown of the body each unknown of the border is (-1: none, as tr V).
c2d_status write_unknowns(Border& b) {
  Compression& t = b.t;
  const uint64_t start = t.upper.end;
  const int32_t none = -1;
  for (int32_t j = 0; j < b.first_contact(); ++j) {
    const int32_t outer = j - b.room();
    const int32_t* id = outer < 0 ? t.w.ids + j : &none;
    if (outer >= 0 && outer < b.outer) id = t.w.sources + b.chosen.sources + outer;
    append(t.upper, id, sizeof *id);
  }
  const uint64_t length = t.upper.end - start;
  append(t.upper, &length, sizeof length);
  return t.upper.status;
}

// With lazy columns, right-hand sides follow later: the border's matrix is factored and stored as a whole.
c2d_status keep_whole(Border& b) {
  const int32_t size = b.rows();
  const c2d_status status = fill_border(&b, 0, size, b.t.w.whole, size);
  return status == C2D_OK ? keep_border(b.t, b.root, b.t.w.sources + b.chosen.sources, size) : status;
}

} // namespace

c2d_status eliminate_border(Compression& t, const TreeCluster& root, const RowSink& sink, Tapes& tapes, const Watch& watch) {
  CompressedWork& w = t.w;
  find_root_products(t, root);
  const int32_t nodes = t.plan.nodes - t.plan.tree;
  int32_t sources = list_sources(t, root.row_ids, root.rows, w.sources);
  for (int32_t i = 0; i < nodes; ++i) w.sources[sources++] = w.border[i];
  list_outer(t, w.sources + sources);
  const ColumnSystem chosen = choose_nodes(t.system, w.sources, sources, w.point, w.twin);
  Border border{t, root, chosen, nodes, list_elements(t, w.border, nodes, w.elements), t.plan.columns - 2 * t.plan.tree, &sink};
  c2d_status status = write_unknowns(border);
  if (status == C2D_OK && t.plan.keeps != 0) status = keep_whole(border);
  if (status != C2D_OK) return status;
  // The condition of METHOD 7.4 covers the border's pivots together with those of the clusters.
  PivotStats stats;
  status = eliminate(border_with(t.plan, root.unknowns), ColumnSource{&border, fill_border}, RowSink{&border, take_rows}, tapes,
                     w.dense, &stats, watch, t.engine);
  if (stats.smallest_ratio < t.pivots->smallest_ratio) t.pivots->smallest_ratio = stats.smallest_ratio;
  if (stats.largest_ratio > t.pivots->largest_ratio) t.pivots->largest_ratio = stats.largest_ratio;
  if (stats.growth > t.pivots->growth) t.pivots->growth = stats.growth;
  if (stats.smallest_column >= 0) t.pivots->smallest_column = stats.smallest_column;
  return status;
}

} // namespace c2d
