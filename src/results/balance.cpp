// Resultants of what acts on both bodies, and their balance. Optional (memory/parts.hpp).
#include <math.h>

#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "memory/parts.hpp"
#include "results/back.hpp"
#include "results/balance.hpp"
#include "results/transferred.hpp"
#include "solver/load_path.hpp"
#include "solver/support.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(BodyForcePart);

namespace {

// The contact's share of an element, from tau itself in its own measure.
void add_contact_end(const Session& session, int b, int32_t index, const EndResultant& w, double out[3]) {
  const ModelHeader& head = *session.model.head;
  const PairState now = pair_state(*session.follower.t, index, session.follower.y);
  const double scale = (b == 1 ? 1.0 : -1.0) * head.stress_unit * head.length_unit;
  double t[2];
  to_global(session.model.pair[index], now.p * scale, now.q * scale, t);
  add_force(out, w.w * t[0], w.w * t[1], head.length_unit * (w.wx * t[1] - w.wy * t[0]));
}

void sum_forces(Session& session, int b) {
  const Model& m = session.model;
  const double unit = m.head->length_unit;
  double *applied = session.solver->applied[b], *contact = session.solver->contact_force[b];
  for (int i = 0; i < 3; ++i) applied[i] = contact[i] = 0.0;
  for (int32_t element = 0; element < m.head->body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    EndResultant own[kElementNodes], shared[kElementNodes];
    end_resultants(m, b, element, Measure::own_length, own);
    end_resultants(m, b, element, Measure::contact, shared);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const int32_t index = pair_of_end(m, b, element, l);
      if (index >= 0) add_contact_end(session, b, index, shared[l], contact);
      const int32_t end = element * m.head->function_nodes + l, node = functional_node(m, b, element, l);
      double total[2], t[2];
      get_traction(session, b, end, total);
      transferred_traction(session, b, element, l, t);
      for (int c = 0; c < 2; ++c) t[c] = total[c] - t[c];
      const EndResultant& w = own[l];
      for (int c = 0; c < 2; ++c) {
        if (index >= 0 && (is_rigid(m, b) || unknown_at(m, b, node, c).kind == UnknownKind::contact)) continue;
        add_force(applied, c == 0 ? unit * w.w * t[0] : 0.0, c == 1 ? unit * w.w * t[1] : 0.0,
                  unit * unit * (c == 1 ? w.wx * t[1] : -w.wy * t[0]));
      }
    }
  }
  if (b == 0 && m.head->free_rows > 0) kFreeZonePart.add_transferred_force(session, contact);
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& p = m.point_load[i];
    if (p.body != b) continue;
    const double f = session.follower.load[p.load_case];
    add_force(applied, f * p.fx, f * p.fy, f * (p.x * p.fy - p.y * p.fx));
  }
  for (int32_t k = 0; k < m.head->load_cases && has_body_force(m, b); ++k) {
    double force[3];
    kBodyForcePart.body_force_resultant(m, b, k, 0.0, 0.0, force);
    const double f = session.follower.load[k];
    add_force(applied, f * force[0], f * force[1], f * force[2]);
  }
  if (!is_rigid(m, b)) return;
  for (int i = 0; i < 3; ++i) applied[i] = -contact[i]; // what holds it
}

// Part of a force along the translations that the body is free to follow; all of it if it is held.
void free_part(const Body& body, int32_t symmetry, const double force[3], double out[2]) {
  if (body.free_motions == 0) { // what acts across a symmetry line is balanced by the other side
    for (int c = 0; c < 2; ++c) out[c] = (symmetry >> c & 1) != 0 ? 0.0 : force[c];
    return;
  }
  double basis[3][3];
  int rank = 0;
  for (int i = 0; i < body.free_motions && rank < 2; ++i) {
    double row[3] = {body.free_motion[i][0], body.free_motion[i][1], 0.0};
    rank += extend_basis(basis, rank, 2, row);
  }
  out[0] = out[1] = 0.0;
  for (int i = 0; i < rank; ++i) {
    const double along = basis[i][0] * force[0] + basis[i][1] * force[1];
    for (int c = 0; c < 2; ++c) out[c] += along * basis[i][c];
  }
}

} // namespace

void balance_forces(Session& session) {
  c2d_solver* s = session.solver;
  for (int b = 0; b < s->model.bodies; ++b) sum_forces(session, b);
  const int b = s->model.contact > 0 ? 1 - s->inverted : 0;
  double applied[2], contact[2];
  free_part(s->model.body[b], s->model.symmetry, s->applied[b], applied);
  free_part(s->model.body[b], s->model.symmetry, s->contact_force[b], contact);
  s->force_applied = hypot(applied[0], applied[1]);
  s->force_contact = hypot(contact[0], contact[1]);
  const double rest = hypot(applied[0] + contact[0], applied[1] + contact[1]);
  const double size = s->force_applied > s->force_contact ? s->force_applied : s->force_contact;
  // Where nothing is loaded there is only the round-off of what was.
  // Nothing is loaded: what there is of forces is the round-off of those before, or of displacements.
  const double round_off = 1e-12 * path_scales(session.follower).w * s->model.stress_unit * s->model.length_unit;
  const bool loaded = size > kNoPressure * s->peak_force && size > round_off;
  s->force_error = s->model.contact > 0 && loaded ? rest / size : 0.0;
}

} // namespace c2d
