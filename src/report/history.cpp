#include "report/history.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

// Is this the step nearest to `part` of `parts` of all?
bool is_nearest(int32_t step, int32_t steps, int32_t part, int32_t parts) {
  return step == (static_cast<int64_t>(steps) * part + parts / 2) / parts;
}

bool is_at_quarter(int32_t step, int32_t steps) {
  return step < steps && (is_nearest(step, steps, 1, 4) || is_nearest(step, steps, 2, 4) || is_nearest(step, steps, 3, 4));
}

// Do the loads reverse at `from`, on the way from `before` to `to`?
bool goes_back(const std::vector<double>& before, const std::vector<double>& from, const std::vector<double>& to) {
  double product = 0;
  for (size_t k = 0; k < to.size(); ++k) product += (from[k] - (k < before.size() ? before[k] : 0.0)) * (to[k] - from[k]);
  return product < 0;
}

ZonePoint zone_point(const FollowedZone& zone, const c2d_step& step) {
  const auto row = [&step](int32_t p) { return step.table + p * int64_t{step.stride}; };
  const auto shift = [&row](int32_t p) { return row(p)[C2D_UT2] - row(p)[C2D_UT1]; };
  ZonePoint out{0, 0, 0, 0};
  if (zone.pair >= 0) out.shift = shift(zone.pair), out.tn = row(zone.pair)[C2D_TN], out.tt = row(zone.pair)[C2D_TT];
  for (const int32_t p : zone.touched) out.mean += shift(p) / static_cast<double>(zone.touched.size());
  return out;
}

// Tractions within a thousandth of the largest pressure.
bool is_same_state(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0, apart = 0;
  for (size_t at = 0; at + C2D_PAIR_FIELDS <= std::min(a.size(), b.size()); at += C2D_PAIR_FIELDS) {
    largest = std::max(largest, std::fabs(a[at + C2D_TN]));
    for (const size_t k : {size_t{C2D_TN}, size_t{C2D_TT}}) apart = std::max(apart, std::fabs(a[at + k] - b[at + k]));
  }
  return apart <= 1e-3 * largest;
}

} // namespace

bool History::is_frame(int32_t step) const {
  for (int32_t part = 1; part <= kMostFrames; ++part)
    if (is_nearest(step, steps_, part, kMostFrames)) return true;
  return false;
}

void History::note_reversal(CoefficientHistory& c, Snapshot now) {
  if (!c.last.loads.empty() && goes_back(c.before.loads, c.last.loads, now.loads)) {
    c.reversals.push_back(c.last);
    if (c.reversals.size() > kMostReversals) c.reversals.erase(c.reversals.begin());
  }
  c.before.loads = c.last.loads;
  c.last = std::move(now);
}

std::vector<const PathPoint*> points_of_cycle(const CoefficientHistory& history) {
  std::vector<const PathPoint*> out;
  for (size_t i = history.cycle; history.cycle > 0 && i < history.points.size(); ++i) out.push_back(&history.points[i]);
  return out.size() > 1 ? out : std::vector<const PathPoint*>{};
}

std::vector<const Snapshot*> earlier_states(const CoefficientHistory& history, int32_t last_step,
                                            const std::vector<double>& table) {
  std::vector<const Snapshot*> some, out;
  for (const Snapshot& s : history.reversals.empty() ? history.frames : history.reversals)
    if (!history.reversals.empty() || (s.is_quarter && s.step != last_step)) some.push_back(&s);
  for (auto s = some.rbegin(); s != some.rend(); ++s) { // of equal ones the latest
    bool is_new = !is_same_state((*s)->table, table);
    for (const Snapshot* kept : out) is_new = is_new && !is_same_state((*s)->table, kept->table);
    if (is_new) out.insert(out.begin(), *s);
  }
  return out;
}

CoefficientHistory& History::history_of(const c2d_step& step) {
  const size_t index = step.coefficient > 0 ? static_cast<size_t>(step.coefficient) - 1 : 0;
  if (coefficients_.size() <= index) coefficients_.resize(index + 1);
  coefficients_[index].mu = step.mu;
  return coefficients_[index];
}

