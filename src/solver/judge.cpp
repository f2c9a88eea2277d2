#include "solver/judge.hpp"

#include <string.h>

#include "bie/columns.hpp"
#include "contact/basis.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/frictionless.hpp"
#include "contact/let_go.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "contact/reduction/rigid_balance.hpp"
#include "contact/start.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/pair_frame.hpp"
#include "solver/energy/energy.hpp"
#include "solver/load_path.hpp"

namespace c2d {

C2D_USES(EnergyPart);

namespace {

double larger(double a, double b) { return a > b ? a : b; }

// Array kJudge.
struct Book {
  Real* stick;                     // v.T [m]; of the open form it counts for tau, and what v' is for w'
  double* stick_load;              // v.b [cases]
  Real *equation_w, *equation_tau; // v'.B, v'.A [m]; v' is v without its part along C (contact/reduction/reduction.hpp)
  double* equation_load;           // v'.h [cases]
  double* equation_terms;          // magnitudes of what h is the rest of [cases]
  Real* moment[2];                 // [m] of tau = 1 on the body of a side about its centre, where that body floats
  double *load, *work, *rubbed;    // of the good state: [cases], [cases], [zones]
};

Book book_of(c2d_solver* s) {
  Book book{};
  book.rubbed = rubbed(s) + s->model.zones;
  double* at = rubbed(s) + 2 * s->model.zones;
  double** const of_cases[] = {&book.stick_load, &book.equation_load, &book.equation_terms, &book.load, &book.work};
  for (double** list : of_cases) {
    *list = at;
    at += s->model.load_cases;
  }
  Real* number = reinterpret_cast<Real*>(at);
  Real** const of_unknowns[] = {&book.stick, &book.equation_w, &book.equation_tau, &book.moment[0], &book.moment[1]};
  for (Real** list : of_unknowns) {
    *list = number;
    number += s->model.contact;
  }
  return book;
}

bool floats(const Body& body) { return body.contact > 0 && body.free_motions > 0; }

// v.A, with v in the place of y.
template <class Number> c2d_status project(const Session& session, ContactMatrix matrix, int32_t columns, Number* out) {
  const int32_t m = session.model.head->contact;
  for (int32_t j = 0; j < columns; ++j) {
    const c2d_status status = read_column(session.tape, matrix, j, session.area.column);
    if (status != C2D_OK) return status;
    out[j] = static_cast<Number>(product(session.area.y, session.area.column, m));
  }
  return C2D_OK;
}

// On demand v.T of a column is v'.A less what it makes of the slots that hold motions, METHOD (10.11), v'.A being known of all.
c2d_status take_balance(const Session& session, const Book& book, const Form& form, int32_t count, const int32_t* dof) {
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < count; ++j) book.stick[dof[j]] = book.equation_tau[dof[j]];
  for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) {
    const Real* g = nullptr;
    status = view_column(session.tape, ContactMatrix::resultants, k, &g);
    for (int32_t j = 0; j < count && status == C2D_OK; ++j) book.stick[dof[j]] -= book.equation_tau[form.held[k]] * g[dof[j]];
  }
  for (int32_t j = 0; j < count; ++j)
    if (has_force(form, session.model, dof[j])) book.stick[dof[j]] = 0;
  return status;
}

// The same of columns of A that are made on demand, v' in the place of y: of those that are there.
c2d_status project_made(const Session& session, const Book& book, const Form& form) {
  const Model& m = session.model;
  for (int32_t i = 0; i < m.head->contact; ++i) book.equation_tau[i] = book.stick[i] = 0;
  const auto for_made = [&](auto visit) {
    c2d_status status = C2D_OK;
    for (int32_t i = 0; i < m.head->pairs; ++i)
      for (int slot = 0; slot <= (session.solver->sliding != 0 ? 0 : m.pair[i].tangential) && m.pair[i].made >= 0; ++slot)
        if (status == C2D_OK) status = visit(m.pair[i], slot);
    return status;
  };
  const c2d_status status = for_made([&](const Pair& pair, int slot) {
    const c2d_status read = read_compliance(session.tape, pair, slot, session.area.column);
    if (read == C2D_OK)
      book.equation_tau[pair.dof + slot] = static_cast<Real>(product(session.area.y, session.area.column, m.head->contact));
    return read;
  });
  return status != C2D_OK ? status : for_made([&](const Pair& pair, int slot) {
    const int32_t dof = pair.dof + slot;
    return take_balance(session, book, form, 1, &dof);
  });
}

