// Discretisation error indicators of boundary elements (METHOD 16.6).
//
// The boundary integral equation and the contact conditions are satisfied at nodes only. Their residuals between the nodes tell
// where the mesh is too coarse. Residual-based indicators for boundary elements in general: Carstensen and Stephan, Math.
// Comput. 64 (1995).
//
// Phases for a group of elements:
//   1. Sample points eta = -1, -1/2, 0, 1/2, 1 on each element, and the points of the other side that face them.
//   2. Residual of the integral equation: the displacement of METHOD (16.8), u + 2 (u_in - u), with u_in evaluated just inside
//      the body, minus the interpolated u. At element ends it is zero by collocation.
//   3. Relative motion of the two sides including these residuals; from it, with the surfaces, the gap r_n where the contact is
//      closed and the tangential drift r_t where it sticks.
//   4. Energies of the residuals, METHOD (16.9): E*/(4 pi) L int (r')^2 ds, the elastic energy of the pressure that would
//      remove a residual of wave number pi/L from a half plane.
#include "results/warnings/indicator.hpp"

#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "model/geometry.hpp"
#include "model/pair_frame.hpp"
#include "results/back.hpp"
#include "results/interior/interior.hpp"
#include "results/rigid.hpp"

namespace c2d {

C2D_USES(CurvePart);
C2D_USES(FreeZonePart);
C2D_USES(RigidPart);

namespace {

// Sample points of an element. At the ends the boundary equation is satisfied (collocation), so only three points cost an
// integration.
constexpr int kSamples = 5;
constexpr double kEta[kSamples] = {-1.0, -0.5, 0.0, 0.5, 1.0};
constexpr int32_t kElementsAtOnce = kSmallCode ? 1 : 8; // integrating over a boundary once for several elements is faster

struct Sampled {
  int32_t element, zone, side; // zone -1: in no contact zone
  FacePoint faced[kSamples];   // facing point on the other side; place -1: none
  double off[kSamples][2];     // residual displacement of the integral equation
  double w[kSamples][2];       // u of side 1 minus u of side 0, with the residuals of both
};

// The point of side 1 - side that faces one of `side`.
bool find_facing(const Model& m, const Zone& z, int side, const FacePoint& at, FacePoint& out) {
  if (z.is_free != 0) return side == 0 ? kFreeZonePart.facing_point(m, z, at, out) : kFreeZonePart.face_point(m, z, at, out);
  out = at;
  if (is_platen(m, z.body[1 - side])) return true; // a platen has no mesh: it coincides with the elements it moves
  out.element = zone_element(m, z, 1 - side, at.place);
  out.eta *= z.element_step[0] * z.element_step[1];
  return true;
}

// Not inlined, to limit the stack: the search for facing points needs many frames.
[[gnu::noinline]] void find_contact(const Model& m, int b, int32_t element, Sampled& out) {
  ZonePlace place;
  out = Sampled{};
  out.element = element;
  out.zone = -1;
  if (!find_contact_element(m, b, element, &place)) return;
  out.zone = place.zone;
  out.side = place.side;
  for (int i = 0; i < kSamples; ++i)
    if (!find_facing(m, m.zone[place.zone], place.side, FacePoint{element, place.place, kEta[i]}, out.faced[i]))
      out.faced[i].place = -1;
}

// ---- displacements ----

// out += factor * u at a boundary point, interpolated or from the rigid-body motion.
void add_displacement_at(const Session& session, int b, const FacePoint& at, double factor, double out[2]) {
  double u[2];
  if (is_rigid(session.model, b)) {
    const CurvePoint p = curve_point(session.model, b, at.element, at.eta);
    kRigidPart.rigid_displacement_now(session, b, p.x, p.y, u);
  } else {
    interpolated_displacement(session, b, BoundaryPlace{at.element, at.eta}, u);
  }
  for (int c = 0; c < 2; ++c) out[c] += factor * u[c];
}

// Collects places and evaluates the residual of the integral equation for several at once, which reads the boundary data once
// for all of them; `finish` evaluates the rest.
struct Equation {
  const Session& session;
  int b;
  int32_t count;
  BoundaryPlace at[kPlacesAtOnce];
  double* to[kPlacesAtOnce];
  double factor;

