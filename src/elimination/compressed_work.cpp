// The work area of compressed elimination, and what it costs.
#include "elimination/compressed_work.hpp"
#include "elimination/cells.hpp"
#include "memory/sizes.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(HolePart);

namespace {

constexpr uint64_t kStreamBytes = 32768; // of data in a block, if the dense blocks are no larger

struct Bump {
  char* base;
  Carver carver{0, true};
  template <class T> void take(T*& out, uint64_t count) {
    carver.align();
    const uint64_t at = carver.carve(count, sizeof(T));
    out = base ? reinterpret_cast<T*>(base + at) : nullptr;
  }
};

int32_t smaller(int32_t a, int32_t b) { return a < b ? a : b; }

uint64_t cells_of(const CompressedPlan& plan) { return uint64_t{1} << tree_depth(plan.tree, plan.leaf); }

} // namespace

int64_t block_numbers(const CompressedPlan& plan) {
  constexpr int64_t kLeast = 2 * (kProxies > kChunk ? kProxies : kChunk);
  const int64_t n = most_dofs(plan);
  const int64_t cell = 2 * (n > kLeast ? n : kLeast) * n, border = 4 * (2 * n + border_rows(plan));
  return cell > border ? cell : border;
}

// Of a cell's result, and of what back substitution needs of it; identities and counts beside the numbers.
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
  Bump bump{base};
  const uint64_t nodes = static_cast<uint64_t>(plan.nodes), tree = static_cast<uint64_t>(plan.tree);
  const uint64_t n = static_cast<uint64_t>(most_dofs(plan)), k = n / 2, loads = static_cast<uint64_t>(right_sides(plan));
  const uint64_t cells = cells_of(plan), border = static_cast<uint64_t>(border_rows(plan));
  const uint64_t listed = 2 * nodes + 2 * static_cast<uint64_t>(kProxies);
  bump.take(w.root_d, n * n);
  bump.take(w.root_q, border * n);
  bump.take(w.root_c, (border + n) * loads);
  bump.take(w.border, nodes - tree);
  bump.take(w.hole, static_cast<uint64_t>(plan.holes));
  bump.take(w.right, (2 * nodes + 3) * loads);
  bump.take(w.position, nodes);
  bump.take(w.stamp, nodes);
  bump.take(w.hole_at, nodes);
  bump.take(w.place, static_cast<uint64_t>(plan.columns) + 2 * static_cast<uint64_t>(plan.contact));
  bump.take(w.ids, 2 * n);
  bump.take(w.block, static_cast<uint64_t>(block_numbers(plan)));
  int32_t** const lists[] = {&w.sources, &w.elements, &w.twin, &w.list};
  for (int32_t** list : lists) bump.take(*list, listed);
  bump.take(w.point, 2 * listed);
  for (int i = 0; i < 2; ++i) {
    bump.take(w.rows[i], 2 * tree);
    bump.take(w.columns[i], 2 * tree);
    bump.take(w.row_begin[i], cells + 1);
    bump.take(w.column_begin[i], cells + 1);
  }
  bump.take(w.upper_buffer, kBlockHeaderBytes + plan.block_bytes);
  // From here on the work area of eliminate() may stand, when the tree is done.
  const uint64_t behind = bump.carver.used;
  bump.take(w.order, tree);
  bump.take(w.room, tree);
  bump.take(w.circle, 3 * cells);
  bump.take(w.reach, nodes);
  bump.take(w.d, n * n);
  bump.take(w.v, n * n);
  bump.take(w.e, n * (n + k));
  bump.take(w.row_x, n * (n + 2));
  bump.take(w.column_x, n * (n + 2));
  bump.take(w.samples, (n + 32) * n);
  bump.take(w.b, n * loads);
  bump.take(w.c, n * loads);
  bump.take(w.g, n * loads);
  bump.take(w.norms, 2 * n);
  bump.take(w.sample, 2 * n);
  for (Real*& result : w.result) bump.take(result, static_cast<uint64_t>(result_numbers(plan)));
  int32_t** const orders[] = {&w.row_order, &w.column_order, &w.pivots};
  for (int32_t** order : orders) bump.take(*order, 2 * n + 2 * static_cast<uint64_t>(kChunk));
  bump.take(w.lower_buffer, kBlockHeaderBytes + plan.block_bytes);
  bump.take(w.read_buffer, kBlockHeaderBytes + plan.block_bytes);
  bump.carver.align();
  Bump dense{base};
  dense.carver.used = behind;
  char* room = nullptr;
  dense.take(room, elimination_bytes(plan.border));
  w.dense = room;
  dense.carver.align();
  if (!bump.carver.fits || !dense.carver.fits) return UINT64_MAX;
  if (out) *out = w;
  return bump.carver.used > dense.carver.used ? bump.carver.used : dense.carver.used;
}

