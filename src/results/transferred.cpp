// Tractions that free zones transfer to side 0 (METHOD 9.2, where the sides are 1 and 2).
//
// In a free zone tau is interpolated at the nodes of side 1, per length of side 1. Side 0 receives, by Newton's third law,
//   t_0(eta_0) = -tau(eta_1) J_1/J_0 at facing points,
// which is a polynomial only on the pieces between the nodes of both sides. Forces and integrals are computed piece by piece,
// exactly; as nodal values for the output t_0 is evaluated at the element ends. This is the segment-to-segment idea of mortar
// methods (Puso and Laursen, Comput. Methods Appl. Mech. Eng. 193, 2004), applied to collocation.
#include "results/transferred.hpp"

#include "bie/transfer.hpp"

namespace c2d {

void add_transferred_traction(const Session& session, int b, int32_t element, int l, double out[2]) {
  const Model& m = session.model;
  TransferredEnd end;
  if (!transferred_end(m, b, element, l, end)) return;
  for (int k = 0; k < m.head->function_nodes; ++k) {
    double t[2];
    pair_force(session, end.pair[k], -m.head->stress_unit * end.ratio * end.weight[k], t);
    for (int c = 0; c < 2; ++c) out[c] += t[c];
  }
}

void transferred_values(const Session& session, const Transfer& piece, int k, double out[2]) {
  const Model& m = session.model;
  out[0] = out[1] = 0.0;
  for (int l = 0; l < m.head->function_nodes; ++l) {
    double t[2];
    pair_force(session, piece.pair[l], -m.head->stress_unit * piece.weight[k][l], t);
    for (int c = 0; c < 2; ++c) out[c] += t[c];
  }
}

namespace {

// Not inlined: the frame of a piece must not add to that of the search for the next one.
[[gnu::noinline]] void add_piece_force(const Session& session, const TransferWalk& walk, double out[3]) {
  const double unit = session.model.head->length_unit;
  Transfer piece;
  make_transfer(session.model, Quadrature::accurate, walk, piece);
  double w[kElementNodes], wx[kElementNodes], wy[kElementNodes], t[2];
  resultants(piece.in, 0.0, 0.0, w, wx, wy);
  for (int k = 0; k < piece.in.functions; ++k) {
    transferred_values(session, piece, k, t);
    add_force(out, unit * w[k] * t[0], unit * w[k] * t[1], unit * unit * (wx[k] * t[1] - wy[k] * t[0]));
  }
}

} // namespace

void add_transferred_force(const Session& session, int b, double out[3]) {
  TransferWalk walk{};
  walk.body = b;
  while (next_transfer(session.model, walk)) add_piece_force(session, walk, out);
}

} // namespace c2d
