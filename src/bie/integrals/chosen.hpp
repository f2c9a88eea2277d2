#pragma once
// Parts of a body's equations: those at chosen nodes, in chosen columns. Used by compressed elimination (METHOD 7.6).
#include "bie/columns.hpp"

namespace c2d {

// The system whose sources are these nodes, in any order; `point` [2 count] and `twin` [count] are filled from those of the
// whole body. Nodes without collocation are allowed.
ColumnSystem choose_nodes(const ColumnSystem& whole, const int32_t* node, int32_t count, double* point, int32_t* twin);
// The same for points off the boundary, without images: node [count] and twin [count] are filled.
ColumnSystem choose_points(const ColumnSystem& whole, double* point, int32_t count, int32_t* node, int32_t* twin);

struct ChosenColumns {
  const int32_t* place;    // of every column of the body except the right-hand sides: its place in the result; -1: none
  int32_t count;           // of places
  const int32_t* elements; // [element_count] all elements with a function of these columns
  int32_t element_count;
};

// Assigns rows 0 ... 2 sources - 1 of all places: out[i + j * ld]. Without the additional terms of equations at a hole (METHOD
// (4.1)), and without those of free zones.
void fill_chosen(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld);
// The same for contact tractions alone, which have neither free terms nor twins.
void fill_tractions(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld);
// Assigns three rows, the balances, from out[0] on.
void fill_balances(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld);
// The same rows as compressed elimination uses them. Rigid-body modes that nothing in the body's equations constrains
// (motions_held, model/model.hpp) make the system singular: no unknown of the balances does work on them. In place of these
// balances, first, are the sums over all displacements times these modes, times `weight`. The balances along the orthogonal
// complement follow.
void fill_sums(const ColumnSystem& system, const ChosenColumns& columns, double weight, Real* out, int64_t ld);
// Transforms three balances in place to those rows: zero for the free modes.
void rotate_balances(const Model& model, int b, Real* sums);
// Assigns one row: L tr V of a hole (bie/holes.hpp), which the equations of its nodes contain times n.
void fill_hole_row(const ColumnSystem& system, const Hole& hole, const ChosenColumns& columns, Real* out, int64_t ld);

} // namespace c2d
