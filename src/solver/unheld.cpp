#include "solver/unheld.hpp"

#include "memory/math.hpp"
#include "model/rigid.hpp"
#include "model/validate/validate_finding.hpp"
#include "solver/support.hpp"

namespace c2d {

namespace {

constexpr double kNone = 1e-9;

struct Prevented {
  const double* row;
  int32_t rank, n;
  double of(int32_t i, int32_t motion) const { return row[static_cast<int64_t>(i) * n + motion]; }
};

// Motions that body b makes while all others rest, in coordinates of its free motions; how many.
int own_motions(const Prevented& by, const Body& body, double out[3][3]) {
  const int k = body.free_motions;
  double basis[3][3];
  int rank = 0;
  for (int32_t i = 0; i < by.rank && rank < k; ++i) {
    double row[3] = {0.0, 0.0, 0.0};
    for (int j = 0; j < k; ++j) row[j] = by.of(i, body.first_motion + j);
    rank += extend_basis(basis, rank, k, row);
  }
  int count = 0;
  for (int j = 0; j < k && rank < k; ++j) {
    double unit[3] = {j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0};
    if (extend_basis(basis, rank, k, unit) == 0) continue;
    for (int c = 0; c < 3; ++c) out[count][c] = basis[rank][c];
    ++rank;
    ++count;
  }
  return count;
}

void put_own(Text& text, const Model& m, int b, const double coordinates[3]) {
  const Body& body = m.body[b];
  double motion[3] = {0.0, 0.0, 0.0};
  for (int j = 0; j < body.free_motions; ++j)
    for (int c = 0; c < 3; ++c) motion[c] += coordinates[j] * body.free_motion[j][c];
  put_motion(text, m, b, motion);
}

void tell_body(c2d_solver* s, const Model& m, int b, int count, const double motion[3][3]) {
  Finding f(C2D_WARN_UNHELD, in_body(b));
  say(f, "nothing holds body ", body_named(m, b), ", its free motions: ");
  for (int i = 0; i < count; ++i) {
    if (i > 0) say(f, i + 1 == count ? " and " : ", ");
    put_own(f.text, m, b, motion[i]);
  }
  report_fault(s, f.entry);
}

void tell_together(c2d_solver* s, const Model& m, const Prevented& by, int32_t count) {
  Finding f(C2D_WARN_UNHELD);
  say(f, "nothing holds bodies");
  int told = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    double own[3][3];
    const Body& body = m.body[b];
    if (body.contact == 0 || body.free_motions == 0 ||
        !(freedom(body, by.row, by.rank, by.n) > own_motions(by, body, own) + kNone))
      continue;
    say(f, told++ == 0 ? " " : ", ", body_named(m, b));
  }
  say(f, ": they can move together in ", count, count == 1 ? " way" : " ways");
  report_fault(s, f.entry);
}

} // namespace

void tell_unheld(c2d_solver* s, const double* prevented, int32_t rank) {
  const Model m = model_of(s);
  const Prevented by = {prevented, prevented ? rank : 0, m.head->motions};
  int32_t alone = 0, all = prevented ? by.n - rank : 0;
  double own[3][3];
  for (int b = 0; b < m.head->bodies; ++b) {
    const Body& body = m.body[b];
    if (body.contact > 0 && !prevented) continue;
    const int count = own_motions(by, body, own);
    if (body.contact == 0) all += count;
    alone += count;
  }
  if (all <= 1 && all == alone) return;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (m.body[b].contact > 0 && !prevented) continue;
    const int count = own_motions(by, m.body[b], own);
    if (count > 0) tell_body(s, m, b, count, own);
  }
  if (all > alone) tell_together(s, m, by, all - alone);
}

} // namespace c2d
