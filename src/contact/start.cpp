#include "contact/start.hpp"

#include "contact/body_unknowns.hpp"
#include "contact/let_go.hpp"
#include "contact/limit_analysis.hpp"
#include "model/free_zones.hpp"
#include "model/pair_frame.hpp"

#include <math.h>

namespace c2d {

namespace {

void reset_pair(Pair& pair) {
  pair.offset = pair.slip_done = pair.slip_from = pair.increment_from = pair.slip_before = 0;
  pair.sign = 0;
}

// They stick for ever.
void tie_pairs(const Tableau& t, int32_t pairs) {
  for (int32_t i = t.pairs; i < pairs; ++i) {
    reset_pair(t.pair[i]);
    t.pair[i].status = C2D_STICK;
    t.pair[i].mu = static_cast<double>(INFINITY);
  }
}

void touch_statuses(Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    reset_pair(pair);
    pair.status = pair.gap > 0.0 ? C2D_OPEN : (pair.mu == 0.0 ? C2D_SLIP : C2D_STICK);
    pair.sign = pair.status == C2D_SLIP ? 1 : 0;
  }
}

void pair_motion(const FreeBody& body, const Model& m, const Pair& pair, double out[2]) {
  motion_at_pair(m, body.body, body.motion, body.centre, pair, out);
}

// At zero load the state is known exactly: the initial gaps and `flight` units of the free motion. Round-off of the
// exchanges is swept away.
void set_constants(Tableau& t, const FreeBody& body, const Model& m, double flight) {
  Real* c = constants(t);
  for (int32_t i = 0; i < t.m; ++i) c[i] = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    double w[2] = {0.0, 0.0};
    if (flight != 0.0) pair_motion(body, m, pair, w);
    if (pair.status == C2D_OPEN) c[pair.dof] = static_cast<Real>(pair.gap / t.length_unit + flight * w[0]);
    if (pair.tangential && pair.status != C2D_STICK) c[pair.dof + 1] = static_cast<Real>(flight * w[1]);
  }
}

// The pair that a motion in this direction closes first; -1: none. *distance: how far it goes.
int32_t first_to_touch(const Tableau& t, const FreeBody& body, const Model& m, double direction, double* distance) {
  int32_t first = -1;
  for (int32_t i = 0; i < t.pairs; ++i) {
    double w[2];
    pair_motion(body, m, t.pair[i], w);
    const double closing = -direction * w[0];
    if (closing <= 1e-9) continue; // motions are of length one: this one passes by
    const double reach = t.pair[i].gap / m.head->length_unit / closing;
    if (first >= 0 && reach >= *distance) continue;
    first = i;
    *distance = reach;
  }
  return first;
}

} // namespace

void motion_at_pair(const Model& m, int b, const double motion[3], const double centre[2], const Pair& pair, double out[2]) {
  out[0] = out[1] = 0.0;
  for (int side = 0; side < 2; ++side) {
    if (body_on(m, pair, side) != b) continue;
    double x, y, w[2];
    pair_position(m, pair, side, &x, &y);
    const double unit = m.head->length_unit;
    const double ux = motion[0] - motion[2] * (y - centre[1]) / unit;
    const double uy = motion[1] + motion[2] * (x - centre[0]) / unit;
    to_frame(pair, signed_on(side, ux), signed_on(side, uy), w);
    for (int d = 0; d < 2; ++d) out[d] += w[d];
  }
}

void motion_column(const Model& m, int b, int32_t j, Real* out) {
  for_pairs_of(m, b, [&](const Pair& pair, int side) {
    double w[2];
    motion_at_pair(m, b, m.body[b].free_motion[j], m.body[b].centre, pair, w);
    for (int32_t d = 0; d <= pair.tangential; ++d) out[dof_on(m, pair, side) + d] = static_cast<Real>(signed_on(side, w[d]));
  });
}

