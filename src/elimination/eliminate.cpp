// Streamed LU elimination of one body with partial pivoting, and back substitution (METHOD 7.1).
//
// Equation, with A_o the columns of the outer unknowns and B all others, METHOD (7.1) to (7.2):
//   P [ A_o | B ] = [ L_1 0; L_2 I ] [ U Y; 0 S ].
// Phases, for one panel of columns after another (left-looking):
// 1. Fill: the source assembles the columns. Their largest entries are noted for the pivot statistics.
// 2. Update: the row exchanges and the blocks of L of all earlier panels are applied, in their order, from tape LOWER.
// 3. Factor: LU with partial pivoting over all remaining rows.
// 4. Write: L to tape LOWER if a later panel needs it, U and Y to tape UPPER. The rows of S go to the sink.
// Back substitution reads UPPER backwards: x = U^-1 Y c. The adjoint reads it forwards: w = Y^T U^-T f.
//
// Left-looking, because each panel is then written once: the right-looking form would rewrite the whole matrix for each panel.
// Literature: Golub and Van Loan, Matrix Computations, chapter 3 (block LU, partial pivoting); Higham, Accuracy and Stability
// of Numerical Algorithms, chapter 9. Partial forward elimination with the contact last: figure 20 of the thesis.
#include "elimination/eliminate.hpp"
#include "linalg/dense.hpp"
#include "linalg/dots.hpp"
#include "memory/hostile.hpp"
#include <string.h>

namespace c2d {
namespace {

// The block buffers, used in rotation, and the transfers in progress on them. With two buffers the next block is read while
// the present one is used.
struct Buffers {
  Tapes& tapes;
  unsigned char* base;
  uint64_t step; // bytes from one to the next
  int32_t made;  // how many there are
  int32_t next;  // the one to use next
  BlockTransfer transfer[kMostBuffers];

  unsigned char* at(int32_t slot) const { return base + step * static_cast<uint64_t>(slot); }
  int32_t count() const { return kMostBuffers == 1 ? 1 : made; }
  bool ahead() const { return count() > 1; }
};

// The next buffer in rotation, after its last transfer has ended: its contents may not change while the port writes them.
c2d_status take_buffer(Buffers& buffers, int32_t* slot) {
  *slot = buffers.next;
  buffers.next = (buffers.next + 1) % buffers.count();
  return finish_transfer(buffers.tapes, buffers.transfer[*slot]);
}

// Ends all transfers. Returns the error that there was already, or the first one found now. After an error the buffers must
// not be released before the port has stopped using them.
c2d_status finish_all(Buffers& buffers, c2d_status status) {
  for (int32_t turn = 0; turn < buffers.count(); ++turn) {
    const int32_t slot = (buffers.next + turn) % buffers.count(); // the oldest first
    if (status == C2D_OK)
      status = finish_transfer(buffers.tapes, buffers.transfer[slot]);
    else
      abandon_transfer(buffers.tapes, buffers.transfer[slot]);
  }
  return status;
}

c2d_status start_write(Buffers& buffers, int32_t slot, int32_t tape, uint64_t block, uint64_t data_bytes) {
  return start_transfer(buffers.tapes, buffers.transfer[slot], BlockTransfer::write, tape, block, buffers.at(slot), data_bytes,
                        buffers.ahead());
}

// The order in which the blocks of a tape are needed. Forward: chunks before column `end`. Back substitution: the trailing
// columns, then the eliminated columns backwards, because U is upper triangular.
struct Pass {
  const EliminationPlan& plan;
  Buffers& buffers;
  int32_t tape, end;
  bool back;
  int32_t under_way;
  Chunk now, ahead; // the next to use, and the next to request

