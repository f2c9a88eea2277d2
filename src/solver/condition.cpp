// How many digits the equations of the bodies leave.

#include "bie/columns.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/validate/validate_finding.hpp"
#include "solver/judge.hpp"

namespace c2d {

C2D_USES(CompressedPart);

namespace {

// z = U^-T f with f = +-1 for the displacements of a body: f.x changes by z.r where the equations change by r, so |z|
// tells how much larger round-off of the equations, whose entries are of size one, is in the displacements. One pass over
// tape UPPER. A strip as thin as 1e-5 of its length has 1e15, which no ratio of pivots shows.
c2d_status find_growth(Session& session, int b, double* growth) {
  c2d_solver* s = session.solver;
  const Model& m = session.model;
  Real* f = session.area.outer;
  const int32_t columns = outer_columns(m, b);
  take_back_work(s);
  if (is_compressed(plan_of(s, b))) return kCompressedPart.compression_growth(session, b, growth);
  for (int32_t j = 0; j < columns; ++j) f[j] = 0;
  for (int32_t node = 0; node < m.body[b].nodes; ++node) {
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c)
      if (unknown[c].kind == UnknownKind::displacement)
        f[outer_column(m, b, node, c)] = static_cast<Real>(sign_of(2 * node + c));
  }
  const c2d_status status = transposed_functional(plan_of(s, b), s->tapes, f, nullptr, session.area.work);
  double sum = 0.0;
  for (int32_t j = 0; j < columns && status == C2D_OK; ++j) sum += static_cast<double>(f[j]) * static_cast<double>(f[j]);
  *growth = sqrt(sum);
  return status;
}

} // namespace

c2d_status find_condition(c2d_solver* s) {
  Session session;
  open_session(s, session);
  s->condition = fmax(s->condition, s->largest_pivot / s->smallest_pivot); // (that of the contact system is there)
  for (int b = 0; b < s->model.bodies; ++b) {
    if (is_rigid(session.model, b)) continue;
    double growth = 0.0;
    const c2d_status status = find_growth(session, b, &growth);
    if (status != C2D_OK) return status;
    if (growth > s->condition) s->condition = growth;
  }
  return C2D_OK;
}

void warn_condition(c2d_solver* s) {
  const double loss = kDigit * s->condition;
  if (!(loss > kLossLimit)) return;
  Finding out(C2D_WARN_CONDITION);
  put_all(out.text, "the equations are badly conditioned: round-off may be up to ", loss < 1.0 ? loss : 1.0,
          " of the displacements; a body may be very slender, supports too close together, or elements of very unlike size");
  report_fault(s, out.entry);
}

} // namespace c2d
