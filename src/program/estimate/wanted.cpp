// Values of the stresses and displacements requested by a sketch: at points inside, along curves, their ranges over the history
// or over its last cycle. The order of the values is the same on every mesh.
#include "program/estimate/wanted.hpp"

#include "program/estimate/fatigue.hpp"
#include "program/estimate/hoop.hpp"
#include "program/sketch/deck/cycle.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

using app::Measure;
using sketch::Want;
using sketch::WantOf;

constexpr Measure kStresses[3] = {Measure::kStressXX, Measure::kStressYY, Measure::kStressXY},
                  kRanges[3] = {Measure::kRangeXX, Measure::kRangeYY, Measure::kRangeXY},
                  kCycles[3] = {Measure::kCycleXX, Measure::kCycleYY, Measure::kCycleXY},
                  kDisplacements[2] = {Measure::kDisplacementX, Measure::kDisplacementY};

// On an axis the round-off of a coordinate becomes 0.
template <class At> void put_place(const At& at, app::Stated& s) {
  const double size = std::hypot(at.x, at.y);
  s.at[0] = app::told_place(at.x, size), s.at[1] = app::told_place(at.y, size);
}

app::Stated number(Measure what, size_t body, double value, double scale, double tolerance) {
  app::Stated s;
  s.what = what;
  s.body = static_cast<int32_t>(body) + 1;
  s.value = value, s.scale = scale, s.tolerance = tolerance;
  return s;
}

// What displacements and stresses in a body must exceed not to be round-off: of the largest motion of all bodies, and of the
// stress that it means along the body's boundary.
constexpr double kOfLargestMotion = 1e-10;
double least_displacement(const Trial& trial) {
  double largest = 0;
  for (const State& state : trial.states) {
    for (const auto& ends : state.ends)
      for (const Field f : {kUx, kUy})
        for (const double u : ends[f]) largest = std::max(largest, std::fabs(u));
    for (const app::Quantity& q : state.quantities)
      if (q.what == Measure::kMotionX || q.what == Measure::kMotionY) largest = std::max(largest, std::fabs(q.value));
  }
  return kOfLargestMotion * largest;
}
double least_stress(const Trial& trial, size_t body) {
  double boundary = 0;
  for (const double length : trial.lengths[body]) boundary += length;
  return boundary > 0 ? trial.stiffness[body] * least_displacement(trial) / boundary : 0;
}

// Range of a stress over states.
struct Range {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void take(double v) { low = std::min(low, v), high = std::max(high, v); }
  double size() const { return high - low; }
  double largest() const { return std::max(std::fabs(low), std::fabs(high)); }
};

// The stress out of the plane at a place at the end and its range from state `first` on; for a cycle only the range.
void add_zz(std::vector<app::Stated>& out, const Trial& trial, const Want& want, size_t place, double tolerance, size_t first) {
  Range range;
  double largest = least_stress(trial, static_cast<size_t>(want.body));
  for (size_t i = first; i < trial.states.size(); ++i) range.take(trial.states[i].inside[place][5]);
  if (first >= trial.states.size()) return;
  largest = std::max(largest, range.largest());
  const auto add = [&](Measure what, double value) {
    out.push_back(number(what, static_cast<size_t>(want.body), value, largest, tolerance));
    put_place(want.where, out.back());
  };
  if (!want.cycle) add(Measure::kStressZZ, trial.states.back().inside[place][5]);
  add(want.cycle ? Measure::kCycleZZ : Measure::kRangeZZ, range.size());
}

// The three stresses at a place at the end and their ranges from state `first` on; for a cycle only the ranges.
void add_place(std::vector<app::Stated>& out, const Trial& trial, const Want& want, size_t place, double tolerance,
               size_t first) {
  Range range[3];
  double largest = least_stress(trial, static_cast<size_t>(want.body));
  for (size_t i = first; i < trial.states.size(); ++i)
    for (size_t c = 0; c < 3; ++c) range[c].take(trial.states[i].inside[place][c + 2]);
  for (const Range& r : range) largest = std::max(largest, r.largest());
  const auto add = [&](Measure what, double value) {
    out.push_back(number(what, static_cast<size_t>(want.body), value, largest, tolerance));
    put_place(want.where, out.back());
  };
  for (size_t c = 0; c < 3 && first < trial.states.size(); ++c) {
    if (!want.cycle) add(kStresses[c], trial.states.back().inside[place][c + 2]);
    add(want.cycle ? kCycles[c] : kRanges[c], range[c].size());
  }
}

