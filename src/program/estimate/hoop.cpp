// Stress along the surface of a body (METHOD-MESHES, "Stress along a surface"). Phases:
//   1. Find the edges of contacts that slip up to the edge.
//   2. There, extrapolate stress plus pressure, which is smooth inside the contact, to the edge by a least-squares parabola.
//   3. Elsewhere take nodal values, and the vertex of the parabola through the largest node and its neighbours.
//   4. Combine both to the largest and smallest values and the largest range.
#include "program/estimate/hoop.hpp"

#include "program/sketch/place_ends.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

// Elements used from an edge inwards, or fewer if slip ends before. The first two are disturbed by the mesh.
constexpr size_t kBehind = 8, kFewer = 6, kDisturbed = 2;
constexpr double kScatter = 2;      // error of the extrapolated value over the scatter of the data
constexpr double kSameBound = 0.1;  // relative difference of friction over pressure in slipping elements
constexpr double kPressed = 1e-3;   // of the largest pressure: smaller pressures count as zero
constexpr size_t kShadow = 2;       // elements beside an edge whose nodal values are not used
constexpr double kOfStanding = 0.1; // times the height of a node above the line between its neighbours: unresolved part
constexpr double kSmooth = 0.02;    // relative difference of the adjacent elements above which the boundary is not smooth

struct HoopElement {
  const sketch::MeshedCurve* curve;
  double from, to;
  size_t before, after; // neighbours on the outline; its own number: none
  bool wanted;
  double length() const { return to - from; }
  sketch::Point at(double f) const { return curve->curve->shape->at(curve->measure.u_at(from + f * (to - from))); }
  sketch::Point tangent(double f) const { return curve->curve->shape->tangent(curve->measure.u_at(from + f * (to - from))); }
};

// An edge of a contact.
struct HoopEdge {
  size_t element; // containing the edge
  double s;       // length along its curve
  bool up;        // contact follows in the order of the elements
  double root;    // pressure at a small distance inside over the root of the distance; 0: unknown
};

// The stress at an edge in one state.
struct EdgeStress {
  HoopEdge edge;
  Along stress;
};

class HoopFinder {
public:
  HoopFinder(const sketch::Mesh& mesh, const Trial& trial, const std::vector<State>& states, const sketch::Side& side,
             size_t first);
  Hoop run();
  Hoop run_zz();
  PressureAt pressure_at(sketch::Point near) const;
  std::vector<SurfaceCycle> cycles(double poisson_ratio);
  std::vector<RubbedPlace> rubbed() const;

private:
  double field(size_t state, Field f, size_t element, double at) const;
  double pressure(size_t state, size_t element, double at, double* friction = nullptr) const;
  double smooth_part(size_t state, size_t element) const;
  size_t next(size_t element, bool up) const { return up ? elements_[element].after : elements_[element].before; }
  bool find_place(sketch::Point at, HoopEdge& out) const;
  std::vector<HoopEdge> edges_of(size_t state) const;
  bool find_stress(size_t state, const HoopEdge& edge, EdgeStress& out) const;
  void find_edges();
  bool find_beside(const std::vector<double>& v, size_t element, size_t node, bool up, double& value, double& away) const;
  sketch::Point place_beside(size_t element, size_t node, double away) const;
  Along top_at(const std::vector<double>& v, size_t element, size_t node) const;
  void take_nodes(Field stress, Hoop& out) const;
  void take_edges(Hoop& out) const;
  double value_at(size_t state, const HoopEdge& edge, double* doubt, int* way) const;
  SurfaceCycle cycle_at_node(size_t element, size_t node) const;
  SurfaceCycle cycle_at_edge(const EdgeStress& edge, double poisson_ratio) const;
  bool is_edge_of(size_t state, const HoopEdge& edge) const;
  void beside_edge(size_t state, const HoopEdge& place, sketch::Point along, double& hoop, sketch::Point& traction,
                   double& doubt) const;

  const Trial& trial_;
  const std::vector<State>& states_;
  const size_t body_, first_;
  std::vector<HoopElement> elements_;
  std::vector<double> largest_;                 // largest pressure per state
  std::vector<std::vector<HoopEdge>> edges_;    // per state, from `first_` on
  std::vector<std::vector<EdgeStress>> stress_; // likewise
  std::vector<char> shadowed_;                  // elements next to edges, at turns of the loads, with extrapolated stresses
};

