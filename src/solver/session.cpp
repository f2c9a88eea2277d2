#include "solver/session.hpp"

#include <stddef.h>
#include <string.h>

#include "memory/hostile.hpp"
#include "memory/parts.hpp"
#include "model/pair_frame.hpp"
#include "solver/load_path.hpp"
#include "solver/support.hpp"

namespace c2d {

C2D_USES(CompressedPart);

namespace {

FreeBody free_body(const Model& m) {
  FreeBody out{};
  out.body = -1;
  out.motions = m.head->loose;
  int32_t last = 0;
  for (int b = 0; b < m.head->bodies; ++b)
    if (m.body[b].contact > 0 && m.body[b].free_motions > 0) last = b;
  // All of the motions left are those of one body, if they are as many and ties take none of them.
  if (out.motions == 0 || m.head->motions != out.motions || m.body[last].free_motions != out.motions) return out;
  const Body& body = m.body[last];
  out.body = last;
  for (int k = 0; k < 3; ++k) out.motion[k] = body.free_motion[0][k];
  for (int k = 0; k < 2; ++k) out.centre[k] = body.centre[k];
  find_slides(m, out);
  return out;
}

} // namespace

void pair_force(const Session& session, int32_t pair, double factor, double out[2]) {
  const PairState now = pair_state(session.tableau, pair, session.area.y);
  to_global(session.model.pair[pair], now.p * factor, now.q * factor, out);
}

void note_free_body(Session& session) {
  session.free_body = free_body(session.model);
  session.tableau.free_motions = session.free_body.others();
}

uint64_t open_path_area(c2d_solver* s, const Model& m, bool flexibility, PathArea& out) {
  const PhaseSizes sizes = model_sizes(m);
  return path_area(sizes, back_need(sizes, &plan_of(s, 0)), flexibility, array_of<char>(s, kPhase), &out);
}

namespace {

// Columns of the tableau.
int32_t tableau_room(const ModelHeader& head) { return !kSmallCode && head.columns > 0 ? head.columns : head.path_unknowns; }

// Products of the tableau are packed where the matrix of the rate problem stands, and else results: of no use while pairs
// change.
Engine engine_of_path(c2d_solver* s, const Session& session) {
  if (kSmallCode) return kPlainEngine;
  const int64_t n = tableau_room(s->model) + 1;
  return {kernel_for(s->instructions), session.area.rates, n * n, nullptr, workers_of(&s->port)};
}

// Those of the model, if a pair's gap follows its slip: from event to event.
SlipGap* slip_gaps(const c2d_solver* s, const Model& m) {
  if (s->options.stepping == C2D_STEPPING_DECK) return nullptr;
  for (int32_t i = 0; i < m.head->path_pairs && m.slip_gap != nullptr; ++i)
    if (m.slip_gap[i].follows != 0) return m.slip_gap;
  return nullptr;
}

void open_tableau(c2d_solver* s, Session& session, const double* loads) {
  const ModelHeader& head = s->model;
  Tableau& t = session.tableau;
  t = Tableau{head.contact,
              tableau_room(head),
              head.load_cases,
              head.path_pairs,
              session.model.pair,
              session.area.tableau,
              head.length_unit,
              s->stiffness,
              s->exchanges,
              engine_of_path(s, session),
              0,
              nullptr,
              nullptr,
              s->guided};
  t.load = loads;
  t.direction = loads + 2 * head.load_cases;
  t.may_rest = s->may_rest;
  t.resting = s->resting;
  place_list(t, session.area.delayed, s->delayed, s->awake);
  t.open = s->open != 0;
  t.sliding = s->sliding != 0;
  t.model = &session.model;
  t.body = &session.free_body;
  t.slip = slip_gaps(s, session.model);
}

void open_follower(c2d_solver* s, Session& session, double* loads) {
  const ModelHeader& head = s->model;
  Follower& f = session.follower;
  f.t = &session.tableau;
  f.tape = &session.tape;
  f.load = loads;
  f.direction = loads + 2 * head.load_cases;
  f.origin = loads + 3 * head.load_cases;
  f.y = session.area.y;
  f.dy = session.area.dy;
  f.gap_scale = s->gap_scale;
  f.pressure_scale = s->pressure_scale;
  f.model = &session.model;
  // Results per pair are of no use while loads move.
  static_assert(kRateListBytes <= C2D_PAIR_FIELDS * sizeof(double),
                "the result table has room for the lists of the rate problem");
  f.rate_area = RateArea{session.area.rates, array_of<double>(s, kPairTable), head.pairs};
  f.bound.pair = -1;
  f.moving = -1;
  f.watch = path_watch(session);
  f.stats = s->stats;
  f.last_pair = s->last_pair;
  f.idle = s->idle != 0;
  f.goes_on = s->goes_on != 0;
}

// (What the table holds is known when the program is linked: a compiler may take its address here for that of the empty one.)
c2d_status make_columns(const ContactTape& tape, const int32_t* pair, int32_t count) {
  const char* const session =
      reinterpret_cast<const char*>(&tape) - offsetof(Session, tape); // (it costs no room on a small stack)
  return kCompressedPart.make_columns(const_cast<char*>(session), pair, count);
}

} // namespace

void open_session(c2d_solver* s, Session& session) {
  memset(static_cast<void*>(&session), 0, sizeof session);
  session.solver = s;
  session.model = model_of(s);
  const uint64_t bytes = open_path_area(s, session.model, s->keeps_flexibility != 0, session.area);
  C2D_ASSERT(bytes <= s->bytes - s->layout.persistent);
  static_cast<void>(bytes);
  session.tape = ContactTape{&s->tapes, &session.model, session.area.buffer};
  if (!kSmallCode) session.tape.make = make_columns;
  double* loads = array_of<double>(s, kLoads);
  open_tableau(s, session, loads);
  open_follower(s, session, loads);
  note_free_body(session);
}

void close_session(Session& session) {
  c2d_solver* s = session.solver;
  s->stiffness = session.tableau.stiffness;
  s->exchanges = session.tableau.exchanges;
  s->gap_scale = session.follower.gap_scale;
  s->pressure_scale = session.follower.pressure_scale;
  s->stats = session.follower.stats;
  s->last_pair = session.follower.last_pair;
  s->guided = session.tableau.guided;
  s->may_rest = session.tableau.may_rest;
  s->resting = session.tableau.resting;
  s->delayed = session.tableau.delayed.count;
  s->awake = session.tableau.delayed.cols;
  s->idle = session.follower.idle;
  s->goes_on = session.follower.goes_on;
}

namespace {

int64_t flexibility_numbers(const Model& m, int b) {
  const int64_t n = is_on_demand(m) || is_rigid(m, b) || m.body[b].keeps_equations != kSolvedFor ? 0 : m.body[b].contact;
  return n * n;
}

} // namespace

c2d_status load_flexibility(Session& session) {
  const Model& m = session.model;
  if (!session.area.flexibility || m.head->contact == 0) return C2D_OK;
  c2d_status status = C2D_OK;
  Real* to = session.area.flexibility;
  for (int b = 0; b < m.head->bodies && status == C2D_OK; to += flexibility_numbers(m, b++))
    if (flexibility_numbers(m, b) > 0) status = read_matrix(session.tape, b, BodyMatrix::flexibility, to, m.body[b].contact);
  return status;
}

const Real* flexibility_of(const Session& session, int b) {
  const Real* at = session.area.flexibility;
  for (int i = 0; i < b; ++i) at += flexibility_numbers(session.model, i);
  return at;
}

} // namespace c2d
