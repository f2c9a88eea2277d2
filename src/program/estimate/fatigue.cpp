// Fatigue parameters of the last cycle. Phases of a request:
//   1. Along curves: the stresses of the cycle at every node and at edges of slipping contacts (hoop.cpp) give a parameter
//   each;
//      the largest is that of an edge, or the vertex of the parabola through a node and its neighbours.
//   2. Below a surface: stresses at points on the inward normal of that place, found by another solution of the history.
//   3. The parameter of the stresses at one depth, of their mean, or the range of the stress intensity of a crack.
#include "program/estimate/fatigue.hpp"

#include "post/fatigue/criteria.hpp"
#include "post/fatigue/depths.hpp"
#include "program/estimate/hoop.hpp"
#include "program/sketch/deck/cycle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>

namespace estimate {
namespace {

using sketch::FatigueKind;
using sketch::FatiguePlace;
using sketch::Want;
using sketch::WantOf;

constexpr double kOfTop = 0.1;        // times the height of the parabola above its neighbours: the doubt of its vertex
constexpr double kSmoothTop = 0.02;   // relative difference at one place above which the parameter jumps there
constexpr double kNoParameter = 0.01; // of the parameter of the largest stress component: errors refer to no less

bool is_rubbing(FatigueKind kind) { return kind == FatigueKind::kRuiz1 || kind == FatigueKind::kRuiz2; }

app::FatigueCriterion criterion_of(FatigueKind kind) {
  switch (kind) {
  case FatigueKind::kFatemiSocie: return app::FatigueCriterion::kFatemiSocie;
  case FatigueKind::kFindley: return app::FatigueCriterion::kFindley;
  case FatigueKind::kCrossland: return app::FatigueCriterion::kCrossland;
  case FatigueKind::kDangVan: return app::FatigueCriterion::kDangVan;
  default: return app::FatigueCriterion::kSwt; // also where a crack is assumed
  }
}

app::FatigueMaterial fatigue_material(const sketch::Body& body) {
  const sketch::FatigueConstants& c = body.fatigue;
  return {body.youngs_modulus, body.poisson_ratio, c.fatemi_socie / c.yield, c.findley, c.crossland, c.dang_van};
}

// The size of a parameter where a stress of this size is alone.
double parameter_of_size(FatigueKind kind, const app::FatigueMaterial& m, double stress) {
  if (kind == FatigueKind::kSwt) return stress * stress / m.youngs_modulus;
  return kind == FatigueKind::kFatemiSocie ? stress / m.youngs_modulus : stress;
}

double largest_in(const app::StressCycle& cycle) {
  double out = 0;
  for (const app::StressState& s : cycle) out = std::max({out, std::fabs(s.xx), std::fabs(s.yy), std::fabs(s.xy)});
  return out;
}

// A parameter at a place of a surface.
struct FatigueSpot {
  sketch::Point at, along;
  const sketch::MeshedCurve* curve;
  double length, element; // along the curve; of its element
  double value = 0, doubt = 0, angle = NAN, stress = 0;
  int way = 0;
};

class FatigueCurve {
public:
  FatigueCurve(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial, const Want& want);
  bool any() const { return !spots_.empty(); }
  FatigueSpot largest();
  std::vector<std::array<double, 2>> points(const sketch::Mesh& mesh, const sketch::Side& side);

private:
  void take_rubbed(const std::vector<RubbedPlace>& places, FatigueKind kind);
  const FatigueSpot& at(size_t k);
  const FatigueSpot* neighbour_of(size_t spot, bool up);
  FatigueSpot vertex_at(size_t spot);