  c2d_status finish() {
    double off[2 * kPlacesAtOnce];
    if (count == 0) return C2D_OK;
    const c2d_status status = off_interpolation(session, b, count, at, off);
    for (int32_t i = 0; i < count && status == C2D_OK; ++i)
      for (int c = 0; c < 2; ++c) to[i][c] += factor * off[2 * i + c];
    count = 0;
    return status;
  }
  c2d_status add(const FacePoint& point, double* sum) {
    if (is_rigid(session.model, b) || fabs(point.eta) == 1.0) return C2D_OK; // no equations, or satisfied by collocation
    at[count] = BoundaryPlace{point.element, point.eta};
    to[count++] = sum;
    return count < kPlacesAtOnce ? c2d_status{C2D_OK} : finish();
  }
};

[[gnu::noinline]] c2d_status sample_own(const Session& session, int b, Sampled* sampled, int32_t count) {
  Equation equation{session, b, 0, {}, {}, 1.0};
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < count; ++k)
    for (int i = 0; i < kSamples && status == C2D_OK; ++i)
      if (is_integrated(session.model, b, sampled[k].element))
        status = equation.add(FacePoint{sampled[k].element, 0, kEta[i]}, sampled[k].off[i]);
  return status == C2D_OK ? equation.finish() : status;
}

// Residuals of body `of` at the points that face the samples. The minus sign: w is the difference of the two sides.
[[gnu::noinline]] c2d_status sample_faced(const Session& session, int of, Sampled* sampled, int32_t count) {
  Equation equation{session, of, 0, {}, {}, -1.0};
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < count; ++k) {
    Sampled& s = sampled[k];
    if (s.zone < 0 || session.model.zone[s.zone].body[1 - s.side] != of) continue;
    for (int i = 0; i < kSamples && status == C2D_OK; ++i)
      if (s.faced[i].place >= 0) status = equation.add(s.faced[i], s.w[i]);
  }
  return status == C2D_OK ? equation.finish() : status;
}

// Adds the interpolated displacements to the residuals and orients the difference from side 0 to side 1.
[[gnu::noinline]] void complete_motion(const Session& session, int b, Sampled& s) {
  for (int i = 0; i < kSamples; ++i) {
    for (int c = 0; c < 2; ++c) s.w[i][c] += s.off[i][c];
    add_displacement_at(session, b, FacePoint{s.element, 0, kEta[i]}, 1.0, s.w[i]);
    if (s.faced[i].place >= 0)
      add_displacement_at(session, session.model.zone[s.zone].body[1 - s.side], s.faced[i], -1.0, s.w[i]);
    for (double& w : s.w[i]) w = signed_on(s.side, w);
  }
}

// ---- contact conditions ----

enum StatusBit { kOpenBit = 1, kStickBit = 2, kSlipBit = 4, kTiedBit = 8 };

// State of the pairs of an element of side 1 at a sample point, interpolated with the shape functions.
struct PairsThere {
  int32_t statuses;                // bits of all pairs of the element
  double n[2], p, spare, wt, slip; // spare: what friction lacks of its bound; slip: |w_t| since slip began
};

void add_pair(const Session& session, int32_t i, double part, PairsThere& out) {
  const Pair& pair = session.model.pair[i];
  const double length = session.model.head->length_unit, stress = session.model.head->stress_unit;
  const PairState now = pair_state(*session.follower.t, i, session.follower.y);
  const bool tied = is_tied(session.model, pair);
  out.statuses |= tied ? kTiedBit : pair.status == C2D_OPEN ? kOpenBit : 0;
  if (!tied && pair.status != C2D_OPEN) {
    if (pair.law.is_smooth())
      out.statuses |= kSlipBit;
    else if (pair.tangential != 0) // on an axis of symmetry a pair neither sticks nor slips: its neighbours decide
      out.statuses |= pair.status == C2D_STICK ? kStickBit : kSlipBit;
  }
  out.n[0] += part * pair.nx;
  out.n[1] += part * pair.ny;
  out.p += part * now.p * stress;
  out.wt += part * now.wt * length;
  if (pair.law.has_bound()) out.spare += part * pair.law.margin(now.p, now.q) * stress;
  if (pair.status == C2D_SLIP && pair.tangential != 0) out.slip += part * fabs(now.wt - pair.slip_from) * length;
}

