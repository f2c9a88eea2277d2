#include "contact/start.hpp"

#include "contact/asleep.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/let_go.hpp"
#include "contact/rates/force_cone.hpp"
#include "contact/rates/limit_analysis.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "model/free_zones.hpp"
#include "model/pair_frame.hpp"

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
  }
}

void touch_statuses(Tableau& t) {
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    reset_pair(pair);
    pair.status = pair.gap > 0.0 ? C2D_OPEN : (pair.law.is_smooth() ? C2D_SLIP : C2D_STICK);
    pair.sign = pair.status == C2D_SLIP ? 1 : 0;
    if (follows_slip(t)) t.slip[i].now = t.slip[i].rate = t.slip[i].work = 0.0;
  }
}

// Nothing is loaded yet, and f.y holds where the pairs are as if rigid. At zero load that is known exactly; round-off of the
// exchanges is swept away. (f.y lasts while the tableau is built.)
void set_constants(Follower& f) {
  Tableau& t = *f.t;
  Real* c = constants(t);
  for (int32_t i = 0; i < t.m; ++i) c[i] = 0;
  for (int32_t i = 0; i < t.pairs; ++i) {
    const Pair& pair = t.pair[i];
    if (pair.status == C2D_OPEN) c[pair.dof] = f.y[pair.dof];
    if (pair.tangential && pair.status != C2D_STICK) c[pair.dof + 1] = f.y[pair.dof + 1];
  }
}

// Where the model has the pairs.
void place_as_given(Follower& f) {
  for (int32_t i = 0; i < f.t->m; ++i) f.y[i] = f.dy[i] = 0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    f.y[pair.dof] = static_cast<Real>(fmax(pair.gap, 0.0) / f.t->length_unit);
    f.gap_scale = fmax(f.gap_scale, fmax(1e-3 * pair.gap, pair.overlap) / f.t->length_unit);
  }
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

double pair_product(const Model& m, int b, const double u[3], const double v[3]) {
  double sum = 0.0;
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    double at_u[2], at_v[2];
    motion_at_pair(m, b, u, m.body[b].centre, m.pair[i], at_u);
    motion_at_pair(m, b, v, m.body[b].centre, m.pair[i], at_v);
    sum += m.pair[i].length * (at_u[0] * at_v[0] + at_u[1] * at_v[1] * m.pair[i].tangential);
  }
  return sum;
}

c2d_status start_path(Follower& f, int32_t* floating) {
  Tableau& t = *f.t;
  touch_statuses(t);
  for (int32_t i = 0; i < t.pairs && delays(t); ++i) // there may be no tableau for long; none sleeps
    t.column[i] = is_on_demand(*f.model) ? 0 : t.pair[i].dof;
  t.delayed.cols = t.n;
  tie_pairs(t, f.model->head->pairs);
  place_as_given(f);
  *floating = 0;
  const c2d_status status = is_let_go(t) ? c2d_status{C2D_ERR_SINGULAR} : build_tableau(t, *f.tape, &f.last_pair);
  if (status == C2D_ERR_SINGULAR) {
    *floating = 1;
    return C2D_OK;
  }
  if (status != C2D_OK) return status;
  set_constants(f);
  refresh(f);
  return C2D_OK;
}

namespace {

// The loads along the path's direction do not move what floats: it lies where the model has it (contact/let_go.hpp).
c2d_status lie_apart(Follower& f, c2d_outcome* outcome) {
  Tableau& t = *f.t;
  bool unloaded = false, balanced = false;
  c2d_status status = loads_balance(f, &unloaded, &balanced);
  if (status != C2D_OK || !balanced) return status;
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    reset_pair(pair);
    pair.status = C2D_OPEN;
    keep_place(pair, pair.gap / t.length_unit, 0.0);
  }
  status = build_tableau(t, *f.tape, &f.last_pair);
  if (status == C2D_ERR_SINGULAR) return C2D_OK;
  if (status == C2D_OK) *outcome = C2D_REACHED;
  refresh(f);
  return status;
}

// The work of the loads along the path's direction on a free motion of a body; zero if it is no more than round-off.
double work_on(const Follower& f, int b, int32_t motion) {
  double work = 0.0, size = 0.0;
  for (int32_t k = 0; k < f.t->cases; ++k) {
    const double* const of_case = f.model->load_work[b] + 4 * static_cast<int64_t>(k);
    work += f.direction[k] * of_case[motion];
    size += fabs(f.direction[k]) * of_case[3];
  }
  return fabs(work) > 1e-10 * size ? work : 0.0;
}

