#pragma once
// Streamed elimination (METHOD 7.1): [ A_o | B ] with A_o of rows x pivots and B of rows x trailing becomes, with partial
// pivoting over all remaining rows,
//     P [ A_o | B ] = [ L_1   ] [ U  Y ]        U pivots x pivots, Y pivots x trailing,
//                     [ L_2 I ] [ 0  S ]        S (rows - pivots) x trailing.
// S goes to the sink. U and Y go to tape UPPER for back substitution. L goes to tape LOWER if it is needed again. Left-looking
// by panels: the whole matrix never exists in memory. A panel is filled, updated with the blocks of L before it, factored, and
// written. (Partial forward elimination: figure 20 of the thesis.)
#include "elimination/plan.hpp"
#include "linalg/lu.hpp"
#include "store/tapes.hpp"

namespace c2d {

// The source of columns. `fill` assigns all rows of columns first ... first+count-1 to panel[i + j * ld]. Every column is
// requested once, in order. A status other than C2D_OK ends the elimination with it. Numbers must be finite.
struct ColumnSource {
  void* context;
  c2d_status (*fill)(void* context, int32_t first, int32_t count, Real* panel, int64_t ld);
};

// Receives S: rows[i + j * ld], i < rows - pivots, of trailing columns first_trailing ... first_trailing+count-1 (counted from
// 0). Every column comes once, in order.
struct RowSink {
  void* context;
  c2d_status (*take)(void* context, int32_t first_trailing, int32_t count, const Real* rows, int64_t ld);
};

// Called for every column when it has been filled and again when it has been eliminated or updated, and after every block of
// L. A status other than C2D_OK stops at once. Null `step`: no calls.
struct Watch {
  void* context;
  c2d_status (*step)(void* context, int32_t column);
};

// Before the first elimination of a preparation the caller begins a new run or new generations of both tapes: a block of an
// earlier attempt then cannot pass for a block of this one whose write was lost. Tapes UPPER and LOWER (if lower_use
// has blocks) are open with room for the plan's blocks; the caller syncs them. `work`: elimination_bytes(...) bytes, aligned to
// 64. `stats` is started anew; null: not wanted. Errors: those of source, sink, watch and the tapes (details in tapes.error);
// C2D_ERR_SINGULAR: the columns stats->first_unusable ... have no usable pivot; C2D_ERR_INTERNAL: a number is not finite. The
// engine decides the speed and the last digits. After an error the contents of the tapes are useless.
c2d_status eliminate(const EliminationPlan& plan, const ColumnSource& source, const RowSink& sink, Tapes& tapes, void* work,
                     PivotStats* stats, const Watch& watch, const Engine& engine = kPlainEngine);

// The same in steps, for a plan of one panel: the columns are assembled at the place that only_panel() returns, factored, and
// the results written. Only the last step uses the tapes, so the others may run beside those of other eliminations, each with
// its own work area. The watch is called in the last step only. The bits are those of `eliminate`.
Real* only_panel(const EliminationPlan& plan, void* work, int64_t* ld);
c2d_status factor_only_panel(const EliminationPlan& plan, Tapes& tapes, void* work, PivotStats& stats, const Engine& engine);
c2d_status write_only_panel(const EliminationPlan& plan, const RowSink& sink, Tapes& tapes, void* work, const Watch& watch);

// Replaces the trailing columns first_trailing ... (from 0) of an elimination whose plan stores all of L. The source gives the
// new columns; the row exchanges and L are applied; the results replace their part of Y on tape UPPER, and their rows of S go
// to the sink. Reads LOWER once per panel of new columns. Arguments and errors as for `eliminate`.
c2d_status eliminate_again(const EliminationPlan& plan, int32_t first_trailing, const ColumnSource& source, const RowSink& sink,
                           Tapes& tapes, void* work, const Watch& watch, const Engine& engine = kPlainEngine);

// Bytes of the work area of back_substitute, which may be the one of `eliminate`.
uint64_t back_substitution_bytes(const EliminationPlan& plan);

// Solves A_o x = sum over k of coefficient[k] B_k in the first `pivots` rows of the eliminated system. If A_o x = B c has a
// solution, this is it. coefficient[0 .. trailing), x[0 .. pivots). Reads every block of UPPER once. `work` as above, aligned
// to 64. Errors: those of the tape.
c2d_status back_substitute(const EliminationPlan& plan, Tapes& tapes, const Real* coefficient, Real* x, void* work);

// The adjoint of back_substitute: for weights f of the unknowns, w with f . x = w . coefficient for every coefficient
// (w = f^T U^-1 Y). A functional of the solution thus costs one pass, and then a product of length `trailing` per state. On
// return f[0 .. pivots) is U^-T f. Reads every block of UPPER once. Without w it stops at U^-T f. `work` and errors as for
// back_substitute.
c2d_status transposed_functional(const EliminationPlan& plan, Tapes& tapes, Real* f, Real* w, void* work);
// The same of several functionals in one pass: f[i], w[i] of each. With `tiles` their sums are formed by its kernel; their last
// digits are then those of its instruction set.
struct FunctionalTiles {
  const Kernel* kernel; // null: none; its tiles are at most kWidestTile wide
  Real* room;           // functional_tiles(lanes, pivots)
  int32_t lanes;        // at least as many as there are functionals, a multiple of the kernel's rows
};
constexpr int32_t kTiledFunctionals = 24; // whole tiles of every kernel
constexpr int32_t kFunctionalsAtOnce = kSmallCode ? 1 : 4 * kTiledFunctionals;
c2d_status transposed_functionals(const EliminationPlan& plan, Tapes& tapes, int32_t count, Real* const* f, Real* const* w,
                                  void* work, const FunctionalTiles& tiles = {});
// Numbers: all functionals, entry by entry, and beside them as many columns of the factors as a tile is wide.
constexpr int32_t kWidestTile = 8;
inline int64_t functional_tiles(int32_t lanes, int64_t pivots) { return pivots * (lanes + kWidestTile); }

} // namespace c2d
