// How a body starts to move when the contact can hold it no longer: the free rigid motions that the pairs still in
// contact allow, and among them the one that friction resists most, or that the loads push most. Where nothing is
// pressed yet (a load that no contact can carry from the start) there is no friction to go by: then the motion of the
// body as if rigid, against unilateral contact with friction.
#include "solver/energy/motion.hpp"

#include "memory/math.hpp"
#include "model/rigid.hpp"
#include "solver/load_path.hpp"
#include "solver/support.hpp"

namespace c2d {

void motion_rows(const Session& session, const Motions& motions, const Pair& pair, double normal[3], double tangential[3]) {
  for (int j = 0; j < motions.count; ++j) {
    double w[2];
    motion_at_pair(session.model, motions.b, motions.body.free_motion[j], motions.body.centre, pair, w);
    normal[j] = w[0];
    tangential[j] = w[1];
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

bool is_pressed(const Session& session) {
  if (session.solver->floating) return false;
  return path_scales(session.follower).p > kNoPressure * session.solver->peak_pressure;
}

bool may_press(const Session& session, int32_t i) {
  const Pair& pair = session.model.pair[i];
  if (session.solver->floating) return pair.gap <= 0.0; // as the model was made
  return pair.status != C2D_OPEN ||
         pair_state(*session.follower.t, i, session.follower.y).wn <= 1e-9 * session.follower.gap_scale;
}

namespace {

// Product of a row and a motion.
double row_times(const double a[3], const double b[3], int n) {
  double sum = 0.0;
  for (int j = 0; j < n; ++j) sum += a[j] * b[j];
  return sum;
}

// v += change * row; how far v went.
double push_along(double v[3], const double row[3], int n, double change) {
  for (int j = 0; j < n; ++j) v[j] += change * row[j];
  return fabs(change) * length_of(row, n);
}

// The forces of a pair on the free motions, so that it does not penetrate and friction opposes its slip. p and q are
// kept in its row of the result table, which is of no use while the path goes on.
double* forces_of(const Session& session, int32_t pair) {
  return array_of<double>(session.solver, kPairTable) + static_cast<int64_t>(pair) * C2D_PAIR_FIELDS;
}

double push_pair(const Session& session, const Motions& motions, int32_t index, double friction, double v[3]) {
  const Pair& pair = session.model.pair[index];
  double* const force = forces_of(session, index);
  const int n = motions.count;
  double normal[3], tangential[3];
  motion_rows(session, motions, pair, normal, tangential);
  const double nn = row_times(normal, normal, n), tt = row_times(tangential, tangential, n);
  double moved = 0.0;
  if (nn > 1e-18) {
    const double p = fmax(0.0, force[0] - row_times(normal, v, n) / nn);
    moved += push_along(v, normal, n, p - force[0]);
    force[0] = p;
  }
  if (pair.tangential && tt > 1e-18) {
    const double most = friction * fmin(pair.law.mu, 1e12) * force[0];
    const double q = fmax(-most, fmin(most, force[1] - row_times(tangential, v, n) / tt));
    moved += push_along(v, tangential, n, q - force[1]);
    force[1] = q;
  }
  return moved;
}

// v = drive + forces of the pairs, in balance with the conditions of contact (projected Gauss-Seidel iteration).
// `friction`: part of every coefficient that counts.
void rigid_response(const Session& session, const Motions& motions, double friction, const double drive[3], double v[3]) {
  for (int j = 0; j < motions.count; ++j) v[j] = drive[j];
  for (int32_t i = 0; i < session.model.head->pairs; ++i) forces_of(session, i)[0] = forces_of(session, i)[1] = 0.0;
  const double enough = 1e-14 * length_of(drive, motions.count);
  for (int sweep = 0; sweep < 50000; ++sweep) {
    double moved = 0.0;
    for (int32_t i = 0; i < session.model.head->pairs; ++i)
      if (may_press(session, i)) moved = fmax(moved, push_pair(session, motions, i, friction, v));
    if (moved <= enough) return;
  }
}

// Take from v what contact prevents, which the iteration left there as round-off.
void remove_round_off(const Session& session, const Motions& motions, double v[3]) {
  const int n = motions.count;
  const double size = length_of(v, n), small = 1e-5 * size;
  double basis[3][3];
  int rank = 0;
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    if (!may_press(session, i)) continue;
    const Pair& pair = session.model.pair[i];
    double normal[3], tangential[3];
    motion_rows(session, motions, pair, normal, tangential);
    const bool pressed = forces_of(session, i)[0] > 0.0 && fabs(row_times(normal, v, n)) <= small;
    if (!pressed) continue;
    const bool slips = pair.tangential && fabs(row_times(tangential, v, n)) > small;
    if (rank < n - 1) rank += extend_basis(basis, rank, n, normal);
    if (pair.tangential && !slips && rank < n - 1) rank += extend_basis(basis, rank, n, tangential);
  }
  double rest[3] = {v[0], v[1], v[2]};
  remove_prevented(basis, rank, n, rest);
  if (length_of(rest, n) > 0.99 * size)
    for (int j = 0; j < n; ++j) v[j] = rest[j];
}

// The motion from a state in which nothing is pressed. False: the loads push no motion, or the rigid body would not move.
bool find_unpressed_motion(const Session& session, const Motions& motions, double v[3]) {
  double drive[3] = {0.0, 0.0, 0.0}, size = 0.0;
  for (int j = 0; j < motions.count; ++j)
    drive[j] = load_work(session, motions.b, session.follower.direction, motions.body.free_motion[j], &size);
  const double pushed = length_of(drive, motions.count);
  if (!(pushed > 1e-10 * size)) return false;
  for (int j = 0; j < motions.count; ++j) drive[j] /= pushed;
  rigid_response(session, motions, 1.0, drive, v);
  if (length_of(v, motions.count) <= 1e-8) rigid_response(session, motions, 0.0, drive, v);
  if (length_of(v, motions.count) <= 1e-8) return false;
  remove_round_off(session, motions, v);
  return true;
}

// How strongly loads push the free motions of a body; nothing if that is round-off.
double push_on(const Session& session, int b, const double* loads) {
  const Body& body = session.model.body[b];
  double work[3] = {0.0, 0.0, 0.0}, size = 0.0;
  for (int j = 0; j < body.free_motions; ++j) work[j] = load_work(session, b, loads, body.free_motion[j], &size);
  const double push = length_of(work, body.free_motions);
  return push > 1e-10 * size ? push : 0.0;
}

// The body with free motions that these loads push most, if it is more than that; else -1.
int body_pushed_more(const Session& session, const double* loads, double than) {
  int most = -1;
  for (int b = 0; b < session.model.head->bodies; ++b) {
    if (session.model.body[b].free_motions == 0) continue;
    const double push = push_on(session, b, loads);
    if (push > than) than = push, most = b;
  }
  return most;
}

// Where several bodies float, the one to tell: that the loads push most on as they go on, or as they stand, be it not at all;
// the others are looked at as if held where they are.
int body_pushed_most(const Session& session) {
  if (session.free_body.motions == 0) return -1; // ties and supports hold them all
  const Follower& f = session.follower;
  const int most = body_pushed_more(session, f.direction, 0.0);
  return most >= 0 ? most : body_pushed_more(session, f.load, -1.0);
}

// The work of the loads on the motions of a body, to work[0 .. body.free_motions); the sum of its magnitudes.
double load_work_on(const Session& session, int b, double* work) {
  const Body& body = session.model.body[b];
  double size = 0.0;
  for (int32_t j = 0; j < body.free_motions; ++j)
    work[j] = load_work(session, b, session.follower.direction, body.free_motion[j], &size);
  return size;
}

// v without its part along orthonormal rows of n numbers; what is left of the motions [first, first + count).
double remove_rows(const double* basis, int32_t rank, int32_t n, double* v, int32_t first, int32_t count) {
  for (int32_t i = 0; i < rank; ++i) {
    const double* row = basis + static_cast<int64_t>(i) * n;
    double part = 0.0;
    for (int32_t j = 0; j < n; ++j) part += row[j] * v[j];
    for (int32_t j = 0; j < n; ++j) v[j] -= part * row[j];
  }
  return length_of(v + first, count);
}

// The share of a body in the motion that all bodies make together, held by nothing but pairs that stick: the one that the loads
// push, else any. In a model so large that there is no room for what is prevented: any motion of the body alone.
void find_unheld_motion(const Session& session, const Motions& motions, double choice[3]) {
  const Model& m = session.model;
  c2d_solver* s = session.solver;
  const bool alone = motions.body.contact == 0; // it is in no zone
  const int32_t n = alone ? motions.count : m.head->motions, first = alone ? 0 : motions.body.first_motion;
  if (static_cast<uint64_t>(n) * static_cast<uint64_t>(n + 1) * sizeof(double) > s->bytes - s->layout.persistent) return;
  double *work = array_of<double>(s, kPhase), *basis = work + n, size = 0.0;
  const int32_t rank = alone ? 0 : prevented_by_contact(m, basis);
  for (int b = 0; b < m.head->bodies; ++b)
    if (alone ? b == motions.b : m.body[b].contact > 0)
      size += load_work_on(session, b, work + (alone ? 0 : m.body[b].first_motion));
  double left = remove_rows(basis, rank, n, work, first, motions.count);
  for (int32_t k = 0; k < motions.count && !(left > 1e-10 * size); ++k) {
    for (int32_t j = 0; j < n; ++j) work[j] = j == first + k ? 1.0 : 0.0;
    size = 1.0;
    left = remove_rows(basis, rank, n, work, first, motions.count);
  }
  for (int32_t j = 0; j < motions.count; ++j) choice[j] = work[first + j];
}

} // namespace

void find_outcome_motion(Session& session, c2d_outcome outcome) {
  c2d_solver* s = session.solver;
  for (double& number : s->outcome_motion) number = 0.0;
  if (s->outcome_body == 0) s->outcome_body = body_pushed_most(session) + 1;
  if (s->outcome_body < 1) return;
  const Body& body = session.model.body[s->outcome_body - 1];
  const Motions motions{body, s->outcome_body - 1, body.free_motions};
  double choice[3] = {1.0, 0.0, 0.0};
  if (s->blocked) find_unheld_motion(session, motions, choice);
  const bool found = s->blocked || (!is_pressed(session) && find_unpressed_motion(session, motions, choice));
  keep_motion(session, motions, outcome, found, choice);
}

} // namespace c2d