HoopFinder::HoopFinder(const sketch::Mesh& mesh, const Trial& trial, const std::vector<State>& states, const sketch::Side& side,
                       size_t first)
    : trial_(trial), states_(states), body_(static_cast<size_t>(side.body)), first_(first) {
  for (const sketch::MeshedOutline& outline : mesh.bodies[body_]) {
    const size_t begin = elements_.size();
    for (const sketch::MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e) {
        const size_t i = elements_.size();
        elements_.push_back(
            {&curve, curve.ends[e], curve.ends[e + 1], i == begin ? i : i - 1, i + 1, side.has(curve.curve->name)});
      }
    if (elements_.size() == begin) continue;
    const size_t last = elements_.size() - 1;
    elements_[last].after = outline.open ? last : begin;
    if (!outline.open) elements_[begin].before = last;
  }
  shadowed_.assign(elements_.size(), 0);
}

// Value in an element at a coordinate from 0 to 1, linear between the adjacent nodes.
double HoopFinder::field(size_t state, Field f, size_t element, double at) const {
  const std::vector<double>& v = states_[state].ends[body_][f];
  const auto n = static_cast<size_t>(trial_.nodes);
  if (n == 1) return v[element];
  const double place = std::clamp(at, 0.0, 1.0) * static_cast<double>(n - 1);
  const size_t i = std::min(static_cast<size_t>(place), n - 2);
  const double part = place - static_cast<double>(i);
  return (1 - part) * v[element * n + i] + part * v[element * n + i + 1];
}

double HoopFinder::pressure(size_t state, size_t element, double at, double* friction) const {
  const sketch::Point along = elements_[element].at(1) - elements_[element].at(0),
                      t{field(state, kTx, element, at), field(state, kTy, element, at)};
  const double size = sketch::length(along);
  if (friction != nullptr) *friction = sketch::dot(t, along) / size;
  return std::fabs(sketch::cross(along, t)) / size;
}

// Mean over an element of the stress along the surface plus the pressure. The strain of an element is already a mean. The
// square of the pressure is taken as linear, which is accurate next to an edge; this applies to both contributions of the
// pressure.
double HoopFinder::smooth_part(size_t state, size_t element) const {
  const double p = pressure(state, element, 0.5), a = pressure(state, element, 0), b = pressure(state, element, 1),
               mean = trial_.nodes == 1 ? p : 2.0 / 3 * (a * a + a * b + b * b) / (a + b), across = trial_.across[body_];
  return field(state, kHoop, element, 0.5) + across * p + (1 - across) * mean;
}

// The place of the body's boundary next to a point of the other side, which may be farther away than an element is long; false:
// it is not on the requested curves.
bool HoopFinder::find_place(sketch::Point at, HoopEdge& out) const {
  double least = HUGE_VAL, s = 0, off = 0;
  out = {elements_.size(), 0, false, 0};
  const sketch::MeshedCurve* curve = nullptr;
  for (size_t e = 0; e < elements_.size(); ++e) {
    if (elements_[e].curve != curve) {
      curve = elements_[e].curve;
      s = sketch::nearest_length(*curve, at);
      off = sketch::length(curve->curve->shape->at(curve->measure.u_at(s)) - at);
    }
    if (off < least && s >= elements_[e].from && s <= elements_[e].to) least = off, out = {e, s, false, 0};
  }
  return out.element < elements_.size() && elements_[out.element].wanted;
}

// Edges of the contacts of this body on the requested curves.
std::vector<HoopEdge> HoopFinder::edges_of(size_t state) const {
  std::vector<HoopEdge> out;
  for (const app::Quantity& q : states_[state].quantities) {
    if (q.what != app::Measure::kContactEdge || q.at_corner || std::isnan(q.at[0])) continue;
    const auto& zone = trial_.zones[static_cast<size_t>(q.zone) - 1];
    if (zone[0].body != static_cast<int32_t>(body_) && zone[1].body != static_cast<int32_t>(body_)) continue;
    HoopEdge edge{};
    if (!find_place({q.at[0], q.at[1]}, edge)) continue; // not on these curves
    edge.up = pressure(state, next(edge.element, true), 0.5) > pressure(state, next(edge.element, false), 0.5);
    for (const app::Quantity& p : states_[state].quantities)
      if (p.what == app::Measure::kEdgePressure && p.zone == q.zone && p.item == q.item) edge.root = p.value;
    out.push_back(edge);
  }
  return out;
}

// Least-squares parabola or straight line through y(x): its value at 0 and the mean deviation.
struct Fit {
  double at_zero = 0, scatter = 0;
  Fit(const std::vector<double>& x, const std::vector<double>& y, size_t count, int degree);
};