// Displacements at a place at the end.
void add_displacements(std::vector<app::Stated>& out, const Trial& trial, size_t body, sketch::Point at, size_t place,
                       double tolerance) {
  double largest = least_displacement(trial);
  for (const State& state : trial.states)
    largest = std::max(largest, std::hypot(state.inside[place][0], state.inside[place][1]));
  for (size_t c = 0; c < 2 && !trial.states.empty(); ++c) {
    out.push_back(number(kDisplacements[c], body, trial.states.back().inside[place][c], largest, tolerance));
    put_place(at, out.back());
  }
}

// The relative motion of two points at the end: along the line from the first to the second, n, and across it, t = (ny, -nx).
void add_pair(std::vector<app::Stated>& out, const Trial& trial, const Want& want, size_t place, double tolerance) {
  const sketch::Point line = want.to - want.where, n = (1 / sketch::length(line)) * line, t{n.y, -n.x};
  const auto apart = [&](const State& s) {
    return sketch::Point{s.inside[place][0] - s.inside[place + 1][0], s.inside[place][1] - s.inside[place + 1][1]};
  };
  double largest = least_displacement(trial);
  for (const State& state : trial.states) largest = std::max(largest, sketch::length(apart(state)));
  if (trial.states.empty()) return;
  const sketch::Point u = apart(trial.states.back());
  const std::pair<Measure, double> both[] = {{Measure::kApproachOf, sketch::dot(u, n)},
                                             {Measure::kShiftOf, -sketch::dot(u, t)}};
  for (const auto& [what, value] : both) {
    out.push_back(number(what, static_cast<size_t>(want.body), value, largest, tolerance));
    put_place(want.where, out.back());
  }
}

// For a cycle only the range.
void add_hoop(std::vector<app::Stated>& out, const sketch::Mesh& mesh, const Trial& trial, const Want& want, double tolerance,
              size_t first) {
  const Hoop hoop = want.is_zz ? find_zz(mesh, trial, *want.side, first) : find_hoop(mesh, trial, *want.side, first);
  if (!hoop.any) return;
  const auto add = [&](Measure what, const Along& a) {
    const double scale = std::max(
        {std::fabs(hoop.high.value), std::fabs(hoop.low.value), least_stress(trial, static_cast<size_t>(want.side->body))});
    out.push_back(number(what, static_cast<size_t>(want.side->body), a.value, scale, tolerance));
    out.back().of = want.side->names[0];
    put_place(a.at, out.back());
    out.back().doubt = a.doubt, out.back().way = a.way;
  };
  if (want.is_zz && want.cycle) return add(Measure::kCycleZZOn, hoop.widest);
  if (want.is_zz)
    return add(Measure::kLargestZZ, hoop.high), add(Measure::kSmallestZZ, hoop.low), add(Measure::kRangeZZOn, hoop.widest);
  if (want.cycle) return add(Measure::kCycleAlong, hoop.widest);
  add(Measure::kLargestAlong, hoop.high), add(Measure::kSmallestAlong, hoop.low), add(Measure::kRangeAlong, hoop.widest);
}

// The state at which the last cycle of the history begins; past the last state if the history ended before the cycle.
size_t state_of_cycle(const sketch::Sketch& sketch, const Trial& trial) {
  const int start = sketch::cycle_start(sketch);
  int turns = 0;
  for (size_t i = 0; i < trial.states.size() && trial.outcome == C2D_REACHED; ++i)
    if (trial.states[i].turn && ++turns == start) return i;
  return trial.states.size();
}