// v.R of the motions that slots hold, to these.
c2d_status project_held(const Session& session, const Form& form, Real* out) {
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < session.model.head->contact; ++i) out[i] = 0;
  for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) {
    const Real* motion = nullptr;
    status = view_column(session.tape, ContactMatrix::motions, k, &motion);
    if (status == C2D_OK) out[form.held[k]] = static_cast<Real>(product(session.area.y, motion, session.model.head->contact));
  }
  return status;
}

// v'.B: of the pairs' own rows v' itself, else with S_u of the body that keeps its equations.
c2d_status project_motions(const Session& session, Real* out) {
  const Model& m = session.model;
  const Real* v = session.area.y;
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < m.head->contact; ++i) out[i] = v[i];
  for (int b = 0; b < m.head->bodies; ++b) {
    if (!keeps_equations(m, b) || session.solver->open != 0) continue;
    Real* own = session.area.motion; // v' by the body's equations
    for_ranges(m, b, [&](const UnknownRange& range) {
      for (int32_t i = 0; i < range.count; ++i) own[range.own + i] = v[range.all + i];
    });
    for_ranges(m, b, [&](const UnknownRange& range) {
      for (int32_t j = 0; j < range.count && status == C2D_OK; ++j) {
        status = read_column(session.tape, b, BodyMatrix::displacement, range.own + j, session.area.column);
        out[range.all + j] = static_cast<Real>(signed_on(range.side, product(own, session.area.column, m.body[b].contact)));
      }
    });
  }
  return status;
}

// v'.C of what displacements of body b, where these are unknowns, have beyond its motions, to `out`; v' stands in y.
c2d_status project_displacements(const Session& session, int b, Real* out) {
  const Model& m = session.model;
  const Real* v = session.area.y;
  Real *own = session.area.own, *column = session.area.column;
  c2d_status status = C2D_OK;
  for_ranges(m, b, [&](const UnknownRange& range) {
    if (!keeps_equations(m, range.other)) {
      for (int32_t i = 0; i < range.count; ++i) out[range.own + i] = signed_on(range.side, v[range.all + i]);
      return;
    }
    for_ranges(m, range.other, [&](const UnknownRange& of_other) { // v' by the other body's equations
      for (int32_t i = 0; i < of_other.count; ++i) own[of_other.own + i] = v[of_other.all + i];
    });
    for (int32_t i = 0; i < range.count && status == C2D_OK; ++i) {
      status = read_column(session.tape, range.other, BodyMatrix::displacement, range.other_own + i, column);
      out[range.own + i] = static_cast<Real>(-product(own, column, m.body[range.other].contact));
    }
  });
  return status;
}

// The body's own equations, S_t t - S_u z + sum lambda_k s_k = 0, join the check, with signs for v', and z, which is known by
// X w' + sum lambda_k x_k, goes out of it.
c2d_status join_own_equations(const Session& session, const Book& book, int b) {
  const Model& m = session.model;
  const int32_t n = m.body[b].contact;
  Real *g = session.area.motion, *own = session.area.own, *column = session.area.column;
  c2d_status status = project_displacements(session, b, g);
  for (int32_t i = 0; i < n; ++i) own[i] = static_cast<Real>(sign_of(i));
  for_ranges(m, b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count && status == C2D_OK; ++i) {
      status = read_column(session.tape, b, BodyMatrix::displacement, range.own + i, column);
      g[range.own + i] -= static_cast<Real>(product(own, column, n));
      if (status == C2D_OK) status = read_column(session.tape, b, BodyMatrix::traction, range.own + i, column);
      book.equation_tau[range.all + i] += static_cast<Real>(signed_on(range.side, product(own, column, n)));
    }
  });
  for (int32_t i = 0; i < n && status == C2D_OK; ++i) {
    status = read_column(session.tape, b, BodyMatrix::flexibility, i, column);
    for (int32_t j = 0; j < m.head->contact; ++j) book.equation_w[j] -= g[i] * column[j];
  }
  for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) {
    status = read_column(session.tape, b, BodyMatrix::load, k, column);
    book.equation_load[k] += product(own, column, n);
    if (status == C2D_OK) status = read_column(session.tape, b, BodyMatrix::response, k, column);
    book.equation_load[k] += product(g, column, n);
  }
  return status;
}

