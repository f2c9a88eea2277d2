// The books of energy: work, friction, elastic energy, and their balance.
#include "solver/energy/energy.hpp"

#include "memory/math.hpp"

namespace c2d {

EnergyBook energy_book(c2d_solver* s) {
  EnergyBook book{};
  book.m = s->model.contact;
  book.cases = s->model.load_cases;
  double* at = array_of<double>(s, kEnergy);
  double** const lists[] = {&book.work, &book.u0, &book.r0, &book.u, &book.r};
  for (double** list : lists) {
    *list = at;
    at += book.cases;
  }
  book.of_loads = at;
  book.of_contact = reinterpret_cast<Real*>(at + 2 * static_cast<int64_t>(book.cases) * book.cases);
  return book;
}

double* work_by_case(c2d_solver* s) { return energy_book(s).work; }

void begin_energy(c2d_solver* s) {
  const EnergyBook book = energy_book(s);
  for (int32_t k = 0; k < book.cases; ++k) book.work[k] = 0.0;
  for (int32_t z = 0; z < s->model.zones; ++z) rubbed(s)[z] = 0.0;
  s->dissipated = s->elastic = s->work = s->energy_size = s->energy_defect = s->least_dissipation = 0.0;
  s->heading = 0;
  s->turns = 0;
}

void note_turn(Session& session, const double* target) {
  c2d_solver* s = session.solver;
  uint64_t heading = 0;
  double none = 0.0; // a factor that is held may have round-off
  for (int32_t k = 0; k < s->model.load_cases; ++k)
    none = fmax(none, 1e-12 * (fabs(target[k]) + fabs(session.follower.load[k])));
  for (int32_t k = 0; k < s->model.load_cases; ++k) { // a digit to base 3 each; of very many the first ones drop out
    const double step = target[k] - session.follower.load[k];
    heading = 3 * heading + (step > none ? 1 : step < -none ? 2 : 0);
  }
  if (heading == 0 || heading == s->heading) return;
  s->heading = heading;
  ++s->turns;
  const double now[3] = {s->work, s->elastic, s->dissipated};
  for (int i = 0; i < 3; ++i) {
    s->turn[2][i] = s->turn[1][i];
    s->turn[1][i] = s->turn[0][i];
    s->turn[0][i] = now[i];
  }
}

namespace {

double energy_unit(const Session& session) {
  const ModelHeader& head = *session.model.head;
  return head.stress_unit * head.length_unit * head.length_unit;
}

// Does load case k do work now? One whose factor is 0, and stays 0, does none: of a path through many cases all but a few.
bool works(const Follower& f, int32_t k) { return f.load[k] != 0.0 || f.direction[k] != 0.0 || f.origin[k] != 0.0; }

// U and R of the cases that do work, or of all (whose factors may change before the values are used), out of values (with gaps
// and load factors) or rates (without gaps, along the direction).
void evaluate(const Session& session, const EnergyBook& book, bool values, bool all = false) {
  const Follower& f = session.follower;
  const int64_t size = 2 * static_cast<int64_t>(book.m);
  const double* factor = values ? f.load : f.direction;
  const int32_t fit = session.model.head->interference;
  for (int32_t k = 0; k < book.cases; ++k) {
    book.u[k] = book.r[k] = 0.0;
    if (!all && !works(f, k)) continue;
    const double* load_part = book.of_loads + 2 * static_cast<int64_t>(k) * book.cases;
    const Real* work = book.of_contact + 2 * k * size;
    const Real* reaction = work + size;
    double u = 0.0, r = 0.0, along = 0.0, reacting = 0.0; // those of tangential slots apart: neither sum waits for the other
    for (int32_t i = 0; i < book.cases; ++i) {
      u += load_part[i] * factor[i];
      r += load_part[book.cases + i] * factor[i];
    }
    for (int32_t i = 0; i < session.model.head->pairs; ++i) {
      const Pair& pair = f.t->pair[i];
      const PairState now = values ? pair_state(*f.t, i, f.y) : pair_rates(*f.t, i, f.dy);
      const double closed = fit != 0 ? factor[fit - 1] * pair.overlap : 0.0;
      const double slid = values ? gap_by_slip(*f.t, pair) : gap_rate(*f.t, pair);
      const double wn = now.wn - ((values ? pair.gap : 0.0) - closed) / f.t->length_unit - slid;
      const auto take = [&](int32_t j, double force, double motion, double& of_u, double& of_r) {
        of_u += work[j] * force + work[book.m + j] * motion;
        of_r += reaction[j] * force + reaction[book.m + j] * motion;
      };
      take(pair.dof, now.p, wn, u, r);
      if (pair.tangential) take(pair.dof + 1, now.q, now.wt, along, reacting);
    }
    book.u[k] = u + along;
    book.r[k] = r + reacting;
  }
}

bool rubs(const Pair& pair) { return pair.status == C2D_SLIP && pair.tangential && !pair.law.is_smooth(); }

void add_dissipated(c2d_solver* s, double term) {
  s->dissipated += term;
  if (term < s->least_dissipation) s->least_dissipation = term;
}

void add_friction(c2d_solver* s, const Pair& pair, double term) {
  rubbed(s)[pair.zone] += term;
  add_dissipated(s, term);
}

} // namespace

// Where surfaces slide past each other's curvature pressure is along neither normal: it does the work of what slip adds to the
// gap.
static void add_slip_work(const Session& session, double unit, double part) {
  const Tableau& t = session.tableau;
  for (int32_t i = 0; i < t.pairs && follows_slip(t); ++i) {
    const double now = pair_state(t, i, session.follower.y).p, rate = pair_rates(t, i, session.follower.dy).p;
    t.slip[i].work -= unit * t.pair[i].weight * part * (now + 0.5 * part * rate) * t.slip[i].rate;
  }
}

void add_segment(Session& session, double part) {
  if (part <= 0.0) return;
  const Follower& f = session.follower;
  const EnergyBook book = energy_book(session.solver);
  const double unit = energy_unit(session);
  evaluate(session, book, true);
  for (int32_t k = 0; k < book.cases; ++k) {
    book.u0[k] = book.u[k];
    book.r0[k] = book.r[k];
  }
  evaluate(session, book, false);
  for (int32_t k = 0; k < book.cases; ++k) {
    const double half = 0.5 * part;
    book.work[k] +=
        unit * part * ((f.load[k] + half * f.direction[k]) * book.u[k] + (book.r0[k] + half * book.r[k]) * f.direction[k]);
  }
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    if (!rubs(pair)) continue;
    const PairState now = pair_state(*f.t, i, f.y), rate = pair_rates(*f.t, i, f.dy);
    add_friction(session.solver, pair, -unit * pair.weight * part * (now.q + 0.5 * part * rate.q) * rate.wt);
  }
  add_slip_work(session, unit, part);
}

