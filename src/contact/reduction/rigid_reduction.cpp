// What the reduction needs of a rigid body: optional (memory/parts.hpp).
#include "bie/measure.hpp"
#include "bie/transfer.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/reduction/reduction.hpp"
#include "contact/start.hpp"
#include "memory/hostile.hpp"
#include "memory/parts.hpp"
#include "model/pair_frame.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

void rigid_motion_at_pair(const Model& m, const Pair& pair, int side, int32_t load_case, double v[2]) {
  double x, y, u[2];
  pair_position(m, pair, side, &x, &y);
  rigid_displacement(m, body_on(m, pair, side), load_case, x, y, u);
  to_frame(pair, u[0] / m.head->length_unit, u[1] / m.head->length_unit, v); // a power of two: the same digits
}

namespace {

// The work of a pair's tractions, component by component, to its unknowns of the body.
void add_work(const Model& m, PairSide at, double ux, double uy, Real* out) {
  const Pair& pair = m.pair[at.pair];
  for (int32_t d = 0; d <= pair.tangential; ++d)
    out[dof_on(m, pair, at.side) + d] += static_cast<Real>(ux * along(pair, d, 0) + uy * along(pair, d, 1));
}

// Displacements under a motion, weighted with a shape function whose integral and first moments about `centre` these are.
struct Weighted {
  double ux, uy;
};
Weighted weighted(const double motion[3], double w, double wx, double wy) {
  return {motion[0] * w - motion[2] * wy, motion[1] * w + motion[2] * wx};
}

// What the tractions of an element's ends do to a motion.
void add_element_work(const Model& m, int b, int32_t element, const double motion[3], Real* out) {
  const double unit = m.head->length_unit, cx = m.body[b].centre[0] / unit, cy = m.body[b].centre[1] / unit;
  EndResultant weight[kElementNodes];
  end_resultants(m, b, element, Measure::contact, weight);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const PairSide at = pair_of_end(m, b, element, l);
    if (at.pair < 0) continue;
    const EndResultant& w = weight[l];
    const Weighted u = weighted(motion, w.w, w.wx - cx * w.w, w.wy - cy * w.w);
    add_work(m, at, u.ux, u.uy, out);
  }
}

// What a piece of side 0 of a free zone does. (Not inlined: it must not stand below the search for the next.)
[[gnu::noinline]] void add_piece_work(const Model& m, const TransferWalk& walk, const double motion[3], Real* out) {
  Transfer piece;
  kFreeZonePart.make_transfer(m, Quadrature::accurate, walk, piece);
  const double* centre = m.body[walk.body].centre;
  double w[kElementNodes], wx[kElementNodes], wy[kElementNodes];
  resultants(piece.in, centre[0] / m.head->length_unit, centre[1] / m.head->length_unit, w, wx, wy);
  for (int k = 0; k < piece.in.functions; ++k) {
    const Weighted u = weighted(motion, w[k], wx[k], wy[k]);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      if (C2D_NEVER(piece.pair[l] < 0)) continue; // all nodes of side 1 are pairs
      add_work(m, {piece.pair[l], 0}, piece.weight[k][l] * u.ux, piece.weight[k][l] * u.uy, out);
    }
  }
}

// G: work of the pairs' tractions on one free motion, exactly that of their shape functions.
void find_work(const Model& m, int b, const double motion[3], Real* out) {
  for (int32_t i = 0; i < m.body[b].contact; ++i) out[i] = 0;
  for (int32_t element = 0; element < end_of_elements(m, b); ++element) {
    ZonePlace place;
    if (find_contact_element(m, b, element, &place)) add_element_work(m, b, element, motion, out);
  }
  TransferWalk walk{};
  walk.body = b;
  while (kFreeZonePart.next_transfer(m, walk)) add_piece_work(m, walk, motion, out);
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
    motion_column(m, b, j, column); // R
    find_work(m, b, m.body[b].free_motion[j], work);
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