// h is B times the differences of what the loads move the bodies: v'.B times the magnitudes of these. What ties hand on
// without a force differs by round-off alone.
c2d_status add_terms(const Session& session, int b, const Real* equation_w, double* terms) {
  const Model& m = session.model;
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) {
    status = read_column(session.tape, b, BodyMatrix::response, k, session.area.column);
    for_ranges(m, b, [&](const UnknownRange& range) {
      for (int32_t i = 0; i < range.count; ++i)
        terms[k] +=
            fabs(static_cast<double>(equation_w[range.all + i]) * static_cast<double>(session.area.column[range.own + i]));
    });
  }
  return status;
}

// The moments of contact tractions on a floating body about its centre.
void find_moments(const Model& m, int b, Real* const moment[2]) {
  const double unit = m.head->length_unit, cx = m.body[b].centre[0] / unit, cy = m.body[b].centre[1] / unit;
  for (ContactEnd end; next_contact_end(m, b, end);) {
    const Pair& pair = m.pair[end.at.pair];
    const EndResultant& w = end.weight();
    for (int32_t d = 0; d <= pair.tangential; ++d) {
      const double x = signed_on(end.at.side, along(pair, d, 0)), y = signed_on(end.at.side, along(pair, d, 1));
      moment[end.at.side][pair.dof + d] += static_cast<Real>((w.wx - cx * w.w) * y - (w.wy - cy * w.w) * x);
    }
  }
}

} // namespace

c2d_status note_demanded(Session& session, const Form& form, int32_t count, const int32_t* dof, const Real* columns) {
  const Book book = book_of(session.solver);
  const int32_t contact = session.model.head->contact;
  for (int32_t j = 0; j < count; ++j)
    book.equation_tau[dof[j]] =
        static_cast<Real>(product(book.equation_w, columns + 2 * static_cast<int64_t>(j) * contact, contact));
  return take_balance(session, book, form, count, dof);
}

c2d_status build_judge(c2d_solver* s) {
  if (s->model.contact == 0) return C2D_OK;
  Session session;
  open_session(s, session);
  const Book book = book_of(s);
  const int32_t m = s->model.contact, cases = s->model.load_cases;
  Form form;
  c2d_status status = kSmallCode ? c2d_status{C2D_OK} : read_form(session.tape, session.area.column, &form);
  if (!kSmallCode) s->sliding = form.sliding, s->open = form.open;
  for (int32_t i = 0; i < m; ++i) {
    const bool held = !kSmallCode && form.open && has_force(form, session.model, i);
    session.area.y[i] = held ? Real(0) : static_cast<Real>(sign_of(i)); // no path has begun
    book.moment[0][i] = book.moment[1][i] = 0;
  }
  const bool demand = is_on_demand(session.model);
  if (!kSmallCode && status == C2D_OK && demand) status = project_held(session, form, book.stick);
  if (status == C2D_OK && !demand) status = project(session, ContactMatrix::stiffness, m, book.stick);
  if (status == C2D_OK) status = project(session, ContactMatrix::stiffness_load, cases, book.stick_load);
  for (int32_t i = 0; i < m && form.sliding && !form.open; ++i) // w_t stands where q, which is zero, does else
    if (is_sliding_slot(session.model, i)) book.stick[i] = -session.area.y[i];
  // v' in the place of v: so that the equations hold whatever the motions x are, or what moves as the slots that are held.
  for (int32_t i = 0; i < m && form.open; ++i) {
    if (session.area.y[i] != 0) continue;
    session.area.y[i] = -book.stick[i];
    book.stick[i] = 0;
  }
  if (status == C2D_OK)
    status = take_out(session.tape, ContactMatrix::border, s->model.border, nullptr, session.area.y, session.area.column);
  for (int32_t i = 0; i < m && s->model.border == m; ++i) session.area.y[i] = 0; // what is left is round-off
  if (status == C2D_OK) status = project_motions(session, book.equation_w);
  if (!kSmallCode && demand && status == C2D_OK)
    status = project_made(session, book, form);
  else if (status == C2D_OK)
    status = project(session, ContactMatrix::compliance, m, book.equation_tau);
  if (status == C2D_OK) status = project(session, ContactMatrix::closing, cases, book.equation_load);
  for (int b = 0; b < s->model.bodies && status == C2D_OK; ++b)
    if (has_displacements(session.model, b)) status = join_own_equations(session, book, b);
  for (int32_t k = 0; k < cases; ++k) book.equation_terms[k] = 0.0;
  for (int b = 0; b < s->model.bodies; ++b) {
    const Body& body = session.model.body[b];
    if (status == C2D_OK && body.contact > 0 && (body.keeps_equations == kSolvedFor || form.open))
      status = add_terms(session, b, book.equation_w, book.equation_terms);
    if (!floats(body)) continue;
    find_moments(session.model, b, book.moment);
    find_load_work(session, b);
  }
  return status;
}

