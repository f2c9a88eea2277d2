// Additional right-hand sides for a body that compressed elimination has already factored: unit tractions at contact nodes
// (lazy columns of the contact system), rigid-body modes, and sums of all tractions (METHOD 10.12).
//
// Phases, with up to kMostSides right-hand sides stored side by side:
// 1. Assemble: columns of G at all equations, and in the sums over the boundary (balances, holes).
// 2. Up the tree, cluster by cluster in the order of their elimination: couple the halves, split off the own equations, apply
//    U^-T and L_1^-T, reduce the skeleton rows and columns.
// 3. Border: one dense solve with the stored LU factors.
// 4. Down the tree (compressed_back.cpp): x_1 = h - M x_2 in each cluster, with the h of phase 2.
// The equations are those of compressed.cpp, METHOD (7.3) and (7.4), with b only: the factors do not change. A right-hand side
// costs as much as reading the factors, O(n). Many at once make it a matrix product instead of a memory-bound vector
// operation.
// Literature: Golub and Van Loan, Matrix Computations, section 3.1 (triangular systems with many right-hand sides).
#include "elimination/later_sides.hpp"

#include <string.h>

#include "linalg/dense.hpp"
#include "linalg/lu.hpp"
#include "memory/sizes.hpp"

namespace c2d {

namespace {

// Right-hand sides lie side by side: `count` numbers for each equation, column and unknown. Gathered for one cluster they form
// a matrix with `count` rows, whose columns are equations or unknowns.
struct SidesWork {
  Real *b, *c; // [2 nodes * count] by equation; by column, the part that does not depend on the cluster's unknowns
  Real* x;     // [columns * count]; before that the right-hand sides as assembled
  Real *own, *sums, *beside;   // [count * n], [count * border rows], [count * n] of a cluster
  Real *matrix, *right, *room; // [(n + border rows)^2], [(n + border rows) * count], sides_room()
  int32_t* ids;                // [4 n + 2 (n + border rows)] of a cluster, or of the border
  int32_t *place, *elements, *nodes;
  Hole* hole;
  char* buffer;
  void* back; // compressed_back_bytes
};

uint64_t lay_out_sides(const CompressedPlan& plan, char* base, SidesWork* out) {
  SidesWork w{};
  AreaCarver area{base};
  const uint64_t nodes = static_cast<uint64_t>(plan.nodes), columns = static_cast<uint64_t>(plan.columns);
  const uint64_t n = static_cast<uint64_t>(most_dofs(plan)), rows = static_cast<uint64_t>(border_rows(plan));
  const uint64_t sides = static_cast<uint64_t>(kMostSides), border = n + rows;
  area.take(w.b, 2 * nodes * sides);
  area.take(w.c, 2 * nodes * sides);
  area.take(w.x, columns * sides);
  area.take(w.own, n * sides);
  area.take(w.sums, rows * sides);
  area.take(w.beside, n * sides);
  area.take(w.matrix, border * border);
  area.take(w.right, border * sides);
  area.take(w.room, static_cast<uint64_t>(sides_room(plan)));
  area.take(w.ids, 4 * n + 2 * border);
  area.take(w.place, columns + 2 * static_cast<uint64_t>(plan.contact));
  area.take(w.elements, 2 * sides);
  area.take(w.nodes, nodes);
  area.take(w.hole, static_cast<uint64_t>(plan.holes));
  area.take(w.buffer, kBlockHeaderBytes + plan.block_bytes);
  char* back = nullptr;
  area.take(back, compressed_back_bytes(plan));
  w.back = back;
  if (out) *out = w;
  return area.total();
}

struct Sides {
  const LaterSides& s;
  SidesWork w;
  int32_t count;
  Stream kept;
  uint64_t at;
};

// ---- right-hand sides ------------------------------------------------------------------------------------------------------

// Elements at the nodes where a unit traction acts, each once. There are few, so the list is searched linearly.
int32_t list_loaded(const Sides& t) {
  const Model& m = t.s.system.model;
  const int b = t.s.system.body;
  const int32_t* const place = t.w.place + t.s.plan.columns + t.s.plan.contact;
  int32_t listed = 0;
  for (int32_t node = 0; node < t.s.plan.nodes; ++node) {
    const PairSide at = pair_of_node(m, b, node);
    if (at.pair < 0) continue;
    const int32_t first = dof_on(m, m.pair[at.pair], at.side);
    int32_t ends[2];
    const bool loaded = place[first] >= 0 || (m.pair[at.pair].tangential != 0 && place[first + 1] >= 0);
    const int found = loaded ? ends_at_node(m, b, node, ends) : 0;
    for (int k = 0; k < found; ++k) {
      const int32_t element = ends[k] / m.head->function_nodes;
      bool known = false;
      for (int32_t i = 0; i < listed && !known; ++i) known = t.w.elements[i] == element;
      if (!known) t.w.elements[listed++] = element;
    }
  }
  return listed;
}

// Columns of G for these contact unknowns. By column in w.x: the equations at the nodes. In w.right: the balances and the rows
// of the holes.
void assemble(const Sides& t, const int32_t* unknown, int32_t count) {
  const SidesWork& w = t.w;
  const CompressedPlan& plan = t.s.plan;
  const int32_t first = plan.columns + plan.contact, rows = border_rows(plan);
  for (int32_t k = 0; k < count; ++k) w.place[first + unknown[k]] = k;
  // Only elements at the loaded nodes contribute: the cost is n per column, not n^2.
  const ChosenColumns columns{w.place, count, w.elements, list_loaded(t)};
  ColumnSystem all = t.s.system;
  all.chosen = w.nodes;
  all.sources = plan.nodes;
  fill_tractions(all, columns, w.x, 2 * static_cast<int64_t>(plan.nodes));
  fill_sums(t.s.system, columns, weight_of_modes(plan), w.right, rows);
  for (int32_t i = 0; i < plan.holes; ++i) fill_hole_row(t.s.system, w.hole[i], columns, w.right + 3 + i, rows);
  for (int32_t k = 0; k < count; ++k) w.place[first + unknown[k]] = -1;
}

Sides begin_sides(const LaterSides& s, int32_t count) {
  Sides t{s, {}, count, {}, 0};
  lay_out_sides(s.plan, static_cast<char*>(s.work), &t.w);
  const KeptPlace place = kept_place(s.plan);
  t.kept = open_stream(s.tapes, C2D_TAPE_LOWER, place.first_block, place.blocks, s.plan.block_bytes, t.w.buffer);
  for (int32_t j = 0; j < s.plan.columns + 2 * s.plan.contact; ++j) t.w.place[j] = -1;
  for (int32_t i = 0; i < s.plan.nodes; ++i) t.w.nodes[i] = i;
  list_holes(s.system, s.plan.holes, t.w.hole);
  return t;
}

// Transposes the assembled columns to side-by-side order, in tiles: a whole row would touch `count` distant pages.
void place_sides(const Sides& t) {
  const int64_t rows = 2 * static_cast<int64_t>(t.s.plan.nodes);
  constexpr int64_t kTile = 16;
  for (int64_t top = 0; top < rows; top += kTile)
    for (int32_t k = 0; k < t.count; ++k)
      for (int64_t i = top; i < top + kTile && i < rows; ++i) t.w.b[i * t.count + k] = t.w.x[i + k * rows];
}

// ---- up the tree ---------------------------------------------------------------------------------------------------------

// Lists of a stored cluster, in w.ids. Its matrices follow on the tape one after another and are read into w.matrix when they
// are needed, so only one of them is in memory.
struct SideCluster {
  KeptCluster of;
  const int32_t *row_ids, *column_ids, *row_order, *column_order, *unknowns;
  int32_t all_rows() const { return of.spare + of.rows; }
  int32_t all_columns() const { return of.columns + of.rest; }
};

// Reads a list of indices. Each index addresses an array, so a value out of range ends the solution.
const int32_t* next_ids(Sides& t, int32_t*& to, int32_t count, int32_t end) {
  int32_t* const ids = to;
  to += count;
  read_at(t.kept, t.at, ids, static_cast<uint64_t>(count) * sizeof(int32_t));
  t.at += static_cast<uint64_t>(count) * sizeof(int32_t);
  for (int32_t i = 0; i < count && t.kept.status == C2D_OK; ++i)
    if (ids[i] < 0 || ids[i] >= end) t.kept.status = C2D_ERR_INTERNAL;
  return ids;
}

const Real* next_numbers(Sides& t, int64_t count) {
  read_at(t.kept, t.at, t.w.matrix, static_cast<uint64_t>(count) * sizeof(Real));
  t.at += static_cast<uint64_t>(count) * sizeof(Real);
  return t.w.matrix;
}

// Counts address memory. They are checked, because the record may come from a store that another program wrote.
bool read_counts(Sides& t, KeptCluster& out) {
  if (read_at(t.kept, t.at, &out, sizeof out) != C2D_OK) return false;
  t.at += sizeof out;
  const int32_t least[] = {out.spare, out.rows, out.columns, out.rest}, most = most_dofs(t.s.plan);
  for (int32_t count : least)
    if (count < 0 || count > most + border_rows(t.s.plan)) return false;
  return true;
}

bool fits(const SideCluster& cluster, int32_t rows, int32_t columns, int32_t most) {
  const KeptCluster& c = cluster.of;
  return rows <= most && columns <= most && c.half_rows >= -1 && c.half_rows <= rows && c.half_columns >= 0 &&
         c.half_columns <= columns;
}

bool read_cluster(Sides& t, SideCluster& cluster) {
  if (!read_counts(t, cluster.of) || !fits(cluster, cluster.all_rows(), cluster.all_columns(), most_dofs(t.s.plan)))
    return false;
  int32_t* to = t.w.ids;
  const int32_t dofs = 2 * t.s.plan.nodes;
  cluster.row_ids = next_ids(t, to, cluster.all_rows(), dofs);
  cluster.column_ids = next_ids(t, to, cluster.all_columns(), dofs);
  cluster.row_order = next_ids(t, to, cluster.all_rows(), cluster.all_rows());
  cluster.column_order = next_ids(t, to, cluster.all_columns(), cluster.all_columns());
  cluster.unknowns = next_ids(t, to, cluster.of.spare, t.s.plan.columns);
  return t.kept.status == C2D_OK;
}

// Copies the listed equations or columns side by side, and back. order: null if the list is in sequence.
void gather(const Sides& t, const Real* from, int32_t count, const int32_t* ids, const int32_t* order, Real* to) {
  for (int32_t i = 0; i < count; ++i)
    memcpy(to + static_cast<int64_t>(i) * t.count, from + static_cast<int64_t>(ids[order ? order[i] : i]) * t.count,
           static_cast<size_t>(t.count) * sizeof(Real));
}
void scatter(const Sides& t, const Real* from, int32_t count, const int32_t* ids, const int32_t* order, Real* to) {
  for (int32_t i = 0; i < count; ++i)
    memcpy(to + static_cast<int64_t>(ids[order ? order[i] : i]) * t.count, from + static_cast<int64_t>(i) * t.count,
           static_cast<size_t>(t.count) * sizeof(Real));
}

// Coupling of the halves: b_1 -= A(S_1, C_2) c_2 and b_2 -= A(S_2, C_1) c_1. c is the part of the skeleton columns that the
// right-hand side has already determined.
void couple_halves(Sides& t, const SideCluster& cluster, int32_t rows, int32_t columns) {
  if (cluster.of.half_rows < 0) return;
  const int32_t first_rows = cluster.of.half_rows, first_columns = cluster.of.half_columns;
  const struct {
    int32_t row, rows, column, columns;
  } blocks[] = {{0, first_rows, first_columns, columns - first_columns}, {first_rows, rows - first_rows, 0, first_columns}};
  const SidesWork& w = t.w;
  gather(t, w.c, columns, cluster.column_ids, nullptr, w.beside);
  gather(t, w.b, rows, cluster.row_ids, nullptr, w.own);
  for (const auto& b : blocks) {
    const Real* const by = next_numbers(t, static_cast<int64_t>(b.rows) * b.columns);
    gemm_minus(t.s.engine, t.count, b.rows, b.columns, w.beside + static_cast<int64_t>(b.column) * t.count, t.count, by,
               b.columns, w.own + static_cast<int64_t>(b.row) * t.count, t.count);
  }
  scatter(t, w.own, rows, cluster.row_ids, nullptr, w.b);
}

// X (rows x n) := X U^-1, and X L^-1, with U and L in a square of leading dimension n. Blocks of kSolveWidth columns: the
// matrix product does most of the work, the short loops only the diagonal blocks.
constexpr int32_t kSolveWidth = 16;
void divide_upper(const Engine& engine, int32_t rows, int32_t n, const Real* u, Real* x) {
  for (int32_t first = 0; first < n; first += kSolveWidth) {
    const int32_t end = first + kSolveWidth < n ? first + kSolveWidth : n;
    Real* const block = x + static_cast<int64_t>(first) * rows;
    gemm_minus(engine, rows, end - first, first, x, rows, u + static_cast<int64_t>(first) * n, n, block, rows);
    for (int32_t j = first; j < end; ++j) {
      const Real* const column = u + static_cast<int64_t>(j) * n;
      Real* const to = x + static_cast<int64_t>(j) * rows;
      for (int32_t i = first; i < j; ++i)
        for (int32_t k = 0; k < rows; ++k) to[k] -= column[i] * x[static_cast<int64_t>(i) * rows + k];
      for (int32_t k = 0; k < rows; ++k) to[k] /= column[j];
    }
  }
}
void divide_lower(const Engine& engine, int32_t rows, int32_t n, const Real* l, Real* x) {
  for (int32_t end = n; end > 0; end = end > kSolveWidth ? end - kSolveWidth : 0) {
    const int32_t first = end > kSolveWidth ? end - kSolveWidth : 0;
    gemm_minus(engine, rows, end - first, n - end, x + static_cast<int64_t>(end) * rows, rows,
               l + static_cast<int64_t>(first) * n + end, n, x + static_cast<int64_t>(first) * rows, rows);
    for (int32_t j = end - 1; j >= first; --j) {
      Real* const to = x + static_cast<int64_t>(j) * rows;
      for (int32_t i = j + 1; i < end; ++i) {
        const Real by = l[static_cast<int64_t>(j) * n + i];
        for (int32_t k = 0; k < rows; ++k) to[k] -= by * x[static_cast<int64_t>(i) * rows + k];
      }
    }
  }
}

// One cluster, as eliminate_cluster() does it for the first right-hand sides. Own equations: g = b_R - X^T b_S, then h =
// L_1^-T U^-T g. Skeleton rows: reduced by what x_1 contributes. Skeleton columns: c = Z c plus the contribution of x_1.
void carry_cluster(Sides& t, const SideCluster& cluster) {
  const SidesWork& w = t.w;
  const Engine& engine = t.s.engine;
  const KeptCluster& c = cluster.of;
  const int32_t count = t.count;
  couple_halves(t, cluster, cluster.all_rows(), cluster.all_columns());
  // Own equations: b_R - X^T b_S. X is stored as it is, since a product subtracts.
  Real *const standing = w.own, *const spare = standing + static_cast<int64_t>(c.rows) * count;
  gather(t, w.b, cluster.all_rows(), cluster.row_ids, cluster.row_order, standing);
  gemm_minus(engine, count, c.spare, c.rows, standing, count, next_numbers(t, static_cast<int64_t>(c.rows) * c.spare), c.rows,
             spare, count);
  // Skeleton columns: c_C + X c_rest. Here -X^T is stored, since a product subtracts.
  Real *const kept = w.beside, *const others = kept + static_cast<int64_t>(c.columns) * count;
  gather(t, w.c, cluster.all_columns(), cluster.column_ids, cluster.column_order, kept);
  gemm_minus(engine, count, c.columns, c.rest, others, count, next_numbers(t, static_cast<int64_t>(c.rest) * c.columns), c.rest,
             kept, count);
  // L and U of the own equations, and the updated skeleton rows behind them.
  const Real* const factors = next_numbers(t, static_cast<int64_t>(c.spare) * (c.spare + c.rows));
  divide_upper(engine, count, c.spare, factors, spare);
  gemm_minus(engine, count, c.rows, c.spare, spare, count, factors + static_cast<int64_t>(c.spare) * c.spare, c.spare, standing,
             count);
  scatter(t, standing, c.rows, cluster.row_ids, cluster.row_order, w.b);
  // The columns need U^-T g, the solution L_1^-T U^-T g: keep a copy of the former.
  memcpy(w.room, spare, static_cast<size_t>(c.spare) * static_cast<size_t>(count) * sizeof(Real));
  divide_lower(engine, count, c.spare, factors, spare);
  // x contains h now; carry_down() subtracts M x_2 when the unknowns that remain are known.
  scatter(t, spare, c.spare, cluster.unknowns, nullptr, w.x);
  gemm_minus(engine, count, c.columns, c.spare, w.room, count, next_numbers(t, static_cast<int64_t>(c.spare) * c.columns),
             c.spare, kept, count);
  scatter(t, kept, c.columns, cluster.column_ids, cluster.column_order, w.c);
}

// ---- the border -----------------------------------------------------------------------------------------------------------

// Dense solve of the root with the sums over the boundary. w.sums: right-hand sides of the balances and holes. The solution is
// written to its places in w.x.
bool solve_border(Sides& t) {
  const SidesWork& w = t.w;
  SideCluster root;
  const int32_t sums = border_rows(t.s.plan), most = most_dofs(t.s.plan), count = t.count;
  if (!read_counts(t, root.of)) return false;
  const int32_t size = root.of.spare, rows = root.of.rows, columns = root.of.columns;
  if (!fits(root, rows, columns, most) || root.of.rest != sums || size != rows + sums) return false;
  int32_t* to = w.ids;
  root.row_ids = next_ids(t, to, rows, 2 * t.s.plan.nodes);
  root.column_ids = next_ids(t, to, columns, 2 * t.s.plan.nodes);
  const int32_t* const unknowns = next_ids(t, to, rows + 3, t.s.plan.columns);
  const int32_t* const pivots = next_ids(t, to, size, size);
  if (t.kept.status != C2D_OK) return false;
  // The sums run over all displacements and tractions, so the part of the root's columns that is already known moves to the
  // right.
  couple_halves(t, root, rows, columns);
  gather(t, w.c, columns, root.column_ids, nullptr, w.beside);
  gather(t, w.b, rows, root.row_ids, nullptr, w.own);
  gemm_minus(t.s.engine, count, sums, columns, w.beside, count, next_numbers(t, static_cast<int64_t>(columns) * sums), columns,
             w.sums, count);
  for (int32_t k = 0; k < count; ++k) {
    Real* const right = w.right + static_cast<int64_t>(k) * size;
    for (int32_t i = 0; i < rows; ++i) right[i] = w.own[static_cast<int64_t>(i) * count + k];
    for (int32_t i = 0; i < sums; ++i) right[rows + i] = w.sums[static_cast<int64_t>(i) * count + k];
  }
  const Real* const factors = next_numbers(t, static_cast<int64_t>(size) * size);
  if (t.kept.status != C2D_OK) return false;
  lu_solve(t.s.engine, size, count, factors, size, pivots, w.right, size);
  for (int32_t i = 0; i < rows + 3; ++i)
    for (int32_t k = 0; k < count; ++k)
      w.x[static_cast<int64_t>(unknowns[i]) * count + k] = w.right[i + static_cast<int64_t>(k) * size];
  return true;
}

c2d_status solve_sides(Sides& t) {
  const SidesWork& w = t.w;
  for (int64_t i = 0; i < 2 * static_cast<int64_t>(t.s.plan.nodes) * t.count; ++i) w.c[i] = 0;
  for (int64_t i = 0, clusters = clusters_below_root(t.s.plan); i < clusters; ++i) {
    SideCluster cluster;
    if (!read_cluster(t, cluster)) return t.kept.status != C2D_OK ? t.kept.status : c2d_status{C2D_ERR_INTERNAL};
    carry_cluster(t, cluster);
  }
  if (!solve_border(t)) return t.kept.status != C2D_OK ? t.kept.status : c2d_status{C2D_ERR_INTERNAL};
  return carry_down(t.s.plan, t.s.tapes, t.s.engine, t.count, w.x, w.room, w.back);
}

} // namespace

uint64_t later_sides_bytes(const CompressedPlan& plan) { return lay_out_sides(plan, nullptr, nullptr); }

c2d_status solve_unit_tractions(const LaterSides& s, const int32_t* unknown, int32_t count, Real** x) {
  Sides t = begin_sides(s, count);
  assemble(t, unknown, count);
  place_sides(t);
  const int32_t rows = border_rows(s.plan);
  for (int32_t i = 0; i < rows; ++i)
    for (int32_t k = 0; k < count; ++k)
      t.w.sums[static_cast<int64_t>(i) * count + k] = t.w.right[i + static_cast<int64_t>(k) * rows];
  *x = t.w.x;
  return solve_sides(t);
}

c2d_status solve_motions(const LaterSides& s, Real** x) {
  // Right-hand side k: the sum that fixes rigid-body mode k equals 1, everything else 0.
  const int32_t count = motions_held(s.system.model, s.system.body), rows = border_rows(s.plan);
  Sides t = begin_sides(s, count);
  for (int64_t i = 0; i < 2 * static_cast<int64_t>(s.plan.nodes) * count; ++i) t.w.b[i] = 0;
  for (int32_t i = 0; i < rows * count; ++i) t.w.sums[i] = 0;
  for (int32_t k = 0; k < count; ++k) t.w.sums[k * count + k] = 1;
  *x = t.w.x;
  return solve_sides(t);
}

c2d_status add_tractions(const LaterSides& s, const Real* traction, Real* x) {
  Sides t = begin_sides(s, 1);
  const SidesWork& w = t.w;
  const int32_t rows = border_rows(s.plan), nodes = 2 * s.plan.nodes;
  for (int32_t i = 0; i < nodes; ++i) w.b[i] = 0;
  for (int32_t i = 0; i < rows; ++i) w.sums[i] = 0;
  // The tractions are known, so their columns are summed into one right-hand side before the tree is passed once. They are
  // assembled in groups that fit into the work area.
  for (int32_t next = 0; next < s.plan.contact;) {
    int32_t count = 0, unknown[kMostSides];
    for (; next < s.plan.contact && count < kMostSides; ++next)
      if (traction[next] != 0) unknown[count++] = next;
    if (count == 0) break;
    assemble(t, unknown, count);
    for (int32_t k = 0; k < count; ++k) {
      const Real by = traction[unknown[k]];
      for (int32_t i = 0; i < nodes; ++i) w.b[i] += by * w.x[i + static_cast<int64_t>(k) * nodes];
      for (int32_t i = 0; i < rows; ++i) w.sums[i] += by * w.right[i + k * rows];
    }
  }
  const c2d_status status = solve_sides(t);
  for (int32_t j = 0; j < s.plan.columns && status == C2D_OK; ++j) x[j] += w.x[j];
  return status;
}

} // namespace c2d
