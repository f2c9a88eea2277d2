#pragma once
// Free zones in the equations of side 0 (model/free_zones.hpp, METHOD 9.2), where tau is per length of side 1 and interpolated
// there. In names 1 stands for side 0 and 2 for side 1. Displacement: the equations u_c - sum_l N_l(eta) u_l = 0 at the point
// that each pair's node faces. Traction: at matching points tau dS2 acts on both bodies, so that int U tau dS1-share = sum
// over pieces of int U(x1) M_j J2 deta2. The same measure in the balances preserves the force exactly, and the moment where
// matching points coincide.
#include "bie/columns.hpp"
#include "model/free_zones.hpp"

namespace c2d {

// One piece of side 0 under tau: an integrator over it, with J2 as its measure, whose functions are tau of
// the pairs at the ends of an element of side 1 by weight[function][end]. pair[end]: -1 without one.
struct Transfer {
  Integrator in;
  int32_t element1;
  int32_t node[2]; // functional nodes of side 0 at its ends in direction of travel, or -1
  int32_t pair[kElementNodes];
  double weight[kElementNodes][kElementNodes];
};
// All pieces of all free zones with the body on side 0: start with zeros except for the body. False after the last one. A
// piece is evaluated apart from the search for it, whose call chain is deep: the two never share the stack.
struct TransferWalk {
  int32_t body;
  int32_t from, to;    // if `to` is not 0: only elements of side 1 with one of these contact unknowns of the body
  int32_t zone, place; // of the element of side 1
  bool inside;         // in the pieces of that element
  PieceWalk pieces;
  FacingPiece piece;
};
bool next_transfer(const Model& m, TransferWalk& walk);
void make_transfer(const Model& m, Quadrature quadrature, const TransferWalk& walk, Transfer& out);

// The share of free zones in the columns of a body, which has free_rows.
void fill_transfer(const ColumnSystem& system, int32_t first, int32_t count, Real* panel, int64_t ld);

// tau of the pairs at local node l of an element of body b on side 0: true traction there = -ratio sum weight[k] tau of
// pair[k], with the ratio of lengths dS2/dS1. False outside free zones and where nothing faces the node.
struct TransferredEnd {
  int32_t pair[kElementNodes];
  double weight[kElementNodes], ratio;
};
bool transferred_end(const Model& m, int b, int32_t element, int l, TransferredEnd& out);

} // namespace c2d
