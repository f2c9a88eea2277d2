#pragma once
// Compressed elimination of one body (METHOD 7.6): the result of eliminate() at a cost that grows like the number of nodes.
//
// The nodes outside the contact are the leaves of a binary tree of clusters (elimination/cells.hpp). Only a few equations and
// unknowns of a cluster, its skeleton, represent it to the rest of the body: the other equations are combinations of these
// outside the cluster (linalg/interpolate.hpp). The differences are equations of the cluster alone, and eliminate as many of
// its unknowns. The contact, rho, omega and the holes (METHOD (4.1), with tr V as one more unknown each) form the border.
// Together with the root of the tree it is a small dense system, which eliminate() solves.
#include "bie/holes.hpp"
#include "elimination/eliminate.hpp"

namespace c2d {

struct CompressedPlan {
  int32_t nodes, columns; // of the body: functional nodes; unknowns outside the contact with rho and omega
  int32_t contact, loads; // contact unknowns; load cases
  int32_t tree, holes;    // nodes in the tree; holes
  int32_t rank, leaf;     // most equations and unknowns of a skeleton; nodes of a leaf, at most `rank`
  int32_t keeps;          // 1: all nodes are in the tree, and the data for additional right-hand sides are stored
  EliminationPlan border; // of the dense system; its blocks come first on both tapes
  uint64_t block_bytes;   // of data, in the blocks behind those of the border
};
constexpr int32_t kLeafNodes = 40;

// Does the node belong to the tree? Nodes in contact do not, unless the body has lazy columns.
bool is_tree_node(const Model& model, int b, int32_t node);
// Most holes that a body with so many regions may have. Elements on lines of symmetry can cut off more.
inline int32_t most_holes(int32_t regions) { return 2 * regions + 2; }
// False for bodies with equations of free zones, for rigid bodies, and for bodies with more holes than most_holes().
bool may_compress(const Model& model, int b);
// The plan of a body, with a border of one-column panels; cut_border() widens them. `rank` may exceed what the body can use.
CompressedPlan plan_compressed(const Model& model, int b, int32_t rank, int32_t leaf);
// A plan that bounds every body within these limits.
struct CompressedLimits {
  int32_t nodes, touching, contact, loads, holes, keeps;
};
CompressedPlan plan_compressed(const CompressedLimits& limits, int32_t rank, int32_t leaf);
// Cuts the border into panels for a work area of `bytes` bytes. Errors: C2D_ERR_MEMORY, with *needed = the bytes that are
// enough.
c2d_status cut_border(uint64_t bytes, CompressedPlan& plan, uint64_t* needed);
// The plan of a body from its border, cut and placed on the tapes; and whether a given border can belong to the body.
CompressedPlan plan_around(const Model& model, int b, const EliminationPlan& border);
bool is_border(const Model& model, int b, const EliminationPlan& border);

// Upper bounds, known beforehand: of the work area, of the blocks on the tapes and of their largest data. UPPER: also for any
// body within the plan's numbers whose border has the same cut.
uint64_t compressed_bytes(const CompressedPlan& plan);
TapeUse compressed_lower_use(const CompressedPlan& plan);
TapeUse compressed_upper_use(const CompressedPlan& plan);

// Ranks found during an elimination.
struct CompressedStats {
  int32_t largest_rank;
  int64_t ranks, clusters; // sum of the ranks, and of how many clusters
};

// As eliminate(), with the same rows for the sink. The system's sources are placed, and its diagonal is filled unless
// elimination/far_sums.hpp does it here. C2D_ERR_MEMORY: a cluster needs a skeleton larger than `rank`; stats->largest_rank is
// the size it needs.
c2d_status eliminate_compressed(const CompressedPlan& plan, const ColumnSystem& system, const RowSink& sink, Tapes& tapes,
                                void* work, PivotStats* pivots, CompressedStats* stats, const Watch& watch,
                                const Engine& engine);

// As back_substitute() and transposed_functional(). Without w, f is unchanged.
uint64_t compressed_back_bytes(const CompressedPlan& plan);
c2d_status back_substitute_compressed(const CompressedPlan& plan, Tapes& tapes, const Real* coefficient, Real* x, void* work);
c2d_status compressed_functional(const CompressedPlan& plan, Tapes& tapes, Real* f, Real* w, void* work);
// As back_substitute_compressed() with a right-hand side of random signs: shows how much round-off in the equations grows.
c2d_status substitute_noise(const CompressedPlan& plan, Tapes& tapes, Real* x, void* work);

// Residual of some equations spread over the body, which are assembled anew: its root mean square, and its largest value over
// the largest term. `diagonal`, `point` and `twin` of the system are not read. work: compressed_check_bytes.
struct Remainder {
  double mean, relative;
};
uint64_t compressed_check_bytes(const CompressedPlan& plan);
c2d_status check_compressed(const CompressedPlan& plan, const ColumnSystem& system, Tapes& tapes, const Real* coefficient,
                            const Real* x, void* work, Remainder* out);

} // namespace c2d
