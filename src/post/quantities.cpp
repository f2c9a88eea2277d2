#include "post/quantities.hpp"

#include "post/edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace app {
class Quantities {
public:
  Quantities(int32_t zone, std::vector<Quantity>& out) : zone_(zone), out_(out) {}
  Quantity& add(Measure what, double value, int32_t item = 0) {
    Quantity q;
    q.what = what, q.zone = zone_, q.item = item, q.value = value;
    out_.push_back(q);
    return out_.back();
  }

private:
  int32_t zone_;
  std::vector<Quantity>& out_;
};

// `contact`: it touches and is not tied; then `edges` are its edges. `now`: null if unknown.
struct ZoneStep {
  LineState state;
  bool contact;
  std::vector<ContactEdge> edges;
  const c2d_zone_state* now;
  const CycleResults* cycle; // null: no cycle is repeated
  bool moves() const { return contact && now != nullptr && !state.line.self; }
};

struct BodyStep {
  const c2d_body_state& now;
  int32_t item;
  bool without_contact; // of the whole model
};

namespace {

struct Peak {
  double s, value;
  double above = 0; // height of the node above the straight line between its neighbours
};

// The vertex of the parabola through the largest of what pairs have and its neighbours; at an end of the contact or a corner,
// where there is no smooth top, and where the neighbours have as much, the largest itself.
Peak find_peak(const LineState& state, const std::vector<double>& values) {
  const ZoneLine& line = state.line;
  const int32_t n = static_cast<int32_t>(line.size());
  size_t top = 0;
  for (size_t j = 1; j < values.size(); ++j)
    if (is_larger(values[j], values[top])) top = j;
  const Peak node{line.s[top], values[top]};
  const int32_t i = static_cast<int32_t>(top);
  if (line.corner[top] != 0 || (!line.round && (i == 0 || i == n - 1)) || n < 3) return node;
  const size_t before = static_cast<size_t>((i + n - 1) % n), after = static_cast<size_t>((i + 1) % n);
  if (state.status[before] == C2D_OPEN || state.status[after] == C2D_OPEN) return node;
  if (!is_larger(node.value, values[before]) && !is_larger(node.value, values[after])) return node; // uniform
  double a = line.s[before] - node.s, b = line.s[after] - node.s;
  if (i == 0) a -= line.length;
  if (i == n - 1) b += line.length;
  const double slope_a = (values[before] - node.value) / a, slope_b = (values[after] - node.value) / b;
  const double curvature = (slope_b - slope_a) / (b - a), slope = slope_a - curvature * a;
  if (curvature >= 0) return node; // three equal values
  const double at = -slope / (2 * curvature);
  return {node.s + at, node.value + slope * at / 2, curvature * a * b};
}

// Where a stretch of contact or of stick ends; direction: 1 as s rises, -1 as it falls.
struct StretchEnd {
  double s;
  int direction;
};
// The stretches of a state, in the order of s; those that reach the ends of the line have no StretchEnd there. Of a closed
// side, `first` and `last`: a stretch goes on across the place where s begins.
struct Stretches {
  std::vector<StretchEnd> ends;
  bool first = false, last = false;
  // One stretch, with both ends on the line or cut by one line of symmetry.
  bool is_one() const { return ends.size() + (first ? 1 : 0) + (last ? 1 : 0) == 2; }
};

double length_of(const ZoneLine& line, const Stretches& stretches) {
  double sum = 0;
  for (const StretchEnd& end : stretches.ends) sum += end.direction * end.s;
  if (line.round)
    return stretches.ends.empty()              ? (stretches.first ? line.length : 0)
           : stretches.first && stretches.last ? sum + line.length
                                               : sum;
  if (stretches.first) sum -= line.end[0].s;
  if (stretches.last) sum += line.end[1].s;
  return sum;
}

// The same with the images of stretches that a line of symmetry cuts.
double whole_length(const ZoneLine& line, const Stretches& stretches, int32_t& images) {
  double sum = length_of(line, stretches);
  images = 1;
  const bool cut[2] = {stretches.first && line.end[0].mirror, stretches.last && line.end[1].mirror};
  if (cut[0] || cut[1]) images = 2;
  if (stretches.ends.empty()) return cut[0] && cut[1] ? 4 * sum : images * sum;
  if (cut[0]) sum += stretches.ends.front().s - line.end[0].s;
  if (cut[1]) sum += line.end[1].s - stretches.ends.back().s;
  return sum;
}

Stretches touching_stretches(const LineState& state, const std::vector<ContactEdge>& edges) {
  Stretches out;
  out.first = state.status.front() != C2D_OPEN, out.last = state.status.back() != C2D_OPEN;
  const int32_t last = static_cast<int32_t>(state.line.size()) - 1;
  for (const ContactEdge& edge : edges) {
    out.ends.push_back({edge.s, edge.direction});
    if (edge.last == 0 && edge.direction < 0) out.first = false;
    if (edge.last == last && edge.direction > 0) out.last = false;
  }
  return out;
}

// Stretches of stick end at borders, or where the contact ends.
Stretches stuck_stretches(const LineState& state, const std::vector<ContactEdge>& edges, const std::vector<double>& borders) {
  Stretches out;
  const auto n = static_cast<int32_t>(state.line.size());
  const auto status = [&](int32_t i) { return state.status[static_cast<size_t>(state.line.round ? (i + n) % n : i)]; };
  out.first = status(0) == C2D_STICK, out.last = status(n - 1) == C2D_STICK;
  size_t border = 0;
  for (int32_t i = 0; i < n; ++i) {
    if (status(i) != C2D_STICK) continue;
    for (const int direction : {-1, 1}) {
      const int32_t next = i + direction;
      const bool on_line = state.line.round || (next >= 0 && next < n);
      double s = NAN;
      if (on_line && status(next) == C2D_SLIP && border < borders.size()) s = borders[border++];
      for (const ContactEdge& edge : edges)
        if (edge.last == i && edge.direction == direction) s = edge.s;
      if (std::isnan(s)) continue;
      out.ends.push_back({s, direction});
      if (i == 0 && direction < 0) out.first = false;
      if (i == n - 1 && direction > 0) out.last = false;
    }
  }
  return out;
}

double touching_length(const LineState& state, const std::vector<ContactEdge>& edges) {
  return state.line.size() == 0 ? 0 : length_of(state.line, touching_stretches(state, edges));
}

// A length round a closed side from 0 on.
double along(const ZoneLine& line, double s) {
  s = told_place(s, line.length);
  return line.round ? s - line.length * std::floor(s / line.length) : s;
}

void add_place(const ZoneLine& line, double s, Quantity& q) {
  line.place(s, q.at);
  q.s = along(line, s), q.along = line.along(s);
}

void take_peak(const ZoneStep& z, Quantities& out) {
  if (!z.contact) return;
  const ZoneLine& line = z.state.line;
  const Peak peak = find_peak(z.state, z.state.tn);
  Quantity& q = out.add(Measure::kPeakPressure, peak.value);
  add_place(line, peak.s, q);
  for (size_t i = 0; i < line.size(); ++i) {
    if (line.s[i] != peak.s || !(peak.value > 0)) continue;
    q.at_corner = line.corner[i] != 0;
    for (const size_t end : {size_t{0}, size_t{1}})
      if (i == (end == 0 ? 0 : line.size() - 1) && !line.round && !line.end[end].mirror) {
        q.at_corner = q.at_corner || line.end[end].corner;
        q.unbounded = line.end[end].cut && !q.at_corner; // as at the edge of a flat punch
      }
  }
}

// The area that touches, of bodies of revolution.
double touching_area(const LineState& state, const std::vector<ContactEdge>& edges) {
  const ZoneLine& line = state.line;
  if (line.size() == 0) return 0;
  const Stretches stretches = touching_stretches(state, edges);
  double sum = 0;
  for (const StretchEnd& end : stretches.ends) sum += end.direction * line.area(end.s);
  if (line.round) {
    const bool whole = stretches.first && (stretches.last || stretches.ends.empty());
    return whole ? sum + line.area(line.length) : sum;
  }
  if (stretches.first) sum -= line.area(line.end[0].s);
  if (stretches.last) sum += line.area(line.end[1].s);
  return sum;
}

double integral(const ZoneLine& line, const std::vector<double>& values) {
  double sum = 0;
  for (size_t i = 0; i < values.size(); ++i) sum += line.weight[i] * values[i];
  return sum;
}

void take_mean(const ZoneStep& z, Quantities& out) {
  const auto measure = z.state.line.revolved ? touching_area : touching_length;
  const double length = z.contact ? measure(z.state, z.edges) : 0;
  if (length > 0) out.add(Measure::kMeanPressure, integral(z.state.line, z.state.tn) / length);
}

bool rubs(const LineState& state) {
  return std::any_of(state.tt.begin(), state.tt.end(), [](double t) { return t != 0; }) ||
         std::count(state.status.begin(), state.status.end(), C2D_STICK) > 0;
}

void take_friction(const ZoneStep& z, Quantities& out) {
  if (z.contact && rubs(z.state)) out.add(Measure::kFrictionForce, integral(z.state.line, z.state.tt));
}

double spacing_at(const ZoneLine& line, double s) {
  const auto place = static_cast<size_t>(std::lower_bound(line.s.begin(), line.s.end(), s) - line.s.begin());
  const size_t low = place > 2 ? place - 2 : 0, high = std::min(place + 2, line.size() - 1);
  return high > low ? (line.s[high] - line.s[low]) / static_cast<double>(high - low) : line.length;
}

Quantity& add_between(const ZoneLine& line, Measure what, double s, size_t i, Quantities& out) {
  Quantity& q = out.add(what, along(line, s), static_cast<int32_t>(i) + 1);
  add_place(line, s, q);
  q.spacing = spacing_at(line, s);
  return q;
}

// The mean distance of pairs that touch.
double mean_spacing(const LineState& state, const std::vector<ContactEdge>& edges) {
  const auto open = std::count(state.status.begin(), state.status.end(), C2D_OPEN);
  return touching_length(state, edges) / static_cast<double>(state.status.size() - static_cast<size_t>(open));
}

void take_edges(const ZoneStep& z, Quantities& out) {
  for (size_t i = 0; i < z.edges.size(); ++i)
    add_between(z.state.line, Measure::kContactEdge, z.edges[i].s, i, out).at_corner = z.edges[i].at_corner;
}

void take_borders(const ZoneStep& z, Quantities& out) {
  if (!z.contact) return;
  const std::vector<double> borders = find_stick_borders(z.state);
  for (size_t i = 0; i < borders.size(); ++i) {
    Quantity& q = add_between(z.state.line, Measure::kStickBorder, borders[i], i, out);
    q.spacing += mean_spacing(z.state, z.edges); // the start of slip depends on the history of the contact
  }
}

void take_contact_width(const ZoneStep& z, Quantities& out) {
  if (!z.contact) return;
  int32_t images = 1;
  const double width = whole_length(z.state.line, touching_stretches(z.state, z.edges), images);
  if (width > 0) out.add(Measure::kContactWidth, width).images = images;
}

void take_half_width(const ZoneStep& z, Quantities& out) {
  if (!z.contact || z.state.line.round) return;
  int32_t images = 1;
  const Stretches stretches = touching_stretches(z.state, z.edges);
  const double width = whole_length(z.state.line, stretches, images);
  if (width > 0 && stretches.is_one()) out.add(Measure::kHalfWidth, width / 2).images = images;
}

// With friction; 0 where all slips.
void take_stuck_width(const ZoneStep& z, Quantities& out) {
  const LineState& state = z.state;
  if (!z.contact || !rubs(state)) return;
  int32_t images = 1;
  const double width = whole_length(state.line, stuck_stretches(state, z.edges, find_stick_borders(state)), images);
  out.add(Measure::kStuckWidth, width).images = images;
}

// Of an uncut stretch: a line of symmetry makes it 0.
void take_eccentricity(const ZoneStep& z, Quantities& out) {
  if (!z.contact || z.edges.size() != 2) return;
  const Stretches stuck = stuck_stretches(z.state, z.edges, find_stick_borders(z.state));
  if (stuck.ends.size() != 2) return;
  const double stick = (stuck.ends[0].s + stuck.ends[1].s) / 2, contact = (z.edges[0].s + z.edges[1].s) / 2;
  const bool up = z.state.line.pieces.empty() || z.state.line.pieces.front().up != z.state.line.turned;
  out.add(Measure::kEccentricity, (up ? 1 : -1) * (stick - contact));
}

template <Measure What, EdgeValue (*Find)(const LineState&, const ContactEdge&)>
void take_intensity(const ZoneStep& z, Quantities& out) {
  for (size_t i = 0; i < z.edges.size(); ++i) {
    const EdgeValue found = Find(z.state, z.edges[i]);
    if (!std::isfinite(found.value)) continue;
    Quantity& q = out.add(What, found.value, static_cast<int32_t>(i) + 1);
    q.doubt = found.doubt;
    add_place(z.state.line, z.edges[i].s, q);
  }
}

// Of how far the largest slip stands above its neighbours: where the contact grew slip is not smooth from node to node.
constexpr double kOfStanding = 0.5;

// Where nothing has slipped there is none. It is largest within the contact, or at an edge, between nodes.
void take_slip_range(const ZoneStep& z, Quantities& out) {
  const LineState& state = z.state;
  if (!z.contact) return;
  std::vector<double> sizes(state.slip.size(), 0.0);
  for (size_t i = 0; i < sizes.size(); ++i)
    if (state.status[i] != C2D_OPEN) sizes[i] = std::fabs(state.slip[i]);
  const Peak peak = find_peak(state, sizes);
  if (!(peak.value > 0)) return;
  EdgeValue largest{peak.value, kOfStanding * peak.above};
  double at = peak.s;
  for (const ContactEdge& edge : z.edges)
    if (const EdgeValue slip = edge_slip(state, edge); slip.value > largest.value) largest = slip, at = edge.s;
  Quantity& q = out.add(Measure::kSlipRange, largest.value);
  q.doubt = largest.doubt;
  add_place(state.line, at, q);
}

template <Measure What, size_t Component> void take_force(const ZoneStep& z, Quantities& out) {
  if (z.now != nullptr) out.add(What, z.now->force[Component]);
}
void take_moment(const ZoneStep& z, Quantities& out) {
  if (z.now != nullptr) out.add(Measure::kMoment, z.now->moment);
}
void take_dissipated(const ZoneStep& z, Quantities& out) {
  if (z.now != nullptr && !z.state.line.tied) out.add(Measure::kDissipated, z.now->dissipated);
}
void take_approach(const ZoneStep& z, Quantities& out) {
  if (z.moves()) out.add(Measure::kApproach, z.now->approach);
}
void take_shift(const ZoneStep& z, Quantities& out) {
  if (z.moves()) out.add(Measure::kShift, z.now->shift);
}

void take_walk(const ZoneStep& z, Quantities& out) {
  if (z.contact && z.cycle != nullptr) out.add(Measure::kWalk, z.cycle->zones[static_cast<size_t>(z.state.line.zone) - 1].walk);
}
void take_stuck_all(const ZoneStep& z, Quantities& out) {
  if (!z.contact || z.cycle == nullptr) return;
  const ZoneLine& line = z.state.line;
  double sum = 0;
  for (size_t i = 0; i < line.size(); ++i) sum += line.weight[i] * z.cycle->stuck[static_cast<size_t>(line.pair[i])];
  out.add(Measure::kStuckAll, sum).spacing = mean_spacing(z.state, z.edges);
}

// Without a contact: along the driving force, which the contact of other models balances.
void take_driven(const BodyStep& b, Quantities& out) {
  const double *motion = b.now.motion, *contact = b.now.contact, force = std::hypot(contact[0], contact[1]);
  if (b.without_contact && force > 0)
    out.add(Measure::kApproach, -(motion[0] * contact[0] + motion[1] * contact[1]) / force, b.item);
}
template <Measure What, size_t Component> void take_motion(const BodyStep& b, Quantities& out) {
  out.add(What, b.now.motion[Component], b.item);
}

// METHOD (16.7). The weights cover the true errors of problems with closed forms closely (tests/truth.mk).
constexpr ErrorRule kNone{0, 0, 0, 0, 0}, kPeak{1.1, 0.5, 0.3, 0, 0}, kMean{0.8, 0.1, 0, 0, 1}, kForce{1, 0.3, 0.1, 0, 0},
    kEdge{1.2, 0.4, 0.15, 0, 1}, kBorder{1, 0.5, 0.05, 0.05, 0}, kMovedBorder{1.5, 0.7, 0.05, 0.03, 0},
    kIntensity{1, 0.5, 0.5, 0, 1}, kSlip{1, 0.5, 1.5, 0, 1}, kTorque{1, 0.4, 0.03, 0, 0}, kEnergy{1, 0.5, 0.7, 0, 0},
    kMotion{1, 1, 0, 0, 0}, kOfCycle{0.7, 0.4, 0.15, 0, 0}, kCycleEnergy{0.8, 0.5, 0.5, 0, 0},
    kPressedEnergy{2, 0.7, 0.2, 0, 0}, kWholePairs{1, 0.5, 0.05, 0.5, 0}, kInside{1, 0.3, 0.07, 0, 0},
    kSurface{1.5, 0.1, 0.2, 0, 1}, kExtrapolated{1, 0.1, 0.05, 0, 1};

using M = Measure;
using U = Unit;
using S = Scale;
using TakeZone = void (*)(const ZoneStep&, Quantities&);
using TakeBody = void (*)(const BodyStep&, Quantities&);

// A number of a contact: a place, which is refined; a number at a place; one that contact tractions determine; any other.
constexpr MeasureRow place(M what, const char* name, U unit, S scale, TakeZone take, ErrorRule rule, ErrorRule other) {
  return {what, name, unit, scale, {rule, other}, {0, 0}, true, PlaceKind::kRefined, take, nullptr};
}
constexpr MeasureRow at_place(M what, const char* name, U unit, S scale, TakeZone take, ErrorRule rule) {
  return {what, name, unit, scale, {rule, rule}, {0, 0}, false, PlaceKind::kGiven, take, nullptr};
}
constexpr MeasureRow local(M what, const char* name, U unit, S scale, TakeZone take, ErrorRule rule) {
  return {what, name, unit, scale, {rule, rule}, {0, 0}, true, PlaceKind::kNone, take, nullptr};
}
constexpr MeasureRow width(M what, const char* name, S scale, TakeZone take, ByPlaces by_places) {
  return {what, name, U::kLength, scale, {kEdge, kEdge}, by_places, true, PlaceKind::kNone, take, nullptr};
}
constexpr MeasureRow zone(M what, const char* name, U unit, S scale, TakeZone take, ErrorRule rule,
                          TakeBody of_body = nullptr) {
  return {what, name, unit, scale, {rule, rule}, {0, 0}, false, PlaceKind::kNone, take, of_body};
}
constexpr MeasureRow body(M what, const char* name, U unit, S scale, TakeBody take) {
  return {what, name, unit, scale, {kMotion, kMotion}, {0, 0}, false, PlaceKind::kNone, nullptr, take};
}
// Requested by a sketch: at points inside, along a surface, of a cycle.
constexpr MeasureRow inside(M what, const char* name, U unit) {
  return {what, name, unit, S::kGiven, {kInside, kInside}, {0, 0}, false, PlaceKind::kRefined, nullptr, nullptr};
}
constexpr MeasureRow surface(M what, const char* name, U unit = U::kStress) {
  return {what, name, unit, S::kGiven, {kSurface, kExtrapolated}, {0, 0}, false, PlaceKind::kRefined, nullptr, nullptr};
}

constexpr MeasureRow of_cycle(M what, const char* name, U unit, ErrorRule rule, ErrorRule other) {
  return {what, name, unit, S::kGiven, {rule, other}, {0, 0}, false, PlaceKind::kNone, nullptr, nullptr};
}
constexpr MeasureRow round_axis(M what, const char* name, U unit) {
  return {what, name, unit, S::kGiven, {kTorque, kTorque}, {0, 0}, false, PlaceKind::kNone, nullptr, nullptr};
}

constexpr MeasureRow kRows[] = {
    place(M::kPeakPressure, "peak pressure", U::kStress, S::kOwn, take_peak, kPeak, kPeak),
    zone(M::kMeanPressure, "mean pressure", U::kStress, S::kOwn, take_mean, kMean),
    zone(M::kFrictionForce, "friction force", U::kForce, S::kForce, take_friction, kForce),
    place(M::kContactEdge, "contact edge", U::kLength, S::kPlace, take_edges, kEdge, kEdge),
    place(M::kStickBorder, "stick border", U::kLength, S::kPlace, take_borders, kBorder, kMovedBorder),
    width(M::kContactWidth, "contact width", S::kOwn, take_contact_width, {1, 0}),
    width(M::kHalfWidth, "half width", S::kOwn, take_half_width, {0.5, 0}),
    width(M::kStuckWidth, "stuck width", S::kContact, take_stuck_width, {0, 1}),
    width(M::kEccentricity, "eccentricity", S::kContact, take_eccentricity, {0.5, 0.5}),
    at_place(M::kEdgePressure, "edge pressure", U::kNone, S::kOwn, take_intensity<M::kEdgePressure, edge_pressure>, kIntensity),
    at_place(M::kEdgeFriction, "edge friction", U::kNone, S::kOwn, take_intensity<M::kEdgeFriction, edge_friction>, kIntensity),
    at_place(M::kSlipRange, "slip range", U::kLength, S::kSlip, take_slip_range, kSlip),
    zone(M::kForceX, "force x", U::kForce, S::kForce, take_force<M::kForceX, 0>, kForce),
    zone(M::kForceY, "force y", U::kForce, S::kForce, take_force<M::kForceY, 1>, kForce),
    zone(M::kMoment, "moment", U::kWork, S::kMoment, take_moment, kTorque),
    local(M::kDissipated, "dissipated", U::kWork, S::kWork, take_dissipated, kEnergy),
    zone(M::kApproach, "approach", U::kLength, S::kApproach, take_approach, kMotion, take_driven),
    zone(M::kShift, "shift", U::kLength, S::kApproach, take_shift, kMotion),
    zone(M::kWalk, "walk", U::kLength, S::kWalk, take_walk, kOfCycle),
    zone(M::kStuckAll, "stuck all through", U::kLength, S::kContact, take_stuck_all, kWholePairs),
    body(M::kMotionX, "motion x", U::kLength, S::kMotion, take_motion<M::kMotionX, 0>),
    body(M::kMotionY, "motion y", U::kLength, S::kMotion, take_motion<M::kMotionY, 1>),
    body(M::kRotation, "rotation", U::kNone, S::kRotation, take_motion<M::kRotation, 2>),
    local(M::kTractions, "tractions", U::kNone, S::kGiven, nullptr, kNone),
    inside(M::kDisplacementX, "displacement x", U::kLength),
    inside(M::kDisplacementY, "displacement y", U::kLength),
    inside(M::kStressXX, "stress xx", U::kStress),
    inside(M::kStressYY, "stress yy", U::kStress),
    inside(M::kStressXY, "stress xy", U::kStress),
    inside(M::kRangeXX, "range of stress xx", U::kStress),
    inside(M::kRangeYY, "range of stress yy", U::kStress),
    inside(M::kRangeXY, "range of stress xy", U::kStress),
    inside(M::kCycleXX, "cycle range of stress xx", U::kStress),
    inside(M::kCycleYY, "cycle range of stress yy", U::kStress),
    inside(M::kCycleXY, "cycle range of stress xy", U::kStress),
    surface(M::kLargestAlong, "largest stress along "),
    surface(M::kSmallestAlong, "smallest stress along "),
    surface(M::kRangeAlong, "range of stress along "),
    surface(M::kCycleAlong, "cycle range of stress along "),
    surface(M::kPressureOn, "pressure on "),
    inside(M::kApproachOf, "approach of points", U::kLength),
    inside(M::kShiftOf, "shift of points", U::kLength),
    of_cycle(M::kCycleDissipated, "dissipated in the last cycle", U::kWork, kCycleEnergy, kPressedEnergy),
    surface(M::kSwt, "SWT"),
    surface(M::kFatemiSocie, "Fatemi-Socie", U::kNone),
    surface(M::kFindley, "Findley"),
    surface(M::kCrossland, "Crossland"),
    surface(M::kDangVan, "Dang Van"),
    surface(M::kRuiz1, "Ruiz F1", U::kForce),
    surface(M::kRuiz2, "Ruiz F2", U::kNone),
    surface(M::kCrackRange, "crack range of K", U::kNone),
    round_axis(M::kTorque, "torque on ", U::kWork),
    round_axis(M::kAngle, "angle of ", U::kNone),
    round_axis(M::kSlipStart, "torque at the start of slip of ", U::kWork),
    round_axis(M::kTurnsThrough, "torque that turns through ", U::kWork),
    round_axis(M::kShear, "largest shear stress on ", U::kStress),
    inside(M::kStressZZ, "stress zz", U::kStress),
    inside(M::kRangeZZ, "range of stress zz", U::kStress),
    inside(M::kCycleZZ, "cycle range of stress zz", U::kStress),
    surface(M::kLargestZZ, "largest stress zz on "),
    surface(M::kSmallestZZ, "smallest stress zz on "),
    surface(M::kRangeZZOn, "range of stress zz on "),
    surface(M::kCycleZZOn, "cycle range of stress zz on "),
};

constexpr double kRoundOff = 1e-10; // of the largest force

// A force that is nothing but round-off of the others becomes 0.
void drop_round_off(const std::vector<c2d_zone_state>& states, std::vector<Quantity>& out) {
  double largest = 0;
  for (const c2d_zone_state& state : states) largest = std::max(largest, std::hypot(state.force[0], state.force[1]));
  for (Quantity& q : out)
    if (row_of(q.what).scale == Scale::kForce && std::fabs(q.value) <= kRoundOff * largest) q.value = 0;
}

constexpr bool is_in_order() {
  for (size_t i = 0; i < kMeasures; ++i)
    if (kRows[i].what != static_cast<Measure>(i)) return false;
  return std::size(kRows) == kMeasures;
}
static_assert(is_in_order(), "row i is that of Measure i");

} // namespace

