#include "results/indicator.hpp"

#include <math.h>

#include "bie/kernels.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "model/geometry.hpp"
#include "model/pair_frame.hpp"
#include "results/back.hpp"
#include "results/interior.hpp"
#include "results/rigid.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(RigidPart);

namespace {

// An element's ends and the points between; at its ends the boundary equation holds.
constexpr int kSamples = 5, kBetween = 3;
constexpr double kEta[kSamples] = {-1.0, -0.5, 0.0, 0.5, 1.0};
constexpr int32_t kElementsAtOnce = kPlacesAtOnce / kSamples;

// A sample and what it faces, side by side: own element on `side`.
struct Contact {
  FacePoint at[2];
  bool faces;
};
struct Sampled {
  int32_t element, zone, side; // zone -1: none
  Contact contact[kSamples];
  double own[kSamples][2], other[kSamples][2]; // displacements as interpolated, and what the equations add to them
  double own_off[kSamples][2], other_off[kSamples][2];
};

// The point of side 1 - side that faces one of `side`.
bool find_facing(const Model& m, const Zone& z, int side, const FacePoint& at, FacePoint& out) {
  if (z.is_free != 0) return side == 0 ? kFreeZonePart.facing_point(m, z, at, out) : kFreeZonePart.face_point(m, z, at, out);
  if (is_platen(m, z.body[1 - side])) {
    out = at;
    return true;
  }
  out = FacePoint{zone_element(m, z, 1 - side, at.place), at.place, z.element_step[0] * z.element_step[1] * at.eta};
  return true;
}

void find_contact(const Model& m, int b, int32_t element, Sampled& out) {
  ZonePlace place;
  out.element = element;
  out.zone = -1;
  if (!find_contact_element(m, b, element, &place)) return;
  const Zone& z = m.zone[place.zone];
  out.zone = place.zone;
  out.side = place.side;
  for (int i = 0; i < kSamples; ++i) {
    Contact& c = out.contact[i];
    c.at[place.side] = FacePoint{element, place.place, kEta[i]};
    c.faces = find_facing(m, z, place.side, c.at[place.side], c.at[1 - place.side]);
  }
}

// ---- displacements ----

void displacement_at(const Session& session, int b, const FacePoint& at, double u[2]) {
  if (!is_rigid(session.model, b)) return interpolated_displacement(session, b, BoundaryPlace{at.element, at.eta}, u);
  const CurvePoint p = curve_point(session.model, b, at.element, at.eta);
  kRigidPart.rigid_displacement_now(session, b, p.x, p.y, u);
}

// Ends of elements need no equation.
bool is_between(double eta) { return fabs(eta) < 1.0; }

// A constant function's node is in the middle: there what lies at the ends is what the points between make likely.
void complete_ends(const Model& m, double off[kSamples][2]) {
  for (int c = 0; c < 2 && m.head->function_nodes == 1; ++c) {
    off[0][c] = 2.0 * off[1][c] - off[2][c];
    off[4][c] = 2.0 * off[3][c] - off[2][c];
  }
}

// Points of one body, and where what its equation adds to the displacement there belongs.
struct Asked {
  int32_t count;
  BoundaryPlace at[kPlacesAtOnce];
  double* to[kPlacesAtOnce];