PathPoint History::point_of(const CoefficientHistory& c, const c2d_step& step) {
  PathPoint now;
  now.step = step.step;
  now.kind = step.kind;
  now.load = step.load;
  now.travel = c.points.empty() ? 0.0 : c.points.back().travel;
  for (size_t k = 0; k < c.loads.size(); ++k) now.travel += std::fabs(step.loads[k] - c.loads[k]);
  now.events = (c.points.empty() ? 0 : c.points.back().events) + (step.kind == C2D_STEP_CHANGE ? 1 : 0);
  const size_t pairs = static_cast<size_t>(step.pairs);
  const bool keep_status = status_bytes_ + pairs <= kMostStatusBytes;
  if (keep_status) now.status.resize(pairs);
  for (size_t p = 0; p < pairs; ++p) {
    const double* row = step.table + static_cast<int64_t>(p) * step.stride;
    const int status = static_cast<int>(row[C2D_STATUS]);
    if (status >= 0 && status < 3) ++now.count[status];
    if (status != C2D_TIED) now.peak = std::max(now.peak, row[C2D_TN]);
    if (keep_status) now.status[p] = static_cast<char>(status);
  }
  if (keep_status) status_bytes_ += pairs;
  for (const FollowedZone& zone : c.followed) now.zones.push_back(zone_point(zone, step));
  return now;
}

void History::note_cycle(const c2d_step& step, std::vector<FollowedZone> followed) {
  CoefficientHistory& c = history_of(step);
  if (c.points.empty()) return;
  if (c.points.back().kind == C2D_STEP_CYCLE) { // the cycle before was not the last one
    status_bytes_ -= c.points.back().status.size();
    c.points.pop_back();
  }
  c.followed = std::move(followed);
  c.cycle = c.points.size();
  c.points.push_back(point_of(c, step));
}

void History::note(const c2d_step& step) {
  CoefficientHistory& c = history_of(step);
  c.loads.resize(static_cast<size_t>(step.cases));
  const PathPoint now = point_of(c, step);
  c.loads.assign(step.loads, step.loads + step.cases);
  c.points.push_back(now);
  if (step.kind == C2D_STEP_CHANGE) return;
  c.energy.push_back({now.travel, step.load, step.work, step.dissipated, step.elastic, step.energy_defect});
  if (step.kind != C2D_STEP_RECORDED) return;
  Snapshot kept;
  kept.step = step.step;
  kept.load = step.load;
  kept.loads.assign(step.loads, step.loads + step.cases);
  for (size_t p = 0; p < static_cast<size_t>(step.pairs); ++p) {
    const double* row = step.table + static_cast<int64_t>(p) * step.stride;
    kept.table.insert(kept.table.end(), row, row + C2D_PAIR_FIELDS);
  }
  kept.is_quarter = is_at_quarter(step.step, steps_);
  if (is_frame(step.step)) c.frames.push_back(kept);
  note_reversal(c, std::move(kept));
}

std::vector<const Snapshot*> frames_of(const CoefficientHistory& history) {
  std::vector<const Snapshot*> out;
  for (const std::vector<Snapshot>* some : {&history.frames, &history.reversals})
    for (const Snapshot& s : *some) out.push_back(&s);
  if (!history.last.table.empty()) out.push_back(&history.last);
  std::stable_sort(out.begin(), out.end(), [](const Snapshot* a, const Snapshot* b) { return a->step < b->step; });
  const auto is_same = [](const Snapshot* a, const Snapshot* b) { return a->step == b->step; };
  out.erase(std::unique(out.begin(), out.end(), is_same), out.end());
  return out;
}

bool rises(const CoefficientHistory& history) {
  if (history.loads.size() > 1) return false;
  double last = 0.0;
  for (const PathPoint& p : history.points) {
    if (p.load < last) return false;
    last = p.load;
  }
  return last > 0.0;
}

std::vector<double> positions_by_step(const CoefficientHistory& history) {
  std::vector<double> out;
  const std::vector<PathPoint>& points = history.points;
  double start = 0.0;
  for (size_t first = 0; first < points.size();) {
    size_t end = first + 1;
    while (end < points.size() && points[end].step == points[first].step) ++end;
    const double whole = points[end - 1].travel - start;
    for (size_t i = first; i < end; ++i) {
      const double by_count = static_cast<double>(i - first + 1) / static_cast<double>(end - first);
      const double part = whole > 0.0 ? (points[i].travel - start) / whole : by_count;
      out.push_back(points[i].step - 1 + part);
    }
    start = points[end - 1].travel;
    first = end;
  }
  return out;
}

} // namespace app
