// Compressed elimination of one body: the driver and the work on one cluster of the tree (METHOD 7.6).
//
// Phases:
// 1. Prepare: reach of each node, right-hand sides, order of the nodes in the leaves, equations that are checked later.
// 2. Leaves to root, one depth at a time. For each cluster: choose its skeleton rows S and columns C (compressed_basis.cpp);
//    assemble its own block D (a leaf) or join its two halves; split off the equations of the cluster alone;
//    eliminate as many unknowns; pass the remainder on to the cluster above.
// 3. Root: it joins the border, which is solved densely (compressed_border.cpp).
// Equations, METHOD (7.3) and (7.4), with R the other rows of the cluster, X and Z the interpolation matrices:
//   A(R, outside) = X^T A(S, outside),   A(outside, cluster) = A(outside, C) Z,
//   (D_R - X^T D_S) x = b_R - X^T b_S   =>   x_1 = h - M x_2.
// Literature: Martinsson and Rokhlin, J. Comput. Phys. 205 (2005), skeletons and proxies; Chandrasekaran, Gu and Pals, SIAM J.
// Matrix Anal. Appl. 28 (2006), equations of a cluster alone; Martinsson, Fast Direct Solvers for Elliptic PDEs (SIAM, 2019).
//
// Matrices of a cluster are stored transposed, so that an equation is a contiguous column and the LU code for tall panels
// applies.
#include <string.h>

#include "elimination/cells.hpp"
#include "elimination/compressed_work.hpp"
#include "linalg/dense.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"

