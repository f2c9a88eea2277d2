#include "post/quantities.hpp"

#include "post/edges.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

class Collector {
public:
  explicit Collector(int32_t zone, std::vector<Quantity>& out) : zone_(zone), out_(out) {}
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

struct Peak {
  double s, value;
  double above = 0; // height of the node above the straight line between its neighbours
};

// The vertex of the parabola through the largest of what pairs have and its neighbours; at an end of the contact or a corner,
// where there is no smooth top, the largest itself.
Peak find_peak(const LineState& state, const std::vector<double>& values) {
  const ZoneLine& line = state.line;
  const int32_t n = static_cast<int32_t>(line.size());
  const size_t top = static_cast<size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  const Peak node{line.s[top], values[top]};
  const int32_t i = static_cast<int32_t>(top);
  if (line.corner[top] != 0 || (!line.round && (i == 0 || i == n - 1)) || n < 3) return node;
  const size_t before = static_cast<size_t>((i + n - 1) % n), after = static_cast<size_t>((i + 1) % n);
  if (state.status[before] == C2D_OPEN || state.status[after] == C2D_OPEN) return node;
  double a = line.s[before] - node.s, b = line.s[after] - node.s;
  if (i == 0) a -= line.length;
  if (i == n - 1) b += line.length;
  const double slope_a = (values[before] - node.value) / a, slope_b = (values[after] - node.value) / b;
  const double curvature = (slope_b - slope_a) / (b - a), slope = slope_a - curvature * a;
  if (curvature >= 0) return node; // three equal values
  const double at = -slope / (2 * curvature);
  return {node.s + at, node.value + slope * at / 2, curvature * a * b};
}

// Length of what touches: between the edges, and up to the ends of the side where contact goes on to them.
double touching_length(const LineState& state, const std::vector<ContactEdge>& edges) {
  const ZoneLine& line = state.line;
  if (line.size() == 0) return 0;
  const bool first = state.status.front() != C2D_OPEN, last = state.status.back() != C2D_OPEN;
  double sum = 0;
  for (const ContactEdge& edge : edges) sum += edge.direction * edge.s;
  // What no edge bounds: the ends of the side; round a closed side, a stretch that goes on across the place where s begins.
  bool begins = false, ends = false;
  for (const ContactEdge& edge : edges) {
    if (edge.last == 0 && edge.direction < 0) begins = true;
    if (edge.last == static_cast<int32_t>(line.size()) - 1 && edge.direction > 0) ends = true;
  }
  if (line.round) return edges.empty() ? line.length : first && last ? sum + line.length : sum;
  if (first && !begins) sum -= line.end[0].s;
  if (last && !ends) sum += line.end[1].s;
  return sum;
}

// A length round a closed side from 0 on.
double along(const ZoneLine& line, double s) {
  s = told_place(s, line.length);
  return line.round ? s - line.length * std::floor(s / line.length) : s;
}

void add_place(const ZoneLine& line, double s, Quantity& q) {
  line.place(s, q.at);
  q.s = along(line, s);
}

void add_pressures(const LineState& state, const std::vector<ContactEdge>& edges, Collector& out) {
  const Peak peak = find_peak(state, state.tn);
  add_place(state.line, peak.s, out.add(Measure::kPeakPressure, peak.value));
  double force = 0, friction = 0;
  for (size_t i = 0; i < state.tn.size(); ++i)
    force += state.line.weight[i] * state.tn[i], friction += state.line.weight[i] * state.tt[i];
  const double length = touching_length(state, edges);
  if (length > 0) out.add(Measure::kMeanPressure, force / length);
  if (std::any_of(state.tt.begin(), state.tt.end(), [](double tt) { return tt != 0; }))
    out.add(Measure::kFrictionForce, friction);
}

double spacing_at(const ZoneLine& line, double s) {
  const auto place = static_cast<size_t>(std::lower_bound(line.s.begin(), line.s.end(), s) - line.s.begin());
  const size_t low = place > 2 ? place - 2 : 0, high = std::min(place + 2, line.size() - 1);
  return high > low ? (line.s[high] - line.s[low]) / static_cast<double>(high - low) : line.length;
}

Quantity& add_between(const ZoneLine& line, Measure what, double s, size_t i, Collector& out) {
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

void add_edges(const LineState& state, const std::vector<ContactEdge>& edges, Collector& out) {
  for (size_t i = 0; i < edges.size(); ++i)
    add_between(state.line, Measure::kContactEdge, edges[i].s, i, out).at_corner = edges[i].at_corner;
  const std::vector<double> borders = find_stick_borders(state);
  for (size_t i = 0; i < borders.size(); ++i) {
    Quantity& q = add_between(state.line, Measure::kStickBorder, borders[i], i, out);
    q.spacing += mean_spacing(state, edges); // the start of slip depends on the history of the contact
  }
  for (const Measure what : {Measure::kEdgePressure, Measure::kEdgeFriction})
    for (size_t i = 0; i < edges.size(); ++i) {
      const EdgeValue found = what == Measure::kEdgePressure ? edge_pressure(state, edges[i]) : edge_friction(state, edges[i]);
      if (!std::isfinite(found.value)) continue;
      Quantity& q = out.add(what, found.value, static_cast<int32_t>(i) + 1);
      q.doubt = found.doubt;
      add_place(state.line, edges[i].s, q);
    }
}

// Of how far the largest slip stands above its neighbours: where the contact grew slip is not smooth from node to node.
constexpr double kOfStanding = 0.5;

// Where nothing has slipped there is none. It is largest within the contact, or at an edge, between nodes.
void add_slip_range(const LineState& state, const std::vector<ContactEdge>& edges, Collector& out) {
  std::vector<double> sizes(state.slip.size(), 0.0);
  for (size_t i = 0; i < sizes.size(); ++i)
    if (state.status[i] != C2D_OPEN) sizes[i] = std::fabs(state.slip[i]);
  const Peak peak = find_peak(state, sizes);
  if (!(peak.value > 0)) return;
  EdgeValue largest{peak.value, kOfStanding * peak.above};
  double at = peak.s;
  for (const ContactEdge& edge : edges)
    if (const EdgeValue slip = edge_slip(state, edge); slip.value > largest.value) largest = slip, at = edge.s;
  Quantity& q = out.add(Measure::kSlipRange, largest.value);
  q.doubt = largest.doubt;
  add_place(state.line, at, q);
}

// Motions of rigid bodies and platens, and without a contact the motion along the force that drives them.
void add_motions(const std::vector<c2d_body_state>& bodies, bool contact, Collector& out) {
  for (size_t b = 0; b < bodies.size(); ++b) {
    const c2d_body_state& state = bodies[b];
    const auto item = static_cast<int32_t>(b) + 1;
    if (state.is_rigid == 0) continue;
    const double force = std::hypot(state.contact[0], state.contact[1]);
    if (!contact && force > 0) // the contact balances the driving force
      out.add(Measure::kApproach, -(state.motion[0] * state.contact[0] + state.motion[1] * state.contact[1]) / force, item);
    const Measure of[] = {Measure::kMotionX, Measure::kMotionY, Measure::kRotation};
    for (size_t i = 0; i < 3; ++i) out.add(of[i], state.motion[i], item);
  }
}

} // namespace

std::vector<Quantity> quantities_of(const std::vector<ZoneLine>& lines, const double* table, int64_t stride,
                                    const std::vector<c2d_zone_state>& states, double dissipated,
                                    const std::vector<double>& slip_at_turn, const std::vector<c2d_body_state>& bodies) {
  std::vector<Quantity> out;
  for (size_t z = 0; z < lines.size(); ++z) {
    Collector zone(lines[z].zone, out);
    const LineState state = line_state(lines[z], table, stride, slip_at_turn);
    const bool touches = std::any_of(state.status.begin(), state.status.end(), [](int32_t s) { return s != C2D_OPEN; });
    const bool contact = touches && !lines[z].tied;
    if (contact) {
      const std::vector<ContactEdge> edges = find_contact_edges(state);
      add_pressures(state, edges, zone);
      add_edges(state, edges, zone);
      add_slip_range(state, edges, zone);
    }
    if (z >= states.size()) continue;
    zone.add(Measure::kForceX, states[z].force[0]);
    zone.add(Measure::kForceY, states[z].force[1]);
    zone.add(Measure::kMoment, states[z].moment);
    if (!lines[z].tied) zone.add(Measure::kDissipated, states[z].dissipated);
    if (!contact || lines[z].self) continue;
    zone.add(Measure::kApproach, states[z].approach);
    zone.add(Measure::kShift, states[z].shift);
  }
  Collector all(0, out);
  if (!lines.empty()) all.add(Measure::kDissipated, dissipated);
  add_motions(bodies, std::any_of(lines.begin(), lines.end(), [](const ZoneLine& line) { return !line.tied; }), all);
  return out;
}

const char* name_of(Measure what) {
  switch (what) {
  case Measure::kPeakPressure: return "peak pressure";
  case Measure::kMeanPressure: return "mean pressure";
  case Measure::kContactEdge: return "contact edge";
  case Measure::kStickBorder: return "stick border";
  case Measure::kForceX: return "force x";
  case Measure::kForceY: return "force y";
  case Measure::kMoment: return "moment";
  case Measure::kApproach: return "approach";
  case Measure::kShift: return "shift";
  case Measure::kDissipated: return "dissipated";
  case Measure::kEdgePressure: return "edge pressure";
  case Measure::kEdgeFriction: return "edge friction";
  case Measure::kSlipRange: return "slip range";
  case Measure::kFrictionForce: return "friction force";
  case Measure::kMotionX: return "motion x";
  case Measure::kMotionY: return "motion y";
  case Measure::kRotation: return "rotation";
  }
  return "";
}

} // namespace app
