#pragma once
// Additional right-hand sides for a compressed elimination: contact tractions, for the columns of a contact system with lazy
// columns (METHOD 10.12). They pass through the stored factors of the tree, from the leaves to the root and back, many side by
// side.
#include "elimination/compressed_work.hpp"

namespace c2d {

constexpr int32_t kMostSides = 48; // side by side: two tiles of the widest kernel

// Counts before the numbers of a cluster, elimination/compressed_kept.cpp. For the border: rows of its matrix; rows and
// columns of the root; sums over the boundary.
struct KeptCluster {
  int32_t spare, rows, columns, rest; // own equations, skeleton rows; skeleton columns, other columns
  int32_t half_rows, half_columns;    // of its first half; -1: it is a leaf
};

// Upper bound for kMostSides of them side by side, for a plan with `keeps`.
uint64_t later_sides_bytes(const CompressedPlan& plan);

// Where tractions act: contact unknowns of the body, and how large they are.
struct LaterSides {
  const CompressedPlan& plan;
  const ColumnSystem& system; // of the whole body; its sources are placed
  Tapes& tapes;
  void* work; // later_sides_bytes
  Engine engine;
};
// Unknowns outside the contact, in their usual numbering, under a unit traction at each of `count` contact unknowns of the
// body, at most kMostSides: (*x)[column * count + k], in the work area. Errors: those of the tapes; C2D_ERR_INTERNAL: the
// tapes do not contain such data.
c2d_status solve_unit_tractions(const LaterSides& s, const int32_t* unknown, int32_t count, Real** x);
// Unknowns outside the contact under each rigid-body mode that nothing in the body's equations constrains (motions_held),
// without tractions, side by side as above.
c2d_status solve_motions(const LaterSides& s, Real** x);
// x += the effect of all contact tractions together, `traction` by contact unknown of the body.
c2d_status add_tractions(const LaterSides& s, const Real* traction, Real* x);

// Unknowns of the clusters, from the root to the leaves. On entry x[column * count + k] contains h of each cluster and the
// unknowns of the border. room: sides_room() numbers; work: compressed_back_bytes (compressed_back.cpp).
int64_t sides_room(const CompressedPlan& plan);
c2d_status carry_down(const CompressedPlan& plan, Tapes& tapes, const Engine& engine, int32_t count, Real* x, Real* room,
                      void* work);

} // namespace c2d
