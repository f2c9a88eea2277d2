// Displacement of a point load under what free zones hand over to body 1 (optional, memory/optional.hpp).
#include "bie/transfer.hpp"
#include "solver/energy_adjoint.hpp"

namespace c2d {

void add_transferred_at(Adjoint& a, const double at[2], const double factor[2]) {
  const Model& m = a.model();
  const double scale = -m.head->stress_unit / (2.0 * shear_modulus(m, 0));
  TransferWalk walk{};
  Transfer piece;
  Blocks blocks;
  while (next_transfer(m, Quadrature::accurate, walk, piece)) {
    integrate(piece.in, at[0], at[1], -1, false, true, blocks);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      if (piece.pair[l] < 0) continue;
      const Pair& pair = m.pair[piece.pair[l]];
      for (int c = 0; c < 2; ++c) {
        double sum = 0.0;
        for (int k = 0; k < piece.in.functions; ++k)
          sum += piece.weight[k][l] * (factor[0] * blocks.g[k][0][c] + factor[1] * blocks.g[k][1][c]);
        a.tau[pair.dof] += static_cast<Real>(scale * sum * (c == 0 ? pair.nx : pair.ny));
        if (pair.tangential) a.tau[pair.dof + 1] += static_cast<Real>(scale * sum * (c == 0 ? pair.ny : -pair.nx));
      }
    }
  }
}

} // namespace c2d
