#include "post/edges.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// The pairs of a line from one of them on in one direction, also around a closed side.
class View {
public:
  View(const ZoneLine& line, int32_t from, int direction) : line_(line), from_(from), direction_(direction) {}
  // Index in the line of the k-th next pair, k of either sign; -1: beyond the end of the line.
  int32_t at(int32_t k) const {
    const int32_t n = static_cast<int32_t>(line_.size()), i = from_ + direction_ * k;
    if (i >= 0 && i < n) return i;
    return line_.round && k > -n && k < n ? (i % n + n) % n : -1;
  }
  // Its distance from the first; negative for k < 0.
  double distance(int32_t k) const {
    const int32_t n = static_cast<int32_t>(line_.size()), i = from_ + direction_ * k;
    const double turns = i < 0 ? -1 : i >= n ? 1 : 0;
    const int32_t place = at(k);
    return direction_ * (line_.s[static_cast<size_t>(place)] + turns * line_.length - line_.s[static_cast<size_t>(from_)]);
  }

private:
  const ZoneLine& line_;
  int32_t from_;
  int direction_;
};

bool touches(int32_t status) { return status != C2D_OPEN; }

// Length x at which y vanishes; y is nearly linear there: inverse interpolation x(y) through samples first ... last.
struct EdgeSample {
  double x, y;
};
double root_of(const std::vector<EdgeSample>& v, size_t first, size_t last) {
  double root = 0;
  for (size_t i = first; i <= last; ++i) {
    double factor = v[i].x;
    for (size_t j = first; j <= last; ++j)
      if (j != i) factor *= v[j].y / (v[j].y - v[i].y);
    root += factor;
  }
  return root;
}

// Where the inverse power of a gap, or of a slip, vanishes before the pairs of v, first the nearest one. The nearest is the
// one that the mesh disturbs most, and is left out. A root through pairs k to k + 2 is off by about the square of the inverse
// of their distance: from two of them follows a better one. On uneven meshes the two may lie so close that their difference
// would be multiplied many times.
constexpr double kMostWeight = 1.5;
double best_root(const std::vector<EdgeSample>& v) {
  if (v.size() < 2) return NAN;
  if (v.size() == 2) return root_of(v, 0, 1);
  if (v.size() < 5) return root_of(v, 1, 2);
  const double near = root_of(v, 1, 3), far = root_of(v, 2, 4);
  const double ratio = std::pow((v[3].x - near) / (v[4].x - near), 2);
  return far + std::min(ratio / (1 - ratio), kMostWeight) * (far - near);
}

// How far before the last pair of a state its end may lie: on a mesh a pair may keep a status that it should have left.
const double kBefore = 0.25;

// The root by as many pairs as give one between the last pair of one state, at 0, and the first of the other.
double limited_root(const std::vector<EdgeSample>& v, double before) {
  const double step = v.front().x;
  for (size_t use = std::min<size_t>(v.size(), 5); use >= 2; use = use > 3 ? 3 : use - 1) {
    const double root = best_root({v.begin(), v.begin() + static_cast<std::ptrdiff_t>(use)});
    if (root >= -before * step && root <= step) return root;
  }
  return step / 2;
}

const int32_t kSamples = 5, kAdvancedSamples = 3;

// The power with which the gap opens: 3/2, but where unlike bodies slide. Body 1 yields along under a pressure, which friction
// on it towards the open side adds to.
double gap_power(const LineState& state, int32_t last, int direction) {
  const ZoneLine& line = state.line;
  const auto i = static_cast<size_t>(last), n = line.size();
  if (line.beta == 0 || n < 2 || state.status[i] != C2D_SLIP || !(state.tn[i] > 0)) return 1.5;
  const size_t a = i > 0 ? i - 1 : i, b = i > 0 ? i : i + 1; // along t = (ny, -nx), or against it?
  const double along = (line.x[b] - line.x[a]) * state.ny[i] - (line.y[b] - line.y[a]) * state.nx[i];
  const double outwards = std::copysign(direction, along * direction) * state.tt[i]; // on side 2
  return 1.5 - std::atan(line.beta * outwards / state.tn[i]) / std::acos(-1.0);
}

// End of a stretch of contact with the last pair `last` in `direction`.
ContactEdge edge_beyond(const LineState& state, int32_t last, int direction) {
  const ZoneLine& line = state.line;
  const View view(line, last, direction);
  ContactEdge edge;
  edge.last = last, edge.direction = direction, edge.s = line.s[static_cast<size_t>(last)];
  edge.at_corner = line.corner[static_cast<size_t>(last)] != 0;
  if (edge.at_corner) return edge;
  int32_t open = 0; // how many pairs until the line ends, or the next stretch begins
  const int32_t most = static_cast<int32_t>(line.size());
  while (open < most && view.at(open + 1) >= 0 && !touches(state.status[static_cast<size_t>(view.at(open + 1))])) ++open;
  const bool more = view.at(open + 1) >= 0;
  const int32_t use = std::min(more ? (open + 1) / 2 : open, kSamples); // up to the middle between two stretches
  const double power = gap_power(state, last, direction);
  std::vector<EdgeSample> samples;
  for (int32_t k = 1; k <= use; ++k)
    samples.push_back({view.distance(k), std::pow(std::max(state.gap[static_cast<size_t>(view.at(k))], 0.0), 1 / power)});
  edge.s += direction * limited_root(samples, kBefore);
  return edge;
}

