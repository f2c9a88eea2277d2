#include "elimination/eliminate.hpp"
#include "linalg/dense.hpp"
#include "memory/hostile.hpp"
#include <string.h>

namespace c2d {
namespace {

// The panel in memory and everything needed to work on it.
struct Panel {
  const EliminationPlan& plan;
  Tapes& tapes;
  const Watch& watch;
  Real* columns; // rows x count
  int64_t ld;
  unsigned char* block; // header room and data of one block
  Real* norms;          // largest entry of each column as filled
  int32_t* pivots;      // for all eliminated columns, absolute rows
  int32_t first, count; // columns of the matrix
  int32_t own;          // how many of them are eliminated
  bool last;            // no panel comes after it
  const Engine& engine;

  Real* column(int32_t j) const { return columns + j * ld; }
  Real* data() const { return reinterpret_cast<Real*>(block + kBlockHeaderBytes); }
};

c2d_status tell(const Watch& watch, int32_t first, int32_t count) {
  for (int32_t j = first; watch.step && j < first + count; ++j) {
    const c2d_status status = watch.step(watch.context, j);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

c2d_status fill(const Panel& panel, const ColumnSource& source) {
  const int32_t rows = panel.plan.rows;
  const c2d_status status = source.fill(source.context, panel.first, panel.count, panel.columns, panel.ld);
  if (status != C2D_OK) return status;
  for (int32_t j = 0; j < panel.count; ++j) {
    if (!all_finite(rows, panel.column(j))) return C2D_ERR_INTERNAL;
    panel.norms[j] = largest(panel.engine, rows, panel.column(j));
  }
  return tell(panel.watch, panel.first, panel.count);
}

// Columns [from, from+count) of the panel are updated by w columns of L, which start in row and column f of
// the matrix and have the leading dimension ldl. Their rows have been exchanged already.
void update(const Panel& panel, int32_t from, int32_t count, const Real* l, int64_t ldl, int32_t f,
            int32_t w) {
  update_by(panel.engine, w, panel.plan.rows - f - w, count, l, ldl, panel.column(from) + f, panel.ld);
}

// Bring a panel up to date with the panels before it. The blocks of L of a panel are as they were when it was
// factored: the row exchanges of later panels never reached them, so exchanges and blocks are applied panel
// after panel.
c2d_status apply_earlier(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  int32_t exchanged = 0;
  Chunk chunk = first_chunk(plan);
  while (chunk.first < plan.pivots && chunk.first < panel.first) {
    if (chunk.first == exchanged) {
      const int32_t left = plan.pivots - exchanged;
      const int32_t count = left < plan.panel_columns ? left : plan.panel_columns;
      apply_pivots(panel.count, panel.columns, panel.ld, panel.pivots, exchanged, count);
      exchanged += count;
    }
    c2d_status status = read_block(panel.tapes, C2D_TAPE_LOWER, plan.lower_first_block + chunk.index,
                                   panel.block, lower_bytes(plan, chunk));
    if (status != C2D_OK) return status;
    update(panel, 0, panel.count, panel.data(), plan.rows - chunk.first, chunk.first, chunk.count);
    status = tell(panel.watch, panel.first, 1);
    if (status != C2D_OK) return status;
    chunk = next_chunk(plan, chunk);
  }
  return C2D_OK;
}

// Factor the panel's own columns, and update trailing columns that are in the same panel.
c2d_status factor(const Panel& panel, PivotStats* stats) {
  const int32_t rows = panel.plan.rows - panel.first, width = lu_width(rows);
  Real* corner = panel.columns + panel.first;
  int32_t* pivots = panel.pivots + panel.first; // relative to the corner until the end
  stats->base = panel.first;
  const Lu lu = {panel.engine, rows, panel.own, panel.count, corner, panel.ld, pivots, panel.norms, stats};
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < panel.own && status == C2D_OK; j += width) {
    if (lu_step(lu, j) > 0) return C2D_ERR_SINGULAR;
    status = tell(panel.watch, panel.first + j, panel.own - j < width ? panel.own - j : width);
  }
  if (status == C2D_OK) status = tell(panel.watch, panel.first + panel.own, panel.count - panel.own);
  if (status != C2D_OK) return status;
  // Whoever reads L again exchanges all of a panel's rows first, then updates.
  if (!panel.last || panel.plan.keep_lower != 0) lu_settle(rows, panel.own, corner, panel.ld, pivots);
  for (int32_t j = 0; j < panel.own; ++j) pivots[j] += panel.first;
  return C2D_OK;
}

// Put rows [from, from+rows) of a chunk into the block buffer, without gaps, and write them.
c2d_status write_part(const Panel& panel, int32_t tape, uint64_t block, const Chunk& chunk, int32_t from,
                      uint64_t data_bytes) {
  const size_t column_bytes = static_cast<size_t>(data_bytes / static_cast<uint64_t>(chunk.count));
  unsigned char* to = panel.block + kBlockHeaderBytes;
  for (int32_t j = 0; j < chunk.count; ++j) {
    memcpy(to, panel.column(chunk.first - panel.first + j) + from, column_bytes);
    to += column_bytes;
  }
  return write_block(panel.tapes, tape, block, panel.block, data_bytes);
}

c2d_status write_panel(const Panel& panel, Chunk chunk) {
  const EliminationPlan& plan = panel.plan;
  for (; chunk.count > 0 && chunk.first < panel.first + panel.count; chunk = next_chunk(plan, chunk)) {
    c2d_status status = C2D_OK;
    if (chunk.first < plan.pivots && (!panel.last || plan.keep_lower != 0)) {
      status = write_part(panel, C2D_TAPE_LOWER, plan.lower_first_block + chunk.index, chunk, chunk.first,
                          lower_bytes(plan, chunk));
    }
    if (status == C2D_OK && plan.pivots > 0) {
      status = write_part(panel, C2D_TAPE_UPPER, plan.upper_first_block + chunk.index, chunk, 0,
                          upper_bytes(plan, chunk));
    }
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

c2d_status hand_over(const Panel& panel, const RowSink& sink) {
  const int32_t trailing = panel.count - panel.own;
  if (trailing == 0 || !sink.take) return C2D_OK;
  const int32_t first = panel.first + panel.own - panel.plan.pivots;
  return sink.take(sink.context, first, trailing, panel.column(panel.own) + panel.plan.pivots, panel.ld);
}

c2d_status do_panel(const Panel& panel, const ColumnSource& source, const RowSink& sink, const Chunk& chunk,
                    PivotStats* stats) {
  c2d_status status = fill(panel, source);
  if (status == C2D_OK) status = apply_earlier(panel);
  if (status == C2D_OK) status = factor(panel, stats);
  if (status == C2D_OK) status = write_panel(panel, chunk);
  if (status == C2D_OK) status = hand_over(panel, sink);
  return status;
}

int32_t between(int32_t low, int32_t x, int32_t high) {
  return x < low ? low : (x > high ? high : x);
}

Panel make_panel(const EliminationPlan& plan, Tapes& tapes, void* work, const Watch& watch, const Engine& engine) {
  const WorkLayout at = work_layout(plan.rows, plan.pivots, plan.panel_columns, plan.block_columns);
  unsigned char* base = static_cast<unsigned char*>(work);
  return Panel{plan,
               tapes,
               watch,
               reinterpret_cast<Real*>(base + at.panel),
               at.leading,
               base + at.block,
               reinterpret_cast<Real*>(base + at.norms),
               reinterpret_cast<int32_t*>(base + at.pivots),
               0,
               0,
               0,
               false,
               engine};
}

// ---- row exchanges on the tape --------------------------------------------------------------------------------------

uint64_t exchanges_bytes(const EliminationPlan& plan) { return static_cast<uint64_t>(plan.pivots) * sizeof(int32_t); }

c2d_status keep_exchanges(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  if (plan.keep_lower == 0 || plan.pivots == 0) return C2D_OK;
  memcpy(panel.block + kBlockHeaderBytes, panel.pivots, static_cast<size_t>(exchanges_bytes(plan)));
  return write_block(panel.tapes, C2D_TAPE_LOWER, plan.lower_first_block + exchanges_block(plan), panel.block,
                     exchanges_bytes(plan));
}

c2d_status load_exchanges(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  if (plan.pivots == 0) return C2D_OK;
  const c2d_status status = read_block(panel.tapes, C2D_TAPE_LOWER, plan.lower_first_block + exchanges_block(plan),
                                       panel.block, exchanges_bytes(plan));
  if (status == C2D_OK)
    memcpy(panel.pivots, panel.block + kBlockHeaderBytes, static_cast<size_t>(exchanges_bytes(plan)));
  return status;
}

// The panel's columns, all trailing ones, take their places in the chunks of Y.
c2d_status rewrite_trailing(const Panel& panel) {
  const EliminationPlan& plan = panel.plan;
  if (plan.pivots == 0) return C2D_OK;
  const size_t column_bytes = static_cast<size_t>(plan.pivots) * sizeof(Real);
  const int32_t end = panel.first + panel.count;
  Chunk chunk = next_chunk(plan, chunk_before(plan, plan.pivots));
  for (; chunk.count > 0 && chunk.first < end; chunk = next_chunk(plan, chunk)) {
    if (chunk.first + chunk.count <= panel.first) continue;
    const uint64_t block = plan.upper_first_block + chunk.index, bytes = upper_bytes(plan, chunk);
    c2d_status status = read_block(panel.tapes, C2D_TAPE_UPPER, block, panel.block, bytes);
    if (status != C2D_OK) return status;
    for (int32_t j = 0; j < chunk.count; ++j) {
      const int32_t column = chunk.first + j - panel.first;
      if (column < 0 || column >= panel.count) continue;
      memcpy(panel.block + kBlockHeaderBytes + static_cast<size_t>(j) * column_bytes, panel.column(column), column_bytes);
    }
    status = write_block(panel.tapes, C2D_TAPE_UPPER, block, panel.block, bytes);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace

c2d_status eliminate_again(const EliminationPlan& plan, int32_t first_trailing, const ColumnSource& source,
                           const RowSink& sink, Tapes& tapes, void* work, const Watch& watch, const Engine& engine) {
  Panel panel = make_panel(plan, tapes, work, watch, engine);
  c2d_status status = load_exchanges(panel);
  const int32_t end = plan.pivots + plan.trailing;
  for (panel.first = plan.pivots + first_trailing; panel.first < end && status == C2D_OK; panel.first += panel.count) {
    panel.count = between(0, end - panel.first, plan.panel_columns);
    status = fill(panel, source);
    if (status == C2D_OK) status = apply_earlier(panel);
    if (status == C2D_OK) status = rewrite_trailing(panel);
    if (status == C2D_OK) status = hand_over(panel, sink);
    if (status == C2D_OK) status = tell(watch, panel.first, panel.count);
  }
  return status;
}

c2d_status eliminate(const EliminationPlan& plan, const ColumnSource& source, const RowSink& sink,
                     Tapes& tapes, void* work, PivotStats* stats, const Watch& watch, const Engine& engine) {
  PivotStats own_stats;
  PivotStats* used = stats ? stats : &own_stats;
  start_stats(*used);
  Panel panel = make_panel(plan, tapes, work, watch, engine);
  const int32_t columns = plan.pivots + plan.trailing, panels = panel_count(plan);
  Chunk chunk = first_chunk(plan);
  for (int32_t p = 0; p < panels; ++p) {
    panel.first = p * plan.panel_columns;
    panel.count = between(0, columns - panel.first, plan.panel_columns);
    panel.own = between(0, plan.pivots - panel.first, panel.count);
    panel.last = p == panels - 1;
    C2D_ASSERT(panel.count > 0 && panel.own >= 0 && panel.own <= panel.count && panel.count <= plan.panel_columns);
    while (chunk.first < panel.first) chunk = next_chunk(plan, chunk);
    const c2d_status status = do_panel(panel, source, sink, chunk, used);
    if (status != C2D_OK) return status;
  }
  return keep_exchanges(panel);
}

uint64_t back_substitution_bytes(const EliminationPlan& plan) {
  const uint64_t data = static_cast<uint64_t>(plan.pivots) * static_cast<uint64_t>(plan.block_columns);
  return kBlockHeaderBytes + data * sizeof(Real);
}

c2d_status back_substitute(const EliminationPlan& plan, Tapes& tapes, const Real* coefficient, Real* x,
                           void* work) {
  if (plan.pivots == 0) return C2D_OK;
  const Real* data = reinterpret_cast<const Real*>(static_cast<unsigned char*>(work) + kBlockHeaderBytes);
  const uint64_t first_block = plan.upper_first_block;
  for (int32_t i = 0; i < plan.pivots; ++i) x[i] = 0;
  // x = Y c: chunks of the trailing columns follow those of the eliminated ones.
  Chunk chunk = next_chunk(plan, chunk_before(plan, plan.pivots));
  for (; chunk.count > 0; chunk = next_chunk(plan, chunk)) {
    const c2d_status status =
        read_block(tapes, C2D_TAPE_UPPER, first_block + chunk.index, work, upper_bytes(plan, chunk));
    if (status != C2D_OK) return status;
    for (int32_t j = 0; j < chunk.count; ++j) {
      const Real factor = coefficient[chunk.first - plan.pivots + j];
      const Real* column = data + static_cast<int64_t>(j) * plan.pivots;
      for (int32_t i = 0; i < plan.pivots; ++i) x[i] += factor * column[i];
    }
  }
  // x := U^-1 x, by block columns from the last to the first.
  for (int32_t end = plan.pivots; end > 0; end = chunk.first) {
    chunk = chunk_before(plan, end);
    const int32_t f = chunk.first, w = chunk.count;
    const c2d_status status =
        read_block(tapes, C2D_TAPE_UPPER, first_block + chunk.index, work, upper_bytes(plan, chunk));
    if (status != C2D_OK) return status;
    trsm_upper(kPlainEngine, w, 1, data + f, end, x + f, plan.pivots);
    gemm_minus(kPlainEngine, f, 1, w, data, end, x + f, plan.pivots, x, plan.pivots);
  }
  return C2D_OK;
}

namespace {

Real dot(int32_t n, const Real* a, const Real* b) {
  Real sum = 0;
  for (int32_t i = 0; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

} // namespace

c2d_status transposed_functional(const EliminationPlan& plan, Tapes& tapes, Real* f, Real* w, void* work) {
  if (plan.pivots == 0) {
    for (int32_t j = 0; j < plan.trailing; ++j) w[j] = 0;
    return C2D_OK;
  }
  const Real* data = reinterpret_cast<const Real*>(static_cast<unsigned char*>(work) + kBlockHeaderBytes);
  for (Chunk chunk = first_chunk(plan); chunk.count > 0; chunk = next_chunk(plan, chunk)) {
    const c2d_status status =
        read_block(tapes, C2D_TAPE_UPPER, plan.upper_first_block + chunk.index, work, upper_bytes(plan, chunk));
    if (status != C2D_OK) return status;
    const bool trailing = chunk.first >= plan.pivots;
    const int32_t rows = trailing ? plan.pivots : chunk.first + chunk.count;
    for (int32_t j = 0; j < chunk.count; ++j) {
      const Real* column = data + static_cast<int64_t>(j) * rows;
      if (trailing) {
        w[chunk.first - plan.pivots + j] = dot(rows, column, f);
        continue;
      }
      const int32_t i = chunk.first + j; // forward substitution: U^T is lower triangular
      const Real diagonal = column[i];
      f[i] = diagonal == Real(0) ? Real(0) : (f[i] - dot(i, column, f)) / diagonal;
    }
  }
  return C2D_OK;
}

} // namespace c2d
