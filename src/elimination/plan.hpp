#pragma once
// Division of an elimination into panels and blocks, and its cost in memory and transfers.
//
// The matrix has `rows` rows and the columns 0 ... pivots-1, which are eliminated, and pivots ... pivots+trailing-1, which are
// only updated. One panel of panel_columns columns is in memory at a time (the last one may be narrower, and one panel may
// contain columns of both kinds). On the tapes a panel is cut into chunks of columns. A chunk never crosses the end of a panel
// or the border between eliminated and trailing columns. Chunk k of block_columns columns is block lower_first_block + k of
// tape LOWER, if a later panel needs it. Wide chunks make the arithmetic fast. Where whole columns of that width would take too
// much memory, a chunk is cut into strips of block_rows rows, each a block. Tape UPPER stores chunks of as many columns as fit
// into a buffer (upper_cut): block upper_first_block + k.
#include "contact2d.h"
#include "contact2d_memory.h"
#include "linalg/kernel.hpp"

namespace c2d {

struct EliminationPlan {
  int32_t rows, pivots, trailing;                // 0 <= pivots <= rows, 0 <= trailing
  int32_t panel_columns, block_columns;          // both >= 1, block_columns <= panel_columns
  int32_t rank;                                  // of compressed elimination, whose border this plan is of; 0: all is dense
  uint64_t lower_first_block, upper_first_block; // set by the caller: where this elimination's blocks start
  int32_t keep_lower;                            // set by the caller: 1: tape LOWER stores all of L, and the row exchanges
                                                 // in one block more, so that eliminate_again is possible
  int32_t block_rows;                            // of a block of LOWER; 0: all
};
inline bool is_compressed(const EliminationPlan& plan) { return !kSmallCode && plan.rank > 0; }
// The plan with the chunks of tape UPPER.
EliminationPlan upper_cut(const EliminationPlan& plan);

// Buffers for blocks: two where a chunk is cut into strips, so that one is used while the other is transferred. Small code
// does one thing at a time, to keep the stack short.
constexpr int32_t kMostBuffers = kSmallCode ? 1 : 2;
int32_t block_buffers(const EliminationPlan& plan);

// Bytes of the work area of `eliminate`: a panel, buffers for blocks with room for their headers, a norm for each
// column of the panel, the pivots. UINT64_MAX if the number is beyond any memory. The second form has one buffer.
uint64_t elimination_bytes(const EliminationPlan& plan);
uint64_t elimination_bytes(int32_t rows, int32_t pivots, int32_t panel_columns, int32_t block_columns);

// The same for the widest panel that is useful: all columns at once, nothing on tape LOWER.
uint64_t elimination_bytes_in_core(int32_t rows, int32_t pivots, int32_t trailing);

// Choose panels and blocks for a work area of `bytes` bytes: all in one panel if that fits, else wide panels and strips in an
// eighth of the memory, or, where that is too little to read ahead, whole blocks of at most a quarter of the panels' width.
// forced_columns > 0 is the width of the panels. The first-block numbers are set to 0. Errors: C2D_ERR_MEMORY with *needed =
// the bytes that are enough (for panels of the forced width, or of one column), C2D_ERR_ARGUMENT for sizes out of range.
// `needed` may be null.
c2d_status plan_elimination(uint64_t bytes, int32_t rows, int32_t pivots, int32_t trailing, int32_t forced_columns,
                            EliminationPlan& out, uint64_t* needed);

// What one elimination needs of a tape. Bytes include headers.
struct TapeUse {
  uint64_t blocks;         // numbered from the plan's first block of that tape
  uint64_t max_data_bytes; // of the largest block, without its header
  uint64_t bytes_written;  // by `eliminate`
  uint64_t bytes_read;     // LOWER: by `eliminate`; UPPER: by each `back_substitute`
};
TapeUse lower_use(const EliminationPlan& plan);
TapeUse upper_use(const EliminationPlan& plan);
// Bounds for any elimination with the same cut and no more rows and columns of either kind; bytes are not given. (For LOWER,
// lower_use is such a bound.)
TapeUse most_upper_use(const EliminationPlan& plan);

// A chunk of columns, all in one panel and of one kind.
struct Chunk {
  int32_t first, count; // columns
  int32_t panel;        // from 0
  int32_t row;          // on LOWER: the first row of the strip
  uint64_t index;       // from 0, of blocks; the eliminated columns' chunks come first
};
// Cuts an elimination with no more rows and columns like this one.
void cut_alike(const EliminationPlan& cut, EliminationPlan& plan);
// Place on tape LOWER, from the plan's first block, of the row exchanges.
uint64_t exchanges_block(const EliminationPlan& plan);
// The first chunk, and the one after `chunk`: count is 0 when there is none.
Chunk first_chunk(const EliminationPlan& plan);
Chunk next_chunk(const EliminationPlan& plan, const Chunk& chunk);
// On LOWER: the next strip of the chunk, or the first of the next chunk.
Chunk next_strip(const EliminationPlan& plan, const Chunk& chunk);
int32_t rows_of_strip(const EliminationPlan& plan, const Chunk& chunk);
// The chunk of eliminated columns that ends before column `end` > 0, which is where a chunk or the eliminated columns end.
Chunk chunk_before(const EliminationPlan& plan, int32_t end);

int32_t panel_count(const EliminationPlan& plan);
// Bytes of data of a chunk's blocks: LOWER stores the rows of a strip, the first of which begins in the row of the
// chunk's first column (for eliminated columns only), UPPER (chunks of upper_cut) the rows down to its last column, or
// the first `pivots` rows of trailing columns.
uint64_t lower_bytes(const EliminationPlan& plan, const Chunk& chunk);
uint64_t upper_bytes(const EliminationPlan& plan, const Chunk& chunk);

// Places in the work area, in bytes from its start, which is aligned to 64 bytes.
struct WorkLayout {
  uint64_t panel, block, norms, pivots, total;
  uint64_t block_step; // from one buffer for blocks to the next
  int64_t leading;     // from one column of the panel to the next
};
WorkLayout work_layout(const EliminationPlan& plan);

} // namespace c2d
