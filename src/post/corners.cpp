#include "post/corners.hpp"

#include "post/corner_fit.hpp"

#include <algorithm>

namespace app {
namespace {

// Results used: from three elements at the corner up to 0.3 of the face, of the stretch of pairs in one
// state, or of the distance to the next corner.
const double kNearest = 3, kFarthest = 0.3;
const size_t kFewest = 6;
const double kWorst = 0.1; // with a larger relative misfit or error no K is given
// Relative errors of K that are equal on graded meshes of all sizes and so cannot be detected: measured with sizes halved one
// after another.
const double kUnseen = 0.004, kUnseenLinear = 0.04;
const double kTerms = 2.6; // exponents up to here are terms of a fit

const char* const kTooFew = "too few nodes near it";
const char* const kNotAlike = "results near it do not follow its exponents";

CornerState state_of(const Corner& c) {
  CornerState out;
  out.kind = c.kind;
  out.zone = c.zone;
  for (int i = 0; i < 2; ++i) out.body[i] = c.body[i], out.at[i] = c.at[i];
  return out;
}

bool same(const Face& a, const Face& b) {
  return a.kind == b.kind && std::fabs(a.friction - b.friction) <= 1e-6 * (std::fabs(a.friction) + std::fabs(b.friction));
}

const std::vector<Complex>& exponents_with(const Corner& c, const Face& joint) {
  for (const Corner::Known& known : c.known)
    if (same(known.joint, joint)) return known.exponents;
  CornerShape shape = c.shape;
  shape.faces[c.joint] = joint;
  c.known.push_back({joint, corner_exponents(shape, kTerms)});
  return c.known.back().exponents;
}

void take_singular(const std::vector<Complex>& all, CornerState& out) {
  for (const Complex& lambda : all)
    if (lambda.real() < kSingular) out.exponents.push_back(lambda);
}

bool is_good(const CornerFit& f) { return f.misfit < kWorst && f.K_error < kWorst * std::fabs(f.K); }

void fit(const std::vector<PressureSample>& samples, const std::vector<Complex>& exponents, bool linear, CornerState& out) {
  if (samples.size() < kFewest) {
    out.why = kTooFew;
    return;
  }
  const CornerFit fitted = fit_pressure(samples, exponents);
  if (!is_good(fitted)) {
    out.why = kNotAlike;
    return;
  }
  out.K = fitted.K;
  out.K_error = 2 * fitted.K_error + (linear ? kUnseenLinear : kUnseen) * std::fabs(fitted.K);
}

// ---- pairs

class Pairs {
public:
  Pairs(const Corner& corner, const double* table, int64_t stride) : corner_(corner), table_(table), stride_(stride) {}
  const double* row(size_t i) const { return table_ + corner_.samples[i].row * stride_; }
  int32_t status(size_t i) const { return static_cast<int32_t>(row(i)[C2D_STATUS]); }
  // Without the pair at the corner itself, whose status is the most uncertain.
  size_t first() const { return corner_.samples.size() > 2 ? 1 : 0; }
  size_t end_of_run() const {
    size_t end = first() + 1;
    while (end < corner_.samples.size() && status(end) == status(first()) && shear(end) * shear(first()) >= 0) ++end;
    return end;
  }
  // Sign of the friction on the body after the joint: away from the corner is positive.
  double shear(size_t i) const {
    const double* r = row(i);
    const double tx = r[C2D_NY], ty = -r[C2D_NX]; // n turned by -90 degrees
    const double along = (r[C2D_X] - corner_.at[0]) * tx + (r[C2D_Y] - corner_.at[1]) * ty;
    return status(i) == C2D_SLIP ? r[C2D_TT] * (along > 0 ? 1 : -1) * (corner_.after == 2 ? 1 : -1) : 0;
  }
  // Ratio of shear to normal stress in the stretch, with the sign of a Face.
  double friction() const {
    double sum = 0, pressure = 0;
    for (size_t i = first(), end = end_of_run(); i < end; ++i) sum += shear(i), pressure += row(i)[C2D_TN];
    return pressure > 0 ? sum / pressure : 0;
  }

private:
  const Corner& corner_;
  const double* table_;
  int64_t stride_;
};

// ---- element ends

struct Ends {
  std::vector<double> ux, uy, tx, ty;
};
c2d_status read_ends(c2d_solver* solver, const Summary& s, int32_t body, Ends& out) {
  const int32_t count = s.body[body - 1].elements * s.function_nodes;
  const struct {
    int32_t field;
    std::vector<double>& to;
  } list[] = {{C2D_END_UX, out.ux}, {C2D_END_UY, out.uy}, {C2D_END_TX, out.tx}, {C2D_END_TY, out.ty}};
  for (const auto& l : list) {
    l.to.resize(static_cast<size_t>(count));
    const c2d_status status = c2d_get(solver, l.field, body, 1, count, l.to.data(), 1);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

double reach(const Corner& c, bool first) {
  double farthest = 0;
  for (const Corner::Sample& s : c.samples)
    if (s.first == first) farthest = std::max(farthest, s.distance);
  return kFarthest * std::min(farthest, c.size);
}

CornerState support_state(const Corner& c, const Ends& ends) {
  CornerState out = state_of(c);
  out.joint = "held";
  const std::vector<Complex>& all = exponents_with(c, c.shape.faces[c.joint]);
  take_singular(all, out);
  if (c.shape.faces[1 - c.joint].kind != FaceKind::kFree) {
    out.why = "both faces are supported";
    return out;
  }
  const bool first = c.joint == 0;
  const double farthest = reach(c, first);
  std::vector<PressureSample> samples;
  for (const Corner::Sample& s : c.samples) {
    if (s.first != first || s.distance < kNearest * c.element || s.distance > farthest) continue;
    const size_t i = static_cast<size_t>(s.row);
    samples.push_back({s.distance, -(ends.tx[i] * s.normal[0] + ends.ty[i] * s.normal[1])});
  }
  fit(samples, all, c.linear, out);
  return out;
}

CornerState notch_state(const Corner& c, const Ends& ends) {
  CornerState out = state_of(c);
  out.joint = "free";
  const Sector& sector = c.shape.sectors[0];
  take_singular(notch_exponents(sector, true), out);
  take_singular(notch_exponents(sector, false), out);
  const double farthest = c.half ? std::max(reach(c, true), reach(c, false)) : std::min(reach(c, true), reach(c, false));
  const double bisector = c.direction + sector.angle / 2, cosine = std::cos(2 * bisector), sine = std::sin(2 * bisector);
  std::vector<NotchSample> samples;
  for (const Corner::Sample& s : c.samples) {
    if (s.distance < kNearest * c.element || s.distance > farthest) continue;
    const double ux = ends.ux[static_cast<size_t>(s.row)], uy = ends.uy[static_cast<size_t>(s.row)];
    samples.push_back({s.distance, s.first, ux, uy});
    if (c.half) samples.push_back({s.distance, !s.first, cosine * ux + sine * uy, sine * ux - cosine * uy});
  }
  const auto on_first = std::count_if(samples.begin(), samples.end(), [](const NotchSample& s) { return s.first; });
  if (std::min(static_cast<size_t>(on_first), samples.size() - static_cast<size_t>(on_first)) < kFewest) {
    out.why = kTooFew;
    return out;
  }
  const CornerFit fitted = fit_notch(samples, {sector, bisector});
  // Either mode may be absent: errors are relative to the larger one.
  const bool two = out.exponents.size() > 1;
  const double apart = two ? std::pow(farthest, out.exponents[1].real() - out.exponents[0].real()) : 0;
  const double most = std::max(std::fabs(fitted.K), std::fabs(fitted.K2) * apart);
  if (fitted.misfit > kWorst || std::max(fitted.K_error, fitted.K2_error * apart) > kWorst * most) {
    out.why = kNotAlike;
    return out;
  }
  out.K = fitted.K;
  const double unseen = c.linear ? kUnseenLinear : kUnseen;
  out.K_error = 2 * fitted.K_error + unseen * std::fabs(fitted.K);
  if (!two) return out;
  out.K2 = fitted.K2;
  out.K2_error = 2 * fitted.K2_error + unseen * std::fabs(fitted.K2);
  return out;
}

} // namespace

const char* name_of(CornerKind kind) {
  switch (kind) {
  case CornerKind::kNotch: return "notch";
  case CornerKind::kSupport: return "end of a support";
  case CornerKind::kContact: return "edge of a contact";
  case CornerKind::kTie: return "end of a tie";
  }
  return "";
}

CornerState corner_state(const Corner& c, const double* table, int64_t stride) {
  CornerState out = state_of(c);
  if (c.samples.empty()) return out;
  const Pairs pairs(c, table, stride);
  const int32_t status = pairs.status(pairs.first());
  out.joint = status == C2D_OPEN ? "open" : status == C2D_SLIP ? "slip" : status == C2D_TIED ? "tied" : "stick";
  if (status == C2D_OPEN) return out;
  Face joint{FaceKind::kBonded, 0};
  if (status == C2D_SLIP) joint = {FaceKind::kRubbing, pairs.friction()};
  if (std::fabs(joint.friction) < 1e-9 && status == C2D_SLIP) joint = {FaceKind::kSmooth, 0};
  const std::vector<Complex>& all = exponents_with(c, joint);
  take_singular(all, out);
  if (out.exponents.empty()) return out;
  const size_t end = pairs.end_of_run();
  const double farthest = kFarthest * std::min(c.samples[end - 1].distance, c.size);
  std::vector<PressureSample> samples;
  for (size_t i = pairs.first(); i < end; ++i)
    if (c.samples[i].distance >= kNearest * c.element && c.samples[i].distance <= farthest)
      samples.push_back({c.samples[i].distance, pairs.row(i)[C2D_TN]});
  fit(samples, all, c.linear, out);
  return out;
}

c2d_status corner_states(c2d_solver* solver, const Summary& s, const std::vector<Corner>& corners,
                         std::vector<CornerState>& out) {
  out.clear();
  std::vector<double> table;
  int32_t read = 0; // the body whose ends these are
  Ends ends;
  for (const Corner& c : corners) {
    const bool at_pairs = c.kind == CornerKind::kContact || c.kind == CornerKind::kTie;
    c2d_status status = C2D_OK;
    if (at_pairs && table.empty()) {
      table.resize(static_cast<size_t>(s.pairs) * C2D_PAIR_FIELDS);
      for (int32_t f = 0; f < C2D_PAIR_FIELDS && status == C2D_OK; ++f)
        status = c2d_get(solver, f, 1, 1, s.pairs, table.data() + f, C2D_PAIR_FIELDS);
    } else if (!at_pairs && read != c.body[0]) {
      status = read_ends(solver, s, c.body[0], ends);
      read = c.body[0];
    }
    if (status != C2D_OK) return status;
    const CornerState now = at_pairs                       ? corner_state(c, table.data(), C2D_PAIR_FIELDS)
                            : c.kind == CornerKind::kNotch ? notch_state(c, ends)
                                                           : support_state(c, ends);
    if (!now.exponents.empty()) out.push_back(now);
  }
  return C2D_OK;
}

} // namespace app
