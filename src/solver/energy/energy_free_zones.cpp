// Displacement of a point load under what free zones hand over to its body (optional, memory/parts.hpp).
#include "bie/transfer.hpp"
#include "model/pair_frame.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

namespace {

// Not inlined: a piece must not stand below the search for the next.
[[gnu::noinline]] void add_piece_at(Adjoint& a, const TransferWalk& walk, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  const double scale = -m.head->stress_unit / (2.0 * shear_modulus(m, a.b));
  Transfer piece;
  make_transfer(m, Quadrature::accurate, walk, piece);
  Blocks blocks;
  integrate(piece.in, at[0], at[1], -1, false, true, blocks);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const Pair& pair = m.pair[piece.pair[l]];
    for (int c = 0; c < 2; ++c) {
      double sum = 0.0;
      for (int k = 0; k < piece.in.functions; ++k)
        sum += piece.weight[k][l] * (factor[0] * blocks.g[k][0][c] + factor[1] * blocks.g[k][1][c]);
      for (int slot = 0; slot <= pair.tangential; ++slot)
        a.tau[pair.dof + slot] += static_cast<Real>(scale * sum * along(pair, slot, c));
    }
  }
}

} // namespace

void add_transferred_at(Adjoint& a, const double at[2], const double factor[2]) {
  TransferWalk walk{};
  walk.body = a.b;
  while (next_transfer(a.model(), walk)) add_piece_at(a, walk, at, factor);
}

} // namespace c2d