namespace {

// ---- the state kept ---------------------------------------------------------------------------------------------------

template <class Number> void copy(Number* to, const Number* from, int32_t n) {
  memcpy(to, from, static_cast<size_t>(n) * sizeof *to);
}

void keep_good(Session& session) {
  c2d_solver* s = session.solver;
  const Follower& f = session.follower;
  const Book book = book_of(s);
  copy(book.load, f.load, s->model.load_cases);
  for (int32_t i = 0; i < s->model.pairs; ++i) {
    Pair& pair = session.model.pair[i];
    pair.good_status = pair.status;
    pair.good_sign = pair.sign;
    pair.good_offset = pair.offset;
    pair.good_slip_done = pair.slip_done;
    pair.good_slip_from = pair.slip_from;
  }
  for (int32_t i = 0; i < s->model.pairs && follows_slip(session.tableau); ++i) {
    SlipGap& gap = session.model.slip_gap[i];
    gap.good = gap.now;
    gap.good_work = gap.work;
  }
  copy(session.area.good, f.y, s->model.contact);
  s->good_floating = s->floating;
  s->good_guided = session.tableau.guided;
  if (s->keeps_energy) {
    copy(book.work, kEnergyPart.work_by_case(s), s->model.load_cases);
    copy(book.rubbed, rubbed(s), s->model.zones);
  }
  s->good_dissipated = s->dissipated;
  s->good_least_dissipation = s->least_dissipation;
}

c2d_status rebuild(Session& session) {
  Follower& f = session.follower;
  const int32_t last_pair = f.last_pair;
  const c2d_status status = build_tableau(session.tableau, session.tape, &f.last_pair);
  if (status != C2D_OK) return status;
  f.last_pair = last_pair;
  session.solver->built_exchanges = session.tableau.exchanges;
  refresh(f);
  return C2D_OK;
}

// ---- what is judged ---------------------------------------------------------------------------------------------------

struct Sum {
  double value, size;
  void add(double term) {
    value += term;
    size += fabs(term);
  }
  double over(double least) const {
    const double by = larger(size, least);
    return by > 0.0 ? fabs(value) / by : 0.0;
  }
};

// Sums over everything, from one walk over the pairs.
struct State {
  Sum tableau, rates, equations;  // of the tableau: values, and rates of the whole piece of the path
  double terms;                   // of what the loads' part in the equations is the rest of
  double equation_tau;            // largest of Book::equation_tau
  double force;                   // magnitude of all forces, or of what the piece adds
  double no_force;                // that of pressures which round-off of motions makes: a body that goes along has only such
  double p, w;                    // largest pressure or friction (likewise), largest gap or motion
  double tension, overlap, slide; // largest of each; slide: friction beyond its bound, over the law's scale
  double dw, back;                // largest rate of a motion, of a slip along its friction
};

void add_pair(const Session& session, const Book& book, const Pair& pair, const PairState& now, const PairState& rate,
              State& out) {
  const double tau[2] = {now.p, now.q}, tau_rate[2] = {rate.p, rate.q};
  const double motion[2] = {now.wn - gap_of(session.tableau, pair), now.wt},
               motion_rate[2] = {rate.wn - gap_rate(session.tableau, pair), rate.wt};
  for (int32_t d = 0; d <= pair.tangential; ++d) {
    const int32_t j = pair.dof + d;
    const bool open = !kSmallCode && session.solver->open != 0;
    const double own = open ? static_cast<double>(book.equation_w[j]) : sign_of(j), stick = book.stick[j],
                 size = larger(fabs(tau[d]), fabs(tau_rate[d]));
    out.tableau.add(own * (open ? motion : tau)[d]);
    out.tableau.add(-stick * (open ? tau : motion)[d]);
    out.rates.add(own * (open ? motion_rate : tau_rate)[d]);
    out.rates.add(-stick * (open ? tau_rate : motion_rate)[d]);
    out.equations.add(book.equation_w[j] * motion[d]);
    out.equations.add(-book.equation_tau[j] * tau[d]);
    out.equation_tau = larger(out.equation_tau, fabs(static_cast<double>(book.equation_tau[j])));
    out.force += pair.weight * size;
    out.no_force += pair.weight;
    out.p = larger(out.p, size);
  }
  out.w = larger(out.w, larger(fabs(now.wn), fabs(now.wt)));
  out.overlap = larger(out.overlap, -now.wn);
  if (!is_tied(session.model, pair)) out.tension = larger(out.tension, -now.p);
  out.dw = larger(out.dw, larger(fabs(rate.wn), fabs(rate.wt)));
  if (pair.status == C2D_SLIP && pair.tangential && !pair.law.is_smooth()) out.back = larger(out.back, pair.sign * rate.wt);
  if (pair.status == C2D_STICK && pair.tangential && pair.law.has_bound())
    out.slide = larger(out.slide, pair.law.excess(now.p, now.q) / pair.law.scale());
}

State sum_up(const Session& session, const Book& book) {
  const Follower& f = session.follower;
  State out{};
  out.w = f.gap_scale;
  for (int32_t i = 0; i < session.model.head->pairs; ++i)
    add_pair(session, book, f.t->pair[i], pair_state(*f.t, i, f.y), pair_rates(*f.t, i, f.dy), out);
  const double unit = session.model.head->length_unit * session.model.head->stress_unit;
  double loads = 0.0;
  for (int32_t k = 0; k < f.t->cases; ++k) {
    out.tableau.add(-book.stick_load[k] * f.load[k]);
    out.rates.add(-book.stick_load[k] * f.direction[k]);
    out.equations.add(-book.equation_load[k] * f.load[k]);
    out.terms += book.equation_terms[k] * fabs(f.load[k]);
    for (int b = 0; b < session.model.head->bodies; ++b)
      if (floats(session.model.body[b]))
        loads += larger(fabs(f.load[k]), fabs(f.direction[k])) * session.model.load_work[b][4 * static_cast<int64_t>(k) + 3];
  }
  if (is_let_go(*f.t) || f.t->resting > 0)
    out.rates = Sum{}; // loads that move a body are no fault of the tableau: settle() sees them
  out.force = larger(unit * out.force, loads);
  out.no_force *= unit * kMixedNoise * f.t->stiffness * out.w;
  return out;
}

// Of the contact on a floating body: force, and moment about its centre.
void find_resultant(const Session& session, const Book& book, int b, double out[3]) {
  const Follower& f = session.follower;
  const double unit = session.model.head->length_unit * session.model.head->stress_unit;
  out[0] = out[1] = out[2] = 0.0;
  for (PairSide at = first_pair_side(); next_pair_of(session.model, b, at);) {
    const Pair& pair = f.t->pair[at.pair];
    const PairState now = pair_state(*f.t, at.pair, f.y);
    const double tau[2] = {now.p, now.q}, scale = signed_on(at.side, unit) * pair.weight;
    double force[2];
    to_global(pair, scale * now.p, pair.tangential ? scale * now.q : 0.0, force);
    for (int c = 0; c < 2; ++c) out[c] += force[c];
    for (int32_t d = 0; d <= pair.tangential; ++d) out[2] += unit * tau[d] * book.moment[at.side][pair.dof + d];
  }
}

// The largest work of contact and loads on a free motion of a body that is more than pressures of round-off make.
double imbalance(const Session& session, const Book& book, const State& state, int b) {
  const Body& body = session.model.body[b];
  double resultant[3], most = 0.0;
  find_resultant(session, book, b, resultant);
  // In free zones the moment on side 0 is that of tractions handed over, not of the pairs. A body that may turn about a support
  // has a reaction there, whose line of action is its element's, not the node's.
  const bool moments_differ = body.free_rows > 0 || body.free_motions < 3;
  for (int32_t j = 0; j < body.free_motions; ++j) {
    const double* motion = body.free_motion[j];
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) sum += resultant[i] * motion[i];
    for (int32_t k = 0; k < session.tableau.cases; ++k)
      sum += session.follower.load[k] * session.model.load_work[b][4 * static_cast<int64_t>(k) + j];
    if (fabs(sum) > state.no_force && (!moments_differ || motion[2] == 0.0)) most = larger(most, fabs(sum));
  }
  return most;
}

