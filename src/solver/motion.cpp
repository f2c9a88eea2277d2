// How a body starts to move when the contact can hold it no longer: the free rigid motions that the pairs still in
// contact allow, and among them the one that friction resists most, or that the loads push most.
#include <math.h>

#include "model/rigid.hpp"
#include "solver/session.hpp"

namespace c2d {

namespace {

// Numbers per free motion of the body: constraints and driving forces.
struct Motions {
  const Body& body;
  int b, count;
};

void motion_rows(const Session& session, const Motions& motions, const Pair& pair, double normal[3], double tangential[3]) {
  for (int j = 0; j < motions.count; ++j) {
    double w[2];
    motion_at_pair(session.model, motions.b, motions.body.free_motion[j], motions.body.centre, pair, w);
    normal[j] = w[0];
    tangential[j] = w[1];
  }
}

// Orthonormal basis of what the contact prevents once the last pair has been given up.
int prevented(const Session& session, const Motions& motions, c2d_outcome outcome, double basis[3][3]) {
  int rank = 0;
  for (int32_t i = 0; i < session.model.head->pairs && rank < motions.count; ++i) {
    const Pair& pair = session.model.pair[i];
    const bool last = i == session.follower.last_pair;
    if (pair.status == C2D_OPEN || (last && outcome == C2D_FREE_MOTION)) continue;
    const double p = pair_state(*session.follower.t, i, session.follower.y).p;
    if (outcome == C2D_FREE_MOTION && p <= kNoPressure * session.solver->peak_pressure) continue;
    double normal[3], tangential[3];
    motion_rows(session, motions, pair, normal, tangential);
    rank += extend_basis(basis, rank, motions.count, normal);
    const bool sticks = pair.status == C2D_STICK && pair.tangential && !(last && outcome == C2D_GROSS_SLIDING);
    if (sticks && rank < motions.count) rank += extend_basis(basis, rank, motions.count, tangential);
  }
  return rank;
}

// What drives each motion: the friction that it overcomes, or the loads.
void driving(const Session& session, const Motions& motions, c2d_outcome outcome, double out[3]) {
  const Follower& f = session.follower;
  for (int j = 0; j < motions.count; ++j) {
    double size = 0.0;
    out[j] = load_work(session, f.direction, motions.body.free_motion[j], &size);
    if (fabs(out[j]) <= 1e-10 * size) out[j] = load_work(session, f.load, motions.body.free_motion[j], &size);
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

double length_of(const double v[3], int n) {
  double sum = 0.0;
  for (int j = 0; j < n; ++j) sum += v[j] * v[j];
  return sqrt(sum);
}

void remove_prevented(const double basis[3][3], int rank, int n, double v[3]) {
  for (int i = 0; i < rank; ++i) {
    double dot = 0.0;
    for (int j = 0; j < n; ++j) dot += basis[i][j] * v[j];
    for (int j = 0; j < n; ++j) v[j] -= dot * basis[i][j];
  }
}

} // namespace

void find_outcome_motion(Session& session, c2d_outcome outcome) {
  c2d_solver* s = session.solver;
  for (double& number : s->outcome_motion) number = 0.0;
  if (s->outcome_body < 1 || s->outcome_body > session.model.head->bodies) return;
  const Motions motions{session.model.head->body[s->outcome_body - 1], s->outcome_body - 1,
                        session.model.head->body[s->outcome_body - 1].free_motions};
  if (motions.count < 1) return;
  double choice[3] = {1.0, 0.0, 0.0}; // in coordinates of the free motions
  if (!s->blocked) {
    double basis[3][3];
    const int rank = prevented(session, motions, outcome, basis);
    driving(session, motions, outcome, choice);
    const double before = length_of(choice, motions.count);
    remove_prevented(basis, rank, motions.count, choice);
    for (int j = 0; j < motions.count && !(length_of(choice, motions.count) > 1e-9 * before); ++j) {
      for (int i = 0; i < motions.count; ++i) choice[i] = i == j ? 1.0 : 0.0;
      remove_prevented(basis, rank, motions.count, choice);
      if (length_of(choice, motions.count) > 1e-6) break;
    }
    const double size = length_of(choice, motions.count);
    if (!(size > 0.0)) return;
    for (int j = 0; j < motions.count; ++j) choice[j] /= size;
  }
  for (int j = 0; j < motions.count; ++j)
    for (int c = 0; c < 3; ++c) s->outcome_motion[c] += choice[j] * motions.body.free_motion[j][c];
}

} // namespace c2d
