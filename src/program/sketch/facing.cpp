// Facing parts of two chains of curves. Phases:
// 1. Sample both chains. For every sample of chain a, find the nearest facing point of chain b (nearest), and accept it if the
//    search back from b finds no nearer point and no other curve lies between (look).
// 2. Where a partner appears, disappears or jumps between neighbouring samples, bisect to locate the limit (fill).
// 3. Join linked neighbours to runs (runs); trim fans of normals at their ends (run_of).
// 4. Repeat with the weight m of METHOD 8.3 from the mean curvatures of each run (facing_runs), then snap ends to curve ends.
// 5. Of a run whose weight has not settled, or that has been divided, keep what it has in common with a search by its own m,
//    until m stays (agree_with_curvatures).
#include "program/sketch/facing.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kFaces = 0.6427876096865394; // cosine of 50 degrees: surfaces with a larger inclination do not face
constexpr double kLinked = 2e-3; // of the other chain: neighbouring points face neighbouring points up to this far apart
constexpr int kJumpDepth = 30, kBorderDepth = 60; // bisections of a jump, of a border
constexpr double kTurnsBack = 1e-9;               // of the other chain: facing points advance against it but for this
constexpr double kLeastRun = 1e-7;                // of the shorter chain
constexpr double kMiddleOfWay = 0.02;             // of the line between two points: its ends lie on the surfaces themselves
constexpr double kSnap = 1e-6;                    // of a run: an end nearer than this to the end of a chain moves there

constexpr int kMostRounds = 3;       // of searches with an updated m
constexpr int kMostWithin = 24;      // of searches within a run
constexpr double kSameNormal = 1e-3; // smaller changes of m are ignored

// The weighted normal along which points face each other.
Point across(Point na, Point nb, double m) { return m * na - (1 - m) * nb; }

struct Partner {
  bool found = false;
  SurfacePoint at;
  double gap = HUGE_VAL;
};

// The zero of a function between two arguments where its signs differ (Illinois method).
template <class Function> double zero_between(double a, double b, double fa, double fb, double nothing, const Function& f) {
  for (int step = 0; step < 60 && std::fabs(fb) > nothing && std::fabs(b - a) > 1e-15 * std::max(1.0, std::fabs(b)); ++step) {
    double x = b - fb * (b - a) / (fb - fa);
    if (!(x >= std::min(a, b) && x <= std::max(a, b))) x = (a + b) / 2;
    const double fx = f(x);
    if ((fx > 0) == (fb > 0))
      fa /= 2;
    else
      a = b, fa = fb;
    b = x, fb = fx;
  }
  return b;
}

class Search {
public:
  Search(const Chain& a, const Chain& b, const FacingLimits& limits, double m) : a_(a), b_(b), limits_(limits), m_(m) {
    for (const Chain* chain : {&a, &b})
      for (const SurfacePoint& p : chain->samples()) size_ = std::max({size_, std::fabs(p.at.x), std::fabs(p.at.y)});
  }
  std::vector<FacingRun> runs();

private:
  struct Look { // the result at one place of chain a
    ChainPlace place = 0;
    Partner partner;
    double length[2] = {0, 0};
  };
  Partner nearest(const Chain& of, const SurfacePoint& from, double m) const;
  Look look(ChainPlace place) const;
  bool is_crossed(Point p, Point q) const;
  bool is_linked(const Look& p, const Look& q) const;
  void fill(const Look& low, const Look& high, int depth);
  FacingRun run_of(const std::vector<Look>& looks, bool ring) const;

  const Chain &a_, &b_;
  const FacingLimits& limits_;
  const double m_;
  double size_ = 0; // of the coordinates
  std::vector<Look> looks_;
};