struct Findings {
  double drift;              // of the tableau
  double size[C2D_BREACHES]; // by C2D_BREACH_...
};

Findings look(Session& session, Agree with) {
  c2d_solver* s = session.solver;
  const Book book = book_of(s);
  const State state = sum_up(session, book);
  Findings out{};
  // What is there at no load is the round-off of what was, or of what this piece of the path adds.
  constexpr double kUnloaded = 1e-3;
  s->peak_terms[0] = larger(s->peak_terms[0], larger(state.tableau.size, state.rates.size));
  // Where all terms vanish by symmetry, what they are is the round-off of one pressure with the largest coefficient.
  s->peak_terms[1] = larger(larger(s->peak_terms[1], state.equation_tau * state.p), larger(state.equations.size, state.terms));
  s->peak_force = larger(s->peak_force, state.force);
  out.drift = larger(state.tableau.over(kUnloaded * s->peak_terms[0]), state.rates.over(0.0));
  out.size[C2D_BREACH_TABLEAU] = out.drift;
  // At no load at all there is nothing to compare with: the tableau's own residual sees that.
  if (state.tableau.size > kUnloaded * s->peak_terms[0])
    out.size[C2D_BREACH_EQUATIONS] = state.equations.over(kUnloaded * s->peak_terms[1]);
  for (int b = 0; b < s->model.bodies && s->peak_force > 0.0; ++b)
    if (floats(session.model.body[b]))
      out.size[C2D_BREACH_BALANCE] = larger(out.size[C2D_BREACH_BALANCE], imbalance(session, book, state, b) / s->peak_force);
  if (with == Agree::nothing) return out;
  const double p = larger(state.p, s->peak_pressure), stiffness = session.tableau.stiffness;
  const double w = stiffness > 0.0 ? larger(state.w, p / stiffness) : state.w;
  const double none = kMixedNoise * stiffness * state.w; // a body that goes along without force has only such pressures
  out.size[C2D_BREACH_SIGN] = larger(state.tension > none ? state.tension / p : 0.0, w > 0.0 ? state.overlap / w : 0.0);
  out.size[C2D_BREACH_CONE] = state.slide > none ? state.slide / p : 0.0;
  if (with == Agree::rates && state.dw > 0.0) out.size[C2D_BREACH_SLIP] = state.back / state.dw;
  return out;
}