namespace c2d {

C2D_USES(HolePart);

void list_holes(const ColumnSystem& system, int32_t count, Hole* out) {
  HoleWalk walk{};
  for (int32_t k = 0; k < count; ++k) kHolePart.next_hole(system.model, system.body, walk, out[k]);
}

namespace {

// ---- before the tree --------------------------------------------------------------------------------------------------

// Distance from a node to the farthest point of its elements. The unknown at a node acts along these elements, so "near" must
// count their extent and not the node alone.
double reach_of(const Compression& t, int32_t node) {
  const Model& m = t.system.model;
  const double* at = t.system.point + 2 * static_cast<int64_t>(node);
  int32_t ends[2];
  const int count = ends_at_node(m, t.system.body, node, ends);
  double reach = 0.0;
  for (int k = 0; k < count; ++k) {
    double x[kElementNodes], y[kElementNodes], length = 0.0;
    element_coordinates(m, t.system.body, ends[k] / m.head->function_nodes, x, y);
    const int points = m.body[t.system.body].element_nodes;
    for (int i = 0; i < points; ++i) {
      const double d = hypot(x[i] / m.head->length_unit - at[0], y[i] / m.head->length_unit - at[1]);
      if (i > 0) length += hypot(x[i] - x[i - 1], y[i] - y[i - 1]) / m.head->length_unit;
      if (d > reach) reach = d;
    }
    if (points > 2 && length > reach) reach = length; // a curve may extend beyond its points
  }
  return reach;
}

// Marks each node with its hole, because the equations at a hole contain n tr V besides the integrals, METHOD (4.1).
void place_holes(Compression& t) {
  list_holes(t.system, t.plan.holes, t.w.hole);
  for (int32_t k = 0; k < t.plan.holes; ++k)
    visit_hole(t.system, t.w.hole[k], [&](int32_t node, const double*) { t.w.hole_at[node] = k; });
}

// A fixed pseudo-random sequence of 1 and -1. It must not depend on the machine: the estimate of the error is printed.
Real noise(int64_t i) {
  uint64_t z = (static_cast<uint64_t>(i) + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 31)) * 0xbf58476d1ce4e5b9u;
  return (z >> 40 & 1) != 0 ? Real(1) : Real(-1);
}

// Right-hand sides of the load cases, and one more of random signs. The last one gives A^-1 s, from which METHOD 7.6 estimates
// how round-off grows. Rows of a balance that a rigid-body mode replaces carry no load.
void fill_right(Compression& t) {
  const int64_t rows = 2 * static_cast<int64_t>(t.plan.nodes) + 3;
  // Large bodies: far elements act through multipole series, which costs n log n instead of n^2.
  if (has_sums_by_cells(t.system))
    fill_right_by_cells(t.system, t.w.right, rows, t.w.sums_by_cells);
  else
    fill_columns(t.system, t.plan.columns + 2 * t.plan.contact, t.plan.loads, t.w.right, rows);
  for (int32_t k = 0; k < t.plan.loads; ++k)
    rotate_balances(t.system.model, t.system.body, t.w.right + k * rows + 2 * static_cast<int64_t>(t.plan.nodes));
  Real* last = t.w.right + rows * t.plan.loads;
  for (int64_t i = 0; i < rows; ++i) last[i] = noise(i);
}

// Assigns every node to the tree or to the border. Nodes in contact stay in the border, because their columns must survive.
void start_lists(Compression& t) {
  const Model& m = t.system.model;
  CompressedWork& w = t.w;
  int32_t tree = 0, border = 0;
  for (int32_t node = 0; node < t.plan.nodes; ++node) {
    w.position[node] = w.hole_at[node] = w.stamp[node] = -1;
    w.reach[node] = reach_of(t, node);
    (is_tree_node(m, t.system.body, node) ? w.order[tree++] : w.border[border++]) = node;
  }
  for (int32_t j = 0; j < t.plan.columns + 2 * t.plan.contact; ++j) w.place[j] = -1;
  C2D_ASSERT(tree == t.plan.tree);
  order_nodes(t.system.point, t.plan.tree, t.depth, w.order, w.room);
  place_holes(t);
  fill_right(t);
}

// Stores the equations that check_compressed() assembles again later: nodes at equal intervals of the numbering, hence all
// over the boundary. Their diagonal and right-hand sides are needed then, and the arrays that contain them are gone by then.
void write_samples(Compression& t) {
  const int32_t count = sample_count(t.plan);
  const int64_t rows = 2 * static_cast<int64_t>(t.plan.nodes) + 3;
  for (int32_t i = 0; i < count; ++i) {
    const int64_t node = (2 * static_cast<int64_t>(i) + 1) * t.plan.nodes / (2 * count);
    CheckedNode sample;
    memset(&sample, 0, sizeof sample); // padding bytes reach the tape: the same run must write the same bytes
    sample.node = static_cast<int32_t>(node);
    sample.twin = t.system.twin[node];
    sample.hole = t.w.hole_at[node];
    memcpy(sample.point, t.system.point + 2 * node, sizeof sample.point);
    memcpy(sample.diagonal, t.system.diagonal + 4 * node, sizeof sample.diagonal);
    append(t.upper, &sample, sizeof sample);
    for (int32_t k = 0; k < t.plan.loads; ++k) append(t.upper, t.w.right + 2 * node + k * rows, 2 * sizeof(Real));
  }
}

// Writes the incomplete last block, and the length of all records into a block of its own. Back substitution reads the records
// from that end backwards.
c2d_status finish_records(Compression& t) {
  const uint64_t end = t.upper.end;
  const c2d_status status = finish_block(t.upper);
  if (status != C2D_OK) return status;
  memset(t.upper.buffer + kBlockHeaderBytes, 0, kEndBytes);
  memcpy(t.upper.buffer + kBlockHeaderBytes, &end, sizeof end);
  return write_block(*t.upper.tapes, C2D_TAPE_UPPER, t.upper.first_block - 1, t.upper.buffer, kEndBytes);
}

// In a leaf every equation and every unknown is a candidate for the skeleton. Depths above start from the skeletons below.
void start_leaves(Compression& t) {
  CompressedWork& w = t.w;
  for (int32_t k = 0; k < 2 * t.plan.tree; ++k) w.rows[0][k] = w.columns[0][k] = 2 * w.order[k / 2] + k % 2;
  for (int32_t i = 0; i <= 1 << t.depth; ++i)
    w.row_begin[0][i] = w.column_begin[0][i] = 2 * leaf_begin(t.plan.tree, t.depth, i);
}

// ---- the equations of a cluster -----------------------------------------------------------------------------------------

// Leaf: D is the block of the system matrix, V the identity (no unknown has been eliminated), b the right-hand sides, c = 0.
void read_leaf(Compression& t, TreeCluster& cluster) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.rows, loads = right_sides(t.plan);
  cluster.unknowns = n;
  int64_t ld;
  int32_t sources;
  fill_block(t, cluster.row_ids, n, cluster.column_ids, n, &ld, &sources);
  const int64_t rows = 2 * static_cast<int64_t>(t.plan.nodes) + 3;
  for (int32_t i = 0; i < n; ++i) {
    const int64_t from = 2 * w.position[cluster.row_ids[i] / 2] + cluster.row_ids[i] % 2;
    w.ids[i] = column_of(t, cluster.column_ids[i]);
    for (int32_t j = 0; j < n; ++j) {
      w.d[j + static_cast<int64_t>(i) * n] = w.block[from + j * ld];
      w.v[j + static_cast<int64_t>(i) * n] = i == j ? Real(1) : Real(0);
    }
    for (int32_t k = 0; k < loads; ++k) {
      w.b[i + static_cast<int64_t>(k) * n] = w.right[cluster.row_ids[i] + k * rows];
      w.c[i + static_cast<int64_t>(k) * n] = 0;
    }
  }
  clear_sources(t, w.sources, sources);
}