// A body's free motions made orthonormal by what they move the pairs, METHOD (13.3), and the work on them that balances the
// loads'.
void make_ways(const ForceCone& cone, int b, double way[kMostMotions][3]) {
  const Body& body = cone.m.body[b];
  double* const load = cone.load + body.first_motion;
  for (int32_t j = 0; j < body.free_motions; ++j) {
    for (int c = 0; c < 3; ++c) way[j][c] = body.free_motion[j][c];
    const double before = pair_product(cone.m, b, way[j], way[j]);
    load[j] = -work_on(cone.f, b, j);
    for (int32_t i = 0; i < j; ++i) {
      const double part = pair_product(cone.m, b, way[j], way[i]);
      for (int c = 0; c < 3; ++c) way[j][c] -= part * way[i][c];
      load[j] -= part * load[i];
    }
    const double left = pair_product(cone.m, b, way[j], way[j]), size = sqrt(left);
    const bool seen = left > 1e-16 * before; // or no pair moves: nothing stops it
    for (int c = 0; c < 3; ++c) way[j][c] = seen ? way[j][c] / size : 0.0;
    if (seen) load[j] /= size;
  }
}

// The motions that the equations know, columns of the resultants of body b, made orthonormal alike.
void orthonormalise_motions(const ForceCone& cone, int b) {
  const auto rows = [&](auto visit) {
    for_slots_of(cone.m, b, [&](const Pair& pair, int side, int slot) {
      const bool counts = zone_of(cone.m, pair).is_self == 0; // a body moves along with itself
      visit(counts ? pair.length : 0.0, cone.resultants_of(pair, side, slot));
    });
  };
  for (int32_t j = 0; j < cone.m.body[b].free_motions; ++j) {
    for (int32_t i = 0; i < j; ++i) {
      double part = 0.0;
      rows([&](double length, const Real* row) { part += length * row[i] * row[j]; });
      rows([&](double, Real* row) { row[j] -= static_cast<Real>(part * row[i]); });
    }
    double size = 0.0;
    rows([&](double length, const Real* row) { size += length * row[j] * row[j]; });
    rows([&](double, Real* row) { row[j] = static_cast<Real>(size > 0.0 ? row[j] / sqrt(size) : 0.0); });
  }
}

// Motions of body b, to the last digit those that strain nothing, and as nearly as they can be those of a rigid body on which
// the loads' work is known. (They are the same, unless functions are of lower order than the geometry.)
c2d_status read_motions(const ForceCone& cone, int b, Real* column) {
  const Body& body = cone.m.body[b];
  double way[kMostMotions][3], mix[kMostMotions][kMostMotions] = {};
  make_ways(cone, b, way);
  const c2d_status status = read_columns(cone, b, BodyMatrix::motions, column);
  orthonormalise_motions(cone, b);
  for_slots_of(cone.m, b, [&](const Pair& pair, int side, int slot) {
    for (int32_t j = 0; j < body.free_motions && zone_of(cone.m, pair).is_self == 0; ++j) {
      double w[2];
      motion_at_pair(cone.m, b, way[j], body.centre, pair, w);
      for (int32_t i = 0; i < body.free_motions; ++i)
        mix[i][j] += pair.length * cone.resultants_of(pair, side, slot)[i] * w[slot];
    }
  });
  for_slots_of(cone.m, b, [&](const Pair& pair, int side, int slot) {
    mix_row(cone.resultants_of(pair, side, slot), body.free_motions, mix);
  });
  return status;
}

// As far against cone.rest, the way that the loads push, as the first pairs that touch let it go. False: it meets none.
bool move_to_touch(Follower& f, const ForceCone& cone) {
  const double touches = kValueTolerance * cone.scales.w;
  double most = 0.0, distance = -1.0;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    for (int slot = 0; slot <= pair.tangential; ++slot) {
      const double rate = -work(cone.of(pair, slot), cone.rest);
      f.dy[pair.dof + slot] = static_cast<Real>(rate);
      most = fmax(most, fabs(rate));
    }
  }
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const double gap = f.y[f.t->pair[i].dof], closing = -static_cast<double>(f.dy[f.t->pair[i].dof]);
    if (gap <= touches || closing <= 1e-9 * most) continue; // it touches already, or passes by
    if (distance < 0.0 || gap < distance * closing) distance = gap / closing;
  }
  for (int32_t i = 0; i < f.t->m && distance >= 0.0; ++i) f.y[i] += static_cast<Real>(distance) * f.dy[i];
  return distance >= 0.0;
}