  void add(const FacePoint& point, double* off) {
    off[0] = off[1] = 0.0;
    if (!is_between(point.eta)) return;
    at[count] = BoundaryPlace{point.element, point.eta};
    to[count++] = off;
  }
};

c2d_status ask(const Session& session, int b, const Asked& asked) {
  double off[2 * kPlacesAtOnce];
  if (asked.count == 0) return C2D_OK;
  const c2d_status status = off_interpolation(session, b, asked.count, asked.at, off);
  for (int32_t i = 0; i < asked.count && status == C2D_OK; ++i)
    for (int c = 0; c < 2; ++c) asked.to[i][c] = off[2 * i + c];
  return status;
}

c2d_status sample_own(const Session& session, int b, Sampled* sampled, int32_t count) {
  Asked asked;
  asked.count = 0;
  for (int32_t k = 0; k < count; ++k)
    for (int i = 0; i < kSamples; ++i) {
      Sampled& s = sampled[k];
      const FacePoint at{s.element, 0, kEta[i]};
      displacement_at(session, b, at, s.own[i]);
      s.own_off[i][0] = s.own_off[i][1] = 0.0;
      if (!is_rigid(session.model, b) && is_integrated(session.model, b, s.element)) asked.add(at, s.own_off[i]);
    }
  const c2d_status status = ask(session, b, asked);
  for (int32_t k = 0; k < count; ++k) complete_ends(session.model, sampled[k].own_off);
  return status;
}

// Of those that face body `of`.
c2d_status sample_other(const Session& session, int of, Sampled* sampled, int32_t count) {
  const Model& m = session.model;
  Asked asked;
  asked.count = 0;
  for (int32_t k = 0; k < count; ++k) {
    Sampled& s = sampled[k];
    if (s.zone < 0 || m.zone[s.zone].body[1 - s.side] != of) continue;
    for (int i = 0; i < kSamples; ++i) {
      s.other_off[i][0] = s.other_off[i][1] = 0.0;
      if (!s.contact[i].faces) continue;
      const FacePoint& at = s.contact[i].at[1 - s.side];
      displacement_at(session, of, at, s.other[i]);
      if (!is_rigid(m, of)) asked.add(at, s.other_off[i]);
    }
  }
  const c2d_status status = ask(session, of, asked);
  for (int32_t k = 0; k < count; ++k) {
    const Sampled& s = sampled[k];
    if (s.zone >= 0 && m.zone[s.zone].body[1 - s.side] == of && m.zone[s.zone].is_free == 0)
      complete_ends(m, sampled[k].other_off);
  }
  return status;
}

// ---- contact conditions ----

enum StatusBit { kOpenBit = 1, kStickBit = 2, kSlipBit = 4, kTiedBit = 8 };

// The pairs of the element of side 1 at a sample, interpolated.
struct PairsThere {
  int32_t statuses; // bits
  double n[2], p, spare, wt, slip; // spare: what is left to the bound of friction; slip: since it began
};

void add_pair(const Session& session, int32_t i, double part, PairsThere& out) {
  const Pair& pair = session.model.pair[i];
  const double length = session.model.head->length_unit, stress = session.model.head->stress_unit;
  const PairState now = pair_state(*session.follower.t, i, session.follower.y);
  const bool tied = is_tied(session.model, pair);
  out.statuses |= tied ? kTiedBit : pair.status == C2D_OPEN ? kOpenBit : 0;
  if (!tied && pair.status != C2D_OPEN) {
    if (pair.mu == 0.0)
      out.statuses |= kSlipBit;
    else if (pair.tangential != 0) // one that symmetry holds is what its neighbours are
      out.statuses |= pair.status == C2D_STICK ? kStickBit : kSlipBit;
  }
  out.n[0] += part * pair.nx;
  out.n[1] += part * pair.ny;
  out.p += part * now.p * stress;
  out.wt += part * now.wt * length;
  if (pair.mu < 1e300) out.spare += part * (pair.mu * now.p - fabs(now.q)) * stress;
  if (pair.status == C2D_SLIP && pair.tangential != 0) out.slip += part * fabs(now.wt - pair.slip_from) * length;
}

PairsThere pairs_there(const Session& session, const Zone& z, const FacePoint& at) {
  const Model& m = session.model;
  PairsThere out{};
  double value[kElementNodes];
  shape(m.head->function_nodes, at.eta, value);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    const PairSide end = pair_of_end(m, z.body[1], at.element, l);
    if (end.pair >= 0)
      add_pair(session, end.pair, value[l], out);
    else
      out.statuses |= kOpenBit; // ends beside the pairs carry nothing
  }
  const double size = hypot(out.n[0], out.n[1]);
  for (double& n : out.n) n = size > 0.0 ? n / size : 0.0;
  return out;
}

// Between the surfaces before any load, less what interference has closed of it.
double initial_gap(const Session& session, const Zone& z, const Contact& c, const double n[2]) {
  const Model& m = session.model;
  const SurfacePoint p = surface_point(m, z.body[0], c.at[0].element, c.at[0].eta);
  const SurfacePoint q = surface_point(m, z.body[1], c.at[1].element, c.at[1].eta);
  const double gap = (q.x - p.x) * n[0] + (q.y - p.y) * n[1];
  if (gap >= 0.0) return gap;
  return m.head->interference != 0 ? gap * session.follower.load[m.head->interference - 1] : 0.0;
}

// What an element has so far: residuals at its samples, and the work of what should be zero.
struct Residuals {
  int32_t statuses;
  double normal[kSamples], tangential[kSamples];
  double gap, drift; // the largest
  double both;       // sum of pressure times gap, and of spare friction times slip, where it is half open and half stuck
};