// Reads what a half has written: counts, identities of the unknowns that remain, then the numbers D, V, b and c.
c2d_status read_result(Compression& t, uint64_t& at, ClusterResult& out, int32_t* ids, Real* numbers) {
  int32_t counts[4];
  if (read_at(t.read, at, counts, sizeof counts) != C2D_OK) return t.read.status;
  at += sizeof counts;
  out.kept = counts[0], out.rows = counts[1], out.columns = counts[2];
  read_at(t.read, at, ids, static_cast<uint64_t>(out.kept) * sizeof(int32_t));
  at += static_cast<uint64_t>(out.kept) * sizeof(int32_t);
  const int64_t loads = right_sides(t.plan);
  const int64_t d = static_cast<int64_t>(out.kept) * out.rows, v = static_cast<int64_t>(out.kept) * out.columns;
  out.d = numbers;
  out.v = out.d + d;
  out.b = out.v + v;
  out.c = out.b + out.rows * loads;
  const uint64_t bytes = static_cast<uint64_t>(d + v + (out.rows + out.columns) * loads) * sizeof(Real);
  read_at(t.read, at, numbers, bytes);
  at += bytes;
  return t.read.status;
}

// Coupling of two halves. The rows S of `to` feel the half `from` through its skeleton columns C only:
//   D(S_to, x_from) = A(S_to, C_from) V_from,   b_to -= A(S_to, C_from) c_from.
// The result goes into w.d from (first_row, first_unknown) on.
void couple(Compression& t, const TreeCluster& cluster, const ClusterResult& to, int32_t first_row, const int32_t* row_ids,
            const ClusterResult& from, int32_t first_unknown, const int32_t* column_ids, Real* kept) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns, loads = right_sides(t.plan);
  int64_t ld;
  int32_t sources;
  fill_block(t, row_ids, to.rows, column_ids, from.columns, &ld, &sources);
  Real* block = w.e; // transposed, negated: gemm_minus subtracts
  for (int32_t i = 0; i < to.rows; ++i) {
    const int64_t at = 2 * w.position[row_ids[i] / 2] + row_ids[i] % 2;
    for (int32_t j = 0; j < from.columns; ++j) block[j + static_cast<int64_t>(i) * from.columns] = -w.block[at + j * ld];
  }
  // Additional right-hand sides pass through the same coupling later.
  for (int64_t i = 0; i < static_cast<int64_t>(to.rows) * from.columns && t.plan.keeps != 0; ++i) kept[i] = -block[i];
  clear_sources(t, w.sources, sources);
  Real* d = w.d + first_unknown + static_cast<int64_t>(first_row) * n;
  gemm_minus(t.engine, from.kept, to.rows, from.columns, from.v, from.kept, block, from.columns, d, n);
  for (int32_t k = 0; k < loads; ++k)
    for (int32_t i = 0; i < to.rows; ++i) {
      Real sum = 0;
      for (int32_t j = 0; j < from.columns; ++j)
        sum += block[j + static_cast<int64_t>(i) * from.columns] * from.c[j + static_cast<int64_t>(k) * from.columns];
      w.b[first_row + i + static_cast<int64_t>(k) * cluster.rows] += sum;
    }
}