// After evaluate() of the values.
static double elastic_energy(const Session& session, const EnergyBook& book) {
  const Follower& f = session.follower;
  double elastic = 0.0;
  for (int32_t k = 0; k < book.cases; ++k) elastic += f.load[k] * (book.u[k] + book.r[k]);
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    elastic += pair.weight * (now.p * (now.wn - gap_of(*f.t, pair)) + now.q * now.wt);
  }
  return 0.5 * energy_unit(session) * elastic;
}

void before_jump(Session& session) {
  const Follower& f = session.follower;
  const EnergyBook book = energy_book(session.solver);
  evaluate(session, book, true, true);
  session.solver->elastic = elastic_energy(session, book);
  for (int32_t k = 0; k < book.cases; ++k) {
    book.u0[k] = book.u[k];
    book.r0[k] = book.r[k];
  }
  for (int32_t i = 0; i < f.t->pairs; ++i) f.t->pair[i].saved_q = static_cast<Real>(pair_state(*f.t, i, f.y).q);
}

void after_jump(Session& session) {
  const Follower& f = session.follower;
  const EnergyBook book = energy_book(session.solver);
  const double unit = energy_unit(session);
  evaluate(session, book, true);
  for (int32_t k = 0; k < book.cases; ++k)
    book.work[k] +=
        0.5 * unit *
        ((f.origin[k] + f.load[k]) * (book.u[k] - book.u0[k]) + (book.r0[k] + book.r[k]) * (f.load[k] - f.origin[k]));
  for (int32_t i = 0; i < f.t->pairs; ++i) {
    const Pair& pair = f.t->pair[i];
    if (!rubs(pair) || pair.saved_status == C2D_OPEN) continue;
    const PairState now = pair_state(*f.t, i, f.y);
    add_friction(session.solver, pair, -0.5 * unit * pair.weight * (pair.saved_q + now.q) * (now.wt - pair.increment_from));
  }
}

void release(Session& session) {
  const Follower& f = session.follower;
  const EnergyBook book = energy_book(session.solver);
  const double before = session.solver->elastic;
  evaluate(session, book, true);
  double work = 0.0;
  for (int32_t k = 0; k < book.cases; ++k) work += energy_unit(session) * f.load[k] * (book.u[k] - book.u0[k]);
  const double released = work + before - elastic_energy(session, book);
  if (fabs(released) <= 1e-11 * (fabs(before) + fabs(work))) return; // round-off: nothing has jumped
  for (int32_t k = 0; k < book.cases; ++k) book.work[k] += energy_unit(session) * f.load[k] * (book.u[k] - book.u0[k]);
  add_dissipated(session.solver, fmax(released, 0.0)); // less than none is an error of the mesh, and remains in the balance
}

void close_balance(Session& session) {
  c2d_solver* s = session.solver;
  const EnergyBook book = energy_book(s);
  evaluate(session, book, true);
  s->work = 0.0;
  for (int32_t k = 0; k < book.cases; ++k) s->work += book.work[k];
  for (int32_t i = 0; i < session.tableau.pairs && follows_slip(session.tableau); ++i) s->work += session.tableau.slip[i].work;
  s->elastic = elastic_energy(session, book);
  const double sizes[] = {fabs(s->work), fabs(s->elastic), fabs(s->dissipated)};
  for (double size : sizes)
    if (size > s->energy_size) s->energy_size = size;
  s->energy_defect = s->energy_size > 0.0 ? (s->work - s->elastic - s->dissipated) / s->energy_size : 0.0;
}

} // namespace c2d
