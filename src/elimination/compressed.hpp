#pragma once
// Compressed elimination of one body's equations (METHOD 7.6): what eliminate() does, at a cost that grows like the number of
// nodes. The nodes outside the contact are the leaves of a tree (elimination/cells.hpp). Of a cell's equations and unknowns
// only few say anything about the rest of the body: the other equations are combinations of these as far as the rest goes
// (linalg/interpolate.hpp), so that their differences are equations of the cell alone, with which as many of its unknowns are
// eliminated. What the contact, rho, omega and the holes (METHOD (4.1), tr V being one more unknown each) have is the border:
// with what the root of the tree is left with it is a small dense system, which eliminate() takes.
#include "bie/holes.hpp"
#include "elimination/eliminate.hpp"

namespace c2d {

struct CompressedPlan {
  int32_t nodes, columns; // of the body: functional nodes; unknowns outside the contact with rho and omega
  int32_t contact, loads; // contact unknowns; load cases
  int32_t tree, holes;    // nodes in the tree; holes
  int32_t rank, leaf;     // most equations and unknowns that a cell may keep; nodes of a leaf, at most `rank`
  int32_t keeps;          // 1: all nodes are in the tree, and it keeps what later right-hand sides go through
  EliminationPlan border; // of the dense system; its blocks come first on both tapes
  uint64_t block_bytes;   // of data, of the blocks behind them
};
constexpr int32_t kLeafNodes = 40;

// Does a node go into the tree? Those do without a part in the contact.
bool is_tree_node(const Model& model, int b, int32_t node);
// How many holes the body's plan may count, by its regions. With elements on lines of symmetry there may be more.
inline int32_t most_holes(int32_t regions) { return 2 * regions + 2; }
// Not for bodies with equations of free zones, nor with more holes than that.
bool may_compress(const Model& model, int b);
// The plan of a body but for how its border is cut, of which every column is a panel. `rank` may be more than is of use.
CompressedPlan plan_compressed(const Model& model, int b, int32_t rank, int32_t leaf);
// One that no body with at most so many nodes, of them so many in contact, contact unknowns and holes goes beyond.
struct CompressedLimits {
  int32_t nodes, touching, contact, loads, holes, keeps;
};
CompressedPlan plan_compressed(const CompressedLimits& limits, int32_t rank, int32_t leaf);
// Cuts the border for a work area of `bytes` bytes. Errors: C2D_ERR_MEMORY, with *needed = the bytes that would do.
c2d_status cut_border(uint64_t bytes, CompressedPlan& plan, uint64_t* needed);
// The plan of a body whose border is cut and has its place on the tapes; and whether a border can be one.
CompressedPlan plan_around(const Model& model, int b, const EliminationPlan& border);
bool is_border(const Model& model, int b, const EliminationPlan& border);

// Upper bounds, known before: of the work area, of blocks of the tapes and of their largest data; UPPER also for any body
// within the plan's numbers whose border is cut alike.
uint64_t compressed_bytes(const CompressedPlan& plan);
TapeUse compressed_lower_use(const CompressedPlan& plan);
TapeUse compressed_upper_use(const CompressedPlan& plan);

// What has been found on the way.
struct CompressedStats {
  int32_t largest_rank;
  int64_t ranks, cells; // sum of the ranks of so many cells
};

// As eliminate(), with the same rows going to the sink. The system's sources are placed, and its diagonal is filled unless
// elimination/far_sums.hpp says that it is done here.
// C2D_ERR_MEMORY: a cell would keep more than `rank`; then stats->largest_rank is what that cell asks for.
c2d_status eliminate_compressed(const CompressedPlan& plan, const ColumnSystem& system, const RowSink& sink, Tapes& tapes,
                                void* work, PivotStats* pivots, CompressedStats* stats, const Watch& watch,
                                const Engine& engine);

// As back_substitute() and transposed_functional(); without w, f comes back as it is.
uint64_t compressed_back_bytes(const CompressedPlan& plan);
c2d_status back_substitute_compressed(const CompressedPlan& plan, Tapes& tapes, const Real* coefficient, Real* x, void* work);
c2d_status compressed_functional(const CompressedPlan& plan, Tapes& tapes, Real* f, Real* w, void* work);
// As back_substitute_compressed with right-hand sides of 1 and -1 at random: how much round-off of the equations grows.
c2d_status substitute_noise(const CompressedPlan& plan, Tapes& tapes, Real* x, void* work);

// What x leaves of some equations, spread over the whole body, that are assembled anew: the mean square root, and the largest
// over the largest term. Of the system `diagonal`, `point` and `twin` are not looked at. work: compressed_check_bytes.
struct Remainder {
  double mean, relative;
};
uint64_t compressed_check_bytes(const CompressedPlan& plan);
c2d_status check_compressed(const CompressedPlan& plan, const ColumnSystem& system, Tapes& tapes, const Real* coefficient,
                            const Real* x, void* work, Remainder* out);

} // namespace c2d