void copy_block(int32_t rows, int32_t columns, const Real* from, Real* to, int64_t ld) {
  for (int32_t j = 0; j < columns; ++j)
    for (int32_t i = 0; i < rows; ++i) to[i + j * ld] = from[i + static_cast<int64_t>(j) * rows];
}

// Two halves become one cluster. D is block diagonal in what the halves left, plus the two coupling blocks.
c2d_status join_halves(Compression& t, TreeCluster& cluster, uint64_t& at) {
  CompressedWork& w = t.w;
  ClusterResult half[2];
  c2d_status status = read_result(t, at, half[0], w.ids, w.result[0]);
  if (status == C2D_OK) status = read_result(t, at, half[1], w.ids + half[0].kept, w.result[1]);
  if (status != C2D_OK) return status;
  const int32_t n = half[0].kept + half[1].kept, loads = right_sides(t.plan);
  cluster.unknowns = n;
  cluster.half_rows = half[0].rows;
  cluster.half_columns = half[0].columns;
  for (int64_t i = 0; i < static_cast<int64_t>(n) * cluster.rows; ++i) w.d[i] = 0;
  for (int64_t i = 0; i < static_cast<int64_t>(n) * cluster.columns; ++i) w.v[i] = 0;
  int32_t unknown = 0, row = 0, column = 0;
  for (const ClusterResult& h : half) {
    copy_block(h.kept, h.rows, h.d, w.d + unknown + static_cast<int64_t>(row) * n, n); // own rows on own unknowns
    copy_block(h.kept, h.columns, h.v, w.v + unknown + static_cast<int64_t>(column) * n, n);
    copy_block(h.rows, loads, h.b, w.b + row, cluster.rows);
    copy_block(h.columns, loads, h.c, w.c + column, cluster.columns);
    unknown += h.kept, row += h.rows, column += h.columns;
  }
  couple(t, cluster, half[0], 0, cluster.row_ids, half[1], half[0].kept, cluster.column_ids + half[0].columns, w.coupling[0]);
  couple(t, cluster, half[1], half[0].rows, cluster.row_ids + half[0].rows, half[0], 0, cluster.column_ids, w.coupling[1]);
  return C2D_OK;
}

// ---- its elimination -------------------------------------------------------------------------------------------------

