#pragma once
// Parts of a body's equations: those at chosen nodes, in chosen columns. What compressed elimination (METHOD 7.6) asks for.
#include "bie/columns.hpp"

namespace c2d {

// The system whose sources are these nodes, ascending or not; `point` [2 count] and `twin` [count] are filled from those of the
// whole body. Nodes without collocation may be among them.
ColumnSystem choose_nodes(const ColumnSystem& whole, const int32_t* node, int32_t count, double* point, int32_t* twin);
// The same for points off the boundary, without images: node [count] and twin [count] are filled.
ColumnSystem choose_points(const ColumnSystem& whole, double* point, int32_t count, int32_t* node, int32_t* twin);

struct ChosenColumns {
  const int32_t* place;    // of every column of the body but the right-hand sides: where it stands in the result; -1: nowhere
  int32_t count;           // of places
  const int32_t* elements; // [element_count] all that have a function of these columns
  int32_t element_count;
};

// Assigns rows 0 ... 2 sources - 1 of all places: out[i + j * ld]. Without what the equations at a hole have beside those of
// other nodes (METHOD (4.1)), and without what free zones hand over.
void fill_chosen(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld);
// The same of contact tractions alone, which have neither free terms nor twins.
void fill_tractions(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld);
// Assigns three rows, the balances, from out[0] on.
void fill_balances(const ColumnSystem& system, const ChosenColumns& columns, Real* out, int64_t ld);
// The same rows as compressed elimination has them. On motions that nothing in the body's equations holds (motions_held,
// model/model.hpp) no unknown of the balances does work. In their place, first, stand the sums over all displacements times
// these motions, and times `weight`; behind them the balances along what is orthogonal to these.
void fill_sums(const ColumnSystem& system, const ChosenColumns& columns, double weight, Real* out, int64_t ld);
// Of balances in three numbers, one after another, those rows: zero for motions.
void turn_sums(const Model& model, int b, Real* sums);
// Assigns one row: L tr V of a hole (bie/holes.hpp), which its nodes' equations have times n.
void fill_hole_row(const ColumnSystem& system, const Hole& hole, const ChosenColumns& columns, Real* out, int64_t ld);

} // namespace c2d
