#pragma once
// What compressed elimination works with.
#include "bie/integrals/chosen.hpp"
#include "elimination/cells.hpp"
#include "elimination/compressed.hpp"
#include "elimination/far_sums.hpp"
#include "elimination/stream.hpp"
#include "linalg/interpolate.hpp"

namespace c2d {

constexpr double kCompressedTolerance = sizeof(Real) == sizeof(double) ? 1e-14 : 1e-6; // of what a cell leaves out
constexpr int32_t kProxies = sizeof(Real) == sizeof(double) ? 88 : 44;                 // points on the circle round a cell
constexpr double kProxyRadius = 2.0;                                                   // over that of the cell
constexpr int32_t kChunk = 64; // columns, or nodes, that are looked at together

// What a cell hands to the one it is part of; it stands in `numbers`.
struct CellResult {
  int32_t kept, rows, columns; // unknowns that are left; equations and unknowns that stand for the cell
  Real* d;                     // [kept * rows] transposed: its equations
  Real* v;                     // [kept * columns] transposed: what the columns have of the unknowns
  Real* b;                     // [rows * loads]
  Real* c;                     // [columns * loads]: what the columns have beside that
};

struct CompressedWork {
  // of the tree
  int32_t *order, *room;                   // [tree]
  int32_t *rows[2], *columns[2];           // [2 tree]: 2 node + component, of one depth and of the one below
  int32_t *row_begin[2], *column_begin[2]; // [cells + 1]
  double* circle;                          // [3 cells]: centre and radius of the cells of one depth
  double* reach;                           // [nodes]: from a node to the end of its elements
  int32_t *position, *stamp;               // [nodes] of the node in a list, -1: none; [nodes] of the elements
  int32_t* hole_at;                        // [nodes]: the hole a node is at, -1: none
  int32_t* place;                          // [columns + 2 contact], -1: none
  int32_t* border;                         // [nodes - tree]
  Hole* hole;                              // [holes]
  Real* right;                             // [(2 nodes + 3) * loads]: right-hand sides, the last of them noise
  // of a cell; n = 2 rank
  Real *d, *v, *e;                                  // [n * n], [n * n], [n * (n + rank)]
  Real *row_x, *column_x;                           // [n * (n + 2)]
  Real* samples;                                    // [(n + 32) * n]
  Real* block;                                      // block_numbers
  Real *b, *c, *g;                                  // [n * loads]
  Real *norms, *sample;                             // [2 n]
  Real* result[2];                                  // a CellResult's numbers
  int32_t *row_order, *column_order, *pivots, *ids; // [2 n]
  int32_t *sources, *elements, *twin, *list;        // [2 nodes + 2 kProxies]
  double* point;                                    // likewise, twice
  char *lower_buffer, *upper_buffer, *read_buffer;
  // of the border
  Real *root_d, *root_q, *root_c; // [n * n], [border rows * n], [border rows * loads]
  void* dense;                    // of eliminate()
  // of the right-hand sides
  void* sums_by_cells;
  // of what is kept for later right-hand sides
  Real *coupling[2], *sums, *whole; // [rank * rank], [border rows * n], [(n + border rows)^2]
  char* kept_buffer;
};
constexpr int64_t kLoadsBeside = 1; // right-hand sides beside the load cases: noise

int64_t block_numbers(const CompressedPlan& plan);
uint64_t lay_out_work(const CompressedPlan& plan, char* base, CompressedWork* out);
// Columns of the contact that the border has.
inline int32_t border_contact(const CompressedPlan& plan) { return plan.keeps != 0 ? 0 : plan.contact; }
inline int32_t most_dofs(const CompressedPlan& plan) { return 2 * plan.rank; }
inline int32_t right_sides(const CompressedPlan& plan) { return plan.loads + static_cast<int32_t>(kLoadsBeside); }
inline int32_t root_size(const CompressedPlan& plan) { return 2 * (plan.tree < plan.rank ? plan.tree : plan.rank); }
// The border's plan where the root has so many unknowns: it is no larger than it is, so that no sum depends on what is allowed.
inline EliminationPlan border_with(const CompressedPlan& plan, int32_t unknowns) {
  EliminationPlan out = plan.border;
  out.rows -= root_size(plan) - unknowns;
  out.pivots -= root_size(plan) - unknowns;
  cut_alike(plan.border, out);
  return out;
}
// Rows of the border: of its nodes, the balances, the holes.
inline int32_t border_rows(const CompressedPlan& plan) { return 2 * (plan.nodes - plan.tree) + 3 + plan.holes; }
// Of the displacements in the sums that hold motions.
inline double weight_of_motions(const CompressedPlan& plan) { return 1.0 / plan.nodes; }
int64_t result_numbers(const CompressedPlan& plan);
int64_t record_numbers(const CompressedPlan& plan);

// A node whose equations are looked at again when there is a solution, and behind it their right-hand sides: two for each load
// case. The first of the records.
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

// ---- what is kept for later right-hand sides (compressed_kept.cpp) ----------------------------------------------------

// A cell's own, cell after cell as they were eliminated: how its equations are combined, its factors, and what the columns of
// its halves have of each other's equations. Then that of the border. All of a plan that keeps it.
int64_t kept_numbers(int64_t unknowns); // of a cell with no more unknowns, at most
int64_t kept_of_border(const CompressedPlan& plan);
struct KeptPlace {
  uint64_t first_block, blocks;
};
KeptPlace kept_place(const CompressedPlan& plan); // on LOWER, behind all that compressed elimination writes there
inline int64_t cells_below_root(const CompressedPlan& plan) { return (int64_t{2} << tree_depth(plan.tree, plan.leaf)) - 2; }

// The records, to be read: what of them there is stands in a block of its own, before them. The stream's status tells what went
// wrong.
constexpr uint64_t kEndBytes = 64;
Stream open_records(const CompressedPlan& plan, Tapes& tapes, char* buffer, uint64_t* end);
Stream records_of(const CompressedPlan& plan, Tapes& tapes, char* buffer);

// The holes of a body, so many.
void list_holes(const ColumnSystem& system, int32_t count, Hole* out);

// A cell while it is worked on: its unknowns `ids`, in w.d (transposed) what its rows, in w.v what its columns have of them.
// The first of its rows and columns are those of its first half; a leaf has no halves.
struct TreeCell {
  int32_t unknowns, rows, columns;
  const int32_t *row_ids, *column_ids;
  int32_t half_rows, half_columns;
};
// What is left of it, in w.e: transposed, the `spare` equations that are the cell's own, then those that stand for it, then its
// columns.
struct Split {
  int32_t spare, rows, columns; // equations; equations and columns that stand for the cell
};

// A tree under way.
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
c2d_status keep_cell(Compression& t, const TreeCell& cell, const Split& s);
// The border's matrix, of `size` rows, stands in w.whole: it is factored.
c2d_status keep_border(Compression& t, const TreeCell& root, const int32_t* unknowns, int32_t size);

// ---- blocks of the equations (compressed_blocks.cpp) ----------------------------------------------------------------

inline int32_t column_of(const Compression& t, int32_t id) {
  return t.system.model.node_column[t.system.body][id / 2] + id % 2;
}
// visit(column) for the columns of a node: its unknowns and, if it makes a pair, what the contact brings.
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
// The nodes of these ids as sources, each once: how many. position[] tells where; forget_sources clears it.
int32_t list_sources(Compression& t, const int32_t* ids, int32_t count, int32_t* sources);
void forget_sources(Compression& t, const int32_t* sources, int32_t count);
// The elements at these nodes, each once.
int32_t list_elements(Compression& t, const int32_t* nodes, int32_t count, int32_t* elements);
// Entries of rows (ids) and columns (ids) in w.block: row i at 2 position[rows[i] / 2] + rows[i] % 2 of leading dimension
// *ld. The sources stay listed in w.sources: *sources of them.
void fill_block(Compression& t, const int32_t* rows, int32_t row_count, const int32_t* columns, int32_t column_count,
                int64_t* ld, int32_t* sources);
// Does a node's equation of this direction have integrals?
bool has_integrals(const Compression& t, int32_t node, int component);

// ---- what stands for a cell (compressed_basis.cpp) --------------------------------------------------------------------

// Cells of a depth, their equations and unknowns in w.rows[which], w.columns[which].
struct Depth {
  int32_t cells, which;
};
void place_circles(Compression& t, const Depth& depth);
// Rows of a cell of which the others are combinations, and unknowns: row_order, row_x; column_order, column_x. k as
// interpolate().
int32_t choose_rows(Compression& t, const Depth& depth, int32_t cell);
int32_t choose_columns(Compression& t, const Depth& depth, int32_t cell);

// ---- the border (compressed_border.cpp) -------------------------------------------------------------------------------

// With the root of the tree; w.ids, w.d, w.v, w.b, w.c are its own.
c2d_status eliminate_border(Compression& t, const TreeCell& root, const RowSink& sink, Tapes& tapes, const Watch& watch);

} // namespace c2d
