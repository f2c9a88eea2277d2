// Plan, work area and tape use of compressed elimination (METHOD 7.6).
//
// All sizes follow from the plan alone, before anything is assembled:
// 1. A cluster keeps at most `rank` rows and columns, so its matrices have at most 2 rank unknowns.
// 2. lay_out_work() computes the work area. Phases that never overlap share memory: sums over all elements, then the tree,
//    then the dense border.
// 3. numbers_of_clusters() adds the data of all clusters, n = min(leaf, rank) doubling upwards: this bounds both tapes.
// Cost: O(n rank^2) operations and O(n rank) numbers for n nodes, as for any nested factorisation of this kind (Martinsson,
// Fast Direct Solvers for Elliptic PDEs, SIAM 2019).
#include "elimination/compressed_work.hpp"
#include "elimination/cells.hpp"
#include "memory/hostile.hpp"
#include "memory/sizes.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(HolePart);

namespace {

constexpr uint64_t kStreamBytes = 131072; // data in a block, unless a column of the border is longer

int32_t smaller(int32_t a, int32_t b) { return a < b ? a : b; }

uint64_t clusters_of(const CompressedPlan& plan) { return uint64_t{1} << tree_depth(plan.tree, plan.leaf); }

} // namespace

int64_t block_numbers(const CompressedPlan& plan) {
  // The largest block assembled at once: a cluster with its proxies or a chunk, or a few columns of the border.
  constexpr int64_t kLeast = 2 * (kProxies > kChunk ? kProxies : kChunk);
  const int64_t n = most_dofs(plan);
  const int64_t cluster = 2 * (n > kLeast ? n : kLeast) * n, border = 4 * (2 * n + border_rows(plan));
  return cluster > border ? cluster : border;
}

// Size of a cluster's result, and of its record for back substitution. The last terms are identities and counts.
int64_t result_numbers(const CompressedPlan& plan) {
  const int64_t k = plan.rank;
  return 2 * k * k + 2 * k * right_sides(plan) + k + 8;
}
int64_t record_numbers(const CompressedPlan& plan) {
  const int64_t k = plan.rank, n = 2 * k;
  return n * n / 4 + n * right_sides(plan) + n + 8;
}