// Rows of METHOD (7.4). The first `spare` columns of w.e become D_R - X^T D_S: these equations do not contain the rest of the
// body. The skeleton rows D_S follow unchanged. The right-hand sides are combined in the same way.
void split_rows(Compression& t, const TreeCluster& cluster, const Split& s) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns, loads = right_sides(t.plan);
  for (int32_t i = 0; i < cluster.rows; ++i) {
    const int32_t from = i < s.spare ? w.row_order[s.rows + i] : w.row_order[i - s.spare];
    memcpy(w.e + static_cast<int64_t>(i) * n, w.d + static_cast<int64_t>(from) * n, static_cast<size_t>(n) * sizeof(Real));
  }
  gemm_minus(t.engine, n, s.spare, s.rows, w.e + static_cast<int64_t>(s.spare) * n, n, w.row_x, s.rows, w.e, n);
  for (int32_t k = 0; k < loads; ++k) {
    const Real* b = w.b + static_cast<int64_t>(k) * cluster.rows;
    Real* g = w.g + static_cast<int64_t>(k) * cluster.rows; // right-hand sides of the own rows, then of the skeleton rows
    for (int32_t i = 0; i < s.rows; ++i) g[s.spare + i] = b[w.row_order[i]];
    for (int32_t i = 0; i < s.spare; ++i) {
      Real sum = b[w.row_order[s.rows + i]];
      for (int32_t j = 0; j < s.rows; ++j) sum -= w.row_x[j + static_cast<int64_t>(i) * s.rows] * g[s.spare + j];
      g[i] = sum;
    }
  }
}

// Columns of METHOD (7.3): (Z V)^T behind the rows in w.e, and Z c in place of c. From now on the outside sees the cluster
// through its skeleton columns only.
void split_columns(Compression& t, const TreeCluster& cluster, const Split& s) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns, loads = right_sides(t.plan), rest = cluster.columns - s.columns;
  Real *to = w.e + static_cast<int64_t>(cluster.rows) * n, *others = w.samples, *x = w.d; // (free by now)
  for (int32_t j = 0; j < cluster.columns; ++j) {
    Real* column = j < s.columns ? to + static_cast<int64_t>(j) * n : others + static_cast<int64_t>(j - s.columns) * n;
    memcpy(column, w.v + static_cast<int64_t>(w.column_order[j]) * n, static_cast<size_t>(n) * sizeof(Real));
  }
  for (int32_t i = 0; i < s.columns; ++i)
    for (int32_t j = 0; j < rest; ++j)
      x[j + static_cast<int64_t>(i) * rest] = -w.column_x[i + static_cast<int64_t>(j) * s.columns];
  gemm_minus(t.engine, n, s.columns, rest, others, n, x, rest, to, n);
  for (int32_t k = 0; k < loads; ++k) {
    Real* c = w.c + static_cast<int64_t>(k) * cluster.columns;
    for (int32_t j = 0; j < cluster.columns; ++j) w.sample[j] = c[w.column_order[j]];
    for (int32_t i = 0; i < s.columns; ++i) {
      Real sum = w.sample[i];
      for (int32_t j = 0; j < rest; ++j) sum += w.column_x[i + static_cast<int64_t>(j) * s.columns] * w.sample[s.columns + j];
      c[i] = sum;
    }
  }
}

// Right-hand sides after the factorisation. The own equations read U^T (L_1^T x_1 + L_2^T x_2) = g. So g := U^-T g, and with
// y_1' = L_1^-1 y_1 of a trailing column, y_1'^T g is the known part that x_1 contributes to that row or column.
void carry_loads(Compression& t, const TreeCluster& cluster, const Split& s) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns, loads = right_sides(t.plan);
  for (int32_t k = 0; k < loads; ++k) {
    Real *g = w.g + static_cast<int64_t>(k) * cluster.rows, *c = w.c + static_cast<int64_t>(k) * cluster.columns;
    for (int32_t j = 0; j < s.spare; ++j) {
      const Real* u = w.e + static_cast<int64_t>(j) * n;
      Real sum = g[j];
      for (int32_t i = 0; i < j; ++i) sum -= u[i] * g[i];
      g[j] = sum / u[j];
    }
    for (int32_t i = 0; i < s.rows + s.columns; ++i) {
      const Real* y = w.e + static_cast<int64_t>(s.spare + i) * n;
      Real sum = 0;
      for (int32_t j = 0; j < s.spare; ++j) sum += y[j] * g[j];
      if (i < s.rows)
        g[s.spare + i] -= sum;
      else
        c[i - s.rows] += sum;
    }
  }
}