// Friction that is round-off of the pressure becomes 0.
void drop_round_off(LineState& state) {
  double pressure = 0, friction = 0;
  for (const double t : state.tn) pressure = std::max(pressure, std::fabs(t));
  for (const double t : state.tt) friction = std::max(friction, std::fabs(t));
  if (friction <= kNoFriction * pressure) std::fill(state.tt.begin(), state.tt.end(), 0.0);
}

} // namespace

LineState line_state(const ZoneLine& line, const double* table, int64_t stride, const std::vector<double>& slip_at_turn) {
  LineState state{line, {}, {}, {}, {}, {}, {}, {}};
  for (const int32_t pair : line.pair) {
    const double* row = table + pair * stride;
    const size_t p = static_cast<size_t>(pair);
    state.status.push_back(static_cast<int32_t>(row[C2D_STATUS]));
    state.tn.push_back(row[C2D_TN]), state.tt.push_back(row[C2D_TT]), state.gap.push_back(row[C2D_GAP]);
    state.nx.push_back(row[C2D_NX]), state.ny.push_back(row[C2D_NY]);
    state.slip.push_back(row[C2D_SLIP_SUM] - (p < slip_at_turn.size() ? slip_at_turn[p] : 0.0));
  }
  drop_round_off(state);
  return state;
}

std::vector<ContactEdge> find_contact_edges(const LineState& state) {
  const ZoneLine& line = state.line;
  std::vector<ContactEdge> out;
  for (int32_t i = 0; i < static_cast<int32_t>(line.size()); ++i) {
    if (!touches(state.status[static_cast<size_t>(i)])) continue;
    for (const int direction : {-1, 1}) {
      const int32_t next = View(line, i, direction).at(1);
      const ZoneEnd& end = line.end[direction > 0 ? 1 : 0];
      if (next >= 0) {
        if (!touches(state.status[static_cast<size_t>(next)])) out.push_back(edge_beyond(state, i, direction));
      } else if (end.corner && !end.mirror) {
        out.push_back({end.s, i, direction, true});
      }
    }
  }
  return out;
}

namespace {

// Locked-in slip of stuck pairs continues smoothly beyond the border: the value there of the parabola through the three stuck
// pairs next to it, or fewer.
double locked_slip(const LineState& state, const View& view, int32_t stuck, double at) {
  double locked = 0;
  const int32_t n = std::min(stuck, 3);
  for (int32_t i = 0; i < n; ++i) {
    double factor = state.slip[static_cast<size_t>(view.at(-i))];
    for (int32_t j = 0; j < n; ++j)
      if (j != i) factor *= (at - view.distance(-j)) / (view.distance(-i) - view.distance(-j));
    locked += factor;
  }
  return locked;
}

int32_t run_of(const LineState& state, const View& view, int32_t first, int step, int32_t status) {
  int32_t run = 0;
  const int32_t most = static_cast<int32_t>(state.line.size());
  while (run < most) {
    const int32_t at = view.at(first + step * run);
    if (at < 0 || state.status[static_cast<size_t>(at)] != status) break;
    ++run;
  }
  return run;
}

// Did the stick zone advance over pairs that had slipped since the last reversal? Then the pair next to the border has
// locked-in slip.
bool has_advanced(const LineState& state, const View& view, int32_t slipping) {
  double most = 0;
  for (int32_t k = 1; k <= slipping; ++k) most = std::max(most, std::fabs(state.slip[static_cast<size_t>(view.at(k))]));
  return std::fabs(state.slip[static_cast<size_t>(view.at(0))]) > 1e-6 * most;
}

// Between a stuck pair and the one that slips next to it. Where slip advances it begins with the power 3/2 of the distance, as
// a gap does; where stick advances the rate of slip vanishes like that, and the slip beyond the locked-in one with the power
// 5/2.
double border_beyond(const LineState& state, int32_t stuck, int direction) {
  const View view(state.line, stuck, direction);
  const int32_t slipping = run_of(state, view, 1, 1, C2D_SLIP), locked = run_of(state, view, 0, -1, C2D_STICK);
  const int32_t behind = view.at(slipping + 1);
  const bool more = behind >= 0 && state.status[static_cast<size_t>(behind)] == C2D_STICK;
  const bool advanced = has_advanced(state, view, slipping);
  const int32_t use = std::min(more ? (slipping + 1) / 2 : slipping, advanced ? kAdvancedSamples : kSamples);
  std::vector<EdgeSample> samples;
  for (int32_t k = 1; k <= use; ++k) {
    const double at = view.distance(k);
    const double slip = std::fabs(state.slip[static_cast<size_t>(view.at(k))] - locked_slip(state, view, locked, at));
    samples.push_back({at, advanced ? std::pow(slip, 0.4) : std::cbrt(slip * slip)});
  }
  return state.line.s[static_cast<size_t>(stuck)] + direction * limited_root(samples, advanced ? 0 : kBefore);
}

} // namespace