std::vector<Quantity> quantities_of(const std::vector<ZoneLine>& lines, const double* table, int64_t stride,
                                    const std::vector<c2d_zone_state>& states, double dissipated,
                                    const std::vector<double>& slip_at_turn, const std::vector<c2d_body_state>& bodies,
                                    const CycleResults* cycle) {
  std::vector<Quantity> out;
  for (size_t z = 0; z < lines.size(); ++z) {
    ZoneStep step{
        line_state(lines[z], table, stride, slip_at_turn), false, {}, z < states.size() ? &states[z] : nullptr, cycle};
    const std::vector<int32_t>& status = step.state.status;
    const bool touches = std::any_of(status.begin(), status.end(), [](int32_t s) { return s != C2D_OPEN; });
    step.contact = touches && !lines[z].tied;
    if (step.contact) step.edges = find_contact_edges(step.state);
    Quantities list(lines[z].zone, out);
    for (const MeasureRow& row : kRows)
      if (row.of_zone != nullptr) row.of_zone(step, list);
  }
  Quantities all(0, out);
  if (!lines.empty()) all.add(Measure::kDissipated, dissipated);
  const bool tied = std::all_of(lines.begin(), lines.end(), [](const ZoneLine& line) { return line.tied; });
  for (size_t b = 0; b < bodies.size(); ++b)
    for (const MeasureRow& row : kRows)
      if (bodies[b].is_rigid != 0 && row.of_body != nullptr) row.of_body({bodies[b], static_cast<int32_t>(b) + 1, tied}, all);
  drop_round_off(states, out);
  return out;
}

