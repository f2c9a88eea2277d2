#include "solver/support.hpp"

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

// Orthonormal basis, in coordinates of the free motions, of what the pairs prevent: all of them sticking, or along the normal
// and by friction alone. Its rank.
int prevented_by_pairs(const Model& m, int b, bool sticking, double basis[3][3]) {
  const Body& body = m.head->body[b];
  const int k = body.free_motions;
  int rank = 0;
  for (int32_t i = 0; i < m.head->pairs && rank < k; ++i) {
    const Pair& pair = m.pair[i];
    for (int d = 0; d <= pair.tangential && rank < k; ++d) {
      if (d == 1 && !sticking && pair.mu == 0.0) continue;
      double row[3] = {0.0, 0.0, 0.0};
      for (int j = 0; j < k; ++j) {
        double w[2];
        motion_at_pair(m, b, body.free_motion[j], body.centre, pair, w);
        row[j] = w[d];
      }
      rank += extend_basis(basis, rank, k, row);
    }
  }
  return rank;
}

bool contact_holds(const Model& m, int b) {
  double basis[3][3];
  return prevented_by_pairs(m, b, true, basis) == m.head->body[b].free_motions;
}

// Of two motions, the sum over the pairs that METHOD (13.3) is about.
double pair_product(const Model& m, const FreeBody& body, const double a[3], const double b[3]) {
  double sum = 0.0;
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    double u[2], v[2];
    motion_at_pair(m, body.body, a, body.centre, m.pair[i], u);
    motion_at_pair(m, body.body, b, body.centre, m.pair[i], v);
    sum += m.pair[i].length * (u[0] * v[0] + u[1] * v[1] * m.pair[i].tangential);
  }
  return sum;
}

// The unit vector that is farthest from an orthonormal basis of `rank` rows, added to it.
void add_farthest(double basis[3][3], int rank, int n) {
  double best[3] = {0.0, 0.0, 0.0}, most = -1.0;
  for (int j = 0; j < n; ++j) {
    double rest = 1.0;
    for (int i = 0; i < rank; ++i) rest -= basis[i][j] * basis[i][j];
    if (rest <= most + 1e-9) continue;
    most = rest;
    for (int i = 0; i < n; ++i) best[i] = i == j ? 1.0 : 0.0;
  }
  extend_basis(basis, rank, n, best);
}

void add_motion(double to[3], double factor, const double motion[3]) {
  for (int c = 0; c < 3; ++c) to[c] += factor * motion[c];
}

// The motion with these coordinates, but for what the pairs make of it along the body's slides.
void to_motion(const Model& m, const FreeBody& body, const double coordinates[3], double out[3]) {
  out[0] = out[1] = out[2] = 0.0;
  for (int j = 0; j < body.motions; ++j) add_motion(out, coordinates[j], m.head->body[body.body].free_motion[j]);
  if (body.slides > 0) add_motion(out, -pair_product(m, body, out, body.slide), body.slide);
}

} // namespace

void find_slides(const Model& m, FreeBody& body) {
  double basis[3][3];
  const int held = prevented_by_pairs(m, body.body, false, basis);
  if (held + 1 != body.motions) return; // on a single pair it may turn as well
  add_farthest(basis, held, body.motions);
  to_motion(m, body, basis[held], body.slide);
  const double size = sqrt(pair_product(m, body, body.slide, body.slide));
  if (!(size > 0.0)) return; // no pair sees it: nothing to hold it by
  for (double& c : body.slide) c /= size;
  body.slides = 1;
  if (held == 1) to_motion(m, body, basis[0], body.motion);
}

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