Fit::Fit(const std::vector<double>& x, const std::vector<double>& y, size_t count, int degree) {
  double a[3][4] = {}, c[3] = {};
  const int n = degree + 1;
  const double unit = x[count - 1]; // scales x to 1
  for (size_t k = 0; k < count; ++k)
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) a[i][j] += std::pow(x[k] / unit, i + j);
      a[i][3] += std::pow(x[k] / unit, i) * y[k];
    }
  for (int i = n - 1; i > 0; --i) // the constant last
    for (int k = 0; k < i; ++k) {
      const double f = a[k][i] / a[i][i];
      for (int j = 0; j < i; ++j) a[k][j] -= f * a[i][j];
      a[k][3] -= f * a[i][3];
    }
  for (int i = 0; i < n; ++i) {
    c[i] = a[i][3];
    for (int j = 0; j < i; ++j) c[i] -= a[i][j] * c[j];
    c[i] /= a[i][i];
  }
  at_zero = c[0];
  for (size_t k = 0; k < count; ++k)
    scatter += std::pow(y[k] - c[0] - (c[1] + c[2] * x[k] / unit) * x[k] / unit, 2) / static_cast<double>(count);
  scatter = std::sqrt(scatter);
}

// Stress plus pressure is smooth inside a contact that slips up to its edge, and the pressure vanishes there: the parabola
// through the means over elements gives the stress at the edge. False: the contact sticks in these elements.
bool HoopFinder::find_stress(size_t state, const HoopEdge& edge, EdgeStress& out) const {
  const HoopElement& own = elements_[edge.element];
  double begin = edge.up ? own.to - edge.s : edge.s - own.from; // distance of the next element from the edge
  const bool with_own = begin > 0.5 * own.length();
  if (with_own) begin -= own.length();
  size_t e = with_own ? edge.element : next(edge.element, edge.up);
  std::vector<double> x, y;
  double bound = 0;
  for (size_t k = 0; k < kBehind; ++k, e = next(e, edge.up)) {
    double friction = 0;
    const double p = pressure(state, e, 0.5, &friction), length = elements_[e].length();
    if (k == 1) bound = friction / p;
    const bool slips = k == 0 || std::fabs(friction / p - bound) <= kSameBound * std::fabs(bound) + kPressed;
    if (!(p > kPressed * largest_[state]) || (k > 0 && e == edge.element) || !slips) break;
    if (k >= kDisturbed) x.push_back(begin + length / 2), y.push_back(smooth_part(state, e));
    begin += length;
  }
  if (x.size() < kFewer - kDisturbed) return false;
  const bool all = x.size() == kBehind - kDisturbed;
  const Fit fit(x, y, all ? x.size() : kFewer - kDisturbed, 2), other(x, y, kFewer - kDisturbed, all ? 2 : 1);
  const double doubt = std::max(std::fabs(fit.at_zero - other.at_zero), kScatter * fit.scatter);
  out = {edge, {fit.at_zero, doubt, own.at((edge.s - own.from) / own.length()), static_cast<int>(x.size())}};
  return true;
}

void HoopFinder::find_edges() {
  for (size_t state = 0; state < states_.size(); ++state) {
    largest_.push_back(0);
    stress_.emplace_back();
    for (const app::Quantity& q : states_[state].quantities)
      if (q.what == app::Measure::kPeakPressure) largest_.back() = std::max(largest_.back(), q.value);
    edges_.emplace_back();
    if (state < first_) continue;
    edges_.back() = edges_of(state);
    for (const HoopEdge& edge : edges_.back()) {
      EdgeStress stress;
      if (!find_stress(state, edge, stress)) continue;
      stress_.back().push_back(stress);
      for (const bool up : {false, true}) {
        if (!states_[state].turn) break; // only turns: between them edges move past places with peaks elsewhere
        size_t e = edge.element;
        for (size_t k = 0; k <= kShadow; ++k, e = next(e, up)) shadowed_[e] = 1;
      }
    }
  }
}

// Value and distance of the neighbour of a node. False: the boundary does not continue smoothly.
bool HoopFinder::find_beside(const std::vector<double>& v, size_t e, size_t i, bool up, double& value, double& away) const {
  const auto n = static_cast<size_t>(trial_.nodes);
  size_t other = e, j = i;
  if (n > 1 && i == (up ? n - 1 : 0)) {
    other = next(e, up), j = up ? 0 : n - 1;
    if (other == e || !elements_[other].wanted || shadowed_[other] != 0) return false;
    if (std::fabs(v[other * n + j] - v[e * n + i]) > kSmooth * std::fabs(v[e * n + i])) return false;
  }
  if (n == 1) return false;
  value = v[other * n + (up ? j + 1 : j - 1)];
  away = (up ? 1 : -1) * elements_[other].length() / static_cast<double>(n - 1);
  return true;
}