[[gnu::noinline]] PairsThere pairs_there(const Session& session, const Zone& z, const FacePoint& at) {
  const Model& m = session.model;
  PairsThere out{};
  double value[kElementNodes];
  shape(m.head->function_nodes, at.eta, value);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    if (value[l] == 0.0) continue; // at a node only its own pair counts
    const PairSide end = pair_of_end(m, z.body[1], at.element, l);
    if (end.pair >= 0)
      add_pair(session, end.pair, value[l], out);
    else
      out.statuses |= kOpenBit; // an element end without a pair carries no traction
  }
  const double size = hypot(out.n[0], out.n[1]);
  for (double& n : out.n) n = size > 0.0 ? n / size : 0.0;
  return out;
}

// Gap of the undeformed surfaces at a sample: initial gap, minus the part of an initial overlap that interference has removed,
// plus the change due to slip along curved surfaces (METHOD 8.7).
[[gnu::noinline]] double gap_without_motion(const Session& session, const Zone& z, const FacePoint at[2], const double n[2],
                                            double wt) {
  const Model& m = session.model;
  const SurfacePoint p = surface_point(m, z.body[0], at[0].element, at[0].eta);
  const SurfacePoint q = surface_point(m, z.body[1], at[1].element, at[1].eta);
  const double gap = (q.x - p.x) * n[0] + (q.y - p.y) * n[1];
  const double closed = m.head->interference != 0 ? session.follower.load[m.head->interference - 1] : 0.0;
  const double left = gap >= 0.0 ? gap : gap * closed;
  const Tableau& t = session.tableau;
  if (!follows_slip(t) || t.slip[z.first_pair].follows == 0) return left;
  return left + kCurvePart.slip_gap(m, z, at, n, wt, t.slip[z.first_pair].even);
}

// Residuals of the contact conditions of an element. In the integrals p*gap and spare*slip both factors cannot be
// non-zero in the exact solution (complementarity); on an element that is partly closed they measure the error.
struct Residuals {
  int32_t statuses;
  double normal[kSamples], tangential[kSamples];
  double gap, drift; // largest magnitudes
  double both;       // sum of p*gap on partly open elements and of spare*slip on partly sticking ones
};

// Where all pairs are closed any gap is an error; where some are open only penetration is.
void look_at_gap(const PairsThere& now, double gap, double& residual, Residuals& out) {
  const bool open = (now.statuses & kOpenBit) != 0, closed = (now.statuses & (kStickBit | kSlipBit)) != 0 || !open;
  residual = open && gap > 0.0 ? 0.0 : gap;
  out.gap = fmax(out.gap, fabs(residual));
  if (open && closed) out.both += fmax(now.p, 0.0) * fmax(gap, 0.0);
}

// Where all pairs stick the tangential displacement between nodes must follow the nodal values; where slip occurs it is free.
void look_at_drift(const PairsThere& now, double drift, double& residual, Residuals& out) {
  residual = 0.0;
  if ((now.statuses & (kOpenBit | kStickBit)) != kStickBit) return;
  if ((now.statuses & kSlipBit) != 0) {
    out.both += fmax(now.spare, 0.0) * fmax(now.slip, 0.0);
    return;
  }
  residual = drift;
  out.drift = fmax(out.drift, fabs(drift));
}

void look_at_sample(const Session& session, const Sampled& s, int i, Residuals& out) {
  const Zone& z = session.model.zone[s.zone];
  out.normal[i] = out.tangential[i] = 0.0;
  if (s.faced[i].place < 0) {
    out.statuses |= kOpenBit;
    return;
  }
  FacePoint at[2];
  at[s.side] = FacePoint{s.element, 0, kEta[i]};
  at[1 - s.side] = s.faced[i];
  const PairsThere now = pairs_there(session, z, at[1]);
  out.statuses |= now.statuses;
  const double wn = s.w[i][0] * now.n[0] + s.w[i][1] * now.n[1], wt = s.w[i][0] * now.n[1] - s.w[i][1] * now.n[0];
  if (z.is_tied != 0) { // a tie allows no relative motion at all
    out.normal[i] = wn;
    out.tangential[i] = wt;
    out.gap = fmax(out.gap, fabs(wn));
    out.drift = fmax(out.drift, fabs(wt));
    return;
  }
  look_at_gap(now, gap_without_motion(session, z, at, now.n, now.wt) + wn, out.normal[i], out);
  look_at_drift(now, wt - now.wt, out.tangential[i], out);
}

