// The largest value over all planes of a parameter W/2 (a + b S) + c S, where S is the largest of some waves in p = 2t (t the
// angle of the normal) and W the difference of the largest and the smallest of others. For one choice of three waves it is a
// trigonometric polynomial of degree 2; the parameter is the largest of these polynomials. Phases, over intervals of p:
//   1. Bound each wave on the interval; keep those that can be the largest, or the smallest, somewhere in it.
//   2. Leave the interval if the bound of the parameter is below the best value so far.
//   3. If few choices of three waves are left, find the largest value of each polynomial: bisect the interval until the slope
//   is
//      monotonic, then find the zero of the slope. Else bisect.
// The parameter itself is evaluated at every place found, so that a choice that does not hold there does no harm.
#include "post/fatigue/planes.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const double kPlanesPi = std::acos(-1.0);
constexpr int kFirstPieces = 8;        // of the full circle of p; less than a quarter each
constexpr size_t kFewChoices = 27;     // of three waves
constexpr double kLeastPiece = 1e-7;   // half width: the parameter changes by its square next to its largest value
constexpr double kLeastOfSlope = 1e-5; // the same for a polynomial, which changes by its cube where slope and curvature vanish
constexpr double kPlaneRoundOff = 1e-14; // relative: smaller improvements are none

double wave_at(const PlaneWave& w, double cosine, double sine) { return w.mean + w.cosine * cosine + w.sine * sine; }

// Largest and smallest value of a wave within h of the place with this cosine and sine. h is below a quarter turn.
struct WaveBounds {
  double low, high;
};
WaveBounds bounds_of(const PlaneWave& w, double c, double s, double cos_h, double sin_h) {
  const double along = w.cosine * c + w.sine * s, across = w.sine * c - w.cosine * s, size = std::hypot(along, across);
  const double a = along * cos_h - across * sin_h, b = along * cos_h + across * sin_h; // at the two ends
  const bool has_turn = std::fabs(across) * cos_h < sin_h * std::fabs(along);
  return {w.mean + (has_turn && along < 0 ? -size : std::min(a, b)), w.mean + (has_turn && along > 0 ? size : std::max(a, b))};
}

// mean + a cos p + b sin p + c cos 2p + d sin 2p
struct PlanePolynomial {
  double mean, a, b, c, d;
  double value(double p) const { return mean + a * std::cos(p) + b * std::sin(p) + c * std::cos(2 * p) + d * std::sin(2 * p); }
  double slope(double p) const { return b * std::cos(p) - a * std::sin(p) + 2 * (d * std::cos(2 * p) - c * std::sin(2 * p)); }
  double curvature(double p) const {
    return -a * std::cos(p) - b * std::sin(p) - 4 * (c * std::cos(2 * p) + d * std::sin(2 * p));
  }
  double first() const { return std::hypot(a, b); }
  double second() const { return std::hypot(c, d); }
};

PlanePolynomial polynomial_of(const PlaneWave& s, const PlaneWave& high, const PlaneWave& low, const PlaneParameter& p) {
  const PlaneWave u{(high.mean - low.mean) / 2, (high.cosine - low.cosine) / 2, (high.sine - low.sine) / 2},
      v{p.alone + p.times * s.mean, p.times * s.cosine, p.times * s.sine};
  const double cc = u.cosine * v.cosine, ss = u.sine * v.sine;
  return {u.mean * v.mean + (cc + ss) / 2 + p.stress * s.mean, u.mean * v.cosine + u.cosine * v.mean + p.stress * s.cosine,
          u.mean * v.sine + u.sine * v.mean + p.stress * s.sine, (cc - ss) / 2, (u.cosine * v.sine + u.sine * v.cosine) / 2};
}

// Finds the place of the largest value of a polynomial in an interval.
class PolynomialTop {
public:
  PolynomialTop(const PlanePolynomial& f, double least) : best(least), f_(f), third_(f.first() + 8 * f.second()) {}
  void look(double from, double to) {
    const double m = (from + to) / 2, h = (to - from) / 2, value = f_.value(m), slope = f_.slope(m);
    take(m, value);
    if (value + std::fabs(slope) * h + (f_.first() + 4 * f_.second()) * h * h / 2 <= best) return;
    const bool is_monotonic = std::fabs(f_.curvature(m)) > third_ * h;
    if (is_monotonic || h < kLeastOfSlope) {
      take(from, f_.value(from)), take(to, f_.value(to));
      if (is_monotonic && f_.slope(from) > 0 && f_.slope(to) < 0) find_zero(from, to);
      return;
    }
    look(from, m), look(m, to);
  }
  double place = 0, best; // `best` stays at the given value if no value is larger

private:
  void take(double p, double value) {
    if (value > best) best = value, place = p;
  }
  void find_zero(double from, double to) { // Newton's steps that stay in the bracket, else bisection
    double p = (from + to) / 2;
    for (int k = 0; k < 60 && to - from > 1e-15; ++k) {
      const double slope = f_.slope(p), curvature = f_.curvature(p);
      (slope > 0 ? from : to) = p;
      const double next = curvature != 0 ? p - slope / curvature : from;
      const double then = next > from && next < to ? next : (from + to) / 2;
      if (std::fabs(then - p) < 1e-16) break;
      p = then;
    }
    take(p, f_.value(p));
  }
  const PlanePolynomial& f_;
  const double third_;
};

