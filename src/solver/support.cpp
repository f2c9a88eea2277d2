#include "solver/support.hpp"

#include "memory/math.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_USES(WarningPart);

namespace {

// Takes what an orthonormal basis of `rank` rows of n numbers, `ld` apart, has of a row off that, so many times, and makes the
// rest a row of length one; 0: there is none.
int make_normal(const double* basis, int32_t rank, int32_t n, int32_t ld, int passes, double* row) {
  double before = 0.0, after = 0.0;
  for (int32_t j = 0; j < n; ++j) before += row[j] * row[j];
  for (int pass = 0; pass < passes; ++pass)
    for (int32_t i = 0; i < rank; ++i) {
      const double* unit = basis + static_cast<int64_t>(i) * ld;
      double part = 0.0;
      for (int32_t j = 0; j < n; ++j) part += unit[j] * row[j];
      for (int32_t j = 0; j < n; ++j) row[j] -= part * unit[j];
    }
  for (int32_t j = 0; j < n; ++j) after += row[j] * row[j];
  if (!(after > 1e-16 * before) || !(after > 1e-16)) return 0;
  const double length = sqrt(after);
  for (int32_t j = 0; j < n; ++j) row[j] /= length;
  return 1;
}

} // namespace

int extend_basis(double basis[3][3], int rank, int n, double row[3]) {
  const int found = make_normal(&basis[0][0], rank, n, 3, 1, row);
  for (int j = 0; j < n && found != 0; ++j) basis[rank][j] = row[j];
  return found;
}