uint64_t lay_out_work(const CompressedPlan& plan, char* base, CompressedWork* out) {
  CompressedWork w{};
  AreaCarver area{base};
  const uint64_t nodes = static_cast<uint64_t>(plan.nodes), tree = static_cast<uint64_t>(plan.tree);
  const uint64_t n = static_cast<uint64_t>(most_dofs(plan)), k = n / 2, loads = static_cast<uint64_t>(right_sides(plan));
  const uint64_t clusters = clusters_of(plan), border = static_cast<uint64_t>(border_rows(plan));
  const uint64_t listed = 2 * nodes + 2 * static_cast<uint64_t>(kProxies);
  area.take(w.root_d, n * n);
  area.take(w.root_q, border * n);
  area.take(w.root_c, (border + n) * loads);
  area.take(w.border, nodes - tree);
  area.take(w.hole, static_cast<uint64_t>(plan.holes));
  area.take(w.right, (2 * nodes + 3) * loads);
  area.take(w.position, nodes);
  area.take(w.stamp, nodes);
  area.take(w.hole_at, nodes);
  area.take(w.place, static_cast<uint64_t>(plan.columns) + 2 * static_cast<uint64_t>(plan.contact));
  area.take(w.ids, 2 * n);
  area.take(w.block, static_cast<uint64_t>(block_numbers(plan)));
  int32_t** const lists[] = {&w.sources, &w.elements, &w.twin, &w.list};
  for (int32_t** list : lists) area.take(*list, listed);
  area.take(w.point, 2 * listed);
  for (int i = 0; i < 2; ++i) {
    area.take(w.rows[i], 2 * tree);
    area.take(w.columns[i], 2 * tree);
    area.take(w.row_begin[i], clusters + 1);
    area.take(w.column_begin[i], clusters + 1);
  }
  area.take(w.upper_buffer, kBlockHeaderBytes + plan.block_bytes);
  if (plan.keeps != 0) {
    for (Real*& coupling : w.coupling) area.take(coupling, k * k);
    area.take(w.sums, border * n);
    area.take(w.whole, (n + border) * (n + border));
    area.take(w.kept_buffer, kBlockHeaderBytes + plan.block_bytes);
  }
  // What follows belongs to the tree. When the tree is done, the work area of eliminate() for the border starts here.
  const uint64_t behind = area.carver.used;
  area.take(w.order, tree);
  area.take(w.room, tree);
  area.take(w.circle, 3 * clusters);
  area.take(w.reach, nodes);
  // The sums over all elements are computed before any cluster, so they use the memory of the clusters.
  AreaCarver far = area;
  char* room_of_sums = nullptr;
  far.take(room_of_sums, far_sums_bytes(plan.nodes, plan.loads));
  w.sums_by_cells = room_of_sums;
  far.carver.align();
  area.take(w.d, n * n);
  area.take(w.v, n * n);
  area.take(w.e, n * (n + k));
  area.take(w.row_x, n * (n + 2));
  area.take(w.column_x, n * (n + 2));
  area.take(w.samples, (n + 32) * n);
  area.take(w.b, n * loads);
  area.take(w.c, n * loads);
  area.take(w.g, n * loads);
  area.take(w.norms, 2 * n);
  area.take(w.sample, 2 * n);
  for (Real*& result : w.result) area.take(result, static_cast<uint64_t>(result_numbers(plan)));
  int32_t** const orders[] = {&w.row_order, &w.column_order, &w.pivots};
  for (int32_t** order : orders) area.take(*order, 2 * n + 2 * static_cast<uint64_t>(kChunk));
  area.take(w.lower_buffer, kBlockHeaderBytes + plan.block_bytes);
  area.take(w.read_buffer, kBlockHeaderBytes + plan.block_bytes);
  area.carver.align();
  AreaCarver dense{base};
  dense.carver.used = behind;
  char* room = nullptr;
  dense.take(room, elimination_bytes(plan.border));
  w.dense = room;
  dense.carver.align();
  if (!area.carver.fits || !dense.carver.fits || !far.carver.fits) return UINT64_MAX;
  if (out) *out = w;
  const uint64_t most = area.carver.used > dense.carver.used ? area.carver.used : dense.carver.used;
  return most > far.carver.used ? most : far.carver.used;
}

uint64_t compressed_bytes(const CompressedPlan& plan) { return lay_out_work(plan, nullptr, nullptr); }

bool is_tree_node(const Model& m, int b, int32_t node) {
  // A node outside the contact has two unknowns of its own. With lazy columns the contact nodes are in the tree as well: their
  // tractions come as additional right-hand sides.
  const bool inside = m.body[b].on_demand != 0 || pair_of_node(m, b, node).pair < 0;
  C2D_ASSERT(!inside || m.node_column[b][node + 1] - m.node_column[b][node] == 2);
  return inside;
}