sketch::Point HoopFinder::place_beside(size_t e, size_t i, double away) const {
  const auto n = static_cast<double>(trial_.nodes);
  const double s = (n == 1 ? 0.5 : static_cast<double>(i) / (n - 1)) * elements_[e].length() + away;
  const bool before = s < 0;
  const bool after = s > elements_[e].length();
  const HoopElement& own = elements_[before || after ? next(e, after) : e];
  return own.at((before ? own.length() + s : after ? s - elements_[e].length() : s) / own.length());
}

// The vertex of the parabola through the largest node and its neighbours, because the largest value of two meshes may be at the
// same node.
Along HoopFinder::top_at(const std::vector<double>& v, size_t e, size_t i) const {
  const double most = v[e * static_cast<size_t>(trial_.nodes) + i];
  double before = 0, after = 0, a = 0, b = 0;
  if (!find_beside(v, e, i, false, before, a) || !find_beside(v, e, i, true, after, b)) return {most, 0, place_beside(e, i, 0)};
  const double slope_a = (before - most) / a, slope_b = (after - most) / b, curvature = (slope_b - slope_a) / (b - a),
               slope = slope_a - curvature * a;
  if (curvature >= 0) return {most, 0, place_beside(e, i, 0)};
  const double at = std::clamp(-slope / (2 * curvature), a, b);
  return {most + (slope + curvature * at) * at, kOfStanding * curvature * a * b, place_beside(e, i, at)};
}

void HoopFinder::take_nodes(Field stress, Hoop& out) const {
  const auto n = static_cast<size_t>(trial_.nodes);
  std::vector<double> high(elements_.size() * n, -HUGE_VAL), below = high, range = high; // below: minus the smallest
  const auto most = [&](const std::vector<double>& v) {                                  // over the nodes in use
    size_t best = v.size();
    for (size_t k = 0; k < v.size(); ++k)
      if (elements_[k / n].wanted && shadowed_[k / n] == 0 && (best == v.size() || v[k] > v[best])) best = k;
    return best;
  };
  for (size_t k = 0; k < high.size(); ++k) {
    for (size_t state = first_; state < states_.size(); ++state) {
      const double v = states_[state].ends[body_][stress][k];
      high[k] = std::max(high[k], v), below[k] = std::max(below[k], -v);
    }
    range[k] = high[k] + below[k];
  }
  const size_t tops[3] = {most(high), most(below), most(range)};
  if (tops[0] == high.size()) return;
  out.any = true;
  out.high = top_at(high, tops[0] / n, tops[0] % n);
  out.low = top_at(below, tops[1] / n, tops[1] % n), out.low.value = -out.low.value;
  out.widest = top_at(range, tops[2] / n, tops[2] % n);
}

// The stress of a state at the edge of another state; it may be an edge in both.
double HoopFinder::value_at(size_t state, const HoopEdge& edge, double* doubt, int* way) const {
  const HoopElement& own = elements_[edge.element];
  for (const EdgeStress& s : stress_[state])
    if (s.edge.up == edge.up && elements_[s.edge.element].curve == own.curve && std::fabs(s.edge.s - edge.s) < own.length()) {
      *doubt += s.stress.doubt, *way = s.stress.way;
      return s.stress.value;
    }
  *way = 0;
  return field(state, kHoop, edge.element, (edge.s - own.from) / own.length());
}

void HoopFinder::take_edges(Hoop& out) const {
  for (size_t state = first_; state < states_.size(); ++state)
    for (const EdgeStress& s : stress_[state]) {
      if (s.stress.value > out.high.value) out.high = s.stress;
      if (s.stress.value < out.low.value) out.low = s.stress;
      out.any = true;
      if (!states_[state].turn) continue;
      double low = HUGE_VAL, high = -HUGE_VAL, doubt_low = 0, doubt_high = 0;
      int way_low = 0, way_high = 0;
      for (size_t k = first_; k < states_.size(); ++k) {
        double doubt = 0;
        int way = 0;
        const double v = value_at(k, s.edge, &doubt, &way);
        if (v < low) low = v, doubt_low = doubt, way_low = way;
        if (v > high) high = v, doubt_high = doubt, way_high = way;
      }
      if (high - low > out.widest.value)
        out.widest = {high - low, doubt_low + doubt_high, s.stress.at, std::min(way_low, way_high)};
    }
}