  app::FatigueCriterion criterion_;
  app::FatigueMaterial material_;
  std::vector<SurfaceCycle> cycles_; // of the spots, unless they are rubbed
  std::vector<FatigueSpot> spots_;   // values are found where they are needed
  std::vector<char> known_;
};

FatigueCurve::FatigueCurve(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial, const Want& want)
    : criterion_(criterion_of(want.fatigue.kind)), material_(fatigue_material(sketch.bodies[static_cast<size_t>(want.body)])) {
  const FatigueKind kind = want.fatigue.kind;
  if (is_rubbing(kind)) {
    take_rubbed(rubbed_places(mesh, trial, *want.side), kind);
    return;
  }
  cycles_ = surface_cycles(mesh, trial, *want.side, sketch.plane_stress ? 0 : material_.poisson_ratio);
  for (const SurfaceCycle& c : cycles_) {
    spots_.push_back({c.at, c.along, c.curve, c.length, c.element});
    spots_.back().way = c.way;
  }
  known_.assign(spots_.size(), 0);
}

void FatigueCurve::take_rubbed(const std::vector<RubbedPlace>& places, FatigueKind kind) {
  for (const RubbedPlace& p : places) {
    FatigueSpot spot{p.at, {}, p.curve, p.length, p.element};
    spot.value = p.friction * p.slip * (kind == FatigueKind::kRuiz2 ? std::max(0.0, p.along) : 1);
    spots_.push_back(spot);
  }
  std::stable_sort(spots_.begin(), spots_.end(), [](const FatigueSpot& a, const FatigueSpot& b) {
    return a.curve != b.curve ? std::less<>()(a.curve, b.curve) : a.length < b.length;
  });
  known_.assign(spots_.size(), 1);
}

// A spot with its value.
const FatigueSpot& FatigueCurve::at(size_t k) {
  FatigueSpot& spot = spots_[k];
  if (known_[k] != 0) return spot;
  known_[k] = 1;
  const SurfaceCycle& c = cycles_[k];
  const app::FatigueValue value = app::fatigue_value(criterion_, c.cycle, material_);
  spot.value = value.value, spot.angle = value.angle, spot.stress = largest_in(c.cycle);
  if (!c.other.empty()) spot.doubt = std::fabs(app::fatigue_value(criterion_, c.other, material_).value - value.value);
  return spot;
}

// The neighbour of a spot on one side of it; null: there is none, or the parameter jumps at the spot.
const FatigueSpot* FatigueCurve::neighbour_of(size_t spot, bool up) {
  const FatigueSpot& own = at(spot);
  for (size_t k = spot; up ? ++k < spots_.size() : k-- > 0;) {
    const FatigueSpot& other = spots_[k];
    const double away = std::fabs(other.length - own.length);
    if (other.curve != own.curve || other.way > 0 || away > 1.5 * std::max(own.element, other.element)) return nullptr;
    if (away > 1e-9 * own.element) return &at(k);
    if (std::fabs(at(k).value - own.value) > kSmoothTop * std::fabs(own.value)) return nullptr;
  }
  return nullptr;
}

// The vertex of the parabola through a value and its neighbours.
FatigueSpot FatigueCurve::vertex_at(size_t spot) {
  FatigueSpot out = at(spot);
  if (out.way > 0) return out;
  const FatigueSpot *before = neighbour_of(spot, false), *after = neighbour_of(spot, true);
  if (before == nullptr || after == nullptr) return out;
  const double a = before->length - out.length, b = after->length - out.length, slope_a = (before->value - out.value) / a,
               slope_b = (after->value - out.value) / b, curvature = (slope_b - slope_a) / (b - a),
               slope = slope_a - curvature * a;
  if (curvature >= 0) return out;
  const double place = std::clamp(-slope / (2 * curvature), a, b);
  out.value += (slope + curvature * place) * place;
  out.doubt = std::fabs(kOfTop * curvature * a * b);
  const double u = out.curve->measure.u_at(out.length + place);
  out.at = out.curve->curve->shape->at(u), out.along = out.curve->curve->shape->tangent(u);
  return out;
}

// The parameter is found in the order of its bounds, until no other can be larger.
FatigueSpot FatigueCurve::largest() {
  std::vector<std::pair<double, size_t>> order; // bound, spot
  for (size_t k = 0; k < spots_.size(); ++k)
    order.emplace_back(known_[k] != 0 ? spots_[k].value : app::fatigue_bound(criterion_, cycles_[k].cycle, material_), k);
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  size_t most = order.front().second;
  for (const auto& [bound, k] : order) {
    if (bound <= at(most).value) break;
    if (at(k).value > at(most).value) most = k;
  }
  return vertex_at(most);
}

// Distances along all curves of a side, one curve after another, and values.
std::vector<std::array<double, 2>> FatigueCurve::points(const sketch::Mesh& mesh, const sketch::Side& side) {
  std::vector<std::array<double, 2>> out;
  double begin = 0;
  for (const sketch::MeshedOutline& outline : mesh.bodies[static_cast<size_t>(side.body)])
    for (const sketch::MeshedCurve& curve : outline.curves) {
      if (!side.has(curve.curve->name)) continue;
      for (size_t k = 0; k < spots_.size(); ++k)
        if (spots_[k].curve == &curve) out.push_back({begin + spots_[k].length, at(k).value});
      begin += curve.ends.back();
    }
  std::stable_sort(out.begin(), out.end(), [](const auto& p, const auto& q) { return p[0] < q[0]; });
  return out;
}

// Depths below the surface and weights of the stresses there.
std::vector<app::DepthWeight> depths_of(const Want& want) {
  const double depth = want.fatigue.depth;
  if (want.fatigue.kind == FatigueKind::kCrack) return app::edge_crack(depth);
  if (want.fatigue.place == FatiguePlace::kMean) return app::mean_over_depth(depth);
  return {{depth, 1}};
}

bool is_below(const Want& want) {
  return want.of == WantOf::kFatigue &&
         (want.fatigue.place == FatiguePlace::kDepth || want.fatigue.place == FatiguePlace::kMean);
}

size_t count_of_points(const sketch::Sketch& sketch) { // of the demand
  return static_cast<size_t>(std::count_if(sketch.wants.begin(), sketch.wants.end(), [](const Want& want) {
    return want.of == WantOf::kFatigue && want.fatigue.place == FatiguePlace::kPoint;
  }));
}

sketch::Point point_below(const FatigueSpot& spot, double depth) { // the material is on the left
  return {spot.at.x - depth * spot.along.y, spot.at.y + depth * spot.along.x};
}

app::StressState state_at(const State& state, size_t place) {
  const auto& s = state.inside[place];
  return {s[2], s[3], s[4], s[5]};
}

// " of top", " of top at depth 0.01": after the name of the parameter.
std::string where_of(const Want& want) {
  std::string out = " of " + want.side->names[0];
  if (want.fatigue.place == FatiguePlace::kSurface) return out;
  char depth[40];
  std::snprintf(depth, sizeof depth, "%g", want.fatigue.depth);
  const bool is_crack = want.fatigue.kind == FatigueKind::kCrack;
  return out + (is_crack ? ", depth " : want.fatigue.place == FatiguePlace::kMean ? ", mean to depth " : " at depth ") + depth;
}

app::Stated stated_of(const Want& want, double value, double scale, double tolerance, sketch::Point at) {
  app::Stated s;
  s.what = sketch::fatigue_rows()[static_cast<size_t>(want.fatigue.kind)].what;
  s.body = static_cast<int32_t>(want.body) + 1;
  s.value = value, s.scale = std::max(scale, std::fabs(value)), s.tolerance = tolerance;
  s.at[0] = at.x, s.at[1] = at.y;
  if (want.side) s.of = where_of(want);
  return s;
}

// The range of the stress intensity of a crack on the inward normal of a spot; a crack that is closed has none.
double crack_range(const app::StressCycle& intensities, const FatigueSpot& spot) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const app::StressState& s : intensities) {
    const sketch::Point t = spot.along;
    const double k = std::max(0.0, s.xx * t.x * t.x + s.yy * t.y * t.y + 2 * s.xy * t.x * t.y);
    low = std::min(low, k), high = std::max(high, k);
  }
  return high - low;
}

