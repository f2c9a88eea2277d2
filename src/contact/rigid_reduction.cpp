// What the reduction needs of a rigid body: optional (memory/parts.hpp).
#include "bie/measure.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/reduction.hpp"
#include "contact/start.hpp"
#include "model/pair_frame.hpp"

namespace c2d {

void rigid_motion_at_pair(const Model& m, const Pair& pair, int side, int32_t load_case, double v[2]) {
  double x, y, u[2];
  pair_position(m, pair, side, &x, &y);
  rigid_displacement(m, body_on(m, pair, side), load_case, x, y, u);
  to_frame(pair, u[0] / m.head->length_unit, u[1] / m.head->length_unit, v); // a power of two: the same digits
}

namespace {

// R: displacements at the pairs under one free motion.
void move_freely(const Model& m, int b, const double motion[3], Real* out) {
  for_pairs_of(m, b, [&](const Pair& pair, int side) {
    double w[2];
    motion_at_pair(m, b, motion, m.body[b].centre, pair, w);
    for (int32_t d = 0; d <= pair.tangential; ++d)
      out[dof_on(m, pair, side) + d] = static_cast<Real>(sign_of_side(side) * w[d]);
  });
}

// What the tractions of an element's ends do to a motion.
void add_element_work(const Model& m, int b, int32_t element, const double motion[3], Real* out) {
  const double unit = m.head->length_unit, cx = m.body[b].centre[0] / unit, cy = m.body[b].centre[1] / unit;
  EndResultant weight[kElementNodes];
  end_resultants(m, b, element, Measure::contact, weight);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const PairSide at = pair_of_end(m, b, element, l);
    if (at.pair < 0) continue;
    const Pair& pair = m.pair[at.pair];
    const EndResultant& w = weight[l];
    const double ux = motion[0] * w.w - motion[2] * (w.wy - cy * w.w), uy = motion[1] * w.w + motion[2] * (w.wx - cx * w.w);
    for (int32_t d = 0; d <= pair.tangential; ++d)
      out[dof_on(m, pair, at.side) + d] += static_cast<Real>(ux * along(pair, d, 0) + uy * along(pair, d, 1));
  }
}

// G: work of the pairs' tractions on one free motion, exactly that of their shape functions; on side 0 of a free zone, where
// pairs are points, that of their weights.
void find_work(const Model& m, int b, const double motion[3], const Real* r, Real* out) {
  for (int32_t i = 0; i < m.body[b].contact; ++i) out[i] = 0;
  for (int32_t element = 0; element < end_of_elements(m, b); ++element) {
    ZonePlace place;
    if (find_contact_element(m, b, element, &place) && is_integrated(m, b, element))
      add_element_work(m, b, element, motion, out);
  }
  for_pairs_of(m, b, [&](const Pair& pair, int side) {
    const int32_t own = dof_on(m, pair, side);
    for (int32_t d = 0; d <= pair.tangential && pair.node[side] < 0; ++d)
      out[own + d] = static_cast<Real>(pair.weight * static_cast<double>(r[own + d]));
  });
}

// g: work of a load case's force and moment on the free motions, which name its components.
void load_work(const Model& m, int b, int32_t load_case, Real g[kMostMotions]) {
  const Body& body = m.body[b];
  const double* load = m.rigid_motion[b][load_case].load;
  const double length = m.head->length_unit, unit = length * m.head->stress_unit;
  for (int32_t j = 0; j < kMostMotions; ++j) g[j] = 0;
  for (int32_t j = 0; j < body.free_motions; ++j) {
    const double* motion = body.free_motion[j];
    g[j] = static_cast<Real>((load[0] * motion[0] + load[1] * motion[1] + load[2] / length * motion[2]) / unit);
  }
}

} // namespace

c2d_status reduce_rigid(const Reduction& r, int b) {
  const Model& m = r.model;
  const int32_t count = m.body[b].free_motions;
  Real *column = r.strip, *work = r.strip + m.body[b].contact;
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < count && status == C2D_OK; ++j) {
    move_freely(m, b, m.body[b].free_motion[j], column);
    find_work(m, b, m.body[b].free_motion[j], column, work);
    status = write_column(r.tape, b, BodyMatrix::motions, j, column);
    if (status == C2D_OK) status = write_column(r.tape, b, BodyMatrix::resultants, j, work);
  }
  for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) {
    Real g[kMostMotions];
    load_work(m, b, k, g);
    if (count > 0) status = write_column(r.tape, b, BodyMatrix::given, k, g);
    for_pairs_of(m, b, [&](const Pair& pair, int side) {
      double v[2];
      rigid_motion_at_pair(m, pair, side, k, v);
      for (int32_t d = 0; d <= pair.tangential; ++d) column[dof_on(m, pair, side) + d] = static_cast<Real>(v[d]);
    });
    if (status == C2D_OK) status = write_column(r.tape, b, BodyMatrix::response, k, column);
  }
  return status;
}

} // namespace c2d