// Sum of squares of the steps between samples: h times int (r')^2 ds for a residual that is linear between them. Constant
// elements have their node in the middle; the values at their ends are extrapolated from the inner samples.
double sum_of_squares(const Model& m, const double* r, int64_t stride) {
  double at[kSamples], sum = 0.0;
  for (int i = 0; i < kSamples; ++i) at[i] = r[i * stride];
  if (m.head->function_nodes == 1) {
    at[0] = 2.0 * at[1] - at[2];
    at[4] = 2.0 * at[3] - at[2];
  }
  for (int i = 1; i < kSamples; ++i) sum += (at[i] - at[i - 1]) * (at[i] - at[i - 1]);
  return sum;
}

// 1/E' of a half plane: (1 - nu^2)/E = (1 - nu)/(2G) (Johnson, Contact Mechanics, chapter 2).
double compliance(const Model& m, int b) {
  return is_rigid(m, b) ? 0.0 : (1.0 - strain_poisson_ratio(m, b)) / (2.0 * shear_modulus(m, b));
}

// Fills the columns of one element from its samples. With four intervals of length L/4 the factor L E*/(4 pi) of METHOD (16.9)
// becomes E*/pi for the sum of squared steps.
[[gnu::noinline]] void fill_row(const Session& session, int b, const Sampled& s, double* out) {
  const Model& m = session.model;
  for (const double* off : s.off) out[C2D_OFF_EQUATION] = fmax(out[C2D_OFF_EQUATION], hypot(off[0], off[1]));
  if (!is_rigid(m, b))
    out[C2D_OFF_EQUATION_ENERGY] =
        (sum_of_squares(m, s.off[0], 2) + sum_of_squares(m, s.off[0] + 1, 2)) / (kPi * compliance(m, b));
  if (s.zone < 0) return;
  Residuals r{};
  const int skipped = m.head->function_nodes == 1 ? 1 : 0;
  for (int i = skipped; i < kSamples - skipped; ++i) look_at_sample(session, s, i, r);
  out[C2D_OFF_STATUSES] = r.statuses;
  out[C2D_OFF_GAP] = r.gap;
  out[C2D_OFF_DRIFT] = r.drift;
  const Zone& z = m.zone[s.zone];
  out[C2D_OFF_CONTACT_ENERGY] = (sum_of_squares(m, r.normal, 1) + sum_of_squares(m, r.tangential, 1)) /
                                    (kPi * (compliance(m, z.body[0]) + compliance(m, z.body[1]))) +
                                out[C2D_OFF_LENGTH] / (kSamples - 1) * r.both;
}

// Columns that do not depend on the solution.
void begin_row(const Model& m, int b, int32_t element, double* row) {
  for (int c = 0; c < C2D_OFF_FIELDS; ++c) row[c] = 0.0;
  ZonePlace at;
  row[C2D_OFF_LENGTH] = element_length(m, b, element);
  if (!find_contact_element(m, b, element, &at)) return;
  row[C2D_OFF_ZONE] = at.zone + 1;
  row[C2D_OFF_SIDE] = at.side + 1;
  row[C2D_OFF_STATUSES] = m.zone[at.zone].is_tied != 0 ? kTiedBit : kOpenBit;
}

[[gnu::noinline]] c2d_status fill_some(const Session& session, int b, int32_t first, int32_t count, double* out,
                                       int64_t stride) {
  Sampled sampled[kElementsAtOnce];
  for (int32_t k = 0; k < count; ++k) find_contact(session.model, b, first + k, sampled[k]);
  c2d_status status = sample_own(session, b, sampled, count);
  for (int of = 0; of < session.model.head->bodies && status == C2D_OK; ++of)
    status = sample_faced(session, of, sampled, count);
  for (int32_t k = 0; k < count && status == C2D_OK; ++k) {
    if (sampled[k].zone >= 0) complete_motion(session, b, sampled[k]);
    fill_row(session, b, sampled[k], out + k * stride);
  }
  return status;
}

} // namespace

c2d_status fill_indicators(Session& session, int b, int32_t first, int32_t count, double* out, int64_t stride) {
  c2d_solver* s = session.solver;
  c2d_status status = back_substitute_all(session);
  if (status != C2D_OK) return fail_store(s, status);
  for (int32_t i = 0; i < count; ++i) begin_row(session.model, b, first + i, out + i * stride);
  if (s->blocked || s->floating) return C2D_OK;
  refresh(session.follower);
  for (int32_t i = 0; i < count && status == C2D_OK; i += kElementsAtOnce) {
    const int32_t rest = count - i;
    status = fill_some(session, b, first + i, rest < kElementsAtOnce ? rest : kElementsAtOnce, out + i * stride, stride);
  }
  return status;
}

} // namespace c2d