// Waves, by number, that can be the largest stress, the largest and the smallest of the ranged ones in an interval.
struct PlaneChoices {
  std::vector<size_t> stress, high, low;
  size_t count() const { return stress.size() * high.size() * low.size(); }
};

class PlaneSearch {
public:
  PlaneSearch(const std::vector<PlaneWave>& stress, const std::vector<PlaneWave>& ranged, const PlaneParameter& parameter)
      : stress_(stress), ranged_(ranged), parameter_(parameter) {}
  PlaneMaximum run();

private:
  double parameter_at(double p) const;
  void take(double p);
  void look(double m, double h, const PlaneChoices& from);

  const std::vector<PlaneWave>&stress_, &ranged_;
  const PlaneParameter& parameter_;
  double best_ = -HUGE_VAL, place_ = 0;
};

double PlaneSearch::parameter_at(double p) const {
  const double c = std::cos(p), s = std::sin(p);
  double stress = -HUGE_VAL, high = -HUGE_VAL, low = HUGE_VAL;
  for (const PlaneWave& w : stress_) stress = std::max(stress, wave_at(w, c, s));
  for (const PlaneWave& w : ranged_) high = std::max(high, wave_at(w, c, s)), low = std::min(low, wave_at(w, c, s));
  return (high - low) / 2 * (parameter_.alone + parameter_.times * stress) + parameter_.stress * stress;
}

void PlaneSearch::take(double p) {
  const double value = parameter_at(p);
  if (value > best_) best_ = value, place_ = p;
}

void PlaneSearch::look(double m, double h, const PlaneChoices& from) {
  const double c = std::cos(m), s = std::sin(m), cos_h = std::cos(h), sin_h = std::sin(h);
  std::vector<WaveBounds> stress, high, low;
  double stress_most = -HUGE_VAL, stress_least = -HUGE_VAL; // largest upper and lower bound
  for (const size_t i : from.stress) {
    stress.push_back(bounds_of(stress_[i], c, s, cos_h, sin_h));
    stress_most = std::max(stress_most, stress.back().high), stress_least = std::max(stress_least, stress.back().low);
  }
  double high_most = -HUGE_VAL, high_least = -HUGE_VAL, low_least = HUGE_VAL, low_most = HUGE_VAL;
  for (const size_t i : from.high) {
    high.push_back(bounds_of(ranged_[i], c, s, cos_h, sin_h));
    high_most = std::max(high_most, high.back().high), high_least = std::max(high_least, high.back().low);
  }
  for (const size_t i : from.low) {
    low.push_back(bounds_of(ranged_[i], c, s, cos_h, sin_h));
    low_least = std::min(low_least, low.back().low), low_most = std::min(low_most, low.back().high);
  }
  const double bound = (high_most - low_least) / 2 * (parameter_.alone + parameter_.times * stress_most) +
                       std::max(parameter_.stress * stress_most, parameter_.stress * stress_least);
  if (bound <= best_ + kPlaneRoundOff * std::fabs(best_)) return;
  PlaneChoices own;
  for (size_t k = 0; k < stress.size(); ++k)
    if (stress[k].high >= stress_least) own.stress.push_back(from.stress[k]);
  for (size_t k = 0; k < high.size(); ++k)
    if (high[k].high >= high_least) own.high.push_back(from.high[k]);
  for (size_t k = 0; k < low.size(); ++k)
    if (low[k].low <= low_most) own.low.push_back(from.low[k]);
  if (own.count() > kFewChoices) {
    take(m);
    if (h < kLeastPiece) return;
    look(m - h / 2, h / 2, own), look(m + h / 2, h / 2, own);
    return;
  }
  for (const size_t i : own.stress)
    for (const size_t j : own.high)
      for (const size_t k : own.low) {
        const PlanePolynomial f = polynomial_of(stress_[i], ranged_[j], ranged_[k], parameter_);
        PolynomialTop top(f, best_);
        top.look(m - h, m + h);
        if (top.best > best_) take(top.place);
      }
}

PlaneMaximum PlaneSearch::run() {
  PlaneChoices all;
  for (size_t i = 0; i < stress_.size(); ++i) all.stress.push_back(i);
  for (size_t i = 0; i < ranged_.size(); ++i) all.high.push_back(i);
  all.low = all.high;
  const double h = kPlanesPi / kFirstPieces;
  for (int k = 0; k < kFirstPieces; ++k) look((2 * k + 1) * h, h, all);
  double angle = place_ / 2 * 180 / kPlanesPi; // 0 to 180
  if (angle > 90) angle -= 180;
  return {best_, angle};
}

} // namespace

PlaneMaximum largest_over_planes(const std::vector<PlaneWave>& stress, const std::vector<PlaneWave>& ranged,
                                 const PlaneParameter& parameter) {
  if (stress.empty() || ranged.empty()) return {};
  return PlaneSearch(stress, ranged, parameter).run();
}

} // namespace app
