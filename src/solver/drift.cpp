// Round-off that gathers in the tableau: looked at now and then, and removed by building it anew.
#include <math.h>

#include "memory/text.hpp"
#include "solver/session.hpp"

namespace c2d {

namespace {

double largest_magnitude(const Real* x, int32_t n) {
  double size = 0.0;
  for (int32_t i = 0; i < n; ++i)
    if (fabs(static_cast<double>(x[i])) > size) size = fabs(static_cast<double>(x[i]));
  return size;
}

// Relative residual of B w' - M tau - sum lambda h, from the matrices on the tape.
c2d_status contact_residual(Session& session, double* out) {
  Follower& f = session.follower;
  const int32_t m = f.t->m;
  Real *sum = session.area.u[0], *magnitude = session.area.u[1], *column = session.area.column;
  session.solver->table_is_current = 0; // its displacements make room
  const ContactMatrix other =
      session.solver->inverted == 0 ? ContactMatrix::displacement2 : ContactMatrix::displacement1;
  for (int32_t i = 0; i < m; ++i) sum[i] = magnitude[i] = 0;
  const auto add = [&](ContactMatrix matrix, int32_t j, double factor) -> c2d_status {
    if (factor == 0.0) return C2D_OK;
    const c2d_status status = read_column(session.tape, matrix, j, column);
    for (int32_t i = 0; i < m && status == C2D_OK; ++i) {
      sum[i] += static_cast<Real>(factor) * column[i];
      magnitude[i] += static_cast<Real>(fabs(factor * column[i]));
    }
    return status;
  };
  c2d_status status = C2D_OK;
  for (int32_t i = 0; i < f.t->pairs && status == C2D_OK; ++i) {
    const Pair& pair = f.t->pair[i];
    const PairState now = pair_state(*f.t, i, f.y);
    status = add(other, pair.dof, now.wn - pair.gap / f.t->length_unit);
    if (status == C2D_OK) status = add(ContactMatrix::compliance, pair.dof, -now.p);
    if (status == C2D_OK && pair.tangential) status = add(other, pair.dof + 1, now.wt);
    if (status == C2D_OK && pair.tangential) status = add(ContactMatrix::compliance, pair.dof + 1, -now.q);
  }
  for (int32_t k = 0; k < f.t->cases && status == C2D_OK; ++k) status = add(ContactMatrix::closing, k, -f.load[k]);
  const double size = largest_magnitude(magnitude, m);
  *out = size > 0.0 ? largest_magnitude(sum, m) / size : 0.0;
  return status;
}

void warn_drift(c2d_solver* s, double residual) {
  c2d_error e = blank_error();
  e.status = C2D_WARN_RESIDUAL;
  e.severity = C2D_WARNING;
  Text text = text_in(e.text);
  put_all(text, "the contact tableau had drifted (relative residual ", residual, ") and was built anew");
  report_fault(s, e);
}

// Look at the residual now and then; build the tableau anew when it has grown.
constexpr int64_t kExchangesBetweenLooks = 200;
constexpr double kDrift = sizeof(Real) == 8 ? 1e-10 : 1e-3;

} // namespace

c2d_status guard_drift(Session& session, bool always) {
  c2d_solver* s = session.solver;
  if (s->floating || s->model.contact == 0 || s->blocked) return C2D_OK;
  if (!always && session.tableau.exchanges - s->checked_exchanges < kExchangesBetweenLooks) return C2D_OK;
  s->checked_exchanges = session.tableau.exchanges;
  const double pressure = path_scales(session.follower).p;
  s->peak_pressure = fmax(s->peak_pressure, pressure);
  if (pressure < 1e-3 * s->peak_pressure) return C2D_OK; // unloaded: round-off of what was is all there is to see
  double residual = 0.0;
  c2d_status status = contact_residual(session, &residual);
  if (status != C2D_OK) return status;
  if (residual > s->max_residual) s->max_residual = residual;
  if (residual <= kDrift) return C2D_OK;
  warn_drift(s, residual);
  ++s->rebuilds;
  status = build_tableau(session.tableau, session.tape, &session.follower.last_pair);
  refresh(session.follower);
  return status;
}

} // namespace c2d
