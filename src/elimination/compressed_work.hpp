#pragma once
// Work area and internal interfaces of compressed elimination (METHOD 7.6).
#include "bie/integrals/chosen.hpp"
#include "elimination/cells.hpp"
#include "elimination/compressed.hpp"
#include "elimination/far_sums.hpp"
#include "elimination/stream.hpp"
#include "linalg/interpolate.hpp"

namespace c2d {

constexpr double kCompressedTolerance = sizeof(Real) == sizeof(double) ? 1e-14 : 1e-6; // of the interpolation of a cluster
constexpr int32_t kProxies = sizeof(Real) == sizeof(double) ? 88 : 44;                 // points on the circle round a cluster
constexpr double kProxyRadius = 2.0;                                                   // times the cluster's own radius
constexpr int32_t kChunk = 64; // columns, or nodes, that are assembled together

// What a cluster passes to the cluster above it; it is stored in `numbers`.
struct ClusterResult {
  int32_t kept, rows, columns; // remaining unknowns; skeleton rows and columns
  Real* d;                     // [kept * rows] transposed: skeleton rows on the remaining unknowns
  Real* v;                     // [kept * columns] transposed: skeleton columns in terms of the remaining unknowns
  Real* b;                     // [rows * loads]
  Real* c;                     // [columns * loads]: the known part of the skeleton columns
};

struct CompressedWork {
  // of the tree
  int32_t *order, *room;                   // [tree]
  int32_t *rows[2], *columns[2];           // [2 tree]: 2 node + component, of this depth and of the depth below
  int32_t *row_begin[2], *column_begin[2]; // [clusters + 1]
  double* circle;                          // [3 clusters]: centre and radius of the clusters of one depth
  double* reach;                           // [nodes]: from a node to the end of its elements
  int32_t *position, *stamp;               // [nodes] place of a node in a list, -1: none; [nodes] of the elements
  int32_t* hole_at;                        // [nodes]: the hole to which a node belongs, -1: none
  int32_t* place;                          // [columns + 2 contact], -1: none
  int32_t* border;                         // [nodes - tree]
  Hole* hole;                              // [holes]
  Real* right;                             // [(2 nodes + 3) * loads]: right-hand sides, the last of them of random signs
  // of a cluster; n = 2 rank
  Real *d, *v, *e;                                  // [n * n], [n * n], [n * (n + rank)]
  Real *row_x, *column_x;                           // [n * (n + 2)]
  Real* samples;                                    // [(n + 32) * n]
  Real* block;                                      // block_numbers
  Real *b, *c, *g;                                  // [n * loads]
  Real *norms, *sample;                             // [2 n]
  Real* result[2];                                  // a ClusterResult's numbers
  int32_t *row_order, *column_order, *pivots, *ids; // [2 n]
  int32_t *sources, *elements, *twin, *list;        // [2 nodes + 2 kProxies]
  double* point;                                    // likewise, twice
  char *lower_buffer, *upper_buffer, *read_buffer;
  // of the border
  Real *root_d, *root_q, *root_c; // [n * n], [border rows * n], [border rows * loads]
  void* dense;                    // of eliminate()
  // of the right-hand sides
  void* sums_by_cells;
  // for additional right-hand sides
  Real *coupling[2], *sums, *whole; // [rank * rank], [border rows * n], [(n + border rows)^2]
  char* kept_buffer;
};
constexpr int64_t kLoadsBeside = 1; // right-hand sides besides the load cases: random signs

int64_t block_numbers(const CompressedPlan& plan);
uint64_t lay_out_work(const CompressedPlan& plan, char* base, CompressedWork* out);
// Columns of the contact in the border.
inline int32_t border_contact(const CompressedPlan& plan) { return plan.keeps != 0 ? 0 : plan.contact; }
inline int32_t most_dofs(const CompressedPlan& plan) { return 2 * plan.rank; }
inline int32_t right_sides(const CompressedPlan& plan) { return plan.loads + static_cast<int32_t>(kLoadsBeside); }
inline int32_t root_size(const CompressedPlan& plan) { return 2 * (plan.tree < plan.rank ? plan.tree : plan.rank); }
// The border's plan for a root of so many unknowns. The border is as large as it must be, so no sum depends on the rank
// allowed.
inline EliminationPlan border_with(const CompressedPlan& plan, int32_t unknowns) {
  EliminationPlan out = plan.border;
  out.rows -= root_size(plan) - unknowns;
  out.pivots -= root_size(plan) - unknowns;
  cut_alike(plan.border, out);
  return out;
}
// Rows of the border: of its nodes, the balances, the holes.
inline int32_t border_rows(const CompressedPlan& plan) { return 2 * (plan.nodes - plan.tree) + 3 + plan.holes; }
// Weight of the displacements in the sums that fix rigid-body modes.
inline double weight_of_modes(const CompressedPlan& plan) { return 1.0 / plan.nodes; }
int64_t result_numbers(const CompressedPlan& plan);
int64_t record_numbers(const CompressedPlan& plan);

// A node whose equations are assembled again when there is a solution. Its right-hand sides follow: two for each load case.
// The samples are the first of the records.
struct CheckedNode {
  int32_t node, twin, hole;
  double point[2], diagonal[4];
};
constexpr int32_t kCheckedNodes = 32;
inline int32_t sample_count(const CompressedPlan& plan) { return plan.nodes < kCheckedNodes ? plan.nodes : kCheckedNodes; }
inline uint64_t sample_bytes(const CompressedPlan& plan) {
  const uint64_t each = sizeof(CheckedNode) + 2 * static_cast<uint64_t>(plan.loads) * sizeof(Real);
  return static_cast<uint64_t>(sample_count(plan)) * each;
}

// ---- data for additional right-hand sides (compressed_kept.cpp) -------------------------------------------------------

// Cluster after cluster, in the order of elimination: the combination of its equations, its factors, and the coupling of its
// halves. The border comes last. Only plans with `keeps` store it.
int64_t kept_numbers(int64_t unknowns); // of a cluster with at most so many unknowns
int64_t kept_of_border(const CompressedPlan& plan);
struct KeptPlace {
  uint64_t first_block, blocks;
};
KeptPlace kept_place(const CompressedPlan& plan); // on LOWER, behind everything else that compressed elimination writes there
inline int64_t clusters_below_root(const CompressedPlan& plan) { return (int64_t{2} << tree_depth(plan.tree, plan.leaf)) - 2; }

// Opens the records for reading. Their total length is in a block of its own before them. The stream's status is the error.
constexpr uint64_t kEndBytes = 64;
Stream open_records(const CompressedPlan& plan, Tapes& tapes, char* buffer, uint64_t* end);
Stream records_of(const CompressedPlan& plan, Tapes& tapes, char* buffer);

// Lists the `count` holes of a body.
void list_holes(const ColumnSystem& system, int32_t count, Hole* out);

// A cluster during its elimination: its unknowns `ids`, its rows in w.d and its columns in w.v, both transposed. Rows and
// columns of the first half come first. A leaf has no halves.
struct TreeCluster {
  int32_t unknowns, rows, columns;
  const int32_t *row_ids, *column_ids;
  int32_t half_rows, half_columns;
};
// The cluster after the split, in w.e, transposed: `spare` own equations, then the skeleton rows, then the skeleton columns.
struct Split {
  int32_t spare, rows, columns; // own equations; skeleton rows and columns
};

// An elimination in progress.
struct Compression {
  const CompressedPlan& plan;
  const ColumnSystem& system;
  CompressedWork w;
  Engine engine;
  int32_t depth;
  int32_t tick; // of stamps
  CompressedStats* stats;
  PivotStats* pivots;
  Stream lower, upper, read, kept;
};

// (compressed_kept.cpp)
c2d_status keep_cluster(Compression& t, const TreeCluster& cluster, const Split& s);
// The border's matrix, of `size` rows, is in w.whole; it is factored there.
c2d_status keep_border(Compression& t, const TreeCluster& root, const int32_t* unknowns, int32_t size);

// ---- blocks of the equations (compressed_blocks.cpp) ----------------------------------------------------------------

inline int32_t column_of(const Compression& t, int32_t id) {
  return t.system.model.node_column[t.system.body][id / 2] + id % 2;
}
// visit(column) for the columns of a node: its own unknowns and, if it belongs to a pair, its contact columns.
template <class Visit> void visit_columns(const CompressedPlan& plan, const Model& m, int b, int32_t node, Visit visit) {
  for (int32_t j = m.node_column[b][node]; j < m.node_column[b][node + 1]; ++j) visit(j);
  const PairSide at = pair_of_node(m, b, node);
  if (at.pair < 0) return;
  const int32_t first = plan.columns + dof_on(m, m.pair[at.pair], at.side);
  for (int32_t k = 0; k <= m.pair[at.pair].tangential; ++k) {
    visit(first + k);
    visit(first + k + plan.contact);
  }
}
// Lists the nodes of these ids as sources, each once, and returns how many. position[] gives their places; clear_sources()
// clears it.
int32_t list_sources(Compression& t, const int32_t* ids, int32_t count, int32_t* sources);
void clear_sources(Compression& t, const int32_t* sources, int32_t count);
// The elements at these nodes, each once.
int32_t list_elements(Compression& t, const int32_t* nodes, int32_t count, int32_t* elements);
// Entries of rows (ids) and columns (ids) in w.block: row i at 2 position[rows[i] / 2] + rows[i] % 2, leading dimension *ld.
// The *sources sources stay listed in w.sources.
void fill_block(Compression& t, const int32_t* rows, int32_t row_count, const int32_t* columns, int32_t column_count,
                int64_t* ld, int32_t* sources);
// Does a node's equation of this direction contain integrals?
bool has_integrals(const Compression& t, int32_t node, int component);

// ---- skeletons (compressed_basis.cpp) ---------------------------------------------------------------------------------

// Clusters of a depth, their candidate rows and columns in w.rows[which], w.columns[which].
struct Depth {
  int32_t clusters, which;
};
void place_circles(Compression& t, const Depth& depth);
// Chooses skeleton rows and columns of a cluster: row_order, row_x; column_order, column_x. Returns k as interpolate().
int32_t choose_rows(Compression& t, const Depth& depth, int32_t cluster);
int32_t choose_columns(Compression& t, const Depth& depth, int32_t cluster);

// ---- the border (compressed_border.cpp) -------------------------------------------------------------------------------

// Solves the border with the root of the tree, which is in w.ids, w.d, w.v, w.b, w.c.
c2d_status eliminate_border(Compression& t, const TreeCluster& root, const RowSink& sink, Tapes& tapes, const Watch& watch);

} // namespace c2d