RoundOff round_off(const std::vector<Quantity>& all, double size) {
  RoundOff out{0.0, size};
  for (const Quantity& q : all)
    if (q.what == Measure::kForceX || q.what == Measure::kForceY) out.force = std::max(out.force, std::fabs(q.value));
  return out;
}

double RoundOff::of(Measure what) const {
  const Unit unit = row_of(what).unit;
  if (unit == Unit::kForce) return 1e-10 * force;
  if (what == Measure::kMoment) return 1e-10 * force * size;
  return unit == Unit::kLength ? 1e-15 * size : 0.0;
}

double RoundOff::shown(Measure what, double value, double error) const {
  return std::fabs(value) <= of(what) || std::fabs(value) <= 0.01 * error ? 0.0 : value;
}

double shown_value(Measure what, double value, double along) {
  const bool is_place = what == Measure::kContactEdge || what == Measure::kStickBorder;
  return is_place && std::isfinite(along) ? along : value;
}

const MeasureRow& row_of(Measure what) { return kRows[static_cast<size_t>(what)]; }

const char* name_of(Measure what) { return static_cast<size_t>(what) < kMeasures ? row_of(what).name : ""; }

const MeasureRow* find_measure(const char* name) {
  for (const MeasureRow& row : kRows)
    if ((row.of_zone != nullptr || row.of_body != nullptr) && std::strcmp(row.name, name) == 0) return &row;
  return nullptr;
}

} // namespace app