// The nearest of all places of a chain that face a point.
Partner Search::nearest(const Chain& of, const SurfacePoint& from, double m) const {
  const double tiny = 2e-12 * size_;
  const auto off = [&](const SurfacePoint& to) { return cross(to.at - from.at, across(from.normal, to.normal, m)); };
  Partner best;
  const auto try_place = [&](ChainPlace place) {
    const SurfacePoint to = of.at(place);
    if (dot(from.normal, to.normal) > -kFaces) return;
    const Point way = across(from.normal, to.normal, m);
    const double gap = dot(to.at - from.at, way) / length(way);
    if (gap > -limits_.overlap && std::fabs(gap) < std::fabs(best.gap)) best = {true, to, gap};
  };
  const std::vector<SurfacePoint>& samples = of.samples();
  double before = 0;
  bool begins = true;
  for (size_t i = 0; i < samples.size(); ++i) {
    const double f = off(samples[i]);
    const bool goes_on = of.continues(i);
    if (std::fabs(f) <= tiny && (begins || !goes_on)) {
      try_place(samples[i].place);
    } else if (!begins && (before <= 0) != (f <= 0)) {
      const SurfacePoint &p = samples[i - 1], &q = samples[i];
      if (std::min(dot(from.normal, p.normal), dot(from.normal, q.normal)) < -kFaces + 0.05)
        try_place(zero_between(p.place, q.place, before, f, 1e-3 * tiny, [&](double x) { return off(of.at(x)); }));
    }
    before = f, begins = !goes_on;
  }
  return best;
}

bool Search::is_crossed(Point p, Point q) const {
  const Point d = q - p;
  if (sketch::length(d) <= limits_.clear) return false;
  return std::any_of(limits_.others.begin(), limits_.others.end(), [&](const auto& chord) {
    const Point e = chord.second - chord.first, o = chord.first - p;
    const double det = cross(d, e);
    if (det == 0) return false;
    const double t = cross(o, e) / det, s = cross(o, d) / det;
    return t > kMiddleOfWay && t < 1 - kMiddleOfWay && s > 0 && s < 1;
  });
}

Search::Look Search::look(ChainPlace place) const {
  Look out;
  out.place = place;
  const SurfacePoint from = a_.at(place);
  Partner partner = nearest(b_, from, m_);
  out.length[0] = a_.length_at(place);
  if (!partner.found) return out;
  const Partner back = nearest(a_, partner.at, 1 - m_);
  const double room = 1e-6 * std::fabs(partner.gap) + 1e-9 * limits_.clear + 1e-14 * size_;
  partner.found = back.found && std::fabs(back.gap) >= std::fabs(partner.gap) - room && !is_crossed(from.at, partner.at.at);
  if (partner.found) out.partner = partner, out.length[1] = b_.length_at(partner.at.place);
  return out;
}

// Do neighbouring points face neighbouring points?
bool Search::is_linked(const Look& p, const Look& q) const {
  if (!p.partner.found || !q.partner.found) return false;
  const double way = std::fabs(a_.way(p.length[0], q.length[0])), other = std::fabs(b_.way(p.length[1], q.length[1]));
  if (b_.way(p.length[1], q.length[1]) > kTurnsBack * b_.length()) return false; // beyond a centre of curvature
  return other <= 4 * way + kLinked * b_.length() || a_.is_fan(p.place) || a_.is_fan(q.place);
}

// Bisects between two neighbouring results, if a facing part ends between them or the partner jumps.
void Search::fill(const Look& low, const Look& high, int depth) {
  const bool border = low.partner.found != high.partner.found;
  const double way = std::fabs(a_.way(low.length[0], high.length[0]));
  const double other = std::fabs(b_.way(low.length[1], high.length[1]));
  const bool jump = low.partner.found && high.partner.found && other > 4 * way && other > kLinked * b_.length();
  if (!(border && depth < kBorderDepth) && !(jump && depth < kJumpDepth)) return;
  const ChainPlace middle = (low.place + high.place) / 2;
  if (middle <= low.place || middle >= high.place) return;
  const Look at = look(middle);
  fill(low, at, depth + 1);
  looks_.push_back(at);
  fill(at, high, depth + 1);
}