// x_1 = h - M x_2 from L_1^T x_1 + L_2^T x_2 = g: M = L_1^-T L_2^T (spare x kept) in w.d, h = L_1^-T g in w.g. This record is
// all that back substitution needs of the cluster.
void find_dependence(Compression& t, const TreeCluster& cluster, const Split& s) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns, kept = n - s.spare, loads = right_sides(t.plan);
  for (int32_t j = 0; j < kept; ++j)
    for (int32_t i = 0; i < s.spare; ++i)
      w.d[i + static_cast<int64_t>(j) * s.spare] = w.e[s.spare + j + static_cast<int64_t>(i) * n];
  // L_1 is unit lower triangular, so its transpose is solved from the last unknown upwards, without divisions.
  const auto solve = [&](Real* x) {
    for (int32_t i = s.spare - 1; i >= 0; --i) {
      const Real* l = w.e + static_cast<int64_t>(i) * n;
      Real sum = x[i];
      for (int32_t k = i + 1; k < s.spare; ++k) sum -= l[k] * x[k];
      x[i] = sum;
    }
  };
  for (int32_t j = 0; j < kept; ++j) solve(w.d + static_cast<int64_t>(j) * s.spare);
  for (int32_t k = 0; k < loads; ++k) solve(w.g + static_cast<int64_t>(k) * cluster.rows);
}

// ---- records ------------------------------------------------------------------------------------------------------------

void append_columns(Stream& to, int32_t rows, int32_t columns, const Real* from, int64_t ld) {
  for (int32_t j = 0; j < columns; ++j) append(to, from + j * ld, static_cast<uint64_t>(rows) * sizeof(Real));
}

// Record for back substitution: counts, unknowns eliminated and kept, M, h. Its length comes last, because a solution reads
// the records backwards, from the root to the leaves.
c2d_status write_record(Compression& t, const TreeCluster& cluster, const Split& s) {
  const int32_t counts[2] = {s.spare, cluster.unknowns - s.spare};
  const uint64_t start = t.upper.end;
  append(t.upper, counts, sizeof counts);
  append(t.upper, t.w.ids, static_cast<uint64_t>(cluster.unknowns) * sizeof(int32_t));
  append(t.upper, t.w.d, static_cast<uint64_t>(s.spare) * static_cast<uint64_t>(counts[1]) * sizeof(Real));
  append_columns(t.upper, s.spare, right_sides(t.plan), t.w.g, cluster.rows);
  const uint64_t length = t.upper.end - start;
  append(t.upper, &length, sizeof length);
  return t.upper.status;
}

// What the cluster above reads, in the order of read_result().
c2d_status write_result(Compression& t, const TreeCluster& cluster, const Split& s) {
  const CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns, kept = n - s.spare, loads = right_sides(t.plan);
  const int32_t counts[4] = {kept, s.rows, s.columns, 0};
  append(t.lower, counts, sizeof counts);
  append(t.lower, w.ids + s.spare, static_cast<uint64_t>(kept) * sizeof(int32_t));
  append_columns(t.lower, kept, s.rows + s.columns, w.e + s.spare + static_cast<int64_t>(s.spare) * n, n);
  append_columns(t.lower, s.rows, loads, w.b, s.rows);
  append_columns(t.lower, s.columns, loads, w.c, cluster.columns);
  return t.lower.status;
}

// ---- one cluster ------------------------------------------------------------------------------------------------------

// The workspace was sized for a largest rank. A cluster that needs more ends the elimination; the caller reports the size that
// is enough.
c2d_status note_rank(Compression& t, int32_t rank) {
  if (rank > t.stats->largest_rank) t.stats->largest_rank = rank;
  t.stats->ranks += rank;
  ++t.stats->clusters;
  return rank > t.plan.rank ? C2D_ERR_MEMORY : C2D_OK;
}