  bool wanted(const Chunk& chunk) const { return chunk.count > 0 && chunk.first < end; }
  Chunk after(const Chunk& chunk) const {
    if (tape == C2D_TAPE_LOWER) return next_strip(plan, chunk);
    if (back && chunk.first < plan.pivots) return chunk.first > 0 ? chunk_before(plan, chunk.first) : Chunk{0, 0, 0, 0, 0};
    const Chunk next = next_chunk(plan, chunk);
    return back && next.count == 0 ? chunk_before(plan, plan.pivots) : next;
  }
};

Pass forward(const EliminationPlan& plan, Buffers& buffers, int32_t tape, int32_t end) {
  const Chunk start = first_chunk(plan);
  return {plan, buffers, tape, end, false, 0, start, start};
}

Pass backward(const EliminationPlan& plan, Buffers& buffers) {
  const Chunk last = chunk_before(plan, plan.pivots), start = plan.trailing > 0 ? next_chunk(plan, last) : last;
  return {plan, buffers, C2D_TAPE_UPPER, plan.pivots + plan.trailing, true, 0, start, start};
}

// Requests as many blocks as there are buffers, then waits for the first of them: data of chunk.count columns, valid until the
// next call. chunk.count = 0: there are no more.
c2d_status next_block(Pass& pass, Chunk& chunk, const Real** data) {
  Buffers& buffers = pass.buffers;
  const EliminationPlan& plan = pass.plan;
  const bool lower = pass.tape == C2D_TAPE_LOWER;
  for (; pass.under_way < buffers.count() && pass.wanted(pass.ahead); ++pass.under_way) {
    const int32_t slot = (buffers.next + pass.under_way) % buffers.count();
    c2d_status status = finish_transfer(buffers.tapes, buffers.transfer[slot]);
    if (status != C2D_OK) return status;
    status = start_transfer(buffers.tapes, buffers.transfer[slot], BlockTransfer::read, pass.tape,
                            (lower ? plan.lower_first_block : plan.upper_first_block) + pass.ahead.index, buffers.at(slot),
                            lower ? lower_bytes(plan, pass.ahead) : upper_bytes(plan, pass.ahead), buffers.ahead());
    if (status != C2D_OK) return status;
    pass.ahead = pass.after(pass.ahead);
  }
  chunk = pass.now;
  if (pass.under_way == 0) {
    chunk.count = 0;
    return C2D_OK;
  }
  pass.now = pass.after(pass.now);
  --pass.under_way;
  int32_t slot;
  const c2d_status status = take_buffer(buffers, &slot);
  *data = reinterpret_cast<const Real*>(buffers.at(slot) + kBlockHeaderBytes);
  return status;
}

// The panel in memory, and what its elimination needs.
struct Panel {
  const EliminationPlan& plan;
  const Watch& watch;
  Real* columns; // rows x count
  int64_t ld;
  Buffers& buffers;
  Real* norms;          // largest entry of each column as filled
  int32_t* pivots;      // for all eliminated columns, absolute rows
  int32_t first, count; // columns of the matrix
  int32_t own;          // how many of them are eliminated
  bool last;            // no panel comes after it
  const Engine& engine;