// A run with continuous lengths where a closed chain passes its start, and without fans at its ends.
FacingRun Search::run_of(const std::vector<Look>& looks, bool ring) const {
  FacingRun out{{&a_, &b_}, {}, ring};
  size_t first = 0, last = looks.size();
  const auto in_fan = [&](size_t i, size_t side) {
    return side == 0 ? a_.is_fan(looks[i].place) : b_.is_fan(looks[i].partner.at.place);
  };
  for (const size_t side : {size_t{0}, size_t{1}}) {
    while (!ring && last - first > 1 && in_fan(first, side) && in_fan(first + 1, side)) ++first;
    while (!ring && last - first > 1 && in_fan(last - 1, side) && in_fan(last - 2, side)) --last;
  }
  for (size_t i = first; i < last; ++i) {
    const Partner& partner = looks[i].partner;
    const SurfacePoint from = a_.at(looks[i].place);
    FacingPoints p{{looks[i].length[0], looks[i].length[1]}, from.at, {from.normal, partner.at.normal}, partner.gap};
    if (!out.points.empty())
      for (size_t side = 0; side < 2; ++side) {
        const double before = out.points.back().length[side];
        p.length[side] = before + out.chain[side]->way(before, p.length[side]);
      }
    out.points.push_back(p);
  }
  return out;
}

std::vector<FacingRun> Search::runs() {
  std::vector<ChainPlace> places;
  for (const SurfacePoint& p : a_.samples()) places.push_back(p.place);
  for (const SurfacePoint& p : b_.samples())
    if (const Partner partner = nearest(a_, p, 1 - m_); partner.found) places.push_back(partner.at.place);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const ChainPlace place : places) {
    const Look next = look(place);
    if (!looks_.empty()) fill(Look(looks_.back()), next, 0);
    looks_.push_back(next);
  }
  std::vector<std::vector<Look>> runs;
  bool linked = false;
  for (size_t i = 0; i < looks_.size(); ++i) {
    linked = i > 0 && is_linked(looks_[i - 1], looks_[i]);
    if (!looks_[i].partner.found) continue;
    if (!linked) runs.push_back({});
    runs.back().push_back(looks_[i]);
  }
  bool ring = false;
  if (a_.closed() && !runs.empty() && is_linked(looks_.back(), looks_.front())) {
    ring = runs.size() == 1;
    if (!ring) {
      runs.back().insert(runs.back().end(), runs.front().begin(), runs.front().end());
      runs.erase(runs.begin());
    }
  }
  std::vector<FacingRun> out;
  for (const std::vector<Look>& looks : runs) {
    if (looks.size() < 2) continue;
    FacingRun run = run_of(looks, ring);
    if (run.points.size() > 1 &&
        (ring || std::max(run.length(0), run.length(1)) > kLeastRun * std::min(a_.length(), b_.length())))
      out.push_back(std::move(run));
  }
  return out;
}

// The weight m of METHOD 8.3 for a run. Lengths on the second side decrease along the run.
double part_of_normal(const FacingRun& run) {
  double curvature[2];
  for (size_t side = 0; side < 2; ++side) {
    double turn = 0;
    for (size_t i = 1; i < run.points.size(); ++i)
      turn += angle_between(run.points[i - 1].normal[side], run.points[i].normal[side]);
    curvature[side] = std::max(side == 0 ? turn : -turn, 1e-15) / std::max(run.length(side), 1e-300);
  }
  return curvature[1] / (curvature[0] + curvature[1]);
}

// The distance of a run from a length on its first side.
double distance_to(const FacingRun& run, double length) {
  double least = HUGE_VAL;
  for (const FacingPoints& p : run.points) least = std::min(least, std::fabs(run.chain[0]->way(p.length[0], length)));
  return least;
}

void snap(FacingRun& run) {
  for (size_t side = 0; side < 2; ++side) {
    const Chain& chain = *run.chain[side];
    if (chain.closed()) continue;
    const double near = kSnap * run.length(side);
    double &low = (side == 0 ? run.points.front() : run.points.back()).length[side],
           &high = (side == 0 ? run.points.back() : run.points.front()).length[side];
    if (low - chain.begin() < near) low = chain.begin();
    if (chain.end() - high < near) high = chain.end();
  }
}

// The place where two sides are nearest to each other.
double nearest_place(const FacingRun& run) {
  return std::min_element(run.points.begin(), run.points.end(),
                          [](const auto& p, const auto& q) { return std::fabs(p.gap) < std::fabs(q.gap); })
      ->length[0];
}

