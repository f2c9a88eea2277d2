// Plan of a streamed elimination (METHOD 7.1): widths of panels, blocks and strips for a given work area, and the blocks on
// the tapes.
//
// Three cases, from fast to slow:
// 1. Everything fits: one panel, nothing is read back.
// 2. Panels of as many columns as fit, and blocks of L cut into strips of rows in an eighth of the memory. Two buffers, so
//    that one strip is read while the other is used.
// 3. Too little memory for strips: whole blocks of at most a quarter of the panel's width.
// Each panel reads all blocks of L before it. With w columns per panel that is n^3 / (3 w) numbers, so a wide panel saves
// transfers. A wide block saves arithmetic time, since products with few inner steps run below full speed.
// Literature: Golub and Van Loan, Matrix Computations, section 3.2 and chapter 1 (blocking, memory traffic).
#include "elimination/plan.hpp"
#include "memory/hostile.hpp"
#include "store/block.hpp"

namespace c2d {
namespace {

constexpr int32_t kWidestBlock = 64;                 // whole blocks: a wider one takes too much from the panel
constexpr int32_t kWidestStrip = 256;                // inner steps with which the kernels run at full speed
constexpr int32_t kNarrowestStrip = 32;              // below that, whole blocks are as good
constexpr int32_t kTileRows = 24, kTileColumns = 8;  // a multiple of each kernel's tile: incomplete tiles cost more
constexpr int32_t kLongestStrip = 1024;              // rows that justify packing the right factor again
constexpr uint64_t kMostNumbers = uint64_t(1) << 56; // numbers in a work area: far more than any machine has

uint64_t aligned(uint64_t bytes) { return (bytes + 63) / 64 * 64; }

int32_t smaller(int32_t a, int32_t b) { return a < b ? a : b; }

// Columns start on cache lines. Distances that are a multiple of 4 KiB are avoided: they would map all columns to the same few
// cache sets.
int64_t leading_dimension(int32_t rows) {
  const int64_t line = 64 / sizeof(Real);
  const int64_t leading = (rows + line - 1) / line * line;
  if (leading == 0) return line;
  return leading % (8 * 64) == 0 ? leading + line : leading;
}

int32_t strip_rows(const EliminationPlan& plan) { return plan.block_rows > 0 ? plan.block_rows : plan.rows; }

int32_t all_columns(const EliminationPlan& plan) { return plan.pivots + plan.trailing; }

// The widest panel that fits together with blocks of this width; 0 if none. Memory grows with the width, so bisection finds
// it.
int32_t widest_panel(uint64_t bytes, EliminationPlan plan, int32_t block_columns) {
  plan.block_columns = block_columns;
  int32_t fits = 0, too_wide = all_columns(plan) + 1;
  while (too_wide - fits > 1) {
    const int32_t middle = fits + (too_wide - fits) / 2;
    plan.panel_columns = middle;
    if (elimination_bytes(plan) <= bytes)
      fits = middle;
    else
      too_wide = middle;
  }
  return fits;
}

// Blocks of a quarter of the panel's width or less: wide blocks serve the arithmetic, wide panels save transfers.
void choose_streamed(uint64_t bytes, EliminationPlan& plan) {
  for (int32_t block = kWidestBlock;; block /= 2) {
    const int32_t panel = widest_panel(bytes, plan, block);
    if (panel < 4 * block && block > 1) continue;
    plan.block_columns = block;
    plan.panel_columns = panel;
    return;
  }
}

// Two buffers for strips: an eighth of the memory, or what a panel of prescribed width leaves. Returns false if strips would
// not be longer than wide, or shorter than the smallest useful ones.
bool choose_strips(uint64_t bytes, int32_t forced, EliminationPlan& plan) {
  EliminationPlan strips = plan;
  const uint64_t beside = forced > 0 ? elimination_bytes(plan.rows, plan.pivots, forced, 0) : bytes / 8 * 7;
  // (1024 bytes for headers and rounding)
  const uint64_t numbers = (bytes < beside + 1024 ? 0 : (bytes - beside - 1024) / 2) / sizeof(Real);
  for (int32_t width = kWidestStrip; width >= kNarrowestStrip; width /= 2) {
    const uint64_t most = static_cast<uint64_t>(kLongestStrip) * static_cast<uint64_t>(width);
    const int32_t fits = numbers < most ? static_cast<int32_t>(numbers) / width : kLongestStrip;
    strips.block_rows = smaller(plan.rows, fits);
    strips.block_columns = width;
    if (strips.block_rows < plan.rows) strips.block_rows -= strips.block_rows % kTileRows;
    if (strips.block_rows < smaller(plan.rows, 3 * width)) continue;
    if (static_cast<int64_t>(strips.block_rows) * width < plan.rows)
      continue; // a buffer must store a column, and the exchanges
    const int32_t widest = forced > 0 ? forced : widest_panel(bytes, strips, width);
    strips.panel_columns = forced > 0 ? forced : widest - widest % kTileColumns;
    if (strips.panel_columns < width) continue;
    if (C2D_NEVER(elimination_bytes(strips) > bytes)) continue; // strips are cut to the memory that is left
    plan = strips;
    return true;
  }
  return false;
}

// The widest blocks that fit beside panels of this width; false if none do.
bool choose_blocks(uint64_t bytes, int32_t panel, EliminationPlan& plan) {
  for (int32_t block = smaller(kWidestBlock, panel); block >= 1; block = block == 1 ? 0 : (block + 1) / 2) {
    plan.panel_columns = panel;
    plan.block_columns = block;
    if (elimination_bytes(plan) <= bytes) return true;
  }
  return false;
}

// A chunk ends where its panel ends and where the eliminated columns end, so a block contains columns of one kind.
Chunk chunk_at(const EliminationPlan& plan, int32_t first, uint64_t index) {
  const int32_t kind_end = first < plan.pivots ? plan.pivots : all_columns(plan);
  const int32_t panel = first / plan.panel_columns;
  const int32_t left_in_panel = plan.panel_columns - first % plan.panel_columns;
  const int32_t count = smaller(plan.block_columns, smaller(left_in_panel, kind_end - first));
  return {first, count, panel, first, index};
}

} // namespace

int32_t block_buffers(const EliminationPlan& plan) { return plan.block_rows > 0 ? kMostBuffers : 1; }

// Tape UPPER is read by whole columns, downwards from row 0. A buffer that stores a strip of many columns stores fewer columns
// of full length.
EliminationPlan upper_cut(const EliminationPlan& plan) {
  EliminationPlan cut = plan;
  cut.block_rows = 0;
  if (plan.block_rows > 0 && plan.block_rows < plan.rows)
    cut.block_columns = plan.block_columns * plan.block_rows / plan.rows; // at most kWidestStrip * kLongestStrip
  return cut;
}

WorkLayout work_layout(const EliminationPlan& plan) {
  WorkLayout at = {0, 0, 0, 0, 0, 0, leading_dimension(plan.rows)};
  const uint64_t leading = static_cast<uint64_t>(at.leading), panel = static_cast<uint64_t>(plan.panel_columns);
  const uint64_t block = static_cast<uint64_t>(plan.block_columns);
  if (leading * panel > kMostNumbers) { // blocks are no wider
    at.total = UINT64_MAX;
    return at;
  }
  at.block_step = aligned(kBlockHeaderBytes + static_cast<uint64_t>(strip_rows(plan)) * block * sizeof(Real));
  const uint64_t blocks = at.block_step * static_cast<uint64_t>(block_buffers(plan));
  const uint64_t columns = static_cast<uint64_t>(plan.pivots);
#define C2D_PLACE(type, name, count, each) at.name = at.total, at.total += aligned((count) * (each)*C2D_BYTES_OF_##type);
  C2D_WORK_ARRAYS_(C2D_PLACE, leading, panel, blocks, columns)
#undef C2D_PLACE
  return at;
}

uint64_t elimination_bytes(const EliminationPlan& plan) { return work_layout(plan).total; }

uint64_t elimination_bytes(int32_t rows, int32_t pivots, int32_t panel_columns, int32_t block_columns) {
  return elimination_bytes({rows, pivots, 0, panel_columns, block_columns, 0, 0, 0, 0, 0});
}

uint64_t elimination_bytes_in_core(int32_t rows, int32_t pivots, int32_t trailing) {
  const int32_t columns = pivots + trailing > 0 ? pivots + trailing : 1;
  return elimination_bytes(rows, pivots, columns, smaller(kWidestBlock, columns));
}

c2d_status plan_elimination(uint64_t bytes, int32_t rows, int32_t pivots, int32_t trailing, int32_t forced_columns,
                            EliminationPlan& out, uint64_t* needed) {
  if (rows < 0 || pivots < 0 || pivots > rows || trailing < 0 || trailing >= INT32_MAX - pivots || forced_columns < 0) {
    return C2D_ERR_ARGUMENT;
  }
  EliminationPlan plan = {rows, pivots, trailing, 1, 1, 0, 0, 0, 0, 0};
  const int32_t columns = all_columns(plan) > 0 ? all_columns(plan) : 1;
  const int32_t forced = smaller(forced_columns, columns);
  const int32_t least = forced > 0 ? forced : 1;
  if (needed) *needed = elimination_bytes(rows, pivots, least, 1);
  if (elimination_bytes(rows, pivots, least, 1) > bytes) return C2D_ERR_MEMORY;
  const int32_t whole = forced > 0 ? forced : columns;
  const bool in_core = whole == columns && choose_blocks(bytes, columns, plan);
  if (!in_core && !choose_strips(bytes, forced, plan)) {
    if (forced > 0)
      choose_blocks(bytes, forced, plan);
    else
      choose_streamed(bytes, plan);
  }
  out = plan;
  return C2D_OK;
}

int32_t panel_count(const EliminationPlan& plan) {
  const int32_t columns = all_columns(plan);
  return columns / plan.panel_columns + (columns % plan.panel_columns != 0);
}

Chunk first_chunk(const EliminationPlan& plan) { return chunk_at(plan, 0, 0); }

Chunk next_chunk(const EliminationPlan& plan, const Chunk& chunk) {
  return chunk_at(plan, chunk.first + chunk.count, chunk.index + 1);
}

Chunk next_strip(const EliminationPlan& plan, const Chunk& chunk) {
  if (rows_of_strip(plan, chunk) == plan.rows - chunk.row) return next_chunk(plan, chunk);
  return {chunk.first, chunk.count, chunk.panel, chunk.row + plan.block_rows, chunk.index + 1};
}

int32_t rows_of_strip(const EliminationPlan& plan, const Chunk& chunk) {
  return smaller(strip_rows(plan), plan.rows - chunk.row);
}

Chunk chunk_before(const EliminationPlan& plan, int32_t end) {
  const int32_t panel = (end - 1) / plan.panel_columns;
  const int32_t place = (end - 1) % plan.panel_columns / plan.block_columns; // of the chunk in its panel
  const int32_t panel_chunks = (plan.panel_columns - 1) / plan.block_columns + 1;
  const uint64_t index = static_cast<uint64_t>(panel) * static_cast<uint64_t>(panel_chunks);
  return chunk_at(plan, panel * plan.panel_columns + place * plan.block_columns, index + static_cast<uint64_t>(place));
}

uint64_t lower_bytes(const EliminationPlan& plan, const Chunk& chunk) {
  return static_cast<uint64_t>(rows_of_strip(plan, chunk)) * static_cast<uint64_t>(chunk.count) * sizeof(Real);
}

uint64_t upper_bytes(const EliminationPlan& plan, const Chunk& chunk) {
  const int32_t rows = chunk.first < plan.pivots ? chunk.first + chunk.count : plan.pivots;
  return static_cast<uint64_t>(rows) * static_cast<uint64_t>(chunk.count) * sizeof(Real);
}

uint64_t exchanges_block(const EliminationPlan& plan) {
  Chunk chunk = first_chunk(plan);
  while (chunk.first < plan.pivots) chunk = next_strip(plan, chunk);
  return chunk.index;
}

TapeUse lower_use(const EliminationPlan& plan) {
  TapeUse use = {0, 0, 0, 0};
  const int32_t last = panel_count(plan) - 1;
  for (Chunk chunk = first_chunk(plan); chunk.first < plan.pivots; chunk = next_strip(plan, chunk)) {
    if (chunk.panel >= last && plan.keep_lower == 0) break;
    const uint64_t data = lower_bytes(plan, chunk);
    use.blocks += 1;
    if (data > use.max_data_bytes) use.max_data_bytes = data;
    use.bytes_written += data + kBlockHeaderBytes;
    // Each panel behind this one reads the block once.
    use.bytes_read += (data + kBlockHeaderBytes) * static_cast<uint64_t>(last - chunk.panel);
  }
  if (plan.keep_lower != 0 && plan.pivots > 0) {
    const uint64_t data = static_cast<uint64_t>(plan.pivots) * sizeof(int32_t);
    use.blocks += 1;
    if (data > use.max_data_bytes) use.max_data_bytes = data;
    use.bytes_written += data + kBlockHeaderBytes;
  }
  return use;
}

TapeUse upper_use(const EliminationPlan& uncut) {
  const EliminationPlan plan = upper_cut(uncut);
  TapeUse use = {0, 0, 0, 0};
  if (plan.pivots == 0) return use;
  for (Chunk chunk = first_chunk(plan); chunk.count > 0; chunk = next_chunk(plan, chunk)) {
    const uint64_t data = upper_bytes(plan, chunk);
    use.blocks += 1;
    if (data > use.max_data_bytes) use.max_data_bytes = data;
    use.bytes_written += data + kBlockHeaderBytes;
  }
  use.bytes_read = use.bytes_written;
  return use;
}

TapeUse most_upper_use(const EliminationPlan& plan) {
  TapeUse use = {upper_use(plan).blocks, 0, 0, 0};
  const EliminationPlan cut = upper_cut(plan);
  const int32_t columns = all_columns(plan), each = (cut.panel_columns - 1) / cut.block_columns + 1;
  // A chunk is cut in two where the eliminated columns end inside a panel: one more block at most.
  const uint64_t panels = static_cast<uint64_t>(columns / cut.panel_columns),
                 rest = static_cast<uint64_t>(columns % cut.panel_columns);
  const uint64_t width = static_cast<uint64_t>(cut.block_columns);
  const uint64_t blocks = panels * static_cast<uint64_t>(each) + (rest + width - 1) / width + 1;
  if (blocks > use.blocks && width > 1 && columns > cut.panel_columns) use.blocks = blocks;
  // A body with fewer rows than the plan gets wider chunks from strips of the same length.
  const bool strips = plan.block_rows > 0 && plan.block_rows < plan.rows;
  const uint64_t most = static_cast<uint64_t>(smaller(cut.block_columns, columns)) * static_cast<uint64_t>(plan.pivots);
  use.max_data_bytes =
      sizeof(Real) * (strips ? static_cast<uint64_t>(plan.block_columns) * static_cast<uint64_t>(plan.block_rows) : most);
  return use;
}

void cut_alike(const EliminationPlan& cut, EliminationPlan& plan) {
  const int32_t columns = all_columns(plan) > 0 ? all_columns(plan) : 1;
  plan.panel_columns = smaller(cut.panel_columns, columns);
  plan.block_columns = smaller(cut.block_columns, plan.panel_columns);
  plan.block_rows = smaller(cut.block_rows, plan.rows);
}

} // namespace c2d