// Factors the own equations and updates the skeleton rows and columns with them. Row exchanges of the transposed panel choose
// which unknowns are eliminated: no diagonal block needs to be regular by itself.
c2d_status eliminate_cluster(Compression& t, const TreeCluster& cluster, const Split& s) {
  CompressedWork& w = t.w;
  const int32_t n = cluster.unknowns;
  for (int32_t j = 0; j < s.spare; ++j) w.norms[j] = largest(t.engine, n, w.e + static_cast<int64_t>(j) * n);
  const int32_t columns = s.spare + s.rows + s.columns;
  // The own equations are `spare` columns of n >= spare entries. A column without a pivot means that the body's system is
  // singular.
  if (lu_panel({t.engine, n, s.spare, columns, w.e, n, w.pivots, w.norms, t.pivots}) > 0) return C2D_ERR_SINGULAR;
  lu_settle(n, s.spare, w.e, n, w.pivots);
  for (int32_t j = 0; j < s.spare; ++j) {
    const int32_t kept = w.ids[j];
    w.ids[j] = w.ids[w.pivots[j]];
    w.ids[w.pivots[j]] = kept;
  }
  carry_loads(t, cluster, s);
  // The skeleton rows take their reduced right-hand sides in place of b; g itself goes to the record.
  for (int32_t k = 0; k < right_sides(t.plan); ++k)
    for (int32_t i = 0; i < s.rows; ++i)
      w.b[i + static_cast<int64_t>(k) * s.rows] = w.g[s.spare + i + static_cast<int64_t>(k) * cluster.rows];
  find_dependence(t, cluster, s);
  const c2d_status status = write_record(t, cluster, s);
  return status == C2D_OK ? write_result(t, cluster, s) : status;
}

// The skeleton of this cluster is part of the candidates of the cluster above.
void list_kept(Compression& t, const Depth& d, int32_t i, const TreeCluster& cluster, const Split& s) {
  CompressedWork& w = t.w;
  const int to = 1 - d.which;
  int32_t *row = w.row_begin[to], *column = w.column_begin[to];
  if (i == 0) row[0] = column[0] = 0;
  for (int32_t k = 0; k < s.rows; ++k) w.rows[to][row[i] + k] = cluster.row_ids[w.row_order[k]];
  for (int32_t k = 0; k < s.columns; ++k) w.columns[to][column[i] + k] = cluster.column_ids[w.column_order[k]];
  row[i + 1] = row[i] + s.rows;
  column[i + 1] = column[i] + s.columns;
}

TreeCluster cluster_at(const Compression& t, const Depth& d, int32_t i) {
  const int32_t *row = t.w.row_begin[d.which], *column = t.w.column_begin[d.which];
  return TreeCluster{
      0, row[i + 1] - row[i], column[i + 1] - column[i], t.w.rows[d.which] + row[i], t.w.columns[d.which] + column[i], -1, 0};
}

// One cluster. The skeletons are chosen before the block is assembled, because they use the same work arrays.
c2d_status reduce_cluster(Compression& t, const Depth& d, int32_t i, bool leaf, uint64_t& at) {
  TreeCluster cluster = cluster_at(t, d, i);
  Split s;
  s.rows = choose_rows(t, d, i);
  c2d_status status = note_rank(t, s.rows);
  if (status != C2D_OK) return status;
  s.columns = choose_columns(t, d, i);
  status = note_rank(t, s.columns);
  if (status != C2D_OK) return status;
  if (leaf)
    read_leaf(t, cluster);
  else
    status = join_halves(t, cluster, at);
  if (status != C2D_OK) return status;
  s.spare = cluster.rows - s.rows;
  split_rows(t, cluster, s);
  split_columns(t, cluster, s);
  list_kept(t, d, i, cluster, s);
  status = eliminate_cluster(t, cluster, s);
  return status == C2D_OK && t.plan.keeps != 0 ? keep_cluster(t, cluster, s) : status;
}