uint64_t compressed_bytes(const CompressedPlan& plan) { return lay_out_work(plan, nullptr, nullptr); }

bool is_tree_node(const Model& m, int b, int32_t node) {
  return m.node_column[b][node + 1] - m.node_column[b][node] == 2 && pair_of_node(m, b, node).pair < 0;
}

CompressedPlan plan_compressed(const Model& m, int b, int32_t rank, int32_t leaf) {
  const Body& body = m.body[b];
  CompressedPlan plan{};
  plan.nodes = body.nodes;
  plan.columns = outer_columns(m, b);
  plan.contact = body.contact;
  plan.loads = m.head->load_cases;
  for (int32_t node = 0; node < body.nodes; ++node) plan.tree += is_tree_node(m, b, node) ? 1 : 0;
  HoleWalk walk{};
  Hole hole;
  while (kHolePart.next_hole(m, b, walk, hole)) ++plan.holes;
  plan.rank = rank;
  plan.leaf = smaller(leaf, rank);
  const int32_t root = root_size(plan);
  plan.border.rows = root + border_rows(plan);
  plan.border.pivots = root + plan.columns - 2 * plan.tree + plan.holes;
  plan.border.trailing = 2 * plan.contact + right_sides(plan);
  plan.border.panel_columns = plan.border.block_columns = 1;
  plan.block_bytes = kStreamBytes;
  return plan;
}

c2d_status cut_border(uint64_t bytes, CompressedPlan& plan, uint64_t* needed) {
  const EliminationPlan narrow = plan.border;
  const uint64_t least = compressed_bytes(plan);
  if (needed) *needed = least;
  if (least > bytes) return C2D_ERR_MEMORY;
  // What stands before the dense work area stays; blocks that grow with the border's make it a little longer.
  uint64_t room = elimination_bytes(narrow) + (bytes - least);
  for (;; room -= room / 16 + 1) {
    c2d_status status = plan_elimination(room, narrow.rows, narrow.pivots, narrow.trailing, 0, plan.border, nullptr);
    if (status != C2D_OK) {
      plan.border = narrow;
      plan.block_bytes = kStreamBytes;
      return C2D_OK;
    }
    const uint64_t upper = upper_use(plan.border).max_data_bytes, lower = lower_use(plan.border).max_data_bytes;
    plan.block_bytes = upper > lower ? upper : lower;
    plan.block_bytes = (plan.block_bytes > kStreamBytes ? plan.block_bytes : kStreamBytes) / 64 * 64;
    if (compressed_bytes(plan) <= bytes) return C2D_OK;
  }
}

namespace {

TapeUse with_stream(const CompressedPlan& plan, TapeUse use, int64_t numbers) {
  // Every cell but the root has one; each depth begins a block.
  const uint64_t depth = static_cast<uint64_t>(tree_depth(plan.tree, plan.leaf)), cells = 2 * cells_of(plan) - 2;
  const uint64_t blocks = cells * static_cast<uint64_t>(numbers) * sizeof(double) / plan.block_bytes + 2 + depth;
  use.blocks += blocks;
  use.bytes_written += blocks * (plan.block_bytes + kBlockHeaderBytes);
  use.bytes_read += blocks * (plan.block_bytes + kBlockHeaderBytes);
  if (plan.block_bytes > use.max_data_bytes) use.max_data_bytes = plan.block_bytes;
  return use;
}

} // namespace

TapeUse compressed_lower_use(const CompressedPlan& plan) {
  return with_stream(plan, lower_use(plan.border), result_numbers(plan));
}
TapeUse compressed_upper_use(const CompressedPlan& plan) {
  return with_stream(plan, upper_use(plan.border), record_numbers(plan));
}

} // namespace c2d
