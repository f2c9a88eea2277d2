// The motion of a body whose pressed pairs hold it no longer, and what is told of it.

#include "memory/math.hpp"
#include "model/rigid.hpp"
#include "solver/energy/motion.hpp"
#include "solver/load_path.hpp"
#include "solver/support.hpp"

namespace c2d {

namespace {

// Does this pair hold the body once the last one has been given up? Where nothing is pressed, what touches does.
bool holds(const Session& session, int32_t i, c2d_outcome outcome) {
  if (is_tied(session.model, session.model.pair[i])) return true;
  if (!is_pressed(session)) return may_press(session, i);
  if (session.model.pair[i].status == C2D_OPEN) return false;
  if (outcome == C2D_GROSS_SLIDING) return true;
  const double p = pair_state(*session.follower.t, i, session.follower.y).p;
  return i != session.follower.last_pair && p > kNoPressure * session.solver->peak_pressure;
}
// Where all slides, whether the last pair at its bound still counts as sticking is round-off.
bool holds_along(const Session& session, int32_t i, c2d_outcome outcome) {
  const Pair& pair = session.model.pair[i];
  if (!pair.tangential) return false;
  if (is_tied(session.model, pair)) return true;
  if (!is_pressed(session)) return !pair.law.is_smooth();
  if (pair.status != C2D_STICK) return false;
  const PairState now = pair_state(*session.follower.t, i, session.follower.y);
  const bool at_bound = pair.law.has_bound() && fabs(now.q) >= (1.0 - 1e-6) * pair.law.bound(now.p);
  return outcome != C2D_GROSS_SLIDING || (i != session.follower.last_pair && !at_bound);
}

// Orthonormal basis of what the contact prevents.
int prevented(const Session& session, const Motions& motions, c2d_outcome outcome, double basis[3][3]) {
  int rank = 0;
  for (int32_t i = 0; i < session.model.head->pairs && rank < motions.count; ++i) {
    if (!holds(session, i, outcome)) continue;
    double normal[3], tangential[3];
    motion_rows(session, motions, session.model.pair[i], normal, tangential);
    rank += extend_basis(basis, rank, motions.count, normal);
    if (rank < motions.count && holds_along(session, i, outcome)) rank += extend_basis(basis, rank, motions.count, tangential);
  }
  return rank;
}

// What drives each motion: the friction that it overcomes, or the loads.
void driving(const Session& session, const Motions& motions, c2d_outcome outcome, double out[3]) {
  const Follower& f = session.follower;
  for (int j = 0; j < motions.count; ++j) {
    double size = 0.0;
    out[j] = load_work(session, motions.b, f.direction, motions.body.free_motion[j], &size);
    if (fabs(out[j]) <= 1e-10 * size) out[j] = load_work(session, motions.b, f.load, motions.body.free_motion[j], &size);
  }
  if (outcome != C2D_GROSS_SLIDING) return;
  for (int j = 0; j < motions.count; ++j) out[j] = 0.0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    if (pair.status == C2D_OPEN || !pair.tangential) continue;
    double normal[3], tangential[3];
    motion_rows(session, motions, pair, normal, tangential);
    const double q = pair_state(*f.t, i, f.y).q;
    for (int j = 0; j < motions.count; ++j) out[j] -= pair.weight * q * tangential[j];
  }
}

// The motion where pairs are pressed: along what friction resists most, or the loads push most.
bool find_pressed_motion(const Session& session, const Motions& motions, c2d_outcome outcome, double choice[3]) {
  double basis[3][3];
  const int rank = prevented(session, motions, outcome, basis);
  driving(session, motions, outcome, choice);
  const double before = length_of(choice, motions.count);
  remove_prevented(basis, rank, motions.count, choice);
  if (length_of(choice, motions.count) > 1e-9 * before) return true;
  for (int j = 0; j < motions.count; ++j) {
    for (int i = 0; i < motions.count; ++i) choice[i] = i == j ? 1.0 : 0.0;
    remove_prevented(basis, rank, motions.count, choice);
    if (length_of(choice, motions.count) > 1e-6) return true;
  }
  return false;
}

} // namespace

void keep_motion(Session& session, const Motions& motions, c2d_outcome outcome, bool found, double choice[3]) {
  const bool moves = found || find_pressed_motion(session, motions, outcome, choice);
  const double size = moves ? length_of(choice, motions.count) : 0.0;
  if (!(size > 0.0)) return;
  double* const motion = session.solver->outcome_motion;
  for (int j = 0; j < motions.count; ++j)
    for (int c = 0; c < 3; ++c) motion[c] += choice[j] / size * motions.body.free_motion[j][c];
  for (int c = 0; c < 3; ++c)
    if (fabs(motion[c]) < 1e-9) motion[c] = 0.0; // round-off
}

} // namespace c2d