std::vector<double> find_stick_borders(const LineState& state) {
  std::vector<double> out;
  for (int32_t i = 0; i < static_cast<int32_t>(state.line.size()); ++i) {
    if (state.status[static_cast<size_t>(i)] != C2D_STICK) continue;
    for (const int direction : {-1, 1}) {
      const int32_t next = View(state.line, i, direction).at(1);
      if (next >= 0 && state.status[static_cast<size_t>(next)] == C2D_SLIP) out.push_back(border_beyond(state, i, direction));
    }
  }
  return out;
}

EdgeValue edge_slip(const LineState& state, const ContactEdge& edge) {
  const View view(state.line, edge.last, -edge.direction);
  if (edge.at_corner || run_of(state, view, 0, 1, C2D_SLIP) < 3) return {};
  const auto s = [&](int32_t k) { return state.slip[static_cast<size_t>(view.at(k))]; };
  const auto at_edge = [&](int32_t k) { // by the line through pairs k and k + 1
    const double a = view.distance(k), b = view.distance(k + 1),
                 edge_at = edge.direction * (state.line.s[static_cast<size_t>(edge.last)] - edge.s);
    return s(k) + (s(k + 1) - s(k)) * (edge_at - a) / (b - a);
  };
  return {std::fabs(at_edge(0)), std::fabs(at_edge(0) - at_edge(1))};
}

namespace {

// An intensity follows from four pairs. The mesh disturbs those in the elements next to the edge, which are left out.
const int32_t kPairs = 4, kElementsOut = 4, kFewerOut = 2;
const int32_t kFarther = 2;                       // elements: pairs this much farther in give a second value
const double kOfFarther = 2, kOfIntensity = 0.03; // uncertainty: times the difference, and at least this fraction of the value

int32_t pairs_per_element(const ZoneLine& line) {
  const size_t elements = std::max<size_t>(line.pieces.size(), 1);
  return std::max<int32_t>(1, static_cast<int32_t>((line.size() + elements / 2) / elements));
}

// Value at d = 0 of the least-squares straight line through the samples.
double value_at_edge(const std::vector<EdgeSample>& v) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const EdgeSample& s : v) n += 1, x += s.x, y += s.y, xx += s.x * s.x, xy += s.x * s.y;
  return (y * xx - x * xy) / (n * xx - x * x);
}

// These pairs as (distance, value(place, distance)); none if the contact, or its stick, ends before the last of them.
template <class Value>
std::vector<EdgeSample> inside(const LineState& state, const ContactEdge& edge, int32_t elements_out, bool stuck, Value value) {
  const View view(state.line, edge.last, -edge.direction);
  const double begin = edge.direction * (edge.s - state.line.s[static_cast<size_t>(edge.last)]);
  const int32_t out_first = elements_out * pairs_per_element(state.line);
  std::vector<EdgeSample> out;
  for (int32_t k = 0; k < out_first + kPairs; ++k) {
    const int32_t at = view.at(k);
    if (at < 0 || !touches(state.status[static_cast<size_t>(at)])) return {};
    if (stuck && state.status[static_cast<size_t>(at)] != C2D_STICK) return {};
    const double d = begin + view.distance(k);
    if (k >= out_first) out.push_back({d, value(static_cast<size_t>(at), d)});
  }
  return out;
}

} // namespace

EdgeValue edge_pressure(const LineState& state, const ContactEdge& edge) {
  if (edge.at_corner) return {NAN, 0};
  const auto intensity = [&](int32_t elements_out) {
    const std::vector<EdgeSample> v =
        inside(state, edge, elements_out, false, [&](size_t at, double d) { return state.tn[at] * state.tn[at] / d; });
    const double square = v.empty() ? NAN : value_at_edge(v);
    return square >= 0 ? std::sqrt(square) : NAN;
  };
  for (const int32_t out : {kElementsOut, kFewerOut}) {
    const double value = intensity(out), other = intensity(out + kFarther);
    if (std::isnan(value)) continue;
    return {value, std::max(kOfIntensity * value, std::isnan(other) ? 0 : kOfFarther * std::fabs(other - value))};
  }
  return {NAN, 0};
}

EdgeValue edge_friction(const LineState& state, const ContactEdge& edge) {
  if (edge.at_corner) return {NAN, 0};
  const auto value = [&](size_t at, double d) { return state.tt[at] * state.tt[at] * d; };
  const std::vector<EdgeSample> v = inside(state, edge, kElementsOut, true, value);
  if (v.empty()) return {NAN, 0};
  // Friction that falls towards the edge, as where the contact has just grown, has no such intensity.
  for (size_t i = 1; i < v.size(); ++i)
    if (v[i].y / v[i].x >= v[i - 1].y / v[i - 1].x) return {NAN, 0};
  const double square = value_at_edge(v);
  return {square > 0 ? std::copysign(std::sqrt(square), state.tt[static_cast<size_t>(edge.last)]) : NAN, 0};
}

} // namespace app