namespace {

// Nodes of the body that belong to contact pairs. Every other node has two unknowns of its own.
int32_t touching_nodes(const Model& m, int b) {
  int32_t count = 0;
  for (int32_t i = 0; i < m.head->zones; ++i)
    for (int side = m.zone[i].is_free != 0 ? 1 : 0; side < 2; ++side) count += m.zone[i].body[side] == b ? m.zone[i].pairs : 0;
  return count;
}

int32_t count_holes(const Model& m, int b) {
  HoleWalk walk{};
  Hole hole;
  int32_t holes = 0;
  while (kHolePart.next_hole(m, b, walk, hole)) ++holes;
  return holes;
}

// Completes a plan that has `tree`, `holes` and the body's counts.
void complete_plan(int32_t rank, int32_t leaf, CompressedPlan& plan) {
  plan.rank = smaller(rank, plan.tree + 1); // the skeleton of half the nodes is at most all of them
  plan.leaf = smaller(leaf, plan.rank);
  const int32_t root = root_size(plan);
  plan.border = EliminationPlan{};
  plan.border.rows = root + border_rows(plan);
  plan.border.pivots = root + plan.columns - 2 * plan.tree + plan.holes;
  plan.border.trailing = 2 * border_contact(plan) + right_sides(plan);
  plan.border.panel_columns = plan.border.block_columns = 1;
  plan.border.rank = plan.rank;
  // A block must store a column of the border at least, so that the border can be written in whole columns.
  const uint64_t column = round_up(static_cast<uint64_t>(plan.border.rows) * sizeof(Real));
  plan.block_bytes = column > kStreamBytes ? column : kStreamBytes;
}

CompressedPlan plan_with_holes(const Model& m, int b, int32_t holes, int32_t rank, int32_t leaf) {
  const Body& body = m.body[b];
  CompressedPlan plan{};
  plan.nodes = body.nodes;
  plan.columns = outer_columns(m, b);
  plan.contact = body.contact;
  plan.loads = m.head->load_cases;
  plan.keeps = body.on_demand;
  plan.tree = body.nodes - (plan.keeps != 0 ? 0 : touching_nodes(m, b));
  plan.holes = holes;
  complete_plan(rank, leaf, plan);
  return plan;
}

} // namespace

bool may_compress(const Model& m, int b) {
  return m.body[b].rigid == 0 && m.body[b].free_rows == 0 && count_holes(m, b) <= most_holes(m.body[b].regions);
}

CompressedPlan plan_compressed(const Model& m, int b, int32_t rank, int32_t leaf) {
  return plan_with_holes(m, b, count_holes(m, b), rank, leaf);
}

CompressedPlan plan_compressed(const CompressedLimits& limits, int32_t rank, int32_t leaf) {
  CompressedPlan plan{};
  plan.nodes = limits.nodes + limits.touching; // bounds the body whether or not contact nodes are in the tree
  plan.tree = limits.nodes;
  plan.columns = 2 * plan.nodes + 3;
  plan.contact = limits.contact;
  plan.loads = limits.loads;
  plan.holes = limits.holes;
  plan.keeps = limits.keeps;
  complete_plan(rank, leaf, plan);
  return plan;
}

// A restored plan knows the border only. The number of holes follows from its rows.
CompressedPlan plan_around(const Model& m, int b, const EliminationPlan& border) {
  CompressedPlan plan = plan_with_holes(m, b, 0, border.rank, kLeafNodes);
  plan = plan_with_holes(m, b, border.rows - plan.border.rows, border.rank, kLeafNodes); // known, so not counted again
  plan.border = border;
  return plan;
}

// A saved border is accepted only if it is the one that this body would get. Otherwise its numbers would address wrong memory.
bool is_border(const Model& m, int b, const EliminationPlan& border) {
  if (border.rank < 1 || !may_compress(m, b)) return false;
  const EliminationPlan least = plan_compressed(m, b, border.rank, kLeafNodes).border;
  return border.rows == least.rows && border.pivots == least.pivots && border.trailing == least.trailing &&
         border.rank == least.rank && border.panel_columns >= 1 && border.panel_columns <= least.pivots + least.trailing &&
         border.block_columns >= 1 && border.block_columns <= border.panel_columns && border.block_rows == 0 &&
         border.keep_lower == 0;
}

c2d_status cut_border(uint64_t bytes, CompressedPlan& plan, uint64_t* needed) {
  const EliminationPlan narrow = plan.border;
  const uint64_t least = compressed_bytes(plan);
  if (needed) *needed = least;
  if (least > bytes) return C2D_ERR_MEMORY;
  // The border may use what the plan with one-column panels leaves of the work area.
  const uint64_t room = elimination_bytes(narrow) + (bytes - least);
  EliminationPlan& cut = plan.border;
  plan_elimination(room, narrow.rows, narrow.pivots, narrow.trailing, 0, cut, nullptr); // (one column fits)
  cut.rank = plan.rank;
  // Blocks of the border are no longer than those of the records; longer ones would make the bounds of the tape too large.
  const uint64_t column = static_cast<uint64_t>(narrow.rows) * sizeof(Real);
  cut.block_rows = 0;
  while (static_cast<uint64_t>(cut.block_columns) * column > plan.block_bytes || elimination_bytes(cut) > room)
    --cut.block_columns; // a block of one column always fits
  return C2D_OK;
}

