#pragma once
// Right-hand sides that come after a compressed elimination: tractions of the contact, for the columns of a contact system that
// are asked for (METHOD 10.12). They go through what the tree has kept, from the leaves to the root and back, many side by
// side.
#include "elimination/compressed_work.hpp"

namespace c2d {

constexpr int32_t kMostSides = 48; // side by side: two tiles of the widest kernel

// What stands before the numbers of a cell, elimination/compressed_kept.cpp. Of the border: rows of its matrix; equations and
// columns of the root; sums over the boundary.
struct KeptCell {
  int32_t spare, rows, columns, rest; // equations of its own, those that stand for it; columns that stand for it, others
  int32_t half_rows, half_columns;    // of its first half; -1: it is a leaf
};

// Of a plan that keeps what they go through. Upper bound, for so many of them side by side.
uint64_t later_sides_bytes(const CompressedPlan& plan);

// Where tractions act: contact unknowns of the body, and how large they are.
struct LaterSides {
  const CompressedPlan& plan;
  const ColumnSystem& system; // of the whole body; its sources are placed
  Tapes& tapes;
  void* work; // later_sides_bytes
  Engine engine;
};
// Unknowns outside the contact, numbered as ever, that a traction of 1 brings at each of `count` contact unknowns of the body,
// at most kMostSides: (*x)[column * count + k], in the work area. Errors: those of the tapes; C2D_ERR_INTERNAL: they hold
// nothing of the kind.
c2d_status solve_unit_tractions(const LaterSides& s, const int32_t* unknown, int32_t count, Real** x);
// Unknowns outside the contact under each motion of the body that nothing in its equations holds (motions_held), to which no
// traction belongs, side by side as above.
c2d_status solve_motions(const LaterSides& s, Real** x);
// What all contact tractions together bring, `traction` by contact unknown of the body: x += that.
c2d_status add_tractions(const LaterSides& s, const Real* traction, Real* x);

// Unknowns of a cell from those it kept, cell by cell from the root to the leaves: x[column * count + k] holds what the others
// bring to each, and those of the border. room: later_room() numbers; work: compressed_back_bytes (compressed_back.cpp).
int64_t later_room(const CompressedPlan& plan);
c2d_status carry_down(const CompressedPlan& plan, Tapes& tapes, const Engine& engine, int32_t count, Real* x, Real* room,
                      void* work);

} // namespace c2d