  Real* column(int32_t j) const { return columns + j * ld; }
};

// Reports columns to the caller's watch, which may stop the elimination.
c2d_status notify(const Watch& watch, int32_t first, int32_t count) {
  for (int32_t j = first; watch.step && j < first + count; ++j) {
    const c2d_status status = watch.step(watch.context, j);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

// The pivot ratios of METHOD 7.4 compare a pivot with its column before elimination, so the norms are taken now. A number that
// is not finite would spread to all later columns.
c2d_status find_norms(const Panel& panel) {
  const int32_t rows = panel.plan.rows;
  for (int32_t j = 0; j < panel.count; ++j) {
    if (!all_finite(rows, panel.column(j))) return C2D_ERR_INTERNAL;
    panel.norms[j] = largest(panel.engine, rows, panel.column(j));
  }
  return C2D_OK;
}

c2d_status fill(const Panel& panel, const ColumnSource& source) {
  c2d_status status = source.fill(source.context, panel.first, panel.count, panel.columns, panel.ld);
  if (status == C2D_OK) status = find_norms(panel);
  return status == C2D_OK ? notify(panel.watch, panel.first, panel.count) : status;
}

// Updates the panel with one strip of L: w columns from column f of the matrix on. The first strip of a chunk contains the
// unit triangle L_1 and makes rows f ... f+w-1 of the panel final (U = L_1^-1 A). The other strips subtract L_2 times these
// rows.
void update(const Panel& panel, const Chunk& strip, const Real* l) {
  const int32_t f = strip.first, w = strip.count, rows = rows_of_strip(panel.plan, strip);
  Real* top = panel.columns + f;
  if (strip.row == f)
    update_by(panel.engine, w, rows - w, panel.count, l, rows, top, panel.ld);
  else
    gemm_minus(panel.engine, rows, panel.count, w, l, rows, top, panel.ld, panel.columns + strip.row, panel.ld);
}

// Brings a panel up to date with all panels before it. A block of L keeps the row order that it had when it was factored. So
// the exchanges of panel k are applied just before the blocks of panel k.
c2d_status apply_earlier(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  int32_t exchanged = 0;
  Pass pass = forward(plan, panel.buffers, C2D_TAPE_LOWER, panel.first < plan.pivots ? panel.first : plan.pivots);
  for (;;) {
    Chunk chunk;
    const Real* l = nullptr;
    c2d_status status = next_block(pass, chunk, &l);
    if (status != C2D_OK || chunk.count == 0) return status;
    // First chunk of a panel: its row exchanges come before all its blocks.
    if (chunk.first == exchanged) {
      const int32_t left = plan.pivots - exchanged;
      const int32_t count = left < plan.panel_columns ? left : plan.panel_columns;
      apply_pivots(panel.count, panel.columns, panel.ld, panel.pivots, exchanged, count);
      exchanged += count;
    }
    update(panel, chunk, l);
    status = notify(panel.watch, panel.first, 1);
    if (status != C2D_OK) return status;
  }
}

// Factors the panel's own columns, and updates the trailing columns of the same panel. (Not inlined, as the functions that
// write: columns are assembled below the frame of eliminate(), and that call chain is deep.)
[[gnu::noinline]] c2d_status factor(const Panel& panel, PivotStats* stats) {
  const int32_t rows = panel.plan.rows - panel.first, width = lu_width(rows);
  Real* corner = panel.columns + panel.first;
  int32_t* pivots = panel.pivots + panel.first; // relative to the corner until the end
  stats->base = panel.first;
  const Lu lu = {panel.engine, rows, panel.own, panel.count, corner, panel.ld, pivots, panel.norms, stats};
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < panel.own && status == C2D_OK; j += width) {
    // A column without a usable pivot: the body moves freely, or two equations are equal.
    if (lu_step(lu, j) > 0) return C2D_ERR_SINGULAR;
    status = notify(panel.watch, panel.first + j, panel.own - j < width ? panel.own - j : width);
  }
  if (status == C2D_OK) status = notify(panel.watch, panel.first + panel.own, panel.count - panel.own);
  if (status != C2D_OK) return status;
  // A later reader applies all exchanges of a panel first and updates afterwards, so L is stored in the
  // panel's final row order.
  if (!panel.last || panel.plan.keep_lower != 0) lu_settle(rows, panel.own, corner, panel.ld, pivots);
  // From now on pivots are absolute rows, for panels that start elsewhere.
  for (int32_t j = 0; j < panel.own; ++j) pivots[j] += panel.first;
  return C2D_OK;
}

// Packs rows `from` ... of a chunk into a buffer, without the gaps of the leading dimension, and starts to write them.
c2d_status write_part(const Panel& panel, int32_t tape, uint64_t block, const Chunk& chunk, int32_t from, int32_t rows) {
  const size_t column_bytes = static_cast<size_t>(rows) * sizeof(Real);
  int32_t slot;
  const c2d_status status = take_buffer(panel.buffers, &slot);
  if (status != C2D_OK) return status;
  unsigned char* to = panel.buffers.at(slot) + kBlockHeaderBytes;
  for (int32_t j = 0; j < chunk.count; ++j) {
    memcpy(to, panel.column(chunk.first - panel.first + j) + from, column_bytes);
    to += column_bytes;
  }
  return start_write(panel.buffers, slot, tape, block, static_cast<uint64_t>(chunk.count) * column_bytes);
}

// Writes L and U of a panel. `lower` and `upper` are its first chunks on entry, those of the next panel on return.
[[gnu::noinline]] c2d_status write_panel(const Panel& panel, Chunk& lower, Chunk& upper) {
  const EliminationPlan& plan = panel.plan;
  const EliminationPlan cut = upper_cut(plan);
  c2d_status status = C2D_OK;
  // No panel follows the last one, so its L is written only if new right-hand sides may follow (eliminate_again).
  const bool wanted = panel.own > 0 && (!panel.last || plan.keep_lower != 0);
  const int32_t own_end = wanted ? panel.first + panel.own : 0;
  for (; lower.first < own_end && status == C2D_OK; lower = next_strip(plan, lower))
    status =
        write_part(panel, C2D_TAPE_LOWER, plan.lower_first_block + lower.index, lower, lower.row, rows_of_strip(plan, lower));
  const int32_t end = plan.pivots > 0 ? panel.first + panel.count : 0;
  for (; upper.first < end && status == C2D_OK; upper = next_chunk(cut, upper))
    status = write_part(panel, C2D_TAPE_UPPER, plan.upper_first_block + upper.index, upper, 0,
                        upper.first < plan.pivots ? upper.first + upper.count : plan.pivots);
  return status;
}

c2d_status hand_over(const Panel& panel, const RowSink& sink) {
  // The last rows of the trailing columns are S: the equations that the contact system is made of.
  const int32_t trailing = panel.count - panel.own;
  if (trailing == 0) return C2D_OK;
  const int32_t first = panel.first + panel.own - panel.plan.pivots;
  return sink.take(sink.context, first, trailing, panel.column(panel.own) + panel.plan.pivots, panel.ld);
}

// The phases of one panel.
c2d_status do_panel(const Panel& panel, const ColumnSource& source, const RowSink& sink, Chunk& lower, Chunk& upper,
                    PivotStats* stats) {
  c2d_status status = fill(panel, source);
  if (status == C2D_OK) status = apply_earlier(panel);
  if (status == C2D_OK) status = factor(panel, stats);
  if (status == C2D_OK) status = write_panel(panel, lower, upper);
  if (status == C2D_OK) status = hand_over(panel, sink);
  return status;
}

int32_t between(int32_t low, int32_t x, int32_t high) { return x < low ? low : (x > high ? high : x); }

Buffers make_buffers(const EliminationPlan& plan, Tapes& tapes, void* base, uint64_t step) {
  return {tapes, static_cast<unsigned char*>(base), step, block_buffers(plan), 0, {}};
}

Panel make_panel(const EliminationPlan& plan, const WorkLayout& at, Buffers& buffers, void* work, const Watch& watch,
                 const Engine& engine) {
  unsigned char* base = static_cast<unsigned char*>(work);
  return Panel{plan,
               watch,
               reinterpret_cast<Real*>(base + at.panel),
               at.leading,
               buffers,
               reinterpret_cast<Real*>(base + at.norms),
               reinterpret_cast<int32_t*>(base + at.pivots),
               0,
               0,
               0,
               false,
               engine};
}

// Columns of panel p, and how many of them are eliminated: one panel may contain both kinds.
void place_panel(Panel& panel, int32_t p) {
  const EliminationPlan& plan = panel.plan;
  panel.first = p * plan.panel_columns;
  panel.count = between(0, plan.pivots + plan.trailing - panel.first, plan.panel_columns);
  panel.own = between(0, plan.pivots - panel.first, panel.count);
  panel.last = p == panel_count(plan) - 1;
  C2D_ASSERT(panel.count > 0 && panel.own >= 0 && panel.own <= panel.count && panel.count <= plan.panel_columns);
}

// ---- row exchanges on the tape --------------------------------------------------------------------------------------

uint64_t exchanges_bytes(const EliminationPlan& plan) { return static_cast<uint64_t>(plan.pivots) * sizeof(int32_t); }

// New right-hand sides need P as well as L. The exchanges are one block behind the blocks of L.
c2d_status keep_exchanges(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  if (plan.keep_lower == 0 || plan.pivots == 0) return C2D_OK;
  int32_t slot;
  const c2d_status status = take_buffer(panel.buffers, &slot);
  if (status != C2D_OK) return status;
  memcpy(panel.buffers.at(slot) + kBlockHeaderBytes, panel.pivots, static_cast<size_t>(exchanges_bytes(plan)));
  return start_write(panel.buffers, slot, C2D_TAPE_LOWER, plan.lower_first_block + exchanges_block(plan),
                     exchanges_bytes(plan));
}

c2d_status load_exchanges(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  if (plan.pivots == 0) return C2D_OK;
  unsigned char* block = panel.buffers.at(0);
  c2d_status status = read_block(panel.buffers.tapes, C2D_TAPE_LOWER, plan.lower_first_block + exchanges_block(plan), block,
                                 exchanges_bytes(plan));
  if (status == C2D_OK) memcpy(panel.pivots, block + kBlockHeaderBytes, static_cast<size_t>(exchanges_bytes(plan)));
  // A correct checksum does not prove that this library wrote the block. Every index is checked before it addresses memory.
  for (int32_t j = 0; j < plan.pivots && status == C2D_OK; ++j)
    if (panel.pivots[j] < j || panel.pivots[j] >= plan.rows) status = C2D_ERR_STORE_FORMAT;
  return status;
}

// Puts the new trailing columns of the panel in place of the old ones in the chunks of Y. A chunk at a border of the range
// also contains columns that stay, so it is read, changed and written again.
[[gnu::noinline]] c2d_status rewrite_trailing(const Panel& panel) {
  const EliminationPlan plan = upper_cut(panel.plan);
  if (plan.pivots == 0) return C2D_OK;
  const size_t column_bytes = static_cast<size_t>(plan.pivots) * sizeof(Real);
  const int32_t end = panel.first + panel.count;
  Chunk chunk = next_chunk(plan, chunk_before(plan, plan.pivots));
  for (; chunk.count > 0 && chunk.first < end; chunk = next_chunk(plan, chunk)) {
    if (chunk.first + chunk.count <= panel.first) continue;
    const uint64_t block = plan.upper_first_block + chunk.index, bytes = upper_bytes(plan, chunk);
    int32_t slot;
    c2d_status status = take_buffer(panel.buffers, &slot);
    if (status == C2D_OK) status = read_block(panel.buffers.tapes, C2D_TAPE_UPPER, block, panel.buffers.at(slot), bytes);
    if (status != C2D_OK) return status;
    unsigned char* data = panel.buffers.at(slot) + kBlockHeaderBytes;
    for (int32_t j = 0; j < chunk.count; ++j) {
      const int32_t column = chunk.first + j - panel.first;
      if (column < 0 || column >= panel.count) continue;
      memcpy(data + static_cast<size_t>(j) * column_bytes, panel.column(column), column_bytes);
    }
    status = start_write(panel.buffers, slot, C2D_TAPE_UPPER, block, bytes);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace

// Only the trailing columns pass through L again; A_o is neither assembled nor factored, METHOD 7.5.
c2d_status eliminate_again(const EliminationPlan& plan, int32_t first_trailing, const ColumnSource& source, const RowSink& sink,
                           Tapes& tapes, void* work, const Watch& watch, const Engine& engine) {
  const WorkLayout at = work_layout(plan);
  Buffers buffers = make_buffers(plan, tapes, static_cast<unsigned char*>(work) + at.block, at.block_step);
  Panel panel = make_panel(plan, at, buffers, work, watch, engine);
  c2d_status status = load_exchanges(panel);
  const int32_t end = plan.pivots + plan.trailing;
  for (panel.first = plan.pivots + first_trailing; panel.first < end && status == C2D_OK; panel.first += panel.count) {
    panel.count = between(0, end - panel.first, plan.panel_columns);
    status = fill(panel, source);
    if (status == C2D_OK) status = apply_earlier(panel);
    if (status == C2D_OK) status = rewrite_trailing(panel);
    if (status == C2D_OK) status = hand_over(panel, sink);
    if (status == C2D_OK) status = notify(watch, panel.first, panel.count);
  }
  return finish_all(buffers, status);
}

c2d_status eliminate(const EliminationPlan& plan, const ColumnSource& source, const RowSink& sink, Tapes& tapes, void* work,
                     PivotStats* stats, const Watch& watch, const Engine& engine) {
  PivotStats own_stats;
  PivotStats* used = stats ? stats : &own_stats;
  start_stats(*used);
  const WorkLayout at = work_layout(plan);
  Buffers buffers = make_buffers(plan, tapes, static_cast<unsigned char*>(work) + at.block, at.block_step);
  Panel panel = make_panel(plan, at, buffers, work, watch, engine);
  Chunk lower = first_chunk(plan), upper = first_chunk(upper_cut(plan));
  c2d_status status = C2D_OK;
  for (int32_t p = 0; p < panel_count(plan) && status == C2D_OK; ++p) {
    place_panel(panel, p);
    status = do_panel(panel, source, sink, lower, upper, used);
  }
  if (status == C2D_OK) status = keep_exchanges(panel);
  return finish_all(buffers, status);
}

// The same elimination in three steps for a body that fits into one panel. The first two steps do not use the tapes, so
// several bodies can run them at the same time, one per thread.
Real* only_panel(const EliminationPlan& plan, void* work, int64_t* ld) {
  const WorkLayout at = work_layout(plan);
  *ld = at.leading;
  return reinterpret_cast<Real*>(static_cast<unsigned char*>(work) + at.panel);
}

c2d_status factor_only_panel(const EliminationPlan& plan, Tapes& tapes, void* work, PivotStats& stats, const Engine& engine) {
  start_stats(stats);
  const WorkLayout at = work_layout(plan);
  Buffers buffers = make_buffers(plan, tapes, static_cast<unsigned char*>(work) + at.block, at.block_step);
  const Watch nobody = {nullptr, nullptr};
  Panel panel = make_panel(plan, at, buffers, work, nobody, engine);
  place_panel(panel, 0);
  const c2d_status status = find_norms(panel);
  return status == C2D_OK ? factor(panel, &stats) : status;
}

c2d_status write_only_panel(const EliminationPlan& plan, const RowSink& sink, Tapes& tapes, void* work, const Watch& watch) {
  const WorkLayout at = work_layout(plan);
  Buffers buffers = make_buffers(plan, tapes, static_cast<unsigned char*>(work) + at.block, at.block_step);
  Panel panel = make_panel(plan, at, buffers, work, watch, kPlainEngine);
  place_panel(panel, 0);
  Chunk lower = first_chunk(plan), upper = first_chunk(upper_cut(plan));
  c2d_status status = notify(watch, 0, panel.count);
  if (status == C2D_OK) status = write_panel(panel, lower, upper);
  if (status == C2D_OK) status = hand_over(panel, sink);
  if (status == C2D_OK) status = keep_exchanges(panel);
  return finish_all(buffers, status);
}

namespace {

// Distance between the buffers of back substitution. For strips it is at least the block that upper_cut() makes of them for
// some number of rows, so a body with fewer rows and the same cut needs no more.
uint64_t back_step(const EliminationPlan& plan) {
  const int32_t rows = plan.block_rows > 0 && plan.block_rows < plan.pivots ? plan.block_rows : plan.pivots;
  const uint64_t data = static_cast<uint64_t>(rows) * static_cast<uint64_t>(plan.block_columns);
  return (kBlockHeaderBytes + data * sizeof(Real) + 63) / 64 * 64;
}

// One chunk of back substitution. Trailing columns: x += Y c. Eliminated columns, from the last: solve with the diagonal
// triangle of U, then subtract its columns from the rows above.
void substitute(const EliminationPlan& plan, const Chunk& chunk, const Real* data, const Real* coefficient, Real* x) {
  const int32_t f = chunk.first, w = chunk.count;
  if (f < plan.pivots) {
    trsm_upper(kPlainEngine, w, 1, data + f, f + w, x + f, plan.pivots);
    gemm_minus(kPlainEngine, f, 1, w, data, f + w, x + f, plan.pivots, x, plan.pivots);
    return;
  }
  for (int32_t j = 0; j < w; ++j, data += plan.pivots) {
    const Real factor = coefficient[f - plan.pivots + j];
    for (int32_t i = 0; i < plan.pivots; ++i) x[i] += factor * data[i];
  }
}

} // namespace

uint64_t back_substitution_bytes(const EliminationPlan& plan) {
  return back_step(plan) * static_cast<uint64_t>(block_buffers(plan));
}

c2d_status back_substitute(const EliminationPlan& uncut, Tapes& tapes, const Real* coefficient, Real* x, void* work) {
  const EliminationPlan plan = upper_cut(uncut);
  if (plan.pivots == 0) return C2D_OK;
  for (int32_t i = 0; i < plan.pivots; ++i) x[i] = 0;
  // First x = Y c from the trailing chunks, then x := U^-1 x by block columns from the last to the first. One pass over the
  // tape serves both.
  Buffers buffers = make_buffers(uncut, tapes, work, back_step(uncut));
  Pass pass = backward(plan, buffers);
  for (;;) {
    Chunk chunk;
    const Real* data = nullptr;
    const c2d_status status = next_block(pass, chunk, &data);
    if (status != C2D_OK || chunk.count == 0) return finish_all(buffers, status);
    substitute(plan, chunk, data, coefficient, x);
  }
}

// f . x = f . (U^-1 Y c) = w . c with w = Y^T U^-T f. The chunks of U come first and turn f into U^-T f by forward
// substitution (U^T is lower triangular). The chunks of Y that follow give w.
namespace {

// Of columns first ... first + width - 1 of the factors the products of their first `rows` numbers with each functional:
// sum[j] of column j.
struct Products {
  const FunctionalTiles& tiles;
  int32_t count, rows;
  Real* const* f;
  Real sum[kWidestTile][kFunctionalsAtOnce];

  void find(const Real* data, int64_t ld, int32_t columns, int32_t n) {
    const Kernel* const kernel = tiles.kernel;
    if (kSmallCode || !kernel || columns != kernel->cols) {
      for (int32_t j = 0; j < columns; ++j) dots(n, data + j * ld, count, f, sum[j]);
      return;
    }
    Real* const packed = tiles.room + static_cast<int64_t>(rows) * tiles.lanes;
    kernel->to_rows(n, data, ld, packed);
    for (int32_t j = 0; j < columns; ++j)
      for (int32_t k = 0; k < kFunctionalsAtOnce; ++k) sum[j][k] = 0;
    for (int32_t k = 0; k < count; k += kernel->rows)
      kernel->tile(n, tiles.room + k, tiles.lanes, packed, sum[0] + k, kFunctionalsAtOnce);
    for (int32_t j = 0; j < columns; ++j)
      for (int32_t k = 0; k < count; ++k) sum[j][k] = -sum[j][k];
  }
  // f[k][i] is known.
  void keep(int32_t k, int32_t i) const {
    if (!kSmallCode && tiles.kernel) tiles.room[static_cast<int64_t>(i) * tiles.lanes + k] = f[k][i];
  }
};

// Columns i ... i + columns - 1 of U, in which the sums over the rows above i are known.
void solve_columns(const Products& products, const Real* data, int64_t ld, int32_t i, int32_t columns) {
  for (int32_t j = 0; j < columns; ++j) {
    const Real* const column = data + j * ld + i; // column i + j of U is row i + j of U^T
    for (int32_t k = 0; k < products.count; ++k) {
      Real sum = products.sum[j][k];
      Real* const f = products.f[k] + i;
      for (int32_t p = 0; p < j; ++p) sum += column[p] * f[p];
      f[j] = column[j] == Real(0) ? Real(0) : (f[j] - sum) / column[j];
      products.keep(k, i + j);
    }
  }
}

} // namespace

c2d_status transposed_functionals(const EliminationPlan& uncut, Tapes& tapes, int32_t count, Real* const* f, Real* const* w,
                                  void* work, const FunctionalTiles& tiles) {
  const EliminationPlan plan = upper_cut(uncut);
  if (plan.pivots == 0) {
    for (int32_t k = 0; k < count && w != nullptr; ++k)
      for (int32_t j = 0; j < plan.trailing; ++j) w[k][j] = 0;
    return C2D_OK;
  }
  Products products = {tiles, count, plan.pivots, f, {}};
  for (int64_t i = 0; i < plan.pivots * int64_t{tiles.lanes} && !kSmallCode && tiles.kernel; ++i) tiles.room[i] = 0;
  const int32_t width = !kSmallCode && tiles.kernel ? tiles.kernel->cols : 1;
  Buffers buffers = make_buffers(uncut, tapes, work, back_step(uncut));
  Pass pass = forward(plan, buffers, C2D_TAPE_UPPER, plan.pivots + (w != nullptr ? plan.trailing : 0));
  for (;;) {
    Chunk chunk;
    const Real* data = nullptr;
    const c2d_status status = next_block(pass, chunk, &data);
    if (status != C2D_OK || chunk.count == 0) return finish_all(buffers, status);
    const bool trailing = chunk.first >= plan.pivots;
    const int32_t rows = trailing ? plan.pivots : chunk.first + chunk.count;
    for (int32_t j = 0, columns; j < chunk.count; j += columns) {
      columns = chunk.count - j < width ? chunk.count - j : width;
      const Real* const first = data + static_cast<int64_t>(j) * rows;
      const int32_t i = chunk.first + j;
      products.find(first, rows, columns, trailing ? rows : i);
      if (!trailing) solve_columns(products, first, rows, i, columns);
      for (int32_t c = 0; c < columns && trailing; ++c)
        for (int32_t k = 0; k < count; ++k) w[k][i + c - plan.pivots] = products.sum[c][k];
    }
  }
}

c2d_status transposed_functional(const EliminationPlan& plan, Tapes& tapes, Real* f, Real* w, void* work) {
  return transposed_functionals(plan, tapes, 1, &f, w != nullptr ? &w : nullptr, work);
}

} // namespace c2d