PressureAt HoopFinder::pressure_at(sketch::Point near) const {
  PressureAt out;
  const size_t last = states_.size() - 1;
  double least = HUGE_VAL;
  for (size_t e = 0; e < elements_.size(); ++e) {
    const HoopElement& element = elements_[e];
    if (!element.wanted) continue;
    out.largest = std::max({out.largest, pressure(last, e, 0), pressure(last, e, 1)});
    const double s = std::clamp(sketch::nearest_length(*element.curve, near), element.from, element.to),
                 f = (s - element.from) / element.length(), off = sketch::length(element.at(f) - near);
    if (off < least) least = off, out.at = element.at(f), out.value = pressure(last, e, f);
  }
  return out;
}

// The stress tensor of a boundary point from the stress along the boundary, the traction and the stress out of the plane.
app::StressState tensor_of(double hoop, sketch::Point traction, double zz, sketch::Point t) {
  const sketch::Point n{t.y, -t.x}; // outwards: the material is on the left
  const double across = sketch::dot(traction, n), shear = sketch::dot(traction, t);
  return {hoop * t.x * t.x + across * n.x * n.x + 2 * shear * t.x * n.x,
          hoop * t.y * t.y + across * n.y * n.y + 2 * shear * t.y * n.y,
          hoop * t.x * t.y + across * n.x * n.y + shear * (t.x * n.y + t.y * n.x), zz};
}

SurfaceCycle HoopFinder::cycle_at_node(size_t e, size_t i) const {
  const auto n = static_cast<size_t>(trial_.nodes);
  const HoopElement& own = elements_[e];
  const double f = n == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(n - 1);
  SurfaceCycle out;
  out.at = own.at(f), out.along = own.tangent(f);
  out.curve = own.curve, out.length = own.from + f * own.length(), out.element = own.length();
  for (const State& state : states_) {
    const auto& ends = state.ends[body_];
    const size_t k = e * n + i;
    out.cycle.push_back(tensor_of(ends[kHoop][k], {ends[kTx][k], ends[kTy][k]}, ends[kSzz][k], out.along));
  }
  return out;
}

// Is it, or nearly, an edge in this state?
bool HoopFinder::is_edge_of(size_t state, const HoopEdge& edge) const {
  return std::any_of(edges_[state].begin(), edges_[state].end(), [&](const HoopEdge& e) {
    return e.up == edge.up && elements_[e.element].curve == elements_[edge.element].curve &&
           std::fabs(e.s - edge.s) < 0.5 * elements_[edge.element].length();
  });
}

// At a place beside the edge of a state, closer than an element: inside the pressure grows as the root of the distance and is
// missing in the stress along the surface; outside the stress falls by twice the friction that there would be inside.
void HoopFinder::beside_edge(size_t state, const HoopEdge& place, sketch::Point along, double& hoop, sketch::Point& traction,
                             double& doubt) const {
  constexpr double kOfRoot = 0.1; // of that pressure: the doubt of these laws
  for (const EdgeStress& s : stress_[state]) {
    const HoopEdge& edge = s.edge;
    const double depth = edge.up ? place.s - edge.s : edge.s - place.s, p = edge.root * std::sqrt(std::fabs(depth));
    if (edge.up != place.up || elements_[edge.element].curve != elements_[place.element].curve ||
        std::fabs(depth) >= elements_[place.element].length())
      continue;
    double friction = 0;
    const double inside = pressure(state, next(edge.element, edge.up), 0.5, &friction), ratio = friction / inside;
    hoop -= depth > 0 ? p : std::copysign(2 * std::fabs(ratio) * p, hoop);
    if (depth > 0) traction = (ratio * p) * along - p * sketch::Point{along.y, -along.x};
    doubt += kOfRoot * p;
    return;
  }
}