c2d_status start_path(Follower& f, const FreeBody& body, const Model& model, int32_t* floating) {
  Tableau& t = *f.t;
  touch_statuses(t);
  tie_pairs(t, model.head->pairs);
  *floating = 0;
  int32_t touching = 0;
  for (int32_t i = 0; i < t.pairs; ++i) touching += t.pair[i].status != C2D_OPEN;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const double gap = fmax(t.pair[i].gap, t.pair[i].overlap) / model.head->length_unit;
    if (gap > f.gap_scale) f.gap_scale = gap;
  }
  if (touching == 0 && body.others() > 0) {
    *floating = 1;
    return C2D_OK;
  }
  const c2d_status status = build_tableau(t, *f.tape, &f.last_pair);
  if (status == C2D_ERR_SINGULAR) {
    *floating = 1;
    return C2D_OK;
  }
  if (status != C2D_OK) return status;
  set_constants(t, body, model, 0.0);
  refresh(f);
  return C2D_OK;
}

namespace {

// The body that the loads move, of several: the tableau is not valid, but what touches has no force yet.
c2d_status find_moving(Follower& f) {
  const Tableau& t = *f.t;
  for (int32_t i = 0; i < t.m; ++i) f.y[i] = f.dy[i] = 0;
  for (int32_t i = 0; i < t.pairs; ++i)
    if (t.pair[i].status == C2D_OPEN) f.y[t.pair[i].dof] = static_cast<Real>(t.pair[i].gap / t.length_unit);
  c2d_outcome kind;
  return limit_analysis(f, true, &kind);
}

} // namespace

c2d_status lie_apart(Follower& f, const Model& model, c2d_outcome* outcome) {
  Tableau& t = *f.t;
  *outcome = C2D_FREE_MOTION;
  bool unloaded = false, balanced = false;
  c2d_status status = loads_balance(f, &unloaded, &balanced);
  if (status == C2D_OK && !balanced && t.body->body < 0) return find_moving(f);
  if (status != C2D_OK || !balanced || t.free_motions == 0) return status;
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    reset_pair(pair);
    pair.status = C2D_OPEN;
    keep_place(pair, pair.gap / model.head->length_unit, 0.0);
  }
  status = build_tableau(t, *f.tape, &f.last_pair);
  if (status == C2D_ERR_SINGULAR) return C2D_OK;
  if (status == C2D_OK) *outcome = C2D_REACHED;
  refresh(f);
  return status;
}

c2d_status fly(Follower& f, const FreeBody& body, const Model& model, double work, c2d_outcome* outcome) {
  Tableau& t = *f.t;
  *outcome = C2D_FREE_MOTION;
  if (body.body < 0 || body.others() != 1 || work == 0.0) return C2D_OK;
  const double direction = work > 0.0 ? 1.0 : -1.0;
  double distance = 0.0;
  const int32_t first = first_to_touch(t, body, model, direction, &distance);
  if (first < 0) return C2D_OK;
  for (int32_t i = 0; i < t.pairs; ++i) {
    reset_pair(t.pair[i]);
    t.pair[i].status = C2D_OPEN;
  }
  Pair& pair = t.pair[first];
  double w[2];
  pair_motion(body, model, pair, w);
  const double tangential = pair.tangential ? direction * distance * w[1] : 0.0;
  pair.status = pair.mu == 0.0 ? C2D_SLIP : C2D_STICK;
  pair.sign = pair.status == C2D_SLIP ? 1 : 0;
  (pair.status == C2D_STICK ? pair.offset : pair.slip_from) = static_cast<Real>(tangential);
  f.last_pair = first;
  const c2d_status status = build_tableau(t, *f.tape, &f.last_pair);
  if (status == C2D_ERR_SINGULAR) return C2D_OK;
  if (status != C2D_OK) return status;
  set_constants(t, body, model, direction * distance);
  refresh(f);
  *outcome = C2D_REACHED;
  return C2D_OK;
}

} // namespace c2d