double limit_of(int32_t breach) {
  return breach == C2D_BREACH_BALANCE ? kBalanceLimit : breach < C2D_BREACH_BALANCE ? kResidualLimit : kSignLimit;
}

// The first limit that is exceeded, C2D_BREACH_NONE if none is; a number that is no number exceeds all.
int32_t breach_in(const Findings& now) {
  for (int32_t i = C2D_BREACH_NONE + 1; i < C2D_BREACHES; ++i)
    if (!(now.size[i] <= limit_of(i))) return i;
  return C2D_BREACH_NONE;
}

c2d_status note_breach(c2d_solver* s, int32_t breach, double size) {
  s->breach = breach;
  s->breach_size = size;
  return kUnsound;
}

bool has_drifted(const c2d_solver* s, const Findings& now) {
  return !(now.drift <= kDriftLimit) && !(now.drift <= 10.0 * s->fresh_drift);
}

} // namespace

void begin_judging(Session& session) {
  c2d_solver* s = session.solver;
  s->unsound = s->careful = 0;
  s->breach = C2D_BREACH_NONE;
  s->breach_size = s->peak_force = s->peak_terms[0] = s->peak_terms[1] = s->fresh_drift = 0.0;
  s->built_exchanges = s->judged_exchanges = session.tableau.exchanges;
  keep_good(session);
}