// The tableau of statuses at zero load. Motions that they leave, but no load drives, are no fault.
c2d_status build_at_rest(Follower& f) {
  Tableau& t = *f.t;
  c2d_status status = build_tableau(t, *f.tape, &f.last_pair);
  if (status != C2D_ERR_SINGULAR) return status;
  keep_open_places(f);
  t.may_rest = 1;
  status = build_tableau(t, *f.tape, &f.last_pair);
  if (status != C2D_OK) t.may_rest = 0;
  return status;
}

// A pair without a share in forces is pressed until the next ones touch: these have no pressure yet, and so no friction. They
// stick where the bodies are then.
c2d_status stick_without_friction(Follower& f) {
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    if (pair.status == C2D_STICK) pair.status = C2D_SLIP, pair.sign = 1;
  }
  const c2d_status status = build_at_rest(f);
  if (status != C2D_OK) return status;
  refresh(f);
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    if (pair.status != C2D_SLIP || pair.law.is_smooth()) continue;
    pair.status = C2D_STICK;
    pair.sign = 0;
    pair.offset = pair.tangential ? f.y[pair.dof + 1] : Real(0);
  }
  return build_at_rest(f);
}

// What touches where the pairs are now holds them.
c2d_status hold_touching(Follower& f, c2d_outcome* outcome) {
  const double touches = kValueTolerance * decision_scales(f).w;
  bool as_if_rigid = true;
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    Pair& pair = f.t->pair[i];
    if (f.y[pair.dof] > touches) continue;
    if (kRings && f.y[pair.dof] < -touches) as_if_rigid = false;
    const Real along = pair.tangential ? f.y[pair.dof + 1] : Real(0);
    pair.status = pair.law.is_smooth() ? C2D_SLIP : C2D_STICK;
    pair.sign = pair.status == C2D_SLIP ? 1 : 0;
    (pair.status == C2D_STICK ? pair.offset : pair.slip_from) = along;
  }
  const c2d_status status = as_if_rigid ? build_at_rest(f) : stick_without_friction(f);
  if (status != C2D_OK) return status == C2D_ERR_SINGULAR ? c2d_status{C2D_OK} : status;
  if (as_if_rigid) set_constants(f);
  refresh(f);
  *outcome = C2D_REACHED;
  return C2D_OK;
}

// The bodies slide without friction until what touches balances the loads, with its friction.
c2d_status slide_to_rest(Follower& f, c2d_outcome* outcome) {
  Real* column;
  ForceCone cone = cone_for_tableau(f, &column);
  c2d_status status = C2D_OK;
  for (int b = 0; b < f.model->head->bodies && cone.load && status == C2D_OK; ++b)
    if (f.model->body[b].contact > 0) status = read_motions(cone, b, column);
  if (status != C2D_OK || !cone.load) return status;
  const int64_t steps = 100 + int64_t{20} * (f.t->pairs + cone.motions);
  for (int64_t step = 0; !C2D_NEVER(step == steps); ++step) { // (each ends at a touch, or at none)
    cone.scales = decision_scales(f);
    if (!is_unbalanced(cone, Friction::own)) return hold_touching(f, outcome);
    const bool moves = is_unbalanced(cone, Friction::none);
    if (C2D_NEVER(!moves)) return hold_touching(f, outcome); // with friction there is no less
    f.moving = body_in_motion(cone);
    if (move_to_touch(f, cone)) continue;
    is_unbalanced(cone, Friction::own); // nothing stops them without friction: they roll and tip against it
    if (!move_to_touch(f, cone)) break;
  }
  return C2D_OK;
}

} // namespace

c2d_status seat(Follower& f, int32_t floating, c2d_outcome* outcome) {
  Tableau& t = *f.t;
  *outcome = C2D_FREE_MOTION;
  keep_pairs(f);
  c2d_status status = lie_apart(f, outcome);
  if (status != C2D_OK || *outcome == C2D_REACHED) return status;
  for (int32_t i = 0; i < t.pairs; ++i) {
    reset_pair(t.pair[i]);
    t.pair[i].status = C2D_OPEN;
  }
  if (!kSmallCode) end_sleep(t); // there is no tableau on the way, and any pair may be met
  t.guided = 0;
  f.idle = false;
  f.bound.pair = -1;
  place_as_given(f);
  status = slide_to_rest(f, outcome);
  if (status != C2D_OK || *outcome == C2D_REACHED) return status;
  if (floating == 0) return restore_pairs(f);
  touch_statuses(t);
  place_as_given(f);
  return C2D_OK;
}

} // namespace c2d