// Inserts a point between the two on either side of a length, if there are such.
void divide_at(FacingRun& run, size_t side, double length) {
  std::vector<FacingPoints>& p = run.points;
  for (size_t i = 0; i + 1 < p.size(); ++i) {
    const double from = run.chain[side]->way(p[i].length[side], length), way = p[i + 1].length[side] - p[i].length[side];
    if (way == 0 || !(from / way > 0 && from / way < 1)) continue;
    const double f = from / way;
    FacingPoints at = p[f < 0.5 ? i : i + 1];
    for (size_t k = 0; k < 2; ++k) at.length[k] = p[i].length[k] + f * (p[i + 1].length[k] - p[i].length[k]);
    at.gap = p[i].gap + f * (p[i + 1].gap - p[i].gap);
    p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
    return;
  }
}

// Keeps what lies between the ends of another run, on both sides. Is there any?
bool keep_within(FacingRun& run, const FacingRun& ends) {
  const auto is_beyond = [&](const FacingPoints& p) {
    for (size_t side = 0; side < 2; ++side) {
      const double middle = (ends.low(side) + ends.high(side)) / 2, off = run.chain[side]->way(middle, p.length[side]);
      if (std::fabs(off) > (0.5 + kSnap) * ends.length(side)) return true;
    }
    return false;
  };
  for (size_t side = 0; side < 2; ++side) divide_at(run, side, ends.low(side)), divide_at(run, side, ends.high(side));
  std::vector<FacingPoints>& p = run.points;
  const size_t before = p.size();
  const auto first = std::find_if_not(p.begin(), p.end(), is_beyond);
  p.erase(std::find_if(first, p.end(), is_beyond), p.end());
  p.erase(p.begin(), first);
  run.ring = run.ring && p.size() == before;
  return p.size() > 1 && run.length(0) > kLeastRun * ends.length(0) && run.length(1) > kLeastRun * ends.length(1);
}

bool are_same(const FacingRun& a, const FacingRun& b) {
  const double near = 1e-3 * a.length(0);
  return distance_to(b, a.points[a.points.size() / 2].length[0]) < near && std::fabs(a.length(0) - b.length(0)) < near;
}

} // namespace

std::vector<FacingRun> facing_runs(const Chain& a, const Chain& b, const FacingLimits& limits) {
  std::vector<FacingRun> out;
  for (FacingRun& first : Search(a, b, limits, 0.5).runs()) {
    const double place = nearest_place(first);
    FacingRun run = std::move(first);
    double m = 0.5, next = part_of_normal(run);
    for (int round = 0; round < kMostRounds && std::fabs(next - m) >= kSameNormal; ++round) {
      m = next;
      std::vector<FacingRun> all = Search(a, b, limits, m).runs();
      if (all.empty()) break;
      run = *std::min_element(all.begin(), all.end(), [&](const FacingRun& p, const FacingRun& q) {
        return distance_to(p, place) < distance_to(q, place);
      });
      next = part_of_normal(run);
    }
    run.weight = m;
    if (!agree_with_curvatures(run, limits)) continue;
    snap(run);
    if (std::none_of(out.begin(), out.end(), [&](const FacingRun& other) { return are_same(run, other); }))
      out.push_back(std::move(run));
  }
  return out;
}

bool agree_with_curvatures(FacingRun& run, const FacingLimits& limits) {
  for (int round = 0; round < kMostWithin; ++round) {
    const double m = part_of_normal(run);
    if (std::fabs(m - run.weight) < kSameNormal) return true;
    const double place = nearest_place(run);
    std::vector<FacingRun> all;
    for (FacingRun& found : Search(*run.chain[0], *run.chain[1], limits, m).runs())
      if (keep_within(found, run)) all.push_back(std::move(found));
    if (all.empty()) return false;
    run = *std::min_element(all.begin(), all.end(), [&](const FacingRun& p, const FacingRun& q) {
      return distance_to(p, place) < distance_to(q, place);
    });
    run.weight = m;
  }
  return false;
}

double least_inclination(const Chain& a, const Chain& b) {
  double least = 1;
  for (const SurfacePoint& p : a.samples())
    for (const SurfacePoint& q : b.samples())
      if (!a.is_fan(p.place) && !b.is_fan(q.place)) least = std::min(least, dot(p.normal, q.normal));
  return std::acos(std::clamp(-least, -1.0, 1.0)) * 180 / std::acos(-1.0);
}

} // namespace sketch