namespace {

// A new tableau, and the statuses that go with its rates: once more where that has spoilt it again.
c2d_status mend(Session& session, Agree with, Findings& now) {
  c2d_solver* s = session.solver;
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const c2d_status status = rebuild(session);
    if (status == C2D_ERR_SINGULAR) return note_breach(s, C2D_BREACH_SINGULAR, 0.0);
    if (status != C2D_OK) return status;
    ++s->rebuilds;
    now = look(session, with);
    s->fresh_drift = now.drift;
    if (with != Agree::rates) return C2D_OK;
    c2d_outcome outcome = C2D_REACHED;
    const c2d_status settled = settle(session.follower, &outcome);
    if (settled != C2D_OK || outcome != C2D_REACHED) return settled;
    now = look(session, with);
    if (session.tableau.exchanges == s->built_exchanges || !has_drifted(s, now)) return C2D_OK;
  }
  return C2D_OK;
}

} // namespace

c2d_status judge(Session& session, Agree with) {
  c2d_solver* s = session.solver;
  C2D_ASSERT(s->blocked == 0 && s->unsound == 0); // such a path is not followed
  if (s->floating != 0) return C2D_OK;
  s->judged_exchanges = session.tableau.exchanges;
  Findings now = look(session, with);
  const bool changed = session.tableau.exchanges != s->built_exchanges;
  if (changed && (has_drifted(s, now) || s->careful != 0 || breach_in(now) != C2D_BREACH_NONE)) {
    // Statuses may have been decided on wrong numbers.
    if (!(now.drift <= kRepeatLimit) && s->careful == 0) return note_breach(s, C2D_BREACH_TABLEAU, now.drift);
    const c2d_status status = mend(session, with, now);
    if (status != C2D_OK) return status;
  }
  const int32_t breach = breach_in(now);
  if (breach != C2D_BREACH_NONE) return note_breach(s, breach, now.size[breach]);
  s->max_residual = larger(s->max_residual, now.size[C2D_BREACH_EQUATIONS]);
  if (with != Agree::nothing) keep_good(session);
  return C2D_OK;
}

bool may_be_shown(Session& session, Agree with) {
  c2d_solver* s = session.solver;
  C2D_ASSERT(s->floating == 0 && s->blocked == 0 && s->unsound == 0); // nothing changes there
  const double terms[2] = {s->peak_terms[0], s->peak_terms[1]}, force = s->peak_force;
  const Findings now = look(session, with);
  for (int i = 0; i < 2; ++i) s->peak_terms[i] = terms[i];
  s->peak_force = force;
  return breach_in(now) == C2D_BREACH_NONE;
}

c2d_status return_to_good(Session& session) {
  c2d_solver* s = session.solver;
  Follower& f = session.follower;
  const Book book = book_of(s);
  copy(f.load, book.load, s->model.load_cases);
  for (int32_t i = 0; i < s->model.pairs; ++i) {
    Pair& pair = session.model.pair[i];
    pair.status = pair.good_status;
    pair.sign = pair.good_sign;
    pair.offset = pair.good_offset;
    pair.slip_done = pair.good_slip_done;
    pair.slip_from = pair.good_slip_from;
  }
  for (int32_t i = 0; i < s->model.pairs && follows_slip(session.tableau); ++i) {
    SlipGap& gap = session.model.slip_gap[i];
    gap.now = gap.good;
    gap.work = gap.good_work;
    gap.rate = 0.0;
  }
  s->floating = s->good_floating;
  session.tableau.guided = s->good_guided;
  if (s->keeps_energy) {
    copy(kEnergyPart.work_by_case(s), book.work, s->model.load_cases);
    copy(rubbed(s), book.rubbed, s->model.zones);
  }
  s->dissipated = s->good_dissipated;
  s->least_dissipation = s->good_least_dissipation;
  if (s->floating != 0) return C2D_OK;
  const c2d_status status = rebuild(session);
  if (status != C2D_ERR_SINGULAR) return status;
  copy(f.y, session.area.good, s->model.contact);
  for (int32_t i = 0; i < s->model.contact; ++i) f.dy[i] = 0;
  forget(f.kept);
  s->unsound = 1;
  return status;
}

} // namespace c2d
