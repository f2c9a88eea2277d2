#include "solver/session.hpp"

#include <string.h>

#include "memory/hostile.hpp"
#include "solver/load_path.hpp"
#include "solver/support.hpp"

namespace c2d {

namespace {

FreeBody free_body(const c2d_solver* s, const Model& m) {
  FreeBody out{};
  if (m.head->contact == 0) return out;
  const Body& body = m.head->body[1 - s->inverted];
  out.body = 1 - s->inverted;
  out.motions = body.free_motions;
  for (int k = 0; k < 3; ++k) out.motion[k] = body.free_motion[0][k];
  for (int k = 0; k < 2; ++k) out.centre[k] = body.centre[k];
  find_slides(m, out);
  return out;
}

} // namespace

void note_free_body(Session& session) {
  session.free_body = free_body(session.solver, session.model);
  session.tableau.free_motions = session.free_body.others();
}

void open_session(c2d_solver* s, Session& session) {
  memset(static_cast<void*>(&session), 0, sizeof session);
  session.solver = s;
  session.model = model_of(s);
  const ModelHeader& head = s->model;
  const uint64_t bytes =
      path_area(model_sizes(session.model), s->plan, s->keeps_flexibility != 0, array_of<char>(s, kPhase), &session.area);
  C2D_ASSERT(bytes <= s->bytes - s->layout.persistent);
  static_cast<void>(bytes);
  const PathArea& area = session.area;
  session.tape = ContactTape{&s->tapes, head.contact, head.load_cases, area.buffer};
  session.tableau = Tableau{head.contact,
                            head.load_cases,
                            head.pairs,
                            session.model.pair,
                            area.tableau,
                            head.length_unit,
                            s->stiffness,
                            s->exchanges,
                            kernel_for(best_instructions()),
                            0,
                            nullptr,
                            nullptr,
                            s->guided};
  double* loads = array_of<double>(s, kLoads);
  session.follower.t = &session.tableau;
  session.follower.tape = &session.tape;
  session.follower.load = loads;
  session.follower.direction = loads + 2 * head.load_cases;
  session.follower.origin = loads + 3 * head.load_cases;
  session.follower.y = area.y;
  session.follower.dy = area.dy;
  session.follower.gap_scale = s->gap_scale;
  session.follower.pressure_scale = s->pressure_scale;
  session.follower.model = &session.model;
  session.follower.floating_body = 1 - s->inverted;
  // Results per pair are of no use while loads move.
  static_assert(kRateListBytes <= C2D_PAIR_FIELDS * sizeof(double),
                "the result table has room for the lists of the rate problem");
  session.follower.rate_area = RateArea{area.rates, array_of<double>(s, kPairTable), head.pairs};
  session.follower.bound.pair = -1;
  session.follower.watch = path_watch(session);
  session.follower.stats = s->stats;
  session.follower.last_pair = s->last_pair;
  session.tableau.model = &session.model;
  session.tableau.body = &session.free_body;
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
}

c2d_status load_flexibility(Session& session) {
  if (!session.area.flexibility || session.model.head->contact == 0) return C2D_OK;
  return read_matrix(session.tape, ContactMatrix::flexibility, session.area.flexibility);
}

} // namespace c2d