namespace {

// Orthonormal basis, in coordinates of the free motions, of what the pairs prevent, along the normal and by friction alone. Its
// rank.
int prevented_by_pairs(const Model& m, int b, double basis[3][3]) {
  const Body& body = m.body[b];
  const int k = body.free_motions;
  int rank = 0;
  for (int32_t i = 0; i < m.head->pairs && rank < k; ++i) {
    const Pair& pair = m.pair[i];
    if (zone_of(m, pair).is_self != 0) continue;
    for (int d = 0; d <= pair.tangential && rank < k; ++d) {
      if (d == 1 && pair.law.is_smooth()) continue;
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
  for (int j = 0; j < body.motions; ++j) add_motion(out, coordinates[j], m.body[body.body].free_motion[j]);
  if (body.slides > 0) add_motion(out, -pair_product(m, body.body, out, body.slide), body.slide);
}

} // namespace

void find_slides(const Model& m, FreeBody& body) {
  double basis[3][3];
  const int held = prevented_by_pairs(m, body.body, basis);
  if (held + 1 != body.motions) return; // on a single pair it may turn as well
  add_farthest(basis, held, body.motions);
  to_motion(m, body, basis[held], body.slide);
  const double size = sqrt(pair_product(m, body.body, body.slide, body.slide));
  if (!(size > 0.0)) return; // no pair sees it: nothing to hold it by
  for (double& c : body.slide) c /= size;
  body.slides = 1;
  if (held == 1) to_motion(m, body, basis[0], body.motion);
}

double freedom(const Body& body, const double* basis, int32_t rank, int32_t n) {
  double sum = 0.0;
  for (int32_t j = body.first_motion; j < body.first_motion + body.free_motions; ++j) {
    sum += 1.0;
    for (int32_t i = 0; i < rank; ++i) sum -= basis[static_cast<int64_t>(i) * n + j] * basis[static_cast<int64_t>(i) * n + j];
  }
  return sum;
}

namespace {

// A pair's motion along one of its slots under all free motions: those of its two bodies alone. A body moves along with itself.
struct MotionRow {
  int32_t count, motion[6];
  double value[6];
};
MotionRow motion_row(const Model& m, const Pair& pair, int slot) {
  MotionRow row = {};
  if (zone_of(m, pair).is_self != 0) return row;
  for (int side = 0; side < 2; ++side) {
    const int b = body_on(m, pair, side);
    const Body& body = m.body[b];
    for (int32_t j = 0; j < body.free_motions; ++j) {
      double w[2];
      motion_at_pair(m, b, body.free_motion[j], body.centre, pair, w);
      row.motion[row.count] = body.first_motion + j;
      row.value[row.count++] = w[slot];
    }
  }
  return row;
}

// Adds what is new of `added` to an orthonormal basis of `rank` rows of n numbers, behind which there is room for one more.
// Twice, so that it is orthogonal to the last digit; where nothing is new, the first time tells, from few numbers.
int extend_rows(double* basis, int32_t rank, int32_t n, const MotionRow& added) {
  double before = 0.0, after = 0.0, *row = basis + static_cast<int64_t>(rank) * n;
  for (int32_t j = 0; j < n; ++j) row[j] = 0.0;
  for (int32_t k = 0; k < added.count; ++k) {
    row[added.motion[k]] = added.value[k];
    before += added.value[k] * added.value[k];
  }
  for (int pass = 0; pass < 2; ++pass) {
    for (int32_t i = 0; i < rank; ++i) {
      const double* unit = basis + static_cast<int64_t>(i) * n;
      double part = 0.0;
      for (int32_t k = 0; k < added.count && pass == 0; ++k) part += unit[added.motion[k]] * added.value[k];
      for (int32_t j = 0; j < n && pass == 1; ++j) part += unit[j] * row[j];
      for (int32_t j = 0; j < n && part != 0.0; ++j) row[j] -= part * unit[j];
    }
    after = 0.0;
    for (int32_t j = 0; j < n; ++j) after += row[j] * row[j];
    if (!(after > 1e-16 * before) || !(after > 1e-16)) return 0;
  }
  const double length = sqrt(after);
  for (int32_t j = 0; j < n; ++j) row[j] /= length;
  return 1;
}

// Rank of what the pairs [first, end) prevent, all sticking, added to an orthonormal basis.
int32_t prevent(const Model& m, int32_t first, int32_t end, double* basis, int32_t rank) {
  const int32_t n = m.head->motions;
  for (int32_t i = first; i < end; ++i)
    for (int d = 0; d <= m.pair[i].tangential && rank < n; ++d)
      rank += extend_rows(basis, rank, n, motion_row(m, m.pair[i], d));
  return rank;
}

} // namespace

int32_t prevented_by_contact(const Model& m, double* basis) { return prevent(m, 0, m.head->pairs, basis, 0); }

namespace {

// The body, from 1, that moves although all pairs stick, the least held one if there are several; 0: none does. `basis`:
// motions^2 numbers.
int32_t find_unheld(c2d_solver* s, const Model& m, double* basis) {
  const int32_t n = m.head->motions;
  const int32_t tied = prevent(m, m.head->path_pairs, m.head->pairs, basis, 0);
  const int32_t rank = prevent(m, 0, m.head->path_pairs, basis, tied);
  if (rank < n) kWarningPart.tell_unheld(s, basis, rank);
  m.head->loose = n - tied;
  int32_t found = 0;
  if (rank == n) return found;
  constexpr double kNone = 1e-9;
  for (int b = 0; b < m.head->bodies; ++b) {
    const Body& body = m.body[b];
    if (body.contact == 0 || !(freedom(body, basis, rank, n) > kNone)) continue;
    if (found == 0 || body.free_motions > m.body[found - 1].free_motions) found = b + 1;
  }
  return found;
}

} // namespace

void find_support(c2d_solver* s, const Model& m) {
  s->blocked = m.head->loose = 0;
  for (int b = 0; b < m.head->bodies; ++b)
    if (m.body[b].contact == 0 && m.body[b].free_motions > 0) s->blocked = b + 1;
  if (s->blocked != 0) kWarningPart.tell_unheld(s, nullptr, 0);
  if (s->blocked != 0 || m.head->motions == 0) return;
  const int32_t n = m.head->motions;
  if (static_cast<uint64_t>(n) * static_cast<uint64_t>(n) * sizeof(double) > s->bytes - s->layout.persistent) { // far too many
    for (int b = 0; b < m.head->bodies; ++b)
      if (s->blocked == 0 || m.body[b].free_motions > m.body[s->blocked - 1].free_motions) s->blocked = b + 1;
    return;
  }
  s->blocked = find_unheld(s, m, array_of<double>(s, kPhase));
}

} // namespace c2d
