#include "solver/support.hpp"
#include "model/pair_frame.hpp"

#include <math.h>

namespace c2d {

int extend_basis(double basis[3][3], int rank, int n, double row[3]) {
  double before = 0.0, after = 0.0;
  for (int j = 0; j < n; ++j) before += row[j] * row[j];
  for (int i = 0; i < rank; ++i) {
    double dot = 0.0;
    for (int j = 0; j < n; ++j) dot += basis[i][j] * row[j];
    for (int j = 0; j < n; ++j) row[j] -= dot * basis[i][j];
  }
  for (int j = 0; j < n; ++j) after += row[j] * row[j];
  if (!(after > 1e-16 * before) || !(after > 1e-16)) return 0;
  const double length = sqrt(after);
  for (int j = 0; j < n; ++j) basis[rank][j] = row[j] / length;
  return 1;
}

namespace {

// Do the contact pairs, all sticking, hold every free motion of this body?
bool contact_holds(const Model& m, int b) {
  const Body& body = m.head->body[b];
  const int k = body.free_motions;
  double basis[3][3]; // orthonormal: what the pairs seen so far prevent, in coordinates of the free motions
  int rank = 0;
  for (int32_t i = 0; i < m.head->pairs && rank < k; ++i) {
    const Pair& pair = m.pair[i];
    double x, y;
    pair_position(m, pair, b, &x, &y);
    const double dx = (x - body.centre[0]) / m.head->length_unit, dy = (y - body.centre[1]) / m.head->length_unit;
    for (int d = 0; d <= pair.tangential && rank < k; ++d) {
      double row[3] = {0.0, 0.0, 0.0};
      for (int j = 0; j < k; ++j) {
        const double* motion = body.free_motion[j];
        row[j] = along(pair, d, 0) * (motion[0] - motion[2] * dy) + along(pair, d, 1) * (motion[1] + motion[2] * dx);
      }
      rank += extend_basis(basis, rank, k, row);
    }
  }
  return rank == k;
}

} // namespace

// Which body's displacements are eliminated, a supported one and the stiffer of two (METHOD 10.1), and whether anything can fly
// away whatever the contact does.
void find_support(c2d_solver* s, const Model& m) {
  s->inverted = 0;
  s->blocked = 0;
  for (int b = 0; b < m.head->bodies; ++b)
    if (m.head->contact == 0 && m.head->body[b].free_motions > 0) s->blocked = b + 1;
  if (m.head->contact == 0) return;
  const int32_t free1 = m.head->body[0].free_motions, free2 = m.head->body[1].free_motions;
  s->inverted = free1 > 0 || (free2 == 0 && m.head->rigid == 0 && shear_modulus(m, 1) > shear_modulus(m, 0)) ? 1 : 0;
  if (m.head->body[s->inverted].free_motions > 0)
    s->blocked = free1 >= free2 ? 1 : 2; // neither is held: the less held one
  else if (!contact_holds(m, 1 - s->inverted))
    s->blocked = 2 - s->inverted;
}

} // namespace c2d