// In the order of the requests.
std::vector<Place> places_below(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  std::vector<Place> out;
  for (const Want& want : sketch.wants) {
    if (!is_below(want)) continue;
    FatigueCurve curve(sketch, mesh, trial, want);
    if (!curve.any()) continue;
    const FatigueSpot top = curve.largest();
    for (const app::DepthWeight& d : depths_of(want)) {
      const sketch::Point at = point_below(top, d.depth);
      out.push_back({want.body + 1, at.x, at.y});
    }
  }
  return out;
}

} // namespace

void ask_for_cycle(const sketch::Sketch& sketch, CycleDemand& demand) {
  demand = CycleDemand();
  for (const Want& want : sketch.wants) {
    if (want.of != WantOf::kFatigue) continue;
    demand.from = sketch::cycle_start(sketch);
    demand.rubbing = demand.rubbing || is_rubbing(want.fatigue.kind);
    if (want.fatigue.place == FatiguePlace::kPoint) {
      demand.points.push_back({want.body + 1, want.where.x, want.where.y});
    } else if (std::find(demand.bodies.begin(), demand.bodies.end(), want.body + 1) == demand.bodies.end()) {
      demand.bodies.push_back(want.body + 1);
    }
  }
}

void ask_below(const sketch::Sketch& sketch, const sketch::Mesh& mesh, CycleDemand& demand) {
  if (demand.from == 0) return;
  demand.from = sketch::cycle_start(sketch);
  if (std::any_of(sketch.wants.begin(), sketch.wants.end(), is_below))
    demand.below = [&](const Trial& trial) { return places_below(sketch, mesh, trial); };
}