void look_at_gap(const PairsThere& now, double gap, double& residual, Residuals& out) {
  const bool open = (now.statuses & kOpenBit) != 0, closed = (now.statuses & (kStickBit | kSlipBit)) != 0 || !open;
  residual = open && gap > 0.0 ? 0.0 : gap;
  out.gap = fmax(out.gap, fabs(residual));
  if (open && closed) out.both += fmax(now.p, 0.0) * fmax(gap, 0.0);
}

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
  if (!s.contact[i].faces) {
    out.statuses |= kOpenBit;
    return;
  }
  const PairsThere now = pairs_there(session, z, s.contact[i].at[1]);
  out.statuses |= now.statuses;
  double w[2];
  for (int c = 0; c < 2; ++c)
    w[c] = signed_on(s.side, s.own[i][c] + s.own_off[i][c] - s.other[i][c] - s.other_off[i][c]);
  const double wn = w[0] * now.n[0] + w[1] * now.n[1], wt = w[0] * now.n[1] - w[1] * now.n[0];
  if (z.is_tied != 0) {
    out.normal[i] = wn;
    out.tangential[i] = wt;
    out.gap = fmax(out.gap, fabs(wn));
    out.drift = fmax(out.drift, fabs(wt));
    return;
  }
  look_at_gap(now, initial_gap(session, z, s.contact[i], now.n) + wn, out.normal[i], out);
  look_at_drift(now, wt - now.wt, out.tangential[i], out);
}

double sum_of_squares(const double r[kSamples]) {
  double sum = 0.0;
  for (int i = 1; i < kSamples; ++i) sum += (r[i] - r[i - 1]) * (r[i] - r[i - 1]);
  return sum;
}

double compliance(const Model& m, int b) {
  return is_rigid(m, b) ? 0.0 : (1.0 - strain_poisson_ratio(m, b)) / (2.0 * shear_modulus(m, b));
}

void fill_row(const Session& session, int b, const Sampled& s, double* out) {
  const Model& m = session.model;
  const double length = element_length(m, b, s.element);
  out[C2D_OFF_LENGTH] = length;
  double parts[2][kSamples], largest = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    for (int c = 0; c < 2; ++c) parts[c][i] = s.own_off[i][c];
    largest = fmax(largest, hypot(s.own_off[i][0], s.own_off[i][1]));
  }
  out[C2D_OFF_EQUATION] = largest;
  if (!is_rigid(m, b))
    out[C2D_OFF_EQUATION_ENERGY] = (sum_of_squares(parts[0]) + sum_of_squares(parts[1])) / (kPi * compliance(m, b));
  if (s.zone < 0) return;
  Residuals r{};
  for (int i = 0; i < kSamples; ++i) look_at_sample(session, s, i, r);
  out[C2D_OFF_STATUSES] = r.statuses;
  out[C2D_OFF_GAP] = r.gap;
  out[C2D_OFF_DRIFT] = r.drift;
  const Zone& z = m.zone[s.zone];
  out[C2D_OFF_CONTACT_ENERGY] = (sum_of_squares(r.normal) + sum_of_squares(r.tangential)) /
                                    (kPi * (compliance(m, z.body[0]) + compliance(m, z.body[1]))) +
                                length / (kSamples - 1) * r.both;
}

// What is known of an element before anything is solved.
void begin_row(const Model& m, int b, int32_t element, double* row) {
  for (int c = 0; c < C2D_OFF_FIELDS; ++c) row[c] = 0.0;
  ZonePlace at;
  row[C2D_OFF_LENGTH] = element_length(m, b, element);
  if (!find_contact_element(m, b, element, &at)) return;
  row[C2D_OFF_ZONE] = at.zone + 1;
  row[C2D_OFF_SIDE] = at.side + 1;
  row[C2D_OFF_STATUSES] = m.zone[at.zone].is_tied != 0 ? kTiedBit : kOpenBit;
}

c2d_status fill_some(const Session& session, int b, int32_t first, int32_t count, double* out, int64_t stride) {
  Sampled sampled[kElementsAtOnce];
  for (int32_t k = 0; k < count; ++k) find_contact(session.model, b, first + k, sampled[k]);
  c2d_status status = sample_own(session, b, sampled, count);
  for (int of = 0; of < session.model.head->bodies && status == C2D_OK; ++of)
    status = sample_other(session, of, sampled, count);
  for (int32_t k = 0; k < count && status == C2D_OK; ++k) fill_row(session, b, sampled[k], out + k * stride);
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