// At the end.
void add_pressure(std::vector<app::Stated>& out, const sketch::Mesh& mesh, const Trial& trial, const Want& want,
                  double tolerance) {
  if (trial.states.empty()) return;
  const PressureAt pressure = find_pressure(mesh, trial, *want.side, want.where);
  const auto body = static_cast<size_t>(want.side->body);
  const double scale = std::max(pressure.largest, least_stress(trial, body));
  out.push_back(number(Measure::kPressureOn, body, pressure.value, scale, tolerance));
  out.back().of = want.side->names[0];
  put_place(pressure.at, out.back());
}

double tolerance_of(const sketch::Sketch& sketch, const sketch::WantRow& row) {
  if (sketch.wants.empty()) return row.by_default ? sketch.tolerance : NAN;
  double least = NAN;
  for (const Want& want : sketch.wants)
    if (want.word == row.word && want.of == row.of) least = std::fmin(least, want.tolerance.value_or(sketch.tolerance));
  return least;
}

// Of what friction dissipates in the whole history: slip of a cycle in less than an element is seen by no mesh.
constexpr double kOfHistory = 0.1;
constexpr double kNoLoss = 0.01; // of the same: what a smaller energy is compared with

// Does the largest pressure of some contact change from turn to turn of the last cycle, which begins with state `first`?
constexpr double kSamePressure = 0.9;
bool is_pressed_by_turns(const Trial& trial, size_t first) {
  for (size_t z = 0; z < trial.zones.size(); ++z) {
    double least = HUGE_VAL, most = 0;
    for (size_t i = first; i < trial.states.size(); ++i) {
      if (!trial.states[i].turn) continue;
      const double pressure = peak_pressure(trial.states[i], static_cast<int32_t>(z) + 1);
      least = std::min(least, pressure), most = std::max(most, pressure);
    }
    if (trial.tied[z] == 0 && least < kSamePressure * most) return true;
  }
  return false;
}

// Energy dissipated by friction in the last cycle. Relative to itself where it is asked for, else to that of the whole history.
void add_cycle_energy(std::vector<app::Stated>& out, const sketch::Sketch& sketch, const Trial& trial, size_t first) {
  if (first >= trial.states.size() || trial.states.back().dissipated <= 0) return;
  const double energy = trial.states.back().dissipated - trial.states[first].dissipated;
  const double tolerance = tolerance_of(sketch, sketch::want_row("loss"));
  const State& end = trial.states.back();
  const double least = kNoLoss * end.dissipated;
  const double scale = std::isnan(tolerance) ? end.dissipated : std::max(std::fabs(energy), least);
  out.push_back(number(Measure::kCycleDissipated, 0, energy, scale, tolerance));
  out.back().body = 0;
  out.back().unseen = kOfHistory * end.dissipated;
  out.back().other_rule = is_pressed_by_turns(trial, first);
}

// Points given only by a stress statement, without a tolerance.
std::vector<sketch::WantedPoint> not_wanted(const sketch::Sketch& sketch) {
  std::vector<sketch::WantedPoint> out;
  for (const sketch::WantedPoint& p : sketch.points)
    if (std::none_of(sketch.wants.begin(), sketch.wants.end(), [&](const Want& w) {
          return w.of == WantOf::kPoints && w.body == p.body && w.where.x == p.at.x && w.where.y == p.at.y;
        }))
      out.push_back(p);
  return out;
}

// Stresses and displacements at these points at the end; they have no tolerance.
void add_points(std::vector<app::Stated>& out, const sketch::Sketch& sketch, const Trial& trial, size_t place) {
  for (const sketch::WantedPoint& p : not_wanted(sketch)) {
    const auto body = static_cast<size_t>(p.body);
    add_displacements(out, trial, body, p.at, place, NAN);
    double largest = least_stress(trial, body);
    for (const State& state : trial.states)
      for (size_t c = 2; c < 5; ++c) largest = std::max(largest, std::fabs(state.inside[place][c]));
    for (size_t c = 0; c < 3 && !trial.states.empty(); ++c) {
      out.push_back(number(kStresses[c], body, trial.states.back().inside[place][c + 2], largest, NAN));
      put_place(p.at, out.back());
    }
    ++place;
  }
}