std::vector<app::FatigueLine> fatigue_lines(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  std::vector<app::FatigueLine> out;
  for (const Want& want : sketch.wants) {
    if (want.of != WantOf::kFatigue || want.fatigue.place != FatiguePlace::kSurface || trial.cycle.empty()) continue;
    const app::Measure what = sketch::fatigue_rows()[static_cast<size_t>(want.fatigue.kind)].what;
    out.push_back({what, static_cast<int32_t>(want.body) + 1, want.side->names[0],
                   FatigueCurve(sketch, mesh, trial, want).points(mesh, *want.side)});
  }
  return out;
}

void FatigueValues::add(const Want& want, const LeastSizes& least, double tolerance, std::vector<app::Stated>& out) {
  if (trial_.cycle.empty() || trial_.outcome != C2D_REACHED) return;
  const FatigueKind kind = want.fatigue.kind;
  const app::FatigueMaterial m = fatigue_material(sketch_.bodies[static_cast<size_t>(want.body)]);
  const auto put = [&](const app::StressCycle& cycle, sketch::Point at) {
    const app::FatigueValue v = app::fatigue_value(criterion_of(kind), cycle, m);
    const double stress = std::max(least.stress, kNoParameter * largest_in(cycle));
    out.push_back(stated_of(want, v.value, parameter_of_size(kind, m, stress), tolerance, at));
    out.back().angle = v.angle;
  };
  if (want.fatigue.place == FatiguePlace::kPoint) {
    app::StressCycle cycle;
    for (const State& state : trial_.cycle) cycle.push_back(state_at(state, points_));
    ++points_;
    return put(cycle, want.where);
  }
  FatigueCurve curve(sketch_, mesh_, trial_, want);
  if (!curve.any()) return;
  const FatigueSpot top = curve.largest();
  if (want.fatigue.place == FatiguePlace::kSurface) {
    const double stress = std::max(least.stress, kNoParameter * top.stress);
    double scale = parameter_of_size(kind, m, stress);
    if (is_rubbing(kind)) scale = least.stress * least.motion * (kind == FatigueKind::kRuiz2 ? least.stress : 1);
    out.push_back(stated_of(want, top.value, scale, tolerance, top.at));
    out.back().angle = top.angle, out.back().doubt = top.doubt, out.back().way = top.way;
    return;
  }
  const std::vector<app::DepthWeight> depths = depths_of(want);
  const size_t first = count_of_points(sketch_) + below_;
  app::StressCycle cycle;
  for (const State& state : trial_.cycle) {
    app::StressState sum;
    for (size_t i = 0; i < depths.size(); ++i) sum = sum + depths[i].weight * state_at(state, first + i);
    cycle.push_back(sum);
  }
  below_ += depths.size();
  if (!cycle.empty() && std::isnan(cycle.front().zz)) {
    char text[160];
    std::snprintf(text, sizeof text, "%g below (%g, %g) is not inside the body, expected a smaller depth", want.fatigue.depth,
                  top.at.x, top.at.y);
    throw sketch::Fault{want.at, text};
  }
  if (kind == FatigueKind::kCrack)
    out.push_back(stated_of(want, crack_range(cycle, top), kNoParameter * largest_in(cycle), tolerance, top.at));
  else
    put(cycle, want.fatigue.place == FatiguePlace::kDepth ? point_below(top, want.fatigue.depth) : top.at);
}

} // namespace estimate