namespace {

// Numbers of all clusters but the root, from the leaves up: of their results, or of their records. Every cluster is taken to
// be as large as it may become.
uint64_t numbers_of_clusters(const CompressedPlan& plan, bool records) {
  const uint64_t loads = static_cast<uint64_t>(right_sides(plan)), rank = static_cast<uint64_t>(plan.rank);
  uint64_t n = 2 * static_cast<uint64_t>(plan.leaf), sum = 0;
  for (uint64_t clusters = clusters_of(plan); clusters > 1; clusters /= 2) {
    const uint64_t k = n < rank ? n : rank;
    sum += clusters * (records ? n * n / 4 + n * loads + n + 8 : 2 * k * k + 2 * k * loads + k + 8);
    n = 2 * k;
  }
  return sum;
}

TapeUse with_stream(const CompressedPlan& plan, TapeUse use, uint64_t bytes, uint64_t blocks_beside) {
  const uint64_t blocks = bytes / plan.block_bytes + 1 + blocks_beside;
  use.blocks += blocks;
  use.bytes_written += blocks * (plan.block_bytes + kBlockHeaderBytes);
  use.bytes_read += blocks * (plan.block_bytes + kBlockHeaderBytes);
  if (plan.block_bytes > use.max_data_bytes) use.max_data_bytes = plan.block_bytes;
  return use;
}

} // namespace

// Data for additional right-hand sides of a cluster of n unknowns with r skeleton rows and columns: (n - r)(n + r) of factors,
// 2 r (n - r) of combinations, n^2 / 2 of couplings.
int64_t kept_numbers(int64_t n) { return 2 * n * n + 3 * n + 8; }
int64_t kept_of_border(const CompressedPlan& plan) {
  const int64_t n = most_dofs(plan), rows = border_rows(plan);
  return (n + rows) * (n + rows) + rows * n + n * n / 2 + 3 * (n + rows) + 8;
}

namespace {

uint64_t kept_bytes(const CompressedPlan& plan) {
  const int64_t rank = plan.rank;
  int64_t n = 2 * static_cast<int64_t>(plan.leaf), sum = kept_of_border(plan);
  for (int64_t clusters = static_cast<int64_t>(clusters_of(plan)); clusters > 1; clusters /= 2) {
    sum += clusters * kept_numbers(n);
    n = 2 * (n < rank ? n : rank);
  }
  return static_cast<uint64_t>(sum) * sizeof(double);
}

// Tape LOWER without the data for additional right-hand sides.
TapeUse passing_use(const CompressedPlan& plan) {
  // Each depth begins a block.
  return with_stream(plan, lower_use(plan.border), numbers_of_clusters(plan, false) * sizeof(double),
                     static_cast<uint64_t>(tree_depth(plan.tree, plan.leaf)));
}

} // namespace

TapeUse compressed_lower_use(const CompressedPlan& plan) {
  const TapeUse use = passing_use(plan);
  return plan.keeps != 0 ? with_stream(plan, use, kept_bytes(plan), 0) : use;
}
KeptPlace kept_place(const CompressedPlan& plan) {
  const uint64_t before = passing_use(plan).blocks;
  return {plan.border.lower_first_block + before, compressed_lower_use(plan).blocks - before};
}
// (The border may have fewer pivots than its plan, so the bound is that of any border with the same cut.)
TapeUse compressed_upper_use(const CompressedPlan& plan) {
  const uint64_t border = static_cast<uint64_t>(plan.border.pivots) * sizeof(int32_t) + sizeof(uint64_t);
  return with_stream(plan, most_upper_use(plan.border),
                     numbers_of_clusters(plan, true) * sizeof(double) + border + sample_bytes(plan), 1);
}

} // namespace c2d