// The lists of two neighbouring clusters lie side by side, so the lists of the depth above need no copy: only the limits
// change.
void join_lists(Compression& t, Depth& d) {
  d.which = 1 - d.which;
  d.clusters /= 2;
  for (int32_t i = 0; i <= d.clusters; ++i) {
    t.w.row_begin[d.which][i] = t.w.row_begin[d.which][2 * i];
    t.w.column_begin[d.which][i] = t.w.column_begin[d.which][2 * i];
  }
}

// All clusters of a depth read what the depth below wrote to the tape and write their own results behind it.
c2d_status reduce_depth(Compression& t, const Depth& d, bool leaf, uint64_t& at, const Watch& watch) {
  place_circles(t, d);
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < d.clusters && status == C2D_OK; ++i) {
    status = reduce_cluster(t, d, i, leaf, at);
    if (status == C2D_OK && watch.step != nullptr) status = watch.step(watch.context, 0);
  }
  return status == C2D_OK ? finish_block(t.lower) : status;
}

// The root has no outside, hence no skeleton to choose. It goes to the border as it is.
c2d_status keep_root(Compression& t, const Depth& d, bool leaf, uint64_t at, const RowSink& sink, Tapes& tapes,
                     const Watch& watch) {
  TreeCluster cluster = cluster_at(t, d, 0);
  if (leaf) {
    read_leaf(t, cluster);
  } else {
    const c2d_status status = join_halves(t, cluster, at);
    if (status != C2D_OK) return status;
  }
  return eliminate_border(t, cluster, sink, tapes, watch);
}

} // namespace

c2d_status eliminate_compressed(const CompressedPlan& plan, const ColumnSystem& system, const RowSink& sink, Tapes& tapes,
                                void* work, PivotStats* pivots, CompressedStats* stats, const Watch& watch,
                                const Engine& engine) {
  Compression t{plan, system, {}, engine, tree_depth(plan.tree, plan.leaf), 0, stats, pivots, {}, {}, {}, {}};
  // Tape LOWER, one behind the other: blocks of the border, results of the clusters, data for additional right-hand sides.
  lay_out_work(plan, static_cast<char*>(work), &t.w);
  *t.stats = CompressedStats{};
  t.pivots->base = 0;
  start_stats(*t.pivots);
  const KeptPlace kept = kept_place(plan);
  const uint64_t lower_first = plan.border.lower_first_block + lower_use(plan.border).blocks;
  const uint64_t lower_blocks = kept.first_block - lower_first;
  t.kept = open_stream(tapes, C2D_TAPE_LOWER, kept.first_block, kept.blocks, plan.block_bytes, t.w.kept_buffer);
  t.lower = open_stream(tapes, C2D_TAPE_LOWER, lower_first, lower_blocks, plan.block_bytes, t.w.lower_buffer);
  t.read = open_stream(tapes, C2D_TAPE_LOWER, lower_first, lower_blocks, plan.block_bytes, t.w.read_buffer);
  t.upper = records_of(plan, tapes, t.w.upper_buffer);
  // Before the tree is built: the work area of the sums is used again by the clusters.
  if (has_diagonal_by_cells(system)) fill_diagonal_by_cells(system, t.w.sums_by_cells);
  start_lists(t);
  start_leaves(t);
  write_samples(t);
  Depth depth{1 << t.depth, 0};
  c2d_status status = C2D_OK;
  bool leaf = true;
  uint64_t from = 0; // where the results of the depth below begin
  for (; depth.clusters > 1 && status == C2D_OK; leaf = false) {
    uint64_t at = from;
    from = t.lower.end;
    status = reduce_depth(t, depth, leaf, at, watch);
    join_lists(t, depth);
  }
  if (status == C2D_OK) status = keep_root(t, depth, leaf, from, sink, tapes, watch);
  if (status == C2D_OK && plan.keeps != 0) status = finish_block(t.kept);
  return status == C2D_OK ? finish_records(t) : status;
}

} // namespace c2d