// At an edge of a state the traction vanishes. The stress out of the plane changes by Poisson's ratio times the stress along
// the surface.
SurfaceCycle HoopFinder::cycle_at_edge(const EdgeStress& s, double poisson_ratio) const {
  const HoopElement& own = elements_[s.edge.element];
  const double f = (s.edge.s - own.from) / own.length();
  SurfaceCycle out;
  out.at = s.stress.at, out.along = own.tangent(f), out.way = s.stress.way;
  out.curve = own.curve, out.length = s.edge.s, out.element = own.length();
  const sketch::Point normal{out.along.y, -out.along.x};
  for (size_t k = 0; k < states_.size(); ++k) {
    double doubt = 0;
    int way = 0;
    double hoop = value_at(k, s.edge, &doubt, &way);
    const double plain = field(k, kHoop, s.edge.element, f);
    const sketch::Point force{field(k, kTx, s.edge.element, f), field(k, kTy, s.edge.element, f)};
    sketch::Point traction = way > 0 || is_edge_of(k, s.edge) ? sketch::Point{} : force;
    if (way > 0) beside_edge(k, s.edge, out.along, hoop, traction, doubt);
    const auto zz = [&](double along) {
      return field(k, kSzz, s.edge.element, f) + poisson_ratio * (along - plain + sketch::dot(traction - force, normal));
    };
    const double other = hoop + std::copysign(doubt, hoop);
    out.cycle.push_back(tensor_of(hoop, traction, zz(hoop), out.along));
    out.other.push_back(tensor_of(other, traction, zz(other), out.along));
  }
  return out;
}

std::vector<SurfaceCycle> HoopFinder::cycles(double poisson_ratio) {
  std::vector<SurfaceCycle> out;
  if (states_.empty()) return out;
  find_edges();
  for (size_t e = 0; e < elements_.size(); ++e)
    for (size_t i = 0; elements_[e].wanted && shadowed_[e] == 0 && i < static_cast<size_t>(trial_.nodes); ++i)
      out.push_back(cycle_at_node(e, i));
  for (size_t k = 0; k < states_.size(); ++k)
    for (const EdgeStress& s : stress_[k])
      if (states_[k].turn) out.push_back(cycle_at_edge(s, poisson_ratio));
  return out;
}

// The pairs on the requested curves, with what they saw in the cycle.
std::vector<RubbedPlace> HoopFinder::rubbed() const {
  std::vector<RubbedPlace> out;
  for (size_t p = 0; p < states_.front().rubbing.size(); ++p) {
    const Rubbing& first = states_.front().rubbing[p];
    const auto& zone = trial_.zones[static_cast<size_t>(first.zone) - 1];
    HoopEdge at{};
    if (zone[0].body != static_cast<int32_t>(body_) && zone[1].body != static_cast<int32_t>(body_)) continue;
    if (!find_place({first.x, first.y}, at)) continue;
    const HoopElement& own = elements_[at.element];
    const double f = (at.s - own.from) / own.length();
    RubbedPlace place{own.at(f), own.curve, at.s, own.length(), 0, 0, -HUGE_VAL};
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t k = 0; k < states_.size(); ++k) {
      place.along = std::max(place.along, field(k, kHoop, at.element, f));
      const Rubbing& now = states_[k].rubbing[p];
      if (!(now.pressure > 0)) continue;
      place.friction = std::max(place.friction, std::fabs(now.friction));
      low = std::min(low, now.slip), high = std::max(high, now.slip);
    }
    place.slip = std::max(0.0, high - low);
    out.push_back(place);
  }
  return out;
}

Hoop HoopFinder::run() {
  Hoop out;
  out.high.value = -HUGE_VAL, out.low.value = HUGE_VAL, out.widest.value = -1;
  if (first_ >= states_.size()) return out;
  find_edges();
  take_nodes(kHoop, out);
  take_edges(out);
  return out;
}

Hoop HoopFinder::run_zz() {
  Hoop out;
  if (first_ < states_.size()) take_nodes(kSzz, out);
  return out;
}

} // namespace

PressureAt find_pressure(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, sketch::Point near) {
  return HoopFinder(mesh, trial, trial.states, side, 0).pressure_at(near);
}

std::vector<SurfaceCycle> surface_cycles(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side,
                                         double poisson_ratio) {
  return HoopFinder(mesh, trial, trial.cycle, side, 0).cycles(poisson_ratio);
}

std::vector<RubbedPlace> rubbed_places(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side) {
  if (trial.cycle.empty()) return {};
  return HoopFinder(mesh, trial, trial.cycle, side, 0).rubbed();
}

Hoop find_zz(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, size_t first) {
  return HoopFinder(mesh, trial, trial.states, side, first).run_zz();
}

Hoop find_hoop(const sketch::Mesh& mesh, const Trial& trial, const sketch::Side& side, size_t first) {
  return HoopFinder(mesh, trial, trial.states, side, first).run();
}

} // namespace estimate
