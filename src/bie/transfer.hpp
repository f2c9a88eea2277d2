#pragma once
// What body 1 has of free zones (model/free_zones.hpp, METHOD 9.2), where tau is per length of body 2 and interpolated there.
// Displacement: the equations u_c - sum_l N_l(eta) u_l = 0 at the point that each pair's node faces. Traction: at matching
// points tau dS2 acts on both bodies, so that int U tau dS1-share = sum over pieces of int U(x1) M_j J2 deta2. The same measure
// in the balances keeps the force exactly; the moment is kept where matching points coincide.
#include "bie/columns.hpp"
#include "model/free_zones.hpp"

namespace c2d {

// One piece of body 1 under tau: an integrator over it, with J2 as its measure, whose functions are tau of
// the pairs at the ends of an element of body 2 by weight[function][end]. pair[end]: -1 without one.
struct Transfer {
  Integrator in;
  int32_t element1;
  int32_t node[2]; // functional nodes of body 1 at its ends in direction of travel, or -1
  int32_t pair[kElementNodes];
  double weight[kElementNodes][kElementNodes];
};
// All pieces of all free zones: start with zeros. False after the last one. What a piece stands for is made apart from
// finding it, which goes deep: none need be in memory then.
struct TransferWalk {
  int32_t zone, place; // of the element of body 2
  bool inside;         // pieces of that element are under way
  PieceWalk pieces;
  FacingPiece piece;
};
bool next_transfer(const Model& m, TransferWalk& walk);
void make_transfer(const Model& m, Quadrature quadrature, const TransferWalk& walk, Transfer& out);

// The share of free zones in the columns of body 1.
void fill_transfer(const ColumnSystem& system, int32_t first, int32_t count, Real* panel, int64_t ld);

// What tau of the pairs is at local node l of an element of body 1: true traction there = -ratio sum weight[k] tau of pair[k],
// with the ratio of lengths dS2/dS1. False outside free zones and where nothing faces it.
struct TransferredEnd {
  int32_t pair[kElementNodes];
  double weight[kElementNodes], ratio;
};
bool transferred_end(const Model& m, int32_t element, int l, TransferredEnd& out);

} // namespace c2d