// Fatigue parameters of the last cycle.
void add_fatigue(std::vector<app::Stated>& out, const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  FatigueValues values(sketch, mesh, trial);
  for (const Want& want : sketch.wants) {
    if (want.of != WantOf::kFatigue) continue;
    const size_t before = out.size();
    values.add(want, {least_stress(trial, static_cast<size_t>(want.body)), least_displacement(trial)},
               want.tolerance.value_or(sketch.tolerance), out);
    for (size_t i = before; i < out.size(); ++i) put_place(sketch::Point{out[i].at[0], out[i].at[1]}, out[i]);
  }
}

} // namespace

double tolerance_of(const sketch::Sketch& sketch, const app::Stated& s, const Trial& trial) {
  if (s.zone > 0 && trial.tied[static_cast<size_t>(s.zone) - 1] != 0) return NAN;
  if (s.is_unbounded() && sketch.wants.empty()) return NAN; // nobody asked for this one by name
  for (const sketch::WantRow& row : sketch::wants())
    if (std::count(row.quantities.begin(), row.quantities.end(), s.what) > 0)
      return row.of_whole && s.zone > 0 ? NAN : tolerance_of(sketch, row);
  return NAN;
}

void ask(const sketch::Sketch& sketch, Demand& demand) {
  for (const Want& want : sketch.wants) {
    if (want.of == WantOf::kPoints || want.of == WantOf::kPair)
      demand.points.push_back({want.body + 1, want.where.x, want.where.y});
    if (want.of == WantOf::kPair) demand.points.push_back({want.other + 1, want.to.x, want.to.y});
    demand.all_steps = demand.all_steps || want.of == WantOf::kPoints || want.of == WantOf::kCurves;
    demand.hoop = demand.hoop || (want.of == WantOf::kCurves && !want.is_zz);
    demand.zz = demand.zz || (want.of == WantOf::kCurves && want.is_zz);
  }
  ask_for_cycle(sketch, demand.cycle);
  for (const sketch::WantedPoint& p : not_wanted(sketch)) demand.points.push_back({p.body + 1, p.at.x, p.at.y});
}

// Cycles come last: if the history ends early they are missing, and the order of the others is unchanged.
std::vector<app::Stated> wanted_of(const sketch::Sketch& sketch, const sketch::Mesh& mesh, const Trial& trial) {
  std::vector<app::Stated> out;
  for (const bool cycle : {false, true}) {
    const size_t first = cycle ? state_of_cycle(sketch, trial) : 0;
    size_t places = 0;
    for (const Want& want : sketch.wants) {
      const size_t place = places;
      if (want.of == WantOf::kPoints) ++places;
      if (want.of == WantOf::kPair) places += 2;
      if (want.cycle != cycle) continue;
      const double tolerance = want.tolerance.value_or(sketch.tolerance);
      if (want.of == WantOf::kPoints && want.is_zz) {
        add_zz(out, trial, want, place, tolerance, first);
        continue;
      }
      if (want.of == WantOf::kPoints && !cycle)
        add_displacements(out, trial, static_cast<size_t>(want.body), want.where, place, tolerance);
      if (want.of == WantOf::kPoints) add_place(out, trial, want, place, tolerance, first);
      if (want.of == WantOf::kPair) add_pair(out, trial, want, place, tolerance);
      if (want.of == WantOf::kPlaces) add_pressure(out, mesh, trial, want, tolerance);
      if (want.of == WantOf::kCurves) add_hoop(out, mesh, trial, want, tolerance, first);
    }
    if (!cycle) add_points(out, sketch, trial, places);
    if (cycle && sketch::cycle_start(sketch) > 0) add_cycle_energy(out, sketch, trial, first);
  }
  add_fatigue(out, sketch, mesh, trial);
  return out;
}

} // namespace estimate
